"""Wrong versions of forward kinematics: what a learner's ``forward_kinematics(rows, q)`` computes when one thing is wrong.

``rows`` is (n, 4): theta offset, d, a, alpha in radians and metres; ``q`` is (n,). Each entry of :data:`WRONG_PRODUCTS` is
``(mistake, place, function of rows, q)``.
"""

import numpy as np

from .wrong_links import DEG, WRONG_LINKS, craig, rounded, standard, truncated

__all__ = ["product", "WRONG_PRODUCTS"]


def product(rows, q, link=standard):
    """A_1 … A_n with theta = offset + q."""
    T = np.eye(4)
    for (offset, d, a, alpha), q_i in zip(rows, q):
        T = T @ link(offset + q_i, d, a, alpha)
    return T


def _with_link(link):
    return lambda rows, q: product(rows, q, link)


def _reversed(rows, q):
    T = np.eye(4)
    for (offset, d, a, alpha), q_i in zip(rows, q):
        T = standard(offset + q_i, d, a, alpha) @ T
    return T


def _elementwise(rows, q):
    T = standard(rows[0][0] + q[0], *rows[0][1:])
    for (offset, d, a, alpha), q_i in zip(rows[1:], q[1:]):
        T = T * standard(offset + q_i, d, a, alpha)
    return T


def _shifts_added(rows, q):
    T = product(rows, q)
    T[:3, 3] = sum(standard(offset + q_i, d, a, alpha)[:3, 3] for (offset, d, a, alpha), q_i in zip(rows, q))
    return T


def _scaled(columns, factor):
    def wrong(rows, q):
        rows = np.array(rows, dtype=float)
        rows[:, columns] *= factor
        return product(rows, q)
    return wrong


def _columns(order):
    return lambda rows, q: product(np.asarray(rows, dtype=float)[:, order], q)


def _previous_row(rows, q):
    rows = np.array(rows, dtype=float)
    rows[:, 2:] = np.vstack([[0, 0], rows[:-1, 2:]])
    return product(rows, q)


def _offsets(change):
    def wrong(rows, q):
        rows = np.array(rows, dtype=float)
        rows[:, 0] = change(rows[:, 0])
        return product(rows, q)
    return wrong


def _rotation_transposed(rows, q):
    T = product(rows, q)
    T[:3, :3] = T[:3, :3].T
    return T


def _rounded_links(digits):
    return lambda rows, q: product(rows, q, lambda *row: rounded(standard(*row), digits))


WRONG_PRODUCTS = [
    ("product-reversed", "", _reversed),
    ("elementwise-product", "", _elementwise),
    ("translations-not-rotated", "", _shifts_added),
    ("pose-inverted", "", lambda rows, q: np.linalg.inv(product(rows, q))),
    ("rotation-transposed", "", _rotation_transposed),
    ("matrix-transposed", "", lambda rows, q: product(rows, q).T),
    ("product-stops-early", "the last row", lambda rows, q: product(rows[:-1], q[:-1])),
    ("product-stops-early", "only the first row is used", lambda rows, q: product(rows[:1], q[:1])),
    ("product-starts-late", "the first row", lambda rows, q: product(rows[1:], q[1:])),
    ("product-starts-late", "only the last row is used", lambda rows, q: product(rows[-1:], q[-1:])),
    ("joint-values-unused", "", lambda rows, q: product(rows, np.zeros(len(rows)))),
    ("joint-index-off-by-one", "", lambda rows, q: product(rows, np.roll(q, 1))),
    ("joint-index-off-by-one", "", lambda rows, q: product(rows, np.roll(q, -1))),
    ("joint-index-off-by-one", "the same q for all rows", lambda rows, q: product(rows, np.full(len(rows), q[0]))),
    ("joint-index-off-by-one", "the same q for all rows", lambda rows, q: product(rows, np.full(len(rows), q[-1]))),
    ("joint-index-off-by-one", "the order of q is turned round", lambda rows, q: product(rows, np.asarray(q)[::-1])),
    ("joints-summed", "", lambda rows, q: product(rows, np.cumsum(q))),
    ("offset-subtracted", "", _offsets(np.negative)),
    ("offset-subtracted", "", lambda rows, q: product(rows, -np.asarray(q))),
    ("offset-missing", "", _offsets(np.zeros_like)),
    ("offset-in-degrees", "", _offsets(lambda theta: theta * DEG)),
    ("degrees-in-sin-cos", "q", lambda rows, q: product(rows, np.asarray(q) * DEG)),
    ("converted-to-radians-twice", "q", lambda rows, q: product(rows, np.asarray(q) / DEG)),
    ("converted-to-radians-twice", "the theta column", _offsets(lambda theta: theta / DEG)),
    ("a-alpha-from-previous-row", "", _previous_row),
    ("columns-misread", "α a d θ", _columns([3, 2, 1, 0])),
    ("columns-misread", "a α d θ", _columns([3, 2, 0, 1])),
    ("length-unit", "d", _scaled([1], 1000)),
    ("length-unit", "a", _scaled([2], 1000)),
    ("length-unit", "d", _scaled([1], 1e-3)),
    ("length-unit", "a", _scaled([2], 1e-3)),
    ("integer-arrays", "each link", _with_link(lambda *row: truncated(standard(*row)))),
    ("integer-arrays", "the result", lambda rows, q: truncated(product(rows, q))),
    ("pi-rounded", "each link, 2 decimals", _rounded_links(2)),
    ("pi-rounded", "each link, 3 decimals", _rounded_links(3)),
    ("pi-rounded", "each link, 4 decimals", _rounded_links(4)),
]
WRONG_PRODUCTS += [(mistake, place or "in every link matrix", _with_link(link)) for mistake, place, link in WRONG_LINKS]
WRONG_PRODUCTS += [("product-reversed", "with Craig's link matrix as well", lambda rows, q: product(rows[::-1], q[::-1], craig))]
