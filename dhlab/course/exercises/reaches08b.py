"""08.13: joint values that bring the end of an arm to a pose, from where the arm stands."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...doctor.programs.wrong.solvers import inverse_kinematics, wrapped
from ...robots import load
from ...rotations import rotation_vectors
from ..kinds import Known, Mistakes, Said, Value
from ..kinds.reading import as_numbers
from ..verdict import Verdict

__all__ = ["MOST", "Reaches", "a_way_to", "draw_ur5e", "several_ways", "wrong_ways"]

MOST = 45.0  # degrees that a joint may turn from where it stands
METRES, DEGREES = 1e-3, 0.1  # how far off the end may be
TOGETHER = 5  # steps between two looks at whether the loop stands still
CUP_Q = np.deg2rad([30, 60, -80, -30, 40, 0])  # of the article's arm


def draw_ur5e(rng: np.random.Generator) -> dict[str, Any]:
    """Where the joints of a UR5e stand, degrees, and a pose near there, well away from the arm's
    singularities and such that the lesson's loop arrives.
    """
    arm = load("ur5e")
    while True:
        there = rng.choice([-70, -40, 25, 55, 80], 6)
        q_now = (there + rng.choice([-30, -20, 20, 30], 6)).astype(float)
        T = arm.forward(np.deg2rad(there))
        if arm.manipulability(np.deg2rad(there)) > 0.03 and _is_there(
            np.deg2rad(there), a_way_to(T, q_now)
        ):
            return {"T": np.where(abs(T) < 1e-12, 0, T).tolist(), "q_now": q_now.tolist()}


def _is_there(q, found):
    return np.allclose(q, found, rtol=0, atol=1e-6)


def a_way_to(T: Any, q_now: Any) -> NDArray:
    """The q to which a hundred steps of the lesson's loop come; every other one that is near
    enough counts as well. A whole class may be compared with it: once q stands still, the steps
    that are left are spared.
    """
    rows, q = load("ur5e").table.rows, np.deg2rad(q_now)
    for _ in range(100 // TOGETHER):
        before, q = q, inverse_kinematics(rows, np.array(T), q, 0.05, TOGETHER)
        if np.abs(wrapped(q - before)).max() < 1e-12:
            break
    return q


def wrong_ways(T: list[list[float]], q_now: list[float]) -> Mistakes:
    """Some of each kind; :class:`Reaches` finds the others by where they lead."""
    for q in load("ur5e").solve(T).q[:3]:
        yield "degrees-for-radians", "q is in degrees, and radians are asked", np.rad2deg(q)
        yield (
            "only-position-checked",
            "the hand is there, turned otherwise",
            q + np.array([0, 0, 0, 0, 0, 0.5]),
        )


def several_ways(answer: Any, T: list[list[float]], q_now: list[float]) -> Known | None:
    """What is said of several q at once, as ``arm.solve`` gives them."""
    Q = as_numbers(answer)
    if Q.ndim != 2 or len(Q) < 2 or Q.shape[1] != len(q_now) or not np.isfinite(Q).all():
        return None
    near = sum(_reaches(q, np.array(T)) and np.abs(_turned(q, q_now)).max() <= MOST for q in Q)
    return None, Said(
        f"these are {len(Q)} q, and one is asked",
        place=f"{near or 'none'} of them reach{'es' if near == 1 else ''} the pose with no joint"
        f" turned further than {MOST:.0f}°",
        next="Compare each row, in degrees, with q_now, and hand in one.",
    )


@dataclass(frozen=True, kw_only=True)
class Reaches(Value):
    """Joint values of the UR5e, in radians: right when its end comes to the pose, to a millimetre
    and a tenth of a degree, and no joint turns further than :data:`MOST`.
    """

    def is_right(self, array: NDArray, expected: NDArray, given: Mapping[str, Any]) -> bool:
        turned = np.abs(_turned(array, given["q_now"])).max()
        return turned <= MOST and _reaches(array, np.array(given["T"]))

    def _compared(self, array: NDArray, expected: NDArray, given: Any, answer: Any) -> Verdict:
        if self.is_right(array, expected, given):
            return self.right()
        T_goal = np.array(given["T"])
        if _reaches(array, T_goal):
            return self._too_far(array, given["q_now"])
        if _reaches(np.deg2rad(array), T_goal):
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
        return self._away(*_off(array, T_goal))

    def _too_far(self, array, q_now):
        """The Verdict on a q that reaches the pose and is not near where the arm stands."""
        turned = _turned(array, q_now)
        k = int(np.abs(turned).argmax())
        far = f"joint {k + 1} would turn by {abs(turned[k]):.0f}°, and {MOST:.0f}° is the most"
        if np.abs(np.rad2deg(wrapped(np.deg2rad(turned)))).max() <= MOST:
            return self.told(
                None,
                Said(
                    "the pose is right, but whole turns are left in q",
                    place=far,
                    next="A whole turn is 2π: take it off as often as it fits.",
                ),
            )
        return self.told(
            None,
            Said(
                "the pose is right, but on another branch than the near one",
                place=far,
                next="Begin the loop at q_now, in radians: where does it end?",
            ),
        )

    def _away(self, metres, degrees):
        """The Verdict on a q that does not reach the pose."""
        words = f"the hand is {_short(1000 * metres)} mm and {_short(degrees)}° away from the pose"
        if metres <= METRES:
            return self.wrong(
                "only-position-checked",
                place=Said(words, next="The position is right. What of the orientation?"),
            )
        if degrees <= DEGREES:
            return self.wrong(
                headline=words, next="The orientation is right. What of the position?"
            )
        return self.wrong(
            headline=words,
            next="Did your loop get ur5e.table.rows, T_task and q_now? Make more steps.",
        )


def _turned(q, q_now):
    """By how many degrees each joint turns."""
    return np.rad2deg(q) - q_now


def _reaches(q, T_goal):
    metres, degrees = _off(q, T_goal)
    return bool(metres <= METRES and degrees <= DEGREES)


def _off(q, T_goal):
    """(metres, degrees) from the end of the UR5e at q to a pose."""
    T = load("ur5e").forward(q)
    turn = np.linalg.norm(rotation_vectors(T_goal[:3, :3] @ T[:3, :3].T))
    return float(np.linalg.norm(T[:3, 3] - T_goal[:3, 3])), float(np.rad2deg(turn))


def _short(x):
    """A number in three digits, without a power of ten where it is large."""
    return f"{x:.0f}" if x >= 100 else f"{x:.3g}" if x >= 1e-3 else "0"
