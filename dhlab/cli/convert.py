"""The verb ``dhlab convert``: an arm in the other convention, made readable, or in Hayati's
parameters.
"""

import json
import sys
from typing import Annotated

import numpy as np
import typer

from ..arm import Arm
from ..printing import number
from .common import ArmName, Json, NewTable, arm_of, give

__all__ = ["convert", "give_hayati"]

Hayati = Annotated[
    bool,
    typer.Option(
        "--hayati",
        help="Print Hayati's parameters, which stay small where axes are nearly parallel.",
    ),
]


def convert(
    arm: ArmName,
    to: Annotated[str, typer.Option("--to", help="standard or craig.")] = "",
    tidy: Annotated[
        bool,
        typer.Option(
            "--tidy",
            help="Make a calibrated table readable: round its numbers, and say what that costs.",
        ),
    ] = False,
    hayati: Hayati = False,
    out: NewTable = "",
    as_json: Json = False,
) -> None:
    """The same arm in the other convention: the same pose for every q, exactly."""
    if not (to or tidy or hayati):
        raise ValueError(
            "convert: expected what to make of the arm, found nothing; add --to standard, --to"
            " craig, --tidy or --hayati"
        )
    model = arm_of(arm)
    model = model.to(to) if to else model
    if tidy:
        from ..geometry.tidying import tidied

        found = tidied(model)
        model = found.arm
        print(
            f"Note: rounded; the end moves by up to {number(found.shift * 1e3, 3)} mm and"
            f" {number(np.rad2deg(found.turn), 3)}°, so do not drive the arm by this table.",
            file=sys.stderr,
        )
    if hayati:
        give_hayati(model, out, as_json)
    else:
        give(model, out, as_json)


def give_hayati(model: Arm, out: str, as_json: bool) -> None:
    """Print Hayati's parameters, and write them as CSV where asked."""
    from ..formats.files import write_text
    from ..geometry.comparing.hayati import hayati

    found = hayati(model)
    if out:
        if not out.lower().endswith(".csv"):
            raise ValueError(
                f"--out: expected a name that ends in .csv for Hayati's parameters, found {out!r}"
            )
        write_text(out, found.to_csv())
    print(json.dumps(found.to_dict(), ensure_ascii=False) if as_json else found)
