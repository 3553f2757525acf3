"""What is wrong with a table that was written down: the changes to the right table that give the
same arm.
"""

from functools import lru_cache

import numpy as np

from ...arm import Arm
from ..finding import find
from ..mistakes.faults import faults
from ..mistakes.registry import preference
from ..mistakes.remade import D, with_parts
from ..mistakes.together import ends_of

__all__ = ["explain_rows", "wrong_tables"]


def explain_rows(given, right, q):
    """The mistake that turns the right arm into the given one.

    Parameters
    ----------
    given : Arm
        The answer; its poses differ from the right ones.
    right : Arm
    q : array (m, n)
        Configurations at which the poses are compared, general ones (no zeros, no multiples of
        90°).

    Returns
    -------
    Finding or None

    Examples
    --------
    >>> import dhlab as dh
    >>> right = dh.load("article-6r")
    >>> rows = right.table.rows
    >>> rows[3, 3] *= -1
    >>> q = np.random.default_rng(1).uniform(-2, 2, (5, 6))
    >>> explain_rows(dh.Arm(dh.DHTable.standard(rows, angle="rad")), right, q).message[:32]
    'alpha has the wrong sign (row 4)'
    """
    if len(given) != len(right):
        return None
    made, ends = _made(right, np.asarray(q, dtype=float).tobytes())
    off = np.abs(ends - given.forward(q)).reshape(len(made), -1).max(axis=1)
    fitting = [
        made[k]
        for k in np.flatnonzero(off <= 1e-8)
        if not _slid_elsewhere(made[k].arm.table, given.table)
    ]
    if not fitting:
        return None
    told = _best(fitting, given.table, right.table)
    return find(told.mistake, told.place)


@lru_cache(maxsize=2)
def _made(right, q):
    """Every mistake in the table of a right arm, and where the arm's end would then be (k, m, 4, 4)
    at the configurations with these bytes: kept for the next try.
    """
    made = list(faults(Arm(right.table), typed=True))
    arms = [with_parts(right, table=fault.arm.table) for fault in made]
    return made, ends_of(arms, np.frombuffer(q).reshape(-1, len(right)))


def _best(fitting, given, right):
    """Of several that make the same arm: what stands there, then the smallest change, then the
    better known; and one row of it before all rows.
    """

    def fit(fault):
        return not _written_alike(fault.arm.table, given), _changed(fault.arm.table, right)

    best = min(fitting, key=lambda fault: (*fit(fault), fault.row > 0, preference(fault.mistake)))
    same = (f for f in fitting if f.mistake == best.mistake and f.row and fit(f) == fit(best))
    return best if best.row else next(same, best)


def _slid_elsewhere(wrong, given):
    """Whether a wrong table becomes the given one by steps along parallel axes that other rows
    hold: the place of its mistake is not true of the given one.
    """
    off = np.abs(wrong.rows - given.rows) > 1e-9
    return (
        wrong.convention == given.convention and off[:, D].any() and not np.delete(off, D, 1).any()
    )


def _written_alike(a, b):
    return a.convention == b.convention and np.allclose(a.rows, b.rows, rtol=0, atol=1e-9)


def _changed(a, b):
    """How many numbers are changed."""
    return int((np.abs(a.rows - b.rows) > 1e-9).sum()) if a.convention == b.convention else 1


def wrong_tables(table):
    """Tables that hold one mistake each: yields (mistake, place, DHTable), those of the whole table
    first, then row by row.
    """
    for fault in sorted(faults(Arm(table), typed=True), key=lambda fault: fault.row):
        yield fault.mistake, fault.place, fault.arm.table
