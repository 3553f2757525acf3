"""The numbers that programs for one link and for a chain are called with: general ones in every
quadrant, and the special ones where an if hides.

General angles keep away from 0 and ±180°, where wrong programs agree, and reach past ±90°: a
program that loses the sign of a cosine is right between -90° and 90°.
"""

import numpy as np

__all__ = ["general_row", "general_chain", "SPECIAL"]

HALF = np.pi / 2
_ROWS = np.array([[0, 0.1, 0, HALF], [HALF, 0, 0.4, 0], [0, 0, -0.35, -HALF]])
SPECIAL = {
    "dh_transform": (
        (0.0, 0.0, 0.0, 0.0),
        (HALF, 0.1, 0.2, -HALF),
        (np.pi, 0.0, 0.3, HALF),
        (-HALF, -0.2, 0.0, 0.0),
        (0.0, 0.15, 0.0, np.pi),
    ),
    "forward_kinematics": (
        (_ROWS, np.zeros(3)),
        (_ROWS, np.array([HALF, 0, -HALF])),
        (_ROWS[:2], np.array([np.pi, -HALF])),
    ),
}


def general_row(rng):
    """theta, d, a, alpha of one row: no zeros, no right angles, every sign and quadrant.

    Examples
    --------
    >>> theta, d, a, alpha = general_row(np.random.default_rng(1))
    >>> 0.2 < abs(theta) < 2.9 and 0.05 < abs(a) < 0.6
    True
    """
    return _angle(rng), _length(rng), _length(rng), _angle(rng)


def general_chain(rng, n=None):
    """Rows (n, 4) and q (n,) of a chain of n joints, 3 to 7 when n is not given.

    Examples
    --------
    >>> rows, q = general_chain(np.random.default_rng(1), 4)
    >>> rows.shape, q.shape
    ((4, 4), (4,))
    """
    n = int(rng.integers(3, 8)) if n is None else n
    rows = np.array([general_row(rng) for _ in range(n)])
    return rows, np.array([_angle(rng) for _ in range(n)])


def _angle(rng):
    size = rng.uniform(0.2, 2.55)
    return _signed(
        rng, size if size < 1.4 else size + 0.35
    )  # not between 1.4 and 1.75, where cosines are small


def _length(rng):
    return _signed(rng, rng.uniform(0.05, 0.6))


def _signed(rng, size):
    return size if rng.random() < 0.5 else -size
