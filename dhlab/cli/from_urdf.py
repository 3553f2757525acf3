"""The verb ``dhlab from-urdf``: the table of a URDF chain."""

import sys
import warnings
from pathlib import Path
from typing import Annotated

import typer

from .common import Convention, Json, NewTable, give

__all__ = ["from_urdf"]


def from_urdf(
    file: Annotated[Path, typer.Argument(metavar="FILE", help="A URDF file (expand xacro first).")],
    base: Annotated[
        str, typer.Option(help="The link the chain begins with; the root when left out.")
    ] = "",
    tip: Annotated[
        str, typer.Option(help="The link it ends with; the only leaf when left out.")
    ] = "",
    to: Convention = "standard",
    out: NewTable = "",
    as_json: Json = False,
) -> None:
    """The DH table of a URDF chain: the same pose for every q."""
    from ..formats.urdf import read_urdf

    with warnings.catch_warnings(record=True) as noted:
        warnings.simplefilter("always")
        model = read_urdf(file, base or None, tip or None, convention=to)
    give(model, out, as_json)
    for warning in noted:
        print(f"Note: {warning.message}", file=sys.stderr)
