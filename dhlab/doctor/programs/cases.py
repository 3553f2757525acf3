"""The numbers that programs for one link and for a chain are called with: general ones in every
quadrant, and the special ones where an if hides.

General angles keep away from 0 and ±180°, where wrong programs agree, and reach past ±90°: a
program that loses the sign of a cosine is right between -90° and 90°.
"""

from itertools import combinations

import numpy as np

from .wrong.products import product

__all__ = ["general_row", "general_chain", "is_long", "where", "SPECIAL"]

HALF = np.pi / 2
_ROWS = np.array([[0, 0.1, 0, HALF], [HALF, 0, 0.4, 0], [0, 0, -0.35, -HALF]])
_FOLDED = np.array([[0.3, 0.2, 0.5, np.pi], [-0.8, -0.1, 0.3, 0], [0.4, 0.6, -0.2, 1.1]])
_LARGE = np.array([[0.5, -2.4, 1.7, 0.9], [-1.1, 1.3, -3.2, -0.6]])
_SEVEN = np.tile(_FOLDED, (3, 1))[:7]
SPECIAL = {
    "dh_transform": (
        (0.0, 0.0, 0.0, 0.0),
        (HALF, 0.1, 0.2, -HALF),
        (np.pi, 0.0, 0.3, HALF),
        (-HALF, -0.2, 0.0, 0.0),
        (0.0, 0.15, 0.0, np.pi),
        (0.7, 0.1, 0.3, 0.0),
        (-0.9, -0.2, 0.4, np.pi),
        (7.9, 0.2, -0.3, 0.8),
        (-3.7, 0.1, 0.2, -0.6),
        (1.2, -2.3, 1.8, 0.5),
        # of this one and the next four, one number is another: a cache must know all four
        (0.7, 0.1, 0.3, 0.4),
        (1.9, 0.1, 0.3, 0.4),
        (0.7, 0.45, 0.3, 0.4),
        (0.7, 0.1, -0.25, 0.4),
        (0.7, 0.1, 0.3, 1.3),
    ),
    "forward_kinematics": (
        (_ROWS, np.zeros(3)),
        (_ROWS, np.array([HALF, 0, -HALF])),
        (_ROWS[:2], np.array([np.pi, -HALF])),
        (_ROWS[:1], np.zeros(1)),
        (_LARGE[:1], np.array([0.6])),
        (_FOLDED, np.array([0.4, -1.2, 0.8])),
        (_FOLDED, np.array([7.1, -3.9, 4.4])),
        (_FOLDED[::-1], np.array([0.4, -1.2, 0.8])),
        (_LARGE, np.array([-0.7, 2.1])),
        (_SEVEN, np.array([0.3, -0.5, 0.7, -0.9, 1.1, -1.3, 1.5])),
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


def is_long(case):
    """Whether a length of a call, (theta, d, a, alpha) or (rows, q), is above 1 m: there a length
    that is cut to whole metres is no length that has no effect.

    Examples
    --------
    >>> is_long((0.7, 0.1, 0.3, 0.4)), is_long(([[0.7, -2.0, 0.3, 0.4]], [0.0]))
    (False, True)
    """
    row = np.asarray(case[0] if len(case) == 2 else case, dtype=float)
    return bool(np.abs(row[..., 1:3]).max() > 1)


# ---- in which calls


def where(kind, wrong, right):
    """What the calls that went wrong have in common, and no other call has.

    Parameters
    ----------
    kind : str
        ``"dh_transform"``, ``"craig_transform"``, ``"forward_kinematics"`` or
        ``"inverse_kinematics"``; nothing is known of others.
    wrong, right : sequences of tuples
        The arguments of the calls.

    Returns
    -------
    str
        Such as ``"there is one row only"``; "" when no such words are known.

    Examples
    --------
    >>> where("dh_transform", [(7.0, 0.1, 0.2, 0.3)], [(0.7, 0.1, 0.2, 0.3)])
    'θ is beyond ±180°'
    """
    traits = _TRAITS.get(kind, {})
    if not wrong:
        return ""
    told = {
        name: [bool(has(*case)) for case in wrong]
        for name, has in traits.items()
        if not any(has(*case) for case in right)
    }
    one = next((name for name, there in told.items() if all(there)), None)
    if one:
        return one
    both = (f"{a} or {b}" for a, b in combinations(told, 2) if all(map(any, zip(told[a], told[b]))))
    return next(both, "")


def _is(x, *angles):
    return any(np.isclose(x, angle, atol=1e-9) for angle in angles)


_OF_ROWS = {
    "θ is beyond ±180°": lambda t, d, a, al: abs(t) > np.pi + 1e-9,
    "θ is above 180°": lambda t, d, a, al: t > np.pi + 1e-9,
    "θ is below -180°": lambda t, d, a, al: t < -np.pi - 1e-9,
    "α is 180°": lambda t, d, a, al: _is(al, np.pi),
    "α is 0": lambda t, d, a, al: al == 0,
    "α is ±90°": lambda t, d, a, al: _is(abs(al), HALF),
    "θ is 180°": lambda t, d, a, al: _is(t, np.pi),
    "θ is ±90°": lambda t, d, a, al: _is(abs(t), HALF),
    "θ is 0": lambda t, d, a, al: t == 0,
    "a length is above 1 m": lambda t, d, a, al: max(abs(d), abs(a)) > 1,
    "a length is 0": lambda t, d, a, al: 0 in (d, a),
    "d is negative": lambda t, d, a, al: d < 0,
    "a is negative": lambda t, d, a, al: a < 0,
    "θ is negative": lambda t, d, a, al: t < 0,
    "α is negative": lambda t, d, a, al: al < 0,
    "α is beyond ±90°": lambda t, d, a, al: abs(al) > HALF + 1e-9,
    "θ is beyond ±90°": lambda t, d, a, al: abs(t) > HALF + 1e-9,
}
_OF_CHAINS = {
    "there is one row only": lambda rows, q: len(q) == 1,
    **{f"there are {n} rows": lambda rows, q, n=n: len(q) == n for n in range(2, 8)},
    "there are not six rows": lambda rows, q: len(q) != 6,
    "there are more than six rows": lambda rows, q: len(q) > 6,
    "there are more than three rows": lambda rows, q: len(q) > 3,
    "there are fewer than six rows": lambda rows, q: len(q) < 6,
    "an angle q is beyond ±180°": lambda rows, q: max(abs(q)) > np.pi + 1e-9,
    "a θ is beyond ±180°": lambda rows, q: max(abs(rows[:, 0] + q)) > np.pi + 1e-9,
    "an α is 180°": lambda rows, q: any(_is(al, np.pi) for al in rows[:, 3]),
    "an α is 0": lambda rows, q: any(rows[:, 3] == 0),
    "an α is ±90°": lambda rows, q: any(_is(abs(al), HALF) for al in rows[:, 3]),
    "a length is above 1 m": lambda rows, q: abs(rows[:, 1:3]).max() > 1,
    "a length is 0": lambda rows, q: (rows[:, 1:3] == 0).any(),
    "a joint value is 0": lambda rows, q: (q == 0).any(),
    "a length is negative": lambda rows, q: (rows[:, 1:3] < 0).any(),
}
_OF_TASKS = {
    "the start is near the goal": lambda rows, T_goal, q, *how: (
        np.abs(product(rows, q) - T_goal).max() < 0.01
    )
}
_TRAITS = {"dh_transform": _OF_ROWS, "craig_transform": _OF_ROWS, "forward_kinematics": _OF_CHAINS}
_TRAITS["inverse_kinematics"] = _OF_TASKS
