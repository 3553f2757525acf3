"""The least squares of a sheet's numbers, as far as there is time."""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

from ..budget import NAMES

__all__ = ["Least", "least"]


@dataclass(frozen=True)
class Least:
    """The numbers with the least misfit, that misfit, and the numbers' covariance."""

    x: np.ndarray
    chi2: float
    covariance: np.ndarray


class _Over(Exception):
    """There is no more time."""


def least(residual, x, clock, steps):
    """The :class:`Least` from ``x`` on: where the time is over on the way, the best so far, with a
    covariance of 0.

    Parameters
    ----------
    residual : callable
        The numbers (k,) to residuals of any shape, in units of the noise.
    x : sequence of k floats
    clock : Budget
    steps : int

    Examples
    --------
    >>> from dhlab.doctor.budget import Budget
    >>> least(lambda x: x - [1.0, 2.0], [0, 0], Budget(10.0), 20).x.round(6)
    array([1., 2.])
    >>> least(lambda x: x - [1.0, 2.0], [0, 0], Budget(0.0), 20).chi2
    5.0
    """
    best = None

    def asked(x):
        nonlocal best
        r = residual(x).ravel()
        chi2 = float(r @ r)
        if best is None or chi2 < best.chi2:
            best = Least(np.array(x, dtype=float), chi2, np.zeros((len(x), len(x))))
        if clock.past(NAMES):
            raise _Over
        return r

    try:
        fit = least_squares(asked, x, x_scale="jac", max_nfev=steps)
    except _Over:
        return best
    return Least(fit.x, 2 * float(fit.cost), np.linalg.pinv(fit.jac.T @ fit.jac))
