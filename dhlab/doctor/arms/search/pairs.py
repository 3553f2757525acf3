"""The search for the two changes that repair an arm: the promising ones fitted, lengths by linear
least squares, angles in closed form.
"""

from dataclasses import replace
from itertools import combinations

import numpy as np

from ...mistakes.remade import ALPHA, THETA, A, D, with_rows
from ...mistakes.together import ends_of
from .angles import STARTS, turned, turns
from .ends import place_ends
from .fitting import fit, misfit, misfits
from .measured import limit
from .repairs import discrete_repairs
from .signs import entries_of, length_columns
from .singles import Explanation

__all__ = ["pairs"]

KEEP = 24  # how many of the best starts of two angles are fitted to the end


def pairs(arm, data, part):
    """Explanations by two changes, the promising ones fitted to the end. ``part`` hands out what is
    tried, as long as there is time.
    """
    yield from part(_two_by_two(arm, data, part))


def _two_by_two(arm, data, part):
    first = [
        Explanation(found, (arm, found.arm)) for found in part(misfits(_repaired(arm, part), data))
    ]
    yield from _two_entries(arm, data, part)
    looked_at = _Ends(data)
    for one in part(first):
        yield from _then_an_entry(one, data, part)
        for end in ("base", "tool"):
            freed = replace(data, **{f"{end}_free": True})
            if (
                not getattr(data, f"{end}_free")
                and _enough(data)
                and _worth_a_fit(place_ends(one.chain[1], freed), freed)
            ):
                found = misfit(one.chain[1], freed)
                yield Explanation(found, (*one.chain, found.arm), ends=(end,))
    yield from _entry_and_end(arm, data)
    for one in part(first):
        for twice in looked_at.near(_repaired(one.chain[1], part)):
            found = misfit(twice, data)
            yield Explanation(found, (*one.chain, found.arm))


def _repaired(arm, part):
    """The arm with each mistake taken back that leaves no number to be fitted."""
    return [repair.arm for repair in part(discrete_repairs(arm)) if not repair.free]


def _enough(data):
    """Whether a base or a tool can be told from a few measurements, besides another mistake:
    positions alone leave it open longer.
    """
    return data.R is not None or len(data.q) >= 6


def _worth_a_fit(arm, data, times=30):
    """Whether an arm is near enough that a fit can bring it within the noise."""
    return (data.residual(arm.forward(data.q)) ** 2).sum() < times * limit(data.count) + 1e6 * (
        data.noise[0] < 1e-5
    )


class _Ends:
    """A quick look at arms' ends, whether they can be the measured ones: two rotations, or a few
    positions or the distances between them.
    """

    def __init__(self, data):
        self.data = data
        self.few = slice(0, 2 if data.R is not None else 4)
        self.open = data.tool_free or (data.R is not None and data.base_free)
        self.pairs = np.triu_indices(len(data.q[self.few]), 1)
        self.sides = self._between(data.p[self.few])

    def near(self, arms):
        """Those of the arms that can be right."""
        if self.open or not arms:
            return arms
        apart = self._apart(ends_of(arms, self.data.q[self.few])).reshape(len(arms), -1)
        most = 12 * self.data.noise[0 if self.data.R is None else 1] + 1e-7
        return [arms[k] for k in np.flatnonzero(np.abs(apart).max(axis=1, initial=0) < most)]

    def _apart(self, ends):
        """What lies between the ends of each arm (k, few, 4, 4) and the measured ones."""
        data = self.data
        if data.R is not None:
            return ends[..., :3, :3] - data.R[self.few]
        if data.base_free:
            return self._between(ends[..., :3, 3]) - self.sides
        return ends[..., :3, 3] - data.p[self.few]

    def _between(self, points):
        i, j = self.pairs
        return np.linalg.norm(points[..., i, :] - points[..., j, :], axis=-1)


def _best_lengths(arm, data, count, enough=None):
    """The lengths whose change lowers the position misfit most; ``enough`` leaves out those that
    leave more misfit than that.

    Where the base is free, what a small motion of it does is taken out of the columns and of the
    misfit first.
    """
    entries = entries_of(arm, (D, A))
    columns, off = length_columns(arm, data, entries)
    if data.base_free:
        known = _base_motions(arm, data)
        columns, off = columns - known @ (known.T @ columns), off - known @ (known.T @ off)
    gain = (columns.T @ off) ** 2 / np.maximum((columns**2).sum(0), 1e-12)
    return [
        entries[k]
        for k in np.argsort(-gain)[:count]
        if enough is None or off @ off - gain[k] < enough
    ]


def _base_motions(arm, data):
    """An orthonormal basis (3m, 6) of what small motions of the base do to the positions."""
    p = arm.forward(data.q)[:, :3, 3]
    moves = np.concatenate(
        [
            np.broadcast_to(np.eye(3), (len(p), 3, 3)),
            np.stack([np.cross(axis, p - p.mean(0)) for axis in np.eye(3)], axis=-1),
        ],
        axis=-1,
    )
    return np.linalg.qr(moves.reshape(-1, 6))[0]


def _then_an_entry(one, data, part):
    """A discrete change and then one entry."""
    if data.R is None and data.tool_free:
        return
    arm = one.fit.arm
    ends = data.base_free or data.tool_free
    enough = limit(3 * len(data.q)) * (30 if ends else 2)
    for entry, turn, left in part(turns(arm, data)):
        if left < enough and _worth_a_fit(
            begun := turned(arm, entry, turn), data, 300 if ends else 30
        ):
            found = fit(begun, data, (entry,))
            yield Explanation(found, (*one.chain, found.arm), (entry,))
    if data.R is None or (data.residual(arm.forward(data.q))[:, 3:] ** 2).sum() < enough:
        for entry in _best_lengths(arm, data, 2, None if data.R is not None else enough):
            found = fit(arm, data, (entry,))
            yield Explanation(found, (*one.chain, found.arm), (entry,))


def _two_entries(arm, data, part):
    """Two entries: lengths by linear least squares, angles from closed forms, an angle and then a
    length.
    """
    placed = place_ends(arm, data)
    lengths = entries_of(arm, (D, A))
    columns, off = length_columns(placed, data, lengths)
    scored = sorted(
        (_two_columns(columns[:, pair], off), pair) for pair in combinations(range(len(lengths)), 2)
    )
    for _, (j, k) in scored[:4]:
        yield _in_turn(arm, placed, data, (lengths[j], lengths[k]))
    if data.R is None and data.tool_free:
        return
    for begun, both in _two_angles(placed, data, part):
        yield _in_turn(arm, begun, data, both)
    for entry, turn, _ in sorted(turns(placed, data), key=lambda item: item[2])[:6]:
        begun = turned(placed, entry, turn)
        for length in _best_lengths(begun, data, 3):
            yield _in_turn(arm, begun, data, (entry, length))


def _two_angles(placed, data, part):
    """Where to begin with two angles: one all round, the other in closed form; at most two starts a
    pair.
    """
    starts = []
    for entry in part(entries_of(placed, (THETA, ALPHA))):
        for start in part(STARTS):
            begun = turned(placed, entry, start)
            starts += [
                (left, begun, entry, other, turn)
                for other, turn, left in turns(begun, data)
                if other != entry
            ]
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
        if getattr(data, f"{end}_free") or not _enough(data):
            continue
        freed = replace(data, **{f"{end}_free": True})
        placed = place_ends(arm, freed)
        for entry in entries_of(arm):
            if entry[1] in (THETA, ALPHA):
                trials = [place_ends(turned(placed, entry, start), freed) for start in STARTS[::2]]
                begun = min(
                    trials, key=lambda trial: (freed.residual(trial.forward(freed.q)) ** 2).sum()
                )
                found = fit(begun, freed, (entry,))
            else:
                found = fit(placed, freed, (entry,), steps=4)
            yield Explanation(
                found, (arm, _halfway(arm, found.arm, entry), found.arm), (entry,), (end,)
            )
