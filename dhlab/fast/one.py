"""One pose in plain floats: for a single pose numpy costs more to call than to compute.

``forward``, ``frames`` and ``jacobian`` return their numbers as one flat list, row by row. They are
written for anything that adds and multiplies: run on floats they give the pose; run on the symbols
of ``straight.py`` they give the program of one arm, which does the same operations in the same
order (but for sums with 0 and products by 1, which change nothing), so that both give the same
bits.
"""

import math
from collections.abc import Iterable, Sequence
from typing import Any

from .chain import LARGEST_SUM, Chain, Step
from .walk import along_the_joints, frame_by_frame, to_the_end

__all__ = ["Floats", "Frame", "forward", "frames", "jacobian"]

LAST_ROW = [0.0, 0.0, 0.0, 1.0]


class Floats:
    """What a walk needs beside sums and products, for floats; ``straight.Program`` has the same for
    symbols.
    """

    cos, sin = math.cos, math.sin

    @staticmethod
    def added(angle: float, theta: float) -> float:
        """The sum of the angles of a run; an OverflowError where its rounding would be seen."""
        if not -LARGEST_SUM < angle + theta < LARGEST_SUM:
            raise OverflowError
        return angle + theta

    @staticmethod
    def keep(value):
        """Give an intermediate result a name; a float needs none."""
        return value

    keep_all = tuple


def forward(chain: Chain, q: Sequence, math_of: Any = Floats) -> list:
    """The end pose of ``q`` (n numbers): 16 numbers."""
    return to_the_end(chain, Frame(chain, q, math_of)).behind(chain.end.tolist())


def frames(chain: Chain, q: Sequence, math_of: Any = Floats) -> list:
    """Every frame: (n + 1)·16 numbers."""
    frame, found = Frame(chain, q, math_of), []
    for _ in frame_by_frame(chain, frame):
        found += frame.rows()
    return found


def jacobian(chain: Chain, q: Sequence, math_of: Any = Floats) -> list:
    """The Jacobian at the end point, 6·n numbers: column i is z × (end - p) over z, or z over 0
    where the joint slides; where joints are coupled, columns per joint variable become columns per
    number of q by the chain rule.
    """
    frame = Frame(chain, q, math_of)
    axes = [(frame.z, frame.p) for _ in along_the_joints(chain, frame)]
    end = frame.point([row[3] for row in chain.end.tolist()])
    columns = [
        [*z, 0.0, 0.0, 0.0] if slides else [*_moment(z, end, p), *z]
        for (z, p), slides in zip(axes, chain.slides)
    ]
    rows, rates = zip(*columns), chain.rates.T.tolist()
    if chain.coupled:
        return [weighed(column, row) for row in rows for column in rates]
    return [rate * number for row in rows for rate, number in zip(rates, row)]


class Frame:
    """Axes ``x``, ``y``, ``z`` and origin ``p``, three numbers each; the moves are those of
    ``walk.py``.
    """

    def __init__(self, chain: Chain, q: Sequence, math_of: Any) -> None:
        self.x, self.y, self.z, self._p = zip(*chain.base[:3].tolist())
        self.math = math_of
        rates = chain.rates.tolist()
        moved = (
            [weighed(row, q) for row in rates]
            if chain.coupled
            else [rate * number for rate, number in zip(rates, q)]
        )
        zeros = zip(moved, chain.theta, chain.d, chain.slides)
        self.variables = [
            (theta, m + d) if slides else (m + theta, d) for m, theta, d, slides in zeros
        ]
        self.angle: Any = None
        self.laid: list | None = None

    @property
    def p(self) -> tuple:
        """The origin; what was laid out in the plane of x and y is added first."""
        if self.laid is not None:
            self._p = self._shifted(self.math.keep_all(self.laid), (self.x, self.y))
            self.laid = None
        return self._p

    def add_joint(self, i: int) -> None:
        theta, d = self.variables[i]
        begins = self.angle is None
        self.angle = self.math.keep(theta) if begins else self.math.added(self.angle, theta)
        self._p = self._shifted((d,), (self.z,))

    def lay(self, a: float) -> None:
        if a:
            step = [a * part for part in self._direction()]
            self.laid = step if self.laid is None else [i + j for i, j in zip(self.laid, step)]

    def turn(self, a: float) -> None:
        if self.laid is not None:
            self.lay(a)
            a = 0.0
        self._p, (c, s) = self.p, self._direction()
        pairs = list(zip(self.x, self.y))
        self.x = self.math.keep_all(i * c + j * s for i, j in pairs)
        self.y = self.math.keep_all(j * c - i * s for i, j in pairs)
        self.angle = None
        self.go(a)

    def go(self, a: float) -> None:
        self._p = self._shifted((a,), (self.x,))

    def tilt(self, step: Step) -> None:
        pairs = list(zip(self.y, self.z))
        self.y = self.math.keep_all(j * step.c + k * step.s for j, k in pairs)
        self.z = self.math.keep_all(k * step.c - j * step.s for j, k in pairs)

    def point(self, xyz: Sequence[float]) -> tuple:
        """A point of this frame in the world."""
        self._p = self.p
        return self._shifted(xyz, (self.x, self.y, self.z))

    def rows(self) -> list:
        """This frame as 16 numbers."""
        rows = zip(self.x, self.y, self.z, self.p)
        return [number for row in rows for number in row] + LAST_ROW

    def behind(self, pose: Sequence[Sequence[float]]) -> list:
        """This frame moved by a constant pose, as 16 numbers."""
        axes = list(zip(self.x, self.y, self.z))
        turned = [[weighed(column[:3], axis) for axis in axes] for column in list(zip(*pose))[:3]]
        columns = *turned, self.point([row[3] for row in pose])
        return [number for row in zip(*columns) for number in row] + LAST_ROW

    def _direction(self):
        """Cosine and sine of the run's angle."""
        keep = self.math.keep
        return keep(self.math.cos(self.angle)), keep(self.math.sin(self.angle))

    def _shifted(self, lengths, axes):
        weights = (1.0, *lengths)
        return self.math.keep_all(weighed(weights, row) for row in zip(self._p, *axes))


def weighed(weights: Iterable[float], terms: Iterable) -> Any:
    """The sum of weight · term."""
    total = 0.0
    for weight, term in zip(weights, terms):
        total = total + weight * term
    return total


def _moment(z, end, p):
    """z × (end - p)"""
    x, y, w = (i - j for i, j in zip(end, p))
    return z[1] * w - z[2] * y, z[2] * x - z[0] * w, z[0] * y - z[1] * x
