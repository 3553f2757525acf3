"""Every mistake at every place of a right arm, and what takes them back."""

from dataclasses import dataclass
from math import isclose

import numpy as np

from ...arm import Arm
from .changes import ALL, EACH, FIRST, LAST, SLIDING, ArmChange, Change, RowChange, Scaled
from .registry import changes
from .remade import with_rows

__all__ = ["Fault", "faults", "repairs", "which_rows"]

SMALLEST_DEGREES = 2  # a table whose angles are all below this was not written in degrees


@dataclass(frozen=True)
class Fault:
    """A mistake made at one place of a right arm.

    ``joint`` is 1-based or None; ``parameter`` the number or part that it changes, or None;
    ``place`` where it is, in words, in a table that was typed, and ``row`` the first row of it, 0
    for the whole table; ``change`` the way it was made.
    """

    mistake: str
    joint: int | None
    parameter: str | None
    arm: Arm
    place: str
    row: int
    change: Change


def faults(arm, typed=False, program=False):
    """Every mistake at every place, made on a right arm; those that change nothing in the numbers
    are left out.

    Parameters
    ----------
    arm : Arm
    typed : bool
        Only what may happen to a table that is typed: other numbers, another convention, other
        joint letters.
    program : bool
        Only what may happen in a program: nothing that happens to whole arms only.

    Yields
    ------
    Fault
    """
    for change in changes(RowChange, ArmChange):
        if program and getattr(change, "only", None) == "arm":
            continue
        made = _of_rows if isinstance(change, RowChange) else _of_arm
        for fault in made(change, arm, typed):
            if fault.arm != arm and not (typed and _more_than_rows(fault.arm, arm)):
                yield fault


def _more_than_rows(wrong, arm):
    """Whether something changes that does not stand in a table."""
    return any(
        not np.array_equal(getattr(wrong, part), getattr(arm, part))
        for part in ("base", "tool", "sign")
    )


def _of_rows(change, arm, typed):
    where = change.rows if change.typed is None or not typed else change.typed
    for i in which_rows(where, arm):
        row = 0 if i is None else i + 1
        joint = None if i is None or change.end else row
        parameter, place = change.end or change.parameter, change.place_of(row)
        wrong = _changed(arm, change.change, i)
        yield Fault(change.mistake, joint, parameter, wrong, place, row, change)


def which_rows(where, arm):
    """The rows (from 0, None for all at once) that a tuple of EACH, ALL, … stands for."""
    n = len(arm)
    known = {
        EACH: range(n),
        ALL: [None],
        FIRST: [0],
        LAST: [n - 1],
        SLIDING: np.flatnonzero(arm.table.prismatic).tolist(),
    }
    for name in where:
        yield from known[name]


def _changed(arm, change, i):
    """The arm with one row, or all of them (None), put through a change."""
    rows = arm.table.rows
    if i is None:
        rows = np.column_stack(change(*rows.T))
    else:
        rows[i] = change(*rows[i])
    return with_rows(arm, rows)


def _of_arm(change, arm, typed):
    if change.only not in (None, "typed" if typed else "arm"):
        return
    for joint, place, wrong in change.make(arm):
        yield Fault(change.mistake, joint, change.parameter, wrong, place, joint or 0, change)


def repairs(arm):
    """What takes each mistake back that may have been made on a wrong arm, without a number to
    guess: yields (Arm, entries (row, column) that are left to be fitted).

    A single number needs none: every number of a table is fitted by itself anyway.
    """
    for change in changes(RowChange, ArmChange):
        if isinstance(change, ArmChange):
            yield from change.taken_back(arm)
        elif change.undone is not None:
            for i in which_rows(change.rows, arm):
                if (i is None or change.parameter is None) and _may_be(change, arm):
                    yield _changed(arm, change.undone, i), ()


def _may_be(change, arm):
    """Whether the wrong table can be this one; else small angles would be explained away."""
    if not isinstance(change.undone, Scaled):
        return True
    in_degrees = [isclose(factor, np.pi / 180) for factor in change.undone.factors]
    return not any(in_degrees) or np.abs(arm.table.rows[:, in_degrees]).max() >= SMALLEST_DEGREES
