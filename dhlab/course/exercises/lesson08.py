"""Lesson 08, beyond forward kinematics: the Jacobian, singularities, damped least squares, limits,
the eight branches.
"""

from ...doctor.programs.wrong.branches import branches, in_order
from ...doctor.programs.wrong.jacobians import geometric_jacobian, pose_error
from ...doctor.programs.wrong.solvers import inverse_kinematics, wrapped
from ..kinds import Choice, Function, Option, Order, Prediction, Said, Value
from .answers08 import (
    FRAME,
    STEPS,
    Speeds,
    draw_bend,
    draw_frames,
    draw_hand_speed,
    draw_reachable,
    draw_task,
    draw_two_poses,
    explain_steps,
    in_the_tools_axes,
    joint_speeds,
    third_column,
    wrong_columns,
    wrong_speeds,
)
from .programs08 import MISREAD, UNDAMPED, Program

__all__ = ["EXERCISES"]

EXERCISES = [
    Value(
        id="08.1",
        title="One column of the Jacobian",
        draw=draw_bend,
        answer=third_column,
        mistakes=wrong_columns,
        words={
            "lever-arm-wrong": Said(
                "the lever does not run from the joint's axis to the end: ω is right, v is not",
                next="Draw the axis of joint 3 and the end point. Which vector swings?",
            ),
            "jacobian-axis-off-by-one": Said(
                "the axis of the wrong frame",
                why=(
                    "In the standard convention joint i turns about z_{i-1}: its axis belongs to"
                    " the frame before its link."
                ),
                next="Joint 1 took axis and origin from frames[0], joint 2 from frames[1].",
            ),
        },
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
    Function(
        id="08.2",
        title="The geometric Jacobian",
        points=3,
        draw=draw_frames,
        answer=geometric_jacobian,
        names=("frames", "T_end", "sliding"),
        family="jacobian",
        shape=(6, 5),
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
    Prediction(
        id="08.P1",
        title="How many directions at q = 0",
        question="What is the rank of J at q = 0?",
        options={"six": "6: there are six joints", "five": "5", "four": "4", "three": "3"},
        correct="four",
        outcome=(
            "the rank is 4. The stretched arm cannot move further out or in, and axes 4 and 6 lie"
            " on one line."
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
            "whirl": "at more than 500° a second",
        },
        correct="whirl",
        outcome=(
            "joint 4 turns at 572° a second and joint 6 just as fast the other way: the speed grows"
            " as 1/sin θ5."
        ),
    ),
    Function(
        id="08.4",
        title="The smallest fix: a pose error",
        draw=draw_two_poses,
        answer=pose_error,
        names=("T", "T_goal"),
        family="pose_error",
        shape=(6,),
        handed_out=in_the_tools_axes,
        words={"orientation-error-frame": FRAME},
        praise="Position and turn, both as the base sees them.",
        hints=(
            "The position part is right. Where is the turn seen from: the base or the tool?",
            (
                "You look for the turn that carries R to R_goal when it is multiplied on the left."
                " Solve that for it."
            ),
        ),
    ),
    Order(
        id="08.5",
        title="One turn of the loop",
        question=(
            "Put one turn of the loop in order: five of the eight lines. Three are wrong in"
            " themselves."
        ),
        length=5,
        items={
            "undamped": "`dq = J.T @ np.linalg.solve(J @ J.T, e)`",
            "frames": "`frames = chain(rows, q); T = frames[-1]`",
            "add-step": "`q = q + dq`",
            "error": "`e = pose_error(T, T_goal)`",
            "forget-q": "`q = dq`",
            "jacobian": "`J = geometric_jacobian(frames, T, sliding)`",
            "error-reversed": "`e = pose_error(T_goal, T)`",
            "damped": "`dq = J.T @ np.linalg.solve(J @ J.T + damping**2 * np.eye(6), e)`",
        },
        accepts=lambda lines: lines in STEPS,
        explain=explain_steps,
        praise="Look where you are, ask for the way, take one damped step.",
        hints=(
            "Which line needs nothing but q?",
            (
                "Three of the eight lines are wrong in themselves: one forgets where q was, one has"
                " no damping, one looks back from the goal."
            ),
        ),
    ),
    Program(
        id="08.6",
        title="Damped least squares",
        points=4,
        draw=draw_task,
        answer=inverse_kinematics,
        names=("rows", "T_goal", "q", "damping", "steps"),
        family="inverse_kinematics",
        shape=(6,),
        read=wrapped,
        tolerance=1e-7,
        more=UNDAMPED,
        needs={"geometric_jacobian": "08.2"},
        words={
            "orientation-error-frame": FRAME,
            "error-sign": Said(
                "the steps, or a part of them, lead away from the goal",
                next="Take one small step by hand: did the error shrink?",
            ),
        },
        places={
            "the step is subtracted": (
                "the step is subtracted, or the error looks back from the goal"
            )
        },
        unknown=Said(
            "the answers differ from the right ones",
            next="Try it with steps = 1: is that q plus one damped step?",
        ),
        praise="Inverse kinematics for any arm of turning joints, in a dozen lines.",
        hints=(
            (
                "A loop over range(steps), with the five lines of 08.5 in it; q is handed back when"
                " the loop is done, not inside it."
            ),
            (
                "If one step is right and three are not: are frames, error and Jacobian made anew"
                " in every turn? If the shapes do not fit, q is probably still a list."
            ),
        ),
    ),
    Choice(
        id="08.7",
        title="An answer outside the limits",
        question="q2 = −13.6° is outside. What now?",
        correct="another-answer",
        hints=(
            "What did the solver know of the limits?",
            "Change one of six joint values and ask forward kinematics where the end is now.",
        ),
        options={
            "solver-wrong": Option(
                "the solver is wrong: with correct angles no limit is broken",
                "Its pose is the cup's to a thousandth of a millimetre. Nobody told it of limits.",
                "limits-in-forward",
            ),
            "clip": Option(
                "set q2 to 0°, the nearest value allowed, and keep the other five",
                "Then the end is 13 cm away from the cup: six values belong together.",
                "clipped-at-limit",
            ),
            "another-answer": Option(
                "the pose is right, the arm may not go there: take another of its answers, from"
                " another start",
                "Limits choose among right answers; they do not make them.",
            ),
            "more-damping": Option(
                "make the damping larger, so that the joints stay small",
                "Damping makes steps small, not values: the loop ends in the same place, later.",
                "damping-taken-for-free",
            ),
        },
    ),
    Program(
        id="08.8",
        title="All eight branches",
        points=3,
        draw=draw_reachable,
        answer=branches,
        names=("T",),
        family="branches",
        shape=(8, 6),
        read=in_order,
        tolerance=1e-6,
        more=MISREAD,
        places={
            "θ5: the turn in the middle is Ry(−θ5)": (
                "θ5, or both signs of both arctan2: the turn in the middle is Ry(−θ5)"
            )
        },
        words={
            "joint-reversed": Said(
                "an angle of the wrist runs the other way",
                next=(
                    "Compare with the last column and the last row: each entry has a sign of its"
                    " own."
                ),
            )
        },
        unknown=Said(
            "not all of the eight are right",
            next="Put each of yours into arm.forward: which of them reach T?",
        ),
        praise="Two shoulders, two elbows, two wrists, and each of them exact.",
        hints=(
            (
                "R_36 is what is left of the orientation when the first three joints are taken off"
                " it: which of the two is transposed, and on which side?"
            ),
            "For the second wrist three angles change: one its sign, the other two by half a turn.",
        ),
    ),
    Speeds(
        id="08.9",
        title="Joint speeds of a Stanford arm",
        points=3,
        draw=draw_hand_speed,
        answer=joint_speeds,
        mistakes=wrong_speeds,
        entries=tuple(f"joint {i}" for i in range(1, 7)),
        praise="A sliding joint among turning ones, and a hand that goes and turns as it was told.",
        hints=(
            (
                "Frames, end and Jacobian first: joint 3 slides, so its value is in metres and its"
                " column is another."
            ),
            (
                "Six equations, six unknown speeds: J times the speeds is the hand's velocity, v"
                " above ω."
            ),
        ),
    ),
]
