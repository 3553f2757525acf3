"""Why there is no solution, and what comes nearest."""

import numpy as np
from numpy.typing import NDArray

from ..printing import number
from .joints import bounds, inside_by_turns, nearest_by_turns
from .numeric.descent import Problem, approach, descend
from .numeric.search import STARTS, arm_length, search, starts
from .question import Question
from .reach import elbow_arm
from .residuals import residuals
from .solutions import Nearest, Reason

__all__ = ["explained"]

CLEARLY = 10.0  # times the tolerance: missed, and not merely badly met
STRIDES, LEADING = 20, 12  # steps of every start, and how many go on from there
FAINT = 1e-3  # the weight of the orientation where the position comes first
SEED = 1


def explained(
    question: Question,
    outside: NDArray[np.float64],
    seen: NDArray[np.float64] | None,
    complete: bool,
) -> tuple[Reason, Nearest]:
    """The reason and the nearest pose, for a question without a solution.

    Parameters
    ----------
    question : Question
    outside : array (j, n)
        Solutions that break the limits.
    seen : array (n,) or None
        Where the search for a solution came nearest.
    complete : bool
        Whether ``outside`` is all there is.

    Returns
    -------
    Reason, Nearest
    """
    if question.limits and len(outside):
        return _limits(question, outside, complete), _Reach(question, outside).nearest()
    if question.holds:
        found = _without_holds(question)
        if len(found):
            q = found[0]
            return _redundancy(question, q), _nearest(question, q)
    reach = _Reach(question, np.empty((0, len(question.arm))) if seen is None else seen[None])
    return reach.reason(None if question.limits else elbow_arm(question.arm)), reach.nearest()


class _Reach:
    """What the end can come to, by search: starts all over the arm's range, walked down."""

    def __init__(self, question, seen):
        self.question, self.arm, self.T = question, question.arm, question.T
        self.length = arm_length(self.arm)
        self.low, self.high = bounds(self.arm)
        generator = np.random.default_rng(SEED)
        wide = (-np.inf, np.inf) if not question.limits else (self.low, self.high)
        first = starts(self.arm, STARTS, generator, *wide)
        self.first = np.concatenate([first, seen])

    def _problem(self, count, weights=(1.0, 1.0)):
        limits = (self.low, self.high) if self.question.limits else (None, None)
        T = np.broadcast_to(self.T, (count, 4, 4))
        return Problem(self.arm, T, self.length, weights, *limits)

    def _walked(self, weights):
        """Where the starts lead: all of them part of the way, the best of them to the end."""
        problem = self._problem(len(self.first), weights)
        q = approach(problem, self.first, steps=STRIDES)
        _, cost = problem.off(q, np.arange(len(q)))
        best = np.argsort(cost)[:LEADING]
        return descend(self._problem(len(best), weights), q[best])

    def nearest(self):
        """Where position and orientation together come nearest."""
        q = self._walked((1.0, 1.0))
        off = residuals(self.arm, q, self.T)
        return _nearest(self.question, q[np.argmin(np.hypot(off[:, 0], self.length * off[:, 1]))])

    def position(self):
        """The least distance (m), in any orientation, and where (k, n) it is met."""
        q = self._walked((1.0, 0.0))
        metres = residuals(self.arm, q, self.T)[:, 0]
        return float(metres.min()), q[metres <= metres.min() + self.question.tolerance]

    def orientation(self, q):
        """The least angle (rad) that is left where the position is met, from ``q`` (k, n)."""
        q = descend(self._problem(len(q), (1.0, FAINT)), q)
        q = approach(self._problem(len(q), (1.0, 0.0)), q)
        metres, radians = residuals(self.arm, q, self.T).T
        met = metres <= CLEARLY * self.question.tolerance
        return float(radians[met].min(initial=np.inf))

    def reason(self, elbow):
        """Reach, orientation, or neither could be told."""
        clear = CLEARLY * self.question.tolerance
        exact, words = elbow.shortfall(self.T) if elbow else (0.0, "")
        told = f" Exactly: {words}, {_mm(exact)} short." if exact else ""
        few = len(self.arm) < 6
        also = f" An arm of {len(self.arm)} joints cannot take up every pose." if few else ""
        metres, at = self.position()
        if metres > clear:
            return Reason(
                "reach",
                f"Out of reach: in no orientation does the end come nearer than about {_mm(metres)}"
                f" to this position.{told}{also}",
                metres=metres,
                short=exact,
                certain=bool(exact),
            )
        radians = self.orientation(at)
        if clear < radians < np.inf:
            return Reason(
                "orientation",
                "The position can be reached, but not in this orientation: the nearest there is"
                f" about {number(np.rad2deg(radians), 4)}° away.{told}{also}",
                radians=radians,
                short=exact,
                certain=bool(exact),
            )
        return Reason(
            "search",
            f"The search from {len(self.first)} starts found none, and found no reason either;"
            " there may be one.",
        )


def _limits(question, outside, complete):
    """Which limit is in the way: of the solution that breaks its limits by the least."""
    low, high = bounds(question.arm)
    over = np.maximum(np.maximum(low - outside, outside - high), 0)
    best = int(np.argmin(over.max(axis=1)))
    joints = [
        _broken(question.arm, i, outside[best, i], low[i], high[i])
        for i in np.flatnonzero(over[best])
    ]
    count = (
        "its one solution breaks" if len(outside) == 1 else f"all {len(outside)} solutions break"
    )
    slides = question.arm.table.prismatic
    return Reason(
        "limits",
        f"The pose is within reach, but {count} the limits; nearest to keeping them is the one with"
        f" {' and '.join(joints)}.",
        metres=float(over[best, slides].max(initial=0.0)),
        radians=float(over[best, ~slides].max(initial=0.0)),
        certain=complete,
    )


def _broken(arm, i, value, low, high):
    limit = low if value < low else high
    scale, unit = (1.0, " m") if arm.table.prismatic[i] else (180 / np.pi, "°")
    return (
        f"joint {i + 1} at {number(value * scale, 3)}{unit} (limit"
        f" {number(limit * scale, 3)}{unit})"
    )


def _without_holds(question):
    """Solutions (k, n) with no joint held, by search."""
    arm = question.arm
    found = search(
        arm,
        question.T[None],
        tolerance=question.tolerance,
        near=question.near,
        within=question.limits,
    )[0].q
    return found[arm.within_limits(found).all(axis=1)] if question.limits else found


def _redundancy(question, q):
    held = sorted({joint for hold in question.holds for joint in hold})
    scales = [1.0 if question.arm.table.prismatic[j] else 180 / np.pi for j in held]
    units = [" m" if question.arm.table.prismatic[j] else "°" for j in held]
    values = " and ".join(
        f"joint {j + 1} at {number(q[j] * scale, 3)}{unit}"
        for j, scale, unit in zip(held, scales, units, strict=True)
    )
    return Reason(
        "redundancy",
        f"Not with the redundancy that was stated, but with another one: the pose is met with"
        f" {values}.",
        certain=True,
    )


def _nearest(question, q):
    """A configuration as a :class:`Nearest`."""
    q = nearest_by_turns(question.arm, q, question.reference)
    if question.limits:
        q = inside_by_turns(question.arm, q[None])[0]
    metres, radians = residuals(question.arm, q[None], question.T)[0]
    pose, length = question.arm.forward(q), arm_length(question.arm)
    return Nearest(q, pose, float(metres), float(radians), length)


def _mm(metres):
    return f"{number(1000 * metres, 3)} mm"
