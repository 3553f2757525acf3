"""The verb ``dhlab compare``: two arms side by side."""

import json
from typing import Annotated

import typer

from .common import Json, arm_of

__all__ = ["compare"]

WHAT = "A name of the library, a .yaml or .csv table file, or a URDF."


def compare(
    a: Annotated[str, typer.Argument(metavar="A", help=WHAT)],
    b: Annotated[str, typer.Argument(metavar="B", help=WHAT)],
    picture: Annotated[
        str,
        typer.Option(
            "--picture",
            metavar="FILE",
            help="Draw both into a .png, .svg or .pdf file; an existing one is kept.",
        ),
    ] = "",
    as_json: Json = False,
) -> None:
    """Two arms: the same motion or not; joint by joint sign, zero and lengths; base and tool."""
    from ..geometry.comparing.compare import compare as side_by_side

    one, other = arm_of(a), arm_of(b)
    found = side_by_side(one, other)
    if picture:
        from ..view import two_arms

        two_arms(one, other).save(picture)
    print(json.dumps(found.to_dict(), ensure_ascii=False) if as_json else found)
