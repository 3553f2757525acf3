"""Damped least squares, many configurations at once: towards a solution, and down to a minimum
where there is none.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ..residuals import missing

__all__ = ["Problem", "approach", "descend"]

LONGEST_STEP = 1.0  # rad or m; the linear model is worth nothing further on
ENOUGH = 1e-13  # of the length: nearer than that, rounding decides
REGULAR = 1e-14  # of the largest entry: keeps the equations solvable where the arm is singular
OF_THE_ERROR = 0.1  # Sugihara's damping; measured: 0.5 is slower, 0.02 misses more
FIRST_DAMPING, EASED, RAISED = 1e-2, 0.1, 8.0  # Levenberg's, after a step that helped and one not
HOPELESS = 1e8  # times the first damping: no step helps any more
STANDSTILL, PATIENCE = 1e-7, 4  # so small a gain, so many times running, is a minimum


@dataclass(frozen=True)
class Problem:
    """What is to be made small: ``|metres missing|² + (length · radians missing)²``.

    Parameters
    ----------
    arm : Arm
    T : array (m, 4, 4)
        A target for each configuration.
    length : float
        So many metres count as much as one radian.
    weights : (float, float)
        Of position and orientation; 0 leaves one out.
    low, high : arrays (n,), optional
        Never stepped over.
    free : array (n,) of bool, optional
        The joints that may move; all when left out.
    """

    arm: Arm
    T: NDArray[np.float64]
    length: float
    weights: tuple[float, float] = (1.0, 1.0)
    low: NDArray[np.float64] | None = None
    high: NDArray[np.float64] | None = None
    free: NDArray[np.bool_] | None = None

    @property
    def scale(self) -> NDArray[np.float64]:
        """What each of the six components of the error is multiplied by."""
        return np.repeat([self.weights[0], self.weights[1] * self.length], 3)

    def off(
        self, q: NDArray[np.float64], rows: Any
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """The scaled error (k, 6) of these rows, and its square (k,)."""
        off = missing(self.arm, q, self.T[rows]) * self.scale
        return off, (off**2).sum(axis=1)

    def stepped(
        self, q: NDArray[np.float64], off: NDArray[np.float64], damping: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """``q + (JᵀJ + damping · 1)⁻¹ Jᵀ off`` (k, n), no joint further than it may go."""
        free = slice(None) if self.free is None else self.free
        J = self.arm.jacobian(q)[:, :, free] * self.scale[:, None]
        JT = np.swapaxes(J, -1, -2)
        A, k = JT @ J, np.arange(J.shape[-1])
        A[:, k, k] += np.maximum(damping, REGULAR * A[:, k, k].max(axis=1, initial=0.0))[:, None]
        step = np.linalg.solve(A, JT @ off[..., None])[..., 0]
        longest = np.abs(step).max(axis=1, initial=0.0, keepdims=True)
        there = q.copy()
        there[:, free] += step * np.minimum(1.0, LONGEST_STEP / np.maximum(longest, LONGEST_STEP))
        return self.kept(there)

    def kept(self, q: NDArray[np.float64]) -> NDArray[np.float64]:
        """``q`` with what is outside the bounds put onto them."""
        return np.array(q, dtype=float) if self.low is None else np.clip(q, self.low, self.high)


def approach(problem: Problem, q: NDArray[np.float64], steps: int = 40) -> NDArray[np.float64]:
    """Walk every configuration of ``q`` (m, n) towards a solution; where there is none it ends
    somewhere near.

    The damping is a tenth of the squared error: it fades as the target comes near, and no step is
    refused, so that a nearly singular solution, at the end of a bent valley, is met all the same
    (Sugihara, Solvability-unconcerned inverse kinematics, IEEE Transactions on Robotics 27, 2011).

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("puma560")
    >>> T = arm.forward([[0.1, 0.5, -0.2, 0.3, 0.4, 0.5]])
    >>> q = approach(Problem(arm, T, length=0.5), np.full((1, 6), 0.3))
    >>> bool(np.allclose(arm.forward(q), T))
    True
    """
    q = problem.kept(q)
    best, lowest = q.copy(), np.full(len(q), np.inf)
    busy = np.arange(len(q))
    for _ in range(steps + 1):
        off, cost = problem.off(q[busy], busy)
        better = cost < lowest[busy]
        lowest[busy[better]], best[busy[better]] = cost[better], q[busy[better]]
        far = cost > (ENOUGH * problem.length) ** 2
        busy = busy[far]
        if not len(busy):
            break
        q[busy] = problem.stepped(q[busy], off[far], OF_THE_ERROR * cost[far])
    return best


def descend(problem: Problem, q: NDArray[np.float64], steps: int = 100) -> NDArray[np.float64]:
    """Walk every configuration of ``q`` (m, n) down to a minimum; a step that does not help is not
    made.

    Levenberg-Marquardt (Nocedal and Wright, Numerical Optimization, section 10.3).

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("cobra600")
    >>> T = arm.forward([[0.0, 0, 0, 0]])
    >>> T[0, 0, 3] += 0.5  # stretched out already
    >>> q = descend(Problem(arm, T, length=0.5), np.full((1, 4), 0.3))
    >>> float(np.linalg.norm(arm.forward(q)[0, :3, 3] - T[0, :3, 3]).round(6))
    0.5
    """
    q = problem.kept(q)
    off, cost = problem.off(q, np.arange(len(q)))
    first = FIRST_DAMPING * (problem.scale**2).max()
    damping, idle = np.full(len(q), first), np.zeros(len(q), dtype=int)
    for _ in range(steps):
        far = cost > (ENOUGH * problem.length) ** 2
        busy = np.flatnonzero(far & (damping < HOPELESS * first) & (idle < PATIENCE))
        if not len(busy):
            break
        there = problem.stepped(q[busy], off[busy], damping[busy])
        off_there, cost_there = problem.off(there, busy)
        gain = cost[busy] - cost_there
        better = gain > 0
        idle[busy] = np.where(better & (gain < STANDSTILL * cost[busy]), idle[busy] + 1, 0)
        damping[busy] *= np.where(better, EASED, RAISED)
        moved = busy[better]
        q[moved], off[moved], cost[moved] = there[better], off_there[better], cost_there[better]
    return q
