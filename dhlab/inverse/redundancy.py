"""Arms with a joint to spare: which joint is held, and at which values."""

from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from ..geometry.canonical import joint_axes
from .joints import bounds
from .meeting import meeting_point

__all__ = ["given_holds", "joint_to_hold", "usual_holds"]

STEP = np.pi / 8  # between the values that are tried when none is stated


def joint_to_hold(arm: Arm) -> int:
    """The joint (from 0) that is held when seven joints turn and none is named.

    Joint 3 where the last three axes meet, which turns the elbow about the line from shoulder to
    wrist (KUKA LBR iiwa); joint 7 where only the first three do (Franka Panda); else joint 3.

    Examples
    --------
    >>> import dhlab as dh
    >>> joint_to_hold(dh.load("iiwa14")), joint_to_hold(dh.load("panda"))
    (2, 6)
    """
    axes = joint_axes(arm)
    wrist, shoulder = (meeting_point(axes.p[part], axes.z[part]) for part in (np.s_[4:], np.s_[:3]))
    return 6 if wrist is None and shoulder is not None else 2


def usual_holds(arm: Arm, near: NDArray[np.float64] | None = None) -> list[dict[int, float]]:
    """What is tried, one after the other, when no redundancy is stated: the joint at its value in
    ``near``, or in the middle of its range, and from there outwards.

    Returns
    -------
    list of {joint from 0: value of q}

    Examples
    --------
    >>> import dhlab as dh
    >>> [round(hold[2], 4) for hold in usual_holds(dh.load("iiwa14"))[:3]]
    [0.0, 0.3927, -0.3927]
    """
    joint = joint_to_hold(arm)
    low, high = (float(bound[joint]) for bound in bounds(arm))
    if not np.isfinite([low, high]).all():
        low, high = -np.pi, np.pi
    middle = (low + high) / 2 if near is None else float(near[joint])
    reach = max(high - middle, middle - low, 0.0)
    steps = [0.0] + [side * k * STEP for k in range(1, int(reach / STEP) + 1) for side in (1, -1)]
    return [{joint: middle + step} for step in steps if step == 0 or low <= middle + step <= high]


def given_holds(arm: Arm, redundancy: Any) -> list[dict[int, float]]:
    """The same from what a user states: a value or several of the usual joint, or
    ``{joint from 1: value or values}``; every combination.

    Examples
    --------
    >>> import dhlab as dh
    >>> given_holds(dh.load("panda"), {7: [0.5, 0.7]})
    [{6: 0.5}, {6: 0.7}]
    """
    n = len(arm)
    if n <= 6:
        raise ValueError(
            "solve: redundancy: expected an arm with a joint to spare, found"
            f" {arm.name or 'an arm'} with {n} joints; leave redundancy out"
        )
    stated = redundancy if isinstance(redundancy, dict) else {joint_to_hold(arm) + 1: redundancy}
    for joint in stated:
        if (
            isinstance(joint, bool)
            or not isinstance(joint, (int, np.integer))
            or not 1 <= joint <= n
        ):
            raise ValueError(
                f"solve: redundancy: expected joints from 1 to {n}, found {joint!r}; as in"
                " {3: 0.4}"
            )
    if not 1 <= len(stated) <= n - 6:
        raise ValueError(
            f"solve: redundancy: expected {'one joint' if n == 7 else f'1 to {n - 6} joints'} to be"
            f" held, found {len(stated)}; an arm needs six joints for every pose"
        )
    lists = [_values(values, joint) for joint, values in stated.items()]
    return [
        {int(joint) - 1: value for joint, value in zip(stated, chosen, strict=True)}
        for chosen in product(*lists)
    ]


def _values(values, joint):
    try:
        array = np.atleast_1d(np.asarray(values, dtype=float))
    except (TypeError, ValueError):
        array = np.array([np.nan])
    if array.ndim != 1 or not len(array) or not np.isfinite(array).all():
        raise ValueError(
            f"solve: redundancy: joint {joint}: expected a value of q or several (radians, metres"
            f" for a prismatic joint), found {values!r}"
        )
    return array.tolist()
