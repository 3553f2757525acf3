"""Lesson 09, your own arm: axes to a table, a check against data, the doctor; and the post-test,
which mirrors the pre-test of lesson 00.
"""

from ...arm import Arm
from ...doctor.programs.cases import SPECIAL, general_chain
from ...doctor.programs.wrong.products import product
from ...geometry.procedure.frames import assign_frames
from ...robots import load
from ...table import DHTable
from ..kinds import Choice, Function, Option, Order, Prediction, Table, Value
from ..kinds.tabled.copied import Copied
from ..kinds.tabled.sheets import OfAxes
from .answers03 import COPIED
from .answers09 import MAKERS, PIPER, unrepaired, wrong_piper
from .bench09 import draw_bench, misread_bench, reading
from .posttest09 import (
    THROWN_AWAY,
    between,
    draw_craig,
    draw_flange,
    draw_rows,
    explain_work,
    half_moved,
    misread_arrow,
    misread_rows,
    reversed_product,
)
from .sheet09 import draw_sheet, of_six, wrong_sheets

__all__ = ["EXERCISES"]

EXERCISES = [
    Order(
        id="09.1",
        title="The order of the work",
        question="Put the five steps in order.",
        items={
            "compare": "compare with poses at general q",
            "axes": "draw the joint axes, with the sense of positive motion",
            "frames": "place frames, read off the table",
            "agree": "agree on base, zero pose and end point",
            "doctor": "ask the doctor about what is left",
        },
        accepts=lambda steps: steps == ["agree", "axes", "frames", "compare", "doctor"],
        explain=explain_work,
        praise="That is the way through this lesson, and through every arm.",
        hints=(
            "What must be known before the first axis can be written as numbers?",
            "A doctor needs a patient and findings: a table, and poses that it misses.",
        ),
    ),
    Prediction(
        id="09.P1",
        title="Your rows and the maker's",
        question="How do your rows compare with the maker's?",
        options={
            "same-numbers": "the same numbers, row for row",
            "same-arm": "other numbers in places, and the same arm",
            "other-arm": "another arm",
        },
        correct="same-arm",
        outcome=(
            "three x arrows point the other way, so a2, a3 and α5 have the other sign, and θ2, θ4,"
            " θ5 and θ6 differ by 180°. Every pose agrees."
        ),
    ),
    OfAxes(
        id="09.2",
        title="Two axes of an AR4",
        points=2,
        draw=draw_sheet,
        answer=of_six,
        mistakes=wrong_sheets,
        praise="Six lines and an end: the arm is known.",
        hints=(
            "Joint 5 nods the hand: about which line? Joint 6 spins it: about which? The right"
            " thumb along the line, the fingers as q grows.",
            (
                "The lines of joints 4, 5 and 6 meet in the wrist's centre; the fifth lies across"
                " the forearm, the sixth along the tool."
            ),
        ),
    ),
    Prediction(
        id="09.P2",
        title="A table and a URDF of one arm",
        question="Both describe a UR5e, and both are right. How large is the largest residual?",
        options={
            "millimetre": "less than a millimetre",
            "centimetre": "about a centimetre",
            "metre": "more than a metre",
        },
        correct="metre",
        outcome=(
            "the ROS file counts from a base that is turned by 180° about z. Each is right in its"
            " own base: name the base, and nothing is left."
        ),
    ),
    Value(
        id="09.5",
        title="A column of a pose",
        mirrors="00.2",
        draw=draw_flange,
        answer=lambda T: T[:3, 2],
        mistakes=misread_arrow,
        tolerance=2e-3,
        entries=("x0", "y0", "z0"),
        praise="The third column: the hand's z arrow, written in the base.",
        hints=(
            "Three columns are arrows, one is a place. In which order?",
            "Written in the base means: read downwards.",
        ),
    ),
    Value(
        id="09.6",
        title="What a row says of two axes",
        mirrors="00.3",
        draw=draw_rows,
        answer=between,
        mistakes=misread_rows,
        units=("deg", "m"),
        entries=("angle", "distance"),
        turns=(0,),
        tolerance=1e-4,
        praise=(
            "α is the angle, a the distance; in Craig's table they stand in the later joint's row."
        ),
        hints=(
            "Two of the four numbers speak of two axes, two of a single one. Which are which?",
            "The heading says a(i-1) and alpha(i-1). In which row is i - 1 your joint?",
        ),
    ),
    Copied(
        id="09.7",
        title="Two tables of one arm",
        mirrors="00.4",
        points=2,
        draw=draw_craig,
        answer=lambda table: Arm(table).to("standard"),
        mistakes=half_moved,
        convention="standard",
        compared=COPIED,
        praise="θ and d stay, a and α move up one row.",
        hints=(
            (
                "Which of the columns belong to the joint itself, and which to the way from one"
                " joint to another?"
            ),
            (
                "In Craig's table, row 2 holds what leads from axis 1 to axis 2. In which row does"
                " the standard convention keep it?"
            ),
        ),
    ),
    Function(
        id="09.8",
        title="The order of a product",
        mirrors="00.5",
        draw=general_chain,
        special=SPECIAL["forward_kinematics"],
        answer=product,
        names=("rows", "q"),
        family="forward_kinematics",
        handed_out=reversed_product,
        sparing=True,
        words={("product-starts-late", "only the last row is used"): THROWN_AWAY},
        praise="The base's matrix stands on the left, the last joint's on the right.",
        hints=(
            "For an arm of one joint this program is right. What happens at the second?",
            "Where must a matrix stand that is written in the frame reached so far?",
        ),
    ),
    Choice(
        id="09.9",
        title="What agreeing positions prove",
        question="What may still be wrong in the table, and why?",
        mirrors="00.6",
        points=2,
        correct="last-angles",
        hints=(
            "Which numbers of a table turn the hand without moving the measured point?",
            "The point lies on the axis of joint 7. What can turn about that axis unseen?",
        ),
        options={
            "nothing": Option(
                "nothing: twelve general poses are plenty",
                "They are plenty for what they see. A turn of the hand about the measured point is"
                " nothing they see.",
                "only-position-checked",
            ),
            "last-angles": Option(
                "the last row's angles: they turn the hand and leave the point where it is",
                "Position and rotation, at general values: both, or the end is half known.",
            ),
            "lengths": Option(
                "the lengths of the middle rows",
                "Each of these moves the point, and twelve general poses would show it.",
                "length-value",
            ),
            "sense": Option(
                "the sense of one of the first joints",
                "A joint that counts backwards carries the point elsewhere in all twelve.",
                "joint-reversed",
            ),
        },
    ),
    Table(
        id="09.3",
        practice=True,
        title="The smallest fix: a table from the maker's program",
        points=2,
        answer=lambda: Arm(DHTable.craig(MAKERS, angle="deg"), sign=load("ar4").sign),
        mistakes=unrepaired,
        sparing=True,
        praise=(
            "One number of 24. The maker's own program had it wrong in one place, and right in"
            " another."
        ),
        hints=(
            "Call dh.diagnose with ours, as the comment says, and read its first two lines.",
            (
                "It names the α of a link by the standard row. A Craig row begins with a and α of"
                " the link before its joint."
            ),
        ),
    ),
    Value(
        id="09.10",
        practice=True,
        title="A reading at the stop",
        points=2,
        draw=draw_bench,
        answer=reading,
        mistakes=misread_bench,
        units=("", "deg"),
        entries=("sign", "offset"),
        praise="Two numbers from one reading, and no doctor. The cell below asks the tape.",
        hints=(
            "At the stop you know both: what the encoder reads, and what q2 is.",
            (
                "The encoder counts down where q2 grows: that is the sign. The offset is what makes"
                " the reading at the stop give the stop's angle."
            ),
        ),
    ),
    OfAxes(
        id="09.4",
        practice=True,
        title="Six axes and a flange",
        points=3,
        answer=lambda: assign_frames(PIPER[0], end=PIPER[1]),
        mistakes=wrong_piper,
        tolerance=1e-4,
        praise="From a sheet of paper to an arm, on your own.",
        hints=(
            "Two units must be changed on the way in. Which?",
            (
                "dh.assign_frames takes pairs (point, direction) in metres, and end as a pose:"
                " transform.from_xyz_rpy makes one, in radians."
            ),
        ),
    ),
]
