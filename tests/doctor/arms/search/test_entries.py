"""Every number fitted by itself, all of them at once, against scipy and the elementary matrices."""

import numpy as np
import pytest
from oracles import elementary_pose
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab.doctor.arms.search.entries import fitted_one_by_one
from dhlab.doctor.arms.search.measured import Measured
from dhlab.doctor.mistakes.remade import with_rows

NOISE = 0.2, 0.3


@pytest.mark.parametrize("convention", ["standard", "craig"])
@pytest.mark.parametrize("full", [True, False])
def test_each_entry_is_fitted_as_by_least_squares(convention, full):
    rng = np.random.default_rng(7)
    rows, q = rng.uniform(-1, 1, (4, 4)), rng.uniform(-2, 2, (6, 4))
    arm = dh.Arm(getattr(dh.DHTable, convention)(rows, angle="rad", joints="RRPR"))
    off = with_rows(arm, rows + rng.normal(0, 0.02, (4, 4)))
    T = np.array([elementary_pose(off.table, one) for one in q])
    data = Measured(q, T[:, :3, 3], T[:, :3, :3] if full else None, NOISE)
    entries = [(i, k) for i in range(4) for k in range(4)]
    found = fitted_one_by_one(arm, data, dict.fromkeys(entries, 0.0), dict.fromkeys(entries, 15))

    def left(x, entry):
        moved = rows.copy()
        moved[entry] += x[0]
        table = with_rows(arm, moved).table
        U = np.array([elementary_pose(table, one) for one in q])
        way, turn = ((U - T)[:, :3, 3] / NOISE[0]), rotation_apart(U, T) / NOISE[1]
        return np.hstack([way.ravel(), turn.ravel() if full else []])

    for entry in [entries[k] for k in rng.permutation(16)[:6]]:
        wanted = least_squares(left, [0.0], args=(entry,))
        assert found[entry].chi2 == pytest.approx(2 * wanted.cost, rel=1e-5)
        felt = np.linalg.norm(wanted.jac)  # positions do not feel every angle
        assert found[entry].sigma[0] * felt == pytest.approx(float(felt > 1e-9), rel=1e-3)


def rotation_apart(U, T):
    return Rotation.from_matrix(np.swapaxes(U[:, :3, :3], 1, 2) @ T[:, :3, :3]).as_rotvec()


def test_what_is_turned_finds_back_in_many_poses():
    arm = dh.load("panda")
    q = np.random.default_rng(1).uniform(-2, 2, (700, 7))  # more than go into one product
    T = arm.forward(q)
    data = Measured(q, T[:, :3, 3], T[:, :3, :3], NOISE)
    found = fitted_one_by_one(arm, data, {(2, 0): 0.3, (3, 1): 0.1}, {(2, 0): 4, (3, 1): 15})
    assert max(fit.chi2 for fit in found.values()) < 1e-12
    assert all(np.allclose(fit.arm.table.rows, arm.table.rows, atol=1e-8) for fit in found.values())
