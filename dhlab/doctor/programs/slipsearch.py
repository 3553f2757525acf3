"""The search for the one or two slips that turn the right program into the one at hand.

Every wrong program is computed on the first case, whole stages at a time, and what fits there is
tried on all other cases. One slip is preferred to two; of two explanations of one length the one
that stands first in :mod:`dhlab.doctor.programs.stages`.
"""

import numpy as np

from .entries import MONOMIALS, RIGHT_ENTRIES, closed_form, slips_of_the_pen, typed
from .stages import (
    ARGUMENTS,
    EACH_LINK,
    LINK,
    PRODUCT,
    READING,
    RESULT,
    Slip,
    chain_product,
    run_chain,
    run_link,
)

__all__ = ["search", "wrong_entries", "mistyped"]

MOST_ENTRIES = 3  # mistyped entries in one matrix; with more it is another formula


def search(answers, cases, kind, tolerance=1e-9):
    """The slips that explain the answers.

    Parameters
    ----------
    answers : array (m, 4, 4)
    cases : sequence of m tuples
        ``(theta, d, a, alpha)`` or ``(rows, q)``; radians and metres.
    kind : "dh_transform" or "forward_kinematics"
    tolerance : float
        Largest deviation, absolute and relative.

    Returns
    -------
    (tuple of Slip, tuple of str)
        One or two slips, empty when nothing fits; and the ids of other single mistakes that give
        the same answers.
    """
    order = _first_cases(cases, kind)
    trial = _Trial([answers[k] for k in order], [cases[k] for k in order], kind, tolerance)
    with np.errstate(all="ignore"):
        singles = list(trial.fitting(_singles(trial)))
        if singles:
            return singles[0], tuple(
                dict.fromkeys(s.mistake for (s,) in singles if s.mistake != singles[0][0].mistake)
            )
        if kind == "dh_transform":
            several = wrong_entries(answers, cases, tolerance)
            if several:
                return several, ()
        return next(trial.fitting(_pairs(trial)), ()), ()


def _first_cases(cases, kind):
    """Cases in the order of trial: a short chain first, though not one so short that shifted and
    reversed look alike.
    """
    if kind == "dh_transform":
        return range(len(cases))
    return sorted(range(len(cases)), key=lambda k: (len(cases[k][1]) < 3, len(cases[k][1])))


class _Trial:
    """The answers, and the stages of many wrong programs at the first case."""

    def __init__(self, answers, cases, kind, tolerance):
        self.answers, self.cases, self.tolerance = answers, cases, tolerance
        self.is_chain = kind == "forward_kinematics"
        if self.is_chain:
            rows, q = (np.asarray(part, dtype=float) for part in cases[0])
        else:  # one link is a chain of one row
            rows, q = np.array([cases[0]], dtype=float), np.zeros(1)
        self.rows, self.q = rows, q
        self.product = PRODUCT if self.is_chain else []
        self.each = EACH_LINK if self.is_chain else []
        self.early = [(), *((slip,) for slip in (READING if self.is_chain else []) + ARGUMENTS)]
        self.table = np.stack([_read(slips, rows, q) for slips in self.early])

    def fitting(self, blocks):
        """The slips, tuples, of every candidate that fits all cases; blocks are (slips of candidate
        k, poses of all candidates).
        """
        for name, poses in blocks:
            for k in np.flatnonzero(self._close(poses, self.answers[0]).all(axis=(-1, -2))):
                slips = name(k)
                if all(
                    self._close(self._run(slips, case), answer).all()
                    for case, answer in zip(self.cases[1:], self.answers[1:])
                ):
                    yield slips

    def _run(self, slips, case):
        return run_chain(slips, *case) if self.is_chain else run_link(slips, *case)

    def _close(self, poses, answer):
        return np.abs(poses - answer) <= self.tolerance * (1 + np.abs(answer))


def _read(slips, rows, q):
    """The four arguments of every link, (..., n, 4), after slips of reading and of arguments."""
    for slip in slips:
        if slip.stage == "reading":
            rows, q = slip.change(rows, q)
    row = (rows[..., 0] + q, rows[..., 1], rows[..., 2], rows[..., 3])
    for slip in slips:
        if slip.stage == "arguments":
            row = slip.change(*row)
    return np.stack(row, axis=-1)


def _columns(table):
    return tuple(np.moveaxis(table, -1, 0))


def mistyped(entry, monomial):
    """The slip that puts a Monomial into an entry (row, column) of the link matrix."""

    def change(T, *row):
        T = T.copy()
        T[(..., *entry)] = monomial(*row)
        return T

    return Slip("entry", "matrix-entry-mistyped", typed(entry, monomial), change)


def _with_entries(table, candidates):
    """Links (m, ..., n, 4, 4): the closed form with one entry replaced by each of m candidates."""
    row = _columns(table)
    right = closed_form(*row)
    links = np.broadcast_to(right, (len(candidates), *right.shape)).copy()
    for k, (entry, monomial) in enumerate(candidates):
        links[(k, ..., *entry)] = monomial(*row)
    return links


def _all_entries():
    return [
        (entry, monomial)
        for entry, right in RIGHT_ENTRIES.items()
        for monomial in MONOMIALS
        if monomial != right
    ]


def _grid(firsts, seconds):
    """Names of the candidates of a block in which every first meets every second, the second index
    running fastest.
    """
    return lambda k: (*firsts[k // len(seconds)], *seconds[k % len(seconds)])


def _flat(poses):
    return poses.reshape(-1, 4, 4)


def _tuples(slips):
    return [(slip,) for slip in slips]


def _singles(trial):
    yield lambda k: trial.early[1 + k], chain_product(closed_form(*_columns(trial.table[1:])))
    right = trial.table[0]
    yield from _late(trial, [()], closed_form(*_columns(right))[None])
    yield (
        _tuples(LINK).__getitem__,
        np.stack([chain_product(slip.change(*_columns(right))) for slip in LINK]),
    )
    candidates = _all_entries()
    yield lambda k: (mistyped(*candidates[k]),), chain_product(_with_entries(right, candidates))


def _late(trial, names, links):
    """One slip after the links are made: each link finished wrongly, multiplied wrongly, or the
    result finished wrongly.
    """
    if trial.product:
        yield (
            _grid(names, _tuples(trial.product)),
            _flat(np.stack([slip.change(links) for slip in trial.product], axis=1)),
        )
    poses = chain_product(links)
    yield (
        _grid(names, _tuples(RESULT)),
        _flat(np.stack([slip.change(poses) for slip in RESULT], axis=1)),
    )
    if trial.each:
        yield (
            _grid(names, _tuples(trial.each)),
            _flat(np.stack([chain_product(slip.change(links)) for slip in trial.each], axis=1)),
        )


def _pairs(trial):
    early, right = trial.early[1:], trial.table[0]
    yield from _late(trial, early, closed_form(*_columns(trial.table[1:])))
    links = np.stack([slip.change(*_columns(right)) for slip in LINK])
    yield from _late(trial, _tuples(LINK), links)
    pen = list(slips_of_the_pen())
    pen_names = [(mistyped(*candidate),) for candidate in pen]
    yield from _late(trial, pen_names, _with_entries(right, pen))
    yield (
        _grid(_tuples(LINK), early),
        _flat(chain_product(np.stack([slip.change(*_columns(trial.table[1:])) for slip in LINK]))),
    )
    yield _grid(pen_names, early), _flat(chain_product(_with_entries(trial.table[1:], pen)))
    yield from _two_early(trial)
    yield from _two_entries(right, pen, pen_names)
    yield from _two_late(trial, closed_form(*_columns(right)))


def _two_early(trial):
    """A second slip of reading or of arguments on top of each first one."""
    if trial.is_chain:
        rows, q = (
            np.stack(parts)
            for parts in zip(*(slip.change(trial.rows, trial.q) for slip in READING))
        )
        for second in READING + ARGUMENTS:
            table = _read((second,), rows, q)
            yield _grid(_tuples(READING), [(second,)]), chain_product(closed_form(*_columns(table)))
    firsts = trial.table[-len(ARGUMENTS) :]
    for second in ARGUMENTS:
        yield (
            _grid(_tuples(ARGUMENTS), [(second,)]),
            chain_product(closed_form(*second.change(*_columns(firsts)))),
        )


def _two_entries(right, pen, pen_names):
    links = _with_entries(right, pen)
    row = _columns(right)
    for k, (entry, monomial) in enumerate(pen):
        second = links[k + 1 :].copy()
        second[(..., *entry)] = monomial(*row)
        later = [j for j in range(k + 1, len(pen)) if pen[j][0] != entry]
        if later:
            keep = np.array(later) - k - 1
            yield (
                (lambda i, k=k, later=later: (*pen_names[k], *pen_names[later[i]])),
                chain_product(second[keep]),
            )


def _two_late(trial, links):
    """Two slips after the links are made."""
    makers = [
        *((slip, chain_product(slip.change(links))) for slip in trial.each),
        *((slip, slip.change(links)) for slip in trial.product),
        *((slip, slip.change(chain_product(links))) for slip in RESULT),
    ]
    for first, poses in makers:
        yield _grid([(first,)], _tuples(RESULT)), np.stack([slip.change(poses) for slip in RESULT])
    for first in trial.each:
        yield (
            _grid([(first,)], _tuples(trial.product)),
            np.stack([slip.change(first.change(links)) for slip in trial.product]),
        )


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
    >>> T = closed_form(*row.T)
    >>> T[:, 2, 3] = 0
    >>> [slip.place for slip in wrong_entries(T, row)]
    ['row 3, column 4: 0 stands there']
    """
    row = np.array(cases, dtype=float).T
    right = closed_form(*row)
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
