"""Lesson 08, second sitting, back from the pose to the joints: damped least squares, limits, the
eight branches.
"""

from ...doctor.programs.wrong.branches import branches, in_order
from ...doctor.programs.wrong.jacobians import pose_error
from ...doctor.programs.wrong.solvers import inverse_kinematics, wrapped
from ..kinds import Choice, Function, Option, Order, Prediction, Said
from .answers08 import CALLS
from .answers08b import (
    EARLY,
    STEPS,
    draw_reachable,
    draw_task,
    draw_two_poses,
    explain_steps,
    in_other_axes,
    in_the_tools_axes,
)
from .programs08b import MISREAD, OTHER_STEPS, Program, branched_at_once, solved_at_once
from .reaches08b import Reaches, a_way_to, draw_ur5e, several_ways, wrong_ways

__all__ = ["EXERCISES"]

EXERCISES = [
    Function(
        id="08.4",
        title="The smallest fix: a pose error",
        draw=draw_two_poses,
        together=True,
        calls=CALLS,
        answer=pose_error,
        names=("T", "T_goal"),
        family="pose_error",
        shape=(6,),
        handed_out=in_the_tools_axes,
        sparing=True,
        words={
            **in_other_axes(),
            (
                "orientation-error-frame",
                "the orientation is R_goalᵀ R, the way back in the goal's axes",
            ): Said(
                "the turn leads back from the goal, and is written in the goal's axes",
                next="Which product carries R to R_goal from the left?",
                why="R_goalᵀ R is the turn from the goal to here, as the goal sees it.",
            ),
        },
        praise="Position and turn, both as the base sees them.",
        hints=(
            "As it is handed out, the position part is right. Where is the turn seen from: the base"
            " or the tool?",
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
            "jacobian": "`J = jacobian(frames)`",
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
        together=True,
        calls=CALLS - len(EARLY),
        special=EARLY,
        answer=inverse_kinematics,
        at_once=solved_at_once,
        names=("rows", "T_goal", "q", "damping", "steps"),
        family="inverse_kinematics",
        shape=(6,),
        read=wrapped,
        angles=True,
        tolerance=1e-7,
        more=OTHER_STEPS,
        if_special="Exactly `steps` steps are asked: does the loop end before they are done, or"
        " is q kept within bounds?",
        words={
            **in_other_axes("the pose error: "),
            "jacobian-not-renewed": Said(
                "what belongs to q is not made anew in every step",
                next="After q = q + dq, the frames, the Jacobian and the error are others.",
            ),
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
    Prediction(
        id="08.P3",
        title="Two starts, one cup",
        question=("The same loop, the same cup, two starts: q = 0 and a bent arm. What comes out?"),
        options={
            "stuck": "from q = 0 nothing: there the Jacobian has no inverse",
            "astray": "from q = 0 another pose than the cup's",
            "both": "from both a q that reaches the cup",
        },
        correct="both",
        outcome=(
            "both reach the cup: damping carries the loop out of the singular start. Here they even"
            " end at the same q, which need not be, as the next section shows."
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
    Prediction(
        id="08.P4",
        title="How many answers",
        question="How many q reach the cup, if whole turns of a joint are not counted?",
        options={"one": "1", "two": "2", "eight": "8", "endless": "infinitely many"},
        correct="eight",
        outcome=(
            "eight: two shoulders, two elbows, two wrists, and each goes with each of the others."
        ),
    ),
    Reaches(
        id="08.13",
        title="An arm you have not solved",
        points=3,
        draw=draw_ur5e,
        answer=a_way_to,
        mistakes=wrong_ways,
        misshapen=several_ways,
        entries=tuple(f"joint {i}" for i in range(1, 7)),
        praise="It reaches the pose, and no joint turns far.",
        hints=(
            "Your loop asks for nothing but rows and a start: give it ur5e.table.rows. Where does"
            " the arm stand?",
            "Not there yet? Make more steps, and put the q that comes out into ur5e.forward.",
        ),
    ),
    Choice(
        id="08.12",
        practice=True,
        title="A jump on the way",
        question=(
            "A solver is asked for one q every millimetre of a straight line. From one to the next"
            " joints 4 and 6 jump by 180° and q5 changes its sign, as from `cup_q` to `other`; the"
            " condition number is 11 before and after. What happened?"
        ),
        correct="branch",
        hints=(
            "Is J near its loss of rank here? What would joint speeds do if it were?",
            "Put cup_q and other into arm.forward. How far apart are the two poses, and the two q?",
        ),
        options={
            "singular": Option(
                "the arm passed a singularity",
                "Then the condition number would have grown without end on the way; it is 11.",
                "singularity-taken-for-failure",
            ),
            "branch": Option(
                "the solver changed to another branch, which reaches the same pose",
                "The other wrist. On a path, take of all answers the one nearest to the last q.",
            ),
            "limit": Option(
                "a limit cut the values off",
                "Cut values would no longer reach the line, and two of the jumps are exactly 180°.",
                "clipped-at-limit",
            ),
            "damping": Option(
                "the damping was too small",
                "Damping makes steps small where J is nearly singular; here it is not.",
                "damping-taken-for-free",
            ),
        },
    ),
    Program(
        id="08.8",
        practice=True,
        title="All eight branches",
        points=3,
        draw=draw_reachable,
        together=True,
        calls=CALLS,
        answer=branches,
        at_once=branched_at_once,
        names=("T",),
        family="branches",
        shape=(8, 6),
        read=in_order,
        angles=True,
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
                "Which two entries of R_36, which `for_the_wrist` gives, hold sine and cosine of θ4"
                " and nothing of θ6? And which two those of θ6?"
            ),
            "For the second wrist three angles change: one its sign, the other two by half a turn.",
        ),
    ),
]
