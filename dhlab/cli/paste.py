"""The verb ``dhlab paste``: a table or a program from anywhere, read into an arm."""

import json
import math
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from ..formats.files import read_text
from .common import Json, NewTable, arm_of, described

if TYPE_CHECKING:
    from ..doctor import Recognised

__all__ = ["paste"]

ANSWERS = {  # the question's option, as the reader of the question types it
    "order": '--order "theta d a alpha"',
    "convention": "--convention standard or --convention craig",
    "angle": "--angle deg or --angle rad",
    "length": "--length m, mm, cm or in",
}


def paste(
    file: Annotated[
        str,
        typer.Argument(
            metavar="FILE",
            help="A text with a table or a program in it; left out or -, standard input.",
        ),
    ] = "-",
    order: Annotated[
        str, typer.Option(help='In which order the columns stand, as in "theta d a alpha".')
    ] = "",
    convention: Annotated[str, typer.Option(help="standard or craig.")] = "",
    angle: Annotated[str, typer.Option(help="deg or rad.")] = "",
    length: Annotated[str, typer.Option(help="m, mm, cm or in.")] = "",
    value: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=NUMBER",
            help="What a letter of the table stands for, in its units; as often as needed.",
        ),
    ] = None,
    nominal: Annotated[
        str,
        typer.Option(
            metavar="ARM", help="The maker's table, for a calibration that holds differences."
        ),
    ] = "",
    right: Annotated[
        str,
        typer.Option(
            metavar="ARM", help="The arm it should be: keeps the reading that is equivalent to it."
        ),
    ] = "",
    take: Annotated[
        int, typer.Option(metavar="N", help="Take the N-th reading where several fit.")
    ] = 0,
    tidy: Annotated[
        bool,
        typer.Option(
            "--tidy", help="Take 1.5708 for π/2 and the like; numbers stay as written otherwise."
        ),
    ] = False,
    out: NewTable = "",
    as_json: Json = False,
) -> None:
    """A pasted table or program, read and never executed: which reading was taken and why."""
    from ..doctor import recognise_table

    text, values = _text(file), _values(value or [])
    known_arm, maker = (arm_of(name) if name else None for name in (right, nominal))
    try:
        found = recognise_table(
            text,
            known_arm,
            order=order or None,
            convention=convention or None,
            angle=angle or None,
            length=length or None,
            values=values,
            nominal=maker,
            tidy=tidy,
        )
    except ValueError as error:
        raise ValueError(_as_typed(str(error), file)) from None
    chosen = _chosen(found.readings, take, bool(out))
    if out:
        chosen.arm.save(out)
    print(json.dumps(_told(found), ensure_ascii=False) if as_json else _words(found, chosen))


def _text(file):
    if file != "-":
        return read_text(Path(file), "a text with a table")
    if sys.stdin.isatty():
        print("Paste the text, then end it with Ctrl-D.", file=sys.stderr)
    try:
        return sys.stdin.read()
    except UnicodeDecodeError as error:
        raise ValueError(
            f"paste: expected UTF-8 text, found other bytes at byte {error.start}; save the text as"
            " UTF-8"
        ) from None


def _as_typed(said, file):
    """What the reader says, with the name of the file, and options in place of arguments."""
    where = "standard input" if file == "-" else file
    said = re.sub(r"with values=\{'(\w+)': 0\.1\}", r"with --value \1=0.1", said)
    said = re.sub(r"nominal=dhlab\.load\(\"ur5e\"\) or ", "", said)
    given = re.match(r"recognise_table: (order|convention|angle|length|nominal|values): ", said)
    if given:
        option = "value" if given[1] == "values" else given[1]
        return f"paste: --{option}: {said[given.end() :]}"
    return said.replace("recognise_table", where, 1)


def _values(pairs):
    """{name: number} of "a1=0.1" and its like."""
    found: dict[str, float] = {}
    for pair in pairs:
        name, _, number = (part.strip() for part in pair.partition("="))
        try:
            value = float(number)
        except ValueError:
            value = math.nan
        if not name or not math.isfinite(value):
            raise ValueError(
                f"paste: --value: expected a name and a number, as in a1=0.1, found {pair!r};"
                " write both"
            )
        if found.get(name, value) != value:
            raise ValueError(
                f"paste: --value: expected one number for {name}, found {found[name]:g} and"
                f" {value:g}; leave one out"
            )
        found[name] = value
    return found


def _chosen(readings, take, needed):
    """The reading that was asked for, or the only one; None while several fit."""
    if take:
        if not 1 <= take <= len(readings):
            raise ValueError(
                f"paste: --take: expected a number from 1 to {len(readings)}, found {take}"
            )
        return readings[take - 1]
    if len(readings) == 1:
        return readings[0]
    if needed:
        raise ValueError(
            f"paste: --out: expected one reading to write, found {len(readings)}; answer the"
            " questions that dhlab paste asks without --out, or take one with --take N"
        )
    return None


def _words(found, chosen):
    lines = [str(found)]
    if chosen is None:
        asked = [ANSWERS[name] for name in found.open if name in ANSWERS]
        ways = "; ".join([*asked, "or take a reading with --take N" if asked else "--take N"])
        lines.append(f"Answer with {ways}.")
    else:
        lines += ["", str(chosen.arm)]
    return "\n".join(lines)


def _told(found: "Recognised") -> dict[str, Any]:
    """What was found, for a program to read: metres and radians."""
    return {
        "readings": [
            {
                "words": reading.words,
                "assumptions": list(reading.assumptions),
                "arm": described(reading.arm),
            }
            for reading in found.readings
        ],
        "questions": list(found.questions),
        "open": list(found.open),
        "notes": list(found.notes),
        "matches": found.matches,
        "tell_apart": None if found.tell_apart is None else found.tell_apart.tolist(),
    }
