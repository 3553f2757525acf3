"""Ways to change a candidate arm that might make it right: whole-arm and row repairs without
numbers to fit, each with what it undoes.
"""

from dataclasses import dataclass
from itertools import product

import numpy as np

from ...arm import Arm
from ...geometry.freedoms import half_turn
from .faults import ALPHA, DEG, THETA, A, D, flipped_x, flipped_z
from .fitting import with_parts, with_rows

__all__ = ["Repair", "discrete_repairs"]


SMALLEST_DEGREES = 2  # a number below this was not written down as degrees of a table


@dataclass(frozen=True)
class Repair:
    """A changed candidate; ``free`` are (row, column) whose values the change leaves to be
    fitted.
    """

    arm: Arm
    free: tuple = ()


def discrete_repairs(arm):
    """Every repair without a number to guess, each arm once."""
    seen = {_key(arm)}
    for repair in _all(arm):
        key = _key(repair.arm)
        if key not in seen or repair.free:
            seen.add(key)
            yield repair


def _key(arm):
    return (
        arm.table.convention,
        arm.table.joints,
        arm.table.rows.tobytes(),
        arm.sign.tobytes(),
        arm.base.tobytes(),
        arm.tool.tobytes(),
    )


def _all(arm):
    rows = arm.table.rows
    other = "craig" if arm.table.convention == "standard" else "standard"
    yield Repair(with_rows(arm, rows, convention=other))
    yield from (Repair(with_rows(arm, changed)) for changed in _whole_tables(rows))
    up = rows.copy()
    up[:-1, A:] = rows[1:, A:]
    up[-1, A:] = 0
    n = len(rows)
    yield Repair(with_rows(arm, up), ((n - 1, A), (n - 1, ALPHA)))
    yield Repair(with_parts(arm, sign=-arm.sign))
    yield Repair(with_rows(arm, rows * [-1, 1, 1, 1], sign=-arm.sign))
    yield Repair(with_parts(arm, base=np.eye(4), tool=_shift_of(arm.base) @ arm.tool))
    for i in range(n):
        yield from _of_row(arm, i)
    for i in range(n - 1):
        yield from _of_frame(arm, i)


def _shift_of(T):
    E = np.eye(4)
    E[:3, 3] = T[:3, 3]
    return E


def _whole_tables(rows):
    """Columns in another order, all signs, all units, rounded angles made whole."""
    for order in (
        [3, 2, 1, 0],
        [2, 3, 1, 0],
        [3, 2, 0, 1],
        [2, 1, 3, 0],
        [0, 2, 1, 3],
        [3, 1, 2, 0],
    ):
        yield rows[:, order]
    for factors in product((1, -1), (1,), (1,), (1, -1)):
        yield rows * factors
    for factor in (10, 0.1, 100, 0.01):
        yield rows * [1, factor, factor, 1]
    for factor in (1000, 1e-3, 25.4e-3, 1 / 25.4e-3):
        for columns in ([D], [A], [D, A]):
            changed = rows.copy()
            changed[:, columns] *= factor
            yield changed
    for columns in ([THETA], [ALPHA], [THETA, ALPHA]):
        for factor in (DEG, 1 / DEG):
            if factor < 1 and np.abs(rows[:, columns]).max() < SMALLEST_DEGREES:
                continue  # else small offsets would be explained away
            changed = rows.copy()
            changed[:, columns] *= factor
            yield changed
    yield rows * [2, 1, 1, 1]
    yield rows * [0.5, 1, 1, 1]
    whole = rows.copy()
    angles = whole[:, [THETA, ALPHA]]
    right = np.round(angles / (np.pi / 2)) * np.pi / 2
    whole[:, [THETA, ALPHA]] = np.where(np.abs(angles - right) < 0.011, right, angles)
    yield whole


def _of_row(arm, i):
    rows = arm.table.rows
    for pair in ([D, A], [THETA, ALPHA]):
        changed = rows.copy()
        changed[i, pair] = rows[i, pair[::-1]]
        yield Repair(with_rows(arm, changed))
    one = np.where(np.arange(len(arm)) == i, -1, 1)
    yield Repair(with_parts(arm, sign=arm.sign * one))
    changed = rows.copy()
    changed[i, THETA] *= -1
    yield Repair(with_rows(arm, changed, sign=arm.sign * one))
    letter = "P" if arm.table.joints[i] == "R" else "R"
    yield Repair(
        with_rows(arm, rows, joints=arm.table.joints[:i] + letter + arm.table.joints[i + 1 :])
    )
    for k in (i - 1, i + 1):
        if 0 <= k < len(arm) and rows[i, THETA]:
            changed = rows.copy()
            changed[k, THETA] += changed[i, THETA]
            changed[i, THETA] = 0
            yield Repair(with_rows(arm, changed))
    if i + 1 < len(arm) and rows[i, A] and not rows[i + 1, D]:
        changed = rows.copy()
        changed[i + 1, D], changed[i, A] = changed[i, A], 0
        yield Repair(with_rows(arm, changed))


def _of_frame(arm, i):
    """What is left to do when an axis was turned round by half: every part of the two flips (a part
    and its rest do the same).
    """
    for kept in product((0, 1), repeat=4):
        if 0 < sum(kept) <= 2:
            yield Repair(with_rows(arm, flipped_x(arm, i, kept)))
    for kept in product((0, 1), repeat=5):
        if 0 < sum(kept) <= 2:
            yield Repair(flipped_z(arm, i, kept))
    rows = arm.table.rows
    rows[i, THETA], rows[i + 1, THETA] = half_turn(rows[i, THETA]), half_turn(rows[i + 1, THETA])
    yield Repair(with_rows(arm, rows))
