"""Wrong versions of Craig's link matrix and of chains of it: what a learner's function of theta, d,
a, alpha, or of rows and q, computes when one thing is wrong.
"""

import numpy as np

from ....transform import rot_x, rot_z, trans_x, trans_z
from ...mistakes.themes.links import MOVES, in_order
from ..search.steps import slips
from .links import two_rows
from .products import SAMPLE, product
from .versions import Versions

__all__ = ["craig", "in_order", "MOVES", "product_craig", "WRONG_CRAIG", "WRONG_CRAIG_PRODUCTS"]


def craig(theta, d, a, alpha):
    """The right one: Rx(alpha) Tx(a) Rz(theta) Tz(d). Craig, Introduction to Robotics, eq. 3.6.

    Examples
    --------
    >>> craig(0.0, 0.1, 0.4, 0.0)[:3, 3]
    array([0.4, 0. , 0.1])
    """
    return rot_x(alpha) @ trans_x(a) @ rot_z(theta) @ trans_z(d)


def _made():
    for slip in slips("craig link"):
        yield slip.mistake, slip.place, slip.change
    for slip in slips("arguments"):
        yield slip.mistake, slip.place, lambda *row, slip=slip: craig(*slip.change(*row))
    for slip in slips("result"):
        yield slip.mistake, slip.place, lambda *row, slip=slip: slip.change(craig(*row))


WRONG_CRAIG = Versions(_made, two_rows, craig)


def product_craig(rows, q):
    """The right chain of Craig's links: row i holds theta_i, d_i, a_{i-1}, alpha_{i-1}.

    Examples
    --------
    >>> product_craig([[0.0, 0.1, 0.4, 0.0]], [0.0])[:3, 3]
    array([0.4, 0. , 0.1])
    """
    return product(rows, q, craig)


def _reversed(rows, q):
    T = np.eye(4)
    for (offset, *row), q_i in zip(rows, q):
        T = craig(offset + q_i, *row) @ T
    return T


def _made_of_chains():
    for slip in slips("reading"):
        yield slip.mistake, slip.place, lambda *case, slip=slip: product_craig(*slip.change(*case))
    for slip in slips("craig link"):
        yield slip.mistake, slip.place, lambda *case, slip=slip: product(*case, slip.change)
    for slip in slips("arguments"):
        link = lambda *row, slip=slip: craig(*slip.change(*row))  # noqa: E731
        yield slip.mistake, slip.place, lambda *case, link=link: product(*case, link)
    for slip in slips("each link"):
        link = lambda *row, slip=slip: slip.change(craig(*row))  # noqa: E731
        yield slip.mistake, slip.place, lambda *case, link=link: product(*case, link)
    for slip in slips("result"):
        yield slip.mistake, slip.place, lambda *case, slip=slip: slip.change(product_craig(*case))
    yield "craig-rows-in-standard-matrix", "the standard link matrix", product
    yield "product-reversed", "the links", _reversed


WRONG_CRAIG_PRODUCTS = Versions(_made_of_chains, lambda: SAMPLE, product_craig)
