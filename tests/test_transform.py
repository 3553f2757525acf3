"""Elementary moves against scipy's rotations; what is and what is no pose."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from dhlab import transform


def test_turns_are_scipys():
    for axis, move in (("x", transform.rot_x), ("y", transform.rot_y), ("z", transform.rot_z)):
        angles = np.random.default_rng(0).uniform(-7, 7, (3, 4))
        wanted = Rotation.from_euler(axis, angles.reshape(-1, 1)).as_matrix().reshape(3, 4, 3, 3)
        assert np.allclose(move(angles)[..., :3, :3], wanted, atol=1e-15)
        assert np.array_equal(move(angles)[..., 3, :], np.broadcast_to([0, 0, 0, 1], (3, 4, 4)))


def test_roll_pitch_yaw_is_fixed_axis_and_comes_back():
    rng = np.random.default_rng(1)
    for pitch in (*rng.uniform(-1.5, 1.5, 20), np.pi / 2, -np.pi / 2, np.pi / 2 - 1e-9):
        xyz, rpy = rng.uniform(-1, 1, 3), [rng.uniform(-3, 3), pitch, rng.uniform(-3, 3)]
        T = transform.from_xyz_rpy(xyz, rpy)
        assert np.allclose(
            T[:3, :3], Rotation.from_euler("xyz", rpy).as_matrix(), atol=1e-15
        ) and np.array_equal(T[:3, 3], xyz)
        assert np.abs(transform.from_xyz_rpy(*transform.to_xyz_rpy(T)) - T).max() < 2e-15


def test_inverse_of_a_batch():
    T = transform.from_xyz_rpy(
        np.random.default_rng(2).uniform(-1, 1, (5, 2, 3)),
        np.random.default_rng(3).uniform(-3, 3, (5, 2, 3)),
    )
    assert np.allclose(transform.inverse(T), np.linalg.inv(T), atol=1e-14)


@pytest.mark.parametrize(
    "T, words",
    [
        (np.eye(3), "shape"),
        (np.diag([1, 1, -1, 1]), "mirror"),
        (np.diag([1, 1, 2, 1]), "not rigid"),
        (np.eye(4) * [[1], [1], [1], [0]], "last row"),
        (np.full((4, 4), np.nan), "NaN"),
        (np.eye(4, dtype=complex), "real"),
    ],
)
def test_what_is_no_pose(T, words):
    assert words in transform.pose_fault(T)
    assert transform.pose_fault(np.eye(4)) is None


def test_a_shift_wants_three_lengths():
    with pytest.raises(ValueError, match="three lengths"):
        transform.trans([1, 2])
