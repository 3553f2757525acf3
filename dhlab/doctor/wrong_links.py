"""Wrong versions of the link matrix: what a learner's ``dh_transform`` computes when one thing is wrong.

Each entry of :data:`WRONG_LINKS` is ``(mistake, place, function of theta, d, a, alpha)``; the angles are radians.
"""

from itertools import permutations

import numpy as np

from ..transform import rot_x, rot_y, rot_z, trans_x, trans_z

__all__ = ["standard", "WRONG_LINKS", "WRONG_ROT_X", "WRONG_COMPOSE", "rounded", "truncated"]

DEG = 180 / np.pi


def standard(theta, d, a, alpha):
    """The right one: Rz(theta) Tz(d) Tx(a) Rx(alpha)."""
    return rot_z(theta) @ trans_z(d) @ trans_x(a) @ rot_x(alpha)


def craig(theta, d, a, alpha):
    """Craig's order: Rx(alpha) Tx(a) Rz(theta) Tz(d)."""
    return rot_x(alpha) @ trans_x(a) @ rot_z(theta) @ trans_z(d)


def truncated(T):
    """What is left when T is written into an array of whole numbers."""
    return np.trunc(T)


def rounded(T, digits=2):
    """T as it is after ``np.round``."""
    return np.round(T, digits)


def _entries(change):
    """The closed form with some entries replaced: ``change(c, s, ca, sa, d, a)`` gives {(row, column): value}."""
    def link(theta, d, a, alpha):
        T = standard(theta, d, a, alpha)
        for (i, j), value in change(np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha), d, a).items():
            T[i, j] = value
        return T
    return link


def _without_last_row(T):
    T = T.copy()
    T[3] = 0
    return T


def _in_order(names):
    def link(theta, d, a, alpha):
        moves = {"Rz": rot_z(theta), "Tz": trans_z(d), "Tx": trans_x(a), "Rx": rot_x(alpha)}
        return moves[names[0]] @ moves[names[1]] @ moves[names[2]] @ moves[names[3]]
    return link


WRONG_LINKS = [
    ("standard-rows-in-craig-matrix", "the four moves reversed are Craig's order", craig),
    ("degrees-in-sin-cos", "theta and alpha", lambda t, d, a, al: standard(t * DEG, d, a, al * DEG)),
    ("degrees-in-sin-cos", "theta", lambda t, d, a, al: standard(t * DEG, d, a, al)),
    ("alpha-in-degrees", "", lambda t, d, a, al: standard(t, d, a, al * DEG)),
    ("converted-to-radians-twice", "theta and alpha", lambda t, d, a, al: standard(t / DEG, d, a, al / DEG)),
    ("converted-to-radians-twice", "theta", lambda t, d, a, al: standard(t / DEG, d, a, al)),
    ("converted-to-radians-twice", "alpha", lambda t, d, a, al: standard(t, d, a, al / DEG)),
    ("shift-not-turned-by-theta", "", lambda t, d, a, al: trans_x(a) @ rot_z(t) @ trans_z(d) @ rot_x(al)),
    ("alpha-before-d", "", lambda t, d, a, al: rot_z(t) @ trans_x(a) @ rot_x(al) @ trans_z(d)),
    ("pose-inverted", "", lambda t, d, a, al: np.linalg.inv(standard(t, d, a, al))),
    ("rotation-transposed", "", _entries(lambda c, s, ca, sa, d, a: dict(zip(
        [(i, j) for i in range(3) for j in range(3)], [c, s, 0, -s * ca, c * ca, sa, s * sa, -c * sa, ca])))),
    ("matrix-transposed", "", lambda t, d, a, al: standard(t, d, a, al).T),
    ("row-vector-convention", "", lambda t, d, a, al: standard(-t, d, a, -al)),
    ("row-vector-convention", "the turn about z", lambda t, d, a, al: standard(-t, d, a, al)),
    ("alpha-sign", "the turn about x", lambda t, d, a, al: standard(t, d, a, -al)),
    ("a-d-exchanged", "", lambda t, d, a, al: standard(t, a, d, al)),
    ("theta-alpha-exchanged", "", lambda t, d, a, al: standard(al, d, a, t)),
    ("length-sign", "d", lambda t, d, a, al: standard(t, -d, a, al)),
    ("length-sign", "a", lambda t, d, a, al: standard(t, d, -a, al)),
    ("length-unit", "", lambda t, d, a, al: standard(t, d * 1000, a * 1000, al)),
    ("length-unit", "", lambda t, d, a, al: standard(t, d / 1000, a / 1000, al)),
    ("sin-cos-exchanged", "alpha", lambda t, d, a, al: standard(t, d, a, np.pi / 2 - al)),
    ("sin-cos-exchanged", "theta", lambda t, d, a, al: standard(np.pi / 2 - t, d, a, al)),
    ("elementwise-product", "", lambda t, d, a, al: rot_z(t) * trans_z(d) * trans_x(a) * rot_x(al)),
    ("last-row-missing", "", lambda t, d, a, al: _without_last_row(standard(t, d, a, al))),
    ("integer-arrays", "", lambda t, d, a, al: truncated(standard(t, d, a, al))),
    ("matrix-entry-mistyped", "row 1, column 2: the minus of -sin θ cos α is lost", _entries(lambda c, s, ca, sa, d, a: {(0, 1): s * ca})),
    ("matrix-entry-mistyped", "row 1, column 3: the sign of sin θ sin α", _entries(lambda c, s, ca, sa, d, a: {(0, 2): -s * sa})),
    ("matrix-entry-mistyped", "row 2, column 3: the minus of -cos θ sin α is lost", _entries(lambda c, s, ca, sa, d, a: {(1, 2): c * sa})),
    ("matrix-entry-mistyped", "row 3, column 2: the sign of sin α", _entries(lambda c, s, ca, sa, d, a: {(2, 1): -sa})),
    ("shift-not-turned-by-theta", "", _entries(lambda c, s, ca, sa, d, a: {(0, 3): a, (1, 3): 0})),
]


def _other_orders():
    """Of the 24 orders of the four moves, those whose product is neither right nor named above (turn and shift about one axis commute)."""
    sample = (0.3, 0.1, 0.4, 0.5)
    known = [standard(*sample), *(version(*sample) for _, _, version in WRONG_LINKS)]
    for order in permutations(("Rz", "Tz", "Tx", "Rx")):
        link = _in_order(order)
        if not any(np.allclose(link(*sample), T) for T in known):
            yield "order-taken-for-free", " ".join(order), link


WRONG_LINKS += list(_other_orders())

WRONG_ROT_X = [
    ("rotation-transposed", "", lambda al: rot_x(-al)),
    ("degrees-in-sin-cos", "", lambda al: rot_x(al * DEG)),
    ("converted-to-radians-twice", "", lambda al: rot_x(al / DEG)),
    ("rotation-block-misread", "this turns about z", rot_z),
    ("rotation-block-misread", "this turns about z, the other way", lambda al: rot_z(-al)),
    ("rotation-block-misread", "this turns about y", rot_y),
    ("rotation-block-misread", "this turns about y, the other way", lambda al: rot_y(-al)),
    ("sin-cos-exchanged", "", lambda al: rot_x(np.pi / 2 - al)),
    ("mirror", "the minus before one sine is lost", lambda al: np.where(rot_x(al) == -np.sin(al), np.sin(al), rot_x(al))),
    ("mirror", "a minus too many before a sine", lambda al: np.where(rot_x(al) == np.sin(al), -np.sin(al), rot_x(al))),
    ("last-row-missing", "", lambda al: _without_last_row(rot_x(al))),
    ("integer-arrays", "", lambda al: truncated(rot_x(al))),
    ("pi-rounded", "", lambda al: rounded(rot_x(al))),
    ("not-rigid", "the 1 for the axis that stays is missing", lambda al: rot_x(al) - np.diag([1, 0, 0, 0])),
    ("matrix-entry-mistyped", "row 3, column 3", lambda al: rot_x(al) + np.diag([0, 0, 1 - np.cos(al), 0])),
    ("matrix-entry-mistyped", "row 2, column 2", lambda al: rot_x(al) + np.diag([0, 1 - np.cos(al), 0, 0])),
]


def _added(T_ab, T_bc):
    T = T_ab @ T_bc
    T[:3, 3] = T_ab[:3, 3] + T_bc[:3, 3]
    return T


def _sum(T_ab, T_bc):
    T = T_ab + T_bc
    T[3, 3] = 1
    return T


def _with_R(T, R):
    T = T.copy()
    T[:3, :3] = R
    return T


WRONG_COMPOSE = [
    ("product-reversed", "", lambda A, B: B @ A),
    ("elementwise-product", "", lambda A, B: A * B),
    ("translations-not-rotated", "", _added),
    ("translations-not-rotated", "whole matrices added", _sum),
    ("translations-not-rotated", "whole matrices added", lambda A, B: A + B),
    ("pose-inverted", "", lambda A, B: np.linalg.inv(A @ B)),
    ("pose-inverted", "the first pose", lambda A, B: np.linalg.inv(A) @ B),
    ("pose-inverted", "the second pose", lambda A, B: A @ np.linalg.inv(B)),
    ("matrix-transposed", "", lambda A, B: (A @ B).T),
    ("matrix-transposed", "the first pose", lambda A, B: A.T @ B),
    ("rotation-transposed", "", lambda A, B: _with_R(A @ B, (A @ B)[:3, :3].T)),
    ("product-stops-early", "", lambda A, B: A),
    ("product-starts-late", "", lambda A, B: B),
    ("last-row-missing", "", lambda A, B: _without_last_row(A @ B)),
    ("integer-arrays", "", lambda A, B: truncated(A @ B)),
    ("length-unit", "", lambda A, B: _with_R(A @ B, (A @ B)[:3, :3]) * np.where(np.arange(4) == 3, [[1000], [1000], [1000], [1]], 1)),
]
