"""The rules for x_i: it lies along the common normal, at right angles to both z axes."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..geometry.lines import across, tilt, unit
from ..printing import number
from .geometry import Geometry
from .words import ANGLE, NO_DIRECTION, Judgement, vector

__all__ = ["judge_x"]


def judge_x(
    found: Geometry, z: NDArray[np.float64], direction: ArrayLike, n: int
) -> tuple[Judgement, NDArray[np.float64] | None]:
    """Judge a direction for x_i of an arm with ``n`` joints; the origin is placed, z_i is ``z``.

    Returns
    -------
    Judgement
    exact : array (3,) or None

    Examples
    --------
    >>> from dhlab.placing.geometry import geometry
    >>> e = np.eye(3)
    >>> found = geometry(1, ("z1", "z0"), 1.0, e[1], (0 * e[0], e[1]), (0 * e[0], e[2]))
    >>> print(judge_x(found, e[1], [0, 1, 1], 2)[0])
    ✗ x1: This lies in the plane of z0 and z1. The two meet, so x1 stands on that plane, along
          z0 × z1 or against it.
    """
    v = vector(direction)
    if v is None or not np.abs(v).max() > 0:
        return Judgement(f"x{found.i}", False, *NO_DIRECTION), None
    v = unit(v / np.abs(v).max())
    if found.x is None and tilt(v, z) > np.pi / 2 - ANGLE:
        why = (
            f"Frame {found.i} is at the free end of the chain"
            if found.other is None
            else f"{found.names[1]} and {found.names[0]} are one line"
        )
        return Judgement(
            f"x{found.i}",
            True,
            "free",
            f"{why}, so any x at right angles to {found.names[0]} will do.",
        ), unit(across(v, z))
    if found.x is not None and tilt(v, found.x) <= ANGLE:
        return Judgement(f"x{found.i}", True, *_right_x(found, n)), found.x * np.sign(v @ found.x)
    return Judgement(f"x{found.i}", False, *_x_fault(found, z, v)), None


def _right_x(found, n):
    (z, w), i = found.names, found.i
    across = found.case in ("meet", "loose")
    says = (
        f"At right angles to {w} and {z}" if across else f"Along the common normal of {w} and {z}"
    )
    signs = (
        f"α{i} would change sign (a{i} is 0)"
        if found.case == "meet"
        else f"a{i} and α{i} would change sign"
    )
    turns = " and ".join(f"θ{k}" for k in (i, i + 1) if 1 <= k <= n)
    takes = "" if 1 <= i < n else f", and the {'tool' if i else 'base'} takes up the rest"
    return "across-both" if across else "common-normal", (
        f"{says}. The other sense would do as well: {signs}, {turns} by 180°{takes}."
    )


def _x_fault(found, z, v):
    i, (own, w) = found.i, found.names
    if tilt(v, z) <= ANGLE:
        return "x-along-z", f"This runs along {own} itself. x{i} is at right angles to {own}."
    if found.case == "meet" and tilt(v, found.x) > np.pi / 2 - ANGLE:
        return (
            "x-in-plane",
            (
                f"This lies in the plane of {w} and {own}. The two meet, so x{i} stands on that"
                f" plane, along {w} × {own} or against it."
            ),
        )
    if tilt(v, z) < np.pi / 2 - ANGLE:
        return (
            "x-not-across-z",
            (
                f"The angle between this and {own} is {number(np.rad2deg(tilt(v, z)), 0)}°, not"
                f" 90°. x{i} is at right angles to {own}."
            ),
        )
    if tilt(v, found.other[1]) < np.pi / 2 - ANGLE:
        return (
            "x-not-across-other",
            (
                f"This is at right angles to {own}, but not to {w}. α turns one into the other"
                f" about x{i}, so x{i} is at right angles to both: look along their common normal."
            ),
        )
    return (
        "x-misses-other-axis",
        (
            f"From o{i} this line passes {w} by. x{i} must meet {w}: it lies along the shortest way"
            " from one axis to the other."
        ),
    )
