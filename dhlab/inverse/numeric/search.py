"""Solutions by search: damped least squares from many starts, for any arm."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...geometry.canonical import joint_axes
from ..joints import bounds
from ..residuals import residuals
from .descent import Problem, approach
from .merging import merged

__all__ = ["Found", "arm_length", "search", "starts"]

STARTS = 64  # of a target in one round
ROUNDS = 6  # as long as a solution was met only once, there may be one that was not met at all
ROWS = 4096  # walked at once: more would leave the processor's cache
SHARP = 1e-3  # of the tolerance: what is not as near yet is walked once more
SEED = 0


@dataclass(frozen=True)
class Found:
    """What a search for one target gave: ``q`` (k, n), every one within the tolerance; ``nearest``
    (n,), where the end came nearest; ``starts``, how many there were; ``once``, how many solutions
    only one start led to.
    """

    q: NDArray[np.float64]
    nearest: NDArray[np.float64]
    starts: int
    once: int


def arm_length(arm: Arm) -> float:
    """How far the arm's joint axes and end lie from each other, in metres: what a radian counts
    as.

    Examples
    --------
    >>> import dhlab as dh
    >>> round(arm_length(dh.load("ur5e")), 3)
    0.85
    """
    axes = joint_axes(arm)
    slides = [
        high - low
        for low, high, slide in zip(*bounds(arm), arm.table.prismatic, strict=True)
        if slide and np.isfinite(high - low)
    ]
    return float(max(axes.reach, max(slides, default=0.0)) or max(axes.largest, 1e-3))


def starts(
    arm: Arm,
    count: int,
    generator: np.random.Generator,
    low: NDArray[np.float64],
    high: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Random configurations (count, n): inside ``low`` and ``high`` where they are finite, else
    half a turn, or the arm's length, to either side.
    """
    wide = np.where(arm.table.prismatic, arm_length(arm), np.pi)
    low, high = np.where(np.isfinite(low), low, -wide), np.where(np.isfinite(high), high, wide)
    return generator.uniform(low, high, (count, len(arm)))


def search(
    arm: Arm,
    T: NDArray[np.float64],
    *,
    tolerance: float,
    held: Mapping[int, float] | None = None,
    near: NDArray[np.float64] | None = None,
    within: bool = False,
) -> list[Found]:
    """Every solution that the starts lead to, for each target.

    Parameters
    ----------
    arm : Arm
    T : array (m, 4, 4)
        Rigid poses.
    tolerance : float
        Metres and radians.
    held : dict, optional
        Joints (from 0) that stay at a value of ``q``.
    near : array (n,), optional
        One more start.
    within : bool
        Never leave the limits.

    Returns
    -------
    list of Found, one per target
    """
    isolated = len(arm) - len(held or {}) <= 6
    founds = []
    batch = max(1, ROWS // STARTS)
    for k in range(0, len(T), batch):
        part = T[k : k + batch]
        round_of = _Rounds(arm, part, tolerance, held or {}, near, within)
        round_of.walk(np.arange(len(part)))
        while isolated and len(again := round_of.unsure()):
            round_of.walk(again)
        founds += round_of.founds()
    return founds


class _Rounds:
    """The starts of some targets, round by round."""

    def __init__(self, arm, T, tolerance, held, near, within):
        self.arm, self.T, self.tolerance = arm, T, tolerance
        self.held, self.near = held, near
        self.low, self.high = bounds(arm)
        self.within = within
        self.length = arm_length(arm)
        self.free = ~np.isin(np.arange(len(arm)), list(held))
        self.generator = np.random.default_rng(SEED)
        self.count = np.zeros(len(T), dtype=int)
        self.solved = [np.empty((0, len(arm))) for _ in T]
        self.best = [(np.inf, np.zeros(len(arm))) for _ in T]

    def walk(self, targets):
        """One round of starts for these targets."""
        first = starts(self.arm, STARTS * len(targets), self.generator, *self._range())
        if self.near is not None:
            first[::STARTS] = self.near
        for joint, value in self.held.items():
            first[:, joint] = value
        aims = np.repeat(self.T[targets], STARTS, axis=0)
        low, high = (self.low, self.high) if self.within else (None, None)
        problem = Problem(self.arm, aims, self.length, low=low, high=high, free=self.free)
        q = approach(problem, first)
        off = residuals(self.arm, q, aims)
        rough = (off <= self.tolerance).all(axis=1) & (off > SHARP * self.tolerance).any(axis=1)
        if rough.any():  # nearly singular: within the tolerance long before it stands still
            q[rough] = approach(replace(problem, T=aims[rough]), q[rough])
            off[rough] = residuals(self.arm, q[rough], aims[rough])
        for target, rows, gaps in zip(
            targets, q.reshape(-1, STARTS, q.shape[1]), off.reshape(-1, STARTS, 2), strict=True
        ):
            self._keep(target, rows, gaps)

    def _range(self):
        """Where starts lie: the limits count for sliding joints always, else when they bind."""
        matters = self.within | self.arm.table.prismatic
        return np.where(matters, self.low, -np.inf), np.where(matters, self.high, np.inf)

    def _keep(self, target, q, off):
        reached = (off <= self.tolerance).all(axis=1)
        self.solved[target] = np.concatenate([self.solved[target], q[reached]])
        cost = np.hypot(off[:, 0], self.length * off[:, 1])
        lowest = int(np.argmin(cost))
        if cost[lowest] < self.best[target][0]:
            self.best[target] = cost[lowest], q[lowest]
        self.count[target] += len(q)

    def _groups(self, target):
        return merged(self.arm, self.solved[target], self.T[target], self.tolerance)

    def unsure(self):
        """The targets that may have more solutions, and have starts left: one was met only once,
        or they are odd in number (real roots of six joints' equations come in pairs).
        """
        short = np.flatnonzero(self.count < ROUNDS * STARTS)
        return np.array([k for k in short if self._may_have_more(self._groups(k)[1])], dtype=int)

    def _may_have_more(self, groups):
        once = any(len(members) == 1 for members in groups)
        return once or (self.free.sum() == 6 and len(groups) % 2 == 1)

    def founds(self):
        """What came out, target by target."""
        return [
            Found(
                q, self.best[k][1], int(self.count[k]), sum(len(members) == 1 for members in groups)
            )
            for k in range(len(self.T))
            for q, groups in [self._groups(k)]
        ]
