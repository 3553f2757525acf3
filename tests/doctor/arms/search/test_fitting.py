"""Free bases and tools in closed form, against scipy's own solutions of the same problems."""

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab.doctor.arms.search.ends import carried
from dhlab.doctor.arms.search.fitting import misfit
from dhlab.doctor.arms.search.measured import Measured


def test_carried_points_against_align_vectors():
    rng = np.random.default_rng(1)
    points, targets = rng.normal(size=(20, 7, 3)), rng.normal(size=(7, 3))
    centred = targets - targets.mean(0)
    wanted = [Rotation.align_vectors(centred, one - one.mean(0))[1] ** 2 for one in points]
    np.testing.assert_allclose(carried(points, targets), wanted, rtol=1e-9)


@pytest.mark.parametrize("full", [True, False])
def test_few_poses_find_the_ends_of_a_right_table(full):
    arm, rng = dh.load("ur5e"), np.random.default_rng(3)
    for _ in range(12):
        q, (B, E) = rng.uniform(-2, 2, (3, 6)), (pose(x) for x in rng.normal(0, 0.7, (2, 6)))
        T = B @ arm.forward(q) @ E
        data = Measured(q, T[:, :3, 3], T[:, :3, :3] if full else None, (1e-4, 1e-3), True, True)
        assert misfit(arm, data).explains(data)


@pytest.mark.parametrize("name", ["px100", "cobra600", "panda", "kr6_r700"])
def test_five_positions_find_both_ends_of_a_right_table(name):
    arm, rng = dh.load(name), np.random.default_rng(5)
    for _ in range(25):
        q, (B, E) = rng.uniform(-2, 2, (5, len(arm))), (pose(x) for x in rng.normal(0, 0.5, (2, 6)))
        p = (B @ arm.forward(q) @ E)[:, :3, 3]
        data = Measured(q, p, None, (1e-4, 1e-3), True, True)
        assert misfit(arm, data).explains(data)


@pytest.mark.slow
@pytest.mark.parametrize("free", ["base", "tool", "both"])
@pytest.mark.parametrize("full", [True, False])
def test_free_ends_against_least_squares(free, full):
    arm, rng = dh.load("ur5e"), np.random.default_rng(2)
    q = rng.uniform(-2, 2, (8, 6))
    T = dh.load("ur10e").forward(q)  # another arm: something is left over
    base, tool = free != "tool", free != "base"
    noise = (0.2, 0.3)
    data = Measured(q, T[:, :3, 3], T[:, :3, :3] if full else None, noise, base, tool)
    own = arm.forward(q)

    def residual(x):
        B, E = pose(x[:6] * base), pose(x[6:] * tool)
        P = B @ own @ E
        parts = [(P[:, :3, 3] - T[:, :3, 3]) / noise[0]]
        if full:
            parts.append(
                Rotation.from_matrix(np.swapaxes(P[:, :3, :3], 1, 2) @ T[:, :3, :3]).as_rotvec()
                / noise[1]
            )
        return np.concatenate(parts).ravel()

    best = min(
        (
            2 * least_squares(residual, x0, x_scale="jac", max_nfev=400).cost
            for x0 in rng.normal(0, 1, (12, 12))
        ),
        default=np.inf,
    )
    found = misfit(arm, data)
    assert found.chi2 <= best * (1 + 1e-6)
    assert found.chi2 == pytest.approx((data.residual(found.arm.forward(q)) ** 2).sum())


def pose(x):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = Rotation.from_rotvec(x[:3]).as_matrix(), x[3:]
    return T
