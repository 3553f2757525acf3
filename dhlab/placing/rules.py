"""The rules by which a step of placing frames is judged: one short id and one or two sentences per
choice, right or wrong.
"""

from dataclasses import dataclass
from textwrap import fill

import numpy as np

from ..geometry.lines import across, nearest_on, tilt, unit
from ..geometry.normals import NEARLY
from ..printing import number
from .geometry import LENGTH

__all__ = ["Judgement", "judge_z", "judge_origin", "judge_x", "ANGLE"]

WIDTH = 90  # of a printed judgement: what a notebook shows without breaking words
ANGLE = 0.01  # rad, 0.6°: a direction typed with three decimals is nearer than this
Z_RULE = {
    "standard": "in the standard convention z{i} is the axis of joint {k}",
    "craig": "in Craig's convention z{i} is the axis of joint {k}",
}
NO_DIRECTION = (
    "no-direction",
    "Expected a direction: three finite numbers, not all 0. Its length does not count.",
)
NO_POINT = (
    "no-point",
    "Expected three finite numbers x, y, z in metres. Look at what was typed or measured.",
)


@dataclass(frozen=True)
class Judgement:
    """What is said of one step: true in an ``if`` when it is right, a sentence when printed.

    ``step`` is "z2", "o2" or "x2"; ``rule`` the short id of the rule that the step keeps or breaks;
    ``message`` one or two sentences.
    """

    step: str
    right: bool
    rule: str
    message: str

    def __bool__(self):
        return self.right

    def __str__(self):
        return fill(
            f"{'✓' if self.right else '✗'} {self.step}: {self.message}",
            WIDTH,
            subsequent_indent=" " * 6,
        )

    __repr__ = __str__


def judge_z(i, axes, convention, reach, direction, point=None):
    """Judge a direction for z_i, and a point of its line when one is given.

    Parameters
    ----------
    i : int
    axes : list of dhlab.geometry.normals.Axis
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
    >>> from dhlab.geometry.normals import Axis
    >>> z, y = np.array([0, 0, 1.0]), np.array([0, 1.0, 0])
    >>> axes = [Axis(0 * z, z, "R"), Axis(z, y, "R"), Axis(z, z, "tool")]
    >>> print(judge_z(1, axes, "standard", 1.0, [0, 0, 1])[0])
    ✗ z1: This is the axis of joint 1; in the standard convention z1 is the axis of joint 2.
          Look at the axis of joint 2.
    >>> judgement, (exact, _) = judge_z(1, axes, "standard", 1.0, [0, -2, 0])
    >>> print(judgement.right, exact + 0)
    True [ 0. -1.  0.]
    """
    v, p = _vector(direction), None if point is None else _vector(point)
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
    fault = _z_fault(
        axes[:n],
        k,
        LENGTH * reach,
        v,
        p,
        Z_RULE[convention].format(i=i, k=k),
        -1 if standard else 1,
    )
    if fault:
        return Judgement(f"z{i}", False, *fault), None
    exact = axes[k - 1].z * np.sign(v @ axes[k - 1].z)
    return Judgement(f"z{i}", True, "joint-axis", _right_z(k, axes[k - 1], exact)), (exact, p)


def _right_z(k, axis, z):
    against = (
        ""
        if z @ axis.z > 0
        else f", against the joint's direction: joint {k} counts the other way, its sign is -1"
    )
    return (
        "Along the axis of joint"
        f" {k}{against}{'; the joint slides, so only the direction counts' if axis.letter == 'P' else ''}."
    )


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
                f"This is the axis of joint {j}; {rule}. Look at the axis of joint {k}.",
            )
    away = tilt(v, axis.z)
    if away <= ANGLE:
        far = _beside(axis.p, axis.z, p)
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


def judge_origin(found, point):
    """Judge a point (m) for o_i.

    Returns
    -------
    Judgement
    exact : array (3,) or None
        The point without the inexactness of a hand, when it is right.

    Examples
    --------
    >>> from dhlab.placing.geometry import geometry
    >>> e = np.eye(3)
    >>> found = geometry(1, ("z1", "z0"), 1.0, e[1], (e[0], e[1]), (0 * e[0], e[2]))
    >>> print(judge_origin(found, [0, 0, 0])[0])
    ✗ o1: This is the foot of the common normal on z0. Frame 1 belongs to z1, so o1 is the
          other foot, the one on z1.
    """
    p = _vector(point)
    if p is None:
        return Judgement(f"o{found.i}", False, *NO_POINT), None
    exact = (
        _reached(found, p)
        if found.line is None
        else nearest_on(*found.line, p)
        if found.origin is None
        else found.origin
    )
    if np.linalg.norm(p - exact) <= found.near:
        return Judgement(f"o{found.i}", True, *_right_origin(found)), exact
    return Judgement(f"o{found.i}", False, *_origin_fault(found, p)), None


def _reached(found, p):
    """The nearest point that one row reaches: any where there is no other line; else in the plane
    through it across which x stands, or, parallel, any.
    """
    if found.other is None:
        return p
    q, w = found.other
    if found.case == "loose, parallel":
        return p if np.linalg.norm(across(p - q, w)) > found.near else nearest_on(q, w, p)
    side = np.cross(w, found.x)
    return p - side * ((p - q) @ side)


def _right_origin(found):
    i, (z, w) = found.i, found.names
    return {
        "start": (
            "free",
            f"Frame {i} is at the free end of the chain, so anywhere on {z} will do.",
        ),
        "skew": ("foot", f"{w} and {z} are skew, and this is where their common normal meets {z}."),
        "meet": ("meeting-point", f"{w} and {z} meet here, so a is 0."),
        "loose": (
            "one-row",
            (
                f"One row reaches this point: from {w} it lies straight along x{i}, which is at"
                f" right angles to {w} and {z}."
            ),
        ),
        "loose, parallel": ("one-row", f"{z} runs through here, parallel to {w}."),
    }.get(
        found.case,
        (
            "slides",
            (
                f"{w} and {z} are {'one line' if found.case.startswith('same') else 'parallel'}, so"
                f" o{i} may stand anywhere on {z}."
            ),
        ),
    )


def _origin_fault(found, p):
    i, (z, w) = found.i, found.names
    if found.line is None:
        return (
            "not-one-row",
            (
                f"No single row leads here: x{i} must be at right angles to {w} and {z}, and its"
                f" line must meet {w}. Take the foot of the common normal of {w} and a line along"
                f" {z}; what is left goes into the tool or the next row."
            ),
        )
    if np.linalg.norm(p - nearest_on(*found.line, p)) > found.near:
        if found.other is None or np.linalg.norm(p - nearest_on(*found.other, p)) > found.near:
            return (
                "origin-off-z",
                (
                    f"This point is {_beside(*found.line, p)} m beside {z}. o{i} lies on {z},"
                    " wherever the housing of the joint may be."
                ),
            )
        if found.feet is not None and np.linalg.norm(p - found.feet[0]) <= found.near:
            return (
                "origin-on-other-axis",
                (
                    f"This is the foot of the common normal on {w}. Frame {i} belongs to {z}, "
                    f"so o{i} is the other foot, the one on {z}."
                ),
            )
        return (
            "origin-on-other-axis",
            f"This is a point of {w}. Frame {i} belongs to {z}, so o{i} lies on {z}.",
        )
    if found.case == "meet":
        return (
            "origin-not-at-meeting",
            (
                f"This point is on {z}, but away from where {w} and {z} meet. Axes that meet have"
                " their origin at the meeting point."
            ),
        )
    return (
        "origin-not-at-foot",
        (
            f"This point is on {z}, but x{i} from here would miss {w}. {w} and {z} are skew: "
            f"o{i} is the foot of their common normal on {z}."
        ),
    )


def judge_x(found, z, direction):
    """Judge a direction for x_i; the origin is placed, and z_i is ``z``.

    Returns
    -------
    Judgement
    exact : array (3,) or None

    Examples
    --------
    >>> from dhlab.placing.geometry import geometry
    >>> e = np.eye(3)
    >>> found = geometry(1, ("z1", "z0"), 1.0, e[1], (0 * e[0], e[1]), (0 * e[0], e[2]))
    >>> print(judge_x(found, e[1], [0, 1, 1])[0])
    ✗ x1: This lies in the plane of z0 and z1. The two meet, so x1 stands on that plane, along
          z0 × z1 or against it.
    """
    v = _vector(direction)
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
        return Judgement(f"x{found.i}", True, *_right_x(found)), found.x * np.sign(v @ found.x)
    return Judgement(f"x{found.i}", False, *_x_fault(found, z, v)), None


def _right_x(found):
    z, w = found.names
    if found.case in ("meet", "loose"):
        return "across-both", f"At right angles to {w} and {z}. The other sense would do as well."
    return (
        "common-normal",
        (
            f"Along the common normal of {w} and {z}. The other sense would do as well: a would"
            " change its sign."
        ),
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


def _beside(p, z, point):
    return number(np.linalg.norm(point - nearest_on(p, z, point)), 3)


def _vector(given):
    """Three finite numbers as an array, or None."""
    try:
        v = np.array(given, dtype=float)
    except (TypeError, ValueError):
        return None
    return v if v.shape == (3,) and np.isfinite(v).all() else None
