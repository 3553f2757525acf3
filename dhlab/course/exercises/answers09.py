"""What lesson 09 draws, what is right, and what the wrong answers are told:
axes of three arms, half a conversion, the post-test.
"""

from itertools import combinations
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...geometry.procedure.frames import assign_frames
from ...robots import load
from ...table import DHTable
from ...transform import from_xyz_rpy
from ..kinds import Mistakes, Said

__all__ = ["MAKERS", "PIPER", "unrepaired", "wrong_axes", "wrong_piper"]

ALONG = np.array(
    [np.cos(np.deg2rad(5)), 0, np.sin(np.deg2rad(5))]
)  # the Piper's forearm at its zero pose: 5° up

WRIST = np.array([-0.03452, 0, 0.20536])

# joint axes at the zero pose, (point in m, direction), and the flange's pose there
PIPER: Any = (
    [
        ([0, 0, 0.123], [0, 0, 1]),
        ([0, 0, 0.123], [0, 1, 0]),
        ([-0.2824, 0, 0.16162], [0, 1, 0]),
        (WRIST, ALONG),
        (WRIST, [0, 1, 0]),
        (WRIST, ALONG),
    ],
    from_xyz_rpy(WRIST + 0.091 * ALONG, [0, np.deg2rad(85), 0]),
)

MAKERS: list[list[float]] = [
    [0, 0.16977, 0, 0],
    [-90, 0, 0.0642, -90],
    [0, -0.007, 0.305, 0],
    [0, 0.22263, 0, -90],
    [0, 0, 0, 90],
    [180, 0.041, 0, -90],
]

MILLIMETRES = {
    "all": "in other units: the points and the end in millimetres; metres are asked",
    "points": "in other units: the points of the axes in millimetres; metres are asked",
    "end": "in other units: the end in millimetres; metres are asked",
}


def wrong_axes(axes: list, end: NDArray) -> Mistakes:
    """Arms from axes with one slip each."""
    yield from _wrong_lines(axes, end)
    yield from _two_lines(axes, end)
    last = end.copy()
    last[:3, 3] = axes[-1][0]
    yield (
        "tool-missing",
        "the end was put where the last axis was given",
        assign_frames(axes, end=last),
    )
    untilted = np.eye(4)
    untilted[:3, 3] = end[:3, 3]
    yield (
        "tool-missing",
        "the end's directions are those of the base",
        assign_frames(axes, end=untilted),
    )
    metres = end.copy()
    metres[:3, 3] *= 1000
    thousand = [(np.multiply(point, 1000), z) for point, z in axes]
    yield "length-unit", MILLIMETRES["all"], assign_frames(thousand, end=metres)
    yield "length-unit", MILLIMETRES["points"], assign_frames(thousand, end=end)
    yield "length-unit", MILLIMETRES["end"], assign_frames(axes, end=metres)


def _wrong_lines(axes, end):
    for k, (point, z) in enumerate(axes):
        yield (
            "joint-reversed",
            Said(
                f"the direction of joint {k + 1} is reversed",
                next="A joint turns by the right hand. Which way is this one to count?",
            ),
            assign_frames(_with(axes, k, (point, np.negative(z))), end=end),
        )
        for other in ([1, 0, 0], [0, 1, 0], [0, 0, 1]):
            yield (
                "z-across-joint-axis",
                Said(
                    f"the direction of joint {k + 1} is another one",
                    next="About which line does this joint turn, at the zero pose?",
                ),
                assign_frames(_with(axes, k, (point, other)), end=end),
            )
        if k:
            yield (
                "length-value",
                Said(f"axis {k + 1} goes through the point that axis {k} was given"),
                assign_frames(_with(axes, k, (axes[k - 1][0], z)), end=end),
            )
        for i, name in enumerate("xyz"):
            mirrored = np.array(point, dtype=float)
            mirrored[i] *= -1
            yield (
                "length-sign",
                Said(f"the {name} of the point on axis {k + 1} has the other sign"),
                assign_frames(_with(axes, k, (mirrored, z)), end=end),
            )


def _two_lines(axes, end):
    """Two lines exchanged or reversed, one written the other way round, some in millimetres."""
    for k, (point, z) in enumerate(axes):
        yield (
            "columns-misread",
            Said(
                f"point and direction of joint {k + 1} have changed places",
                next="Write each axis as (point, direction).",
            ),
            assign_frames(_with(axes, k, (z, point)), end=end),
        )
    for i, k in combinations(range(len(axes)), 2):
        exchanged = _with(_with(axes, i, axes[k]), k, axes[i])
        yield (
            "joint-index-off-by-one",
            Said(
                f"the lines of joints {i + 1} and {k + 1} have changed places",
                next=f"About which of the two lines does joint {i + 1} turn?",
            ),
            assign_frames(exchanged, end=end),
        )
        (p, u), (r, v) = axes[i], axes[k]
        reversed_both = _with(_with(axes, i, (p, np.negative(u))), k, (r, np.negative(v)))
        yield (
            "joint-reversed",
            Said(
                f"the directions of joints {i + 1} and {k + 1} are reversed",
                next="A joint turns by the right hand. Which way are these two to count?",
            ),
            assign_frames(reversed_both, end=end),
        )
    for first in range(1, len(axes)):
        some = [*axes[:first], *((np.multiply(point, 1000), z) for point, z in axes[first:])]
        joints = ("joint 6", "joints 5 and 6", f"joints {first + 1} to 6")[min(5 - first, 2)]
        yield (
            "length-unit",
            f"in other units: the points of {joints} in millimetres; metres are asked",
            assign_frames(some, end=end),
        )


def _with(axes, k, axis):
    return [*axes[:k], axis, *axes[k + 1 :]]


def wrong_piper() -> Mistakes:
    axes, end = PIPER
    yield from wrong_axes(axes, end)
    for mistake, place, rpy in (
        ("angle-unit", "the end's angles were left in degrees", [0, 85, 0]),
        ("rotation-transposed", "the end's pitch has the other sign", [0, -np.deg2rad(85), 0]),
        (
            "roll-yaw-exchanged",
            "the end's angle was taken about another axis",
            [np.deg2rad(85), 0, 0],
        ),
        (
            "roll-yaw-exchanged",
            "the end's angle was taken about another axis",
            [0.0, 0.0, np.deg2rad(85)],
        ),
    ):
        yield mistake, place, assign_frames(axes, end=from_xyz_rpy(end[:3, 3], rpy))

    thousand = [(np.multiply(point, 1000), z) for point, z in axes]
    for points, place in (
        (thousand, "the points and the flange are in millimetres"),
        (axes, "the flange is in millimetres"),
    ):
        wrong = assign_frames(points, end=from_xyz_rpy(1000 * end[:3, 3], [0, 85, 0]))
        yield (
            "length-unit",
            Said(
                f"both units: {place}, its angles in degrees",
                next="dh.assign_frames takes metres, transform.from_xyz_rpy metres and radians.",
            ),
            wrong,
        )
    yield (
        "length-unit",
        Said(
            "both units: the points are in millimetres, the flange's angles in degrees",
            next="dh.assign_frames takes metres, transform.from_xyz_rpy radians.",
        ),
        assign_frames(thousand, end=from_xyz_rpy(end[:3, 3], [0, 85, 0])),
    )


def unrepaired() -> Mistakes:
    typed = [*MAKERS[:5], [*MAKERS[5][:3], 180]]
    yield (
        "alpha-value",
        Said(
            "this is still the arm of the maker's table",
            next="Ask dh.diagnose about ours first: which number does it name?",
        ),
        Arm(DHTable.craig(typed, angle="deg"), sign=load("ar4").sign),
    )
    carried = [*MAKERS[:4], [*MAKERS[4][:3], -90], typed[5]]
    yield (
        "a-alpha-from-previous-row",
        Said(
            "α of row 5 of the maker's table was right before you changed it",
            next="The doctor spoke of a standard row 5. In which of Craig's rows stands its α?",
        ),
        Arm(DHTable.craig(carried, angle="deg"), sign=load("ar4").sign),
    )
