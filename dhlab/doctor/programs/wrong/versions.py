"""A list of wrong versions of one program, made when it is first looked at."""

from collections.abc import Sequence
from functools import cached_property

import numpy as np

__all__ = ["Versions"]


class Versions(Sequence):
    """Wrong versions of a program, each ``(mistake, place, function)``.

    Parameters
    ----------
    made : callable
        Yields all of them.
    sample : callable
        The arguments, general ones, at which they are compared: a version whose answer an earlier
        one gives under another id is left out; first come, first named.
    right : callable, optional
        The right program, where some versions may be right all the same; they are left out too.

    Examples
    --------
    >>> twice = Versions(
    ...     lambda: [("a", "", np.sin), ("b", "", np.cos), ("c", "", lambda x: -np.sin(-x))],
    ...     lambda: (0.3,),
    ... )
    >>> [mistake for mistake, _, _ in twice]
    ['a', 'b']
    """

    def __init__(self, made, sample, right=None):
        self._made, self._sample, self._right = made, sample, right

    @cached_property
    def _kept(self):
        sample = self._sample()
        kept, seen = [], {}  # whose answers are known, and they, by their shape
        with np.errstate(all="ignore"):
            if self._right is not None:
                right = np.asarray(self._right(*sample))
                seen[right.shape] = [""], [right]
            for mistake, place, version in self._made():
                T = np.asarray(version(*sample))
                names, answers = seen.setdefault(T.shape, ([], []))
                if not any(names[k] != mistake for k in _like(T, answers)):
                    kept.append((mistake, place, version))
                    names.append(mistake)
                    answers.append(T)
        return kept

    def __len__(self):
        return len(self._kept)

    def __getitem__(self, k):
        return self._kept[k]


def _like(T, answers):
    """Which of the answers, all of one shape, are T."""
    if not answers:
        return ()
    near = np.isclose(T, answers, rtol=1e-9, atol=1e-9, equal_nan=True)
    return np.flatnonzero(near.reshape(len(answers), -1).all(axis=1))
