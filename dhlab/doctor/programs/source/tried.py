"""How much of what a program answers is right, in calls whose right answers are known."""

import copy
from functools import cached_property

import numpy as np

__all__ = ["FIRST", "Tried", "turns_between"]

FIRST = 6  # calls that tell which changes make more right
WEIGHT = 8  # of a right turn between two calls, in entries


def turns_between(poses):
    """The trace of the turn from the first pose to each other one, (m - 1,): the same whatever
    constant base and tool stand at the ends.

    Examples
    --------
    >>> poses = np.array([np.eye(4), np.diag([-1, -1, 1, 1])])
    >>> turns_between(poses)
    array([-1.])
    """
    return np.einsum("kij,ij->k", poses[1:, :3, :3], poses[0, :3, :3])


class Tried:
    """The calls by which a program is judged: ``calls`` of (arguments, right answer), the simplest
    first.
    """

    def __init__(self, calls, tolerance):
        self.calls, self.tolerance = calls, tolerance
        self.looked_at = range(min(FIRST, len(calls)))  # the calls that are scored

    def entries(self, f, k):
        """Which entries of the answer to call k are right; None where there is no answer, or the
        arguments are changed.
        """
        off = self.deviation(f, k)
        return None if off is None else self.is_none(off, k)

    def is_none(self, off, k):
        """Which entries of a deviation in call k are none."""
        return np.abs(off) <= self.tolerance * (1 + np.abs(self.calls[k][1]))

    def deviation(self, f, k):
        """The answer to call k minus the right one; None as for :meth:`entries`."""
        given, right = self.calls[k]
        mine = copy.deepcopy(given)
        try:
            answer = np.asarray(f(*mine), dtype=float)
        except (Exception, SystemExit):
            return None
        same = answer.shape == right.shape and all(map(np.array_equal, given, mine))
        return answer - right if same else None

    def score(self, f):
        """How much is right in the first calls: entries, and what wrong ends leave as it is; None
        when all entries are right.
        """
        offs = [(self.deviation(f, k), k) for k in self.looked_at]
        if any(off is None for off, _ in offs):
            return sum(int(self.is_none(off, k).sum()) for off, k in offs if off is not None)
        right = sum(int(self.is_none(off, k).sum()) for off, k in offs)
        if right == sum(off.size for off, _ in offs):
            return None
        with np.errstate(all="ignore"):
            answers = np.array([off + self.calls[k][1] for off, k in offs])
            kept = np.abs(turns_between(answers) - self.turns) <= self.tolerance
        return right + WEIGHT * int(kept.sum())

    @cached_property
    def turns(self):
        """:func:`turns_between` the right answers."""
        return turns_between(np.array([self.calls[k][1] for k in self.looked_at]))

    def look_at(self, pivot):
        """Judge by the first calls; by those from the pivot on where all before it are right."""
        first = 0 if pivot < FIRST - 1 else min(pivot, len(self.calls) - FIRST)
        self.looked_at = range(first, first + FIRST)
        self.__dict__.pop("turns", None)

    def is_right(self, f, k):
        """Whether the answer to a call is right."""
        entries = self.entries(f, k)
        return entries is not None and bool(entries.all())

    def all_right(self, f):
        """Whether all answers are right, and the first once more at the end."""
        return all(self.is_right(f, k) for k in (*range(len(self.calls)), 0))
