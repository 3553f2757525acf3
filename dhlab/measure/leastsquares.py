"""Nonlinear least squares, by the method of Levenberg and Marquardt.

scipy does this too, and takes 35 MB to load; what is measured here has a few dozen unknowns, and
its derivatives are known.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["least_squares"]

Vector = NDArray[np.float64]

MOST = 200  # steps; from afar some dozens are taken
CLOSE = 1e-13  # of the unknowns, and of what is left over: a smaller change is none
FIRST, LEAST = 1e-3, 1e-12  # damping, as a share of the largest squared singular value
NO_EFFECT = 1e-9  # of a column of the derivative over the largest; smaller ones are rounding
LOST = 1e12  # of the same; where even so short a step is none down, there is none


def least_squares(
    residual: Callable[[Vector], Vector], start: ArrayLike, jacobian: Callable[[Vector], Vector]
) -> Vector:
    """The unknowns x (k,), near ``start``, for which the squares of ``residual(x)`` (m,) have the
    least sum; ``jacobian(x)`` (m, k) is its derivative.

    Each step solves the linear problem, damped in unknowns that are scaled by the columns of the
    derivative (Marquardt 1963); the damping follows how well the linear problem foretold what came
    (Nielsen 1999). Unknowns without effect stay as they are.

    Examples
    --------
    >>> t = np.arange(5.0)
    >>> off = lambda x: x[0] * np.exp(-x[1] * t) - 3 * np.exp(-0.5 * t)
    >>> by = lambda x: np.stack([np.exp(-x[1] * t), -x[0] * t * np.exp(-x[1] * t)], axis=1)
    >>> least_squares(off, [1, 1], by).round(9)
    array([3. , 0.5])
    """
    x = np.array(start, dtype=float)
    r, damping, more = residual(x), FIRST, 2.0
    step = _steps(r, jacobian(x))
    for _ in range(MOST):
        change, foretold = step(damping)
        tried = residual(x + change)
        gain = r @ r - tried @ tried
        small = np.linalg.norm(change) <= CLOSE * (CLOSE + np.linalg.norm(x))
        if gain > 0:
            settled = small or max(gain, foretold) <= CLOSE * (r @ r)
            x, r = x + change, tried
            if settled:
                break
            step = _steps(r, jacobian(x))
            damping = max(LEAST, damping * max(1 / 3, 1 - (2 * gain / foretold - 1) ** 3))
            more = 2.0
        elif small or damping > LOST or foretold <= CLOSE * (r @ r):
            break  # what is left to gain is rounding
        else:
            damping, more = damping * more, 2 * more
    return x


def _steps(r, J):
    """From a damping to (the step, how much it should take off the sum of squares)."""
    scale = np.linalg.norm(J, axis=0)
    scale = np.maximum(scale, max(NO_EFFECT * scale.max(initial=0.0), 1e-300))
    U, s, Vt = np.linalg.svd(J / scale, full_matrices=False)
    along = U.T @ r
    largest = max(s.max(initial=0.0), 1e-300) ** 2

    def step(damping):
        by = s / (s**2 + damping * largest)
        left = 1 - s * by
        return -(Vt.T @ (by * along)) / scale, float((along**2 * (1 - left**2)).sum())

    return step
