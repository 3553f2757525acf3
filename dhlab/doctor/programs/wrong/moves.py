"""Wrong versions of a turn about x and of the product of two poses: what a learner's
``rot_x(alpha)`` and ``compose(T_ab, T_bc)`` compute when one thing is wrong.
"""

import numpy as np

from ....transform import from_xyz_rpy, rot_x, rot_y, rot_z
from ..search.steps import slips
from .versions import Versions

__all__ = ["WRONG_COMPOSE", "WRONG_ROT_X"]

DEG = 180 / np.pi


def _finished(right):
    """What can happen to any finished pose."""
    for slip in slips("result"):
        yield slip.mistake, slip.place, lambda *case, slip=slip: slip.change(right(*case))


# ---- a turn about x


def _turns():
    yield "rotation-transposed", "", lambda al: rot_x(-al)
    yield from _finished(rot_x)
    yield "degrees-in-sin-cos", "", lambda al: rot_x(al * DEG)
    yield "converted-to-radians-twice", "", lambda al: rot_x(al / DEG)
    yield "rotation-block-misread", "this turns about z", rot_z
    yield "rotation-block-misread", "this turns about z, the other way", lambda al: rot_z(-al)
    yield "turn-about-y", "", rot_y
    yield "turn-about-y", "and the other way round", lambda al: rot_y(-al)
    yield "sin-cos-exchanged", "", lambda al: rot_x(np.pi / 2 - al)
    yield "mirror", "the minus before one sine is lost", lambda al: _other_sign(al, -np.sin(al))
    yield "mirror", "a minus too many before a sine", lambda al: _other_sign(al, np.sin(al))
    yield (
        "not-rigid",
        "the 1 for the axis that stays is missing",
        lambda al: rot_x(al) - np.diag([1, 0, 0, 0]),
    )
    for k in (2, 1):
        place = f"row {k + 1}, column {k + 1}"
        yield "matrix-entry-mistyped", place, lambda al, k=k: _one_at(rot_x(al), k)


def _other_sign(alpha, entry):
    """The entries of this value with the other sign."""
    T = rot_x(alpha)
    return np.where(entry == T, -T, T)


def _one_at(T, k):
    T = T.copy()
    T[k, k] = 1
    return T


WRONG_ROT_X = Versions(_turns, lambda: (0.3,), rot_x)


# ---- the product of two poses


def _compose(T_ab, T_bc):
    return T_ab @ T_bc


def _products():
    yield "product-reversed", "", lambda A, B: B @ A
    yield "elementwise-product", "", lambda A, B: A * B
    yield "translations-not-rotated", "", _added
    yield "translations-not-rotated", "whole matrices added", _sum
    yield "translations-not-rotated", "whole matrices added", lambda A, B: A + B
    yield "product-stops-early", "", lambda A, B: A
    yield "product-starts-late", "", lambda A, B: B
    yield from _finished(_compose)
    yield "pose-inverted", "the first pose", lambda A, B: np.linalg.inv(A) @ B
    yield "pose-inverted", "the second pose", lambda A, B: A @ np.linalg.inv(B)
    yield "matrix-transposed", "the first pose", lambda A, B: A.T @ B
    yield from _by_blocks()


def _by_blocks():
    """Rotation and position worked out apart, and one of the two otherwise than the product has
    it.
    """
    for mistake, place, R_ac, p_ac in (
        ("product-reversed", "the two rotations; the position is right", _back, _right_p),
        ("product-reversed", "the position; the rotation is right", _right_R, _p_back),
        ("product-reversed", "the second shift is added before it is turned", _right_R, _p_first),
        ("product-starts-late", "in the position: p_ab is left out", _right_R, _turned),
        ("product-stops-early", "in the position: p_bc is left out", _right_R, _p_ab),
        ("length-sign", "the turned p_bc is taken off, not added", _right_R, _p_minus),
        ("rotation-transposed", "R_ab, where it turns p_bc", _right_R, _p_turned_back),
        ("translations-not-rotated", "and the rotations are reversed", _back, _p_sum),
    ):

        def version(A, B, R_ac=R_ac, p_ac=p_ac):
            T = np.eye(4)
            T[:3, :3], T[:3, 3] = R_ac(A, B), p_ac(A, B)
            return T

        yield mistake, place, version


def _right_R(A, B):
    return A[:3, :3] @ B[:3, :3]


def _back(A, B):
    return B[:3, :3] @ A[:3, :3]


def _turned(A, B):
    return A[:3, :3] @ B[:3, 3]


def _right_p(A, B):
    return _turned(A, B) + A[:3, 3]


def _p_ab(A, B):
    return A[:3, 3]


def _p_minus(A, B):
    return A[:3, 3] - _turned(A, B)


def _p_sum(A, B):
    return A[:3, 3] + B[:3, 3]


def _p_back(A, B):
    return B[:3, :3] @ A[:3, 3] + B[:3, 3]


def _p_first(A, B):
    return A[:3, :3] @ (A[:3, 3] + B[:3, 3])


def _p_turned_back(A, B):
    return A[:3, :3].T @ B[:3, 3] + A[:3, 3]


def _added(T_ab, T_bc):
    T = T_ab @ T_bc
    T[:3, 3] = T_ab[:3, 3] + T_bc[:3, 3]
    return T


def _sum(T_ab, T_bc):
    T = T_ab + T_bc
    T[3, 3] = 1
    return T


def _two_poses():
    return from_xyz_rpy([0.3, -0.2, 0.5], [0.4, -0.7, 1.1]), from_xyz_rpy(
        [0.1, 0.6, -0.4], [1, 0.5, -0.3]
    )


WRONG_COMPOSE = Versions(_products, _two_poses, _compose)
