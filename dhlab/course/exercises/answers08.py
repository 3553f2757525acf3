"""What lesson 08's first sitting draws, what is right, and what the wrong answers are told:
Jacobians, speeds of the hand.
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ... import kinematics
from ...doctor.programs.wrong.jacobians import geometric_jacobian
from ...robots import load
from ...transform import from_xyz_rpy
from ..kinds import Known, Mistakes, Said

__all__ = [
    "CALLS",
    "COLUMN_LINES",
    "NOT_TO_THE_PEN",
    "OF_THE_AXIS",
    "PEN",
    "draw_bend",
    "draw_frames",
    "explain_column",
    "general",
    "in_every_octant",
    "random_poses",
    "seen_at",
    "third_column",
    "to_the_flange",
    "wrong_columns",
]

# of a program: fewer than elsewhere, since each takes long; what a program could be right in only a
# part of (which joints slide, the signs of what it is given) is gone through, not left to chance
CALLS = 16
# which of five joints slide: each alone, and two together in every way
ALONE = np.eye(5, dtype=bool)
TWO = np.array([ALONE[i] | ALONE[j] for i in range(5) for j in range(i)])
PEN = Said(
    "the lever does not run to the tip of the pen",
    place="v, while ω is right",
    next="Which of the inputs knows of the pen: frames or T_end?",
)
OF_THE_AXIS = {  # where the catalogue's title is not the learner's slip, or no sentence
    ("jacobian-frame", "the axis left in its own frame: always 0 0 1"): Said(
        "the axis z is 0 0 1 for every joint, as each frame sees its own; p and o are right",
        next="Take z out of the joint's frame: its third column, written in the base.",
    )
}
NOT_TO_THE_PEN = (  # of the levers that the doctor knows, by its places
    "o alone, the end does not enter",
    "o × z: the velocity of a point at the base's origin",
    "to the next origin, not to the end",
)


def general(rng: np.random.Generator, low: float, high: float, *shape: int) -> NDArray:
    """Numbers of either sign, none of them small."""
    return rng.uniform(low, high, shape) * (2 * rng.integers(0, 2, shape) - 1)


def in_every_octant(rng: np.random.Generator, low: float, high: float, count: int) -> NDArray:
    """Triples (count, 3) of such numbers, whose signs go through all eight octants in turn."""
    octant = rng.permutation(count)[:, None] % 8
    return rng.uniform(low, high, (count, 3)) * np.where(octant >> np.arange(3) & 1, 1, -1)


def random_poses(rng: np.random.Generator, count: int) -> NDArray:
    return from_xyz_rpy(general(rng, 0.1, 0.6, count, 3), general(rng, 0.3, 1.2, count, 3))


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


def seen_at(name: str, q: ArrayLike) -> tuple[NDArray, NDArray, NDArray]:
    """Frames, end and kinds of joints of a named arm at q in degrees, metres where a joint
    slides.
    """
    arm = load(name)
    q = np.where(arm.table.prismatic, q, np.deg2rad(q))
    return arm.frames(q), arm.forward(q), arm.table.prismatic


def third_column(q: list[float]) -> NDArray:
    return geometric_jacobian(*seen_at("article-6r", q))[:, 2]


def wrong_columns(q: list[float]) -> Mistakes:
    frames, T_end, sliding = seen = seen_at("article-6r", q)
    for place, column in _of_bent(*seen):
        yield (
            "jacobian-not-renewed",
            Said(place, next="Take frames and end anew, at q_mine."),
            column,
        )
    J = geometric_jacobian(*seen)
    yield "joint-index-off-by-one", "this is column 2", J[:, 1]
    yield "joint-index-off-by-one", "this is column 4", J[:, 3]
    yield (
        "columns-misread",
        Said("this is row 3 of J", next="J[row, column]: which of the two says which joint?"),
        J[2],
    )
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
    before, T_before, _ = seen_at("article-6r", [0, 40, -60, 50, 40, 0])
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


def draw_frames(rng: np.random.Generator, count: int) -> list[tuple]:
    """Frames, end pose and kinds of joints of random arms with base and tool: five joints, one or
    two of them sliding: each alone, then two in one way after the other.
    """
    rows = general(rng, 0.15, 0.6, count, 5, 4) * [2.3, 1, 1, 2.3]
    sliding = np.resize(np.vstack([ALONE, rng.permutation(TWO)]), (count, 5))
    base, tool = random_poses(rng, count), random_poses(rng, count)
    q = general(rng, 0.2, 1.2, count, 5)
    theta, d, a, alpha = np.moveaxis(rows, -1, 0)
    A = kinematics.link_matrices(
        "standard", np.where(sliding, theta, theta + q), np.where(sliding, d + q, d), a, alpha
    )
    seen = kinematics.frames(base, A)
    return list(zip(seen, seen[:, -1] @ tool, sliding))


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
            next="Joint 1 takes axis and origin from frames[0].",
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
