"""The axis sheet of 09.2: an arm of the AR4's build, whose last two axes are to be written."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...geometry.procedure.frames import assign_frames
from ...robots import load
from ...transform import from_xyz_rpy
from ..kinds import Mistakes, Said
from .answers09 import wrong_axes

__all__ = ["draw_sheet", "of_six", "six_axes", "wrong_sheets"]

MEET = "How far behind the flange do the axes of joints 4, 5 and 6 meet?"


def draw_sheet(rng: np.random.Generator) -> dict[str, Any]:
    """Axes 1 to 4 and the flange at the zero pose, metres; how far the wrist's centre lies behind
    the flange; which way joints 5 and 6 count.
    """
    between = (150, 190), (55, 75), (280, 330), (200, 240), (35, 55)  # mm
    rise, reach, upper, fore, hand = (int(rng.integers(*ends)) for ends in between)
    aside = int(rng.integers(5, 13) * rng.choice([-1, 1]))
    shoulder, elbow = _metres(reach, 0, rise), _metres(reach, aside, rise + upper)
    flange = _metres(reach + fore + hand, aside, rise + upper)
    return {
        "axes": [
            (_metres(0, 0, rise), [0, 0, -1]),
            (shoulder, [0, 1, 0]),
            (elbow, [0, 1, 0]),
            (elbow, [1, 0, 0]),
        ],
        "end": from_xyz_rpy(flange, [0, np.pi / 2, 0]),
        "hand": hand / 1000,
        "q5 grows": f"as the hand nods {rng.choice(['up', 'down'])}",
        "q6 grows": str(rng.choice(["clockwise", "anticlockwise"])),
    }


def _metres(*millimetres):
    return [x / 1000 for x in millimetres]


def six_axes(axes: list, end: NDArray, hand: float, **senses: str) -> list:
    """The whole sheet: axis 5 across the forearm, axis 6 along the tool, through the wrist's
    centre; by the right hand about +y the hand nods down, about +x it spins anticlockwise.
    """
    wrist = end[:3, 3] - hand * end[:3, 2]
    nod = 1 if senses["q5 grows"].endswith("down") else -1
    spin = 1 if senses["q6 grows"] == "anticlockwise" else -1
    return [*axes, (wrist, [0, nod, 0]), (wrist, [spin, 0, 0])]


def of_six(**sheet: Any) -> Arm:
    """The arm of the whole sheet."""
    return assign_frames(six_axes(**sheet), end=sheet["end"])


def wrong_sheets(**sheet: Any) -> Mistakes:
    """Arms of a sheet with one slip."""
    lines, end, hand = six_axes(**sheet), sheet["end"], sheet["hand"]
    yield (
        "another-model",
        Said(
            "this is the AR4 of the library, and yours has other lengths",
            next="Write the lines of your own sheet.",
        ),
        load("ar4"),
    )
    for mistake, said, point in (
        ("length-value", "axis 5 goes through the flange", end[:3, 3]),
        (
            "length-sign",
            "axis 5 goes through a point as far before the flange as the wrist's centre is behind",
            end[:3, 3] + hand * end[:3, 2],
        ),
    ):
        fifth = (point, lines[4][1])
        yield (
            mistake,
            Said(said, next=MEET),
            assign_frames([*lines[:4], fifth, lines[5]], end=end),
        )
    yield from wrong_axes(lines, end)
