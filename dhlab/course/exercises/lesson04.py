"""Lesson 04, first sitting, placing frames on pairs of axes: z on the joint axes, origins and x on
the common normals.
"""

from ..kinds import Choice, Option, Order, Prediction
from ..kinds.frames.placed import Frames
from .answers04 import OF_Z, draw_colleagues, draw_shoulder, draw_skew, draw_sliding, explain_lines
from .answers04b import PAIRS, explain_pairs

__all__ = ["EXERCISES"]

EXERCISES = [
    Order(
        id="04.1",
        title="Six lines, three axes",
        question="Which line carries each z? Three letters.",
        places=("z0", "z1", "z2"),
        repeats=True,
        items={
            "upper-arm": "the line from joint 2 to joint 3, along the upper arm",
            "axis-3": "the axis of joint 3",
            "tool": "the line along which the tool points",
            "axis-1": "the axis of joint 1",
            "axis-2": "the axis of joint 2",
            "base-to-tool": "the line from the base to the tool",
        },
        accepts=lambda lines: lines == OF_Z,
        explain=explain_lines,
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
        title="The origin of frame 1",
        question="Where does the origin of frame 1 go?",
        options={
            "housing": "in the middle of joint 2's housing (the cylinder)",
            "foot-on-z0": "where the common normal meets z0",
            "foot-on-z1": "where the common normal meets z1",
        },
        correct="foot-on-z1",
        outcome=(
            "frame 1 belongs to z1, so its origin is the foot on z1. The housing may be anywhere"
            " along that line."
        ),
    ),
    Choice(
        id="04.3",
        title="Why there",
        question="Which rule puts o1 exactly there?",
        correct="meets-z0",
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
            "housing": Option(
                "the joint is there: the origin belongs in the middle of its housing",
                "A housing may sit anywhere along its axis. The four numbers know nothing of it.",
                "origin-off-common-normal",
            ),
            "meets-z0": Option(
                "x1 must meet z0 at a right angle, and only from this point of z1 does it",
                "This is the rule behind four numbers instead of six: x_i is at right angles to"
                " z_{i-1} and meets it.",
            ),
            "starts-on-z0": Option(
                "row 1 starts on z0, so its frame sits on z0",
                "Row 1 starts at frame 0 and leads to frame 1, which moves with z1.",
                "frame-at-other-end",
            ),
            "any-point": Option(
                "any point of z1 would do, the tool takes up the difference",
                "Any other point would need a step along y as well, and no row has one. Along z1"
                " the origin is free only where the two axes are parallel or one line.",
                "four-numbers-for-any-pose",
            ),
        },
    ),
    Frames(
        id="04.2",
        title="Two skew axes",
        draw=draw_skew,
        praise="The foot of the common normal, and x along it.",
        hints=(
            (
                "Which is the shortest way from the axis of joint 1 to the axis of joint 2? Where"
                " does it arrive?"
            ),
            (
                "All points of axis 2 have the same y and the same z. Only x is open, and axis 1"
                " has its own x."
            ),
        ),
    ),
    Prediction(
        id="04.P3",
        title="An x that points forward",
        question=(
            "Axes 2 and 3 are parallel, one above the other, and x1 points forward. x2 shall point"
            " forward too. What does the board say?"
        ),
        options={
            "kept": "it keeps x2: along parallel axes x is free",
            "refused": "it refuses: x2 must point from axis 2 to axis 3",
            "origin": "it keeps x2 when o2 is slid along its axis",
        },
        correct="refused",
        outcome=(
            "it refuses. The origin is free along parallel axes, the x is not: it is the way from"
            " one axis to the other."
        ),
    ),
    Order(
        id="04.11",
        title="Five pairs of axes",
        question=(
            "How does each axis of this arm lie to the one before it? Five letters; a"
            " letter may come more than once."
        ),
        repeats=True,
        items={
            "parallel": "parallel, apart",
            "skew": "skew",
            "line": "on one line",
            "meet": "they meet",
        },
        places=("axes 1 and 2", "axes 2 and 3", "axes 3 and 4", "axes 4 and 5", "axes 5 and 6"),
        accepts=lambda cases: cases == PAIRS,
        explain=explain_pairs,
        praise="Two that meet at the foot, three parallel axes, and a wrist whose axes meet.",
        hints=(
            "Parallel: the same direction or the opposite one. Do two others have a common point?",
            "Axis 5 is vertical. Does the vertical line meet axis 4, and axis 6?",
        ),
    ),
    Frames(
        id="04.4",
        practice=True,
        title="Shoulder and elbow",
        points=2,
        draw=draw_shoulder,
        praise="Every choice keeps its rule.",
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
    Frames(
        id="04.7",
        practice=True,
        title="A colleague's frames",
        draw=draw_colleagues,
        sparing=True,
        praise="One point. The reversed z2, the reversed x2 and the slid o2 were all allowed.",
        hints=(
            (
                "Four things look odd in these frames. Three of them are free choices: which rules"
                " do they keep?"
            ),
            "Go through the origins: does each lie on its own z?",
        ),
    ),
    Frames(
        id="04.10",
        practice=True,
        title="An arm with a sliding joint",
        points=3,
        draw=draw_sliding,
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
