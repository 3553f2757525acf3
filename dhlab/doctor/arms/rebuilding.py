"""A table with many mistakes: the arm is rebuilt from the measurements, then said number by number
how the table differs from it.
"""

from dataclasses import replace

import numpy as np

from ..diagnosis import EXPLAINED, Diagnosis
from ..mistakes.remade import ALPHA, THETA, A, D, with_rows
from .judging.agreement import possible
from .judging.weighing import as_measured, largest, level_left, number_costs, squares
from .search.ends import place_ends
from .search.fitting import fit, misfit
from .search.measured import limit
from .search.signs import entries_of
from .search.singles import singles
from .words.differences import wrapped
from .words.naming import name_every_change

__all__ = ["rebuilt"]

SHARE = 0.85  # of the time, after which nothing more is begun
LAST = 0.95  # of the time, until which numbers of the table are put back
SPARE = 6  # numbers that must be left over when all of the table are fitted
WIDE, DEEP = 3, 5  # arms kept after each mistake that is taken back, and how many are
NEARER = 0.7  # of the misfit must be left at most by one more change
WORSE = 16.0  # χ² that a number of the table may cost when it is put back
OVER_NOTHING = 20.0  # nats by which the rebuilt arm must be better than the bare numbers


def rebuilt(arm, data, budget):
    """The Diagnosis with every number that is wrong, None where no arm of this kind fits.

    All numbers are fitted at once, begun at the table and at the arms that are nearest to the
    measurements after one, two, … changes.
    """
    ends = 6 * (data.base_free + data.tool_free)
    if data.count < 4 * len(arm) + ends + SPARE:
        return None
    for start in _starts(arm, data, budget):
        whole = fit(place_ends(start, data), data, entries_of(start), steps=30)
        if _fits(whole, data):
            return _told(arm, whole, data, budget)
    return None


def _starts(arm, data, budget):
    """The table, and what is nearest to the measurements after one, two, … changes, as long as that
    brings it nearer.
    """
    yield arm
    kept, before = [arm], np.inf
    for _ in range(DEEP):
        more = []
        for begun in kept:
            more += singles(begun, data, budget.part("rebuilding the arm", SHARE))
        nearest = _nearest(more)
        if not nearest or nearest[0].chi2 > NEARER * before:
            return
        kept, before = [found.arm for found in nearest], nearest[0].chi2
        yield from budget.within(kept, "rebuilding the arm", SHARE)


def _nearest(explanations):
    """The fits with the least misfit, of those that are told apart by it."""
    kept = []
    for e in sorted(explanations, key=lambda e: e.fit.chi2):
        own = e.data_fault is None and not e.ends
        if own and all(abs(e.fit.chi2 - other.chi2) > 1e-3 * other.chi2 for other in kept):
            kept.append(e.fit)
        if len(kept) == WIDE:
            break
    return kept


def _fits(whole, data):
    if data.stated:
        return whole.explains(data)
    level = level_left(whole.arm, data, whole.fitted)
    return all(s <= most for s, most in zip(level, possible(data)))


def _told(arm, whole, data, budget):
    """The Diagnosis, once every number that may stay as it is in the table has been put back."""
    at = data if data.stated else replace(data, noise=level_left(whole.arm, data, whole.fitted))
    wrong = with_rows(whole.arm, arm.table.rows)  # the same senses and letters as the rebuilt arm
    found, free = _put_back(wrong, whole.arm, at, budget)
    length, angle = number_costs(at.noise, data)
    cost = sum(length if c in (D, A) else angle for _, c in free) + found.chi2 / 2
    if not data.stated:
        cost += sum(
            count * np.log(max(s / least, 1))
            for (_, count), s, least in zip(squares(found.arm, data), at.noise, data.floor)
        )
    if cost + OVER_NOTHING > as_measured(data):
        return None
    findings = name_every_change(arm, found.arm, free)
    if not findings:
        return None
    return Diagnosis(
        EXPLAINED,
        f"{len(findings)} things are wrong; the arm was rebuilt from the measurements.",
        findings,
        largest(misfit(arm, data).arm, data),
        largest(found.arm, data),
    )


def _put_back(wrong, right, data, budget):
    """(Fit, the entries (row, column) that must differ): the numbers of the table put back one by
    one, the least certain first, as long as the rest can be fitted about as well.
    """
    free = entries_of(right)
    found = fit(right, data, free, steps=10)
    rows = right.table.rows
    off = np.array([_apart(rows[e], wrong.table.rows[e], e[1]) for e in free])
    sure = np.abs(off) / np.maximum(found.sigma[: len(off)], 1e-12)
    order = np.argsort([s / (1 if wrong.table.rows[e] else 2) for s, e in zip(sure, free)])
    for entry in budget.within([free[k] for k in order], "which numbers may stay", LAST):
        rest = [e for e in free if e != entry]
        rows = found.arm.table.rows
        rows[entry] += _apart(wrong.table.rows[entry], rows[entry], entry[1])
        trial = fit(with_rows(found.arm, rows), data, rest, steps=8)
        if trial.chi2 < found.chi2 + WORSE and trial.chi2 <= limit(data.count - trial.fitted):
            found, free = trial, rest
    return found, free


def _apart(a, b, column):
    return wrapped(a - b) if column in (THETA, ALPHA) else a - b
