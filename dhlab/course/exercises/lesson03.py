"""Lesson 03, standard against Craig: where the frames sit, the order of the moves, telling
published tables apart, converting.
"""

from ...doctor.programs.cases import SPECIAL, general_row
from ...doctor.programs.wrong.craig import craig
from ..kinds import Choice, Option, Order, Prediction, Value
from ..kinds.tabled.copied import Copied
from .answers03 import (
    COPIED,
    badly_repaired,
    draw_broken,
    draw_craig,
    draw_standard,
    half_to_craig,
    half_to_standard,
    repaired,
    to_craig,
    to_standard,
)
from .orders03 import (
    CRAIG_ORDERS,
    CRAIGS_WORDS,
    PUBLISHED,
    REASONS,
    SIDES,
    CraigsMatrix,
    explain_order,
    explain_published,
    explain_reasons,
    explain_sides,
)
from .unseen03 import draw_unseen, unseen_point, whole_pose, wrong_points

__all__ = ["EXERCISES"]

EXERCISES = [
    Prediction(
        id="03.P1",
        title="Joint 2 turns alone",
        question="Which origin {2} moves?",
        options={"both": "both", "standard": "only the standard one", "craig": "only Craig's"},
        correct="standard",
        outcome=(
            "Craig's {2} sits on the axis of joint 2, and what lies on the axis stays. The standard"
            " {2} sits at the far end of the link and swings."
        ),
    ),
    Order(
        id="03.1",
        title="Whose frame is it",
        question="Which convention is each sentence about? Six letters.",
        alphabet="sc",
        places=(
            "$z_i$ lies on the axis of joint i",
            "$z_i$ lies on the axis of joint i+1",
            "row i holds the a and α of link i−1",
            "the last plate, {n}, always sits on the axis of a joint",
            "plate {i} is bolted to the far end of link i",
            "in row i the joint's own turn comes first, then the link behind it",
        ),
        repeats=True,
        items={"standard": "standard", "craig": "Craig's"},
        accepts=lambda given: given == SIDES,
        explain=explain_sides,
        praise="Far end for the standard convention, near end for Craig's; the rest follows.",
        hints=(
            (
                "Link i runs from the axis of joint i to the axis of joint i+1. Which convention"
                " bolts its plate to which end?"
            ),
            (
                "Craig's z carries the number of its own joint. With the far end, the next joint's"
                " axis is z."
            ),
        ),
    ),
    Order(
        id="03.2",
        title="Craig's four moves in order",
        question=(
            "Put the four moves into an order that gives Craig's link matrix; any right one"
            " will do."
        ),
        items={"rz": "Rz(θ)", "tz": "Tz(d)", "tx": "Tx(a)", "rx": "Rx(α)"},
        accepts=lambda order: order in CRAIG_ORDERS,
        explain=explain_order,
        praise="Five of the 24 orders give Craig's matrix, and yours is one of them.",
        hints=(
            (
                "From near end to near end: first along the link before, then about the own joint."
                " Which two moves belong to the link?"
            ),
            "Both x moves come before Rz(θ).",
        ),
    ),
    Prediction(
        id="03.P2",
        title="The same rows in Craig's matrix, at q = 0",
        question=(
            "At q = 0 the right pose is (0.75, −0.2, 0.1), tool along −y0. What does the wrong"
            " program say?"
        ),
        options={
            "everything": "everything differs",
            "one-sign": "the rotation is right, and one sign of the position differs",
            "nothing": "nothing differs",
        },
        correct="one-sign",
        outcome=(
            "the rotation is right and the position is (0.75, -0.2, -0.1) where (0.75, -0.2, 0.1)"
            " belongs. Away from q = 0 nothing agrees any more."
        ),
    ),
    Choice(
        id="03.4",
        title="The same numbers, another arm",
        question="Why are the same rows another arm?",
        correct="link-before",
        hints=(
            "Write the two link matrices side by side. Which moves come before the joint's turn?",
            "Row 1: does joint 1 tip over when α1 acts before its turn?",
        ),
        options={
            "link-before": Option(
                "in Craig's matrix a and α act before the joint turns: they must be those of the"
                " link before",
                "So each joint got the wrong link in front of it: "
                "joint 1 was tipped by α1 = 90° and turned about a level axis.",
            ),
            "clockwise": Option(
                "Craig counts angles clockwise",
                "Both count by the right hand.",
                "all-joints-left-handed",
            ),
            "base": Option(
                "only the base frame is another: one constant base pose repairs it",
                "No constant base and tool repair it: the joints' axes themselves stand wrong.",
                "base-turned",
            ),
            "mistyped": Option(
                "the order of moves does not matter, the rows must have been mistyped",
                "The rows are digit by digit those of the right table. The order does matter.",
                "order-taken-for-free",
            ),
        },
    ),
    Copied(
        id="03.7",
        title="From standard to Craig",
        points=2,
        draw=draw_standard,
        answer=to_craig,
        convention="craig",
        mistakes=half_to_craig,
        compared=COPIED,
        praise="θ and d stayed, the pairs moved down, the last one is the tool's.",
        hints=(
            (
                "θ and d belong to the joint and stay. a and α belong to the link: in which row"
                " does Craig write the link behind joint 1?"
            ),
            (
                "Row 1 has no link before it: zeros. Row 2 holds the pair of link 1, row 3 that of"
                " link 2."
            ),
        ),
    ),
    Copied(
        id="03.9",
        title="A table half converted",
        draw=draw_broken,
        answer=repaired,
        mistakes=badly_repaired,
        compared=COPIED,
        convention="craig",
        handed_out=lambda standard, converted: converted,
        sparing=True,
        praise="Column a had stayed behind. A half-converted table looks as tidy as a right one.",
        hints=(
            (
                "Compare the two tables column by column. Which columns stayed, and which of them"
                " should have?"
            ),
            "α has moved down one row. Its partner has not.",
        ),
    ),
    Value(
        id="03.10",
        title="A table with no name on it",
        points=3,
        draw=draw_unseen,
        answer=unseen_point,
        mistakes=wrong_points,
        misshapen=whole_pose,
        units="m",
        entries=("x", "y", "z"),
        praise="One check pose settled what no looking at the rows could.",
        hints=(
            ("The two arms are the two readings. See which of them meets p_check at q_check."),
            "Both the rows and q are in degrees; forward takes radians.",
        ),
    ),
    CraigsMatrix(
        id="03.3",
        practice=True,
        title="craig_transform",
        points=2,
        draw=general_row,
        special=SPECIAL["dh_transform"],
        answer=craig,
        names=("theta", "d", "a", "alpha"),
        family="craig_transform",
        words=CRAIGS_WORDS,
        praise="The same four moves, the other way about.",
        hints=(
            "Multiply the four moves in the order of 03.2, from left to right.",
            "Link first: the two x moves. Then the joint: the two z moves.",
        ),
    ),
    Order(
        id="03.5",
        practice=True,
        title="Published tables to classify",
        question="Which convention is each of the six tables written in? Six letters.",
        alphabet="sc",
        points=2,
        length=6,
        repeats=True,
        items={"standard": "standard", "craig": "Craig's"},
        accepts=lambda given: given == PUBLISHED,
        explain=explain_published,
        praise="All six. A habit of tables, and a good first guess.",
        hints=(
            "What comes before joint 1, and what after the last joint? Mostly nothing.",
            (
                "Craig's row 1 holds the link before joint 1, the standard last row the link after"
                " the last joint: there the zeros stand."
            ),
        ),
    ),
    Order(
        id="03.6",
        practice=True,
        title="Why two tables differ",
        question="What is behind each pair? Five letters; one is left over.",
        points=2,
        length=5,
        repeats=True,
        items={
            "convention": "another convention, the same arm",
            "hand": "a hand is counted in",
            "digit": "a wrong digit",
            "zero-pose": "another zero pose",
            "reversed-joint": "a joint counted the other way",
            "other-robots": "different robots",
        },
        accepts=lambda given: given == REASONS,
        explain=explain_reasons,
        praise="One of five was the convention. Ask what differs before you convert.",
        hints=(
            (
                "Let dh.equivalent speak: it names the first joint that differs, or what would make"
                " the two one arm."
            ),
            (
                "Read each sentence to its end: a tool, 0.3 mm, a joint's zero, a joint's"
                " direction, or nothing but the convention."
            ),
        ),
    ),
    Copied(
        id="03.8",
        practice=True,
        title="From Craig to standard",
        points=2,
        draw=draw_craig,
        answer=to_standard,
        convention="standard",
        mistakes=half_to_standard,
        compared=COPIED,
        praise="The pairs moved up, and zeros stand in the last row.",
        hints=(
            "The other way round: which way do the pairs move now?",
            (
                "Row i of the standard table takes a and α from row i+1. What comes after the last"
                " row?"
            ),
        ),
    ),
]
