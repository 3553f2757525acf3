"""The rules for z_i: it lies on the axis of a joint, either way along it."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..geometry.lines import nearest_on, tilt, unit
from ..geometry.procedure.normals import NEARLY, Axis
from ..printing import number
from .geometry import LENGTH
from .words import ANGLE, NO_DIRECTION, NO_POINT, Judgement, beside, vector

__all__ = ["judge_z"]


Z_RULE = {
    "standard": "in the standard convention z{i} is the axis of joint {k}",
    "craig": "in Craig's convention z{i} is the axis of joint {k}",
}


def judge_z(
    i: int,
    axes: Sequence[Axis],
    convention: str,
    reach: float,
    direction: ArrayLike,
    point: ArrayLike | None = None,
) -> tuple[Judgement, tuple[NDArray[np.float64], NDArray[np.float64] | None] | None]:
    """Judge a direction for z_i, and a point of its line when one is given.

    Parameters
    ----------
    i : int
    axes : list of dhlab.geometry.procedure.normals.Axis
        Joints 1 … n, then the tool's.
    convention : "standard" or "craig"
    reach : float
        The size of the arm, m.
    direction, point
        What was given.

    Returns
    -------
    Judgement
    exact : pair of arrays (3,), or None
        Direction and point (or None) without the inexactness of a hand, when it is right.

    Examples
    --------
    >>> from dhlab.geometry.procedure.normals import Axis
    >>> z, y = np.array([0, 0, 1.0]), np.array([0, 1.0, 0])
    >>> axes = [Axis(0 * z, z, "R"), Axis(z, y, "R"), Axis(z, z, "tool")]
    >>> print(judge_z(1, axes, "standard", 1.0, [0, 0, 1])[0].message[:40])
    This points along the axis of joint 1; i
    >>> judgement, (exact, _) = judge_z(1, axes, "standard", 1.0, [0, -2, 0])
    >>> print(judgement.right, exact + 0)
    True [ 0. -1.  0.]
    """
    v, p = vector(direction), None if point is None else vector(point)
    if v is None or not np.abs(v).max() > 0:
        return Judgement(f"z{i}", False, *NO_DIRECTION), None
    if point is not None and p is None:
        return Judgement(f"z{i}", False, *NO_POINT), None
    v, n, standard = unit(v / np.abs(v).max()), len(axes) - 1, convention == "standard"
    k = i + standard
    if not 1 <= k <= n:
        axis = axes[n - 1 if standard else 0].z
        # else the common normal runs away; assign_frames does the same
        v = axis * np.sign(v @ axis) if tilt(v, axis) < NEARLY else v
        return Judgement(
            f"z{i}",
            True,
            "free",
            f"On no joint, so any direction will do; the {'tool' if standard else 'base'} takes up"
            " the rest.",
        ), (v, p)
    rule = Z_RULE[convention].format(i=i, k=k)
    fault = _z_fault(axes[:n], k, LENGTH * reach, v, p, rule, -1 if standard else 1)
    if fault:
        return Judgement(f"z{i}", False, *fault), None
    exact = axes[k - 1].z * np.sign(v @ axes[k - 1].z)
    return Judgement(f"z{i}", True, "joint-axis", _right_z(k, axes[k - 1], exact)), (exact, p)


def _right_z(k, axis, z):
    text = f"Along the axis of joint {k}"
    if z @ axis.z <= 0:
        text += f", against the joint's direction: joint {k} counts the other way, its sign is -1"
    if axis.letter == "P":
        text += "; the joint slides, so only the direction counts"
    return text + "."


def _z_fault(axes, k, near, v, p, rule, usual):
    """(rule, message) of what is wrong with a z along v through p for joint k, or None; ``usual``
    says whose axis is most often taken for it.
    """
    axis = axes[k - 1]
    if _on(axis, v, p, near):
        return None
    for j in (k + usual, k - usual):
        if 1 <= j <= len(axes) and _on(axes[j - 1], v, p, near):
            return (
                "z-on-wrong-joint",
                f"This points along the axis of joint {j}; {rule}. Look at the axis of joint {k}.",
            )
    away = tilt(v, axis.z)
    if away <= ANGLE:
        far = beside(axis.p, axis.z, p)
        return (
            "z-beside-axis",
            (
                f"The direction is right, but this line runs {far} m beside the axis of joint {k}."
                " z lies on the axis itself."
            ),
        )
    if away > np.pi / 2 - ANGLE:
        motion = "slides along" if axis.letter == "P" else "turns about"
        return (
            "z-across-axis",
            (
                f"This stands across the axis of joint {k}. z lies on the line the joint {motion}: "
                "move the joint alone and look for the line that stays in place."
            ),
        )
    return (
        "z-not-along-axis",
        (
            f"This is {number(np.rad2deg(away), 0)}° away from the axis of joint {k}; {rule}, and"
            " may point either way along it."
        ),
    )


def _on(axis, v, p, near):
    there = (
        p is None or axis.letter == "P" or np.linalg.norm(p - nearest_on(axis.p, axis.z, p)) <= near
    )
    return tilt(v, axis.z) <= ANGLE and there
