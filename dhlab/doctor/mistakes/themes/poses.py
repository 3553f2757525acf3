"""Poses, as a program answers them or as they were measured: inverse, transposed, without their
last row, no poses at all, their angles or quaternions in another order.
"""

import warnings

import numpy as np
from scipy.spatial.transform import Rotation

from ....kinematics import link_matrices
from ....transform import pose_fault
from ..changes import MeasuredChange, PoseChange, Slip, Symptom
from ..registry import mistake


@mistake("pose-inverted")
def pose_inverted():
    yield PoseChange(_inverse, measured="the measured poses are inverse")


def _inverse(T):
    with np.errstate(all="ignore"):
        return (
            np.linalg.inv(T)
            if np.all(np.abs(np.linalg.det(T)) > 1e-12)
            else np.full_like(T, np.nan)
        )


@mistake("rotation-transposed")
def rotation_transposed():
    yield PoseChange(_rotation_transposed, measured="the measured rotations are transposed")


def _rotation_transposed(T):
    T = T.copy()
    T[..., :3, :3] = np.swapaxes(T[..., :3, :3], -1, -2).copy()
    return T


@mistake("matrix-transposed")
def matrix_transposed():
    yield PoseChange(lambda T: np.swapaxes(T, -1, -2))


@mistake("last-row-missing")
def last_row_missing():
    yield PoseChange(lambda T: T * np.array([1, 1, 1, 0])[:, None])
    yield PoseChange(_with_ones_below, "1 1 1 1 stands there")
    yield Symptom(_rest_right, explains=True)


def _with_ones_below(T):
    return np.concatenate([T[..., :3, :], np.ones_like(T[..., :1, :])], axis=-2)


def _rest_right(answers, right):
    rest = answers[..., :3, :], right[..., :3, :]
    return "" if np.allclose(*rest, rtol=1e-9, atol=1e-9) else None


@mistake("mirror")
def mirror():
    for j in range(3):
        turned = np.where(np.arange(4) == j, [[-1], [-1], [-1], [1]], 1)
        yield Slip(
            "link",
            f"column {j + 1} points the other way",
            lambda *row, turned=turned: link_matrices("standard", *row) * turned,
        )
    yield Symptom(_fault_is("determinant"), alone=True)


@mistake("last-row-wrong")
def last_row_wrong():
    yield Symptom(_fault_is("last row"), alone=True)


@mistake("not-rigid")
def not_rigid():
    yield Symptom(_fault_is("rigid"), alone=True)


def _fault_is(word):
    """Whether this is what makes the answers no poses: a word of :func:`pose_fault`."""
    return lambda T, right: "" if word in (pose_fault(T) or "") else None


# ---- orientations that were written down


def _reread(place, again):
    """A rotation that was read otherwise than it was written: ``again`` makes the right one."""

    def repair(q, p, R):
        with warnings.catch_warnings():  # where roll and yaw are one, scipy takes yaw for 0
            warnings.simplefilter("ignore", UserWarning)
            return q, p, again(Rotation.from_matrix(R)).as_matrix()

    return MeasuredChange(lambda n: [(None, place, repair)], rotations=True)


@mistake("quaternion-order")
def quaternion_order():
    for place, order in (("w was taken for x", [1, 2, 3, 0]), ("x was taken for w", [3, 0, 1, 2])):
        yield _reread(place, lambda R, order=order: Rotation.from_quat(R.as_quat()[:, order]))


@mistake("rpy-order")
def rpy_order():
    mixed = "fixed and moving axes mixed up"
    yield _reread(mixed, lambda R: Rotation.from_euler("XYZ", R.as_euler("xyz")))
    yield _reread(mixed, lambda R: Rotation.from_euler("xyz", R.as_euler("XYZ")))
    yield _reread(
        "roll, pitch, yaw were read as a rotation vector",
        lambda R: Rotation.from_euler("xyz", R.as_rotvec()),
    )
    yield _reread(
        "a rotation vector was read as roll, pitch, yaw",
        lambda R: Rotation.from_rotvec(R.as_euler("xyz")),
    )


@mistake("roll-yaw-exchanged")
def roll_yaw_exchanged():
    yield _reread("", lambda R: Rotation.from_euler("xyz", R.as_euler("xyz")[:, ::-1]))
