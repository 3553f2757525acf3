"""Wrong versions of Craig's link matrix: what a learner's function computes when one thing is
wrong; entries as in ``wrong_links``.
"""

from itertools import permutations

import numpy as np

from ....transform import inverse, rot_x, rot_z, trans_x, trans_z
from ..stages import rounded, truncated
from .links import distinct, standard

__all__ = ["craig", "WRONG_CRAIG"]

DEG = 180 / np.pi
SAMPLE = (0.3, -0.1, 0.4, 0.5)
MOVES = {
    "Rz": lambda row: rot_z(row[0]),
    "Tz": lambda row: trans_z(row[1]),
    "Tx": lambda row: trans_x(row[2]),
    "Rx": lambda row: rot_x(row[3]),
}


def craig(theta, d, a, alpha):
    """The right one: Rx(alpha) Tx(a) Rz(theta) Tz(d). Craig, Introduction to Robotics, eq. 3.6.

    Examples
    --------
    >>> craig(0.0, 0.1, 0.4, np.pi / 2)[:3, 3].round(6)
    array([ 0.4, -0.1,  0. ])
    """
    return rot_x(alpha) @ trans_x(a) @ rot_z(theta) @ trans_z(d)


def in_order(names, *row):
    """The four moves multiplied in any order, such as ``("Rx", "Tx", "Rz", "Tz")``."""
    return np.linalg.multi_dot([MOVES[name](row) for name in names])


def _other_orders():
    """The orders that give neither Craig's matrix nor the standard one."""
    for names in permutations(MOVES):
        T = in_order(names, *SAMPLE)
        if not any(np.allclose(T, known(*SAMPLE)) for known in (craig, standard)):
            yield (
                "order-taken-for-free",
                " ".join(names),
                lambda *row, names=names: in_order(names, *row),
            )


def _with_R(T, R):
    T = T.copy()
    T[:3, :3] = R
    return T


def _scaled(*row):
    T = craig(*row)
    T[:3, 3] *= 1000
    return T


WRONG_CRAIG = distinct(
    [
        ("craig-rows-in-standard-matrix", "the moves about and along z come first", standard),
        *_other_orders(),
        ("alpha-sign", "", lambda th, d, a, al: craig(th, d, a, -al)),
        ("length-sign", "a", lambda th, d, a, al: craig(th, d, -a, al)),
        ("length-sign", "d", lambda th, d, a, al: craig(th, -d, a, al)),
        ("a-d-exchanged", "", lambda th, d, a, al: craig(th, a, d, al)),
        ("theta-alpha-exchanged", "", lambda th, d, a, al: craig(al, d, a, th)),
        ("degrees-in-sin-cos", "", lambda th, d, a, al: craig(th * DEG, d, a, al * DEG)),
        ("alpha-in-degrees", "", lambda th, d, a, al: craig(th, d, a, al * DEG)),
        ("converted-to-radians-twice", "", lambda th, d, a, al: craig(th / DEG, d, a, al / DEG)),
        ("pose-inverted", "", lambda *row: inverse(craig(*row))),
        ("rotation-transposed", "", lambda *row: _with_R(craig(*row), craig(*row)[:3, :3].T)),
        ("matrix-transposed", "", lambda *row: craig(*row).T),
        (
            "elementwise-product",
            "",
            lambda *row: MOVES["Rx"](row) * MOVES["Tx"](row) * MOVES["Rz"](row) * MOVES["Tz"](row),
        ),
        ("last-row-missing", "", lambda *row: np.vstack([craig(*row)[:3], np.zeros(4)])),
        ("length-unit", "", _scaled),
        ("integer-arrays", "", lambda *row: truncated(craig(*row))),
        ("pi-rounded", "", lambda *row: rounded(craig(*row))),
    ],
    *SAMPLE,
)
