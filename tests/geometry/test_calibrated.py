"""Arms whose axes are nearly parallel: Hayati's parameters, and a table made readable."""

import numpy as np
import pytest
from draws import few

import dhlab as dh
from dhlab.transform import rot_x, rot_y, rot_z, trans_x, trans_z


def product(found, q):
    """Hayati's product, written out."""
    T = found.base
    for (theta, d, a, alpha, beta), letter, value in zip(found.rows, found.joints, q):
        T = T @ rot_z(theta + value * (letter == "R")) @ trans_z(d + value * (letter == "P"))
        T = T @ trans_x(a) @ rot_x(alpha) @ rot_y(beta)
    return T @ found.tool


@pytest.fixture(scope="module")
def calibrated():
    """A UR5e whose elbow axis is 0.06° off: its table has lengths of hundreds of metres."""
    right = dh.load("ur5e")
    axes = [[frame[:3, 3], frame[:3, 2]] for frame in right.frames([0] * 6)[:-1]]
    axes[2][1] = axes[2][1] + np.array([0.001, 0, 0.0002])
    with pytest.warns(dh.NearlyParallelWarning):
        return dh.assign_frames(axes, end=right.forward([0] * 6), name="calibrated")


@pytest.mark.parametrize("name", few(dh.robots(), 5))
def test_hayati_s_product_is_the_arm(name):
    arm = dh.load(name)
    for q in np.random.default_rng(1).uniform(-2, 2, (3, len(arm))):
        np.testing.assert_allclose(product(dh.hayati(arm), q), arm.forward(q), atol=1e-13)


def test_nearly_parallel_axes_keep_small_numbers(calibrated):
    found = dh.hayati(calibrated)
    assert np.abs(calibrated.table.d).max() > 100 and np.abs(found.rows[:, 1:3]).max() < 0.5
    assert (np.abs(found.rows[:, 4]) > 1e-5).sum() == 2
    q = np.random.default_rng(2).uniform(-2, 2, 6)
    np.testing.assert_allclose(product(found, q), calibrated.forward(q), atol=1e-11)
    values = [line.split(",")[:5] for line in found.to_csv().splitlines()[1:]]
    assert np.array_equal(np.array(values, float), found.rows)


def test_a_calibrated_table_becomes_readable_for_what_is_said(calibrated):
    found = dh.tidied(calibrated)
    nominal = dh.load("ur5e").table
    assert np.abs(found.arm.table.d).max() < 0.2
    q = np.random.default_rng(3).uniform(-3, 3, (100, 6))
    T, U = found.arm.forward(q), calibrated.forward(q)
    off = np.linalg.norm((T - U)[:, :3, 3], axis=1)
    assert off.max() < 1.2 * found.shift and 1e-4 < found.shift < 5e-3
    lengths = [np.sort(np.abs(table.rows[:, 1:3]).ravel()) for table in (found.arm.table, nominal)]
    np.testing.assert_allclose(*lengths, atol=6e-4)
