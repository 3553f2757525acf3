"""Lesson 01, frames: reading, building and composing poses; base, flange and tool."""

from ..kinds import Choice, Function, Option, Order, Prediction, Value
from .answers01 import (
    draw_corner,
    draw_pose,
    general_pose,
    misread_axis,
    misshapen_axis,
    plate,
    wrong_plates,
)
from .chains01 import (
    FROM_BASE_TO_TOOL,
    LINKS,
    draw_chain,
    draw_tool,
    explain_chain,
    misshapen_point,
    misshapen_tip,
    point_in_base,
    wrong_points,
    wrong_tips,
)
from .compose01 import COMPOSED

__all__ = ["EXERCISES"]

EXERCISES = [
    Prediction(
        id="01.P1",
        title="A plate turned about its x arrow",
        question="Where does the plate's z arrow point after the turn?",
        options={"along-y": "along y0", "against-y": "against y0", "up": "up, as before"},
        correct="against-y",
        outcome="a turn by +90° about x carries y to z and z to -y: the z arrow points against y0.",
    ),
    Value(
        id="01.1",
        title="Read an arrow",
        draw=draw_pose,
        answer=lambda T_01: T_01[:3, 0],
        mistakes=misread_axis,
        misshapen=misshapen_axis,
        entries=("x0 coordinate", "y0 coordinate", "z0 coordinate"),
        tolerance=2e-3,
        praise="The first column is the plate's x arrow, written in the base.",
        hints=(
            "A pose T_01 has four columns: three arrows and an origin. Which comes first?",
            "Take the first three numbers of one column, from top to bottom.",
        ),
    ),
    Value(
        id="01.2",
        title="The pose of a camera plate",
        points=2,
        draw=draw_corner,
        answer=plate,
        mistakes=wrong_plates,
        units="pose",
        tolerance=1e-6,
        praise="Three arrows as columns, the origin beside them, 0 0 0 1 below.",
        hints=(
            (
                "Write the arrows one by one as columns. You know x and z; the right hand gives y ="
                " z × x."
            ),
            (
                "x points along y0, so the first column is 0 1 0. Stand in the base and ask where y"
                " must point for a right hand."
            ),
        ),
    ),
    Prediction(
        id="01.P2",
        title="Two poses in the other order",
        question=(
            "Both poses turn about z, by 90° and by −30°. How does `T_12 @ T_01` compare with `T_01"
            " @ T_12`?"
        ),
        options={
            "same": "the same",
            "other-place": "turned the same way, at another place",
            "other-turn": "at another place, and turned another way",
        },
        correct="other-place",
        outcome=(
            "both turns are about z, so the directions agree; the shifts were made along different"
            " arrows, so the places differ. With turns about different axes the directions differ"
            " as well."
        ),
    ),
    Function(
        id="01.4",
        title="Compose two poses",
        points=2,
        draw=lambda rng: (general_pose(rng), general_pose(rng)),
        answer=lambda A, B: A @ B,
        names=("T_ab", "T_bc"),
        family="compose",
        words=COMPOSED,
        praise="One product turns, shifts and keeps the last row, all at once.",
        hints=(
            "Inner subscripts meet: T_ab and T_bc share b, and b disappears.",
            "numpy's matrix product is @; the pose that is nearer to the base stands on the left.",
        ),
    ),
    Order(
        id="01.5",
        title="From base to tool",
        question=(
            "Which four poses, multiplied from left to right, give T_0T? Put their letters in"
            " order."
        ),
        length=4,
        items=LINKS,
        accepts=lambda order: order == FROM_BASE_TO_TOOL,
        explain=explain_chain,
        praise="Each inner pair meets: 0·1, 1·2, 2·F, F·T.",
        hints=(
            "The product must begin with 0 and end with T.",
            "Neighbours must meet: after T_01 comes a pose that begins with 1.",
        ),
    ),
    Choice(
        id="01.6",
        title="Twenty poses, no camera",
        question="Why does no single camera pose fit?",
        correct="flange-and-tip",
        hints=(
            "Which two frames are both called “the end of the arm”?",
            (
                "One side of the calibration was told where the flange is. What was the other side"
                " looking at?"
            ),
        ),
        options={
            "tilted": Option(
                "the camera was not level",
                "A tilted camera is no trouble: its tilt is one of the numbers that calibration"
                " finds.",
                "wrong-frame-compared",
            ),
            "transposed": Option(
                "the rotation matrices were transposed",
                "Then the poses themselves would have been wrong. Here every one that was noted is"
                " right.",
                "rotation-transposed",
            ),
            "flange-and-tip": Option(
                "the controller reported the flange, the camera saw the tool's tip",
                "The tool's length turns with the wrist, so no constant camera pose can make up"
                " for it.",
            ),
            "wrong-order": Option(
                "the poses were multiplied in the wrong order",
                "Then the errors would have had nothing to do with the tool. Here they are as large"
                " as the tool is long.",
                "product-reversed",
            ),
        },
    ),
    Value(
        id="01.7",
        title="The tip of a bent gripper",
        points=2,
        draw=draw_tool,
        answer=lambda T_0F, T_FT: (T_0F @ T_FT)[:3, 3],
        mistakes=wrong_tips,
        units="m",
        misshapen=misshapen_tip,
        entries=("x0", "y0", "z0"),
        praise="Base to flange, flange to tool: the chain is the same on every arm.",
        hints=(
            "Write the chain with its subscripts first: 0 to F, F to T.",
            "The tip is the origin of frame T: which column of T_0T is that?",
        ),
    ),
    Value(
        id="01.3",
        practice=True,
        title="A point of the second plate, in the base",
        draw=draw_chain,
        answer=point_in_base,
        mistakes=wrong_points,
        units="m",
        misshapen=misshapen_point,
        entries=("x0", "y0", "z0"),
        praise="Turn first, then shift.",
        hints=(
            "The shift p_12 is written in plate 1's arrows. Where do these point in the base?",
            "Turn p_12 with the rotation block first; what must be added to it then?",
        ),
    ),
]
