"""The search for the one change that repairs an arm: every entry of the catalogue, every number of
the table, signs, offsets, ends, data.
"""

from dataclasses import dataclass, replace

import numpy as np

from .datafaults import data_repairs
from .faults import ALPHA, THETA, A, D
from .fitting import Fit, Measured, carried, fit, misfit, place_ends, with_rows
from .repairs import discrete_repairs

__all__ = [
    "Explanation",
    "singles",
    "calibrated",
    "STARTS",
    "entries_of",
    "turned",
    "turns",
    "length_columns",
]

STARTS = np.arange(12) * np.pi / 6
GRID = np.arange(24) * np.pi / 12


@dataclass(frozen=True)
class Explanation:
    """A repaired arm that may explain the data.

    ``chain`` holds the arms on the way: the candidate, after the first change, (after the second).
    ``entries`` are the (row, column) that were fitted, ``ends`` names "base" or "tool" when one
    was, ``data_fault`` the mistake when the data were changed instead, to ``changed``. ``odd``
    counts fitted entries that are no number one would have guessed.
    """

    fit: Fit
    chain: tuple
    entries: tuple = ()
    ends: tuple = ()
    data_fault: tuple = None
    changed: Measured = None
    odd: int = 0

    @property
    def changes(self):
        """How many mistakes it supposes."""
        return len(self.chain) - 1 + (self.data_fault is not None)


def entries_of(arm, columns=(THETA, D, A, ALPHA)):
    """(row, column) of every number of the table."""
    return [(i, column) for i in range(len(arm)) for column in columns]


def singles(arm, data):
    """Every explanation by one change, fitting or not; the caller keeps those that fit."""
    for repair in discrete_repairs(arm):
        found = (
            fit(place_ends(repair.arm, data), data, repair.free)
            if repair.free
            else misfit(repair.arm, data)
        )
        yield Explanation(found, (arm, found.arm), repair.free)
    placed = place_ends(arm, data)
    for i, column in entries_of(arm):
        for found in _entry_fits(placed, data, i, column):
            yield Explanation(found, (arm, found.arm), ((i, column),))
    for twisted in [arm, *_signs_of_twists(arm, data)]:
        if twisted is not arm:
            found = misfit(twisted, data)
            yield Explanation(found, (arm, found.arm))
        for found in _signs_of_lengths(twisted, data):
            yield Explanation(found, (arm, found.arm))
    for found, free in _all_offsets(arm, data):
        yield Explanation(found, (arm, found.arm), free)
    for found in _rounded_angles(placed, data):
        yield Explanation(found, (arm, found.arm))
    for end in ("base", "tool"):
        if not getattr(data, f"{end}_free"):
            found = misfit(arm, replace(data, **{f"{end}_free": True}))
            yield Explanation(found, (arm, found.arm), ends=(end,))
    for fault, changed in data_repairs(data):
        yield Explanation(misfit(arm, changed), (arm,), data_fault=fault, changed=changed)


def turned(arm, entry, turn):
    """The arm with one angle of its table turned further."""
    rows = arm.table.rows
    rows[entry] += turn
    return with_rows(arm, rows)


def _entry_fits(placed, data, i, column):
    """Fits of one entry; an angle is begun where it is best, or all round, since a fit only sees
    the nearest valley.
    """
    entry = i, column
    if column in (D, A):
        return [fit(placed, data, (entry,))]
    if not data.base_free and not data.tool_free:
        turn = next(turn for e, turn, _ in turns(placed, data) if e == entry)
        return [fit(turned(placed, entry, turn), data, (entry,), steps=4)]
    trials = [misfit(turned(placed, entry, start), data) for start in STARTS]
    order = np.argsort([trial.chi2 for trial in trials])[:2]
    return [fit(trials[k].arm, data, (entry,)) for k in order]


def _signs_of_twists(arm, data):
    """Arms with other signs of several alphas (their lengths' signs open), the two that fit best:
    by rotation, with a free base by position.
    """
    twisted = np.flatnonzero(np.abs(np.sin(arm.table.alpha)) > 1e-9)
    by_position = data.R is None or data.base_free
    if (
        data.tool_free
        or not 2 <= len(twisted) <= 7
        or by_position
        and (arm.table.rows[:, 1:] < 0).any()
    ):  # lost signs leave no negative number
        return []
    trials = []
    for pattern in range(1, 2 ** len(twisted)):
        rows = arm.table.rows
        rows[twisted[[(pattern >> k) & 1 == 1 for k in range(len(twisted))]], ALPHA] *= -1
        trial = with_rows(arm, rows)
        trials.append(
            (
                (
                    min(_length_signs(trial, data)[2], default=np.inf)
                    if by_position
                    else _rotation_apart(trial, data)
                ),
                pattern,
                trial,
            )
        )
    return [trial for _, _, trial in sorted(trials, key=lambda item: item[:2])[:2]]


def _rotation_apart(arm, data):
    R = arm.frames(data.q[:3])[:, -1, :3, :3] @ arm.tool[:3, :3]
    return -np.einsum("kij,kij->", R, data.R[:3])


def _signs_of_lengths(arm, data):
    """All lengths with other signs, the two patterns that fit best."""
    entries, patterns, misfits = _length_signs(arm, data)
    for k in np.argsort(misfits)[:2]:
        rows = arm.table.rows
        for e, sign in zip(entries, patterns[k]):
            rows[e] *= sign
        yield misfit(with_rows(arm, rows), data)


def _length_signs(arm, data):
    """The lengths, every pattern of their signs and its misfit: positions are linear in lengths, so
    every pattern is one matrix product.
    """
    entries = [
        e
        for e in entries_of(arm, (D, A))
        if arm.table.rows[e] and not (e[1] == D and arm.table.joints[e[0]] == "P")
    ]
    if data.tool_free or not 2 <= len(entries) <= 12:
        return [], [], []
    columns, off = length_columns(arm, data, entries)
    lengths = np.array([arm.table.rows[e] for e in entries])
    patterns = 1 - 2 * ((np.arange(2 ** len(entries))[:, None] >> np.arange(len(entries))) & 1)
    offs = off + (patterns - 1) * lengths @ columns.T
    targets = data.p / data.noise[0]
    return (
        entries,
        patterns,
        (
            carried(offs.reshape(len(offs), -1, 3) + targets, targets)
            if data.base_free
            else (offs**2).sum(1)
        ),
    )


def length_columns(arm, data, entries):
    """How the positions move with each length (3m, k) and how far they are off now (3m,), in units
    of the noise.
    """
    F = arm.frames(data.q)
    standard = arm.table.convention == "standard"
    axes = [F[:, i if (c == D) == standard else i + 1, :3, 2 if c == D else 0] for i, c in entries]
    off = ((F[:, -1] @ arm.tool)[:, :3, 3] - data.p) / data.noise[0]
    return np.stack([axis.reshape(-1) for axis in axes], axis=1) / data.noise[0], off.reshape(-1)


def _all_offsets(arm, data):
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
    T = arm.forward(data.q[:3] + (arm.sign * ~arm.table.prismatic) * grid[:, None])
    free = tuple((i, THETA) for i in range(n) if arm.table.joints[i] == "R")
    for k in np.argsort(_grid_misfit(T, data))[:3]:
        rows = arm.table.rows
        rows[:, THETA] += grid[k]
        yield fit(place_ends(with_rows(arm, rows), data), data, free, steps=10), free


def _rounded_angles(placed, data):
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
        left = carried(np.einsum("mij,gmj->gmi", L[:, :3, :3], turned_v) + L[:, :3, 3], data.p)
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


def calibrated(arm, data, prior=None):
    """The fit of every entry at once, begun at the arm: what a factory calibration does; ``prior``
    as in ``fit``.
    """
    return fit(place_ends(arm, data), data, entries_of(arm), steps=25, prior=prior)
