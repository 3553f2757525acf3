"""``Chain``: the numbers of an arm as the fast paths want them, worked out once per arm.

Both conventions are one chain here. A link is a turn and a shift of a joint, ``Rz(theta) Tz(d)``,
and a fixed step, ``Tx(a) Rx(alpha)``; a standard row has the step behind its joint, Craig's has it
before. So with J for a joint and X for a step ::

    standard:  base ·       J_1 · X_1 · J_2 · X_2 · … · J_n · X_n · tool
    Craig:     base · X_0 · J_1 · X_1 · J_2 · X_2 · … · J_n ·       tool
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

__all__ = ["Chain", "Step", "chain_of"]

ROUNDING = np.finfo(float).eps


@dataclass(frozen=True)
class Step:
    """``Tx(a) Rx(alpha)``: ``a`` in metres, ``c`` and ``s`` the cosine and sine of alpha."""

    a: float
    c: float
    s: float

    @property
    def parallel(self):
        """Whether the axes before and behind it point the same way."""
        return self.c == 1.0 and self.s == 0.0

    def pose(self):
        """The step as a 4×4 pose."""
        return np.array(
            [[1, 0, 0, self.a], [0, self.c, -self.s, 0], [0, self.s, self.c, 0], [0, 0, 0, 1.0]]
        )


@dataclass(frozen=True, eq=False)
class Chain:
    """What every path reads.

    ``steps[0]`` is X_0 and ``steps[i]`` is X_i (the one that the convention lacks is no step at
    all); ``end`` is X_n · tool, multiplied once here instead of for every pose. ``theta`` and ``d``
    are the zero offsets, ``slides`` says which joints are prismatic, and ``counts @ q + offset``
    (n, n) are the joint variables; it is diagonal unless the joints are ``coupled``.
    """

    standard: bool
    base: np.ndarray
    steps: tuple
    end: np.ndarray
    theta: np.ndarray
    d: np.ndarray
    slides: tuple
    counts: np.ndarray
    coupled: bool

    def __len__(self):
        return len(self.slides)

    @cached_property
    def rates(self):
        """(n, n) or (n, 1), and offsets (n, 1) or None"""
        unit = np.where(self.slides, 1.0, -0.5)[:, None]
        rates = self.counts * unit if self.coupled else np.diag(self.counts)[:, None] * unit
        offsets = np.where(self.slides, self.d, self.theta)[:, None] * unit
        return rates, offsets if offsets.any() else None


def chain_of(table, base, tool, sign, coupling=None):
    """The ``Chain`` of an arm's parts; see ``dhlab.Arm``."""
    steps = [_step(a, alpha) for a, alpha in zip(table.a.tolist(), table.alpha.tolist())]
    none, standard = Step(0.0, 1.0, 0.0), table.convention == "standard"
    steps = (none, *steps) if standard else (*steps, none)
    return Chain(
        standard,
        base,
        steps,
        steps[-1].pose() @ tool,
        table.theta,
        table.d,
        tuple(table.prismatic.tolist()),
        np.diag(sign) if coupling is None else coupling * sign,
        coupling is not None,
    )


def _step(a, alpha):
    """A step whose cosine and sine are free of what the rounding of pi leaves in them: cos(pi / 2)
    is 6e-17 in floating point, and less than the rounding of 1 is taken as 0. That is what makes
    right angles and parallel axes cost nothing.
    """
    c, s = float(np.cos(alpha)), float(np.sin(alpha))
    if abs(s) < ROUNDING:
        return Step(a, float(np.sign(c)), 0.0)
    if abs(c) < ROUNDING:
        return Step(a, 0.0, float(np.sign(s)))
    return Step(a, c, s)
