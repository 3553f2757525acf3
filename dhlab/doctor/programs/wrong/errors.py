"""Wrong versions of the pose error: what a learner's function computes when one thing is wrong.

Each entry of :data:`WRONG_ERRORS` is ``(mistake, place, function)``, a function of ``T`` and
``T_goal`` (4, 4); metres and radians.
"""

import numpy as np

from ....rotations import rotation_vectors
from ....transform import from_xyz_rpy
from .versions import Versions

__all__ = ["pose_error", "WRONG_ERRORS"]

DEG = 180 / np.pi


def pose_error(T, T_goal):
    """The right one: p_goal − p, then the rotation vector of R_goal Rᵀ; both in the base's axes.

    Examples
    --------
    >>> from dhlab.transform import rot_z
    >>> pose_error(np.eye(4), rot_z(0.3)).round(6)
    array([0. , 0. , 0. , 0. , 0. , 0.3])
    """
    return _error(T, T_goal)


def _error(
    T,
    T_goal,
    way=lambda R, R_goal, p, p_goal: p_goal - p,
    turn=lambda R, R_goal: rotation_vectors(R_goal @ R.T),
):
    R, R_goal = T[:3, :3], T_goal[:3, :3]
    return np.concatenate([way(R, R_goal, T[:3, 3], T_goal[:3, 3]), turn(R, R_goal)])


def _made(**parts):
    return lambda T, T_goal: _error(T, T_goal, **parts)


def _changed(change):
    return lambda T, T_goal: change(_error(T, T_goal))


def _skew(A):
    """The vector in the antisymmetric part of a 3×3 block."""
    return np.array([A[2, 1] - A[1, 2], A[0, 2] - A[2, 0], A[1, 0] - A[0, 1]]) / 2


def _quaternion(R):
    """Its vector part, with w positive."""
    vector = rotation_vectors(R)
    return vector / 2 * np.sinc(np.linalg.norm(vector) / (2 * np.pi))


def _angles(order):
    def differ(R, R_goal):
        from scipy.spatial.transform import Rotation

        return Rotation.from_matrix(R_goal).as_euler(order) - Rotation.from_matrix(R).as_euler(
            order
        )

    return differ


def _angles_of_the_turn(R, R_goal):
    from scipy.spatial.transform import Rotation

    return Rotation.from_matrix(R_goal @ R.T).as_euler("xyz")


def _backwards(way, turn):
    return lambda e: np.concatenate([way * e[:3], turn * e[3:]])


_TOOL_TURN = {"turn": lambda R, R_goal: rotation_vectors(R.T @ R_goal)}
_TOOL_WAY = {"way": lambda R, R_goal, p, p_goal: R.T @ (p_goal - p)}

_ALL = [
    ("error-sign", "all six: the way back from the goal", _changed(_backwards(-1, -1))),
    ("error-sign", "the position", _changed(_backwards(-1, 1))),
    ("error-sign", "the orientation", _changed(_backwards(1, -1))),
    ("orientation-error-frame", "the orientation is in the tool's axes", _made(**_TOOL_TURN)),
    (
        "orientation-error-frame",
        "the orientation is R_goalᵀ R, the way back in the goal's axes",
        _made(turn=lambda R, R_goal: rotation_vectors(R_goal.T @ R)),
    ),
    ("orientation-error-frame", "the position is in the tool's axes", _made(**_TOOL_WAY)),
    ("orientation-error-frame", "both are in the tool's axes", _made(**_TOOL_WAY, **_TOOL_TURN)),
    (
        "orientation-error-frame",
        "the position is in the goal's axes",
        _made(way=lambda R, R_goal, p, p_goal: R_goal.T @ (p_goal - p)),
    ),
    (
        "pose-inverted",
        "a transpose is missing: R_goal R where R_goal Rᵀ belongs",
        _made(turn=lambda R, R_goal: rotation_vectors(R_goal @ R)),
    ),
    (
        "pose-inverted",
        "a transpose is missing: R R_goal",
        _made(turn=lambda R, R_goal: rotation_vectors(R @ R_goal)),
    ),
    ("rotation-difference", "", _made(turn=lambda R, R_goal: _skew(R_goal - R))),
    (
        "rotation-difference",
        "twice the antisymmetric part",
        _made(turn=lambda R, R_goal: 2 * _skew(R_goal - R)),
    ),
    (
        "rotation-difference",
        "the x arrows subtracted",
        _made(turn=lambda R, R_goal: (R_goal - R)[:, 0]),
    ),
    (
        "rotation-difference",
        "the z arrows subtracted",
        _made(turn=lambda R, R_goal: (R_goal - R)[:, 2]),
    ),
    (
        "rotation-difference",
        "the diagonals subtracted",
        _made(turn=lambda R, R_goal: np.diag(R_goal - R)),
    ),
    ("angles-subtracted", "roll, pitch, yaw", _made(turn=_angles("xyz"))),
    ("angles-subtracted", "yaw, pitch, roll", _made(turn=_angles("ZYX"))),
    (
        "angles-subtracted",
        "rotation vectors",
        _made(turn=lambda R, R_goal: rotation_vectors(R_goal) - rotation_vectors(R)),
    ),
    (
        "rotation-vector-misread",
        "roll, pitch, yaw of the turn, not its rotation vector",
        _made(turn=_angles_of_the_turn),
    ),
    (
        "rotation-vector-misread",
        "the sine of the angle, not the angle",
        _made(turn=lambda R, R_goal: _skew(R_goal @ R.T)),
    ),
    (
        "rotation-vector-misread",
        "twice the sine of the angle, not the angle",
        _made(turn=lambda R, R_goal: 2 * _skew(R_goal @ R.T)),
    ),
    (
        "rotation-vector-misread",
        "the vector part of the quaternion",
        _made(turn=lambda R, R_goal: _quaternion(R_goal @ R.T)),
    ),
    (
        "rotation-vector-misread",
        "the axis alone, without the angle",
        _made(
            turn=lambda R, R_goal: (
                rotation_vectors(R_goal @ R.T) / np.linalg.norm(rotation_vectors(R_goal @ R.T))
            )
        ),
    ),
    (
        "rotation-vector-misread",
        "only the z arrows are compared",
        _made(turn=lambda R, R_goal: np.cross(R[:, 2], R_goal[:, 2])),
    ),
    ("jacobian-rows-exchanged", "", _changed(lambda e: np.roll(e, 3))),
    ("angular-part-missing", "", _changed(_backwards(1, 0))),
    ("degrees-for-radians", "the orientation", _changed(_backwards(1, DEG))),
    ("length-unit", "the position is in mm", _changed(_backwards(1000, 1))),
    (
        "wrong-frame-compared",
        "this is the goal itself, not the way to it",
        _made(
            way=lambda R, R_goal, p, p_goal: p_goal, turn=lambda R, R_goal: rotation_vectors(R_goal)
        ),
    ),
    ("integer-arrays", "", _changed(np.trunc)),
]


def _sample():
    """Two general poses."""
    return from_xyz_rpy([0.6] * 3, [0.4, -0.7, 1.1]), from_xyz_rpy([0.9] * 3, [1.0, 0.5, -2.3])


WRONG_ERRORS = Versions(lambda: _ALL, _sample)
