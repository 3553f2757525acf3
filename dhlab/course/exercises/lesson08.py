"""Lesson 08, first sitting, beyond forward kinematics: the Jacobian, singularities."""

from ...doctor.programs.wrong.jacobians import geometric_jacobian
from ..kinds import Choice, Option, Order, Prediction, Value
from .answers08 import (
    CALLS,
    COLUMN_LINES,
    NOT_TO_THE_PEN,
    OF_THE_AXIS,
    PEN,
    draw_bend,
    draw_frames,
    explain_column,
    third_column,
    to_the_flange,
    wrong_columns,
)
from .programs08 import Jacobian
from .speeds08 import Speeds, draw_hand_speed, joint_speeds, wrong_speeds

__all__ = ["EXERCISES"]

EXERCISES = [
    Order(
        id="08.10",
        title="A column, line by line",
        question=(
            "The column of joint `i`, counted from 1: put five of the eight lines in order. Three"
            " are wrong in themselves."
        ),
        length=5,
        items={
            "lever-reversed": "`v = np.cross(z, o - p)`",
            "frames": "`frames = arm.frames(q)`",
            "stack": "`column = np.hstack([v, z])`",
            "own-frame": "`z, o = frames[i][:3, 2], frames[i][:3, 3]`",
            "end": "`p = arm.forward(q)[:3, 3]`",
            "lever": "`v = np.cross(z, p - o)`",
            "frame-before": "`z, o = frames[i - 1][:3, 2], frames[i - 1][:3, 3]`",
            "base-origin": "`v = np.cross(z, p)`",
        },
        accepts=lambda lines: lines in COLUMN_LINES,
        explain=explain_column,
        praise="Frames and end, axis and origin, lever, and both halves of the column.",
        hints=(
            "Which lines need nothing but q? What does the line with the cross product need?",
            "Three of the eight are wrong in themselves: joint i turns about the frame before its"
            " link, and the lever runs from the axis to the end.",
        ),
    ),
    Jacobian(
        id="08.2",
        title="The geometric Jacobian",
        points=3,
        draw=draw_frames,
        together=True,
        calls=CALLS,
        answer=geometric_jacobian,
        names=("frames", "T_end", "sliding"),
        family="jacobian",
        shape=(6, 5),
        words=OF_THE_AXIS,
        praise="Turning or sliding, any number of joints, base and tool included.",
        hints=(
            (
                "One column per joint. For joint i, counted from 1, axis and origin come from"
                " frames[i - 1]."
            ),
            (
                "A turning joint gives the cross product of axis and lever, then the axis; a"
                " sliding one the axis, then three zeros. Stack columns side by side."
            ),
        ),
    ),
    Jacobian(
        id="08.11",
        title="The smallest fix: a pen in the hand",
        points=1,
        draw=draw_frames,
        together=True,
        calls=CALLS,
        answer=geometric_jacobian,
        names=("frames", "T_end", "sliding"),
        family="jacobian",
        shape=(6, 5),
        handed_out=to_the_flange,
        sparing=True,
        words=OF_THE_AXIS | {("lever-arm-wrong", place): PEN for place in NOT_TO_THE_PEN},
        praise="The lever runs to the tip of the pen, wherever the last frame may be.",
        hints=(
            "It was right until the pen was mounted. Which of the three inputs knows of the pen?",
            "p is taken from the last frame. With a tool, the end is somewhere else.",
        ),
    ),
    Prediction(
        id="08.P1",
        title="How many directions at q = 0",
        question="What is the rank of J at q = 0?",
        options={"six": "6: there are six joints", "five": "5", "four": "4", "three": "3"},
        correct="four",
        outcome=(
            "the rank is 4. The stretched arm cannot move further out or in; how the other"
            " direction is lost, 08.3 asks."
        ),
    ),
    Choice(
        id="08.3",
        title="Why a direction is lost at θ5 = 0",
        question="At θ5 = 0, elbow bent, the rank is 5. Which rule justifies this?",
        correct="one-line",
        hints=(
            (
                "Print columns 4 and 6 of the Jacobian, or the axes z3 and z5 and the origins they"
                " pass through."
            ),
            "What can two joints do together that turn about one and the same line?",
        ),
        options={
            "stretched": Option(
                "the arm is stretched as far as it goes",
                "At this pose the elbow is bent by 60°, and the end is well inside the reach.",
                "singularity-taken-for-reach-limit",
            ),
            "one-line": Option(
                "axes 4 and 6 lie on one line, so two joints turn the end in one and the same way",
                "Two columns of J are equal, and five directions are left for six joints.",
            ),
            "no-inverse": Option(
                "sin θ5 = 0, so the link matrix A5 has no inverse",
                "Every link matrix is a pose and has its inverse. Forward kinematics never fails.",
                "singularity-taken-for-failure",
            ),
            "limit": Option(
                "joint 5 has reached its limit",
                "No limit enters the Jacobian, and 0° is the middle of the range.",
                "limits-in-forward",
            ),
        },
    ),
    Prediction(
        id="08.P2",
        title="One degree from the singularity",
        question="How fast must joint 4 turn at θ5 = 1°?",
        options={
            "slow": "at about 10° a second",
            "faster": "at about 60° a second",
            "whirl": "at about 600° a second",
            "beyond": "at about 6,000° a second",
        },
        correct="whirl",
        outcome=(
            "joint 4 turns at 572° a second and joint 6 at 573° the other way: the speeds grow"
            " as 1/sin θ5."
        ),
    ),
    Speeds(
        id="08.9",
        title="Joint speeds of a Stanford arm",
        points=3,
        draw=draw_hand_speed,
        answer=joint_speeds,
        mistakes=wrong_speeds,
        units=("rad/s", "rad/s", "m/s", "rad/s", "rad/s", "rad/s"),
        entries=tuple(f"joint {i}" for i in range(1, 7)),
        praise="A sliding joint among turning ones, and a hand that goes and turns as it was told.",
        hints=(
            (
                "The Jacobian of the Stanford arm first, at q_stanford. Joint 3 slides, so its"
                " column is another; stanford.jacobian knows that."
            ),
            (
                "Six equations, six unknown speeds: J times the speeds is the hand's velocity, v"
                " above ω."
            ),
        ),
    ),
    Value(
        id="08.1",
        practice=True,
        title="One column of the Jacobian",
        draw=draw_bend,
        answer=third_column,
        mistakes=wrong_columns,
        units=("m", "m", "m", "", "", ""),
        entries=(
            "v along x0",
            "v along y0",
            "v along z0",
            "ω about x0",
            "ω about y0",
            "ω about z0",
        ),
        praise="What joint 3 alone does to the end: three numbers of v, three of ω.",
        hints=(
            "Joint 3 turns about z of frame {2}, through the origin of frame {2}.",
            (
                "The lever runs from that origin to the end: v is the axis crossed with the lever,"
                " ω the axis."
            ),
        ),
    ),
]
