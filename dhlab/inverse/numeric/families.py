"""Solutions that are not alone: at some poses joints can move and the end stays where it is."""

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ..joints import nearest_by_turns
from ..residuals import missing, residuals

__all__ = ["flat", "same_family", "settled", "still_free"]

FLAT = 1e-5  # of the largest singular value: a direction in which the end hardly moves
PROBE = 0.02  # rad or m: so far a joint of a family moves, and the end is back in place
SHARE = 1e-3  # of the largest component: which joints take part
ALIKE = 1e-5  # rad, m
CORRECTIONS, WALK = 5, 200


def flat(arm: Arm, q: NDArray[np.float64], free: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Where the Jacobian of the free joints loses rank: booleans (k,) for ``q`` (k, n)."""
    sizes = np.linalg.svd(arm.jacobian(q)[..., free], compute_uv=False)
    return sizes[:, -1] <= FLAT * sizes[:, 0]


def still_free(
    arm: Arm,
    q: NDArray[np.float64],
    T: NDArray[np.float64],
    tolerance: float,
    free: NDArray[np.bool_] | None = None,
) -> tuple[int, ...]:
    """Which joints of a solution can move while the end stays.

    Parameters
    ----------
    arm : Arm
    q : array (n,)
        A solution for ``T``.
    T : array (4, 4)
    tolerance : float
        Metres and radians.
    free : array (n,) of bool, optional
        The joints that are not held; all when left out.

    Returns
    -------
    tuple of joints, from 1; empty where the solution stands alone

    Notes
    -----
    That the Jacobian loses rank is not enough: a stretched arm's does, and it cannot move. So a
    step is made along each direction that the Jacobian does not see, the end is brought back, and
    the joints that have moved then are the answer.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm, q = dh.load("puma560"), np.array([0.1, 0.2, 0.3, 0.4, 0.0, 0.6])
    >>> still_free(arm, q, arm.forward(q), 1e-9)
    (4, 6)
    """
    free = np.ones(len(arm), dtype=bool) if free is None else free
    moved = np.zeros(len(arm))
    for direction in _unseen(arm, q, free):
        for side in (1.0, -1.0):
            there = _brought_back(arm, q + side * PROBE * direction, T, free)
            if (residuals(arm, there[None], T)[0] <= tolerance).all():
                step = np.abs(there - q)
                moved = np.maximum(moved, step if step.max() > PROBE / 2 else 0)
    return tuple(int(i) + 1 for i in np.flatnonzero(moved > SHARE * max(moved.max(), PROBE)))


def same_family(
    arm: Arm, q: NDArray[np.float64], other: NDArray[np.float64], moving: tuple[int, ...]
) -> bool:
    """Whether two solutions in which the same two joints can move are one family: two such joints
    turn about one line (or slide along one), so that all of their family has the others alike.
    """
    stays = [i for i in range(len(arm)) if i + 1 not in moving]
    apart = np.abs(nearest_by_turns(arm, q, other) - other)[stays]
    return len(moving) == 2 and apart.max(initial=0.0) < ALIKE


def settled(
    arm: Arm,
    q: NDArray[np.float64],
    T: NDArray[np.float64],
    to: NDArray[np.float64],
    tolerance: float,
    free: NDArray[np.bool_],
) -> NDArray[np.float64]:
    """The member of a solution's family that is nearest to ``to`` (n,), as far as a walk along the
    family gets; ``q`` (n,) itself where that does not work.

    Members of one family that were met apart settle to the same place, and are one then.
    """
    for _ in range(WALK):
        N = _unseen(arm, q, free)
        way = N.T @ (N @ (nearest_by_turns(arm, to, q) - q))
        far = np.abs(way).max(initial=0.0)
        if far < 1e-12:
            break
        there = _brought_back(arm, q + way * min(1.0, 5 * PROBE / far), T, free)
        if not (residuals(arm, there[None], T)[0] <= tolerance).all():
            break
        if np.abs(there - q).max() < 1e-10:
            break
        q = there
    return q


def _unseen(arm, q, free):
    """Unit directions (k, n) of the free joints in which the end does not move, to first order."""
    _, sizes, Vh = np.linalg.svd(arm.jacobian(q)[:, free])
    rank = int((sizes > FLAT * sizes.max(initial=0.0)).sum())
    directions = np.zeros((len(Vh) - rank, len(arm)))
    directions[:, free] = Vh[rank:]
    return directions


def _brought_back(arm, q, T, free):
    """``q`` (n,) with its end moved back to ``T``, by the smallest steps of the free joints."""
    q = q.copy()
    for _ in range(CORRECTIONS):
        inverse = np.linalg.pinv(arm.jacobian(q)[:, free], rcond=FLAT)
        q[free] += inverse @ missing(arm, q[None], T[None])[0]
    return q
