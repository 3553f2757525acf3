"""The table that the library writes for an arm read from a URDF: of the right ones the plainest,
its numbers without the dust of the computation, and what it is in words.
"""

from itertools import product

import numpy as np

from ..arm import Arm
from ..geometry.conversion import to_convention
from ..printing import number
from ..table import DHTable
from ..transform import from_xyz_rpy, to_xyz_rpy

__all__ = ["plainest", "without_dust", "topology", "zero_pose"]

DUST = 9, 9  # decimals of metres and of degrees that are kept
SAME = 1e-6  # m or rad; below it two axes meet, or are parallel


def plainest(arm: Arm) -> Arm:
    """The same arm with the x axes turned so that fewest zeros are offset, then fewest a negative.

    Parameters
    ----------
    arm : Arm

    Returns
    -------
    Arm

    Examples
    --------
    >>> import dhlab as dh
    >>> plainest(dh.load("irb120").flip_x(2).flip_x(3)) == plainest(dh.load("irb120"))
    True
    """
    found = []
    for flips in product((False, True), repeat=len(arm) - 1):
        one = arm
        for i in np.flatnonzero(flips) + 1:
            one = one.flip_x(int(i))
        found.append(without_dust(one))
    return min(found, key=_untidiness)


def _untidiness(arm):
    t = arm.table
    turned = abs(np.rad2deg(t.theta))
    return (
        (turned > 1e-6).sum(),
        (turned > 179).sum(),
        (t.a < 0).sum() + (t.alpha < -SAME).sum(),
        (t.theta < -SAME).sum(),
    )


def without_dust(arm: Arm) -> Arm:
    """The arm with lengths rounded to 1e-9 m and angles to 1e-9°, and angles from -180° to 180°.

    Examples
    --------
    >>> import dhlab as dh
    >>> dusty = dh.DHTable.standard([[0, 0.1 + 1e-14, 0.3, 270]], angle="deg")
    >>> print(without_dust(dh.Arm(dusty)).table)
    standard DH, 1 joint (lengths in m, angles in deg)
     i  theta  d    a    alpha
     1  q1     0.1  0.3  -90
    """
    t = arm.table
    table = DHTable(
        t.convention, _angles(t.theta), _lengths(t.d), _lengths(t.a), _angles(t.alpha), t.joints
    )
    base, tool = (_pose(T) for T in (arm.base, arm.tool))
    return Arm(table, base, tool, arm.limits, arm.sign, arm.name, arm.source, arm.coupling)


def _lengths(values):
    return np.round(values, DUST[0]) + 0.0


def _angles(values):
    degrees = np.round(np.rad2deg(values), DUST[1])
    return np.deg2rad(180 - (180 - degrees) % 360 + 0.0)


def _pose(T):
    xyz, rpy = to_xyz_rpy(T)
    return from_xyz_rpy(_lengths(xyz), _angles(rpy))


def topology(arm: Arm) -> str:
    """The joints and what is special about their axes, in words.

    Examples
    --------
    >>> import dhlab as dh
    >>> topology(dh.load("ur5e")), topology(dh.load("iiwa14"))
    ('6R, axes 2-3-4 parallel', '7R, spherical shoulder, spherical wrist')
    """
    t, n = to_convention(arm, "standard").table, len(arm)
    letters = t.joints if "P" in t.joints else f"{n}R"
    parallel = abs(np.sin(t.alpha[:-1])) < SAME
    meets = abs(t.a[:-1]) < SAME
    said, k = [letters], 0
    while k < n - 1:
        run = k
        while run < n - 1 and parallel[run]:
            run += 1
        if run > k:
            said.append(f"axes {'-'.join(str(i + 1) for i in range(k, run + 1))} parallel")
        k = max(run, k + 1)

    def spherical(i):
        """Whether the axes i, i + 1 and i + 2 (from 0) meet in a point, no two of them parallel."""
        bent = not parallel[i] and not parallel[i + 1]
        return bent and meets[i] and meets[i + 1] and abs(t.d[i + 1]) < SAME

    if "P" not in t.joints and n == 7 and spherical(0):
        said.append("spherical shoulder")
    if "P" not in t.joints and n >= 6 and spherical(n - 3):
        said.append("spherical wrist")
    return ", ".join(said)


def zero_pose(arm: Arm) -> str:
    """Where the end is at q = 0, and where its z axis points, in words.

    Examples
    --------
    >>> import dhlab as dh
    >>> zero_pose(dh.load("irb120"))
    'at q = 0 the end is at (374, 0, 630) mm and its z axis points along +x'
    """
    T = arm.forward(np.zeros(len(arm)))
    place = ", ".join(number(value * 1000, 3) for value in T[:3, 3])
    z = T[:3, 2]
    along = int(np.argmax(abs(z)))
    if abs(z[along]) > 1 - 1e-9:
        way = f"along {'+' if z[along] > 0 else '-'}{'xyz'[along]}"
    else:
        way = f"along ({', '.join(number(value, 3) for value in z)})"
    return f"at q = 0 the end is at ({place}) mm and its z axis points {way}"
