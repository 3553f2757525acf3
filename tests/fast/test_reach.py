"""Workspace and manipulability, against what geometry says of arms worked out by hand."""

import numpy as np
import pytest
from cases import fanuc

import dhlab as dh
from dhlab import view


def planar(*lengths, limits=None):
    rows = [[0, 0, a, 0] for a in lengths]
    return dh.Arm(dh.DHTable.standard(rows, angle="deg"), limits=limits)


def test_a_planar_arm_reaches_a_ring():
    points = planar(0.5, 0.3).workspace(20_000, seed=1)
    out = np.linalg.norm(points[:, :2], axis=1)
    assert points.shape == (20_000, 3)
    assert not points[:, 2].any()
    assert 0.2 - 1e-12 < out.min() < 0.201
    assert 0.799 < out.max() < 0.8 + 1e-12


def test_limits_are_kept_and_seeds_repeat():
    arm = planar(0.5, limits=[(0.0, 1.0)])
    points = arm.workspace(1000, seed=3)
    angles = np.arctan2(points[:, 1], points[:, 0])
    assert 0 <= angles.min() < 0.01
    assert 0.99 < angles.max() <= 1
    assert np.array_equal(points, arm.workspace(1000, seed=3))
    assert not np.array_equal(points, arm.workspace(1000, seed=4))


def test_limits_are_of_what_is_counted():
    arm = fanuc()
    q = np.random.default_rng(5).uniform(-2, 2, (500, 6))
    assert np.allclose(arm.workspace(500, seed=5), arm.forward(q)[:, :3, 3])


def test_a_sliding_joint_needs_limits():
    table = dh.load("stanford").table
    with pytest.raises(ValueError, match="joint 3 slides and states no limits"):
        dh.Arm(table).workspace(10)
    for bad in (0, 1.5, "many", True):
        with pytest.raises(ValueError, match="expected how many samples"):
            dh.load("ur5e").workspace(bad)


def test_manipulability_of_a_planar_arm_is_the_area_of_its_links():
    arm, q = planar(0.5, 0.3), np.linspace(-3, 3, 50)
    w = arm.manipulability(np.stack([np.zeros(50), q], axis=1))
    # v alone spans a1 a2 |sin q2| (Yoshikawa 1985, section 5); the turning about z adds its share
    J = arm.jacobian(np.stack([np.zeros(50), q], axis=1))
    planar_part = np.abs(np.linalg.det(J[:, :2]))
    assert np.allclose(planar_part, 0.15 * np.abs(np.sin(q)))
    gram = np.swapaxes(J, 1, 2) @ J
    assert np.allclose(w, np.sqrt(np.linalg.det(gram)))


def test_manipulability_is_the_root_of_a_determinant():
    for name in ("ur5e", "panda"):
        arm = dh.load(name)
        q = np.random.default_rng(0).uniform(-2, 2, (20, len(arm)))
        J = arm.jacobian(q)
        right = np.sqrt(np.linalg.det(J @ np.swapaxes(J, 1, 2)))
        assert np.allclose(arm.manipulability(q), right, rtol=1e-8, atol=1e-12)
        assert np.ndim(arm.manipulability(q[0])) == 0


def test_the_picture_of_reach():
    picture = view.workspace(dh.load("cobra600"), 5000)
    assert "z" in picture.table
    assert len(picture.figure.axes) == 2
    assert len(picture.points["end"]) == 5000
    low, high = picture.points["end"][:, 2].min(), picture.points["end"][:, 2].max()
    assert f"{low:.3f}".rstrip("0") in picture.table
    assert f"{high:.3f}".rstrip("0") in picture.table
    with pytest.raises(ValueError, match="expected an Arm first"):
        view.workspace(dh.load("ur5e").table)
