"""Lesson 04, second sitting, a whole six-axis arm: its frames one after the other, the table read
off them, what is free, and three beginner's mistakes.
"""

from ...arm import Arm
from ...robots import load
from ...table import DHTable
from ..kinds import Choice, Option, Prediction
from ..kinds.frames.placed import Frames
from .answers04 import ReadTable, draw_read, rows_read
from .answers04b import (
    draw_half_arm,
    draw_roll_wrist,
    draw_spoilt_wrist,
    draw_whole_arm,
    off_axis_4,
)

__all__ = ["EXERCISES"]

EXERCISES = [
    Frames(
        id="04.12",
        title="The article's arm, shoulder to forearm",
        points=2,
        draw=draw_half_arm,
        warning=off_axis_4,
        praise="Half the arm stands: z0, z1 and z2 lie on the axes of joints 1, 2 and 3.",
        hints=(
            "Frames 0 and 1 are placed. z2 lies on the axis of joint 3; frame 3 stands at the"
            " forearm's end.",
            "Axes 2 and 3 are parallel: x2 points straight across, from one to the other.",
        ),
    ),
    Frames(
        id="04.13",
        title="The article's arm, whole",
        points=3,
        draw=draw_whole_arm,
        published=lambda **given: load("article-6r"),
        known_as="that of lesson 06",
        praise="Seven frames on six bare axes.",
        hints=(
            "z4 is on the axis of joint 5, z5 on that of joint 6, and z6 is yours: along the tool.",
            "Axes 4, 5 and 6 meet in one point. There o4 and o5 stand, each x at right angles to"
            " its z and the z before it.",
        ),
    ),
    Frames(
        id="04.14",
        title="One frame too far",
        draw=draw_spoilt_wrist,
        sparing=True,
        praise="The wrist's axes meet, and the origin stands where they do. All else was allowed.",
        hints=(
            "Go from frame to frame and say the case of the two axes: which rule does each keep?",
            "In the wrist two axes meet. Where does the origin stand then, and where is it here?",
        ),
    ),
    ReadTable(
        id="04.5",
        title="Read the table off the frames",
        points=2,
        draw=draw_read,
        answer=lambda **given: Arm(DHTable.standard(rows_read(**given), angle="deg")),
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
    Prediction(
        id="04.P2",
        title="Two learners, two tables",
        question="The two tables differ in every row. What is the same on both arms?",
        options={
            "nothing": "nothing: one of the two tables must be wrong",
            "tool-at-zero": "the tool's pose at q = 0, and not elsewhere",
            "tool": "the tool's pose at every q, and no frame's",
            "frames": "the pose of the tool and of every frame, at every q",
        },
        correct="tool",
        outcome=(
            "every choice kept the rules, so both tables are the arm. Each frame stands otherwise,"
            " more than half of the numbers differ, and the tool's pose never does."
        ),
    ),
    Prediction(
        id="04.P4",
        title="Turning one x",
        question=(
            "In Ada's frames x2 is turned round, and nothing else; her α2 is 0. Which numbers of"
            " the table change?"
        ),
        options={
            "length": "a2 changes sign, and nothing else",
            "one-row": "a2 changes sign, and θ2 changes by 180°",
            "two-rows": "a2 changes sign, and θ2 and θ3 change by 180°",
        },
        correct="two-rows",
        outcome=(
            "a2 is counted along x2 and changes sign, as an α2 that is not 0 would; θ2 ends at x2"
            " and θ3 begins there, so both change by 180°."
        ),
    ),
    Choice(
        id="04.8",
        title="A z axis turned round",
        question=(
            "Somebody turned z2 round and changed α2 by 180°, θ3 and d3 in sign, and the way joint"
            " 3 counts. What was forgotten?"
        ),
        correct="alpha-3",
        hints=(
            (
                "Which entries of the table are measured about or along z2? And which have z2 as"
                " their start or their end?"
            ),
            "α2 goes from z1 to z2, about x2. Which α is measured from z2?",
        ),
        options={
            "nothing": Option(
                "nothing: with its z turned round, it is another arm",
                "The arm has never heard of z: whoever changes all that hangs on z2 has the same"
                " arm.",
                "joint-reversed",
            ),
            "lengths": Option(
                "a2 and a3 in sign, since they are lengths",
                "a is counted along x, and no x was turned.",
                "z-flip-incomplete",
            ),
            "alpha-3": Option(
                "α3 by 180°, since it begins at z2",
                "α2 ends at z2 and α3 begins there, θ3 and d3 are counted about and along it. With"
                " the way the joint counts these are five, and the arm is the same.",
            ),
            "theta-2": Option(
                "θ2 by 180°, since it ends in row 2",
                "θ2 goes from x1 to x2, about z1, and none of these was turned.",
                "z-flip-incomplete",
            ),
        },
    ),
    Choice(
        id="04.6",
        practice=True,
        title="A step along parallel axes",
        question="Where does the step of 0.1 m along the parallel axes 2 and 3 belong?",
        correct="either-row",
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
            "row-3": Option(
                "row 3 only: the normal must go through the previous origin, so d2 = 0",
                "That is a habit of books, and a good one, but no rule: slide o2 and d2 is whatever"
                " you like.",
                "table-taken-as-unique",
            ),
            "both-rows": Option(
                "both rows, since both axes are stepped along",
                "Then the step is made twice, and everything behind it is 0.1 m off.",
                "parallel-offset-in-both-rows",
            ),
            "either-row": Option(
                "either row, or a part in each, as long as the sum is 0.1 m",
                "The origin slides along z, d before it grows by what d behind it loses.",
            ),
            "neither": Option(
                "neither: a step sideways belongs in a",
                "a runs along x, across the axes. This step is along them.",
                "a-d-exchanged",
            ),
        },
    ),
    Choice(
        id="04.9",
        practice=True,
        title="The calibration that never fits",
        question=(
            "A camera and an arm report one point. They differ by 0.15 m along the tool's own z,"
            " whatever the pose. What is wrong?"
        ),
        correct="last-frame",
        hints=(
            (
                "The difference is constant in the tool's own directions, and it turns with the"
                " wrist. On which side of the product must it stand?"
            ),
            "Which frame is at that end of the chain, and who said where it is?",
        ),
        options={
            "last-frame": Option(
                "the two did not agree on the last frame: one means the flange, the other the"
                " fingertip",
                "A constant on the right of the product: arm.tool. Neither table is wrong.",
            ),
            "length": Option(
                "one of the tables has a wrong a in row 2",
                "Then the end is off along x2, and in the tool's own directions x2 turns with every"
                " joint behind row 2. This difference does not.",
                "length-value",
            ),
            "base-frame": Option(
                "the two did not agree on the base frame",
                "Then the difference depends on where the point is alone: turn the wrist about it,"
                " and it stays. This one turns with the wrist.",
                "base-turned",
            ),
            "convention": Option(
                "one of the two used Craig's convention",
                "Converted rightly, the pose is the same in both conventions.",
                "standard-rows-in-craig-matrix",
            ),
        },
    ),
    Frames(
        id="04.15",
        practice=True,
        title="A small welding robot",
        points=4,
        draw=draw_roll_wrist,
        praise="Six bare axes, seven frames, no help: this is the method.",
        hints=(
            "All z first: z0 to z5 on the axes of joints 1 to 6, z6 along the tool.",
            "Then pair by pair: meet, parallel, skew, meet, meet. Where they are skew, look for the"
            " foot on the later axis.",
        ),
    ),
]
