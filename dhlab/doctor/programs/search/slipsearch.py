"""The search for the one or two slips that turn the right program into the one at hand.

Every wrong program is computed on the first case, whole steps at a time, and what fits there is
tried on all other cases. One slip is preferred to two; of two explanations of one length the one
whose mistake is registered first.
"""

import numpy as np

from ...mistakes.entries import MONOMIALS, RIGHT_ENTRIES
from ...mistakes.themes.links import mistyped
from .candidates import one_slip, two_slips
from .steps import right_link
from .trial import Trial

__all__ = ["search", "wrong_entries"]

MOST_ENTRIES = 3  # mistyped entries in one matrix; with more it is another formula


def search(answers, cases, kind, tolerance=1e-9, pairs=True):
    """The slips that explain the answers.

    Parameters
    ----------
    answers : array (m, 4, 4)
    cases : sequence of m tuples
        ``(theta, d, a, alpha)`` or ``(rows, q)``; radians and metres.
    kind : "dh_transform" or "forward_kinematics"
    tolerance : float
        Largest deviation, absolute and relative.
    pairs : bool
        Whether two slips are tried where one does not explain the answers.

    Returns
    -------
    (tuple of Slip, tuple of str)
        One or two slips, empty when nothing fits; and the ids of other single mistakes that give
        the same answers.
    """
    order = _first_cases(cases, kind)
    trial = Trial([answers[k] for k in order], [cases[k] for k in order], kind, tolerance)
    with np.errstate(all="ignore"):
        singles = list(trial.fitting(one_slip(trial)))
        if singles:
            return singles[0], tuple(
                dict.fromkeys(s.mistake for (s,) in singles if s.mistake != singles[0][0].mistake)
            )
        if kind == "dh_transform":
            several = wrong_entries(answers, cases, tolerance)
            if several:
                return several, ()
        both = list(trial.fitting(two_slips(trial))) if pairs else []
        return min(both, key=_kinds, default=()), ()


def _kinds(made):
    """How many different mistakes slips are: one that is made in two places goes first."""
    return len({slip.mistake for slip in made})


def _first_cases(cases, kind):
    """Cases in the order of trial: a short chain first, though not one so short that shifted and
    reversed look alike.
    """
    if kind == "dh_transform":
        return range(len(cases))
    return sorted(range(len(cases)), key=lambda k: (len(cases[k][1]) < 3, len(cases[k][1])))


def wrong_entries(answers, cases, tolerance=1e-9):
    """Up to three mistyped entries of a link matrix, each told by itself; empty when an entry is no
    single product of the usual factors.

    Parameters
    ----------
    answers : array (m, 4, 4)
    cases : (m, 4) numbers
        theta, d, a, alpha; radians and metres.

    Returns
    -------
    tuple of Slip

    Examples
    --------
    >>> row = np.array([[0.3, 0.1, 0.4, 0.5], [1.1, -0.2, 0.3, -0.7]])
    >>> T = right_link(*row.T)
    >>> T[:, 2, 3] = 0
    >>> [slip.place for slip in wrong_entries(T, row)]
    ['row 3, column 4: 0 stands there']
    """
    row = np.array(cases, dtype=float).T
    right = right_link(*row)
    wrong = [
        tuple(map(int, entry))
        for entry in np.argwhere(
            (np.abs(answers - right) > tolerance * (1 + np.abs(right))).any(axis=0)
        )
    ]
    if not 0 < len(wrong) <= MOST_ENTRIES or any(entry not in RIGHT_ENTRIES for entry in wrong):
        return ()
    found = [_monomial(answers[(slice(None), *entry)], row, tolerance) for entry in wrong]
    return (
        ()
        if None in found
        else tuple(mistyped(entry, monomial) for entry, monomial in zip(wrong, found))
    )


def _monomial(values, row, tolerance):
    return next(
        (
            m
            for m in MONOMIALS
            if np.all(np.abs(m(*row) - values) <= tolerance * (1 + np.abs(values)))
        ),
        None,
    )
