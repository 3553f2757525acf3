"""The search for what repairs an arm: one change, then two; lengths by linear least squares, angles in closed form."""

from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from .datafaults import data_repairs
from .faults import A, ALPHA, D, THETA
from .fitting import Fit, carried, fit, limit, misfit, place_ends, with_rows
from .repairs import discrete_repairs

__all__ = ["Explanation", "singles", "pairs", "calibrated"]

STARTS = np.arange(12) * np.pi / 6
KEEP = 24  # how many of the best starts of two angles are fitted to the end


@dataclass(frozen=True)
class Explanation:
    """A repaired arm that may explain the data.

    ``chain`` holds the arms on the way: the candidate, after the first change, (after the second). ``entries`` are the (row, column)
    that were fitted, ``ends`` names "base" or "tool" when one was, ``data_fault`` the mistake when the data were changed instead.
    ``odd`` counts fitted entries that are no number one would have guessed.
    """

    fit: Fit
    chain: tuple
    entries: tuple = ()
    ends: tuple = ()
    data_fault: tuple = None
    odd: int = 0

    @property
    def changes(self):
        """How many mistakes it supposes."""
        return len(self.chain) - 1 + (self.data_fault is not None)


def _entries(arm, columns=(THETA, D, A, ALPHA)):
    return [(i, column) for i in range(len(arm)) for column in columns]


def singles(arm, data):
    """Every explanation by one change, fitting or not; the caller keeps those that fit."""
    for repair in discrete_repairs(arm):
        found = fit(place_ends(repair.arm, data), data, repair.free) if repair.free else misfit(repair.arm, data)
        yield Explanation(found, (arm, found.arm), repair.free)
    placed = place_ends(arm, data)
    for i, column in _entries(arm):
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
        yield Explanation(misfit(arm, changed), (arm,), data_fault=fault)


def _turned(arm, entry, turn):
    rows = arm.table.rows
    rows[entry] += turn
    return with_rows(arm, rows)


def _entry_fits(placed, data, i, column):
    """Fits of one entry; an angle is begun where it is best, or all round, since a fit only sees the nearest valley."""
    entry = i, column
    if column in (D, A):
        return [fit(placed, data, (entry,))]
    if data.R is not None and not data.base_free and not data.tool_free:
        turn = next(turn for e, turn, _ in _turns(placed, data) if e == entry)
        return [fit(_turned(placed, entry, turn), data, (entry,), steps=4)]
    trials = [misfit(_turned(placed, entry, start), data) for start in STARTS]
    order = np.argsort([trial.chi2 for trial in trials])[:2]
    return [fit(trials[k].arm, data, (entry,)) for k in order]


def _signs_of_twists(arm, data):
    """Arms with other signs of several alphas (their lengths' signs open), the two that fit best: by rotation, with a free base by position."""
    twisted = np.flatnonzero(np.abs(np.sin(arm.table.alpha)) > 1e-9)
    by_position = data.R is None or data.base_free
    if data.tool_free or not 2 <= len(twisted) <= 7 or by_position and (arm.table.rows[:, 1:] < 0).any():  # lost signs leave no negative number
        return []
    trials = []
    for pattern in range(1, 2 ** len(twisted)):
        rows = arm.table.rows
        rows[twisted[[(pattern >> k) & 1 == 1 for k in range(len(twisted))]], ALPHA] *= -1
        trial = with_rows(arm, rows)
        trials.append((min(_length_signs(trial, data)[2], default=np.inf) if by_position else _rotation_apart(trial, data), pattern, trial))
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
    """The lengths, every pattern of their signs and its misfit: positions are linear in lengths, so every pattern is one matrix product."""
    entries = [e for e in _entries(arm, (D, A)) if arm.table.rows[e] and not (e[1] == D and arm.table.joints[e[0]] == "P")]
    if data.tool_free or not 2 <= len(entries) <= 12:
        return [], [], []
    columns, off = _length_columns(arm, data, entries)
    lengths = np.array([arm.table.rows[e] for e in entries])
    patterns = 1 - 2 * ((np.arange(2 ** len(entries))[:, None] >> np.arange(len(entries))) & 1)
    offs = off + (patterns - 1) * lengths @ columns.T
    targets = data.p / data.noise[0]
    return entries, patterns, carried(offs.reshape(len(offs), -1, 3) + targets, targets) if data.base_free else (offs**2).sum(1)


def _length_columns(arm, data, entries):
    """How the positions move with each length (3m, k) and how far they are off now (3m,), in units of the noise."""
    F = arm.frames(data.q)
    standard = arm.table.convention == "standard"
    axes = [F[:, i if (c == D) == standard else i + 1, :3, 2 if c == D else 0] for i, c in entries]
    off = ((F[:, -1] @ arm.tool)[:, :3, 3] - data.p) / data.noise[0]
    return np.stack([axis.reshape(-1) for axis in axes], axis=1) / data.noise[0], off.reshape(-1)


def _all_offsets(arm, data):
    """Several zero offsets at once: quarter turns on a grid, judged by rotation (or position), the best fitted."""
    n = len(arm)
    if n > 7 or len(data.q) < 3:
        return
    grid = np.stack(np.meshgrid(*[np.arange(4) * np.pi / 2] * (n - 1), indexing="ij"), -1).reshape(-1, n - 1)
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
    """Angles that were written with two to four decimals of a radian: all of them fitted, kept when they round to what stands there."""
    free = _entries(placed, (THETA, ALPHA))
    angles = np.array([placed.table.rows[e] for e in free])
    for digits in (2, 3, 4):
        if np.abs(np.round(angles, digits) - angles).max() < 1e-12 and np.abs(angles).max() > 0:
            found = fit(placed, data, free)
            fitted = np.array([found.arm.table.rows[e] for e in free])
            if np.abs(fitted - angles).max() < 0.6 * 10.0**-digits:
                yield found
            return


def _grid_misfit(T, data):
    """Misfit of a grid of arms at three poses, whatever the free base or tool; T is (grid, 3, 4, 4)."""
    if data.R is None:
        p = T[..., :3, 3]
        sides = np.linalg.norm(p[:, [0, 1, 2]] - p[:, [1, 2, 0]], axis=-1)
        wanted = np.linalg.norm(data.p[[0, 1, 2]] - data.p[[1, 2, 0]], axis=-1)
        return ((sides - wanted) ** 2).sum(1) if data.base_free else ((p - data.p[:3]) ** 2).sum((1, 2))
    R, U = T[..., :3, :3], data.R[:3]
    if data.base_free:
        R, U = np.swapaxes(R[:, :1], -1, -2) @ R, U[0].T @ U
    elif data.tool_free:
        R, U = R @ np.swapaxes(R[:, :1], -1, -2), U @ U[0].T
    return -np.einsum("gkij,kij->g", R, U)


def pairs(arm, data):
    """Explanations by two changes, the promising ones fitted to the end."""
    first = [Explanation(f := misfit(repair.arm, data), (arm, f.arm)) for repair in discrete_repairs(arm) if not repair.free]
    yield from _two_entries(arm, data)
    for one in first:
        yield from _then_an_entry(one, data)
        for end in ("base", "tool"):
            freed = replace(data, **{f"{end}_free": True})
            if not getattr(data, f"{end}_free") and data.R is not None and _worth_a_fit(place_ends(one.chain[1], freed), freed):
                found = misfit(one.chain[1], freed)
                yield Explanation(found, (*one.chain, found.arm), ends=(end,))
    yield from _entry_and_end(arm, data)
    for one in first:
        for repair in discrete_repairs(one.chain[1]):
            if not repair.free and _rotation_fits(repair.arm, data):
                found = misfit(repair.arm, data)
                yield Explanation(found, (*one.chain, found.arm))


def _worth_a_fit(arm, data, times=30):
    """Whether an arm is near enough that a fit can bring it within the noise."""
    return (data.residual(arm.forward(data.q)) ** 2).sum() < times * limit(data.count) + 1e6 * (data.noise[0] < 1e-5)


def _rotation_fits(arm, data):
    """A quick look at two rotations; True where it cannot be told so cheaply."""
    if data.R is None or data.base_free or data.tool_free:
        return data.R is not None
    R = arm.frames(data.q[:2])[:, -1, :3, :3] @ arm.tool[:3, :3]
    return np.abs(R - data.R[:2]).max() < 12 * data.noise[1] + 1e-7


def _turns(arm, data):
    """For every angle of the table: the turn that repairs the rotations best, and the rotation misfit then left, in closed form.

    With L the rotation of the axis' frame, N = Lᵀ R_measured R_predictedᵀ L is a turn about one axis if that angle is all that is wrong.
    """
    F = arm.frames(data.q)[..., :3, :3]
    back = data.R @ np.swapaxes(F[:, -1] @ arm.tool[:3, :3], -1, -2)
    standard = arm.table.convention == "standard"
    for i in range(len(arm)):
        for column, axis in ((THETA, 2), (ALPHA, 0)):
            L = F[:, i if (column == THETA) == standard else i + 1]
            N = (np.swapaxes(L, -1, -2) @ back @ L).sum(0)
            j, k = (axis + 1) % 3, (axis + 2) % 3
            s, c = N[k, j] - N[j, k], N[j, j] + N[k, k]
            left = 3 * len(data.q) - N[axis, axis] - np.hypot(s, c)
            yield (i, column), np.arctan2(s, c), left / data.noise[1] ** 2


def _best_lengths(arm, data, count):
    """The lengths whose change lowers the position misfit most."""
    entries = _entries(arm, (D, A))
    columns, off = _length_columns(arm, data, entries)
    gain = (columns.T @ off) ** 2 / np.maximum((columns**2).sum(0), 1e-12)
    return [entries[k] for k in np.argsort(-gain)[:count]]


def _then_an_entry(one, data):
    """A discrete change and then one entry."""
    if data.R is None:
        return
    arm = one.fit.arm
    rotation = limit(3 * len(data.q)) * (30 if data.base_free or data.tool_free else 2)
    for entry, turn, left in _turns(arm, data):
        if left < rotation and _worth_a_fit(turned := _turned(arm, entry, turn), data, 300 if data.base_free or data.tool_free else 30):
            found = fit(turned, data, (entry,))
            yield Explanation(found, (*one.chain, found.arm), (entry,))
    if (data.residual(arm.forward(data.q))[:, 3:] ** 2).sum() < rotation:
        for entry in _best_lengths(arm, data, 2):
            found = fit(arm, data, (entry,))
            yield Explanation(found, (*one.chain, found.arm), (entry,))


def _two_entries(arm, data):
    """Two entries: lengths by linear least squares, angles from closed forms, an angle and then a length."""
    placed = place_ends(arm, data)
    lengths = _entries(arm, (D, A))
    columns, off = _length_columns(placed, data, lengths)
    scored = sorted((_two_columns(columns[:, pair], off), pair) for pair in combinations(range(len(lengths)), 2))
    for _, (j, k) in scored[:4]:
        yield _in_turn(arm, placed, data, (lengths[j], lengths[k]))
    if data.R is None:
        return
    for begun, both in _two_angles(placed, data):
        yield _in_turn(arm, begun, data, both)
    for entry, turn, _ in sorted(_turns(placed, data), key=lambda item: item[2])[:6]:
        begun = _turned(placed, entry, turn)
        for length in _best_lengths(begun, data, 3):
            yield _in_turn(arm, begun, data, (entry, length))


def _two_angles(placed, data):
    """Where to begin with two angles: one all round, the other in closed form; at most two starts a pair."""
    starts = []
    for entry in _entries(placed, (THETA, ALPHA)):
        for start in STARTS:
            begun = _turned(placed, entry, start)
            starts += [(left, begun, entry, other, turn) for other, turn, left in _turns(begun, data) if other != entry]
    starts.sort(key=lambda item: item[0])
    tried = {}
    for _, begun, entry, other, turn in starts:
        pair = tuple(sorted((entry, other)))
        if tried.setdefault(pair, 0) < 2 and sum(tried.values()) < KEEP:
            tried[pair] += 1
            yield _turned(begun, other, turn), (entry, other)


def _two_columns(columns, off):
    solution = np.linalg.lstsq(columns, -off, rcond=1e-9)[0]
    return float(((off + columns @ solution) ** 2).sum())


def _halfway(arm, repaired, entry):
    rows = arm.table.rows
    rows[entry] = repaired.table.rows[entry]
    return with_rows(arm, rows)


def _in_turn(arm, begun, data, entries):
    """Fit two entries; the arm on the way has only the first of them repaired."""
    found = fit(begun, data, entries)
    return Explanation(found, (arm, _halfway(arm, found.arm, entries[0]), found.arm), entries)


def _entry_and_end(arm, data):
    """An entry together with a base or a tool."""
    for end in ("base", "tool"):
        if getattr(data, f"{end}_free") or data.R is None:
            continue
        freed = replace(data, **{f"{end}_free": True})
        placed = place_ends(arm, freed)
        for entry in _entries(arm):
            if entry[1] in (THETA, ALPHA):
                trials = [place_ends(_turned(placed, entry, start), freed) for start in STARTS[::2]]
                begun = min(trials, key=lambda trial: (freed.residual(trial.forward(freed.q)) ** 2).sum())
                found = fit(begun, freed, (entry,))
            else:
                found = fit(placed, freed, (entry,), steps=4)
            yield Explanation(found, (arm, _halfway(arm, found.arm, entry), found.arm), (entry,), (end,))


def calibrated(arm, data, prior=None):
    """The fit of every entry at once, begun at the arm: what a factory calibration does; ``prior`` as in ``fit``."""
    return fit(place_ends(arm, data), data, _entries(arm), steps=25, prior=prior)
