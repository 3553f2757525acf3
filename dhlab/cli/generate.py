"""The verb ``dhlab generate``: an arm's kinematics as source for a controller."""

from typing import Annotated

import typer

from .common import ArmName, arm_of

__all__ = ["generate"]


def generate(
    arm: ArmName,
    to: Annotated[str, typer.Option(help="c (C99, needs math.h) or python (needs math).")] = "c",
    out: Annotated[
        str, typer.Option(metavar="FILE", help="Write a file; an existing one is kept.")
    ] = "",
    name: Annotated[
        str,
        typer.Option(
            help="What the functions' names begin with; made from the arm's name when left out."
        ),
    ] = "",
) -> None:
    """Forward kinematics and Jacobian of one arm as one source file that checks itself."""
    from ..formats import files
    from ..generating import CHECKS
    from ..generating import generate as source_of

    text = source_of(arm_of(arm), to, name=name or None)
    if not out:
        print(text, end="")
        return
    files.write_text(out, text)
    print(f"{out}: written. To check it: {CHECKS[to].replace('FILE', out)}")
