"""Table files: YAML and CSV, as described in the documentation's "Table files" page, read strictly
and written losslessly.
"""

from dataclasses import replace
from pathlib import Path

import numpy as np

from .. import units
from ..arm import Arm
from ..table import DHTable
from . import plainyaml
from .axisfile import holds_axes, sheet_from_item
from .files import write_text
from .plainyaml import placed
from .tablecsv import csv_text, read_csv
from .tableyaml import arm_from_item, yaml_text

__all__ = ["read_arm", "read_table", "write"]


def read_arm(path: str | Path) -> Arm:
    """The ``Arm`` in a ``.yaml``, ``.yml`` or ``.csv`` file.

    Raises
    ------
    ValueError
        One sentence naming file, line or row, and column.
    """
    path = Path(path)
    kind = _kind(path)
    arm = read_csv(path) if kind == "csv" else _from_yaml(plainyaml.read(path))
    if arm.name:
        return arm
    return replace(arm, name=path.stem)


def _from_yaml(item):
    """The arm of a table, or of joint axes."""
    if holds_axes(item):
        sheet = sheet_from_item(item)
        return placed(item.where, sheet.arm)
    return arm_from_item(item)


def read_table(path: str | Path) -> DHTable:
    """The ``DHTable`` in a file that holds nothing a table cannot hold."""
    arm = read_arm(path)
    plain = Arm(arm.table)
    more = [
        name
        for name in ("base", "tool", "sign")
        if not np.array_equal(getattr(arm, name), getattr(plain, name))
    ]
    more += ["limits"] if arm.limits else []
    more += ["coupling"] if arm.coupling is not None else []
    if more:
        raise ValueError(
            f"{path}: expected a table alone, found {' and '.join(more)} beside it; read it as an"
            " arm with dhlab.load"
        )
    return arm.table


def _kind(path):
    kind = {".yaml": "yaml", ".yml": "yaml", ".csv": "csv"}.get(path.suffix.lower())
    if kind is None:
        raise ValueError(
            f"{path}: expected a file name ending in .yaml or .csv, found"
            f" {path.suffix or 'no ending'!r}; rename the file"
        )
    return kind


def write(
    path: str | Path,
    what: Arm | DHTable,
    *,
    angle: str | None = None,
    length: str = "m",
    overwrite: bool = False,
) -> None:
    """Write a ``DHTable`` or an ``Arm``; see their ``save``."""
    path = Path(path)
    arm = what if isinstance(what, Arm) else Arm(what)
    kind = _kind(path)
    if angle is None:
        exact = all(
            units.shortest(v, units.ANGLE["deg"]) is not None
            for v in [*arm.table.theta, *arm.table.alpha]
        )
        angle = "deg" if exact else "rad"
    units.scale_of(angle, "angle", "save"), units.scale_of(length, "length", "save")
    text = (csv_text if kind == "csv" else yaml_text)(arm, angle, length)
    write_text(path, text, overwrite=overwrite)
