"""The search for the one change that repairs an arm: every mistake taken back, every number of the
table, signs, offsets, ends, data.
"""

from dataclasses import dataclass, replace

import numpy as np

from ...mistakes.remade import A, D
from .angles import STARTS, all_offsets, rounded_angles, turned, turns
from .data import data_repairs
from .ends import place_ends
from .entries import fitted_one_by_one
from .fitting import Fit, fit, misfit, misfits
from .measured import Measured
from .repairs import discrete_repairs
from .signs import entries_of, signs_of_lengths, signs_of_twists

__all__ = ["Explanation", "singles", "calibrated"]


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


def singles(arm, data, part):
    """Every explanation by one change, fitting or not; the caller keeps those that fit. ``part``
    hands out what is tried, as long as there is time.
    """
    yield from part(_one_by_one(arm, data, part))


def _one_by_one(arm, data, part):
    repairs = list(discrete_repairs(arm))
    whole = iter(misfits([repair.arm for repair in repairs if not repair.free], data))
    for repair in repairs:
        found = fit(place_ends(repair.arm, data), data, repair.free) if repair.free else next(whole)
        yield Explanation(found, (arm, found.arm), repair.free)
    placed = place_ends(arm, data)
    for entry, found in _entry_fits(placed, data):
        yield Explanation(found, (arm, found.arm), (entry,))
    for twisted in [arm, *signs_of_twists(arm, data, part)]:
        if twisted is not arm:
            found = misfit(twisted, data)
            yield Explanation(found, (arm, found.arm))
        for found in signs_of_lengths(twisted, data):
            yield Explanation(found, (arm, found.arm))
    for found, free in all_offsets(arm, data):
        yield Explanation(found, (arm, found.arm), free)
    for found in rounded_angles(placed, data):
        yield Explanation(found, (arm, found.arm))
    for end in ("base", "tool"):
        if not getattr(data, f"{end}_free"):
            found = misfit(arm, replace(data, **{f"{end}_free": True}))
            yield Explanation(found, (arm, found.arm), ends=(end,))
    for fault, changed in data_repairs(data):
        yield Explanation(misfit(arm, changed), (arm,), data_fault=fault, changed=changed)


def _entry_fits(placed, data):
    """(entry, Fit) of each entry by itself; an angle is begun where it is best, or all round, since
    a fit only sees the nearest valley.
    """
    entries = entries_of(placed)
    if not data.base_free and not data.tool_free:
        begun = dict.fromkeys(entries, 0.0) | {
            entry: turn for entry, turn, _ in turns(placed, data)
        }
        steps = {entry: 15 if entry[1] in (D, A) else 4 for entry in entries}
        yield from fitted_one_by_one(placed, data, begun, steps).items()
        return
    for entry in entries:
        if entry[1] in (D, A):
            yield entry, fit(placed, data, (entry,))
            continue
        trials = [misfit(turned(placed, entry, start), data) for start in STARTS]
        for k in np.argsort([trial.chi2 for trial in trials])[:2]:
            yield entry, fit(trials[k].arm, data, (entry,))


def calibrated(arm, data, prior=None):
    """The fit of every entry at once, begun at the arm: what a factory calibration does; ``prior``
    as in ``fit``.
    """
    return fit(place_ends(arm, data), data, entries_of(arm), steps=25, prior=prior)
