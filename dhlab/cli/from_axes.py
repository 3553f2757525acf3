"""The verb ``dhlab from-axes``: the table of an arm whose joint axes were written down."""

import sys
import warnings
from pathlib import Path
from typing import Annotated

import typer

from .common import Convention, Json, NewTable, give

__all__ = ["from_axes"]


def from_axes(
    file: Annotated[
        Path,
        typer.Argument(
            metavar="FILE.yaml",
            help="An axis sheet: units, axes (point and direction of each joint), end.",
        ),
    ],
    to: Convention = "standard",
    steps: Annotated[
        bool, typer.Option("--steps", help="Say in words how each frame was placed.")
    ] = False,
    out: NewTable = "",
    as_json: Json = False,
) -> None:
    """The DH table of an arm from its joint axes at the zero pose, frame by frame."""
    from ..formats.axisfile import read_axes

    with warnings.catch_warnings(record=True) as noted:
        warnings.simplefilter("always")
        model = read_axes(file).arm(to)
    give(model, out, as_json)
    for k, sentence in enumerate(model.steps if steps else (), 1):
        print(f"{k}. {sentence}", file=sys.stderr if as_json else sys.stdout)
    for warning in noted:
        print(f"Note: {warning.message}", file=sys.stderr)
