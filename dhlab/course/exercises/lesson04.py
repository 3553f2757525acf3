"""Lesson 04, placing frames: z on the joint axes, origins and x on the common normals, what is
free, and three beginner's mistakes.
"""

from dataclasses import dataclass

import numpy as np

from ...arm import Arm
from ...table import DHTable
from ..kinds import Choice, Option, Order, Prediction, Said, Table
from ..kinds.placed import Frames
from ..verdict import RIGHT, WRONG

__all__ = ["EXERCISES"]

# the frames of 04.5 as a table; the lesson gives them as arrows and points
READ = [[0, 0.3, 0, 90], [90, 0.1, 0.4, 0], [-90, 0, 0.3, -90]]


def _pose(x, y, z, p):
    return [[float(v) for v in row] for row in zip(x, y, z, p)] + [[0.0, 0.0, 0.0, 1.0]]


def _tenths(rng, low, high):
    return int(rng.integers(low, high + 1)) / 10


def _draw_skew(rng):
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
        "end": _pose([1, 0, 0], [0, 0, -1], [0, 1, 0], [a + 0.3, 0, h]),
    }


def _draw_shoulder(rng):
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
        "end": _pose([0, 0, -1], [0, 1, 0], [1, 0, 0], [round(upper + fore, 6), 0, h]),
    }


def _draw_colleagues(rng):
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
        "end": _pose([1, 0, 0], [0, 0, -1], [0, 1, 0], [tip, 0.1, h]),
        "frames": frames,
    }


def _draw_sliding(rng):
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
        "end": _pose([0, 0, -1], [0, 1, 0], [1, 0, 0], [round(reach + tool, 6), side, h]),
    }


def _explain_lines(letters):
    right = ["d", "e", "b"]
    wrong = ", ".join(
        f"z{i}" for i, (letter, wanted) in enumerate(zip(letters, right)) if letter != wanted
    )
    if letters[1:] == right[:2]:
        return "frame-at-other-end", f"{wrong}: every z is one joint late"
    if set(letters) & {"a", "f"}:
        return "z-across-joint-axis", wrong
    return "frame-at-other-end", wrong


ABOUT = (
    "Thumb along z{0}: do the fingers turn x{0} into x{1}, and by how much?",
    "Go along z{0} from o{0}: how far, with or against the arrow, until you are level with x{1}?",
    "Go along x{1}: how far from z{0} to o{1}, with or against the arrow?",
    "Thumb along x{1}: do the fingers turn z{0} into z{1}, and by how much?",
)
NAMES, KINDS = ("θ", "d", "a", "α"), ("offset", "length", "length", "alpha")


@dataclass(frozen=True, kw_only=True)
class ReadTable(Table):
    """A table to be read off frames that are drawn; says which single numbers were misread, and
    when a right table is that of other frames.

    ``read`` holds the rows of the frames that are drawn, degrees and metres.
    """

    read: tuple = ()

    def compare(self, answer, variant):
        verdict = super().compare(answer, variant)
        rows = _numbers(answer, np.shape(self.read))
        if rows is None or verdict.status not in (RIGHT, WRONG):
            return verdict
        off = np.abs(rows - self.read) > 1e-6
        off[:, [0, 3]] = np.abs((rows - self.read + 180) % 360 - 180)[:, [0, 3]] > 1e-3
        named = [f"{NAMES[k]}{i + 1}" for i, k in np.argwhere(off)]
        if verdict.status == RIGHT:
            return (
                self.say(
                    RIGHT,
                    f"the same arm, yet these frames have another {', '.join(named)}."
                    f" {self.praise}",
                )
                if named
                else verdict
            )
        columns = np.flatnonzero(off.any(axis=0))
        if (
            len(columns) == 1
        ):  # more columns than one: a slip of another kind, of which the doctor knows more
            return self._misread(rows, off, int(columns[0]), named)
        if verdict.mistake is None:
            i, k = np.argwhere(off)[0]
            return self.wrong(
                headline=f"these frames have another {', '.join(named)}",
                next=f"One number at a time. For {named[0]}: {ABOUT[k].format(i, i + 1)}",
            )
        return verdict

    def _misread(self, rows, off, k, named):
        given, right = rows[off], np.array(self.read, dtype=float)[off]
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


EXERCISES = [
    Order(
        id="04.1",
        title="Which line is which z",
        length=3,
        repeats=True,
        items={
            "a": "the line from joint 2 to joint 3, along the upper arm",
            "b": "the axis of joint 3",
            "c": "the line along which the tool points",
            "d": "the axis of joint 1",
            "e": "the axis of joint 2",
            "f": "the line from the base to the tool",
        },
        accepts=lambda letters: letters == ["d", "e", "b"],
        explain=_explain_lines,
        praise="z0 is joint 1's, z1 joint 2's, z2 joint 3's: always one less.",
        hints=(
            "z is never the metal. Which line stays where it is when a joint turns?",
            (
                "In the standard convention the first row's turn, about z0, is the motion of joint"
                " 1. So which z does joint 2 turn about?"
            ),
        ),
    ),
    Prediction(
        id="04.P1",
        title="Where the origin goes",
        options={
            "a": "in the middle of joint 2's housing",
            "b": "where the common normal meets z0",
            "c": "where the common normal meets z1",
        },
        correct="c",
        outcome=(
            "frame 1 belongs to z1, so its origin is the foot on z1. The housing may be anywhere"
            " along that line."
        ),
    ),
    Frames(
        id="04.2",
        title="Two skew axes",
        draw=_draw_skew,
        praise="The foot of the common normal, and x along it.",
        hints=(
            (
                "Which is the shortest way from the axis of joint 1 to the axis of joint 2? Where"
                " does it arrive?"
            ),
            (
                "All points of axis 2 have the same x and the same z. Only y is open, and axis 1"
                " has its own y."
            ),
        ),
    ),
    Choice(
        id="04.3",
        title="Why there",
        correct="b",
        hints=(
            (
                "A row goes along z_{i-1} by d, then along x_i by a. Where has it arrived after"
                " these two steps?"
            ),
            (
                "The origin must lie on z_i, and the line of x_i through it must meet z_{i-1}. How"
                " many points do both?"
            ),
        ),
        options={
            "a": Option(
                "the joint is there: the origin belongs in the middle of its housing",
                "A housing may sit anywhere along its axis. The four numbers know nothing of it.",
                "origin-off-common-normal",
            ),
            "b": Option(
                "x1 must meet z0 at a right angle, and only from this point of z1 does it",
                "This is the rule behind four numbers instead of six: x_i is at right angles to"
                " z_{i-1} and meets it.",
            ),
            "c": Option(
                "row 1 starts on z0, so its frame sits on z0",
                "Row 1 starts at frame 0 and leads to frame 1, which moves with z1.",
                "frame-at-other-end",
            ),
            "d": Option(
                "any point of z1 would do, the tool takes up the difference",
                "Any point would need a step along y as well, and no row has one. Only along"
                " parallel axes is the origin free.",
                "four-numbers-for-any-pose",
            ),
        },
    ),
    Frames(
        id="04.4",
        title="Shoulder and elbow",
        points=2,
        draw=_draw_shoulder,
        praise="Twelve choices, and every one keeps its rule.",
        hints=(
            (
                "All z first. Then go frame by frame and ask each time: are the two axes skew, do"
                " they meet, are they parallel?"
            ),
            (
                "Axes that meet: origin at the meeting point, x at right angles to both. Parallel:"
                " origin anywhere on z, x straight across."
            ),
        ),
    ),
    Prediction(
        id="04.P2",
        title="Two learners, two tables",
        options={
            "a": "different poses: one of the two tables must be wrong",
            "b": "the same pose at q = 0, different ones elsewhere",
            "c": "the same pose for every q",
        },
        correct="c",
        outcome=(
            "every choice kept the rules, so both tables are the arm. More than half of the numbers"
            " differ, and no pose does."
        ),
    ),
    ReadTable(
        id="04.5",
        title="Read the table off the frames",
        points=2,
        answer=Arm(DHTable.standard(READ, angle="deg")),
        read=READ,
        praise="θ and d about and along the old z, a and α along and about the new x.",
        hints=(
            (
                "Row by row: turn about z_{i-1} from x_{i-1} to x_i, shift along z_{i-1}, shift"
                " along x_i, turn about x_i from z_{i-1} to z_i."
            ),
            (
                "For each angle, thumb along the axis of the turn: do the fingers go from the old"
                " arrow to the new one? If not, it is negative."
            ),
        ),
    ),
    Choice(
        id="04.6",
        title="A step along parallel axes",
        correct="c",
        hints=(
            (
                "Between parallel axes the origin may slide. What happens to d before it, and to d"
                " behind it?"
            ),
            (
                "Add up the d along the parallel axes, in each of the tables. Which sum is the"
                " arm's step?"
            ),
        ),
        options={
            "a": Option(
                "row 3 only: the normal must go through the previous origin, so d2 = 0",
                "That is a habit of books, and a good one, but no rule: slide o2 and d2 is whatever"
                " you like.",
                "table-taken-as-unique",
            ),
            "b": Option(
                "both rows, since both axes are stepped along",
                "Then the step is made twice, and everything behind it is 0.1 m off.",
                "parallel-offset-in-both-rows",
            ),
            "c": Option(
                "either row, or a part in each, as long as the sum is 0.1 m",
                "The origin slides along z, d before it grows by what d behind it loses.",
            ),
            "d": Option(
                "neither: a step sideways belongs into a",
                "a runs along x, across the axes. This step is along them.",
                "a-d-exchanged",
            ),
        },
    ),
    Frames(
        id="04.7",
        title="The smallest fix: one origin",
        draw=_draw_colleagues,
        praise="One point. The reversed z2, the reversed x2 and the slid o2 were all allowed.",
        hints=(
            (
                "Four things look odd in these frames. Three of them are free choices: which rules"
                " do they keep?"
            ),
            "Go through the origins: does each lie on its own z?",
        ),
    ),
    Choice(
        id="04.8",
        title="A z axis turned round",
        correct="d",
        hints=(
            (
                "Which entries of the table are measured about or along z2? And which have z2 as"
                " their start or their end?"
            ),
            (
                "θ3 and d3 are about and along z2. α2 ends at z2, α3 begins there. And which way"
                " does the joint count now?"
            ),
        ),
        options={
            "a": Option(
                "nothing: the line is the same, only the arrow differs",
                "α is an angle between arrows, and d and θ are counted along one.",
                "z-flip-incomplete",
            ),
            "b": Option(
                "α2 alone, by 180°",
                "Then everything behind joint 3 is upside down. The story's two days began like"
                " this.",
                "z-flip-incomplete",
            ),
            "c": Option(
                "the arm: with its z reversed a joint moves to other places",
                "The arm has never heard of z. Joint 3 counts the other way, that is all.",
                "joint-reversed",
            ),
            "d": Option(
                "α2 and α3 by 180°, θ3 and d3 in sign, and joint 3 counts the other way",
                "All five together, and the arm is the same.",
            ),
        },
    ),
    Choice(
        id="04.9",
        title="The calibration that never fits",
        correct="a",
        hints=(
            (
                "The difference is constant in the tool's own directions, and it turns with the"
                " wrist. On which side of the product must it stand?"
            ),
            "Which frame is at that end of the chain, and who said where it is?",
        ),
        options={
            "a": Option(
                "the two did not agree on the last frame: one means the flange, the other the"
                " fingertip",
                "A constant on the right of the product: arm.tool. Neither table is wrong.",
            ),
            "b": Option(
                "one of the tables has a wrong a or d",
                "Then the difference would change with the joints behind that row.",
                "length-value",
            ),
            "c": Option(
                "the two did not agree on the base frame",
                "A base difference is constant in the base's directions. This one turns with the"
                " wrist.",
                "base-turned",
            ),
            "d": Option(
                "one of the two used Craig's convention",
                "Converted rightly, the pose is the same in both conventions.",
                "standard-rows-in-craig-matrix",
            ),
        },
    ),
    Frames(
        id="04.10",
        title="An arm you have not seen",
        points=3,
        draw=_draw_sliding,
        praise="A sliding joint, axes on one line, a tool: the same rules on every arm.",
        hints=(
            (
                "Of the sliding joint only the direction counts, so its line goes through the"
                " origin that you choose. Where is that handy?"
            ),
            (
                "z2 and z3 on one line leave x3 free. Put o2 on the line of joint 4, straight"
                " across from z1."
            ),
        ),
    ),
]
