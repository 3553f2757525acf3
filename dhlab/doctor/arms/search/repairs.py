"""Changes of a candidate arm, without a number to guess, that might make it right."""

from dataclasses import dataclass
from itertools import product

import numpy as np

from ....arm import Arm
from ...mistakes.faults import repairs
from ...mistakes.remade import THETA, A, D, with_rows

__all__ = ["Repair", "discrete_repairs"]

INCH = 25.4e-3  # m


@dataclass(frozen=True)
class Repair:
    """A changed candidate; ``free`` are (row, column) whose values the change leaves to be
    fitted.
    """

    arm: Arm
    free: tuple = ()


def discrete_repairs(arm):
    """Every mistake taken back, each arm once."""
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
        None if arm.coupling is None else arm.coupling.tobytes(),
        arm.base.tobytes(),
        arm.tool.tobytes(),
    )


def _all(arm):
    for repaired, free in repairs(arm):
        yield Repair(repaired, free)
    yield from _of_two(arm)


def _of_two(arm):
    """Two mistakes that are often made together, offsets halved, one column in inches."""
    rows = arm.table.rows
    yield Repair(with_rows(arm, rows * [-1, 1, 1, -1]))
    yield Repair(with_rows(arm, rows * [2, 1, 1, 1]))
    for column, factor in product((D, A), (INCH, 1 / INCH)):
        yield Repair(with_rows(arm, rows * np.where(np.arange(4) == column, factor, 1)))
    for i in range(len(arm)):
        turned = np.where(np.arange(len(arm)) == i, -1, 1)
        changed = arm.table.rows
        changed[i, THETA] *= -1
        yield Repair(with_rows(arm, changed, sign=arm.sign * turned))
