"""Bases and tools in closed form: where they are free, put where the measured poses are nearest."""

import numpy as np

from ....transform import inverse
from ...mistakes.remade import with_parts
from .measured import rotation_vectors

__all__ = ["place_ends", "carried", "rigid"]


def place_ends(arm, data):
    """The arm with the free base and tool that bring it near the measured poses."""
    if not (data.base_free or data.tool_free):
        return arm
    T = arm.forward(data.q)
    if data.R is None:
        return _placed_by_positions(arm, T, data)
    U = np.tile(np.eye(4), (len(T), 1, 1))
    U[:, :3, :3], U[:, :3, 3] = data.R, data.p
    B, E = np.eye(4), np.eye(4)
    if data.base_free and data.tool_free:
        B[:3, :3] = _aligned(T, U)
    for _ in range(10 if data.base_free and data.tool_free else 1):
        if data.tool_free:
            E = _mean(inverse(B @ T) @ U)
        if data.base_free:
            B = _mean(U @ inverse(T @ E))
    return with_parts(arm, base=rigid(B @ arm.base), tool=rigid(arm.tool @ E))


def _placed_by_positions(arm, T, data):
    """The same from positions alone: a tool point is the mean of where the measured ones are in the
    last frame, a base is carried there.
    """
    B, E = np.eye(4), np.eye(4)
    for _ in range(10 if data.base_free and data.tool_free else 1):
        if data.tool_free:
            E[:3, 3] = (
                (inverse(B @ T)[:, :3, :3] @ (data.p - (B @ T)[:, :3, 3])[..., None])[..., 0]
            ).mean(0)
        if data.base_free:
            B = _kabsch((T @ E)[:, :3, 3], data.p)
    return with_parts(arm, base=rigid(B @ arm.base), tool=arm.tool @ E)


def _kabsch(points, targets):
    """The pose that carries points to targets best (Kabsch 1976)."""
    a, b = points - points.mean(0), targets - targets.mean(0)
    U, _, Vt = np.linalg.svd(b.T @ a)
    T = np.eye(4)
    T[:3, :3] = U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt
    T[:3, 3] = targets.mean(0) - T[:3, :3] @ points.mean(0)
    return T


def carried(points, targets):
    """The squares left when each set of points (k, m, 3) is carried to the targets (m, 3) as well
    as a pose can (Kabsch 1976).
    """
    a, b = points - points.mean(1, keepdims=True), targets - targets.mean(0)
    U, s, Vt = np.linalg.svd(b.T @ a)
    s[:, 2] *= np.sign(np.linalg.det(U) * np.linalg.det(Vt))
    return (a**2).sum((1, 2)) + (b**2).sum() - 2 * s.sum(1)


def _aligned(T, U):
    """The base rotation from relative motions: conjugate rotations have rotation vectors turned by
    it.
    """
    if len(T) == 1:
        return np.eye(3)  # one pose has no motion; the tool takes it all
    a = rotation_vectors(T[1:, :3, :3] @ T[0, :3, :3].T)
    b = rotation_vectors(U[1:, :3, :3] @ U[0, :3, :3].T)
    return _kabsch(np.vstack([a, -a]), np.vstack([b, -b]))[:3, :3]


def _mean(poses):
    """The mean pose: the rotation nearest to the sum of the rotations."""
    T = np.eye(4)
    T[:3, :3] = poses[:, :3, :3].mean(0)
    T[:3, 3] = poses[:, :3, 3].mean(0)
    return rigid(T)


def rigid(T):
    """The pose nearest to a matrix whose rotation block is nearly one."""
    U, _, Vt = np.linalg.svd(T[:3, :3])
    R = U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt
    T = T.copy()
    T[:3, :3] = R
    return T
