"""The line that must change: a program is tried again and again with one thing in its text changed,
or two, until it is right in every call.
"""

import copy
from functools import cached_property
from itertools import chain, combinations, product

import numpy as np

from ...budget import Budget
from ..running.deadline import OutOfTime, limited
from .changes.edits import changes_of
from .changes.statements import turns_of
from .constants import fitted_numbers
from .foretold import foretold_pairs
from .kinds import kinds_of
from .text import Edit

__all__ = ["repaired"]

SINGLES = 0.65  # of the time, for single changes
EACH = 0.1  # s of the processor for one changed program; a changed loop may never end
MANY = 5  # times as long, for all calls
GENERAL = (7, 9, 11)  # calls with numbers of either sign
ALL = 10**6  # in place of a score, where all that is scored is right
LAST = np.array([0, 0, 0, 1.0])  # row of a pose
UNFELT, BENT = -1, -2  # in place of a score
SLOW = 2.5e-3  # s for one call
STRAIGHT = 16  # what an answer counts that becomes a pose, in entries
LIKELIEST = 3  # of them, which are tried with every other change first
LIKELY = 12  # of them, which are tried with each other before
BEST = 40  # changes that make more right than was right before, tried in pairs


def repaired(text, tried, seconds, arm=None):
    """The change of a program's text, or the two changes, that make it right in every call.

    Parameters
    ----------
    text : Text
    tried : Tried
    seconds : float
        Of the processor, for the whole search.
    arm : Arm, optional
        The one arm that the program is for.

    Returns
    -------
    (tuple of tuples of Edit, list of (tuple of Edit, function))
        The changes, empty when none is found in time, the second an empty one where the first holds
        both; and then single ones that make more of the
        answers right, with the functions that they make, the best first.
    """
    search = _Search(text, tried, Budget(seconds), arm)
    try:
        with np.errstate(all="ignore"):
            found = (
                search.single()
                or search.number()
                or search.foretold()
                or search.beside(search.mending)
                or search.with_a_number()
                or search.beside(search.turning())
                or search.pair()
            )
    except OutOfTime:
        found = ()
    return found, [(change, text.function(change)) for change in search.better]


class _Search:
    def __init__(self, text, tried, clock, arm=None):
        self.text, self.tried, self.clock = text, tried, clock
        self.better, self.mending, self.answers = [], [], {}
        self.memory = None  # of a slow program, what its functions gave
        self.felt, self.far, self.others, self.bent = [], [], [], []
        kinds = self._made((), lambda f: kinds_of(f, *copy.deepcopy(tried.calls[0][0])), {})
        self.changes = changes_of(text, arm, kinds)
        self.of_an_arm = arm is not None

    def single(self):
        """The first change that makes everything right; on the way those that make more right are
        noted, and those that change the first wrong answer.
        """
        self.tried.look_at(self.pivot)
        before = self._made((), self.tried.score) or 0
        self.memory = {} if self._seconds_of(()) > SLOW else None
        kept = (1 - SINGLES) * self.clock.left
        scored = []
        for change in self.changes if self.memory is None else self._soonest():
            if self.clock.left < kept:
                break
            if self.memory is not None and self._seconds_of(change) > SLOW:
                if self._made(change, self._right_at_pivot, False) and self._all_right(change):
                    return (change,)
                continue
            near, score, few = self._made(change, self._looked_at, (False, UNFELT, None))
            if score is None and self._all_right(change):
                return (change,)
            if few is not None:  # of those that make the same of these, the likeliest are kept
                self.answers.setdefault(few.round(9).tobytes(), []).append((change, few))
            kind = self.felt if near else self.bent if score == BENT else self.others
            kind.append(change)
            if not near and score not in (UNFELT, BENT):
                self.far.append(change)
            if (score is None or score > before) and not self._is_known(few):
                scored.append((score or ALL, change))
        scored.sort(key=lambda entry: -entry[0])
        self.better = [change for _, change in scored[:BEST]]
        self.mending = [change for score, change in scored if score == ALL][:LIKELIEST]
        return ()

    def _right_at_pivot(self, f):
        return self.tried.is_right(f, self.pivot)

    def _soonest(self):
        """The changes; first those after which the other functions are only looked up."""
        last = self.text.blocks[-1]
        start, end = self.text.lines_of(last)
        return sorted(self.changes, key=lambda change: not start <= change[0].start < end)

    def _seconds_of(self, edits):
        """How long the first wrong call takes."""
        before = self.clock.left
        self._made(edits, self._right_at_pivot)
        return before - self.clock.left

    def _is_known(self, few):
        """Whether another change, a likelier one, makes the same of a few answers."""
        return few is not None and len(self.answers[few.round(9).tobytes()]) > 1

    def _looked_at(self, f):
        """What :meth:`_score` gives, and :meth:`_few` where the change is felt."""
        near, score = self._score(f)
        return near, score, None if score == UNFELT else self._few(f)

    def _few(self, f):
        """The answers to the first wrong call and to general ones; None where there are none."""
        offs = [self.tried.deviation(f, k) for k in self.few]
        if any(off is None or not np.isfinite(off).all() for off in offs):
            return None
        return np.array(offs) + self.few_right

    @cached_property
    def few(self):
        calls = self.tried.calls
        alone = [k for k in range(len(calls)) if _is_one_link(calls[k][0])]
        return sorted({self.pivot, *(k for k in GENERAL[:2] if k < len(calls)), *alone[:1]})

    @cached_property
    def few_right(self):
        return np.array([self.tried.calls[k][1] for k in self.few])

    def foretold(self):
        """The first two changes whose answers tell that together they make everything right."""
        before = self._made((), self._few)
        if before is None or not self.answers:
            return ()
        kept = list(self.answers.values())
        answers = np.array([group[0][1] for group in kept])
        for part in self._parts(before):
            for i, j in foretold_pairs(before[part], answers[:, part], self.few_right[part]):
                for (first, _), (second, _) in product(kept[i][:2], kept[j][:2]):
                    if changes := self._are_right(first, second, self.few[part[0]]):
                        return changes
        return ()

    def _parts(self, before):
        """The places, among the few calls, of those that follow the same law: all of them; and
        those of one link, since one that stands in a product several times is in none of its places
        alone, and zeros leave no inverse.
        """
        yield list(range(len(self.few)))
        alone = [i for i, k in enumerate(self.few) if _is_one_link(self.tried.calls[k][0])]
        wrong = not np.allclose(before[alone], self.few_right[alone], atol=self.tried.tolerance)
        if alone and wrong and len(alone) < len(self.few):
            yield alone

    def _score(self, f):
        """Whether the first wrong answer changes and is a pose still, and :meth:`Tried.score`: None
        where that answer is right, UNFELT where nothing changes.
        """
        off = self.tried.deviation(f, self.pivot)
        if off is None:
            return False, UNFELT if self.wrong else None
        if self.off is not None and np.array_equal(off, self.off):
            return False, self._score_elsewhere(f) if self.wrong else None
        if self.tried.is_none(off, self.pivot).all():
            return True, None
        is_pose = self._is_pose(off)
        if self.was_pose and not is_pose:
            return False, BENT
        score = self.tried.score(f)
        return True, score and score + (STRAIGHT if is_pose and not self.was_pose else 0)

    def _score_elsewhere(self, f):
        """The score of a change that the first wrong call does not feel: the other mistake may be
        seen in others alone.
        """
        for k, before in self.elsewhere:
            off = self.tried.deviation(f, k)
            if off is None:
                return UNFELT
            if before is None or not np.array_equal(off, before):
                score = self.tried.score(f)
                return UNFELT if score is None else score
        return UNFELT

    @cached_property
    def elsewhere(self):
        """(k, the deviation in call k) of general calls; None where there is no answer."""
        calls = [k for k in GENERAL if k < len(self.tried.calls)]
        return [(k, self._made((), lambda f, k=k: self.tried.deviation(f, k))) for k in calls]

    def _is_pose(self, off):
        """Whether the first wrong answer, with another deviation, is a pose."""
        T = off + self.tried.calls[self.pivot][1]
        R = T[:3, :3]
        return bool(
            np.abs(T[3] - LAST).max() < 1e-6
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
        return self._first_wrong(())

    def _first_wrong(self, edits):
        tried = self.tried

        def first_wrong(f):
            return next((k for k in range(len(tried.calls)) if not tried.is_right(f, k)), 0)

        return self._made(edits, first_wrong, 0)

    def number(self, beside=()):
        """A number that is written in, and with another value makes everything right, beside
        another change.
        """

        def deviation(edits):
            if self.clock.left < 0:
                raise OutOfTime
            if not _are_apart(edits, beside):
                return None
            return self._made((*beside, *edits), lambda f: self.tried.deviation(f, self.pivot))

        for edit in fitted_numbers(self.text, deviation, self.of_an_arm):
            if self._all_right((*beside, edit)):
                return tuple(change for change in (beside, (edit,)) if change)
        return ()

    def with_a_number(self):
        """One of the best changes, and a number."""
        found = (self.number(change) for change in self.better[:LIKELIEST])
        return next(filter(None, found), ())

    def pair(self):
        """The first two changes that together make everything right."""
        best, rest = self.better, self.better[LIKELIEST:]
        done = self.mending
        return (
            self._of(combinations(best[:LIKELY], 2))
            or self.beside([change for change in best[:LIKELIEST] if change not in done])
            or self._of(combinations(best, 2))
            or self._of(product(rest, self.felt))
            or self._of(product(rest, self.far))
        )

    def _of(self, pairs):
        """The first of the pairs that makes everything right."""
        return next(filter(None, (self._are_right(*pair, self.pivot) for pair in pairs)), ())

    def turning(self):
        """Changes of how often a loop turns, or where a function ends: they may hide the other
        mistake until both are mended.
        """
        around = list(turns_of(self.text))
        return [
            change
            for change in (*self.felt, *self.others, *self.bent)
            if change[0].rank == 0 and any(a <= change[0].start < b for a, b in around)
        ][:LIKELIEST]

    def beside(self, changes):
        """One of some changes with any other one. Where it mends the first wrong call, the other is
        seen in a later one.
        """
        for first in changes:
            k = self._first_wrong(first)
            others = (self.felt, self.others, self.bent)
            if k != self.pivot:
                others = (self.others, self.felt, self.bent)
            for second in chain(*others):
                if both := self._are_right(first, second, k):
                    return both
        return ()

    def _all_right(self, edits):
        """Whether everything is right; asked where the first wrong call is."""
        memory, self.memory = self.memory, None
        try:
            return self._made(edits, self.tried.all_right, False, MANY * EACH)
        finally:
            self.memory = memory

    def _made(self, edits, look, otherwise=None, seconds=EACH):
        """What a look at the changed program shows; ``otherwise`` where it is none or takes too
        long.
        """

        def make_and_look():
            return look(self.text.function(edits, self.memory))

        try:
            return limited(seconds, make_and_look)
        except (Exception, SystemExit, OutOfTime):
            return otherwise

    def _are_right(self, first, second, k):
        """The two changes, as :func:`_together` has them, if they make all right; call k first."""
        if self.clock.left < 0:
            raise OutOfTime
        changes = _together(first, second, self.text)
        edits = tuple(edit for change in changes for edit in change)
        right = (
            bool(edits)
            and self._made(edits, lambda f: self.tried.is_right(f, k), False)
            and self._all_right(edits)
        )
        return changes if right else ()


def _is_one_link(given):
    """Whether one link was asked for, and of that no number is 0."""
    return np.size(given[0]) * len(given) in (4, 8) and np.all([np.all(part) for part in given])


def _are_apart(first, second):
    """Whether no edit of the one overlaps one of the other."""
    return all(a.end <= b.start or b.end <= a.start for a in first for b in second)


def _together(first, second, text):
    """Two changes of a text that can be made together; where the one stands in the other, as a
    sign in a product whose factors are exchanged, the first holds both; none where they exclude
    each other.
    """
    if _are_apart(first, second):
        return first, second
    if len(first) > 1 or len(second) > 1:
        return ()
    (outer,), (inner,) = sorted((first, second), key=lambda change: change[0].start - change[0].end)
    old = text.data[inner.start : inner.end]
    if not outer.start <= inner.start < inner.end <= outer.end or outer.new.count(old) != 1:
        return ()
    both = Edit(outer.start, outer.end, outer.new.replace(old, inner.new), outer.rank)
    return (both,), ()
