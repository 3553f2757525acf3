"""An arm that is a little off its table, as real arms are: whether small changes of all numbers
explain a misfit better than one mistake does, and which of them stand out.
"""

from dataclasses import dataclass

import numpy as np

from ....printing import number
from ....table import COLUMNS
from ...mistakes.remade import ALPHA, THETA, A, D
from ..search.ends import place_ends
from ..search.fitting import Fit, fit, jacobian
from ..search.measured import limit
from ..search.signs import entries_of
from .agreement import possible
from .weighing import as_measured, squares

__all__ = ["Calibration", "calibration", "changes_by_size", "is_small"]

SMALL = (0.012, 0.02)  # a misfit that a calibration might make (of the reach, rad; rms)
# how far a calibration moves a number, standard deviation (of the reach, rad): the arms of dh_facts
# are 1 to 5 mm off at the end
MOVED = (1e-3, 2e-3)
TIMES = (0.3, 1.0, 3.0)  # more or less than that
CHOICE = 3.0  # nats for which of these, and for which noise
SURE = 4.0  # standard deviations by which a number stands out
MOST_LISTED = 12


@dataclass(frozen=True)
class Calibration:
    """All numbers a little off: the fitted arm, what the supposition costs (nats), the noise and
    how far numbers may move (m, rad).
    """

    fit: Fit
    cost: float
    level: tuple
    moved: tuple


def is_small(now, data):
    """Whether a misfit is no larger than a calibration might make it."""
    (p, count), (turn, of_turns) = squares(now.arm, data)
    position = np.sqrt(3 * p / count)
    return position < SMALL[0] * max(data.reach, 1.0) and (
        not of_turns or np.sqrt(3 * turn / of_turns) < SMALL[1]
    )


def calibration(arm, now, data):
    """The :class:`Calibration` that costs least; None where even that leaves more than noise.

    The cost is that of a Gaussian model in which every number moves by chance: half of
    ``r' C⁻¹ r + log det C`` with ``C = I + J P J'``, r and J in units of the noise.
    """
    entries = entries_of(arm)
    J, r = jacobian(now.arm, data, entries, data.base_free, data.tool_free)
    n = len(entries)
    lengths = np.array([column in (D, A) for _, column in entries])
    best = None
    for level in _levels(now, data):
        unit = np.tile(
            np.repeat(np.array(data.noise) / level, 3)[: len(r) // len(data.q)], len(data.q)
        )
        Ju, ru = J * unit[:, None], r * unit
        for times in TIMES:
            moved = times * MOVED[0] * data.reach, times * MOVED[1]
            sigma = np.concatenate(
                [np.where(lengths, *moved), np.full(Ju.shape[1] - n, max(data.reach, 1.0))]
            )
            cost = _evidence(Ju * sigma, ru) + CHOICE + _level_cost(level, data)
            if best is None or cost < best[0]:
                best = cost, level, moved
    cost, level, moved = best
    near = data if data.stated else _at(data, level)
    whole = fit(place_ends(arm, near), near, entries, steps=25, prior=moved)
    left = float((near.residual(whole.arm.forward(data.q)) ** 2).sum())
    if left > limit(data.count):
        return None
    return Calibration(whole, cost, level, moved)


def _at(data, level):
    from dataclasses import replace

    return replace(data, noise=level)


def _levels(now, data):
    """The noises to suppose: the stated one, or all from that of the digits to the largest
    possible.
    """
    if data.stated:
        return [data.noise]
    (p, count), (turn, of_turns) = squares(now.arm, data)
    largest = np.minimum(
        [np.sqrt(p / count), np.sqrt(turn / of_turns) if of_turns else data.floor[1]],
        possible(data),
    )
    floor = np.array(data.floor)
    return [tuple(floor * (np.maximum(largest, floor) / floor) ** x) for x in np.linspace(0, 1, 7)]


def _level_cost(level, data):
    """What a noise costs that is larger than the digits make it, as in :mod:`weighing`."""
    if data.stated:
        return 0.0
    counts = data.p.size, data.p.size if data.R is not None else 0
    return sum(
        count * np.log(s / least) for s, least, count in zip(level, data.floor, counts) if count
    )


def _evidence(X, r):
    """Half of ``r' C⁻¹ r + log det C`` for ``C = I + X X'``."""
    M = np.eye(X.shape[1]) + X.T @ X
    v = X.T @ r
    return 0.5 * (r @ r - v @ np.linalg.solve(M, v) + np.linalg.slogdet(M)[1])


def explains_better(whole, data):
    """Whether the calibration is worth more than the bare numbers."""
    return whole.cost + 10 < as_measured(data)


def changes_by_size(arm, whole, data):
    """Sentences: every number that is off by more than the noise, the largest first."""
    near = _at(data, whole.level)
    entries = entries_of(arm)
    J, _ = jacobian(whole.fit.arm, near, entries, data.base_free, data.tool_free)
    spring = np.zeros(J.shape[1])
    spring[: len(entries)] = [1 / whole.moved[0 if c in (D, A) else 1] for _, c in entries]
    spread = np.sqrt(np.diag(np.linalg.pinv(J.T @ J + np.diag(spring**2))))
    off = np.array([whole.fit.arm.table.rows[e] - arm.table.rows[e] for e in entries])
    sizes = np.linalg.norm(J[:, : len(entries)] * off, axis=0)
    told = [
        k
        for k in np.argsort(-sizes)
        if abs(off[k]) > SURE * spread[k] or sizes[k] > 0.5 * sizes.max()
    ]
    if not told:
        return
    listed = "; ".join(_change(entries[k], off[k], spread[k]) for k in told[:MOST_LISTED])
    more = len(told) - MOST_LISTED
    yield (
        f"The numbers that are off, by what they do to the end: {listed}"
        + (f"; and {more} more." if more > 0 else ".")
    )


def _change(entry, off, spread):
    i, column = entry
    name = f"{COLUMNS[column]}{i + 1}"
    if column in (THETA, ALPHA):
        return f"{name} {_signed(np.rad2deg(off), 3)}° (± {number(np.rad2deg(spread), 3)}°)"
    return f"{name} {_signed(1e3 * off, 2)} mm (± {number(1e3 * spread, 2)} mm)"


def _signed(value, digits):
    return ("+" if value > 0 else "") + number(value, digits)
