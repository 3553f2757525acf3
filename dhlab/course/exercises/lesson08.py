"""Lesson 08, beyond forward kinematics: the Jacobian, singularities, damped least squares, limits,
the eight branches.
"""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from ...arm import Arm
from ...doctor.programs.wrong.branches import branches, in_order
from ...doctor.programs.wrong.jacobians import WRONG_JACOBIANS, geometric_jacobian, pose_error
from ...doctor.programs.wrong.products import product
from ...doctor.programs.wrong.solvers import inverse_kinematics, wrapped
from ...robots import load
from ...table import DHTable
from ...transform import from_xyz_rpy
from ..kinds import Choice, Function, Option, Order, Prediction, Said, Value
from ..verdict import RIGHT
from .programs08 import MISREAD, UNDAMPED, Program

__all__ = ["EXERCISES"]

SOLVE = "Solve J · speeds = velocity: six equations, six unknowns."
FRAME = Said(
    "the error is not in the base's axes: right where the tool's arrows point along the base's,"
    " astray elsewhere",
    next="Which product carries R to R_goal from the left?",
    why=(
        "Rᵀ R_goal is the turn as the tool sees it; R_goal Rᵀ is the same turn as the base sees it."
    ),
)
DEG = 180 / np.pi
SPEEDS = np.array(
    [DEG, DEG, 1, DEG, DEG, DEG]
)  # of the Stanford arm's joints: degrees where they turn, metres where joint 3 slides


def _general(rng, low, high, *shape):
    return rng.uniform(low, high, shape) * rng.choice([-1, 1], shape)


def _pose(rng):
    return from_xyz_rpy(_general(rng, 0.1, 0.6, 3), _general(rng, 0.3, 1.2, 3))


def _draw_bend(rng):
    return {
        "q": [
            float(value)
            for value in (
                rng.choice([10, 20, 30]),
                rng.choice([30, 40, 50]),
                rng.choice([-70, -60, -40]),
                rng.choice([20, 30, 50]),
                rng.choice([35, 55]),
                0,
            )
        ]
    }


def _seen(name, q):
    """Frames, end and kinds of joints of a named arm at q in degrees, metres where a joint
    slides.
    """
    arm = load(name)
    q = np.where(arm.table.prismatic, q, np.deg2rad(q))
    return arm.frames(q), arm.forward(q), arm.table.prismatic


def _third_column(q):
    return geometric_jacobian(*_seen("article-6r", q))[:, 2]


def _wrong_columns(q):
    seen = _seen("article-6r", q)
    for mistake, place, version in WRONG_JACOBIANS:
        yield mistake, place, version(*seen)[:, 2]
    for place, column in _of_bent(*seen):
        yield (
            "jacobian-not-renewed",
            Said(place, next="Take frames and end anew, at q_mine."),
            column,
        )
    yield "joint-index-off-by-one", "this is column 2", geometric_jacobian(*seen)[:, 1]
    yield "joint-index-off-by-one", "this is column 4", geometric_jacobian(*seen)[:, 3]


def _of_bent(frames, T_end, sliding):
    """Column 3 with something in it that an earlier cell left in memory: frames, p at ``bent``."""
    before, T_before, _ = _seen("article-6r", [0, 40, -60, 50, 40, 0])
    yield (
        "this is the column at bent, whose frames and p are still in memory",
        geometric_jacobian(before, T_before, sliding)[:, 2],
    )
    yield (
        "the frames are those of bent, still in memory",
        geometric_jacobian(before, T_end, sliding)[:, 2],
    )
    yield (
        "p is the end at bent, still in memory",
        geometric_jacobian(frames, T_before, sliding)[:, 2],
    )


def _draw_frames(rng):
    """Frames, end pose and kinds of joints of a random arm with base and tool: five joints, one or
    two of them sliding.
    """
    rows = _general(rng, 0.15, 0.6, 5, 4) * [2.3, 1, 1, 2.3]
    letters = ["R"] * 5
    for k in rng.choice(5, rng.integers(1, 3), replace=False):
        letters[k] = "P"
    arm = Arm(DHTable.standard(rows, angle="rad", joints=letters), base=_pose(rng), tool=_pose(rng))
    q = _general(rng, 0.2, 1.2, 5)
    return arm.frames(q), arm.forward(q), arm.table.prismatic.copy()


def _draw_two_poses(rng):
    """A pose and a goal, turned against it by less than half a turn."""
    T, turned = _pose(rng), np.eye(4)
    turned[:3, :3] = Rotation.from_rotvec(_general(rng, 0.2, 1.2, 3)).as_matrix()
    T_goal = turned @ T
    T_goal[:3, 3] = _general(rng, 0.1, 0.6, 3)
    return T, T_goal


def _in_the_tools_axes(T, T_goal):
    """The broken pose error of 08.4."""
    return np.concatenate(
        [T_goal[:3, 3] - T[:3, 3], Rotation.from_matrix(T[:3, :3].T @ T_goal[:3, :3]).as_rotvec()]
    )


def _draw_task(rng):
    """A random arm of six turning joints, a goal near q, a damping and a few steps."""
    rows, q = _general(rng, 0.15, 0.5, 6, 4) * [2.3, 1, 1, 2.3], _general(rng, 0.2, 1.3, 6)
    goal = product(rows, q + _general(rng, 0.1, 0.3, 6))
    return rows, goal, q, float(rng.uniform(0.1, 0.3)), int(rng.integers(3, 6))


def _draw_reachable(rng):
    """A pose of the course's arm whose wrist lies well inside the reach, so that wrong centres are
    within reach too.
    """
    arm = load("article-6r")
    while True:
        T = arm.forward(_general(rng, 0.3, 2.4, 6))
        x, y, z = T[:3, 3]
        if np.hypot(x, y) > 0.32 and 0.3 < np.hypot(np.hypot(x, y), z - 0.1) < 0.5:
            return (T,)


def _draw_hand_speed(rng):
    q = [
        rng.choice(values)
        for values in (
            [-30, 20, 40],
            [50, 65, 80],
            [0.4, 0.5, 0.6],
            [-50, 25, 60],
            [-70, -45, 40, 60],
            [15, 70],
        )
    ]
    return {
        "q": [float(value) for value in q],
        "v": [float(value) for value in rng.choice([-0.3, -0.2, -0.1, 0.1, 0.2, 0.3], 3)],
        "omega": [float(value) for value in rng.choice([-0.8, -0.6, -0.4, 0.4, 0.6, 0.8], 3)],
    }


def _joint_speeds(q, v, omega):
    return np.linalg.solve(geometric_jacobian(*_seen("stanford", q)), [*v, *omega])


def _wrong_speeds(q, v, omega):
    frames, T_end, sliding = seen = _seen("stanford", q)
    right, J, twist = _joint_speeds(q, v, omega), geometric_jacobian(*seen), np.array([*v, *omega])
    yield "degrees-for-radians", "the turning joints are in degrees per second", right * SPEEDS
    yield (
        "jacobian-rows-exchanged",
        "v was put where ω belongs",
        np.linalg.solve(J, np.roll(twist, 3)),
    )
    yield (
        "jacobian-transpose-only",
        Said(
            "this is Jᵀ times the hand's velocity, and the transpose is not the inverse", next=SOLVE
        ),
        J.T @ twist,
    )
    yield (
        "jacobian-transpose-only",
        Said(
            "this is J times the hand's velocity",
            why="Joint speeds go into J; the hand's velocity comes out.",
            next=SOLVE,
        ),
        J @ twist,
    )
    yield (
        "error-sign",
        Said(
            "all six speeds have the other sign",
            next="Multiply J by your speeds: which way does the hand go then?",
        ),
        -right,
    )
    yield (
        "degrees-in-sin-cos",
        "q was left in degrees",
        np.linalg.solve(geometric_jacobian(*_at_radians(q)), twist),
    )
    yield (
        "angle-unit",
        Said("joint 3's value went through deg2rad too", why="It slides: its value is in metres."),
        np.linalg.solve(geometric_jacobian(*_at_radians(np.deg2rad(q))), twist),
    )
    for damping in (0.01, 0.05, 0.1, 0.5):
        yield (
            "damping-taken-for-free",
            Said(
                "this is a damped step: the hand lags behind what was asked",
                next=f"Here the arm is far from singular. {SOLVE}",
            ),
            _damped(J, twist, damping),
        )
    for wrong in (np.linalg.pinv(J[:3]) @ v, np.linalg.solve(J, [*v, 0, 0, 0])):
        yield (
            "angular-part-missing",
            Said("the hand goes at v, but does not turn with ω", next=SOLVE),
            wrong,
        )
    yield (
        "angular-part-missing",
        Said("the hand turns with ω, but does not go at v", next=SOLVE),
        np.linalg.solve(J, [0, 0, 0, *omega]),
    )
    yield (
        "prismatic-column-wrong",
        "the slide is treated as a turning joint",
        np.linalg.pinv(geometric_jacobian(frames, T_end, [False] * 6)) @ twist,
    )
    for other in (
        np.eye(4),
        *frames[1:-1],
        load("article-6r").forward(np.deg2rad([30, 60, -80, -30, 40, 0])),
    ):
        yield (
            "lever-arm-wrong",
            Said(
                "these speeds fit another end point",
                next="The hand is where stanford.forward puts it at your q.",
            ),
            np.linalg.solve(geometric_jacobian(frames, other, sliding), twist),
        )
    for mistake, place, version in WRONG_JACOBIANS:
        wrong = version(frames, T_end, sliding)
        if np.linalg.cond(wrong) < 1e6:
            yield mistake, place, np.linalg.solve(wrong, twist)


def _damped(J, twist, damping):
    return J.T @ np.linalg.solve(J @ J.T + damping**2 * np.eye(6), twist)


@dataclass(frozen=True, kw_only=True)
class Speeds(Value):
    """Joint speeds of the Stanford arm; it knows a slide that was treated as a turning joint, too:
    then J has no inverse, and any huge numbers come out.
    """

    def compare(self, answer, variant):
        verdict = super().compare(answer, variant)
        try:
            speeds = np.asarray(answer, dtype=float)
        except (TypeError, ValueError):
            return verdict
        if (
            verdict.status == RIGHT
            or verdict.mistake
            or speeds.shape != (6,)
            or not np.isfinite(speeds).all()
        ):
            return verdict
        frames, T_end, _ = _seen("stanford", self.given(variant)["q"])
        lost = np.linalg.svd(geometric_jacobian(frames, T_end, [False] * 6))[2][-1]
        if np.linalg.norm(speeds) < 1e6 or abs(lost @ speeds) < 0.9999 * np.linalg.norm(speeds):
            return verdict
        return self.wrong(
            "prismatic-column-wrong",
            place=Said(
                "these speeds are beyond all measure: the slide is treated as a turning joint",
                next="Which entry of sliding is True here?",
                why=(
                    "Axes 3 and 4 lie on one line: if both turn, J has two equal columns and no"
                    " inverse."
                ),
            ),
        )


def _at_radians(q):
    arm = load("stanford")
    return arm.frames(q), arm.forward(q), arm.table.prismatic


def _explain_steps(letters):
    for letter, mistake, place in (
        (
            "e",
            "step-not-accumulated",
            Said("e forgets the q before", why="Every step begins where the last one ended."),
        ),
        ("a", "damping-missing", "a"),
        (
            "g",
            "error-sign",
            Said("g leads from the goal to here", why="The step must go from here to the goal."),
        ),
    ):
        if letter in letters:
            return mistake, place
    if sorted(letters) != list("bcdfh"):
        return None
    if letters[0] != "b":
        return "jacobian-not-renewed", Said(
            "b comes first", why="Everything else needs the frames of this q."
        )
    if letters[-1] != "c":
        return "step-not-accumulated", Said(
            "c comes last", why="There is no Δq to add before h has made it."
        )
    return "jacobian-not-renewed", Said("h comes too early", why="It needs e and J.")


EXERCISES = [
    Value(
        id="08.1",
        title="One column of the Jacobian",
        draw=_draw_bend,
        answer=_third_column,
        mistakes=_wrong_columns,
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
        draw=_draw_frames,
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
        options={"a": "6: there are six joints", "b": "5", "c": "4", "d": "3"},
        correct="c",
        outcome=(
            "the rank is 4. The stretched arm cannot move further out or in, and axes 4 and 6 lie"
            " on one line."
        ),
    ),
    Choice(
        id="08.3",
        title="Why a direction is lost at θ5 = 0",
        correct="b",
        hints=(
            (
                "Print columns 4 and 6 of the Jacobian, or the axes z3 and z5 and the origins they"
                " pass through."
            ),
            "What can two joints do together that turn about one and the same line?",
        ),
        options={
            "a": Option(
                "the arm is stretched as far as it goes",
                "At this pose the elbow is bent by 60°, and the end is well inside the reach.",
                "singularity-taken-for-reach-limit",
            ),
            "b": Option(
                "axes 4 and 6 lie on one line, so two joints turn the end in one and the same way",
                "Two columns of J are equal, and five directions are left for six joints.",
            ),
            "c": Option(
                "sin θ5 = 0, so the link matrix A5 has no inverse",
                "Every link matrix is a pose and has its inverse. Forward kinematics never fails.",
                "singularity-taken-for-failure",
            ),
            "d": Option(
                "joint 5 has reached its limit",
                "No limit enters the Jacobian, and 0° is the middle of the range.",
                "limits-in-forward",
            ),
        },
    ),
    Prediction(
        id="08.P2",
        title="One degree from the singularity",
        options={
            "a": "at about 10° a second",
            "b": "at about 60° a second",
            "c": "at more than 500° a second",
        },
        correct="c",
        outcome=(
            "joint 4 turns at 572° a second and joint 6 just as fast the other way: the speed grows"
            " as 1/sin θ5."
        ),
    ),
    Function(
        id="08.4",
        title="The smallest fix: a pose error",
        draw=_draw_two_poses,
        answer=pose_error,
        names=("T", "T_goal"),
        family="pose_error",
        shape=(6,),
        handed_out=_in_the_tools_axes,
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
        length=5,
        items={
            "a": "dq = J.T @ np.linalg.solve(J @ J.T, e)",
            "b": "frames = chain(rows, q); T = frames[-1]",
            "c": "q = q + dq",
            "d": "e = pose_error(T, T_goal)",
            "e": "q = dq",
            "f": "J = geometric_jacobian(frames, T, sliding)",
            "g": "e = pose_error(T_goal, T)",
            "h": "dq = J.T @ np.linalg.solve(J @ J.T + damping**2 * np.eye(6), e)",
        },
        accepts=lambda letters: letters in (list("bdfhc"), list("bfdhc")),
        explain=_explain_steps,
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
        draw=_draw_task,
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
        correct="c",
        hints=(
            "What did the solver know of the limits?",
            "Change one of six joint values and ask forward kinematics where the end is now.",
        ),
        options={
            "a": Option(
                "the solver is wrong: with correct angles no limit is broken",
                "Its pose is the cup's to a thousandth of a millimetre. Nobody told it of limits.",
                "limits-in-forward",
            ),
            "b": Option(
                "set q2 to 0°, the nearest value allowed, and keep the other five",
                "Then the end is 13 cm away from the cup: six values belong together.",
                "clipped-at-limit",
            ),
            "c": Option(
                "the pose is right, the arm may not go there: take another of its answers, from"
                " another start",
                "Limits choose among right answers; they do not make them.",
            ),
            "d": Option(
                "make the damping larger, so that the joints stay small",
                "Damping makes steps small, not values: the loop ends in the same place, later.",
                "damping-taken-for-free",
            ),
        },
    ),
    Program(
        id="08.8",
        title="Stretch: all eight branches",
        points=3,
        draw=_draw_reachable,
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
        title="Joint speeds of an arm you have not seen",
        points=3,
        draw=_draw_hand_speed,
        answer=_joint_speeds,
        mistakes=_wrong_speeds,
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
