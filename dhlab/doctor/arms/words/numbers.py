"""The name of one wrong number: by what stood there and what should."""

import numpy as np

from ....table import COLUMNS
from ...mistakes.changes import EACH, RowChange, Scaled
from ...mistakes.faults import which_rows
from ...mistakes.registry import changes, preference, value_mistake
from ...mistakes.remade import ALPHA, THETA
from .differences import wrapped

__all__ = ["name_number"]

NOTHING = 1e-9  # a number below this was 0
TURN = 2 * np.pi  # beyond it an angle is taken as it stands, not round the circle


def name_number(was, should, arm, entry):
    """The id of the mistake that puts one number in another's place.

    Parameters
    ----------
    was, should : float
        What stood there and what should; radians or metres.
    arm : Arm
    entry : (row, column)
        Of the table, from 0.

    Returns
    -------
    str

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("article-6r")
    >>> name_number(-0.4, 0.4, arm, (1, 2)), name_number(0.45, 0.4, arm, (1, 2))
    ('length-sign', 'length-value')
    """
    i, column = entry
    for change in _of_one_number():
        there = not change.rows or i in which_rows(change.rows, arm)
        if change.parameter == COLUMNS[column] and there and _makes(change, was, should, column):
            return change.mistake
    return value_mistake(COLUMNS[column])


def _of_one_number():
    """What is made in particular rows first, then as the preference says."""
    known = [change for change in changes(RowChange) if change.parameter is not None]
    return sorted(
        known,
        key=lambda change: (not change.rows or EACH in change.rows, preference(change.mistake)),
    )


def _makes(change, was, should, column):
    """Whether the change makes what stood there of what should."""
    row = np.zeros(4)
    row[column] = should
    wrong = float(change.change(*row)[column])
    if isinstance(change.change, Scaled) and wrong == 0:
        return abs(was) < NOTHING
    if column not in (THETA, ALPHA):
        return abs(was - wrong) < change.within * abs(wrong)
    apart = was - wrong
    return abs(wrapped(apart) if abs(wrong) <= TURN else apart) < change.within
