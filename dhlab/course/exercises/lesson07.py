"""Lesson 07, troubleshooting: from a symptom to its cause, by hand and with the doctor; three ways
to check a table; zero offsets.
"""

from ...arm import Arm
from ...doctor.programs.cases import SPECIAL, general_chain
from ...doctor.programs.wrong.products import product
from ...table import DHTable
from ..kinds import Choice, Function, Option, Order, Prediction, Value
from ..kinds.tabled.repaired import Impostor, Repair
from .answers07 import (
    CAUSES,
    CRANE,
    OF_SYMPTOMS,
    PUMA,
    article,
    draw_length,
    draw_offsets,
    draw_pasted,
    explain_match,
    mended_length,
    offsets_of,
    story,
    turned_by_theta,
    two_sources,
    wrong_offsets,
)

__all__ = ["EXERCISES"]

EXERCISES = [
    Order(
        id="07.1",
        title="From a symptom to its cause",
        question="A cause for each of the symptoms 1 to 5, in this order; one cause is left over.",
        points=2,
        length=5,
        repeats=True,
        items={cause: text for cause, (text, _) in CAUSES.items()},
        accepts=lambda causes: causes == OF_SYMPTOMS,
        explain=explain_match,
        praise="Each cause leaves its own trace; one of the six leaves none.",
        hints=(
            (
                "Ask of every symptom: is the rotation touched? Does the error stay the same, and"
                " seen from where?"
            ),
            (
                "What is fixed to the floor shifts every pose alike; what is fixed to the hand"
                " shifts it alike seen from the hand. One of the causes leaves no trace at all."
            ),
        ),
    ),
    Prediction(
        id="07.P1",
        title="A length that is 5 cm too long",
        question="What is the residual at different poses?",
        options={
            "same-vector": "the same vector at every pose",
            "same-length": "5 cm long at every pose, in another direction each time",
            "grows": "the further the arm reaches, the larger",
        },
        correct="same-length",
        outcome=(
            "every link behind is carried along by 5 cm, in the direction of x2: the length of the"
            " error is the error of the length, and its direction turns with the link."
        ),
    ),
    Impostor(
        id="07.4",
        title="A wrong table that passes q = 0",
        points=2,
        answer=lambda: Arm(DHTable.standard(CRANE, angle="deg")),
        handed_out=lambda: CRANE,
        praise="A perfect impostor.",
        hints=(
            (
                "At q = 0 upper arm and forearm lie on one line. Which wrong lengths would still"
                " add up?"
            ),
            "A stretched arm shows some lengths only as a sum. Share that sum out in another way.",
        ),
    ),
    Prediction(
        id="07.P2",
        title="Three tables, one joint moved",
        question="Which table draws no arc?",
        options={
            "reversed": "the one that missed the cup",
            "random": "the random one",
            "both": "both the one that missed the cup and the random one",
            "none": "all three draw an arc",
        },
        correct="none",
        outcome=(
            "all three draw exact circles. What stands before the joint and what stands behind it"
            " are constant while only this joint turns, whatever the table says:"
            " T = L · Rz(θ5) · M."
        ),
    ),
    Choice(
        id="07.5",
        title="What the arc proves",
        question=(
            "Joint 5 of the real arm was moved, and the measured points lie on a circle. What"
            " follows?"
        ),
        correct="measurement",
        hints=(
            (
                "Write T(q5) = L · Rz(θ5) · M. What do wrong numbers in L and M do to the kind of"
                " path?"
            ),
            "What would have to happen on the real arm for the points to leave the circle?",
        ),
        options={
            "table": Option(
                "the table is right",
                "A table of random numbers passed as well: T = L · Rz(θ5) · M draws a circle for"
                " any L and M.",
                "arc-taken-for-proof",
            ),
            "row-5": Option(
                "a and α of row 5 are right",
                "Change them to anything: L · Rz(θ5) · M still draws a circle.",
                "arc-taken-for-proof",
            ),
            "measurement": Option(
                "only joint 5 moved, without play; of the table, nothing",
                "T = L · Rz(θ5) · M with L and M at rest: it is a test of the measurement.",
            ),
            "nothing": Option(
                "nothing at all",
                "A test that can fail tells something when it passes. What would take the points"
                " off the circle?",
                "joints-coupled",
            ),
        },
    ),
    Repair(
        id="07.6",
        title="The table of the missed cup",
        points=3,
        answer=lambda **log: article(),
        draw=story,
        mistakes=turned_by_theta,
        nearly="You are nearly there: the angle that is meant is a multiple of 90°.",
        handed_out=lambda rows, **log: rows,
        praise="That was it: z4, drawn with its arrow on the wrong side. Two days.",
        hints=(
            (
                "Which is the last joint whose axis is where the table has it, in place and in"
                " direction? Which is the first whose axis is not?"
            ),
            (
                "Row i makes the axis of joint i + 1. Of the four numbers of the guilty row, look"
                " for the one that tilts this axis and leaves the arc of joint i where it is about"
                " its own axis."
            ),
        ),
    ),
    Repair(
        id="07.8",
        title="A table from a paper",
        points=3,
        answer=lambda **paper: Arm(DHTable.standard(PUMA, angle="deg")),
        draw=draw_pasted,
        nearly="You are nearly there: all that was lost on paper is a sign.",
        handed_out=lambda rows, **log: rows,
        praise="A Puma 560, repaired from six circles.",
        hints=(
            (
                "Which is the first axis that is turned or shifted? Row i makes the axis of joint"
                " i + 1."
            ),
            (
                "A lost sign changes a number by twice its size. So what is 180° off was an α of"
                " 90°; and half of a shift is the d or the a that lost its sign."
            ),
        ),
    ),
    Function(
        id="07.2",
        practice=True,
        title="A program for six axes",
        points=2,
        draw=general_chain,
        special=SPECIAL["forward_kinematics"],
        answer=product,
        names=("rows", "q"),
        family="forward_kinematics",
        handed_out=two_sources,
        sparing=True,
        praise="One conversion too many. On a flat arm, where every α is 0, nobody could notice.",
        hints=(
            (
                "A flat arm has α = 0 in every row. Which line does something that makes no"
                " difference then?"
            ),
            "Which unit does α come in, and which unit does dh_transform want?",
        ),
    ),
    Repair(
        id="07.3",
        practice=True,
        title="Which length, and by how much",
        points=3,
        answer=mended_length,
        draw=draw_length,
        nearly="You are nearly there, and what is left is noise. Round as the question says.",
        handed_out=lambda rows, **log: rows,
        praise="One arrow accused itself: the residual lay along it at every pose.",
        hints=(
            (
                "d_i acts along z_{i-1}, which is frames[:, i - 1, :3, 2]; a_i acts along x_i,"
                " which is frames[:, i, :3, 0]."
            ),
            (
                "Multiply the residuals with an arrow and add over the three coordinates. The"
                " guilty arrow gives nearly one number at every pose, within the tape's noise, and"
                " its mean is missing in the table."
            ),
        ),
    ),
    Value(
        id="07.7",
        practice=True,
        title="Zero offsets of shoulder and elbow",
        points=2,
        draw=draw_offsets,
        answer=offsets_of,
        mistakes=wrong_offsets,
        turns=(0, 1),
        units=("deg", "deg"),
        tolerance=0.04,
        entries=("joint 2", "joint 3"),
        praise="Added to θ, these two bring the model from centimetres down to the noise.",
        hints=(
            "calibrate_offsets returns a Calibration; what is in its offsets?",
            "The offsets are in radians, one per joint; joints 2 and 3 stand at places 1 and 2.",
        ),
    ),
]
