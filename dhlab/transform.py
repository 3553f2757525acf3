"""4×4 poses: the elementary moves, the inverse, and the test that a matrix is a pose.

A pose ``T_ab`` is frame b written in frame a: its upper left 3×3 block holds b's axes as columns,
its last column b's origin. Every function takes numbers or arrays of any leading shape and returns
``(..., 4, 4)``. Angles are radians, lengths metres.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "rot_x",
    "rot_y",
    "rot_z",
    "trans",
    "trans_x",
    "trans_z",
    "inverse",
    "from_xyz_rpy",
    "to_xyz_rpy",
    "pose_fault",
    "require_pose",
]

IDENTITY = np.eye(4)
RIGID_TOLERANCE = 1e-6  # a pose typed with seven digits passes, one with four does not


def rot_x(angle: ArrayLike) -> NDArray[np.float64]:
    """Turn about x.

    Parameters
    ----------
    angle : float or array (...)
        Radians, counter-clockwise seen against the axis.

    Returns
    -------
    array (..., 4, 4)

    Examples
    --------
    >>> rot_x(np.pi / 2)[:3, 1].round(6) + 0.0
    array([0., 0., 1.])
    """
    return _rotation(angle, 1, 2)


def rot_y(angle: ArrayLike) -> NDArray[np.float64]:
    """Turn about y; arguments and result as :func:`rot_x`.

    Examples
    --------
    >>> rot_y(np.pi / 2)[:3, 2].round(6) + 0.0
    array([1., 0., 0.])
    """
    return _rotation(angle, 2, 0)


def rot_z(angle: ArrayLike) -> NDArray[np.float64]:
    """Turn about z; arguments and result as :func:`rot_x`.

    Examples
    --------
    >>> rot_z(np.pi / 2)[:3, 0].round(6) + 0.0
    array([0., 1., 0.])
    """
    return _rotation(angle, 0, 1)


def _rotation(angle: ArrayLike, j: int, k: int) -> NDArray[np.float64]:
    """The turn that carries axis j towards axis k."""
    angle = np.asarray(angle, dtype=float)
    c, s = np.cos(angle), np.sin(angle)
    T = _identity(angle.shape)
    T[..., j, j], T[..., j, k] = c, -s
    T[..., k, j], T[..., k, k] = s, c
    return T


def trans(xyz: ArrayLike) -> NDArray[np.float64]:
    """Shift by a vector.

    Parameters
    ----------
    xyz : array (..., 3)
        Metres.

    Returns
    -------
    array (..., 4, 4)

    Examples
    --------
    >>> trans([1, 2, 3])[:3, 3]
    array([1., 2., 3.])
    """
    xyz = np.asarray(xyz, dtype=float)
    if xyz.shape[-1:] != (3,):
        raise ValueError(
            f"trans: expected three lengths (x, y, z), found shape {xyz.shape}; give an array whose"
            " last axis is 3"
        )
    T = _identity(xyz.shape[:-1])
    T[..., :3, 3] = xyz
    return T


def trans_x(length: ArrayLike) -> NDArray[np.float64]:
    """Shift along x by ``length`` (...), metres; returns (..., 4, 4).

    Examples
    --------
    >>> trans_x(0.4)[0, 3]
    np.float64(0.4)
    """
    return _shift(length, 0)


def trans_z(length: ArrayLike) -> NDArray[np.float64]:
    """Shift along z by ``length`` (...), metres; returns (..., 4, 4).

    Examples
    --------
    >>> trans_z(0.1)[2, 3]
    np.float64(0.1)
    """
    return _shift(length, 2)


def _shift(length: ArrayLike, axis: int) -> NDArray[np.float64]:
    length = np.asarray(length, dtype=float)
    T = _identity(length.shape)
    T[..., axis, 3] = length
    return T


def _identity(shape: tuple[int, ...]) -> NDArray[np.float64]:
    T = np.empty((*shape, 4, 4))
    T[...] = IDENTITY
    return T


def inverse(T_ab: ArrayLike) -> NDArray[np.float64]:
    """The pose of a in b from the pose of b in a: the rotation transposed, the shift turned back
    and reversed.

    Parameters
    ----------
    T_ab : array (..., 4, 4)
        Poses.

    Returns
    -------
    array (..., 4, 4)

    Examples
    --------
    >>> T = rot_z(0.3) @ trans([1, 2, 3])
    >>> bool(np.allclose(inverse(T) @ T, np.eye(4)))
    True
    """
    T_ab = np.asarray(T_ab, dtype=float)
    R_ba = np.swapaxes(T_ab[..., :3, :3], -1, -2)
    T_ba = np.zeros_like(T_ab)
    T_ba[..., :3, :3] = R_ba
    T_ba[..., :3, 3] = -(R_ba @ T_ab[..., :3, 3:])[..., 0]
    T_ba[..., 3, 3] = 1.0
    return T_ba


def from_xyz_rpy(xyz: ArrayLike, rpy: ArrayLike) -> NDArray[np.float64]:
    """Pose from a shift and roll, pitch, yaw about fixed x, y, z, in this order (as URDF has it).

    Parameters
    ----------
    xyz : array (..., 3)
        Metres.
    rpy : array (..., 3)
        Radians.

    Returns
    -------
    array (..., 4, 4)
        ``trans(xyz) @ rot_z(yaw) @ rot_y(pitch) @ rot_x(roll)``.

    Examples
    --------
    >>> from_xyz_rpy([0, 0, 1], [0, 0, np.pi / 2])[:3, 0].round(6) + 0.0
    array([0., 1., 0.])
    """
    roll, pitch, yaw = np.moveaxis(np.asarray(rpy, dtype=float), -1, 0)
    return trans(xyz) @ rot_z(yaw) @ rot_y(pitch) @ rot_x(roll)


def to_xyz_rpy(T: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Shift and roll, pitch, yaw (fixed axes) of a pose; at pitch ±90°, where only yaw ∓ roll is
    known, yaw is set to 0.

    Parameters
    ----------
    T : array (4, 4)

    Returns
    -------
    xyz, rpy : arrays (3,)
        Metres, radians; :func:`from_xyz_rpy` gives T back.

    Examples
    --------
    >>> xyz, rpy = to_xyz_rpy(from_xyz_rpy([1, 2, 3], [0.1, 0.2, 0.3]))
    >>> rpy.round(9)
    array([0.1, 0.2, 0.3])
    """
    T = np.asarray(T, dtype=float)
    R = T[:3, :3]
    across = np.hypot(R[0, 0], R[1, 0])
    yaw = np.arctan2(R[1, 0], R[0, 0]) if across > 1e-15 else 0.0
    pitch = np.arctan2(-R[2, 0], across)
    c, s = np.cos(yaw), np.sin(yaw)
    # of what is left once yaw is taken off
    roll = np.arctan2(s * R[0, 2] - c * R[1, 2], c * R[1, 1] - s * R[0, 1])
    return T[:3, 3].copy(), np.array([roll, pitch, yaw])


def pose_fault(T: ArrayLike, tolerance: float = RIGID_TOLERANCE) -> str | None:
    """What keeps a matrix from being a pose, in words; ``None`` when nothing does.

    Parameters
    ----------
    T : array
        Anything that might be a pose or a batch of poses (..., 4, 4).
    tolerance : float
        Largest deviation allowed in RᵀR − 1 and in the last row.

    Returns
    -------
    str or None

    Examples
    --------
    >>> pose_fault(np.diag([1, 1, -1, 1]))
    'its rotation block is a mirror (determinant -1): one axis points the wrong way'
    >>> pose_fault(np.eye(4)) is None
    True
    """
    T = np.asarray(T)
    if T.shape[-2:] != (4, 4):
        return f"its shape is {T.shape}, not 4×4"
    if T.dtype.kind not in "iuf":
        return "it holds something other than real numbers"
    if not np.isfinite(T).all():
        return "it holds NaN or infinity"
    if np.abs(T[..., 3, :] - [0, 0, 0, 1]).max(initial=0) > tolerance:
        return "its last row is not 0 0 0 1"
    R = T[..., :3, :3]
    worst = np.abs(np.swapaxes(R, -1, -2) @ R - np.eye(3)).max(initial=0)
    if worst > tolerance:
        return (
            f"its rotation block is not rigid: RᵀR differs from 1 by {worst:.2g} (axes must be unit"
            " vectors at right angles)"
        )
    if (np.linalg.det(R) < 0).any():
        return "its rotation block is a mirror (determinant -1): one axis points the wrong way"
    return None


def require_pose(T: ArrayLike, name: str) -> NDArray[np.float64]:
    """``T`` as a float array when it is one pose (4, 4); otherwise a ValueError that says what is
    wrong with ``name``.

    Examples
    --------
    >>> require_pose(np.zeros((3, 3)), "tool")
    Traceback (most recent call last):
    ...
    ValueError: tool: expected a 4×4 pose, but its shape is (3, 3), not 4×4; build one with
    dhlab.transform (trans, rot_z, ...)
    """
    try:
        array = np.array(T, dtype=float)
    except (TypeError, ValueError):
        array = np.array(None)
    fault = f"its shape is {array.shape}, not 4×4" if array.shape != (4, 4) else pose_fault(array)
    if fault:
        raise ValueError(
            f"{name}: expected a 4×4 pose, but {fault}; build one with dhlab.transform (trans,"
            " rot_z, ...)"
        )
    return array
