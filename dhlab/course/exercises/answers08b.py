"""What lesson 08's second sitting draws, what is right, and what the wrong answers are told: pose
errors and steps of the loop.
"""

from itertools import product as every

import numpy as np
from numpy.typing import NDArray

from ...doctor.programs.wrong.products import product
from ...kinematics import frames, link_matrices
from ...robots import load
from ...rotations import from_rotation_vectors, rotation_vectors
from ..kinds import Known, Said
from .answers08 import general, in_every_octant, random_poses

__all__ = [
    "EARLY",
    "STEPS",
    "draw_reachable",
    "draw_task",
    "draw_two_poses",
    "explain_steps",
    "in_other_axes",
    "in_the_tools_axes",
]

FRAME = Said(
    "the error is not in the base's axes: right where the tool's arrows point along the base's,"
    " astray elsewhere",
    next="Which product carries R to R_goal from the left?",
    why=(
        "Rᵀ R_goal is the turn as the tool sees it; R_goal Rᵀ is the same turn as the base sees it."
    ),
)


_OF_POSITION = {
    f"the position is in the {whose} axes": Said(
        f"the turn is right; the position is written in the {whose} axes",
        next="Which of the two differences, p_goal − p or its product with a transpose, is in the"
        " base's axes?",
        why="p and p_goal are written in the base, and so is their difference.",
    )
    for whose in ("tool's", "goal's")
}


def in_other_axes(of: str = "") -> dict:
    """What is said of pose errors in other axes, by mistake and place; ``of`` stands before the
    place where the error is a part of the program.
    """
    mistake = "orientation-error-frame"
    return {mistake: FRAME, **{(mistake, of + place): x for place, x in _OF_POSITION.items()}}


def draw_two_poses(rng: np.random.Generator, count: int) -> list[tuple]:
    """Poses and goals, turned against them by less than half a turn, about axes in every octant."""
    T, T_goal = random_poses(rng, count), np.tile(np.eye(4), (count, 1, 1))
    T_goal[:, :3, :3] = from_rotation_vectors(in_every_octant(rng, 0.2, 1.2, count)) @ T[:, :3, :3]
    T_goal[:, :3, 3] = general(rng, 0.1, 0.6, count, 3)
    return list(zip(T, T_goal))


def in_the_tools_axes(T: NDArray, T_goal: NDArray) -> NDArray:
    """The broken pose error of 08.4."""
    return np.concatenate(
        [T_goal[:3, 3] - T[:3, 3], rotation_vectors(T[:3, :3].T @ T_goal[:3, :3])]
    )


def draw_task(rng: np.random.Generator, count: int) -> list[tuple]:
    """Random arms of six turning joints, goals near q, dampings and a few steps."""
    rows = general(rng, 0.15, 0.5, count, 6, 4) * [2.3, 1, 1, 2.3]
    q, way = general(rng, 0.2, 1.3, count, 6), general(rng, 0.1, 0.3, count, 6)
    theta, *rest = np.moveaxis(rows, -1, 0)
    goals = frames(np.eye(4), link_matrices("standard", theta + q + way, *rest))[:, -1]
    dampings, steps = rng.uniform(0.1, 0.3, count), 2 + rng.permutation(count) % 2
    return list(zip(rows, goals, q, dampings.tolist(), steps.tolist()))


def _near_and_far():
    """Tasks that begin near the goal and, strongly damped, come little nearer with each step, and
    one in which a step leads further away and the next ones back: a loop that ends before its steps
    are done is wrong there.
    """
    ((rows, _, q, *_),) = draw_task(np.random.default_rng(8), 1)
    for off, damping in ((3e-4, 1.0), (3e-5, 1.0), (3e-6, 1.0), (1.2, 0.02)):
        yield rows, product(rows, q + off * np.array([1, -1, 1, 1, -1, 1])), q, damping, 4


EARLY = tuple(_near_and_far())


def draw_reachable(rng: np.random.Generator, count: int) -> list[tuple]:
    """Poses of the course's arm whose wrist lies well inside the reach, so that wrong centres are
    within reach too; as many in each octant, seen from the shoulder.
    """
    arm = load("article-6r")
    found: dict[tuple, list] = {octant: [] for octant in every((False, True), repeat=3)}
    while min(map(len, found.values())) < count / 8:
        T = arm.forward(general(rng, 0.3, 2.4, 16 * count, 6))
        x, y, z = T[:, :3, 3].T
        away = np.hypot(np.hypot(x, y), z - 0.1)
        for one in T[(np.hypot(x, y) > 0.32) & (away > 0.3) & (away < 0.5)]:
            found[tuple((one[:3, 3] > [0, 0, 0.1]).tolist())].append((one,))
    return [case for turn in zip(*found.values()) for case in turn][:count]


STEPS = (
    ["frames", "error", "jacobian", "damped", "add-step"],
    ["frames", "jacobian", "error", "damped", "add-step"],
)
WRONG_LINES: dict[str, Known] = {  # wrong in themselves: (mistake, what is said of it)
    "forget-q": (
        "step-not-accumulated",
        Said("q = dq forgets the q before", why="Every step begins where the last one ended."),
    ),
    "undamped": (
        "damping-missing",
        Said(
            "a line without damping**2 is among the five",
            why="Near a singularity the plain inverse asks for enormous joint steps.",
        ),
    ),
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
