"""What a controller counts, ``q``, and the joint variables of the table; and the same
configuration a whole turn further on.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arm import Arm

__all__ = ["bounds", "counted", "inside_by_turns", "nearest_by_turns", "variables", "wrapped"]

TURN = 2 * np.pi
ROUNDING = 1e-11  # rad, m


def variables(arm: Arm, q: ArrayLike) -> NDArray[np.float64]:
    """The joint variables of ``q`` (..., n), without the table's offsets; :func:`counted` is the
    way back.

    These two are the only place of this room that knows how an arm counts its joints.

    Examples
    --------
    >>> import dhlab as dh
    >>> variables(dh.load("ar4"), np.ones(6))
    array([-1.,  1.,  1.,  1.,  1.,  1.])
    """
    return arm.joint_values(q)


def counted(arm: Arm, v: NDArray[np.float64]) -> NDArray[np.float64]:
    """``q`` (..., n) of joint variables ``v``."""
    if arm.coupling is None:
        return arm.sign * v
    return arm.sign * np.linalg.solve(arm.coupling, np.asarray(v, dtype=float)[..., None])[..., 0]


def wrapped(angle: ArrayLike) -> NDArray[np.float64]:
    """Angles brought into (-π, π] by whole turns.

    Examples
    --------
    >>> wrapped(np.array([-np.pi, 3 * np.pi / 2])).round(4)
    array([ 3.1416, -1.5708])
    """
    return np.pi - np.mod(np.pi - np.asarray(angle, dtype=float), TURN)


def nearest_by_turns(
    arm: Arm, q: NDArray[np.float64], to: NDArray[np.float64]
) -> NDArray[np.float64]:
    """``q`` (..., n) with every revolute joint turned by whole turns until it is nearest to ``to``
    (..., n).

    Examples
    --------
    >>> import dhlab as dh
    >>> nearest_by_turns(dh.load("ur5e"), np.full(6, 6.0), np.zeros(6)).round(4)
    array([-0.2832, -0.2832, -0.2832, -0.2832, -0.2832, -0.2832])
    """
    away = variables(arm, np.asarray(q, dtype=float) - to)
    return to + counted(arm, np.where(arm.table.prismatic, away, wrapped(away)))


def bounds(arm: Arm) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Lowest and highest ``q``, two arrays (n,); infinite where the arm states no limit.

    Examples
    --------
    >>> import dhlab as dh
    >>> bounds(dh.load("cobra600"))[1].round(4)
    array([0.8727, 1.5359, 0.21  , 3.1416])
    """
    pairs = [
        (-np.inf, np.inf) if pair is None else pair for pair in arm.limits or [None] * len(arm)
    ]
    low, high = np.array(pairs, dtype=float).T
    return low, high


def inside_by_turns(arm: Arm, q: NDArray[np.float64]) -> NDArray[np.float64]:
    """``q`` (k, n) moved by whole turns until as little as possible of it is outside the limits;
    what only rounding puts outside is put onto the limit.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("puma560")
    >>> np.rad2deg(inside_by_turns(arm, np.deg2rad([[0, -170, 0, 0, 0, 0]]))).round(6)
    array([[  0., 190.,   0.,   0.,   0.,   0.]])
    """
    low, high = bounds(arm)
    q = np.array(q, dtype=float)
    if ((low <= q) & (q <= high)).all():
        return q
    for joint in np.flatnonzero(~arm.table.prismatic):
        turn = counted(arm, TURN * np.eye(len(arm))[joint])
        tries = q[:, None, :] + np.array([0, -1, 1])[:, None] * turn
        over = (np.maximum(low - tries, 0) + np.maximum(tries - high, 0)).sum(axis=-1)
        q = tries[np.arange(len(q)), np.argmin(over, axis=1)]  # the first of equals: as it was
    inside = np.clip(q, low, high)
    return np.where(np.abs(inside - q) < ROUNDING, inside, q)
