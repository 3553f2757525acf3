"""Bases and tools in closed form: where they are free, put where the measured poses are nearest."""

from itertools import product

import numpy as np

from ....rotations import rotation_vectors
from ....transform import inverse
from ...mistakes.remade import with_parts

__all__ = ["place_ends", "carried", "rigid"]

RADII = 0.1, 0.3, 1.0  # of the measured points' spread: how far off a tool point is looked for
AROUND = np.array([way for way in product((-1, 0, 1), repeat=3) if any(way)], float)
AROUND /= np.linalg.norm(AROUND, axis=1, keepdims=True)
STEPS, DAMPING = 8, 1e-6


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
    """The same from positions alone, which a base carries to the measured ones."""
    B, E = np.eye(4), np.eye(4)
    if data.tool_free:
        E[:3, 3] = (_point_on_base if data.base_free else _point)(T, data.p)
    if data.base_free:
        B = _kabsch((T @ E)[:, :3, 3], data.p)
    return with_parts(arm, base=rigid(B @ arm.base), tool=arm.tool @ E)


def _point(T, p):
    """The tool point (3,): the mean of where the measured ones (m, 3) are in the last frame."""
    return ((p - T[:, :3, 3])[:, None] @ T[:, :3, :3]).mean(0)[0]


def _point_on_base(T, p):
    """The tool point where the base is free too: the one that a base carries nearest to the
    measured points, of those to which Gauss-Newton steps lead from many starts. What the steps
    mend are distances between points, which no base changes.
    """
    around = np.outer(RADII, AROUND).reshape(-1, 3) * np.sqrt(p.var(0).sum())
    starts = points = np.vstack([np.zeros(3), around])
    for _ in range(STEPS):
        points = points + _nearer(T, points, p)
    points = np.vstack([starts, points])
    return points[carried(_ways(T, points), p).argmin()]


def _nearer(T, points, p):
    """The steps (k, 3) of tool points that bring the squares of distances, from each pose to the
    next two, nearer to those of the measured points.
    """
    ways, J, off = _ways(T, points), [], []
    for n in (1, 2):
        apart = ways - np.roll(ways, n, 1)
        turned = T[:, :3, :3] - np.roll(T[:, :3, :3], n, 0)
        J.append(2 * np.swapaxes(np.swapaxes(apart, 0, 1) @ turned, 0, 1))
        off.append((apart**2).sum(-1) - ((p - np.roll(p, n, 0)) ** 2).sum(-1))
    J, off = np.concatenate(J, 1), np.concatenate(off, 1)
    H = np.swapaxes(J, 1, 2) @ J
    damping = np.maximum(DAMPING * np.trace(H, axis1=1, axis2=2), np.finfo(float).tiny)
    H += damping[:, None, None] * np.eye(3)
    return -np.linalg.solve(H, np.swapaxes(J, 1, 2) @ off[..., None])[..., 0]


def _ways(T, points):
    """Where the arm takes each tool point: (k, m, 3)."""
    return T[:, :3, 3] + np.swapaxes(points @ np.swapaxes(T[:, :3, :3], 1, 2), 0, 1)


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
