"""The product of the links (..., n, 4, 4): its order, its factors, what is multiplied."""

from itertools import permutations

import numpy as np

from ..changes import Slip
from ..registry import mistake
from .links import (
    ALPHA_BEFORE_D,
    CRAIG,
    MOVES,
    STANDARD,
    X_BEFORE_Z,
    exchanged,
    in_another_order,
    in_order,
)

__all__ = ["chain_product", "running"]

SAMPLE = (0.3, -0.1, 0.4, 0.5)  # a row without symmetry


def chain_product(links):
    """A_1 … A_n of links (..., n, 4, 4)."""
    return running(lambda T: T)(links)


def running(after):
    """The product in which something is done after every factor."""

    def product(links):
        T = np.broadcast_to(np.eye(4), (*links.shape[:-3], 4, 4))
        for i in range(links.shape[-3]):
            T = after(T @ links[..., i, :, :])
        return T

    return product


def _product(place, change):
    return Slip("product", place, change)


def _of(selected, place):
    """The product of some of the links."""
    return _product(place, lambda links: chain_product(links[..., selected, :, :]))


# ---- order


@mistake("product-reversed")
def product_reversed():
    yield _of(slice(None, None, -1), "")
    yield _product("of the rotations only", _half_reversed(True))
    yield _product("of the positions only", _half_reversed(False))
    yield in_another_order(CRAIG, place="the four moves")


@mistake("order-taken-for-free")
def order_taken_for_free():
    """Every other order whose product differs: turn and shift about one axis commute, and so do the
    two shifts.
    """
    named = (STANDARD, CRAIG, X_BEFORE_Z, ALPHA_BEFORE_D)
    for order in _different(named, permutations(STANDARD)):
        yield in_another_order(order, place=exchanged(order, STANDARD))
    for order in (X_BEFORE_Z, ALPHA_BEFORE_D):  # found as look-alikes, after their own names
        yield in_another_order(order, place=exchanged(order, STANDARD))
    for order in permutations(STANDARD):
        T = in_order(order, *SAMPLE)
        if not any(np.allclose(T, in_order(known, *SAMPLE)) for known in (STANDARD, CRAIG)):
            yield in_another_order(order, "craig link", exchanged(order, CRAIG))
    yield _product("the shift is turned by its own link too", _turned_too_early)


def _different(known, orders):
    """The orders that give other matrices than those known or before."""
    seen = [in_order(order, *SAMPLE) for order in known]
    for order in orders:
        T = in_order(order, *SAMPLE)
        if not any(np.allclose(T, other) for other in seen):
            seen.append(T)
            yield order


def _turned_too_early(links):
    """The shift of each link turned by the rotation that already includes this link."""
    T, p = np.broadcast_to(np.eye(4), (*links.shape[:-3], 4, 4)), 0
    for i in range(links.shape[-3]):
        T = T @ links[..., i, :, :]
        p = p + (T[..., :3, :3] @ links[..., i, :3, 3:])[..., 0]
    return _at(T, p)


def _half_reversed(of_rotation):
    """The rotation of one order of the product and the position of the other."""

    def product(links):
        right, wrong = chain_product(links), chain_product(links[..., ::-1, :, :])
        rotation, position = (wrong, right) if of_rotation else (right, wrong)
        return _at(rotation, position[..., :3, 3])

    return product


# ---- what is multiplied


@mistake("elementwise-product")
def elementwise_product():
    yield _product("", lambda links: np.prod(links, axis=-3))
    for step, order in (("link", STANDARD), ("craig link", CRAIG)):
        yield Slip(step, "", lambda *row, order=order: _entry_by_entry(order, *row))


def _entry_by_entry(order, *row):
    return np.prod([MOVES[name](row) for name in order], axis=0)


@mistake("translations-not-rotated")
def translations_not_rotated():
    yield _product("", _shifts_added)
    yield _product("each shift is turned by the transposed rotation", _turned_back)


def _shifts_added(links):
    return _at(chain_product(links), links[..., :3, 3].sum(axis=-2))


def _turned_back(links):
    """The shift of each link turned the other way."""
    T, p = np.broadcast_to(np.eye(4), (*links.shape[:-3], 4, 4)), 0
    for i in range(links.shape[-3]):
        p = p + (np.swapaxes(T[..., :3, :3], -1, -2) @ links[..., i, :3, 3:])[..., 0]
        T = T @ links[..., i, :, :]
    return _at(T, p)


def _at(T, p):
    """The poses T with the positions p."""
    T = T.copy()
    T[..., :3, 3] = p
    return T


# ---- which links


@mistake("product-from-zeros")
def product_from_zeros():
    yield _product("", lambda links: 0 * chain_product(links))


@mistake("product-stops-early")
def product_stops_early():
    yield _of(slice(None, -1), "the last row")
    yield _of(slice(None, 1), "only the first row is used")
    yield _of(slice(None, None, 2), "every second row is left out")


@mistake("last-link-by-half")
def last_link_by_half():
    yield Slip("reading", "", _without_its_link)


def _without_its_link(rows, q):
    """The last row without its a and alpha."""
    kept = np.ones(rows.shape[-2:])
    kept[-1, 2:] = 0
    return rows * kept, q


@mistake("product-starts-late")
def product_starts_late():
    yield _of(slice(1, None), "the first row")
    yield _of(slice(-1, None), "only the last row is used")
    yield _of(slice(1, -1), "and the last row is left out too")


@mistake("link-counted-twice")
def link_counted_twice():
    for i, name in ((0, "first"), (-1, "last")):
        yield _product(f"the {name} link", _repeated(i))


def _repeated(i):
    return lambda links: chain_product(np.insert(links, i, links[..., i, :, :], axis=-3))
