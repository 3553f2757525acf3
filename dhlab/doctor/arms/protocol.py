"""With a tape measure: the few poses whose end points tell the most mistakes of an arm's table
apart, as a sheet to fill in.
"""

import numpy as np

from ...arm import Arm
from ...geometry.conversion import require_uncoupled
from ...table import COLUMNS, DHTable
from ..mistakes.faults import faults
from ..mistakes.remade import ALPHA, THETA, A, D, with_rows
from .sheet import Protocol

__all__ = ["protocol", "Protocol"]

CANDIDATES = 120
STEP = np.deg2rad(5)  # a pendant and an eye like whole numbers
CLEAR = np.deg2rad(10)  # from zero and right angles, where sines and cosines hide mistakes
REACH = np.deg2rad(150)  # no further, whatever the limits: cables
SLIDE = 0.01  # the same for sliding joints, m
SEEN = 0.02  # m; a tape measure shows this for certain
LENGTH, ANGLE = 0.03, np.deg2rad(6)  # small changes of each number, beside the catalogue's
HIDDEN = 1e-3  # m; less than this no pose shows


def protocol(arm, count=8):
    """The poses at which to measure an arm's tool point, so that its table's mistakes show and can
    be told apart.

    Parameters
    ----------
    arm : Arm or DHTable
    count : int
        How many poses, 3 to 40; six to eight suit a tape measure.

    Returns
    -------
    Protocol
        Printed, the sheet; ``q`` (count, n) and ``to_csv()``.

    Raises
    ------
    ValueError
        No arm, or a count out of range.

    Notes
    -----
    Of random poses inside the limits, above the base and away from multiples of 90°, one after the
    other is taken that makes the pairs of mistakes (and each mistake and none) differ most; the
    price of a pair falls off with the root of its summed squared differences over 20 mm.

    Examples
    --------
    >>> import dhlab as dh
    >>> plan = protocol(dh.load("ur5e"), 6)
    >>> plan.q.shape, plan.hidden
    ((6, 6), ('theta6', 'alpha6'))
    """
    arm = Arm(arm) if isinstance(arm, DHTable) else arm
    if not isinstance(arm, Arm):
        raise ValueError(f"protocol: expected an Arm or a DHTable, found {type(arm).__name__}")
    require_uncoupled(arm, "protocol")
    if isinstance(count, bool) or not isinstance(count, (int, np.integer)) or not 3 <= count <= 40:
        raise ValueError(
            f"protocol: count: expected a whole number from 3 to 40, found {count!r}; eight suit a"
            " tape measure"
        )
    q, above = _candidates(arm)
    p = arm.forward(q)[:, :3, 3]
    wrong = [f.arm for f in faults(arm)] + [changed for _, changed in _small_changes(arm)]
    moved = np.stack([np.zeros_like(p), *(a.forward(q)[:, :3, 3] - p for a in wrong)]).astype(
        np.float32
    )
    chosen = _choose(moved, min(count, len(q)))
    return Protocol(arm, q[chosen], _smallest(moved, chosen), _hidden(arm), _still(arm, q), above)


def _candidates(arm):
    """Poses to choose from, and whether all keep the arm above its base's plane."""
    rng = np.random.default_rng(12)
    values = [
        _values(pair, letter)
        for pair, letter in zip(arm.limits or [None] * len(arm), arm.table.joints)
    ]
    q = np.unique(np.column_stack([rng.choice(v, 40 * CANDIDATES) for v in values]), axis=0)
    q = rng.permutation(q)
    free, upright = _free(arm, q)
    enough = [mask for mask in (free & upright, free, upright) if mask.sum() >= CANDIDATES / 2]
    mask = enough[0] if enough else np.ones(len(q), bool)
    return q[mask][:CANDIDATES], bool(upright[mask][:CANDIDATES].all())


def _values(pair, letter):
    """What a joint may be driven to: whole steps inside its limits, away from zeros and right
    angles.
    """
    step, default = (SLIDE, (0.1, 0.4)) if letter == "P" else (STEP, (-REACH, REACH))
    low, high = pair or default
    if letter == "R" and low < REACH and high > -REACH:  # else all of it is further than that
        low, high = max(low, -REACH), min(high, REACH)
    values = step * np.arange(np.ceil(low / step + 0.999), np.floor(high / step - 0.999) + 1)
    away = (
        np.abs(values) > step / 2
        if letter == "P"
        else np.abs((values + np.pi / 4) % (np.pi / 2) - np.pi / 4) >= CLEAR - 1e-9
    )
    if not away.any():
        return low + (high - low) * np.array([0.23, 0.41, 0.64, 0.83])
    return values[away]


def _free(arm, q):
    """Which poses keep the tool point off the arm itself, and which keep everything above the base
    (all, where it does not stand upright).
    """
    F = arm.frames(q)
    end = (F[:, -1] @ arm.tool)[:, :3, 3]
    points = np.concatenate([F[:, :, :3, 3], end[:, None]], axis=1)
    reach = np.linalg.norm(points - points[:, :1], axis=2).max()
    apart = (
        np.linalg.norm(points[:, : max(len(arm) - 2, 1)] - end[:, None], axis=2).min(axis=1)
        > 0.2 * reach
    )
    if arm.base[2, 2] < 0.999:
        return apart, np.ones(len(q), bool)
    return apart, (points[:, 1:, 2] > arm.base[2, 3] - 1e-6).all(axis=1) & (
        end[:, 2] > arm.base[2, 3] + 0.03 * reach
    )


def _small_changes(arm):
    """(name, arm with one number changed a little), for every number that is no joint variable's
    double.
    """
    for i in range(len(arm)):
        for column, change in ((THETA, ANGLE), (D, LENGTH), (A, LENGTH), (ALPHA, ANGLE)):
            rows = arm.table.rows
            rows[i, column] += change
            yield f"{COLUMNS[column]}{i + 1}", with_rows(arm, rows)


def _choose(moved, count):
    """Rows of the candidates, taken greedily, then each exchanged once for a better one; moved is
    (mistakes, candidates, 3).
    """
    apart = np.stack([_squares(moved[:, k]) for k in range(moved.shape[1])])
    apart = apart[:, apart.max(axis=0) > HIDDEN**2]

    def price(total):
        return np.exp(-np.sqrt(total) / SEEN).sum()

    chosen, total = [], np.zeros_like(apart[0])
    for step in range(2 * count):
        if step >= count:
            total = total - apart[chosen.pop(0)]
        prices = [np.inf if k in chosen else price(total + apart[k]) for k in range(len(apart))]
        chosen.append(int(np.argmin(prices)))
        total = total + apart[chosen[-1]]
    return sorted(chosen)


def _squares(d):
    """Squared distances between all rows (k, 3), the upper triangle only."""
    i, j = np.triu_indices(len(d), 1)
    out = ((d[i] - d[j]) ** 2).sum(axis=1)
    return np.minimum(out, 1.0) * np.where(i == 0, 1.0, 0.5)


def _smallest(moved, chosen):
    """Over all mistakes large enough for a tape at some candidate: how far the chosen pose that
    shows it best moves.
    """
    sizes = np.linalg.norm(moved, axis=2)
    large = sizes[sizes.max(axis=1) > SEEN]
    return float(large[:, chosen].max(axis=1).min()) if len(large) else 0.0


def _hidden(arm):
    """The numbers whose change moves no tool point."""
    q = np.random.default_rng(5).uniform(-2, 2, (5, len(arm)))
    p = arm.forward(q)[:, :3, 3]
    return tuple(
        name
        for name, changed in _small_changes(arm)
        if np.abs(changed.forward(q)[:, :3, 3] - p).max() < 1e-9
    )


def _still(arm, q):
    """The joints that leave the tool point where it is."""
    speeds = np.linalg.norm(arm.jacobian(q[:6])[:, :3], axis=1).max(axis=0)
    return tuple(int(i) + 1 for i in np.flatnonzero(speeds < HIDDEN))
