"""Lesson 05, the link matrix: four moves, their order, the closed form."""

import numpy as np

from ...doctor.programs.cases import SPECIAL, general_row
from ...doctor.programs.wrong.links import standard
from ...transform import rot_x, rot_z
from ..kinds import Choice, Function, Option, Order, Prediction, Said, Value
from .answers05 import (
    OTHER_ORDERS,
    draw_angle,
    draw_column,
    draw_slide,
    explain_order,
    row_in_radians,
    slide,
    wrong_origins,
    wrong_slides,
)
from .closed05 import OF_THE_MATRIX, TYPED, ClosedForm, closed, from_a_blog

__all__ = ["EXERCISES"]

EXERCISES = [
    Prediction(
        id="05.P1",
        title="Turn, then step; step, then turn",
        question=(
            "The first turns, then steps; the second steps, then turns. Where do they end, as"
            " (x, y)?"
        ),
        options={
            "same-place": "both end at the same place",
            "step-turned": "the first ends at (0, 0.4), the second at (0.4, 0)",
            "step-straight": "the first ends at (0.4, 0), the second at (0, 0.4)",
        },
        correct="step-turned",
        outcome=(
            "turning first turns the x arrow too, so the step goes along y0. Stepping first goes"
            " along x0, and the turn comes too late to matter."
        ),
    ),
    Function(
        id="05.1",
        title="A turn about x",
        draw=draw_angle,
        special=((0.0,), (np.pi / 2,), (-np.pi / 2,), (np.pi,)),
        answer=rot_x,
        names=("alpha",),
        family="rot_x",
        in_lesson=(rot_z,),
        praise="x stays; y goes towards z.",
        words={
            "rotation-transposed": Said(
                "the turn goes the other way",
                next="Take the second column at α = 90°: y must go to z, (0, 0, 1).",
            ),
            "mirror": Said(
                "x, y and z do not turn together",
                next=(
                    "x stays. Tip y a little towards z: which way does z go, and which sine carries"
                    " the minus?"
                ),
                why="The three must stay at right angles, and z = x × y.",
            ),
            "rotation-block-misread": Said(
                "this is a turn, but not about x",
                next="Which row and column keep their 1? They belong to the axis that stays.",
            ),
            "matrix-entry-mistyped": Said(
                "not every entry is right",
                next=(
                    "Put α = 30° in, then −30°: which way does y tip, which way z, and by how much?"
                ),
            ),
        },
        hints=(
            "Compare with rot_z: the axis that stays has a 1 on the diagonal. Which one stays now?",
            "The second column says where y goes: cos α along y, sin α along z.",
        ),
    ),
    Order(
        id="05.3",
        title="The four moves in order",
        question=(
            "The order Rz(θ), Tz(d), Tx(a), Rx(α) gives the standard link matrix. Give one of the"
            " four others that do."
        ),
        items={"rz": "Rz(θ)", "tz": "Tz(d)", "tx": "Tx(a)", "rx": "Rx(α)"},
        accepts=lambda order: order in OTHER_ORDERS,
        explain=explain_order,
        praise="Five of the 24 orders give this matrix, and yours is one of the four others.",
        hints=(
            "Two of the moves belong to z, two to x. Which pair does a standard row make first?",
            "Tx(a) must come after Rz(θ), and Rx(α) after both z moves.",
        ),
    ),
    Function(
        id="05.4",
        title="dh_transform from four moves",
        points=2,
        draw=general_row,
        special=SPECIAL["dh_transform"],
        answer=standard,
        names=("theta", "d", "a", "alpha"),
        family="dh_transform",
        in_lesson=(from_a_blog,),
        praise="It is Rz, Tz, Tx and Rx, multiplied from left to right.",
        words=OF_THE_MATRIX,
        hints=(
            "Write the four matrices first, in the order about z, along z, along x, about x.",
            (
                "Each new move is made in the current frame, so it goes to the right of those"
                " already made."
            ),
        ),
    ),
    Prediction(
        id="05.P2",
        title="One test, 24 orders",
        question="How many of the 24 orders pass the test θ = 0, d = 0, a = 1, α = 0?",
        options={"one": "1", "five": "5", "all": "24"},
        correct="all",
        outcome=(
            "with θ = d = α = 0 three of the moves do nothing, and one move alone has no order. All"
            " 24 pass."
        ),
    ),
    ClosedForm(
        id="05.6",
        title="dh_transform in closed form",
        points=2,
        draw=general_row,
        special=SPECIAL["dh_transform"],
        answer=closed,
        names=("theta", "d", "a", "alpha"),
        family="dh_transform",
        sparing=True,
        praise="The same matrix as the four moves make, entry by entry.",
        words=OF_THE_MATRIX | TYPED,
        hints=(
            (
                "First column: the x arrow after the turn by θ. Last column: a times that arrow,"
                " and d."
            ),
            (
                "The second column is the turned y arrow (-sin θ, cos θ, 0), tilted towards z by α;"
                " the third is what is then left for z."
            ),
        ),
    ),
    ClosedForm(
        id="05.7",
        title="A sign in a copied matrix",
        draw=general_row,
        special=SPECIAL["dh_transform"],
        answer=closed,
        names=("theta", "d", "a", "alpha"),
        family="dh_transform",
        sparing=True,
        handed_out=from_a_blog,
        praise="One sign was wrong. It hides whenever α is 0, and also at θ = ±90°.",
        words=OF_THE_MATRIX | TYPED,
        hints=(
            "Compare the third column with that of your dh_closed.",
            (
                "The third column must be at right angles to the first: multiply them entry by"
                " entry and add."
            ),
        ),
    ),
    Value(
        id="05.9",
        title="The matrix of a sliding joint",
        points=2,
        draw=draw_slide,
        answer=slide,
        mistakes=wrong_slides,
        units="pose",
        tolerance=1e-6,
        praise="For a sliding joint d moves and θ stays: the matrix is the same.",
        hints=(
            "Which of the four numbers does a sliding joint change?",
            "Call your dh_transform with theta = -90° in radians and d = q3.",
        ),
    ),
    Choice(
        id="05.2",
        practice=True,
        title="Moves that commute",
        question="Which of the four moves may change places with which?",
        correct="about-one-axis",
        hints=(
            "Try each pair with your hand: does the first move change the direction of the second?",
            "A turn about an axis leaves that axis where it is.",
        ),
        options={
            "none": Option(
                "none: every change of order is a mistake",
                "Too strict: a turn about z leaves the z axis where it is, so a shift along z does"
                " not notice.",
                "every-order-taken-for-wrong",
            ),
            "about-one-axis": Option(
                "Rz with Tz, Tx with Rx, and Tz with Tx",
                "Turn and shift about one axis commute, and so do two shifts: five of the 24 orders"
                " are right.",
            ),
            "turns-with-shifts": Option(
                "all turns with all shifts",
                "A turn about z does change where a shift along x goes.",
                "order-taken-for-free",
            ),
            "both-turns": Option(
                "Rz with Rx, since both are turns",
                "Turns about different axes do not commute: try a book on the table.",
                "order-taken-for-free",
            ),
        },
    ),
    Value(
        id="05.5",
        practice=True,
        title="The new origin",
        draw=draw_column,
        answer=lambda **row: row_in_radians(**row)[:3, 3],
        mistakes=wrong_origins,
        units="m",
        entries=("x", "y", "z"),
        praise="The link swings with θ; d lifts it; α has no say in the position.",
        hints=(
            (
                "The last column of the link matrix is where the origin goes: which of the four"
                " numbers enter it?"
            ),
            "a is walked along the new x arrow, which θ has turned: (a cos θ, a sin θ, d).",
        ),
    ),
    Choice(
        id="05.8",
        practice=True,
        title="What a good test needs",
        question="Which test would have shown that sign?",
        correct="general",
        hints=(
            "Which numbers make sin or cos vanish?",
            "A sign can only show where what it multiplies is not 0.",
        ),
        options={
            "unit-step": Option(
                "θ = 0, d = 0, a = 1, α = 0, and look for a shift of 1 along x",
                "All 24 orders of the moves pass this one.",
                "only-zero-pose-checked",
            ),
            "right-angles": Option(
                "all angles 90°, since the matrix is then clean",
                "Clean, because the cosines vanish, and what they multiply is never tested.",
                "only-zero-pose-checked",
            ),
            "positions": Option(
                "compare the positions only, that is what counts",
                "α never enters the position of its own link: the nine numbers of the rotation"
                " would go untested.",
                "only-zero-pose-checked",
            ),
            "general": Option(
                "values without zeros and right angles, position and rotation both",
                "Then every entry, and every sign, has to be right.",
            ),
        },
    ),
]
