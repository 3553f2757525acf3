"""A program for forward kinematics as a sequence of steps, and the slips that people make at each;
a wrong program is one or two of them.

A program reads the rows and q, hands four arguments to the link matrix, multiplies the links and
returns the result. All functions here take batches, so that many wrong programs are computed at
once. What a slip is, and the names of the steps, stands in :mod:`dhlab.doctor.mistakes.changes`.
"""

from functools import cache

import numpy as np

from ....kinematics import link_matrices
from ...mistakes.changes import JointChange, PoseChange, RowChange, Slip
from ...mistakes.registry import changes
from ...mistakes.themes.products import chain_product

__all__ = ["chain_product", "right_link", "run_chain", "run_link", "slips"]


def right_link(*row):
    """The standard link matrix of theta, d, a, alpha, arrays of one shape (...); (..., 4, 4)."""
    return link_matrices("standard", *row)


@cache
def slips(step):
    """Every slip at a step, a list; of equals the first is told.

    Examples
    --------
    >>> [slip.mistake for slip in slips("link")][:2]
    ['shift-not-turned-by-theta', 'alpha-before-d']
    """
    return [slip for change in changes() for slip in _slips_of(change) if slip.step == step]


def _slips_of(change):
    """What a change is in a program."""
    if isinstance(change, Slip):
        yield change
    elif isinstance(change, RowChange):
        if change.reading is not None:
            yield _slip("reading", change.reading, _on_rows(change.change), change)
        if change.argument is not None:
            yield _slip("arguments", change.argument, change.change, change)
    elif isinstance(change, JointChange) and change.reading is not None:
        yield _slip("reading", change.reading, _on_q(change.matrix), change)
    elif isinstance(change, PoseChange):
        yield _slip("result", change.place, change.change, change)
        if change.each_link:
            place = f"each link, {change.place}" if change.place else "each link"
            yield _slip("each link", place, change.change, change)


def _slip(step, place, what, change):
    return Slip(step, place, what, mistake=change.mistake)


def _on_rows(change):
    """The change of rows (..., n, 4) that are read; q stays."""
    return lambda rows, q: (np.stack(change(*np.moveaxis(rows, -1, 0)), axis=-1), q)


def _on_q(matrix):
    """The change of q (..., n) that is read; the rows stay."""
    return lambda rows, q: (rows, q @ matrix(q.shape[-1]).T)


# ---- a whole program


def _at(step, made):
    return [slip for slip in made if slip.step == step]


def run_link(made, theta, d, a, alpha):
    """What ``dh_transform`` gives when these slips are made."""
    return _finished(_links(made, theta, d, a, alpha), made)


def run_chain(made, rows, q):
    """What ``forward_kinematics`` gives when these slips are made; ``rows`` (n, 4) and ``q`` (n,),
    radians and metres.
    """
    rows, q = np.asarray(rows, dtype=float), np.asarray(q, dtype=float)
    for slip in _at("reading", made):
        rows, q = slip.change(rows, q)
    links = _links(made, rows[..., 0] + q, rows[..., 1], rows[..., 2], rows[..., 3])
    product = _at("product", made)
    return _finished(product[0].change(links) if product else chain_product(links), made)


def _links(made, *row):
    for slip in _at("arguments", made):
        row = slip.change(*row)
    link = _at("link", made)
    T = link[0].change(*row) if link else right_link(*row)
    for entry in _at("entry", made):
        T = entry.change(T, *row)
    for slip in _at("each link", made):
        T = slip.change(T)
    return T


def _finished(T, made):
    for slip in _at("result", made):
        T = slip.change(T)
    return T
