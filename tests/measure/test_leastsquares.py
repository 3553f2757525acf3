"""Nonlinear least squares, judged by scipy's."""

import numpy as np
import pytest
import scipy.linalg
import scipy.optimize

from dhlab.measure.leastsquares import least_squares
from dhlab.measure.unknowns import pivots

T = np.linspace(0, 3, 20)
SCATTER = np.random.default_rng(0).normal(size=20)


def _swing(x):
    return x[0] * np.exp(-x[1] * T) * np.cos(x[2] * T) - np.exp(-0.7 * T) * np.cos(2.1 * T)


def _swing_by(x):
    fading, angle = np.exp(-x[1] * T), x[2] * T
    whole = fading * np.cos(angle)
    return np.stack([whole, -x[0] * T * whole, -x[0] * T * fading * np.sin(angle)], axis=1)


def _valley(x):
    return np.array([10 * (x[1] - x[0] ** 2), 1 - x[0]])


def _valley_by(x):
    return np.array([[-20 * x[0], 10.0], [-1.0, 0.0]])


@pytest.mark.parametrize("noise", [0, 1e-6, 0.05])
def test_a_swing_that_fades(noise):
    def residual(x):
        return _swing(x) + noise * SCATTER

    ours = least_squares(residual, [0.8, 0.5, 1.8], _swing_by)
    theirs = scipy.optimize.least_squares(
        residual, [0.8, 0.5, 1.8], _swing_by, xtol=1e-15, ftol=1e-15, gtol=1e-15
    ).x
    assert ours == pytest.approx(theirs, abs=1e-9)


def test_the_curved_valley_of_rosenbrock():
    assert least_squares(_valley, [-1.2, 1], _valley_by) == pytest.approx([1, 1], abs=1e-12)


@pytest.mark.parametrize("little", [0, 1e-14])
def test_an_unknown_without_effect_stays(little):
    def residual(x):
        return np.r_[_swing(x[:3]) + 0.05 * SCATTER, little * x[3]]

    def by(x):
        return np.block([[_swing_by(x[:3]), np.zeros((20, 1))], [np.zeros((1, 3)), little]])

    found = least_squares(residual, [0.8, 0.5, 1.8, 7], by)
    alone = least_squares(lambda x: _swing(x) + 0.05 * SCATTER, [0.8, 0.5, 1.8], _swing_by)
    assert found[:3] == pytest.approx(alone, abs=1e-9)
    assert found[3] == pytest.approx(7, abs=1e-3)


def test_two_unknowns_of_which_only_the_sum_counts_move_alike():
    def by(x):
        return np.ones((4, 2))

    assert least_squares(lambda x: by(x) @ x - 6, [1.0, 2.0], by) == pytest.approx([2.5, 3.5])


@pytest.mark.parametrize("seed", range(20))
def test_unknowns_are_held_as_a_pivoted_decomposition_says(seed):
    rng = np.random.default_rng(seed)
    free = rng.integers(1, 5)
    N = np.linalg.qr(rng.normal(size=(12, free)))[0]
    preferred = np.where(np.arange(12) < 6, 1.0, 1e-3)
    _, _, order = scipy.linalg.qr((N * preferred[:, None]).T, pivoting=True, mode="economic")
    assert set(np.flatnonzero(pivots(N, 6))) == set(order[:free])
