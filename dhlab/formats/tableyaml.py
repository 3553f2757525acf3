"""Table files in YAML: what an ``Arm`` looks like as text, read strictly and written losslessly."""

import json
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import units
from ..arm import Arm
from ..table import COLUMNS, CONVENTIONS, DHTable, joint_letter
from ..transform import from_xyz_rpy, to_xyz_rpy
from .plainyaml import Item, entries, fields, number, placed, shown, text

__all__ = ["ARM_KEYS", "arm_from_item", "pose_of", "read_limits", "scales_of", "yaml_text"]

ARM_KEYS = {
    "name",
    "source",
    "convention",
    "units",
    "joints",
    "base",
    "tool",
    "limits",
    "sign",
    "coupling",
}


def arm_from_item(item: Item, **inherited: Any) -> Arm:
    """The ``Arm`` that a mapping read by ``plainyaml`` describes; ``inherited`` gives name, limits
    … where it is silent.
    """
    given = fields(item, "the file", required={"convention", "units", "joints"}, allowed=ARM_KEYS)
    convention = text(given["convention"], "convention")
    if convention not in CONVENTIONS:
        hint = '; "modified" is called craig here' if convention == "modified" else ""
        raise ValueError(
            f"{given['convention'].where}: convention: expected standard or craig, found"
            f" {shown(convention)}{hint}"
        )
    to_m, to_rad = scales_of(given["units"])
    letters, rows = _joints(given["joints"])
    theta, d, a, alpha = rows.T
    table = DHTable(
        convention,
        units.convert(theta, to_rad),
        units.convert(d, to_m),
        units.convert(a, to_m),
        units.convert(alpha, to_rad),
        letters,
    )
    parts = dict(inherited)
    parts.update({key: text(given[key], key) for key in ("name", "source") if key in given})
    parts.update(
        {key: pose_of(given[key], key, to_m, to_rad) for key in ("base", "tool") if key in given}
    )
    if "limits" in given:
        parts["limits"] = read_limits(given["limits"], letters, to_m, to_rad)
    if "sign" in given:
        parts["sign"] = [
            number(entry, f"sign, joint {i}")
            for i, entry in enumerate(entries(given["sign"], "sign", len(letters)), 1)
        ]
    if "coupling" in given:
        parts["coupling"] = _coupling(given["coupling"], letters, to_m, to_rad)
    for key in ("limits", "sign", "coupling"):  # each with the line where it stands
        if key in given:
            placed(given[key].where, lambda key=key: Arm(table, **{key: parts[key]}))  # type: ignore[misc]
    return placed(item.where, lambda: Arm(table, **parts))


def scales_of(item: Item) -> tuple[float, float]:
    """Metres in the unit of length and radians in that of angles, of the key ``units``."""
    unit = fields(item, "units", required={"length", "angle"}, allowed={"length", "angle"})
    to_rad = units.scale_of(unit["angle"].plain(), "angle", f"{unit['angle'].where}: units")
    to_m = units.scale_of(unit["length"].plain(), "length", f"{unit['length'].where}: units")
    return to_m, to_rad


def _joints(item):
    letters, rows = "", []
    for i, row in enumerate(entries(item, "joints"), 1):
        what = f"joints, row {i}"
        given = fields(row, what, required=set(COLUMNS), allowed={*COLUMNS, "type"})
        letters += (
            joint_letter(given["type"].plain(), f"{given['type'].where}: {what}, type")
            if "type" in given
            else "R"
        )
        rows.append([number(given[name], f"{what}, {name}") for name in COLUMNS])
    if not rows:
        raise ValueError(
            f"{item.where}: joints: expected at least one row {{theta, d, a, alpha}}, found an"
            " empty list"
        )
    return letters, np.array(rows)


def pose_of(item: Item, key: str, to_m: float, to_rad: float) -> NDArray[np.float64]:
    """The pose (4, 4) in a mapping of ``xyz`` and ``rpy``, in the file's units."""
    given = fields(item, key, required=set(), allowed={"xyz", "rpy"})
    triple = {
        k: (
            [number(v, f"{key}, {k}") for v in entries(given[k], f"{key}, {k}", 3)]
            if k in given
            else [0, 0, 0]
        )
        for k in ("xyz", "rpy")
    }
    return from_xyz_rpy(
        units.convert(np.array(triple["xyz"]), to_m), units.convert(np.array(triple["rpy"]), to_rad)
    )


def _coupling(item, letters, to_m, to_rad):
    """The matrix in radians and metres: where a turning joint and a sliding one are coupled, an
    entry has the file's units, such as degrees per millimetre.
    """
    n = len(letters)
    scale = np.array([to_m if letter == "P" else to_rad for letter in letters])
    rows = [
        [number(entry, f"coupling, row {i}") for entry in entries(row, f"coupling, row {i}", n)]
        for i, row in enumerate(entries(item, "coupling", n), 1)
    ]
    return np.array(rows, dtype=float) * (scale[:, None] / scale)


def read_limits(
    item: Item, letters: str, to_m: float, to_rad: float
) -> list[tuple[float, float] | None] | None:
    """Limits per joint in radians and metres, from a list of pairs and nulls; null as a whole is
    None.
    """
    if item.value is None:
        return None
    limits: list[tuple[float, float] | None] = []
    for i, (pair, letter) in enumerate(zip(entries(item, "limits", len(letters)), letters), 1):
        scale = to_m if letter == "P" else to_rad
        what = f"limits, joint {i}"
        if not pair.value:
            limits.append(pair.value)
            continue
        low, high = (units.convert(number(end, what), scale) for end in entries(pair, what, 2))
        limits.append((float(low), float(high)))
    return limits


def yaml_text(arm: Arm, angle: str, length: str) -> str:
    """The YAML text of an arm, in the units named."""
    lines = [
        f"{key}: {json.dumps(getattr(arm, key), ensure_ascii=False)}"
        for key in ("name", "source")
        if getattr(arm, key)
    ]
    lines += [
        f"convention: {arm.table.convention}",
        f"units: {{length: {length}, angle: {angle}}}",
        "joints:",
    ]
    for row, letter in zip(units.written_rows(arm.table, angle, length), arm.table.joints):
        kind = "type: prismatic, " if letter == "P" else ""
        cells = ", ".join(f"{name}: {value}" for name, value in zip(COLUMNS, row))
        lines.append(f"  - {{{kind}{cells}}}")
    for key in ("base", "tool"):
        pose = getattr(arm, key)
        if not np.array_equal(pose, np.eye(4)):
            lines.append(f"{key}: {_pose_text(pose, angle, length)}")
    if arm.limits:
        limits = (
            _limit(pair, angle if letter == "R" else length)
            for pair, letter in zip(arm.limits, arm.table.joints)
        )
        lines.append(f"limits: [{', '.join(limits)}]")
    if (arm.sign < 0).any():
        lines.append("sign: [" + ", ".join(str(int(sign)) for sign in arm.sign) + "]")
    if arm.coupling is not None:
        lines.append("coupling:")
        lines += [f"  - [{', '.join(row)}]" for row in _coupling_rows(arm, angle, length)]
    return "\n".join(lines) + "\n"


def _pose_text(pose, angle, length):
    xyz, rpy = to_xyz_rpy(pose)
    shift = ", ".join(units.written(v, length) for v in xyz)
    return f"{{xyz: [{shift}], rpy: [{', '.join(_near(v, angle) for v in rpy)}]}}"


def _coupling_rows(arm, angle, length):
    """The matrix in the file's units, each number the shortest that reads back as it is."""
    factors = {**units.ANGLE, **units.LENGTH}
    scale = [factors[length if letter == "P" else angle] for letter in arm.table.joints]
    for row, to_row in zip(arm.coupling, scale):
        yield [
            units.shortest(value, to_row / to_column) or repr(float(value) / (to_row / to_column))
            for value, to_column in zip(row, scale)
        ]


def _near(value, unit):
    """As ``units.written``, with the rounding noise of a matrix taken off: 30, not
    30.000000000000004.
    """
    rounded = round(float(value) / units.ANGLE[unit], 12) + 0.0
    return (
        repr(rounded)
        if abs(rounded * units.ANGLE[unit] - value) < 4e-16
        else units.written(value, unit)
    )


def _limit(pair, unit):
    return (
        "null"
        if pair is None
        else "[" + ", ".join(units.written(value, unit) for value in pair) + "]"
    )
