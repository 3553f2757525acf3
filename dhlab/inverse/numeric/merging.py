"""The same solution found twice is one solution."""

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ..joints import nearest_by_turns
from ..residuals import residuals

__all__ = ["merged"]

SAME = 1e-6  # rad and m: nearer than that in every joint, two are one
CLOSE = 1e-3  # nearer than that, they are one when half way between them solves the target too


def merged(
    arm: Arm, q: NDArray[np.float64], T: NDArray[np.float64], tolerance: float
) -> tuple[NDArray[np.float64], list[NDArray[np.int64]]]:
    """Distinct solutions, and which of the given ones each was met as.

    Parameters
    ----------
    arm : Arm
    q : array (k, n)
        Solutions for one target.
    T : array (4, 4)
    tolerance : float
        Metres and radians.

    Returns
    -------
    q : array (j, n)
        The first one met of each, in the order in which they were met.
    members : list of (j) arrays
        Indices into ``q``.

    Notes
    -----
    Near a singular pose a root is known only to the square root of the tolerance: what half way
    between still solves is one root, seen twice.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm, q = dh.load("ur5e"), np.array([0.1, -1, 1, 0.4, 0.5, 0.6])
    >>> merged(arm, [q, q + 2 * np.pi, q + 1e-9], arm.forward(q), 1e-9)[1]
    [array([0, 1, 2])]
    """
    q = np.reshape(q, (-1, len(arm)))
    if _clearly_apart(arm, q):
        return q, [np.array([k]) for k in range(len(q))]
    kept, members, left = [], [], np.arange(len(q))
    while len(left):
        first = q[left[0]]
        others = nearest_by_turns(arm, q[left], first)
        apart = np.abs(others - first).max(axis=1)
        same = apart < SAME
        near = np.flatnonzero(~same & (apart < CLOSE))
        if len(near):
            half = residuals(arm, (others[near] + first) / 2, T)
            same[near] = (half <= tolerance).all(axis=1)
        kept.append(first)
        members.append(left[same])
        left = left[~same]
    return np.reshape(kept, (-1, len(arm))), members


def _clearly_apart(arm, q):
    """Whether every two differ by more than what needs a closer look."""
    apart = np.abs(nearest_by_turns(arm, q[:, None] - q, np.zeros(len(arm)))).max(axis=-1)
    return (apart >= CLOSE).sum() == len(q) * (len(q) - 1)
