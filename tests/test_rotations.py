"""Rotation vectors against scipy's, which goes by quaternions."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from dhlab.rotations import from_rotation_vectors, rotation_vectors

AXES = Rotation.random(40, random_state=3).as_matrix()[:, 0]
ANGLES = [0, 1e-12, 1e-7, 0.3, 2.5, 3.0, np.pi - 1e-3, np.pi - 1e-9]


@pytest.mark.parametrize("angle", ANGLES)
def test_there_and_back(angle):
    expected = Rotation.from_rotvec(angle * AXES)
    assert abs(from_rotation_vectors(angle * AXES) - expected.as_matrix()).max() < 1e-15
    found = rotation_vectors(expected.as_matrix())
    assert abs(found - angle * AXES).max() < 1e-8 * angle + 1e-15


def test_one_rotation_as_in_a_batch():
    R = Rotation.from_rotvec([[0.1, 0.2, 0.3], [3.0, 0.5, -0.4]]).as_matrix()
    for one, vector in zip(R, rotation_vectors(R[None])[0]):
        assert np.array_equal(rotation_vectors(one), vector)
        assert np.array_equal(from_rotation_vectors(vector), from_rotation_vectors([vector])[0])


def test_exactly_half_a_turn_about_each_axis():
    R = np.stack([np.diag(row) for row in ([1.0, -1, -1], [-1.0, 1, -1], [-1.0, -1, 1])])
    assert np.allclose(abs(rotation_vectors(R)), np.pi * np.eye(3), rtol=0, atol=1e-15)
