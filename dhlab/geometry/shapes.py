"""The shape of an arm: what is left of its table when base, tool, zeros and the free choices are
taken away; and whether two arms have one shape.

Between joints i and i + 1 of turning axes that is a_i and alpha_i, and along the axes d_2 … d_{n-1}
(of parallel axes only the sum): the common normals are where they are, however frames are laid.
Two arms of turning joints have one shape exactly when some zeros, signs, base and tool make them
one arm; a mirror image has another.
"""

from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from .conversion import to_convention
from .zeros import Rezeroed

__all__ = ["Shape", "SameShape", "shape", "same_shape"]

PARALLEL = 1e-6  # rad; a table of whole numbers has 0 or 180 here


@dataclass(frozen=True, eq=False)
class Shape:
    """``a``, ``alpha`` (n - 1,) between neighbouring axes and ``d`` (n,) along them in m and rad,
    with all of a parallel run in its first d, and 0 where base or tool take it up.
    """

    a: NDArray[np.float64]
    alpha: NDArray[np.float64]
    d: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class SameShape:
    """How arm b is laid on arm a: ``length`` (m) and ``angle`` (rad) by which the shapes differ at
    most, ``zeros`` with ``b(q) = base · a(sign · q + offset) · tool``.
    """

    length: float
    angle: float
    zeros: Rezeroed


def shape(arm: Arm) -> Shape:
    """The shape of an arm of turning joints.

    Parameters
    ----------
    arm : Arm

    Returns
    -------
    Shape

    Raises
    ------
    ValueError
        A sliding joint, whose axis has no place of its own.

    Examples
    --------
    >>> import dhlab as dh
    >>> found = shape(dh.load("ur5e").slide(2, 0.3))
    >>> found.a.round(4), found.d.round(4) + 0
    (array([ 0.    , -0.425 , -0.3922,  0.    ,  0.    ]), array([0.    , 0.1333, 0.    , 0.    ,
    0.0997, 0.    ]))
    """
    if "P" in arm.table.joints:
        raise ValueError("shape: expected turning joints only, found a sliding one")
    table = to_convention(arm, "standard").table
    a, alpha, d = table.a[:-1], table.alpha[:-1], np.array(table.d)
    parallel = abs(np.sin(alpha)) < PARALLEL
    for i in reversed(np.flatnonzero(parallel)):
        d[i], d[i + 1] = d[i] + np.cos(alpha[i]) * d[i + 1], 0.0
    bent = np.flatnonzero(~parallel)
    d[0] = d[bent[-1] + 1 if len(bent) else 0] = 0.0  # the base and the tool take them up
    return Shape(a, alpha, d)


def same_shape(a: Arm, b: Arm, *, length: float = 1e-6, angle: float = 1e-6) -> SameShape | None:
    """How arm b lies on arm a, up to base, tool, zeros, signs and what a table leaves free.

    Parameters
    ----------
    a, b : Arm
        Coupled joints are taken one by one.
    length, angle : float
        Metres and radians by which a number of the shape may differ.

    Returns
    -------
    SameShape or None
        None when they differ by more, in the number or kind of joints, or have a sliding joint.

    Examples
    --------
    >>> import dhlab as dh
    >>> print(same_shape(dh.load("piper.sdk_old"), dh.load("piper.sdk_new")).zeros)
    joint 2's zero moved by 2°, joint 3's zero moved by -2°, and base and tool free,
    >>> same_shape(dh.load("ur5e"), dh.load("ur5_cb")) is None
    True
    """
    if a.table.joints != b.table.joints or "P" in a.table.joints:
        return None
    A, B = shape(a), shape(b)
    ways = [way for start in (1, -1) for way in _ways(A, B, (start,), (1,), length, angle)]
    if not ways:
        return None
    found = []
    for z, x in ways:
        off, turned = _gap(A, B, z, x)
        found.append(SameShape(off, turned, _zeros(a, b, z, x)))
    return min(found, key=lambda same: (round(same.length, 9), _changes(same.zeros)))


def _ways(A, B, z, x, length, angle):
    """Every (senses of the z axes, senses of the x axes) that lays B's shape on A's; senses of b's
    frames as a's see them.
    """
    i = len(z) - 1
    if abs(A.d[i] - z[i] * B.d[i]) > length:
        return
    if i == len(A.a):
        yield z, (*x, 1)
        return
    for next_x, next_z in product((1, -1), (1, -1)):
        if abs(A.a[i] - next_x * B.a[i]) <= length and abs(_twist(A, B, i, z, next_x, next_z)) <= (
            angle
        ):
            yield from _ways(A, B, (*z, next_z), (*x, next_x), length, angle)


def _twist(A, B, i, z, next_x, next_z):
    turned = np.pi if z[i] != next_z else 0.0
    return _wrapped(A.alpha[i] - next_x * B.alpha[i] - turned)


def _gap(A, B, z, x):
    z, x = np.array(z), np.array(x[1:-1])
    twists = [_twist(A, B, i, z, x[i], z[i + 1]) for i in range(len(x))]
    lengths = np.r_[A.a - x * B.a, A.d - z * B.d]
    return float(abs(lengths).max()), float(np.abs(twists).max(initial=0.0))


def _zeros(a, b, z, x):
    """From θ_a = z (θ_b + 180° where the x axes turn round between): q of a for each q of b; what
    joints 1 and n leave goes into base and tool.
    """
    z, x = np.array(z), np.array(x)
    theta_a, theta_b = (to_convention(arm, "standard").table.theta for arm in (a, b))
    turned = np.where(x[:-1] != x[1:], np.pi, 0.0)
    offset = _wrapped(a.sign * (z * (theta_b + turned) - theta_a))
    offset[[0, -1]] = 0.0
    return Rezeroed(a.sign * z * b.sign, offset + 0.0, "free", "free", a.table.joints)


def _changes(zeros):
    return (zeros.sign < 0).sum() + (abs(zeros.offset) > 1e-8).sum()


def _wrapped(angle):
    return np.pi - (np.pi - angle) % (2 * np.pi)
