"""The line that must change: a program is tried again and again with one thing in its text changed,
or two, until it is right in every call.
"""

from itertools import chain, combinations, product

import numpy as np

from ...budget import Budget
from ..running.deadline import OutOfTime
from .changes.statements import turns_of
from .constants import fitted_numbers
from .foretold import foretold_pairs
from .singles import LIKELIEST, Singles, is_one_link
from .text import Edit

__all__ = ["repaired"]

LIKELY = 12  # of the best changes, which are tried with each other first


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
                or search.beside(search.mending, likely=True)
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


class _Search(Singles):
    def number(self, beside=()):
        """A number that is written in, and with another value makes everything right, beside
        another change.
        """

        def deviation(edits):
            if self.clock.left < 0:
                raise OutOfTime
            if not _are_apart(edits, beside):
                return None
            return self.made((*beside, *edits), lambda f: self.tried.deviation(f, self.pivot))

        for edit in fitted_numbers(self.text, deviation, self.of_an_arm):
            if self.all_right((*beside, edit)):
                return tuple(change for change in (beside, (edit,)) if change)
        return ()

    def with_a_number(self):
        """One of the best changes, and a number."""
        found = (self.number(change) for change in self.better[:LIKELIEST])
        return next(filter(None, found), ())

    def foretold(self):
        """The first two changes whose answers tell that together they make everything right."""
        before = self.made((), self._few)
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
        alone = [i for i, k in enumerate(self.few) if is_one_link(self.tried.calls[k][0])]
        wrong = not np.allclose(before[alone], self.few_right[alone], atol=self.tried.tolerance)
        if alone and wrong and len(alone) < len(self.few):
            yield alone

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

    def beside(self, changes, likely=False):
        """One of some changes with any other one, or with a ``likely`` one. Where it mends the
        first wrong call, the other is seen in a later one.
        """
        for first in changes:
            k = self.first_wrong(first)
            others = (self.felt, self.others, self.bent)
            if k != self.pivot:
                others = (self.others, self.felt, self.bent)
            for second in chain(*others):
                if likely and second[0].rank:
                    continue
                if both := self._are_right(first, second, k):
                    return both
        return ()

    def _are_right(self, first, second, k):
        """The two changes, as :func:`_together` has them, if they make all right; call k first."""
        if self.clock.left < 0:
            raise OutOfTime
        changes = _together(first, second, self.text)
        edits = tuple(edit for change in changes for edit in change)
        right = (
            bool(edits)
            and self.made(edits, lambda f: self.tried.is_right(f, k), False)
            and self.all_right(edits)
        )
        return changes if right else ()


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
