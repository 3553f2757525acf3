"""From joint axes in space to common normals and DH numbers: the geometry behind
:func:`dhlab.assign_frames`.

Axis k is the axis of joint k, axis n+1 the z axis of the tool. Normal k joins axis k to axis k+1
(normal 0 is a choice, on axis 1). Both conventions hold these normals and these numbers: theta_k
and d_k between normals k-1 and k, a_k and alpha_k along normal k.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ..lines import (
    CommonNormal,
    across,
    angle_about,
    common_normal,
    nearest_on,
    parallel_normal,
    tilt,
    unit,
)

__all__ = ["Axis", "Choices", "Placement", "place", "tidy", "no_dust"]

# rad; axes out of a chain of matrices that should be parallel differ by some 1e-16, and snapping
# costs this much × reach
ROUNDING = 1e-12
# × reach; lines nearer than this meet or coincide, since positions are not known better
SAME_PLACE = 1e-13
CLEAR_SIDE = 1e-6  # × reach; from here on a common normal is long enough to say which way x points
# rad, 3°; below it a tilt of the tool is left to arm.tool, and a common normal may be far away
NEARLY = 0.05
EPS = np.finfo(float).eps


@dataclass
class Axis:
    """A line through ``p`` along the unit vector ``z``; ``letter`` is "R", "P" or "tool"."""

    p: NDArray[np.float64]
    z: NDArray[np.float64]
    letter: str


@dataclass
class Choices:
    """What the geometry leaves open; the keywords of ``assign_frames``."""

    x_signs: dict[int, int] = field(default_factory=dict)
    slides: dict[int, float] = field(default_factory=dict)
    x_along: dict[int, NDArray[np.float64]] = field(default_factory=dict)
    prismatic: str = "auto"
    parallel: float | None = None
    standard: bool = True


@dataclass
class Placement:
    """What :func:`place` found: ``axes`` 1 … n+1 and ``normals`` 0 … n, how each was found
    (``cases``), and the size of the arm in m.
    """

    axes: list[Axis]
    normals: list[CommonNormal]
    cases: list[str]
    reach: float
    snapped: dict[int, tuple[float, float]]

    def rows(self) -> NDArray[np.float64]:
        """(n, 4): theta_k, d_k, a_k, alpha_k for k = 1 … n."""
        return np.array([self.row(k) for k in range(1, len(self.normals))])

    def x(self, k: int) -> NDArray[np.float64]:
        """The direction of normal k."""
        x = self.normals[k].x
        assert x is not None  # place() gives one to every normal
        return x

    def row(self, k: int) -> NDArray[np.float64]:
        """theta_k, d_k, a_k, alpha_k."""
        before, normal = self.normals[k - 1], self.normals[k]
        return np.array(
            [
                tidy(angle_about(self.axes[k - 1].z, self.x(k - 1), self.x(k))),
                no_dust(normal.out - before.into, self.reach),
                no_dust(normal.a, self.reach),
                tidy(normal.alpha),
            ]
        )

    def frame_0(self) -> NDArray[np.float64]:
        """Frame 0 in the base frame: on axis 1, at normal 0."""
        axis, x = self.axes[0], self.x(0)
        T = np.eye(4)
        T[:3, :3] = np.column_stack([x, np.cross(axis.z, x), axis.z])
        T[:3, 3] = axis.p + self.normals[0].into * axis.z
        dust = EPS * 4 * max(1.0, self.reach)
        return np.where(abs(T - np.round(T)) < dust, np.round(T), T) + 0.0


def place(axes: list[Axis], end: NDArray[np.float64], choices: Choices) -> Placement:
    """Put a common normal between every axis and the next.

    Parameters
    ----------
    axes : list of Axis
        Joints 1 … n, z already with the sign that the table shall have.
    end : array (4, 4)
        The end pose; its z axis is the last line.
    choices : Choices

    Returns
    -------
    Placement

    Examples
    --------
    >>> z, x = np.array([0.0, 0, 1]), np.array([1.0, 0, 0])
    >>> axes = [Axis(np.zeros(3), z, "R"), Axis(0.4 * x, z, "R")]
    >>> found = place(axes, np.eye(4), Choices())
    >>> found.cases, found.normals[1].a
    (['start', 'parallel', 'parallel'], 0.4)
    """
    target = end[:3, 3]
    axes = [
        Axis(
            nearest_on(axis.p, axis.z, target) if axis.letter == "R" else axis.p,
            axis.z,
            axis.letter,
        )
        for axis in axes
    ]
    axes.append(Axis(target, unit(end[:3, 2]), "tool"))
    reach = _reach(axes, target)
    found = Placement(axes, [], [], reach, {})
    _start(found, choices)
    for k in range(1, len(axes)):
        _add_normal(found, k, end, choices)
    return found


def _reach(axes, target):
    """The size of the arm: how far the axes pass from the end point or the base; free of where
    points were chosen on the axes.
    """
    turning = [axis for axis in axes if axis.letter == "R"]
    places = [axis.p for axis in turning] + [
        nearest_on(axis.p, axis.z, np.zeros(3)) for axis in turning[:1]
    ]
    return max(
        [np.linalg.norm(p - target) for p in places]
        + [np.linalg.norm(target) if not turning else 0.0]
    )


def _start(found, choices):
    """Normal 0: from the point of axis 1 nearest to the base's origin, along the base's x (y when
    axis 1 runs along x).
    """
    axis = found.axes[0]
    if axis.letter == "P":
        _locate(found, 1, np.zeros(3), choices)
    wanted = choices.x_along.get(0, np.eye(3)[1 if abs(axis.z[0]) > 0.9 else 0])
    x = unit(across(wanted, axis.z)) * choices.x_signs.get(0, 1)
    into = -(axis.p @ axis.z) + choices.slides.get(0, 0.0)
    found.normals.append(CommonNormal(into, into, x, 0.0, 0.0))
    found.cases.append("start")


def _locate(found, k, previous, choices):
    """Give the sliding axis k a place: only its direction counts. ``previous`` is the last origin
    that is already known.
    """
    axis, behind = found.axes[k - 1], found.axes[k]
    how = choices.prismatic
    if how == "auto":
        turns_behind = behind.letter == "R" and tilt(axis.z, behind.z) < NEARLY
        how = "next" if turns_behind else "previous"
    if how == "previous":
        axis.p = previous
    elif how == "next":
        axis.p = _next_origin(found.axes, k)


def _next_origin(axes, k):
    """A point of axis k+1 that the rest of the chain singles out: where the normal behind it
    starts, else the point given.
    """
    if axes[k].letter == "P":
        return _next_origin(axes, k + 1)
    if k + 1 < len(axes) and axes[k + 1].letter == "R" and tilt(axes[k].z, axes[k + 1].z) > NEARLY:
        return (
            axes[k].p
            + axes[k].z * common_normal(axes[k].p, axes[k].z, axes[k + 1].p, axes[k + 1].z).out
        )
    return axes[k].p


def _add_normal(found, k, end, choices):
    """Normal k, from axis k to axis k+1, and how it was found."""
    here, there, before = found.axes[k - 1], found.axes[k], found.normals[-1]
    if there.letter == "P":
        _locate(found, k + 1, here.p + before.into * here.z, choices)
    if not _is_parallel(found, k, choices):
        normal, case = _crossing(here, there, choices.x_signs.get(k, 1), found.reach)
    else:
        normal, case = _alongside(found, k, end, choices)
    found.normals.append(normal)
    found.cases.append(case)


def _is_parallel(found, k, choices):
    """Whether axis k+1 counts as parallel to axis k; its direction is then made so.

    Below ROUNDING always. Above it, when the caller said so, or when the exact table would be the
    less exact one: its numbers are as large as the distance to the common normal and lose EPS of
    it, where taking the axes as parallel loses the angle × reach. A small tilt of the tool costs
    nothing at all, since arm.tool holds it.
    """
    here, there = found.axes[k - 1], found.axes[k]
    angle = tilt(here.z, there.z)
    if angle > ROUNDING:
        N = common_normal(here.p, here.z, there.p, there.z)
        far = max(abs(N.out), abs(N.into))
        asked = choices.parallel is not None and angle <= choices.parallel
        held = there.letter == "tool" and angle < NEARLY
        if not (asked or held or 4 * EPS * far > angle * found.reach):
            return False
        found.snapped[k] = (angle, far)
    there.z = _aligned(here.z, there.z)
    return True


def _aligned(z, w):
    return z.copy() if z @ w > 0 else -z


def _crossing(here, there, sign, reach):
    """The one common normal of two axes that are not parallel; x from the first to the second,
    along z × z' when they meet.
    """
    N = common_normal(here.p, here.z, there.p, there.z)
    meet = abs(N.a) <= SAME_PLACE * reach
    if N.a < -CLEAR_SIDE * reach:
        sign = -sign
    return CommonNormal(N.out, N.into, sign * N.x, 0.0 if meet else sign * N.a, sign * N.alpha), (
        "meet" if meet else "skew"
    )


def _alongside(found, k, end, choices):
    """A normal of parallel axes: through the previous origin (the tool's: through the end point)
    unless slid; x as before when they coincide.
    """
    here, there, before = found.axes[k - 1], found.axes[k], found.normals[-1]
    out = (there.p - here.p) @ here.z if there.letter == "tool" else before.into
    # z_k is axis k+1 (standard) or axis k (Craig)
    along_z_k = np.sign(here.z @ there.z) if choices.standard else 1.0
    out += choices.slides.get(k, 0.0) * along_z_k
    N = parallel_normal(here.p, here.z, there.p, there.z, out, SAME_PLACE * found.reach)
    x, sign = N.x, choices.x_signs.get(k, 1)
    sense = "parallel" if N.alpha == 0 else "antiparallel"
    if x is not None:
        return CommonNormal(N.out, N.into, sign * x, sign * N.a, N.alpha), sense
    x = end[:3, 0] if there.letter == "tool" else before.x
    x = unit(across(choices.x_along.get(k, x), here.z))
    return CommonNormal(N.out, N.into, sign * x, 0.0, N.alpha), (
        "same line" if sense == "parallel" else "same line, opposite"
    )


def tidy(angle: float) -> float:
    """An angle that only rounding keeps from a multiple of 15° becomes it; -180° becomes 180°."""
    step = np.pi / 12
    near = round(angle / step) * step
    angle = near if abs(angle - near) < 4 * EPS else angle
    return np.pi if angle == -np.pi else angle + 0.0


def no_dust(length: float, reach: float) -> float:
    """``length``, or 0 when it is rounding at the size of the arm."""
    return 0.0 if abs(length) < 4 * EPS * reach else length
