"""Whether a table agrees: no more misfit than the noise makes, as a whole, at any one pose, and in
the direction of any one number of the table.
"""

from dataclasses import dataclass, replace

import numpy as np
from scipy.special import chdtri, fdtri

from ..given import distinct
from ..search.fitting import jacobian
from ..search.signs import entries_of
from .weighing import level_left

__all__ = ["Agreement", "FEW", "agreement", "are_few", "may_be_scatter", "possible", "too_free"]

CHANCE = 0.006  # how often right data may be doubted
CHANCE_OF_FEW = 0.05  # the same where too few poses would show a mistake
FEW = 5  # poses; fewer do not tell what the noise is
CHANCE_OF_ANOTHER = 1e-4  # how often a second mistake may be suspected beside the right repair
ENOUGH = 15  # numbers that are measured beyond those of the free ends
FINE = 1e-5  # of the reach; exact poses agree by chance with no wrong table
HIDDEN = 1e-9  # share of a number's effect that is left when the free ends have taken theirs
# the largest noise to suppose where none is stated (m for an arm of 1 m, rad)
COARSE = (3e-3, 6e-3)


@dataclass(frozen=True)
class Agreement:
    """Whether a table agrees at all, and the noise (m, rad) that is then supposed.

    ``shown`` is False where the data cannot contradict any table.
    """

    agrees: bool
    level: tuple
    shown: bool = True


def possible(data):
    """The largest noise (m, rad) that may be supposed where none is stated."""
    return min(max(COARSE[0], COARSE[0] * data.reach), 10 * COARSE[0] * data.reach), COARSE[1]


def agreement(now, data):
    """The :class:`Agreement` of an arm, its free ends in place (``now``, a Fit).

    Where the noise is not stated, it is that of the digits; where the misfit is larger, what the
    misfit itself shows, if it is no larger than people measure and nothing but scatter is in it.
    """
    spare = _kinds(data) - now.fitted
    if spare <= 0 or too_free(now, data):
        return Agreement(False, data.noise, shown=False)
    few = are_few(now, data)
    chance = CHANCE_OF_FEW if few else CHANCE
    if data.stated:
        return Agreement(not _doubted(now, data, data.noise, np.inf, chance), data.noise)
    if not _doubted(now, data, data.floor, np.inf, chance):
        return Agreement(True, data.floor)
    level = level_left(now.arm, data, now.fitted)
    plausible = _is_possible(level, data)
    if data.R is not None and level[1] <= data.floor[1] and level[0] > 2 * data.floor[0]:
        data, spare = replace(data, R=None), spare // 2  # rotations without noise tell no scatter
    agrees = plausible and not few and not _doubted(now, data, level, spare, 3 * CHANCE)
    return Agreement(agrees, level)


def are_few(now, data):
    """Whether poses, the free ends paid for, are too few to tell what the noise is."""
    return _kinds(data) - now.fitted < FEW * (3 if data.R is None else 6)


def too_free(now, data):
    """Whether rough poses with a free end have too few numbers to spare for a clean bill: what one
    number of the table does, the free ends take up all but a few times the noise of it.
    """
    free = data.base_free or data.tool_free
    rough = data.noise[0] > FINE * data.reach
    return free and rough and _kinds(data) - now.fitted < ENOUGH


def may_be_scatter(found, data, level):
    """Whether an arm leaves no more than people measure, and nothing but scatter."""
    return _is_possible(level, data) and _only_scatter(found, data, level)


def _is_possible(level, data):
    return all(s <= most for s, most in zip(level, possible(data)))


def _only_scatter(found, data, level):
    """Whether what a repaired arm leaves is scatter, so far as these data show: else something else
    is wrong besides.
    """
    if all(s <= 2 * least for s, least in zip(level, data.floor)):
        return True
    spare = _kinds(data) - found.fitted
    return spare > 0 and not _doubted(found, data, level, spare, CHANCE_OF_ANOTHER)


def _kinds(data):
    return distinct(data.q) * (3 if data.R is None else 6)


def _doubted(now, data, level, freedom, chance):
    """Whether something other than noise is in the misfit; ``freedom`` says by how many numbers the
    noise is known.
    """
    r, columns = _in_units(now.arm, data, level)
    total = r @ r
    count = len(r) - now.fitted
    if freedom == np.inf:
        if total > chdtri(count, chance / 3):
            return True
    elif _shared(r, columns, now, chance / 3):
        return True
    gains = _gains(r, columns)
    poses = (r.reshape(len(data.q), -1) ** 2).sum(axis=1)
    size = r.size // len(data.q)
    return _passed(gains.max(initial=0), 1, total, freedom, chance / 3 / max(len(gains), 1)) or (
        freedom > size + 2 and _passed(poses.max(), size, total, freedom, chance / 3 / len(poses))
    )


def _passed(gain, numbers, total, freedom, chance):
    """Whether so much of the squares lies in so few numbers more often than by chance."""
    if freedom == np.inf:
        return gain > chdtri(numbers, chance)
    rest = max(total - gain, 1e-12)
    left = max(freedom - numbers, 1)
    return gain / numbers / (rest / left) > fdtri(numbers, left, 1 - chance)


def _shared(r, columns, now, chance):
    """Whether all numbers of the table together take more of the misfit than chance gives them."""
    U, s, _ = np.linalg.svd(columns, full_matrices=False)
    U = U[:, s > 1e-6 * s.max(initial=1e-300)]
    left = len(r) - now.fitted - U.shape[1]
    if left < 3 or U.shape[1] == 0:
        return False
    taken = ((U.T @ r) ** 2).sum()
    return taken / U.shape[1] / (max(r @ r - taken, 1e-12) / left) > fdtri(
        U.shape[1], left, 1 - chance
    )


def _in_units(arm, data, level):
    """The residuals, and what every number of the table, the base and the tool would do to them, in
    units of a level of noise; what the free ends do is taken out.
    """
    J, r = jacobian(arm, data, entries_of(arm), True, True)
    size = 3 if data.R is None else 6
    unit = np.tile(np.repeat(np.array(data.noise) / level, 3)[:size], len(data.q))
    J, r = J * unit[:, None], r * unit
    n = 4 * len(arm)
    ends = J[:, n:]
    mine = np.zeros(12, dtype=bool)
    mine[:6], mine[6:] = data.base_free, data.tool_free
    if not mine.any():
        return r, J
    U, s, _ = np.linalg.svd(ends[:, mine], full_matrices=False)
    U = U[:, s > 1e-6 * s.max()]
    rest = np.hstack([J[:, :n], ends[:, ~mine]])
    kept = rest - U @ (U.T @ rest)
    seen = (kept**2).sum(0) > HIDDEN * (rest**2).sum(0)
    return r - U @ (U.T @ r), kept[:, seen]


def _gains(r, columns):
    """By how much the squares would fall for each number alone."""
    squared = (columns**2).sum(0)
    seen = squared > 1e-12 * squared.max(initial=1e-300)
    return (columns[:, seen].T @ r) ** 2 / squared[seen]
