"""What several verbs take and print."""

from __future__ import annotations

import json
import sys
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from ..arm import Arm
from ..robots import load
from ..units import ANGLE, LENGTH

if TYPE_CHECKING:
    from ..grading.intake.roster import Student
    from ..grading.settings import Settings

__all__ = [
    "ArmName",
    "Convention",
    "Course",
    "Json",
    "NewTable",
    "Roster",
    "arm_of",
    "described",
    "give",
    "class_of",
    "settings_of",
    "units_of",
]

Json = Annotated[bool, typer.Option("--json", help="Print JSON for a program to read.")]
ArmName = Annotated[
    str,
    typer.Argument(
        metavar="ARM", help="A name of the library, a .yaml or .csv table file, or a URDF."
    ),
]
Convention = Annotated[str, typer.Option("--to", help="standard or craig.")]
NewTable = Annotated[
    str, typer.Option("--out", help="Write a .yaml file; an existing one is kept.")
]
Roster = Annotated[
    str,
    typer.Option(
        metavar="FILE.csv",
        help="The class: a column student and, where known, name, email, language.",
    ),
]
Course = Annotated[
    str, typer.Option(metavar="FILE.yaml", help="Lessons, due dates, points, lateness, limits.")
]


def arm_of(name: str | Path) -> Arm:
    """The arm of that name, or in that file; what has to be said of it goes to standard error."""
    with warnings.catch_warnings(record=True) as noted:
        warnings.simplefilter("always")
        model = load(name)
    for warning in noted:
        print(f"Note: {warning.message}", file=sys.stderr)
    return model


def described(arm: Arm) -> dict[str, Any]:
    """An arm for JSON: its table in metres and radians, base, tool, limits, source."""
    table = arm.table
    return {
        "name": arm.name,
        "convention": table.convention,
        "joints": table.joints,
        "units": {"length": "m", "angle": "rad"},
        "rows": table.rows.tolist(),
        "sign": arm.sign.tolist(),
        "coupling": None if arm.coupling is None else arm.coupling.tolist(),
        "base": arm.base.tolist(),
        "tool": arm.tool.tolist(),
        "limits": arm.limits,
        "source": arm.source,
    }


def give(model: Arm, out: str, as_json: bool) -> None:
    """Print an arm, and write it where asked."""
    if out:
        model.save(out)
    print(json.dumps(described(model), ensure_ascii=False) if as_json else model)


def units_of(text: str, verb: str) -> tuple[str, str]:
    """The unit of length and that of angles in a text such as "mm,deg"."""
    parts = [part.strip() for part in text.split(",")]
    lengths = [part for part in parts if part in LENGTH]
    angles = [part for part in parts if part in ANGLE]
    if len(parts) != 2 or len(lengths) != 1 or len(angles) != 1:
        raise ValueError(
            f"{verb}: --units: expected a unit of length and one of angle, such as mm,deg or m,rad,"
            f" found {text!r}"
        )
    return lengths[0], angles[0]


def class_of(path: str | Path) -> tuple[Student, ...]:
    """The class of a roster file; nobody where none is given."""
    from ..grading.intake.roster import read_roster

    return read_roster(path) if path else ()


def settings_of(path: str | Path) -> Settings:
    """The settings of a course file, or those that every course begins with."""
    from ..grading.settings import Settings, read_settings

    return read_settings(path) if path else Settings()
