"""How much of what a program answers is right, in calls whose right answers are known."""

import copy
from functools import cached_property

import numpy as np

from ....transform import inverse

__all__ = ["FIRST", "Tried", "joints_apart", "turns_between"]

FIRST = 6  # calls that tell which changes make more right
WEIGHT = 8  # of a right turn between two calls, in entries
FLAT = 1e-3  # a determinant; what makes everything nothing keeps nothing as it is
APART = 16  # of a joint that a wrong place stands before or behind, in entries


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


def joints_apart(poses, right, tolerance=1e-6):
    """How many joints of an arm move nothing that is wrong: each stands as a whole behind all that
    is wrong, or before it.

    What is wrong in one place, L W R where L A R is right, leaves ``poses @ inverse(right)`` as it
    is when joints of R move, and ``inverse(right) @ poses`` when joints of L do; whatever stands
    at that place, a pose or not.

    Parameters
    ----------
    poses, right : arrays (n + 1, 4, 4)
        At a first configuration, then with each joint moved alone.

    Examples
    --------
    >>> from dhlab.transform import rot_z, trans_x
    >>> def arm(q, a):
    ...     return rot_z(q[0]) @ trans_x(0.4) @ rot_z(q[1]) @ trans_x(a)
    >>> q = [(0.1, 0.2), (0.9, 0.2), (0.1, 0.7)]
    >>> joints_apart(np.array([arm(one, 0.3) for one in q]), np.array([arm(one, 0.5) for one in q]))
    2
    """
    whole = np.allclose(poses[:, 3], [0, 0, 0, 1], atol=tolerance)
    if not whole or np.abs(np.linalg.det(poses)).min() < FLAT:
        return 0
    back = inverse(right)
    off = [
        np.abs(change[1:] - change[0]).max(axis=(1, 2)) <= tolerance
        for change in (poses @ back, back @ poses)
    ]
    return int((off[0] | off[1]).sum())


class Tried:
    """The calls by which a program is judged: ``calls`` of (arguments, right answer), the simplest
    first; of an arm, ``joints`` of them move one joint alone, after the first.
    """

    def __init__(self, calls, tolerance, joints=0):
        self.calls, self.tolerance, self.joints = calls, tolerance, joints
        self.looked_at = range(min(joints + 1 if joints else FIRST, len(calls)))  # for the score

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
        mine = tuple(g.copy() if isinstance(g, np.ndarray) else copy.deepcopy(g) for g in given)
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
            if self.joints:
                return right + APART * joints_apart(answers, self.right, self.tolerance)
            kept = np.abs(turns_between(answers) - turns_between(self.right)) <= self.tolerance
        return right + WEIGHT * int(kept.sum())

    @cached_property
    def right(self):
        """The right answers to the calls that are scored."""
        return np.array([self.calls[k][1] for k in self.looked_at])

    def look_at(self, pivot):
        """Judge by the first calls; by those from the pivot on where all before it are right."""
        many = len(self.looked_at)
        if pivot >= many - 1:
            first, self.joints = min(pivot, len(self.calls) - many), 0
            self.looked_at = range(first, first + many)
            self.__dict__.pop("right", None)

    def is_right(self, f, k):
        """Whether the answer to a call is right."""
        entries = self.entries(f, k)
        return entries is not None and bool(entries.all())

    def all_right(self, f):
        """Whether all answers are right, and the first once more at the end."""
        return all(self.is_right(f, k) for k in (*range(len(self.calls)), 0))
