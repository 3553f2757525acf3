"""Angles: the turn of one that repairs the measurements best, in closed form, and many at once."""

import numpy as np

from ...mistakes.remade import ALPHA, THETA, with_parts, with_rows
from .ends import carried, place_ends
from .fitting import fit
from .signs import entries_of

__all__ = ["STARTS", "all_offsets", "rounded_angles", "turned", "turns"]

STARTS = np.arange(12) * np.pi / 6
GRID = np.arange(24) * np.pi / 12


def turned(arm, entry, turn):
    """The arm with one angle of its table turned further."""
    rows = arm.table.rows
    rows[entry] += turn
    return with_rows(arm, rows)


def turns(arm, data):
    """For every angle of the table: (entry, the turn that repairs the measurements best, the misfit
    then left), in closed form.

    Rotations: with L the rotation of the axis' frame, N = Lᵀ R_measured R_predictedᵀ L is a turn
    about one axis if that angle is all that is wrong. Positions alone: seen from the axis' frame
    the measured ones are the predicted ones, turned about one axis; where the base is free as well,
    the turn is the best of a grid.
    """
    F = arm.frames(data.q)
    standard = arm.table.convention == "standard"
    for i in range(len(arm)):
        for column, axis in ((THETA, 2), (ALPHA, 0)):
            L = F[:, i if (column == THETA) == standard else i + 1]
            if data.R is not None:
                back = data.R @ np.swapaxes(F[:, -1, :3, :3] @ arm.tool[:3, :3], -1, -2)
                yield (i, column), *_turn_of_rotations(L[:, :3, :3], back, axis, data)
            else:
                yield (
                    (i, column),
                    *_turn_of_positions(L, (F[:, -1] @ arm.tool)[:, :3, 3], axis, data),
                )


def _turn_of_rotations(L, back, axis, data):
    N = (np.swapaxes(L, -1, -2) @ back @ L).sum(0)
    j, k = (axis + 1) % 3, (axis + 2) % 3
    s, c = N[k, j] - N[j, k], N[j, j] + N[k, k]
    return np.arctan2(s, c), (3 * len(data.q) - N[axis, axis] - np.hypot(s, c)) / data.noise[1] ** 2


def _turn_of_positions(L, ends, axis, data):
    j, k = (axis + 1) % 3, (axis + 2) % 3
    v = np.einsum("mij,mi->mj", L[:, :3, :3], ends - L[:, :3, 3])
    if data.base_free:
        c, s = np.cos(GRID)[:, None], np.sin(GRID)[:, None]
        turned_v = np.broadcast_to(v, (len(GRID), *v.shape)).copy()
        turned_v[..., j], turned_v[..., k] = c * v[:, j] - s * v[:, k], s * v[:, j] + c * v[:, k]
        around = np.swapaxes(turned_v, 0, 1) @ np.swapaxes(L[:, :3, :3], 1, 2)
        left = carried(np.swapaxes(around, 0, 1) + L[:, :3, 3], data.p)
        return GRID[np.argmin(left)], left.min() / data.noise[0] ** 2
    w = np.einsum("mij,mi->mj", L[:, :3, :3], data.p - L[:, :3, 3])
    s, c = (
        (v[:, j] * w[:, k] - v[:, k] * w[:, j]).sum(),
        (v[:, j] * w[:, j] + v[:, k] * w[:, k]).sum(),
    )
    return (
        np.arctan2(s, c),
        ((v**2).sum() + (w**2).sum() - 2 * (v[:, axis] * w[:, axis]).sum() - 2 * np.hypot(s, c))
        / data.noise[0] ** 2,
    )


def all_offsets(arm, data):
    """Several zero offsets at once: quarter turns on a grid, judged by rotation (or position), the
    best fitted.
    """
    n = len(arm)
    if n > 7 or len(data.q) < 3:
        return
    grid = np.stack(np.meshgrid(*[np.arange(4) * np.pi / 2] * (n - 1), indexing="ij"), -1).reshape(
        -1, n - 1
    )
    grid = np.column_stack([np.zeros(len(grid)), grid])
    if len(grid) > 1100:
        grid = grid[(grid > 0).sum(1) <= 4]
    joints = with_parts(arm, sign=np.ones(n), coupling=None)  # each joint by itself, offsets too
    T = joints.forward(arm.joint_values(data.q[:3]) + ~arm.table.prismatic * grid[:, None])
    free = tuple((i, THETA) for i in range(n) if arm.table.joints[i] == "R")
    for k in np.argsort(_grid_misfit(T, data))[:3]:
        rows = arm.table.rows
        rows[:, THETA] += grid[k]
        yield fit(place_ends(with_rows(arm, rows), data), data, free, steps=10), free


def rounded_angles(placed, data):
    """Angles that were written with two to four decimals of a radian: all of them fitted, kept when
    they round to what stands there.
    """
    free = entries_of(placed, (THETA, ALPHA))
    angles = np.array([placed.table.rows[e] for e in free])
    for digits in (2, 3, 4):
        if np.abs(np.round(angles, digits) - angles).max() < 1e-12 and np.abs(angles).max() > 0:
            found = fit(placed, data, free)
            fitted = np.array([found.arm.table.rows[e] for e in free])
            if np.abs(fitted - angles).max() < 0.6 * 10.0**-digits:
                yield found
            return


def _grid_misfit(T, data):
    """Misfit of a grid of arms at three poses, whatever the free base or tool; T is (grid, 3, 4,
    4).
    """
    if data.R is None:
        p = T[..., :3, 3]
        sides = np.linalg.norm(p[:, [0, 1, 2]] - p[:, [1, 2, 0]], axis=-1)
        wanted = np.linalg.norm(data.p[[0, 1, 2]] - data.p[[1, 2, 0]], axis=-1)
        return (
            ((sides - wanted) ** 2).sum(1)
            if data.base_free
            else ((p - data.p[:3]) ** 2).sum((1, 2))
        )
    R, U = T[..., :3, :3], data.R[:3]
    if data.base_free:
        R, U = np.swapaxes(R[:, :1], -1, -2) @ R, U[0].T @ U
    elif data.tool_free:
        R, U = R @ np.swapaxes(R[:, :1], -1, -2), U @ U[0].T
    return -np.einsum("gkij,kij->g", R, U)
