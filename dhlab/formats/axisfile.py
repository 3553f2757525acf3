"""Axis sheets: the joint axes of an arm at its zero pose, as somebody measured or drew them, in
YAML.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .. import units
from ..table import joint_letter
from ..transform import to_xyz_rpy
from . import plainyaml
from .files import write_text
from .plainyaml import Item, entries, fields, number, text
from .tableyaml import pose_of, read_limits, scales_of

if TYPE_CHECKING:
    from ..geometry.procedure.frames import PlacedArm

__all__ = ["AxisSheet", "read_axes", "holds_axes", "sheet_from_item"]

KEYS = {"name", "source", "units", "axes", "end", "limits"}
AXIS = {"point", "direction", "type"}


@dataclass(frozen=True, eq=False)
class AxisSheet:
    """The joint axes of an arm in the base frame, at its zero pose.

    Attributes
    ----------
    axes : tuple of (point (3,), direction (3,), "R" or "P")
        As :func:`dhlab.assign_frames` takes them; metres.
    end : array (4, 4)
        The end pose there.
    limits, name, source
        As in ``Arm``.
    """

    axes: tuple[tuple[NDArray[np.float64], NDArray[np.float64], str], ...]
    end: NDArray[np.float64]
    limits: tuple[tuple[float, float] | None, ...] | None = None
    name: str = ""
    source: str = ""

    def arm(self, convention: str = "standard") -> PlacedArm:
        """The arm of these axes, with frames assigned."""
        from ..geometry.procedure.frames import assign_frames

        return assign_frames(
            self.axes,
            end=self.end,
            convention=convention,
            limits=self.limits,
            name=self.name,
            source=self.source,
        )

    def save(self, path: str | Path, *, length: str = "m", overwrite: bool = False) -> None:
        """Write the sheet as ``.yaml``; an existing file is kept unless told otherwise."""
        if Path(path).suffix.lower() not in (".yaml", ".yml"):
            raise ValueError(f"{path}: expected a name that ends in .yaml for an axis sheet")
        write_text(path, self._yaml(length), overwrite=overwrite)

    def _yaml(self, length):
        units.scale_of(length, "length", "save")
        lines = [f"name: {_quoted(self.name)}"] if self.name else []
        lines += [f"source: {_quoted(self.source)}"] if self.source else []
        lines += [f"units: {{length: {length}, angle: deg}}", "axes:"]
        for point, direction, letter in self.axes:
            kind = "type: prismatic, " if letter == "P" else ""
            at = ", ".join(units.written(x, length) for x in point)
            along = ", ".join(units.written(x, "m") for x in direction)
            lines.append(f"  - {{{kind}point: [{at}], direction: [{along}]}}")
        xyz, rpy = to_xyz_rpy(self.end)
        shift = ", ".join(units.written(x, length) for x in xyz)
        turn = ", ".join(repr(round(float(np.rad2deg(x)), 10) + 0.0) for x in rpy)
        lines.append(f"end: {{xyz: [{shift}], rpy: [{turn}]}}")
        if self.limits:
            pairs = (
                "null"
                if pair is None
                else "["
                + ", ".join(units.written(x, length if letter == "P" else "deg") for x in pair)
                + "]"
                for pair, (_, _, letter) in zip(self.limits, self.axes)
            )
            lines.append(f"limits: [{', '.join(pairs)}]")
        return "\n".join(lines) + "\n"


def _quoted(words):
    return json.dumps(words, ensure_ascii=False)


def read_axes(path: str | Path) -> AxisSheet:
    """The joint axes in an axis sheet.

    Parameters
    ----------
    path : str or path
        YAML with ``units`` (length and angle), ``axes`` (per joint ``point``, ``direction`` and,
        where it slides, ``type: prismatic``), ``end`` (``xyz``, ``rpy``: the end pose), all in the
        base frame at the zero pose; optionally ``name``, ``source``, ``limits``.

    Returns
    -------
    AxisSheet

    Raises
    ------
    ValueError
        One sentence that names file, line and joint.

    Examples
    --------
    >>> import pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp(), "axes.yaml")
    >>> _ = path.write_text('''
    ... units: {length: mm, angle: deg}
    ... axes:
    ...   - {point: [0, 0, 0], direction: [0, 0, 1]}
    ...   - {point: [400, 0, 100], direction: [0, 0, 1]}
    ... end: {xyz: [700, 0, 100]}
    ... ''')
    >>> sheet = read_axes(path)
    >>> print(sheet.arm().table)
    standard DH, 2 joints (lengths in m, angles in deg)
     i  theta  d    a    alpha
     1  q1     0    0.4  0
     2  q2     0.1  0.3  0
    """
    return sheet_from_item(plainyaml.read(path, "an axis sheet"))


def holds_axes(item: Item) -> bool:
    """Whether what was read is an axis sheet, and no table."""
    return isinstance(item.value, dict) and "axes" in item.value and "joints" not in item.value


def sheet_from_item(item: Item) -> AxisSheet:
    """The sheet that a mapping read by ``plainyaml`` describes."""
    given = fields(item, "the file", required={"units", "axes", "end"}, allowed=KEYS)
    to_m, to_rad = scales_of(given["units"])
    axes = tuple(_axis(row, i, to_m) for i, row in enumerate(entries(given["axes"], "axes"), 1))
    if not axes:
        raise ValueError(
            f"{given['axes'].where}: axes: expected at least one {{point, direction}}, found an"
            " empty list; write one line for each joint"
        )
    letters = "".join(letter for _, _, letter in axes)
    limits = read_limits(given["limits"], letters, to_m, to_rad) if "limits" in given else None
    return AxisSheet(
        axes,
        pose_of(given["end"], "end", to_m, to_rad),
        None if limits is None else tuple(limits),
        *(text(given[key], key) if key in given else "" for key in ("name", "source")),
    )


def _axis(row, i, to_m):
    what = f"axes, joint {i}"
    given = fields(row, what, required={"point", "direction"}, allowed=AXIS)
    point, direction = (
        np.array([number(x, f"{what}, {key}") for x in entries(given[key], f"{what}, {key}", 3)])
        for key in ("point", "direction")
    )
    if not direction.any():
        raise ValueError(
            f"{given['direction'].where}: {what}, direction: expected a vector with a length, found"
            " 0 0 0; give the direction of positive motion, such as [0, 0, 1]"
        )
    letter = (
        joint_letter(given["type"].plain(), f"{given['type'].where}: {what}, type")
        if "type" in given
        else "R"
    )
    return units.convert(point, to_m), direction.astype(float), letter
