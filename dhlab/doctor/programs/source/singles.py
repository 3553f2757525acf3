"""Every small change of a program by itself: whether it makes everything right; if not, how much of
it, and what the program answers then.
"""

import copy
from functools import cached_property

import numpy as np

from ..running.deadline import OutOfTime, limited
from .changes.edits import changes_of
from .held import kinds_of

__all__ = ["LIKELIEST", "Singles", "is_one_link"]

SINGLES = 0.65  # of the time, for single changes
EACH = 0.1  # s of the processor for one changed program; a changed loop may never end
MANY = 5  # times as long, for all calls
SLOW = 2.5e-3  # s for one call
GENERAL = (7, 9, 11)  # calls with numbers of either sign
ALL = 10**6  # in place of a score, where all that is scored is right
LAST = np.array([0, 0, 0, 1.0])  # row of a pose
UNFELT, BENT = -1, -2  # in place of a score
STRAIGHT = 16  # what an answer counts that becomes a pose, in entries
BEST = 40  # changes that make more right than was right before, tried in pairs
LIKELIEST = 3  # of them, which are tried with every other change first


class Singles:
    """The changes of a text, tried one by one by :meth:`single`: those that are ``better`` than
    none, of these the ``mending`` ones that make the first wrong call right, the ``answers`` to a
    ``few`` calls; and of all those that are ``felt`` in the first wrong call, those that make it no
    pose, ``bent``, and the ``others``, some of which are felt in ``far`` calls.

    Parameters
    ----------
    text : Text
    tried : Tried
    clock : Budget
    arm : Arm, optional
        The one arm that the program is for.
    """

    def __init__(self, text, tried, clock, arm=None):
        self.text, self.tried, self.clock = text, tried, clock
        self.scored, self.better, self.mending, self.answers = [], [], [], {}
        self.memory = None  # of a slow program, what its functions gave
        self.felt, self.far, self.others, self.bent = [], [], [], []
        kinds = self.made((), lambda f: kinds_of(f, *copy.deepcopy(tried.calls[0][0])), {})
        self.changes = changes_of(text, arm, kinds)
        self.of_an_arm = arm is not None

    def single(self):
        """The first change that makes everything right; on the way those that make more right are
        noted, and those that change the first wrong answer.
        """
        self.tried.look_at(self.pivot)
        before = self.made((), self.tried.score) or 0
        self.memory = {} if self._seconds_of(()) > SLOW else None
        kept = (1 - SINGLES) * self.clock.left
        for change in self.changes if self.memory is None else self._soonest():
            if self.clock.left < kept:
                break
            if self.memory is not None and self._seconds_of(change) > SLOW:
                if self.made(change, self._right_at_pivot, False) and self.all_right(change):
                    return (change,)
                continue
            if self._is_right(change, before):
                return (change,)
        self.scored.sort(key=lambda entry: -entry[0])
        self.better = [change for _, change in self.scored[:BEST]]
        self.mending = [change for score, change in self.scored if score == ALL][:LIKELIEST]
        return ()

    def _is_right(self, change, before):
        """Whether a change makes everything right; what it does is noted, beside the score of the
        program as it stands.
        """
        near, score, few = self.made(change, self._looked_at, (False, UNFELT, None))
        if score is None and self.all_right(change):
            return True
        if few is not None:  # of those that make the same of these, the likeliest are kept
            self.answers.setdefault(few.round(9).tobytes(), []).append((change, few))
        kind = self.felt if near else self.bent if score == BENT else self.others
        kind.append(change)
        if not near and score not in (UNFELT, BENT):
            self.far.append(change)
        if (score is None or score > before) and not self._is_known(few):
            self.scored.append((score or ALL, change))
        return False

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
        self.made(edits, self._right_at_pivot)
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
        alone = [k for k in range(len(calls)) if is_one_link(calls[k][0])]
        return sorted({self.pivot, *(k for k in GENERAL[:2] if k < len(calls)), *alone[:1]})

    @cached_property
    def few_right(self):
        return np.array([self.tried.calls[k][1] for k in self.few])

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
        return [(k, self.made((), lambda f, k=k: self.tried.deviation(f, k))) for k in calls]

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
        return self.made((), lambda f: self.tried.deviation(f, self.pivot))

    @cached_property
    def wrong(self):
        """Whether that call is wrong by itself, and not only after others."""
        return self.off is None or not self.tried.is_none(self.off, self.pivot).all()

    @cached_property
    def pivot(self):
        """The first call that goes wrong."""
        return self.first_wrong(())

    def first_wrong(self, edits):
        """The first call that goes wrong with a change."""
        tried = self.tried

        def look(f):
            return next((k for k in range(len(tried.calls)) if not tried.is_right(f, k)), 0)

        return self.made(edits, look, 0)

    def all_right(self, edits):
        """Whether everything is right; asked where the first wrong call is."""
        memory, self.memory = self.memory, None
        seconds = min(MANY * EACH, max(EACH, self.clock.left))
        try:
            return self.made(edits, self.tried.all_right, False, seconds)
        finally:
            self.memory = memory

    def made(self, edits, look, otherwise=None, seconds=EACH):
        """What a look at the changed program shows; ``otherwise`` where it is none or takes too
        long.
        """

        def make_and_look():
            return look(self.text.function(edits, self.memory))

        try:
            return limited(seconds, make_and_look)
        except (Exception, SystemExit, OutOfTime):
            return otherwise


def is_one_link(given):
    """Whether one link was asked for, and of that no number is 0."""
    return np.size(given[0]) * len(given) in (4, 8) and np.all([np.all(part) for part in given])
