"""``Chain``: the numbers of an arm as the fast paths want them, worked out once per arm.

Both conventions are one chain here. A link is a turn and a shift of a joint, ``Rz(theta) Tz(d)``,
and a fixed step, ``Tx(a) Rx(alpha)``; a standard row has the step behind its joint, Craig's has it
before. So with J for a joint and X for a step ::

    standard:  base ·       J_1 · X_1 · J_2 · X_2 · … · J_n · X_n · tool
    Craig:     base · X_0 · J_1 · X_1 · J_2 · X_2 · … · J_n ·       tool
"""

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from .plain import Plain

__all__ = ["LARGEST_SUM", "Chain", "Step", "chain_of"]

ROUNDING = float(np.finfo(float).eps)
LARGEST_SUM = 64.0  # rad, ten turns: the rounding of a larger one would be seen (1e-14 and more)


@dataclass(frozen=True)
class Step:
    """``Tx(a) Rx(alpha)``: ``a`` in metres, ``c`` and ``s`` the cosine and sine of alpha."""

    a: float = 0.0
    c: float = 1.0
    s: float = 0.0

    @property
    def parallel(self) -> bool:
        """Whether the axes before and behind it point the same way."""
        return self.c == 1.0 and self.s == 0.0

    def pose(self) -> NDArray[np.float64]:
        """The step as a 4×4 pose."""
        return np.array(
            [[1, 0, 0, self.a], [0, self.c, -self.s, 0], [0, self.s, self.c, 0], [0, 0, 0, 1.0]]
        )


@dataclass(frozen=True, eq=False)
class Chain:
    """What every fast path reads.

    ``steps[0]`` is X_0 and ``steps[i]`` is X_i (the one that the convention lacks is no step at
    all); ``end`` is X_n · tool, multiplied once here instead of for every pose. ``theta`` and ``d``
    are the zero offsets, ``slides`` says which joints are prismatic. The joint variables are
    ``rates · q`` + offset: (n,), or a matrix (n, n) where the joints are coupled. Without coupling
    the rates are the signs: one product a joint, also where all of them are 1.
    """

    standard: bool
    base: NDArray[np.float64]
    steps: tuple[Step, ...]
    end: NDArray[np.float64]
    theta: tuple[float, ...]
    d: tuple[float, ...]
    slides: tuple[bool, ...]
    rates: NDArray[np.float64]

    def __len__(self) -> int:
        return len(self.slides)

    @property
    def coupled(self) -> bool:
        """Whether a joint variable depends on more than one number of q."""
        return self.rates.ndim == 2

    @cached_property
    def largest_q(self) -> float:
        """How large numbers of q may be for the angles of a run, with their offsets, to stay below
        ``LARGEST_SUM``; infinite where no two axes are parallel.
        """
        longest = run = 1
        for step in self.steps[1:-1]:
            run = run + 1 if step.parallel else 1
            longest = max(longest, run)
        if longest == 1:
            return math.inf
        rates = np.abs(self.rates)
        rate = float(rates.sum(axis=1).max() if self.coupled else rates.max())
        offsets = longest * max(map(abs, self.theta))
        return max(LARGEST_SUM - offsets, 0.0) / (longest * rate)

    @cached_property
    def minus_half_angles(self) -> tuple[NDArray[np.float64], NDArray[np.float64] | None]:
        """``rates`` (n, n or 1) and offsets (n, 1), None where all are 0, as ``many.py`` wants
        them: d where a joint slides, and minus half the angle where it turns, so that
        ``many.phases`` of it is exp(-i·angle). Sign, halving and minus are one product.
        """
        unit = np.where(self.slides, 1.0, -0.5)[:, None]
        offsets = np.where(self.slides, self.d, self.theta)[:, None] * unit
        rates = self.rates if self.coupled else self.rates[:, None]
        return rates * unit, offsets if offsets.any() else None


def chain_of(arm: Plain) -> Chain:
    """The ``Chain`` of an arm."""
    table, standard = arm.table, arm.table.convention == "standard"
    steps = [_step(a, alpha) for a, alpha in zip(table.a.tolist(), table.alpha.tolist())]
    steps = [Step(), *steps] if standard else [*steps, Step()]
    return Chain(
        standard,
        arm.base,
        tuple(steps),
        steps[-1].pose() @ arm.tool,
        tuple(table.theta.tolist()),
        tuple(table.d.tolist()),
        tuple(letter == "P" for letter in table.joints),
        arm.sign if arm.coupling is None else arm.coupling * arm.sign,
    )


def _step(a, alpha):
    """A step whose cosine and sine are free of what the rounding of pi leaves in them: cos(pi / 2)
    is 6e-17 in floating point, and less than the rounding of 1 is taken as 0. That is what makes
    right angles and parallel axes cost nothing.
    """
    c, s = math.cos(alpha), math.sin(alpha)
    if abs(s) < ROUNDING:
        return Step(a, math.copysign(1.0, c), 0.0)
    if abs(c) < ROUNDING:
        return Step(a, 0.0, math.copysign(1.0, s))
    return Step(a, c, s)
