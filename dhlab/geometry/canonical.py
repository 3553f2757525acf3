"""The canonical form of an arm: its joint axes and its end pose at q = 0. Two arms move alike
exactly when these agree.

The pose is a product of exponentials, ``T(q) = e^(S_1 q_1) … e^(S_n q_n) M`` (Brockett 1984; Lynch
& Park, Modern Robotics, section 4.1), and the derivative of T by q_i at q = 0 gives S_i back, so
that S_1 … S_n and M are determined by the motion. What a DH table leaves free (which x, which
origin, which line for a sliding joint) is not in them.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from ..transform import inverse
from .lines import across, common_normal, nearest_on

__all__ = ["JointAxes", "joint_axes", "moved", "gaps", "align"]

# × the largest length that went in: what rounding makes of it, where lengths run away (574 m in a
# table of a 1 m arm) or are all 0 and only the base is not
ROUNDING = 64 * np.finfo(float).eps
PARALLEL = 1e-10  # rad; below it two axes do not say which way is across, or where along them is
# a pair of axes tilted more than this gives the sideways direction without regard to their distance
WELL_TILTED = 1e-3


@dataclass(frozen=True)
class JointAxes:
    """Axes of the joints at q = 0: ``p`` (n, 3) the point nearest to the end (m), ``z`` (n, 3) the
    direction in which the joint counts; ``end`` (4, 4); ``letters`` such as "RRP"; ``reach`` (m)
    how far the turning axes pass from the end; ``largest`` (m) the largest number that went in.
    """

    p: NDArray[np.float64]
    z: NDArray[np.float64]
    end: NDArray[np.float64]
    letters: str
    reach: float
    largest: float


def joint_axes(arm: Arm) -> JointAxes:
    """The canonical form of an arm.

    Parameters
    ----------
    arm : Arm

    Returns
    -------
    JointAxes

    Examples
    --------
    >>> import dhlab as dh
    >>> axes = joint_axes(dh.load("article-6r"))
    >>> axes.z[1].round(6) + 0.0, axes.p[1].round(6) + 0.0
    (array([ 0., -1.,  0.]), array([ 0. , -0.2,  0.1]))
    """
    chain = arm.frames(np.zeros(len(arm)))
    of_joint = chain[:-1] if arm.table.convention == "standard" else chain[1:]
    end = chain[-1] @ arm.tool
    z = of_joint[:, :3, 2] * counting(arm)[0][:, None]
    p = np.array([nearest_on(frame[:3, 3], axis, end[:3, 3]) for frame, axis in zip(of_joint, z)])
    turning = ~arm.table.prismatic
    reach = np.linalg.norm(p - end[:3, 3], axis=1)[turning].max(initial=0.0)
    return JointAxes(p, z, end, arm.table.joints, reach, largest_length(arm))


def largest_length(arm: Arm) -> float:
    """The largest length (m) among d, a, base and tool; at least 1 mm, for an arm of no length."""
    lengths = (arm.table.d, arm.table.a, arm.base[:3, 3], arm.tool[:3, 3])
    return max(1e-3, *(np.abs(column).max() for column in lengths))


def counting(arm: Arm) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """How the joints count, apart from how the table's z axes happen to point.

    Returns
    -------
    senses : array (n,)
        +1 where a joint moves along its z when q grows, -1 against it.
    rates : array (n, n)
        What each joint makes of q in that sense: the identity where joints are not coupled. Of a
        coupled joint the sense is that of the first number of q which moves it.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.Arm(dh.load("stanford").table, coupling=np.diag([1, -1, 2, 1, 1, 1]))
    >>> counting(arm)[0], counting(arm)[1].diagonal()
    (array([ 1., -1.,  1.,  1.,  1.,  1.]), array([1., 1., 2., 1., 1., 1.]))
    """
    if arm.coupling is None:
        return arm.sign, np.eye(len(arm))
    rates = arm.coupling * arm.sign
    first = np.argmax(rates != 0, axis=1)
    senses = np.sign(rates[np.arange(len(arm)), first])
    return senses, rates * senses[:, None]


def moved(X: NDArray[np.float64], axes: JointAxes) -> JointAxes:
    """The same axes and end after the rigid move ``X`` (4, 4)."""
    R = X[:3, :3]
    return JointAxes(
        axes.p @ R.T + X[:3, 3], axes.z @ R.T, X @ axes.end, axes.letters, axes.reach, axes.largest
    )


def gaps(a: JointAxes, b: JointAxes) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """How far the axes of b are from those of a, joint by joint.

    Parameters
    ----------
    a, b : JointAxes
        With the same letters.

    Returns
    -------
    angles, distances : arrays (n,)
        Radians from 0 to π; metres from a's axis to the point of b's axis nearest to a's end; 0 for
        a sliding joint, whose place is free.
    """
    angles = np.arctan2(np.linalg.norm(np.cross(a.z, b.z), axis=1), (a.z * b.z).sum(axis=1))
    distances = np.zeros(len(angles))
    for i, letter in enumerate(a.letters):
        if letter == "R":
            near = nearest_on(b.p[i], b.z[i], a.end[:3, 3])
            distances[i] = np.linalg.norm(across(near - a.p[i], a.z[i]))
    return angles, distances


def align(a: JointAxes, b: JointAxes, count: int | None = None) -> NDArray[np.float64]:
    """The rigid move that lays the axes of b on those of a, if any does.

    A frame is built from the axes alone, on a and in the same way on b. Where the axes leave some
    of it free (all parallel, all through one point, all sliding) any choice serves, since the move
    that is left over maps every axis to itself.

    Parameters
    ----------
    a, b : JointAxes
    count : int, optional
        Only the first ``count`` joints.

    Returns
    -------
    array (4, 4)
        X such that ``moved(X, b)`` has a's axes.

    Examples
    --------
    >>> import dhlab as dh
    >>> from dhlab.transform import from_xyz_rpy
    >>> axes, X = joint_axes(dh.load("ur5e")), from_xyz_rpy([1, 2, 3], [0.1, 0.2, 0.3])
    >>> bool(np.allclose(align(moved(X, axes), axes), X))
    True
    """
    used = range(len(a.letters) if count is None else count)
    across_by, origin_by = _sideways(a, used), _origin(a, used)
    return _frame(a, across_by, origin_by) @ inverse(_frame(b, across_by, origin_by))


def _most(pairs, size):
    """The pair of joints for which ``size`` is largest, and that size."""
    return max(((size(i, j), i, j) for i, j in pairs), default=(0.0, None, None))


def _pairs(used, letters, only_turning):
    chosen = [i for i in used if letters[i] == "R" or not only_turning]
    return [(i, j) for n, i in enumerate(chosen) for j in chosen[n + 1 :]]


def _sideways(a, used):
    """What gives the frame its directions: ("tilt", i, j), ("gap", i, j) or ("any", i, None)."""
    tilt, i, j = _most(
        _pairs(used, a.letters, False), lambda i, j: np.linalg.norm(np.cross(a.z[i], a.z[j]))
    )
    gap, k, m = _most(
        _pairs(used, a.letters, True), lambda i, j: np.linalg.norm(across(a.p[j] - a.p[i], a.z[i]))
    )
    gap = gap / a.reach if a.reach else 0.0
    if tilt > max(PARALLEL, min(gap, WELL_TILTED)):
        return "tilt", i, j
    return ("gap", k, m) if gap > PARALLEL else ("any", 0, None)


def _origin(a, used):
    """What gives the frame its place: ("foot", i, j) of the common normal of two turning axes,
    ("on", i, None), or ("any", 0, None).
    """
    tilt, i, j = _most(
        _pairs(used, a.letters, True), lambda i, j: np.linalg.norm(np.cross(a.z[i], a.z[j]))
    )
    if tilt > PARALLEL:
        return "foot", i, j
    turning = [i for i in used if a.letters[i] == "R"]
    return ("on", turning[0], None) if turning else ("any", 0, None)


def _frame(axes, across_by, origin_by):
    kind, i, j = across_by
    z = axes.z[i]
    sideways = {
        "tilt": lambda: np.cross(z, axes.z[j]),
        "gap": lambda: across(axes.p[j] - axes.p[i], z),
        "any": lambda: np.zeros(3),
    }[kind]()
    if np.linalg.norm(sideways) == 0:  # free; or b lacks what a has, which the comparison will show
        sideways = across(np.eye(3)[np.argmin(abs(z))], z)
    x = sideways / np.linalg.norm(sideways)
    T = np.eye(4)
    T[:3, :3] = np.column_stack([x, np.cross(z, x), z])
    T[:3, 3] = _place(axes, *origin_by)
    return T


def _place(axes, kind, i, j):
    if kind == "any":
        return np.zeros(3)
    if kind == "on" or np.linalg.norm(np.cross(axes.z[i], axes.z[j])) < PARALLEL:
        return axes.p[i]
    return axes.p[i] + axes.z[i] * common_normal(axes.p[i], axes.z[i], axes.p[j], axes.z[j]).out
