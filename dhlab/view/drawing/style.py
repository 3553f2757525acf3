"""How things are drawn: one place for ink, widths and type, chosen to be told apart in colour, by a
colour-blind eye and in grey print.
"""

import re
from dataclasses import dataclass

from matplotlib import patheffects
from matplotlib.patheffects import AbstractPathEffect

__all__ = [
    "AXES",
    "AxisStyle",
    "POSES",
    "INK",
    "QUIET",
    "FLOOR",
    "SHADOW",
    "LINK",
    "JOINT",
    "JOINT_CAP",
    "SIZES",
    "FONT",
    "halo",
    "axis_name",
]

INK, QUIET, FLOOR, SHADOW = "#22262b", "#6b737c", "#d9dde1", "#e6e8eb"
LINK, JOINT, JOINT_CAP = "#a3abb4", "#7b858f", "#d3d8dd"
FONT = "DejaVu Sans"  # comes with matplotlib, so a picture is the same everywhere
# points, on a page 8 inches wide
SIZES = {"title": 11.5, "note": 9.5, "name": 10.5, "axis": 11.0, "tick": 9.0, "value": 11.5}


@dataclass(frozen=True)
class AxisStyle:
    """How one axis of every frame is drawn; ``dash`` is matplotlib's line style."""

    letter: str
    color: str
    width: float
    dash: object


AXES = (
    AxisStyle("x", "#c23b00", 1.6, "-"),
    AxisStyle("y", "#00734f", 1.6, (0, (2.6, 1.3))),
    AxisStyle("z", "#17479e", 2.9, "-"),
)

# colour and line style of the first, second, ... configuration in one picture; each differs from
# the others in both
POSES = (
    ("#22262b", "-"),
    ("#17479e", (0, (4, 1.4))),
    ("#c23b00", (0, (1.2, 1.0))),
    ("#6b737c", (0, (5, 1.2, 1.2, 1.2))),
    ("#00734f", (0, (2.2, 2.2))),
)


def halo(width: float = 2.6) -> list[AbstractPathEffect]:
    """White around a text, so that it can be read on top of a line."""
    return [patheffects.withStroke(linewidth=width, foreground="white")]


def axis_name(letter: str, name: str) -> str:
    """An axis as mathematical text, its frame as the subscript; a name that is no plain word or
    number is left out.

    Examples
    --------
    >>> axis_name("x", "1"), axis_name("z", "tool"), axis_name("y", "left hand")
    ('x_{1}', 'z_{\\\\mathrm{tool}}', 'y')
    """
    if name.isascii() and name.isdigit():
        return f"{letter}_{{{name}}}"
    return rf"{letter}_{{\mathrm{{{name}}}}}" if re.fullmatch("[A-Za-z0-9]{1,8}", name) else letter
