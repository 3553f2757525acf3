"""What lesson 04 draws, what is right, and what the wrong answers are told:
axes to place frames on, frames to read a table from.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..kinds import Known, Said
from ..kinds.tabled.arms import IN_DEGREES
from ..kinds.tabled.copied import Copied
from ..kinds.tabled.entries import COLUMNS, differing

__all__ = [
    "OF_Z",
    "ReadTable",
    "draw_colleagues",
    "draw_read",
    "draw_shoulder",
    "draw_skew",
    "draw_sliding",
    "explain_lines",
    "pose_of",
    "rows_read",
]

Triple = Sequence[float]


def pose_of(x: Triple, y: Triple, z: Triple, p: Triple) -> list[list[float]]:
    """A tool's pose (4, 4), metres, from its three arrows and its origin, as plain numbers."""
    return [[float(v) for v in row] for row in zip(x, y, z, p)] + [[0.0, 0.0, 0.0, 1.0]]


def _tenths(rng, low, high):
    return int(rng.integers(low, high + 1)) / 10


def draw_skew(rng: np.random.Generator) -> dict[str, Any]:
    """Two skew axes, the second along x, where the worked arm's is along y; the housing of joint 2
    is not where the common normal arrives. Frame 2 is the tool's.
    """
    a, h, side, sense = (
        _tenths(rng, 1, 3),
        _tenths(rng, 3, 6),
        _tenths(rng, 1, 2) * int(rng.choice([-1, 1])),
        int(rng.choice([-1, 1])),
    )
    return {
        "axes": [([0, 0, 0], [0, 0, 1]), ([side, a, h], [sense, 0, 0])],
        "end": pose_of([0, 1, 0], [0, 0, 1], [1, 0, 0], [0, a + 0.3, h]),
    }


def draw_shoulder(rng: np.random.Generator) -> dict[str, Any]:
    """Axis 2 meets axis 1, axis 3 is parallel to axis 2, the tool points away from the elbow."""
    h, upper, fore, side = (
        _tenths(rng, 3, 5),
        _tenths(rng, 3, 5),
        _tenths(rng, 2, 4),
        _tenths(rng, 1, 2),
    )
    sense = int(rng.choice([-1, 1]))
    axes = [
        ([0, 0, 0], [0, 0, 1]),
        ([0, side, h], [0, sense, 0]),
        ([upper, side, h], [0, sense, 0]),
    ]
    return {
        "axes": axes,
        "end": pose_of([0, 0, -1], [0, 1, 0], [1, 0, 0], [round(upper + fore, 6), 0, h]),
    }


def draw_colleagues(rng: np.random.Generator) -> dict[str, Any]:
    """Somebody's frames: a z and an x turned round and an origin slid, all of which is allowed, and
    one origin on the wrong axis.
    """
    a, h, upper, fore = (
        _tenths(rng, 1, 3),
        _tenths(rng, 3, 5),
        _tenths(rng, 3, 5),
        _tenths(rng, 2, 4),
    )
    far, tip = round(a + upper, 6), round(a + upper + fore, 6)
    axes = [([0, 0, 0], [0, 0, 1]), ([a, 0, h], [0, 1, 0]), ([far, 0, h], [0, 1, 0])]
    frames = [
        [[0, 0, 1], [0, 0, 0], [1, 0, 0]],
        [[0, 1, 0], [0, 0, h], [1, 0, 0]],
        [[0, -1, 0], [far, 0.1, h], [-1, 0, 0]],
        [[0, 1, 0], [tip, 0.1, h], [1, 0, 0]],
    ]
    return {
        "axes": axes,
        "end": pose_of([1, 0, 0], [0, 0, -1], [0, 1, 0], [tip, 0.1, h]),
        "frames": frames,
    }


def draw_read(rng: np.random.Generator) -> dict[str, Any]:
    """A shoulder and an elbow with all their frames placed, the last of them on the tool."""
    h, side, upper, fore = (
        _tenths(rng, 3, 5),
        _tenths(rng, 1, 2),
        _tenths(rng, 3, 5),
        _tenths(rng, 2, 4),
    )
    high = round(h + upper, 6)
    return {
        "axes": [([0, 0, 0], [0, 0, 1]), ([0, 0, h], [0, -1, 0]), ([0, -side, high], [0, -1, 0])],
        "end": pose_of([1, 0, 0], [0, 1, 0], [0, 0, 1], [fore, -side, high]),
        "frames": [
            [[0, 0, 1], [0, 0, 0], [1, 0, 0]],
            [[0, -1, 0], [0, 0, h], [1, 0, 0]],
            [[0, -1, 0], [0, -side, high], [0, 0, 1]],
            [[0, 0, 1], [fore, -side, high], [1, 0, 0]],
        ],
    }


def rows_read(axes: Any, end: Any, frames: Any) -> list[list[float]]:
    """The rows of these frames, degrees and metres."""
    h, (fore, y, high) = frames[1][1][2], frames[3][1]
    return [[0, h, 0, 90], [90, -y, round(high - h, 6), 0], [-90, 0, fore, -90]]


def draw_sliding(rng: np.random.Generator) -> dict[str, Any]:
    """Shoulder, a joint that slides, a roll on the same line, and the tool: the first joints of the
    Stanford arm.
    """
    h, side, reach, tool = (
        _tenths(rng, 3, 5),
        _tenths(rng, 1, 2),
        _tenths(rng, 4, 6),
        _tenths(rng, 1, 2),
    )
    axes = [
        ([0, 0, 0], [0, 0, 1]),
        ([0, side / 2, h], [0, 1, 0]),
        ([0.1, side, h], [1, 0, 0], "P"),
        ([reach, side, h], [1, 0, 0]),
    ]
    return {
        "axes": axes,
        "end": pose_of([0, 0, -1], [0, 1, 0], [1, 0, 0], [round(reach + tool, 6), side, h]),
    }


OF_Z = ["axis-1", "axis-2", "axis-3"]  # 04.1: the lines of z0, z1, z2


def explain_lines(lines: list[str]) -> Known | None:
    wrong = ", ".join(
        f"z{i}" for i, (line, wanted) in enumerate(zip(lines, OF_Z)) if line != wanted
    )
    if lines[1:] == OF_Z[:2]:
        return "frame-at-other-end", Said(
            "z1 and z2: these are the axes of joints 1 and 2",
            next="The first row turns about z0, and that is the motion of joint 1. Count on.",
        )
    if lines[:2] == OF_Z[1:]:
        return "frame-at-other-end", Said(
            "z0 and z1: these are the axes of joints 2 and 3, one joint too far",
            next="The first row turns about z0, and that is the motion of joint 1. Count on.",
        )
    metal = ", ".join(f"z{i}" for i, line in enumerate(lines) if line not in OF_Z)
    others = ", ".join(name for name in wrong.split(", ") if name not in metal)
    if metal:
        no_axis = (
            "these lines are no joint's axis" if "," in metal else "this line is no joint's axis"
        )
        return "z-across-joint-axis", Said(
            f"{metal}: {no_axis}; {others}: the axis of another joint"
            if others
            else f"{metal}: {no_axis}",
            next="Move a joint alone. Which line stands still? That line is z.",
        )
    return "frame-at-other-end", Said(
        f"{wrong}: the axis of another joint",
        next="The first row turns about z0, and that is the motion of joint 1. Count on.",
    )


ABOUT = (
    "Thumb along z{0}: do the fingers turn x{0} into x{1}, and by how much?",
    "Go along z{0} from o{0}: how far, with or against the arrow, until you are level with x{1}?",
    "Go along x{1}: how far from z{0} to o{1}, with or against the arrow?",
    "Thumb along x{1}: do the fingers turn z{0} into z{1}, and by how much?",
)


@dataclass(frozen=True, kw_only=True)
class ReadTable(Copied):
    """A table to be read off frames that are drawn: ``answer`` has the rows of these. A right table
    that is read off other frames of the arm is not the one that is asked.
    """

    def named(self, row: int, column: int) -> str:
        return f"{COLUMNS[column]}{row + 1}"

    def asked(self, off: NDArray[np.bool_]) -> str:
        """How the first number that is not that of the frames is read."""
        i, k = np.argwhere(off)[0]
        return f"One number at a time. For {self.named(i, k)}: {ABOUT[k].format(i, i + 1)}"

    def _right(self, arm, right, off):
        rows, drawn = (one.table.rows * IN_DEGREES for one in (arm, right))
        other = differing(rows, drawn)
        if arm.table.convention != right.table.convention or not other.any():
            return super()._right(arm, right, off)
        names = ", ".join(self.named(i, k) for i, k in np.argwhere(other))
        said = f"the same arm, but a table of other frames: these have another {names}"
        return self.wrong("table-taken-as-unique", place=Said(said, next=self.asked(other)))
