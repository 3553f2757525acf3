"""The verb ``dhlab from-urdf``: the table of a chain in a URDF, a xacro file or an MJCF model."""

import sys
import warnings
from pathlib import Path
from typing import Annotated

import typer

from .common import Convention, Json, NewTable, give
from .convert import Hayati, give_hayati

__all__ = ["from_urdf"]


def from_urdf(
    file: Annotated[
        Path, typer.Argument(metavar="FILE", help="A URDF, a xacro file, or MuJoCo's MJCF.")
    ],
    base: Annotated[
        str, typer.Option(help="The link the chain begins with; the root when left out.")
    ] = "",
    tip: Annotated[
        str,
        typer.Option(
            "--end",
            "--tip",
            metavar="LINK",
            help="The link it ends with; that of the longest chain of arm joints when left out.",
        ),
    ] = "",
    to: Convention = "standard",
    parallel: Annotated[
        float | None,
        typer.Option(
            metavar="RAD",
            help=(
                "Axes closer to parallel than this are taken as parallel; 0: the exact table. Left"
                " out: where it costs at most 0.1 mm."
            ),
        ),
    ] = None,
    arg: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME=VALUE", help="An argument of a xacro file; repeat for more."),
    ] = None,
    package: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME=FOLDER", help="Where a package is that a xacro file asks for."),
    ] = None,
    hayati: Hayati = False,
    out: NewTable = "",
    as_json: Json = False,
) -> None:
    """The DH table of a chain in a robot description: the same pose for every q."""
    from ..formats.descriptions.urdf import read_description

    xacro = {"arguments": _pairs(arg, "--arg"), "packages": _pairs(package, "--package")}
    with warnings.catch_warnings(record=True) as noted:
        warnings.simplefilter("always")
        model = read_description(
            file,
            base or None,
            tip or None,
            convention=to,
            parallel=parallel,
            **{key: value for key, value in xacro.items() if value},
        )
    if hayati:
        give_hayati(model, out, as_json)
    else:
        give(model, out, as_json)
    for warning in noted:
        print(f"Note: {warning.message}", file=sys.stderr)


def _pairs(given, option):
    """{name: value} of what stands as NAME=VALUE."""
    found = {}
    for text in given or ():
        name, equals, value = text.partition("=")
        if not (name and equals):
            raise ValueError(
                f"from-urdf: {option}: expected a name and a value such as name=value, found"
                f" {text!r}"
            )
        found[name] = value
    return found
