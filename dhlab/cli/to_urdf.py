"""The verb ``dhlab to-urdf``: an arm as a URDF for simulators."""

from typing import Annotated

import typer

from .common import ArmName, arm_of

__all__ = ["to_urdf"]


def to_urdf(
    arm: ArmName,
    out: Annotated[
        str,
        typer.Option("--out", metavar="FILE.urdf", help="Write a file; an existing one is kept."),
    ] = "",
) -> None:
    """A URDF of an arm, with links, joints and limits, for simulators and visualisers."""
    from ..formats.descriptions.urdf import to_urdf as written

    text = written(arm_of(arm), out or None)
    print(f"{out}: written." if out else text, end="\n" if out else "")
