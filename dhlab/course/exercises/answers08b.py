"""What lesson 08's second sitting draws, what is right, and what the wrong answers are told: pose
errors, steps of the loop, and any q that reaches a pose.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...doctor.programs.wrong.products import product
from ...robots import load
from ...rotations import from_rotation_vectors, rotation_vectors
from ..kinds import Known, Mistakes, Said, Value
from ..verdict import Verdict
from .answers08 import general, random_pose

__all__ = [
    "EARLY",
    "STEPS",
    "Reaches",
    "a_way_to",
    "draw_reachable",
    "draw_task",
    "draw_two_poses",
    "draw_ur5e",
    "explain_steps",
    "in_other_axes",
    "in_the_tools_axes",
    "wrong_ways",
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


def draw_two_poses(rng: np.random.Generator) -> tuple:
    """A pose and a goal, turned against it by less than half a turn."""
    T, turned = random_pose(rng), np.eye(4)
    turned[:3, :3] = from_rotation_vectors(general(rng, 0.2, 1.2, 3))
    T_goal = turned @ T
    T_goal[:3, 3] = general(rng, 0.1, 0.6, 3)
    return T, T_goal


def in_the_tools_axes(T: NDArray, T_goal: NDArray) -> NDArray:
    """The broken pose error of 08.4."""
    return np.concatenate(
        [T_goal[:3, 3] - T[:3, 3], rotation_vectors(T[:3, :3].T @ T_goal[:3, :3])]
    )


def draw_task(rng: np.random.Generator) -> tuple:
    """A random arm of six turning joints, a goal near q, a damping and a few steps."""
    rows, q = general(rng, 0.15, 0.5, 6, 4) * [2.3, 1, 1, 2.3], general(rng, 0.2, 1.3, 6)
    goal = product(rows, q + general(rng, 0.1, 0.3, 6))
    return rows, goal, q, float(rng.uniform(0.1, 0.3)), int(rng.integers(3, 6))


def _near_and_far():
    """Tasks that begin near the goal and, strongly damped, come little nearer with each step, and
    one in which a step leads further away and the next ones back: a loop that ends before its steps
    are done is wrong there.
    """
    rows, _, q, *_ = draw_task(np.random.default_rng(8))
    for off, damping in ((3e-4, 1.0), (3e-5, 1.0), (3e-6, 1.0), (1.2, 0.02)):
        yield rows, product(rows, q + off * np.array([1, -1, 1, 1, -1, 1])), q, damping, 4


EARLY = tuple(_near_and_far())


def draw_reachable(rng: np.random.Generator) -> tuple:
    """A pose of the course's arm whose wrist lies well inside the reach, so that wrong centres are
    within reach too.
    """
    arm = load("article-6r")
    while True:
        T = arm.forward(general(rng, 0.3, 2.4, 6))
        x, y, z = T[:3, 3]
        if np.hypot(x, y) > 0.32 and 0.3 < np.hypot(np.hypot(x, y), z - 0.1) < 0.5:
            return (T,)


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


CUP_Q = np.deg2rad([30, 60, -80, -30, 40, 0])  # of the article's arm


def draw_ur5e(rng: np.random.Generator) -> dict[str, Any]:
    """A pose of the UR5e well away from its singularities."""
    arm = load("ur5e")
    while True:
        q = np.deg2rad(rng.choice([-70, -40, 25, 55, 80], 6))
        if arm.manipulability(q) > 0.03:
            return {"T": np.where(abs(T := arm.forward(q)) < 1e-12, 0, T).tolist()}


def a_way_to(T: list[list[float]]) -> NDArray:
    """One q that reaches the pose; every other one counts as well."""
    return load("ur5e").solve(T).q[0]


def wrong_ways(T: list[list[float]]) -> Mistakes:
    """Some of each kind; :class:`Reaches` finds the others by where they lead."""
    for q in load("ur5e").solve(T).q[:3]:
        yield "degrees-for-radians", "q is in degrees, and radians are asked", np.rad2deg(q)
        yield (
            "only-position-checked",
            "the hand is there, turned otherwise",
            q + np.array([0, 0, 0, 0, 0, 0.5]),
        )


@dataclass(frozen=True, kw_only=True)
class Reaches(Value):
    """Joint values of the UR5e, in radians: right when its end comes to the pose, to a millimetre
    and a tenth of a degree, whichever branch it is.
    """

    def expected(self, variant: int) -> NDArray[np.float64]:
        """As many numbers as are asked; which of them are right, the pose says."""
        return np.zeros(len(load("ur5e")))

    def is_right(self, array: NDArray, expected: NDArray, given: Mapping[str, Any]) -> bool:
        metres, degrees = _off(array, np.array(given["T"]))
        return metres <= 1e-3 and degrees <= 0.1

    def _compared(self, array: NDArray, expected: NDArray, given: Any, answer: Any) -> Verdict:
        if self.is_right(array, expected, given):
            return self.right()
        T_goal = np.array(given["T"])
        metres, degrees = _off(array, T_goal)
        at_radians = _off(np.deg2rad(array), T_goal)
        if at_radians[0] <= 1e-3 and at_radians[1] <= 0.1:
            return self.wrong(
                "degrees-for-radians",
                place=Said("these are degrees, and q is in radians", next="np.deg2rad(q)."),
            )
        if np.allclose(load("article-6r").forward(array), T_goal, atol=1e-3):
            return self.wrong(
                headline="this q brings the article's arm to the pose, and the UR5e is asked",
                next="Your loop goes by the rows that it is given: hand it ur5e.table.rows.",
            )
        cup = load("article-6r").forward(CUP_Q)
        if np.allclose(load("ur5e").forward(array), cup, atol=1e-3):
            return self.wrong(
                headline="this q brings the UR5e to the cup, and another pose is asked",
                next="Hand T_task to your loop.",
            )
        words = f"the hand is {_short(1000 * metres)} mm and {_short(degrees)}° away from the pose"
        if metres <= 1e-3:
            return self.wrong(
                "only-position-checked",
                place=Said(words, next="The position is right. What of the orientation?"),
            )
        if degrees <= 0.1:
            return self.wrong(
                headline=words, next="The orientation is right. What of the position?"
            )
        return self.wrong(
            headline=words,
            next="Did your loop get ur5e.table.rows and T_task? Make more steps, or start"
            " elsewhere.",
        )


def _off(q, T_goal):
    """(metres, degrees) from the end of the UR5e at q to a pose."""
    T = load("ur5e").forward(q)
    turn = np.linalg.norm(rotation_vectors(T_goal[:3, :3] @ T[:3, :3].T))
    return float(np.linalg.norm(T[:3, 3] - T_goal[:3, 3])), float(np.rad2deg(turn))


def _short(x):
    """A number in three digits, without a power of ten where it is large."""
    return f"{x:.0f}" if x >= 100 else f"{x:.3g}" if x >= 1e-3 else "0"
