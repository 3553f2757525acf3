"""The search for the two changes that repair an arm: the promising ones fitted, lengths by linear least squares, angles in closed form."""

from dataclasses import replace
from itertools import combinations

import numpy as np

from .armsearch import STARTS, Explanation, entries_of, length_columns, turned, turns
from .faults import A, ALPHA, D, THETA
from .fitting import fit, limit, misfit, place_ends, with_rows
from .repairs import discrete_repairs

__all__ = ["pairs"]

KEEP = 24  # how many of the best starts of two angles are fitted to the end


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


def _best_lengths(arm, data, count):
    """The lengths whose change lowers the position misfit most."""
    entries = entries_of(arm, (D, A))
    columns, off = length_columns(arm, data, entries)
    gain = (columns.T @ off) ** 2 / np.maximum((columns**2).sum(0), 1e-12)
    return [entries[k] for k in np.argsort(-gain)[:count]]


def _then_an_entry(one, data):
    """A discrete change and then one entry."""
    if data.R is None:
        return
    arm = one.fit.arm
    rotation = limit(3 * len(data.q)) * (30 if data.base_free or data.tool_free else 2)
    for entry, turn, left in turns(arm, data):
        if left < rotation and _worth_a_fit(begun := turned(arm, entry, turn), data, 300 if data.base_free or data.tool_free else 30):
            found = fit(begun, data, (entry,))
            yield Explanation(found, (*one.chain, found.arm), (entry,))
    if (data.residual(arm.forward(data.q))[:, 3:] ** 2).sum() < rotation:
        for entry in _best_lengths(arm, data, 2):
            found = fit(arm, data, (entry,))
            yield Explanation(found, (*one.chain, found.arm), (entry,))


def _two_entries(arm, data):
    """Two entries: lengths by linear least squares, angles from closed forms, an angle and then a length."""
    placed = place_ends(arm, data)
    lengths = entries_of(arm, (D, A))
    columns, off = length_columns(placed, data, lengths)
    scored = sorted((_two_columns(columns[:, pair], off), pair) for pair in combinations(range(len(lengths)), 2))
    for _, (j, k) in scored[:4]:
        yield _in_turn(arm, placed, data, (lengths[j], lengths[k]))
    if data.R is None:
        return
    for begun, both in _two_angles(placed, data):
        yield _in_turn(arm, begun, data, both)
    for entry, turn, _ in sorted(turns(placed, data), key=lambda item: item[2])[:6]:
        begun = turned(placed, entry, turn)
        for length in _best_lengths(begun, data, 3):
            yield _in_turn(arm, begun, data, (entry, length))


def _two_angles(placed, data):
    """Where to begin with two angles: one all round, the other in closed form; at most two starts a pair."""
    starts = []
    for entry in entries_of(placed, (THETA, ALPHA)):
        for start in STARTS:
            begun = turned(placed, entry, start)
            starts += [(left, begun, entry, other, turn) for other, turn, left in turns(begun, data) if other != entry]
    starts.sort(key=lambda item: item[0])
    tried = {}
    for _, begun, entry, other, turn in starts:
        pair = tuple(sorted((entry, other)))
        if tried.setdefault(pair, 0) < 2 and sum(tried.values()) < KEEP:
            tried[pair] += 1
            yield turned(begun, other, turn), (entry, other)


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
        for entry in entries_of(arm):
            if entry[1] in (THETA, ALPHA):
                trials = [place_ends(turned(placed, entry, start), freed) for start in STARTS[::2]]
                begun = min(trials, key=lambda trial: (freed.residual(trial.forward(freed.q)) ** 2).sum())
                found = fit(begun, freed, (entry,))
            else:
                found = fit(placed, freed, (entry,), steps=4)
            yield Explanation(found, (arm, _halfway(arm, found.arm, entry), found.arm), (entry,), (end,))
