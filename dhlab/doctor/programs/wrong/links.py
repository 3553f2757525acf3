"""Wrong versions of the link matrix, of a turn about x and of a product of two poses: what a
learner's function computes when one thing is wrong.

Each entry of the lists is ``(mistake, place, function)``; :data:`WRONG_LINKS` holds functions of
theta, d, a, alpha; angles are radians.
"""

import numpy as np

from ....transform import rot_x, rot_y, rot_z, trans_x, trans_z
from ..entries import MONOMIALS
from ..slipsearch import mistyped
from ..stages import ARGUMENTS, LINK, RESULT, rounded, run_link, truncated

__all__ = ["standard", "WRONG_LINKS", "WRONG_ROT_X", "WRONG_COMPOSE", "distinct"]

DEG = 180 / np.pi


def standard(theta, d, a, alpha):
    """The right one: Rz(theta) Tz(d) Tx(a) Rx(alpha)."""
    return rot_z(theta) @ trans_z(d) @ trans_x(a) @ rot_x(alpha)


def _without_last_row(T):
    T = T.copy()
    T[3] = 0
    return T


def distinct(versions, *sample):
    """The (mistake, place, function) entries whose answers at ``sample`` no earlier entry gives
    under another id; first come, first named.
    """
    kept, seen = [], []
    with np.errstate(all="ignore"):
        for mistake, place, version in versions:
            T = version(*sample)
            if all(
                name == mistake or not np.allclose(T, other, rtol=1e-9, atol=1e-9, equal_nan=True)
                for name, other in seen
            ):
                kept.append((mistake, place, version))
                seen.append((mistake, T))
    return kept


def _with(slip):
    return lambda theta, d, a, alpha: run_link((slip,), theta, d, a, alpha)


def _typed(entry, sign, parts):
    return mistyped(entry, next(m for m in MONOMIALS if m.sign == sign and m.parts == parts))


TYPICAL_ENTRIES = [
    _typed((0, 1), 1, (2, 1, 0)),
    _typed((0, 2), -1, (2, 2, 0)),
    _typed((1, 2), 1, (1, 2, 0)),
    _typed((2, 1), -1, (0, 2, 0)),
    _typed((1, 3), 1, (1, 0, 1)),
    _typed((2, 3), 0, (0, 0, 0)),
]
WRONG_LINKS = distinct(
    [
        (slip.mistake, slip.place, _with(slip))
        for slip in ARGUMENTS + LINK + RESULT + TYPICAL_ENTRIES
    ],
    0.3,
    -0.1,
    0.4,
    0.5,
)

WRONG_ROT_X = [
    ("rotation-transposed", "", lambda al: rot_x(-al)),
    ("degrees-in-sin-cos", "", lambda al: rot_x(al * DEG)),
    ("converted-to-radians-twice", "", lambda al: rot_x(al / DEG)),
    ("rotation-block-misread", "this turns about z", rot_z),
    ("rotation-block-misread", "this turns about z, the other way", lambda al: rot_z(-al)),
    ("rotation-block-misread", "this turns about y", rot_y),
    ("rotation-block-misread", "this turns about y, the other way", lambda al: rot_y(-al)),
    ("sin-cos-exchanged", "", lambda al: rot_x(np.pi / 2 - al)),
    (
        "mirror",
        "the minus before one sine is lost",
        lambda al: np.where(rot_x(al) == -np.sin(al), np.sin(al), rot_x(al)),
    ),
    (
        "mirror",
        "a minus too many before a sine",
        lambda al: np.where(rot_x(al) == np.sin(al), -np.sin(al), rot_x(al)),
    ),
    ("last-row-missing", "", lambda al: _without_last_row(rot_x(al))),
    ("integer-arrays", "", lambda al: truncated(rot_x(al))),
    ("pi-rounded", "", lambda al: rounded(rot_x(al))),
    (
        "not-rigid",
        "the 1 for the axis that stays is missing",
        lambda al: rot_x(al) - np.diag([1, 0, 0, 0]),
    ),
    (
        "matrix-entry-mistyped",
        "row 3, column 3",
        lambda al: rot_x(al) + np.diag([0, 0, 1 - np.cos(al), 0]),
    ),
    (
        "matrix-entry-mistyped",
        "row 2, column 2",
        lambda al: rot_x(al) + np.diag([0, 1 - np.cos(al), 0, 0]),
    ),
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
    (
        "length-unit",
        "",
        lambda A, B: (
            _with_R(A @ B, (A @ B)[:3, :3])
            * np.where(np.arange(4) == 3, [[1000], [1000], [1000], [1]], 1)
        ),
    ),
]
