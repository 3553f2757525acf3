"""What lesson 04 draws, what is right, and what the wrong answers are told:
axes to place frames on, frames to read a table from.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...table import DHTable
from ..kinds import Known, Said, Table
from ..kinds.tabled.entries import COLUMNS, KINDS, differing, in_part
from ..verdict import RIGHT, WRONG, Verdict

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
    """Two skew axes; the housing of joint 2 is not where the common normal arrives. Frame 2 is the
    tool's.
    """
    a, h, side, sense = (
        _tenths(rng, 1, 3),
        _tenths(rng, 3, 6),
        _tenths(rng, 1, 2) * int(rng.choice([-1, 1])),
        int(rng.choice([-1, 1])),
    )
    return {
        "axes": [([0, 0, 0], [0, 0, 1]), ([a, side, h], [0, sense, 0])],
        "end": pose_of([1, 0, 0], [0, 0, -1], [0, 1, 0], [a + 0.3, 0, h]),
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
class ReadTable(Table):
    """A table to be read off frames that are drawn; says which single numbers were misread. A right
    table that is read off other frames of the arm is not the one that is asked.

    ``read(**given)`` gives the rows of the frames that are drawn, degrees and metres.
    """

    read: Callable[..., Sequence[Sequence[float]]]

    def compare(self, answer: object, variant: int) -> Verdict:
        verdict = super().compare(answer, variant)
        if verdict.mistake in ("angle-unit", "length-unit"):
            return verdict
        right = np.array(self.read(**self.given(variant)), dtype=float)
        rows = _numbers(answer, right.shape)
        if rows is None or verdict.status not in (RIGHT, WRONG):
            return verdict
        unit = in_part(rows, right, lambda i, k: f"{COLUMNS[k]}{i + 1}")
        if unit:
            return self.told(*unit)
        off = differing(rows, right)
        named = [f"{COLUMNS[k]}{i + 1}" for i, k in np.argwhere(off)]
        if verdict.status == RIGHT:
            return self._of_other_frames(off, named) if named else verdict
        columns = np.flatnonzero(off.any(axis=0))
        if (
            len(columns) == 1
        ):  # more columns than one: a slip of another kind, of which the doctor knows more
            return self._misread(rows[off], right[off], off, int(columns[0]), named)
        if verdict.mistake is None:
            return self.wrong(
                headline=f"these frames have another {', '.join(named)}",
                next=_one_at_a_time(off, named),
            )
        return verdict

    def _of_other_frames(self, off, named):
        """The Verdict on a right table of the arm that is not read off these frames."""
        return self.wrong(
            "table-taken-as-unique",
            place=Said(
                f"the same arm, but a table of other frames: these have another {', '.join(named)}",
                next=_one_at_a_time(off, named),
            ),
        )

    def _misread(self, given, right, off, k, named):
        one, i = len(named) == 1, int(np.argwhere(off)[0][0])
        sign = bool(np.allclose(given, -right))
        slip = (
            "sign"
            if sign
            else (
                "missing"
                if k == 0 and not given.any()
                else (
                    "unit" if KINDS[k] == "length" and np.allclose(given, 1000 * right) else "value"
                )
            )
        )
        are, have = ("is", "has") if one else ("are", "have")
        said = {
            "sign": f"{have} the wrong sign",
            "missing": f"{are} not 0: look at the x arrows",
            "unit": f"{are} in millimetres, and metres are asked",
            "value": f"{have} another value",
        }
        return self.wrong(
            f"{KINDS[k]}-{slip}",
            place=Said(f"{' and '.join(named)} {said[slip]}", next=ABOUT[k].format(i, i + 1)),
        )


def _one_at_a_time(off, named):
    """The next step where numbers are not those of the frames: how the first is read."""
    i, k = np.argwhere(off)[0]
    return f"One number at a time. For {named[0]}: {ABOUT[k].format(i, i + 1)}"


def _numbers(answer, shape):
    """An answer's rows in degrees and metres, or None when they are not written in this shape or
    convention.
    """
    table = getattr(answer, "table", answer)
    if isinstance(table, DHTable):
        return (
            np.column_stack([np.rad2deg(table.theta), table.d, table.a, np.rad2deg(table.alpha)])
            if table.convention == "standard" and len(table) == shape[0]
            else None
        )
    try:
        rows = np.array(table, dtype=float)
    except (TypeError, ValueError):
        return None
    return rows if rows.shape == shape and np.isfinite(rows).all() else None
