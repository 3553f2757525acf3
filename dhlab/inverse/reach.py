"""Exactly how far an arm with a shoulder, an elbow and a spherical wrist reaches."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from ..geometry.canonical import joint_axes
from ..geometry.lines import across, common_normal, tilt
from ..printing import number
from ..transform import inverse
from .meeting import meeting_point

__all__ = ["ElbowArm", "elbow_arm"]

SQUARE = 1e-9  # rad: axes at right angles, or parallel


@dataclass(frozen=True)
class ElbowArm:
    """Six joints whose last three axes meet, at right angles one to the next, and whose first three
    are a vertical axis and two parallel ones across it.

    Such a wrist can take up every orientation, so that a pose is within reach exactly when its
    wrist centre is.

    Parameters
    ----------
    base : array (4, 4)
        Axis 1 is its z, the shoulder (axis 2) stands ``forward`` of it at height 0.
    centre : array (3,)
        The wrist centre in the end's frame.
    forward, aside, upper, fore : float
        Metres: axis 2 from axis 1; the wrist centre from the plane through axis 1 in which the arm
        bends; elbow from shoulder; wrist centre from elbow.
    """

    base: NDArray[np.float64]
    centre: NDArray[np.float64]
    forward: float
    aside: float
    upper: float
    fore: float

    def shortfall(self, T: NDArray[np.float64]) -> tuple[float, str]:
        """How many metres the wrist centre lacks, and the sentence that says so; (0, "") when the
        pose ``T`` (4, 4) is within reach.
        """
        x, y, h = inverse(self.base)[:3] @ np.append(T[:3, :3] @ self.centre + T[:3, 3], 1.0)
        out = np.hypot(x, y)
        if out < self.aside:
            return self.aside - out, (
                f"with this orientation the wrist centre would lie {_mm(out)} from the axis of"
                f" joint 1, and it comes no nearer than {_mm(self.aside)}"
            )
        ahead = np.sqrt(out**2 - self.aside**2)
        spans = np.hypot([ahead - self.forward, ahead + self.forward], h)  # facing it, or turned
        longest, shortest = self.upper + self.fore, abs(self.upper - self.fore)
        lacks = np.maximum(np.maximum(spans - longest, shortest - spans), 0)
        best = int(np.argmin(lacks))
        if lacks[best] == 0:
            return 0.0, ""
        limit = (
            f"the arm stretches to {_mm(longest)}"
            if spans[best] > longest
            else f"it folds no shorter than {_mm(shortest)}"
        )
        return float(lacks[best]), (
            f"with this orientation the wrist centre would lie {_mm(spans[best])} from the"
            f" shoulder, and {limit}"
        )


def elbow_arm(arm: Arm) -> ElbowArm | None:
    """The arm as an :class:`ElbowArm`, or None when it is none.

    Examples
    --------
    >>> import dhlab as dh
    >>> puma = elbow_arm(dh.load("puma560"))
    >>> round(puma.upper, 4), round(puma.fore, 4), round(puma.aside, 5)
    (0.4318, 0.4323, 0.15005)
    >>> elbow_arm(dh.load("ur5e")) is None
    True
    """
    if len(arm) != 6 or arm.table.prismatic.any():
        return None
    axes = joint_axes(arm)
    p, z = axes.p, axes.z
    wrist = meeting_point(p[3:], z[3:])
    square = [abs(np.pi / 2 - tilt(z[i], z[i + 1])) < SQUARE for i in (0, 3, 4)]
    if wrist is None or not all(square) or tilt(z[1], z[2]) > SQUARE:
        return None
    normal = common_normal(p[0], z[0], p[1], z[1])
    origin = p[0] + normal.out * z[0]  # on axis 1, at the height of the shoulder
    x = normal.x
    assert x is not None  # which two axes that are not parallel always have
    base = np.eye(4)
    base[:3, :3] = np.column_stack([x, np.cross(z[0], x), z[0]])
    base[:3, 3] = origin
    centre = inverse(axes.end)[:3] @ np.append(wrist, 1.0)
    return ElbowArm(
        base,
        centre,
        forward=abs(float(normal.a)),
        aside=abs(float((wrist - origin) @ z[1])),
        upper=float(np.linalg.norm(across(p[2] - p[1], z[1]))),
        fore=float(np.linalg.norm(across(wrist - p[2], z[2]))),
    )


def _mm(metres):
    return f"{number(1000 * metres, 3)} mm"
