"""What lesson 08's first sitting draws, what is right, and what the wrong answers are told:
Jacobians, speeds of the hand.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...doctor.programs.wrong.jacobians import geometric_jacobian
from ...robots import load
from ...table import DHTable
from ...transform import from_xyz_rpy
from ..kinds import Known, Mistakes, Said, Value
from ..verdict import RIGHT, Verdict

__all__ = [
    "COLUMN_LINES",
    "PEN",
    "Speeds",
    "draw_bend",
    "draw_frames",
    "draw_hand_speed",
    "explain_column",
    "general",
    "joint_speeds",
    "random_pose",
    "third_column",
    "to_the_flange",
    "wrong_columns",
    "wrong_speeds",
]

SOLVE = "Solve J · speeds = velocity: six equations, six unknowns."
PEN = Said(
    "the lever does not run to the tip of the pen: ω is right, v is not",
    next="Which of the inputs knows of the pen: frames or T_end?",
)


def general(rng: np.random.Generator, low: float, high: float, *shape: int) -> NDArray:
    """Numbers of either sign, none of them small."""
    return rng.uniform(low, high, shape) * rng.choice([-1, 1], shape)


def random_pose(rng: np.random.Generator) -> NDArray:
    return from_xyz_rpy(general(rng, 0.1, 0.6, 3), general(rng, 0.3, 1.2, 3))


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
    frames, T_end, sliding = seen = _seen("article-6r", q)
    for place, column in _of_bent(*seen):
        yield (
            "jacobian-not-renewed",
            Said(place, next="Take frames and end anew, at q_mine."),
            column,
        )
    J = geometric_jacobian(*seen)
    yield "joint-index-off-by-one", "this is column 2", J[:, 1]
    yield "joint-index-off-by-one", "this is column 4", J[:, 3]
    z, o, p = frames[2, :3, 2], frames[2, :3, 3], T_end[:3, 3]
    v, nothing = np.cross(z, p - o), np.zeros(3)
    for mistake, said, upper, lower in (
        ("cross-product-reversed", "ω is right, and v has the other sign", -v, z),
        ("error-sign", "v is right, and ω has the other sign", v, -z),
        ("joint-reversed", "all six numbers have the other sign", -v, -z),
        ("jacobian-rows-exchanged", "ω stands above v, and v above ω is asked", z, v),
        ("angular-part-missing", "v is right, and ω is left out", v, nothing),
        ("prismatic-column-wrong", "this is a sliding joint's column: v = z, ω = 0", z, nothing),
        ("lever-arm-wrong", _lever("this lever runs from the base's origin"), np.cross(z, p), z),
        ("lever-arm-wrong", _lever("this v is the lever, without the axis"), p - o, z),
        ("lever-arm-wrong", _lever("this lever ends at the joint"), np.cross(z, o), z),
        ("lever-arm-wrong", _lever("this lever is p + o"), np.cross(z, p + o), z),
        ("jacobian-frame", "written in the end's own axes", v @ T_end[:3, :3], z @ T_end[:3, :3]),
    ):
        yield mistake, said, np.concatenate([upper, lower])
    in_degrees = load("article-6r").frames(np.asarray(q)), load("article-6r").forward(q)
    yield (
        "degrees-in-sin-cos",
        "q was left in degrees",
        geometric_jacobian(*in_degrees, sliding)[:, 2],
    )


def _lever(what):
    return Said(
        f"ω is right, v is not: {what}",
        next="Draw the axis of joint 3 and the end point. Which vector swings?",
    )


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
    rows = general(rng, 0.15, 0.6, 5, 4) * [2.3, 1, 1, 2.3]
    letters = ["R"] * 5
    for k in rng.choice(5, rng.integers(1, 3), replace=False):
        letters[k] = "P"
    arm = Arm(
        DHTable.standard(rows, angle="rad", joints=letters),
        base=random_pose(rng),
        tool=random_pose(rng),
    )
    q = general(rng, 0.2, 1.2, 5)
    return arm.frames(q), arm.forward(q), arm.table.prismatic.copy()


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
    yield from _by_other_jacobians(frames, T_end, sliding, twist)


def _by_other_jacobians(frames, T_end, sliding, twist):
    """Speeds that fit a Jacobian with one slip in it."""
    J, p, R = geometric_jacobian(frames, T_end, sliding), T_end[:3, 3], T_end[:3, :3]
    moved = np.concatenate([frames[1:], T_end[None]])
    z = frames[:-1, :3, 2]
    to_base = np.where(sliding, z.T, np.cross(z, p).T)
    turns_too = J.copy()
    turns_too[3:, sliding] = z[sliding].T
    for mistake, said, wrong in (
        (
            "cross-product-reversed",
            "these speeds fit a Jacobian whose cross products are the wrong way round",
            np.vstack([np.where(sliding, J[:3], -J[:3]), J[3:]]),
        ),
        (
            "jacobian-axis-off-by-one",
            "these speeds fit a Jacobian that takes the axis of joint i from frame i",
            geometric_jacobian(moved, T_end, sliding),
        ),
        (
            "lever-arm-wrong",
            "these speeds fit a Jacobian whose levers all begin at the base's origin",
            np.vstack([to_base, J[3:]]),
        ),
        (
            "prismatic-column-wrong",
            "these speeds fit a Jacobian in which joint 3 slides and turns",
            turns_too,
        ),
        (
            "jacobian-frame",
            "these speeds fit a Jacobian that is written in the end's own axes",
            np.vstack([R.T @ J[:3], R.T @ J[3:]]),
        ),
    ):
        if np.linalg.cond(wrong) < 1e6:
            yield mistake, said, np.linalg.solve(wrong, twist)


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


def to_the_flange(frames: NDArray, T_end: NDArray, sliding: NDArray) -> NDArray:
    """The broken Jacobian of 08.11: right as long as the arm carries no tool."""
    return geometric_jacobian(frames, frames[-1], sliding)


COLUMN_LINES = (
    ["frames", "end", "frame-before", "lever", "stack"],
    ["frames", "frame-before", "end", "lever", "stack"],
    ["end", "frames", "frame-before", "lever", "stack"],
)
WRONG_COLUMN_LINES: dict[str, Known] = {  # wrong in themselves: (mistake, what is said of it)
    "own-frame": (
        "jacobian-axis-off-by-one",
        Said(
            "frames[i] stands behind joint i",
            why="In the standard convention joint i turns about the z axis of the frame before.",
            next="Joint 1 took axis and origin from frames[0].",
        ),
    ),
    "lever-reversed": (
        "cross-product-reversed",
        Said(
            "o - p points from the end to the axis",
            why="v = ω × r, and r runs from the axis to what moves.",
        ),
    ),
    "base-origin": (
        "lever-arm-wrong",
        Said(
            "this lever begins at the base's origin",
            why="The end swings about the joint's own axis, so the lever begins there, at o.",
        ),
    ),
}


def explain_column(lines: list[str]) -> Known | None:
    for line, said in WRONG_COLUMN_LINES.items():
        if line in lines:
            return said
    if sorted(lines) != sorted(COLUMN_LINES[0]):
        return None
    if lines.index("frame-before") < lines.index("frames"):
        return "order-taken-for-free", Said(
            "axis and origin come before frames", why="They are taken out of frames."
        )
    if lines[-1] == "stack":
        return "order-taken-for-free", Said(
            "v comes too early", why="The cross product needs z, o and p."
        )
    return "order-taken-for-free", Said(
        "the column is stacked too early", why="It holds v, which has not been made yet."
    )
