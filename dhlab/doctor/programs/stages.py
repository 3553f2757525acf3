"""The stages of a program for forward kinematics, and the slips that people make at each; a wrong
program is one or two of them.

A program reads the rows and q, hands four arguments to the link matrix, multiplies the links and
returns the result. A slip changes one of these stages; all functions here take batches, so that
many wrong programs are computed at once.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import permutations

import numpy as np

from ...transform import rot_x, rot_z, trans_x, trans_z
from .entries import closed_form

__all__ = [
    "Slip",
    "READING",
    "ARGUMENTS",
    "LINK",
    "EACH_LINK",
    "PRODUCT",
    "RESULT",
    "run_chain",
    "run_link",
    "chain_product",
    "craig",
    "rounded",
    "truncated",
]

DEG = 180 / np.pi
NAMES = ("theta", "d", "a", "alpha")


@dataclass(frozen=True)
class Slip:
    """One mistake at one stage: its id, its place in words, and ``change``, what the stage computes
    instead.
    """

    stage: str
    mistake: str
    place: str
    change: Callable


def craig(theta, d, a, alpha):
    """Craig's order: Rx(alpha) Tx(a) Rz(theta) Tz(d) (Craig, Introduction to Robotics, eq. 3.6)."""
    return rot_x(alpha) @ trans_x(a) @ rot_z(theta) @ trans_z(d)


def truncated(T):
    """What is left when T is written into an array of whole numbers."""
    return np.trunc(T)


def rounded(T, digits=2):
    """T as it is after ``np.round``."""
    return np.round(T, digits)


def _slips(stage, *entries):
    return [Slip(stage, *entry) for entry in entries]


# ---- reading rows (..., n, 4) and q (..., n): a slip gives other rows and another q


def _theta(change):
    """The theta column changed."""
    return lambda rows, q: (np.concatenate([change(rows[..., :1]), rows[..., 1:]], axis=-1), q)


def _q(change):
    return lambda rows, q: (rows, change(q))


def _both(change):
    return lambda rows, q: (
        np.concatenate([change(rows[..., :1]), rows[..., 1:]], axis=-1),
        change(q),
    )


def _columns(order):
    return lambda rows, q: (rows[..., order], q)


def _neighbour(step, wrap):
    """a and alpha from another row; the row that has no neighbour takes 0, or the one at the other
    end.
    """

    def change(rows, q):
        moved = np.roll(rows[..., 2:], step, axis=-2)
        if not wrap:
            moved[..., 0 if step > 0 else -1, :] = 0
        return np.concatenate([rows[..., :2], moved], axis=-1), q

    return change


def _lent(row):
    """d, a and alpha of one row for all."""

    def change(rows, q):
        return np.concatenate([rows[..., :1], 0 * rows[..., 1:] + rows[..., [row], 1:]], axis=-1), q

    return change


def _q_in(column):
    """q added to another column than theta."""

    def change(rows, q):
        rows = rows.copy()
        rows[..., column] += q
        return rows, 0 * q

    return change


def _shifted(q, step):
    moved = np.roll(q, step, axis=-1)
    moved[..., 0 if step > 0 else -1] = 0
    return moved


def _all_summed(rows, q):
    return np.concatenate([0 * rows[..., :1], rows[..., 1:]], axis=-1), np.cumsum(
        rows[..., 0] + q, axis=-1
    )


def _column_orders():
    """The readings θ, d, a, α in another order; the two that only swap a pair have names of their
    own.
    """
    for order in permutations(range(4)):
        names = ", ".join(NAMES[order.index(k)] for k in range(4))
        mistake = {(0, 2, 1, 3): "a-d-exchanged", (3, 1, 2, 0): "theta-alpha-exchanged"}.get(
            order, "columns-misread"
        )
        if order != (0, 1, 2, 3):
            yield mistake, "" if mistake != "columns-misread" else f"read as {names}", list(order)


READING = _slips(
    "reading",
    ("joint-values-unused", "", _q(np.zeros_like)),
    ("joint-index-off-by-one", "the q of the row before", _q(lambda q: np.roll(q, 1, axis=-1))),
    ("joint-index-off-by-one", "the q of the row after", _q(lambda q: np.roll(q, -1, axis=-1))),
    ("joint-index-off-by-one", "the q of the row before", _q(lambda q: _shifted(q, 1))),
    ("joint-index-off-by-one", "the q of the row after", _q(lambda q: _shifted(q, -1))),
    ("joint-index-off-by-one", "the same q for all rows", _q(lambda q: 0 * q + q[..., :1])),
    ("joint-index-off-by-one", "the same q for all rows", _q(lambda q: 0 * q + q[..., -1:])),
    ("joint-index-off-by-one", "the order of q is turned round", _q(lambda q: q[..., ::-1])),
    (
        "joint-index-off-by-one",
        "the row before, with this joint's q",
        lambda rows, q: (np.roll(rows, 1, axis=-2), q),
    ),
    (
        "joint-index-off-by-one",
        "the row after, with this joint's q",
        lambda rows, q: (np.roll(rows, -1, axis=-2), q),
    ),
    ("one-row-for-all-joints", "the last row", lambda rows, q: (0 * rows + rows[..., -1:, :], q)),
    ("one-row-for-all-joints", "d, a and alpha of the last row", _lent(-1)),
    ("one-row-for-all-joints", "d, a and alpha of the first row", _lent(0)),
    ("one-row-for-all-joints", "the first row", lambda rows, q: (0 * rows + rows[..., :1, :], q)),
    ("joints-summed", "", _q(lambda q: np.cumsum(q, axis=-1))),
    ("joints-summed", "offsets too", _all_summed),
    (
        "joints-summed",
        "the other way: differences of q",
        _q(lambda q: np.diff(q, axis=-1, prepend=0)),
    ),
    ("offset-missing", "", _theta(np.zeros_like)),
    ("offset-sign", "", _theta(np.negative)),
    ("offset-subtracted", "", _q(np.negative)),
    ("offset-counted-twice", "", _theta(lambda theta: 2 * theta)),
    ("all-joints-left-handed", "", _both(np.negative)),
    ("offset-in-degrees", "", _theta(lambda theta: theta * DEG)),
    ("degrees-in-sin-cos", "q", _q(lambda q: q * DEG)),
    ("converted-to-radians-twice", "q", _q(lambda q: q / DEG)),
    ("converted-to-radians-twice", "the theta column", _theta(lambda theta: theta / DEG)),
    (
        "converted-to-radians-twice",
        "the angles of the rows",
        lambda rows, q: (rows * [1 / DEG, 1, 1, 1 / DEG], q),
    ),
    ("degrees-in-sin-cos", "the angles of the rows", lambda rows, q: (rows * [DEG, 1, 1, DEG], q)),
    ("columns-misread", "q is added to alpha", _q_in(3)),
    ("columns-misread", "q is added to d", _q_in(1)),
    ("columns-misread", "q is added to a", _q_in(2)),
    ("integer-arrays", "the table", lambda rows, q: (np.trunc(rows), q)),
    ("integer-arrays", "q", _q(np.trunc)),
    (
        "integer-arrays",
        "the sums of offset and q",
        lambda rows, q: (
            np.concatenate([np.trunc(rows[..., :1] + q[..., None]), rows[..., 1:]], axis=-1),
            0 * q,
        ),
    ),
    ("a-alpha-from-previous-row", "", _neighbour(1, False)),
    ("a-alpha-from-previous-row", "row 1 takes them from the last row", _neighbour(1, True)),
    ("a-alpha-from-previous-row", "here it is the row after", _neighbour(-1, False)),
    ("a-alpha-from-previous-row", "here it is the row after", _neighbour(-1, True)),
    *((mistake, place, _columns(order)) for mistake, place, order in _column_orders()),
)


# ---- the four arguments of the link matrix: a slip gives four others


def _scaled(**factors):
    return lambda *row: tuple(value * factors.get(name, 1) for name, value in zip(NAMES, row))


def _changed(name, change):
    """One argument, or both angles, through a function."""
    which = [k for k, own in enumerate(NAMES) if own in name]
    return lambda *row: tuple(change(value) if k in which else value for k, value in enumerate(row))


def _nearest(step):
    return lambda x: np.round(x / step) * step


def _arguments_lost():
    """What is lost of an argument on its way: its sign, its quadrant, its digits, half of it, all
    of it.
    """
    angles = (("theta", ("theta",)), ("alpha", ("alpha",)), ("theta and alpha", ("theta", "alpha")))
    for place, names in angles:
        yield "atan-for-atan2", place, _changed(names, lambda x: np.arctan(np.tan(x)))
        yield "sign-lost", f"the sine of {place}", _changed(names, np.abs)
        yield "sign-lost", f"the cosine of {place}", _changed(names, lambda x: np.arcsin(np.sin(x)))
        yield "pi-rounded", f"{place}, to multiples of 90°", _changed(names, _nearest(np.pi / 2))
        yield "pi-rounded", f"{place}, to whole degrees", _changed(names, _nearest(1 / DEG))
        for digits in (0, 1, 2, 3):
            yield (
                "pi-rounded",
                f"{place}, {digits} decimals",
                _changed(names, lambda x, digits=digits: np.round(x, digits)),
            )
        yield "integer-arrays", place, _changed(names, np.trunc)
        yield "angle-unit", f"{place}: twice the angle", _changed(names, lambda x: 2 * x)
        yield "angle-unit", f"{place}: half the angle", _changed(names, lambda x: x / 2)
    for name, mistake in (("theta", "offset-value"), ("alpha", "alpha-value")):
        for turn in (180, 90, -90):
            yield (
                mistake,
                f"{name}: {turn}° too much",
                _changed((name,), lambda x, turn=turn: x + turn / DEG),
            )
    yield "alpha-value", "alpha is not used", _changed(("alpha",), np.zeros_like)
    yield "joint-values-unused", "theta is not used", _changed(("theta",), np.zeros_like)
    for name in ("d", "a"):
        yield "length-value", f"{name} is not used", _changed((name,), np.zeros_like)
        yield "length-value", f"twice {name}", _changed((name,), lambda x: 2 * x)
        yield "length-value", f"half of {name}", _changed((name,), lambda x: x / 2)
        yield "lengths-made-positive", name, _changed((name,), np.abs)
        for digits in (1, 2, 3):
            yield (
                "pi-rounded",
                f"{name}, {digits} decimals",
                _changed((name,), lambda x, digits=digits: np.round(x, digits)),
            )
    yield "integer-arrays", "d and a", _changed(("d", "a"), np.trunc)


def _rearranged(order):
    return lambda *row: tuple(row[k] for k in order)


ARGUMENTS = _slips(
    "arguments",
    ("degrees-in-sin-cos", "theta and alpha", _scaled(theta=DEG, alpha=DEG)),
    ("degrees-in-sin-cos", "theta", _scaled(theta=DEG)),
    ("alpha-in-degrees", "", _scaled(alpha=DEG)),
    ("converted-to-radians-twice", "theta and alpha", _scaled(theta=1 / DEG, alpha=1 / DEG)),
    ("converted-to-radians-twice", "theta", _scaled(theta=1 / DEG)),
    ("converted-to-radians-twice", "alpha", _scaled(alpha=1 / DEG)),
    ("row-vector-convention", "", _scaled(theta=-1, alpha=-1)),
    ("row-vector-convention", "the turn about z", _scaled(theta=-1)),
    ("alpha-sign", "the turn about x", _scaled(alpha=-1)),
    ("length-sign", "d", _scaled(d=-1)),
    ("length-sign", "a", _scaled(a=-1)),
    ("lengths-made-positive", "", lambda t, d, a, al: (t, np.abs(d), np.abs(a), al)),
    *(
        ("length-unit", place, _scaled(**{name: factor for name in names}))
        for place, names in (("", ("d", "a")), ("d", ("d",)), ("a", ("a",)))
        for factor in (1000, 1e-3)
    ),
    ("sin-cos-exchanged", "alpha", lambda t, d, a, al: (t, d, a, np.pi / 2 - al)),
    ("sin-cos-exchanged", "theta", lambda t, d, a, al: (np.pi / 2 - t, d, a, al)),
    *(
        (mistake, place.replace("read as", "taken as"), _rearranged(order))
        for mistake, place, order in _column_orders()
    ),
    *_arguments_lost(),
)


# ---- the link matrix: a slip gives another matrix from the same four numbers


def _in_order(names):
    def link(theta, d, a, alpha):
        moves = {"Rz": rot_z(theta), "Tz": trans_z(d), "Tx": trans_x(a), "Rx": rot_x(alpha)}
        return moves[names[0]] @ moves[names[1]] @ moves[names[2]] @ moves[names[3]]

    return link


def _orders():
    """The orders of the four moves whose products differ: turn and shift about one axis commute,
    and so do the two shifts.
    """
    named = {
        ("Rx", "Tx", "Rz", "Tz"): (
            "standard-rows-in-craig-matrix",
            "the four moves reversed are Craig's order",
        ),
        ("Tx", "Rz", "Tz", "Rx"): ("shift-not-turned-by-theta", ""),
        ("Rz", "Tx", "Rx", "Tz"): ("alpha-before-d", ""),
    }
    sample, seen = (0.3, 0.1, 0.4, 0.5), []
    for order in (("Rz", "Tz", "Tx", "Rx"), *named, *permutations(("Rz", "Tz", "Tx", "Rx"))):
        T = _in_order(order)(*sample)
        if not any(np.allclose(T, other) for other in seen):
            seen.append(T)
            yield (*named.get(order, ("order-taken-for-free", " ".join(order))), _in_order(order))


def _column_turned(j):
    return lambda *row: closed_form(*row) * np.where(np.arange(4) == j, [[-1], [-1], [-1], [1]], 1)


def _half_exchanged(theta, d, a, alpha):
    """cos(alpha) kept as 1, as if alpha were 0 there and 90° in the sine."""
    T = closed_form(theta, d, a, alpha)
    T[..., :3, 1] = np.stack([-np.sin(theta), np.cos(theta), np.sin(alpha)], axis=-1)
    T[..., 2, 2] = 1
    return T


LINK = _slips(
    "link",
    *list(_orders())[1:],
    ("elementwise-product", "", lambda t, d, a, al: rot_z(t) * trans_z(d) * trans_x(a) * rot_x(al)),
    ("sin-cos-exchanged", "cos alpha is 1 everywhere", _half_exchanged),
    *(("mirror", f"column {j + 1} points the other way", _column_turned(j)) for j in range(3)),
)
LINK += _slips(
    "link",
    (
        "product-reversed",
        "the four moves",
        craig,
    ),  # these stand after the names of their own, so they are found as look-alikes
    *(
        ("order-taken-for-free", " ".join(order), _in_order(order))
        for order in (("Tx", "Rz", "Tz", "Rx"), ("Rz", "Tx", "Rx", "Tz"))
    ),
)


# ---- the finished matrix, of each link or of the whole


def _inverse(T):
    with np.errstate(all="ignore"):
        return (
            np.linalg.inv(T)
            if np.all(np.abs(np.linalg.det(T)) > 1e-12)
            else np.full_like(T, np.nan)
        )


def _rotation_transposed(T):
    T = T.copy()
    T[..., :3, :3] = np.swapaxes(T[..., :3, :3], -1, -2).copy()
    return T


def _with_ones_below(T):
    return np.concatenate([T[..., :3, :], np.ones_like(T[..., :1, :])], axis=-2)


def _without_last_row(T):
    return T * np.array([1, 1, 1, 0])[:, None]


def _in_millimetres(T):
    return T * np.where(np.arange(4) == 3, [[1000], [1000], [1000], [1]], 1)


_FINISHED = (
    ("pose-inverted", "", _inverse),
    ("rotation-transposed", "", _rotation_transposed),
    ("matrix-transposed", "", lambda T: np.swapaxes(T, -1, -2)),
    ("last-row-missing", "", _without_last_row),
    ("last-row-missing", "1 1 1 1 stands there", _with_ones_below),
    ("integer-arrays", "", truncated),
    *(
        ("pi-rounded", f"{digits} decimals", lambda T, digits=digits: rounded(T, digits))
        for digits in (1, 2, 3, 4, 5)
    ),
)
RESULT = _slips("result", *_FINISHED, ("length-unit", "the position, in mm", _in_millimetres))
EACH_LINK = _slips(
    "each link",
    *(
        (mistake, f"each link{', ' if place else ''}{place}", change)
        for mistake, place, change in _FINISHED
    ),
)


# ---- the product of the links (..., n, 4, 4)


def chain_product(links):
    """A_1 … A_n of links (..., n, 4, 4)."""
    return _running(links, lambda T: T)


def _running(links, after):
    T = np.broadcast_to(np.eye(4), links.shape[:-3] + (4, 4))
    for i in range(links.shape[-3]):
        T = after(T @ links[..., i, :, :])
    return T


def _elementwise(links):
    return np.prod(links, axis=-3)


def _shifts_added(links):
    T = chain_product(links).copy()
    T[..., :3, 3] = links[..., :3, 3].sum(axis=-2)
    return T


def _turned_too_early(links):
    """The shift of each link turned by the rotation that already includes this link."""
    T, p = np.broadcast_to(np.eye(4), links.shape[:-3] + (4, 4)), 0
    for i in range(links.shape[-3]):
        T = T @ links[..., i, :, :]
        p = p + (T[..., :3, :3] @ links[..., i, :3, 3:])[..., 0]
    T = T.copy()
    T[..., :3, 3] = p
    return T


def _turned_back(links):
    """The shift of each link turned the other way."""
    T, p = np.broadcast_to(np.eye(4), links.shape[:-3] + (4, 4)), 0
    for i in range(links.shape[-3]):
        p = p + (np.swapaxes(T[..., :3, :3], -1, -2) @ links[..., i, :3, 3:])[..., 0]
        T = T @ links[..., i, :, :]
    T = T.copy()
    T[..., :3, 3] = p
    return T


def _half_reversed(of_rotation):
    """The rotation of one order of the product and the position of the other."""

    def product(links):
        right, wrong = chain_product(links), chain_product(links[..., ::-1, :, :])
        T = (right if not of_rotation else wrong).copy()
        T[..., :3, 3] = (wrong if not of_rotation else right)[..., :3, 3]
        return T

    return product


def _repeated(i):
    return lambda links: chain_product(np.insert(links, i, links[..., i, :, :], axis=-3))


PRODUCT = _slips(
    "product",
    ("product-reversed", "", lambda links: chain_product(links[..., ::-1, :, :])),
    ("elementwise-product", "", _elementwise),
    ("translations-not-rotated", "", _shifts_added),
    ("order-taken-for-free", "the shift is turned by its own link too", _turned_too_early),
    ("translations-not-rotated", "each shift is turned by the transposed rotation", _turned_back),
    ("product-reversed", "of the rotations only", _half_reversed(True)),
    ("product-reversed", "of the positions only", _half_reversed(False)),
    ("product-from-zeros", "", lambda links: 0 * chain_product(links)),
    ("product-stops-early", "the last row", lambda links: chain_product(links[..., :-1, :, :])),
    ("product-stops-early", "only the first row is used", lambda links: links[..., 0, :, :]),
    ("product-starts-late", "the first row", lambda links: chain_product(links[..., 1:, :, :])),
    ("product-starts-late", "only the last row is used", lambda links: links[..., -1, :, :]),
    (
        "product-stops-early",
        "every second row is left out",
        lambda links: chain_product(links[..., ::2, :, :]),
    ),
    (
        "product-starts-late",
        "and the last row is left out too",
        lambda links: chain_product(links[..., 1:-1, :, :]),
    ),
    ("link-counted-twice", "the first link", _repeated(0)),
    ("link-counted-twice", "the last link", _repeated(-1)),
    ("integer-arrays", "the running product", lambda links: _running(links, truncated)),
    *(
        (
            "pi-rounded",
            f"the running product, {digits} decimals",
            lambda links, digits=digits: _running(links, lambda T: rounded(T, digits)),
        )
        for digits in (1, 2, 3, 4, 5)
    ),
)


# ---- a whole program


def _of(stage, slips):
    return [slip for slip in slips if slip.stage == stage]


def run_link(slips, theta, d, a, alpha):
    """What ``dh_transform`` gives with these slips."""
    return _finish(_links(slips, theta, d, a, alpha), slips)


def run_chain(slips, rows, q):
    """What ``forward_kinematics`` gives with these slips; ``rows`` (n, 4) and ``q`` (n,), radians
    and metres.
    """
    rows, q = np.asarray(rows, dtype=float), np.asarray(q, dtype=float)
    for slip in _of("reading", slips):
        rows, q = slip.change(rows, q)
    links = _links(slips, rows[..., 0] + q, rows[..., 1], rows[..., 2], rows[..., 3])
    product = _of("product", slips)
    return _finish(product[0].change(links) if product else chain_product(links), slips)


def _links(slips, *row):
    for slip in _of("arguments", slips):
        row = slip.change(*row)
    link = _of("link", slips)
    T = link[0].change(*row) if link else closed_form(*row)
    for entry in _of("entry", slips):
        T = entry.change(T, *row)
    for slip in _of("each link", slips):
        T = slip.change(T)
    return T


def _finish(T, slips):
    for slip in _of("result", slips):
        T = slip.change(T)
    return T
