"""What is said of one step, right or wrong, and how exact a hand must be."""

from dataclasses import dataclass
from textwrap import fill

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..geometry.lines import nearest_on
from ..printing import number

__all__ = ["Judgement", "ANGLE", "NO_DIRECTION", "NO_POINT", "beside", "vector"]


WIDTH = 90  # of a printed judgement: what a notebook shows without breaking words


ANGLE = 0.01  # rad, 0.6°: a direction typed with three decimals is nearer than this


NO_DIRECTION = (
    "no-direction",
    "Expected a direction: three finite numbers, not all 0. Its length does not count.",
)


NO_POINT = (
    "no-point",
    "Expected three finite numbers x, y, z in metres. Look at what was typed or measured.",
)


@dataclass(frozen=True)
class Judgement:
    """What is said of one step: true in an ``if`` when it is right, a sentence when printed.

    ``step`` is "z2", "o2" or "x2"; ``rule`` the short id of the rule that the step keeps or breaks;
    ``message`` one or two sentences.
    """

    step: str
    right: bool
    rule: str
    message: str

    def __bool__(self) -> bool:
        return self.right

    def __str__(self) -> str:
        return fill(
            f"{'✓' if self.right else '✗'} {self.step}: {self.message}",
            WIDTH,
            subsequent_indent=" " * 6,
        )

    __repr__ = __str__


def beside(p: NDArray[np.float64], z: NDArray[np.float64], point: NDArray[np.float64]) -> str:
    """How far (m) a point is from the line (p, z), written with three decimals."""
    return number(float(np.linalg.norm(point - nearest_on(p, z, point))), 3)


def vector(given: ArrayLike | None) -> NDArray[np.float64] | None:
    """Three finite numbers as an array, or None."""
    try:
        v = np.array(given, dtype=float)
    except (TypeError, ValueError):
        return None
    return v if v.shape == (3,) and np.isfinite(v).all() else None
