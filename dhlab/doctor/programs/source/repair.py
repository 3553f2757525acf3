"""The line that must change: a program is tried again and again with one thing in its text changed,
or two, until it is right in every call.
"""

import copy
import time
from functools import cached_property
from itertools import chain, product

import numpy as np

from ...diagnosis import Line
from ..running.deadline import OutOfTime, limited
from .constants import fitted_numbers
from .edits import changes_of

__all__ = ["Tried", "lines_of", "repaired"]

EACH = 0.1  # s of the processor for one changed program; a changed loop may never end
FIRST = 4  # calls that tell which changes make more right
ALL = 16 * FIRST
UNFELT, BENT = -1, -2  # in place of a score
STRAIGHT = 16  # what an answer counts that becomes a pose, in entries
WEIGHT = 8  # of a right turn between two calls, in entries
LIKELIEST = 3  # of them, which are tried with every other change first
BEST = 40  # changes that make more right than was right before, tried in pairs


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
        calls = self.calls[:FIRST]
        offs = [self.deviation(f, k) for k in range(len(calls))]
        if any(off is None for off in offs):
            return sum(self.is_none(off, k).sum() for k, off in enumerate(offs) if off is not None)
        right = sum(int(self.is_none(off, k).sum()) for k, off in enumerate(offs))
        if right == sum(T.size for _, T in calls):
            return None
        with np.errstate(all="ignore"):
            answers = np.array([off + T for off, (_, T) in zip(offs, calls)])
            kept = np.abs(turns_between(answers) - self.turns) <= self.tolerance
        return right + WEIGHT * int(kept.sum())

    @cached_property
    def turns(self):
        """:func:`turns_between` the right answers."""
        return turns_between(np.array([T for _, T in self.calls[:FIRST]]))

    def is_right(self, f, k):
        """Whether the answer to a call is right."""
        entries = self.entries(f, k)
        return entries is not None and bool(entries.all())

    def all_right(self, f):
        """Whether all answers are right, and the first once more at the end."""
        return all(self.is_right(f, k) for k in (*range(len(self.calls)), 0))


def repaired(text, tried, seconds):
    """The change of a program's text, or the two changes, that make it right in every call.

    Parameters
    ----------
    text : Text
    tried : Tried
    seconds : float
        Of the processor, for the whole search.

    Returns
    -------
    (tuple of tuples of Edit, list of (tuple of Edit, function))
        The changes, empty when none is found in time; and then single ones that make more of the
        answers right, with the functions that they make, the best first.
    """
    search = _Search(text, tried, time.process_time() + seconds)
    try:
        with np.errstate(all="ignore"):
            found = search.single() or search.number() or search.pair()
    except OutOfTime:
        found = ()
    return found, [(change, text.function(change)) for change in search.better]


class _Search:
    def __init__(self, text, tried, end):
        self.text, self.tried, self.end = text, tried, end
        self.changes, self.better = changes_of(text), []
        self.felt, self.others = [], []

    def single(self):
        """The first change that makes everything right; on the way those that make more right are
        noted, and those that change the first wrong answer.
        """
        before = self._made((), self.tried.score) or 0
        scored = []
        for change in self.changes:
            if time.process_time() > self.end:
                break
            score = self._made(change, self._score, UNFELT)
            if score is None and self._made(change, self.tried.all_right, False):
                return (change,)
            if score != BENT:
                (self.others if score == UNFELT else self.felt).append(change)
            if score is None or score > before:
                scored.append((score or ALL, change))
        scored.sort(key=lambda entry: -entry[0])
        self.better = [change for _, change in scored[:BEST]]
        return ()

    def _score(self, f):
        """:meth:`Tried.score`, None where the first wrong answer is right, UNFELT where it is as it
        was or there is none, BENT where it was a pose and is none now.
        """
        off = self.tried.deviation(f, self.pivot)
        if off is None or (self.off is not None and np.array_equal(off, self.off)):
            return UNFELT if self.wrong else None
        if self.tried.is_none(off, self.pivot).all():
            return None
        is_pose = self._is_pose(off)
        if self.was_pose and not is_pose:
            return BENT
        score = self.tried.score(f)
        return score and score + (STRAIGHT if is_pose and not self.was_pose else 0)

    def _is_pose(self, off):
        """Whether the first wrong answer, with another deviation, is a pose."""
        T = off + self.tried.calls[self.pivot][1]
        R = T[:3, :3]
        return bool(
            np.allclose(T[3], [0, 0, 0, 1])
            and np.abs(R @ R.T - np.eye(3)).max() < 1e-6
            and np.linalg.det(R) > 0
        )

    @cached_property
    def was_pose(self):
        """Whether it is one as it stands."""
        return self.off is not None and self._is_pose(self.off)

    @cached_property
    def off(self):
        """The deviation in the first wrong call; None where there is no answer."""
        return self._made((), lambda f: self.tried.deviation(f, self.pivot))

    @cached_property
    def wrong(self):
        """Whether that call is wrong by itself, and not only after others."""
        return self.off is None or not self.tried.is_none(self.off, self.pivot).all()

    @cached_property
    def pivot(self):
        """The first call that goes wrong."""
        tried = self.tried

        def first_wrong(f):
            return next((k for k in range(len(tried.calls)) if not tried.is_right(f, k)), 0)

        return self._made((), first_wrong, 0)

    def number(self):
        """A number that is written in, and with another value makes everything right."""

        def deviation(edits):
            if time.process_time() > self.end:
                raise OutOfTime
            return self._made(edits, lambda f: self.tried.deviation(f, self.pivot))

        edits = fitted_numbers(self.text, deviation)
        right = (edit for edit in edits if self._made((edit,), self.tried.all_right, False))
        return next((((edit,),) for edit in right), ())

    def pair(self):
        """The first two changes that together make everything right."""
        best = self.better
        tried = chain(
            product(best[:LIKELIEST], self.felt),
            ((first, second) for i, first in enumerate(best) for second in best[:i]),
            product(best[:LIKELIEST], self.others),
            product(best[LIKELIEST:], self.felt),
        )
        return next((pair for pair in tried if self._are_right(*pair)), ())

    def _made(self, edits, look, otherwise=None):
        """What a look at the changed program shows; ``otherwise`` where it is none or takes too
        long.
        """

        def make_and_look():
            return look(self.text.function(edits))

        try:
            return limited(EACH, make_and_look)
        except (Exception, SystemExit, OutOfTime):
            return otherwise

    def _are_right(self, first, second):
        if time.process_time() > self.end:
            raise OutOfTime
        if not all(a.end <= b.start or b.end <= a.start for a in first for b in second):
            return False
        edits = (*first, *second)
        return self._made(
            edits, lambda f: self.tried.is_right(f, self.pivot), False
        ) and self._made(edits, self.tried.all_right, False)


def lines_of(text, changes):
    """The lines that changes of a text change, as Lines."""
    edits = [edit for change in changes for edit in change]
    edited = text.edited(edits).splitlines()
    found = []
    for edit in sorted(edits, key=lambda edit: edit.start):
        number = text.line_at(edit.start)
        before = text.data[: edit.start].count(b"\n")
        moved = sum(
            e.new.count(b"\n") - text.data[e.start : e.end].count(b"\n")
            for e in edits
            if e.start < edit.start
        )
        instead = edited[before + moved].strip() if before + moved < len(edited) else ""
        if edit.start == edit.end and b"\n" in edit.new:
            where = "behind" if edit.new.startswith(b"\n") else "before"
            instead = f"{edit.new.decode().strip()}  (a new line {where} this one)"
        found.append(Line(number, text.line(number), instead))
    return tuple(found)
