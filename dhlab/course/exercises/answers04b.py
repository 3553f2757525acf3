"""What lesson 04's second sitting draws and what the wrong answers are told: six bare axes to place
frames on.
"""

from typing import Any

import numpy as np

from ...placing.board import Placement
from ..kinds import Known, Said
from .answers04 import pose_of

__all__ = [
    "PAIRS",
    "draw_half_arm",
    "draw_roll_wrist",
    "draw_spoilt_wrist",
    "draw_whole_arm",
    "explain_pairs",
    "off_axis_4",
]

PAIRS = ["meet", "parallel", "parallel", "meet", "meet"]  # the axes of the article's arm
NEAR = 1e-3  # m, rad
X, Y, Z = [1, 0, 0], [0, 1, 0], [0, 0, 1]
MINUS_Y, MINUS_Z = [0, -1, 0], [0, 0, -1]


def _article(rng):
    """The article's arm as bare axes, every point moved along its axis: a housing may be anywhere
    on it.
    """
    along = [int(k) / 100 for k in rng.choice([-8, -5, 4, 6, 9], 6)]
    return [
        ([0, 0, 0], Z),
        ([0, along[1], 0.1], MINUS_Y),
        ([0.4, along[2], 0.1], MINUS_Y),
        ([0.75, along[3], 0.1], MINUS_Y),
        ([0.75, -0.1, round(0.1 + along[4], 6)], MINUS_Z),
        ([0.75, round(-0.1 + along[5], 6), 0.1], MINUS_Y),
    ]


def draw_half_arm(rng: np.random.Generator) -> dict[str, Any]:
    """The first three joints, and the forearm's end on the line of joint 4."""
    return {"axes": _article(rng)[:3], "end": pose_of(X, Z, MINUS_Y, [0.75, 0, 0.1])}


def off_axis_4(task: Placement) -> str:
    """What is said of a frame 3 that is right at the end of half an arm and not on the whole."""
    beside = np.linalg.norm(np.cross(MINUS_Y, task.o[3] - [0.75, 0, 0.1])) > NEAR
    if not beside and np.linalg.norm(np.cross(MINUS_Y, task.z[3])) < NEAR:
        return ""
    return (
        " But your z3 does not lie on the axis of joint 4. Here frame 3 is the end, and free; on"
        " the whole arm z3 must lie there, so move it before you go on."
    )


def draw_whole_arm(rng: np.random.Generator) -> dict[str, Any]:
    """All six joints and the flange."""
    return {"axes": _article(rng), "end": pose_of(X, Z, MINUS_Y, [0.75, -0.2, 0.1])}


def draw_spoilt_wrist(rng: np.random.Generator) -> dict[str, Any]:
    """Somebody's frames of the whole arm: a z turned round and an origin slid, which is allowed,
    and o4 on its own axis but past the point where axes 4 and 5 meet.
    """
    slid, past = (int(k) / 100 for k in rng.choice([4, 5, 6, 8], 2))
    frames = [
        [Z, [0, 0, 0], X],
        [MINUS_Y, [0, 0, 0.1], X],
        [Y, [0.4, slid, 0.1], X],
        [MINUS_Y, [0.75, slid, 0.1], X],
        [MINUS_Z, [0.75, -0.1, round(0.1 - past, 6)], X],
        [MINUS_Y, [0.75, -0.1, 0.1], X],
        [MINUS_Y, [0.75, -0.2, 0.1], X],
    ]
    return {**draw_whole_arm(rng), "frames": frames}


def draw_roll_wrist(rng: np.random.Generator) -> dict[str, Any]:
    """An arm whose forearm rolls: axis 4 runs along it, above axis 3."""
    high, upper = int(rng.integers(3, 5)) / 10, int(rng.integers(3, 5)) / 10
    above, fore = int(rng.integers(4, 9)) / 100, int(rng.integers(3, 6)) / 10
    elbow, level = round(high + upper, 6), round(high + upper + above, 6)
    sense = [Y, MINUS_Y][int(rng.integers(2))]
    axes = [
        ([0, 0, 0], Z),
        ([0, 0.12, high], sense),
        ([0, 0.09, elbow], sense),
        ([round(fore / 2, 6), 0, level], X),
        ([fore, 0.05, level], sense),
        ([round(fore + 0.03, 6), 0, level], X),
    ]
    return {"axes": axes, "end": pose_of(MINUS_Z, Y, X, [round(fore + 0.08, 6), 0, level])}


NOT_SO = {  # of a case that was said, what is not so where the axes meet or are parallel
    "parallel": "Parallel axes have the same direction or the opposite one: these two have not.",
    "skew": "Skew axes differ in direction: these two do not.",
    "line": "Axes on one line have all points in common: these two have not.",
    "meet": "Axes that meet have a point in common: these two have none.",
}


def explain_pairs(cases: list[str]) -> Known:
    wrong = [i for i, (case, right) in enumerate(zip(cases, PAIRS)) if case != right]
    first = wrong[0]
    housings = cases[first] == "skew" and PAIRS[first] == "meet"
    return None, Said(
        f"axes {first + 1} and {first + 2} lie otherwise",
        why=(
            "The points given are somewhere on the axes, and lines go on beyond them."
            if housings
            else NOT_SO[cases[first]]
        ),
        next="Compare the directions first, then ask whether the two lines have a point in common.",
    )
