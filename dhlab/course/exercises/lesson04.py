"""Lesson 04, placing frames: z on the joint axes, origins and x on the common normals, what is
free, and three beginner's mistakes.
"""

from ...arm import Arm
from ...table import DHTable
from ..kinds import Choice, Option, Order, Prediction
from ..kinds.placed import Frames
from .answers04 import (
    OF_Z,
    READ,
    ReadTable,
    draw_colleagues,
    draw_shoulder,
    draw_skew,
    draw_sliding,
    explain_lines,
)

__all__ = ["EXERCISES"]

EXERCISES = [
    Order(
        id="04.1",
        title="Six lines, three axes",
        question="Which line carries z0, which z1, which z2? Three letters, in this order.",
        length=3,
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
                "All points of axis 2 have the same x and the same z. Only y is open, and axis 1"
                " has its own y."
            ),
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
        draw=draw_shoulder,
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
        question="The two tables differ in every row. And the poses of the tool?",
        options={
            "different": "different: one of the two tables must be wrong",
            "same-at-zero": "the same at q = 0, different elsewhere",
            "same": "the same for every q",
        },
        correct="same",
        outcome=(
            "every choice kept the rules, so both tables are the arm. More than half of the numbers"
            " differ, and no pose does."
        ),
    ),
    ReadTable(
        id="04.5",
        title="Read the table off the frames",
        points=2,
        answer=lambda: Arm(DHTable.standard(READ, angle="deg")),
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
                "neither: a step sideways belongs into a",
                "a runs along x, across the axes. This step is along them.",
                "a-d-exchanged",
            ),
        },
    ),
    Frames(
        id="04.7",
        title="A colleague's frames",
        draw=draw_colleagues,
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
        question="z2 is turned round, properly. What changes?",
        correct="five-things",
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
            "nothing": Option(
                "nothing: the line is the same, only the arrow differs",
                "α is an angle between arrows, and d and θ are counted along one.",
                "z-flip-incomplete",
            ),
            "alpha-2": Option(
                "α2 alone, by 180°",
                "Then everything behind joint 3 is upside down. The story's two days began like"
                " this.",
                "z-flip-incomplete",
            ),
            "arm": Option(
                "the arm: with its z reversed a joint moves to other places",
                "The arm has never heard of z. Joint 3 counts the other way, that is all.",
                "joint-reversed",
            ),
            "five-things": Option(
                "α2 and α3 by 180°, θ3 and d3 in sign, and joint 3 counts the other way",
                "All five together, and the arm is the same.",
            ),
        },
    ),
    Choice(
        id="04.9",
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
                "one of the tables has a wrong a or d",
                "Then the difference would change with the joints behind that row.",
                "length-value",
            ),
            "base-frame": Option(
                "the two did not agree on the base frame",
                "A base difference is constant in the base's directions. This one turns with the"
                " wrist.",
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
        id="04.10",
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
