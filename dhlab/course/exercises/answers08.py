"""What lesson 08 draws, what is right, and what the wrong answers are told:
Jacobians, pose errors, steps of the loop, speeds of the hand.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ...arm import Arm
from ...doctor.programs.wrong.jacobians import WRONG_JACOBIANS, geometric_jacobian
from ...doctor.programs.wrong.products import product
from ...robots import load
from ...table import DHTable
from ...transform import from_xyz_rpy
from ..kinds import Known, Mistakes, Said, Value
from ..verdict import RIGHT, Verdict

__all__ = [
    "FRAME",
    "STEPS",
    "Speeds",
    "draw_bend",
    "draw_frames",
    "draw_hand_speed",
    "draw_reachable",
    "draw_task",
    "draw_two_poses",
    "explain_steps",
    "in_the_tools_axes",
    "joint_speeds",
    "third_column",
    "wrong_columns",
    "wrong_speeds",
]

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


def draw_bend(rng: np.random.Generator) -> dict[str, Any]:
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


def third_column(q: list[float]) -> NDArray:
    return geometric_jacobian(*_seen("article-6r", q))[:, 2]


def wrong_columns(q: list[float]) -> Mistakes:
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


def draw_frames(rng: np.random.Generator) -> tuple:
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


def draw_two_poses(rng: np.random.Generator) -> tuple:
    """A pose and a goal, turned against it by less than half a turn."""
    T, turned = _pose(rng), np.eye(4)
    turned[:3, :3] = Rotation.from_rotvec(_general(rng, 0.2, 1.2, 3)).as_matrix()
    T_goal = turned @ T
    T_goal[:3, 3] = _general(rng, 0.1, 0.6, 3)
    return T, T_goal


def in_the_tools_axes(T: NDArray, T_goal: NDArray) -> NDArray:
    """The broken pose error of 08.4."""
    return np.concatenate(
        [T_goal[:3, 3] - T[:3, 3], Rotation.from_matrix(T[:3, :3].T @ T_goal[:3, :3]).as_rotvec()]
    )


def draw_task(rng: np.random.Generator) -> tuple:
    """A random arm of six turning joints, a goal near q, a damping and a few steps."""
    rows, q = _general(rng, 0.15, 0.5, 6, 4) * [2.3, 1, 1, 2.3], _general(rng, 0.2, 1.3, 6)
    goal = product(rows, q + _general(rng, 0.1, 0.3, 6))
    return rows, goal, q, float(rng.uniform(0.1, 0.3)), int(rng.integers(3, 6))


def draw_reachable(rng: np.random.Generator) -> tuple:
    """A pose of the course's arm whose wrist lies well inside the reach, so that wrong centres are
    within reach too.
    """
    arm = load("article-6r")
    while True:
        T = arm.forward(_general(rng, 0.3, 2.4, 6))
        x, y, z = T[:3, 3]
        if np.hypot(x, y) > 0.32 and 0.3 < np.hypot(np.hypot(x, y), z - 0.1) < 0.5:
            return (T,)


def draw_hand_speed(rng: np.random.Generator) -> dict[str, Any]:
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


def joint_speeds(q: list[float], v: list[float], omega: list[float]) -> NDArray:
    return np.linalg.solve(geometric_jacobian(*_seen("stanford", q)), [*v, *omega])


def wrong_speeds(q: list[float], v: list[float], omega: list[float]) -> Mistakes:
    frames, T_end, sliding = seen = _seen("stanford", q)
    right, J, twist = joint_speeds(q, v, omega), geometric_jacobian(*seen), np.array([*v, *omega])
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

    def compare(self, answer: object, variant: int) -> Verdict:
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


STEPS = (
    ["frames", "error", "jacobian", "damped", "add-step"],
    ["frames", "jacobian", "error", "damped", "add-step"],
)
WRONG_LINES: dict[str, Known] = {  # wrong in themselves: (mistake, what is said of it)
    "forget-q": (
        "step-not-accumulated",
        Said("q = dq forgets the q before", why="Every step begins where the last one ended."),
    ),
    "undamped": ("damping-missing", "the line without damping**2"),
    "error-reversed": (
        "error-sign",
        Said(
            "pose_error(T_goal, T) leads from the goal to here",
            why="The step must go from here to the goal.",
        ),
    ),
}


def explain_steps(lines: list[str]) -> Known | None:
    for line, said in WRONG_LINES.items():
        if line in lines:
            return said
    if sorted(lines) != sorted(STEPS[0]):
        return None
    if lines[0] != "frames":
        return "jacobian-not-renewed", Said(
            "the frames come first", why="Everything else needs the frames of this q."
        )
    if lines[-1] != "add-step":
        return "step-not-accumulated", Said(
            "q = q + dq comes last", why="There is no dq to add before it has been made."
        )
    return "jacobian-not-renewed", Said("dq comes too early", why="It needs e and J.")
