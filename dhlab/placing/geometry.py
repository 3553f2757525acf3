"""What bare joint axes leave open for one frame: the geometry behind :mod:`dhlab.placing`.

A frame stands on its own line (that of z_i) and has at most one other line to look at: that of
z_{i-1} (standard) or z_{i+1} (Craig), because a row leads from one to the other along their common
normal. How the two lines lie to each other decides what is right.
"""

from dataclasses import dataclass

import numpy as np

from ..geometry.lines import across, common_normal, parallel_normal, tilt, unit
from ..geometry.normals import ROUNDING, SAME_PLACE

__all__ = ["Geometry", "geometry", "LENGTH"]

LENGTH = 2e-3  # × the size of the arm: a point typed with three decimals is nearer than this


@dataclass(frozen=True, eq=False)
class Geometry:
    """What is open for frame ``i``; lines are (point, direction), metres in the base frame.

    Attributes
    ----------
    case : str
        "start" (the frame at the free end of the chain), "skew", "meet", "parallel",
        "antiparallel", "same line", "same line, opposite"; "loose" and "loose, parallel" where only
        the direction of z_i is settled and its line goes through o_i.
    line, other : pair of arrays (3,), or None
        The line of z_i, and the line that x_i must meet; None when it is not settled, or there is
        none.
    feet : array (2, 3) or None
        Where the common normal meets ``other`` and ``line``; of parallel lines the one through o_i,
        else through the neighbour's origin.
    origin : array (3,) or None
        The only right o_i; None: anywhere on ``line`` (or, loose, wherever one row reaches).
    x : array (3,) or None
        The direction of x_i, either way; None: any at right angles to z_i, or not known before o_i
        is.
    names : pair of str
        z_i and the other z, as they are written.
    reach : float
        The size of the arm, m.
    """

    i: int
    names: tuple
    reach: float
    case: str
    line: tuple = None
    other: tuple = None
    feet: np.ndarray = None
    origin: np.ndarray = None
    x: np.ndarray = None

    @property
    def near(self):
        """Metres; points nearer than this are taken as meant for each other."""
        return LENGTH * self.reach


def geometry(i, names, reach, z, line, other, anchor=None, o=None):
    """The case of frame i.

    Parameters
    ----------
    i, names, reach
        As in :class:`Geometry`.
    z : array (3,)
        The direction of z_i.
    line, other : pair of arrays (3,), or None
        The line of z_i, None when only its direction is settled; the other line, None when there is
        none.
    anchor : array (3,), optional
        Where the normal of parallel lines is shown while o_i is not placed.
    o : array (3,), optional
        o_i, when it is placed.

    Returns
    -------
    Geometry

    Examples
    --------
    >>> e = np.eye(3)
    >>> found = geometry(1, ("z1", "z0"), 1.0, e[1], (e[0], e[1]), (0 * e[0], e[2]))
    >>> found.case, found.origin, abs(found.x)
    ('skew', array([1., 0., 0.]), array([1., 0., 0.]))
    """
    common = {"i": i, "names": names, "reach": reach, "line": line, "other": other}
    if other is None:
        return Geometry(case="start", **common)
    if line is None:
        return _loose(*other, z, o, common)
    (q, _), (p, w) = line, other
    if tilt(w, z) > ROUNDING:
        N = common_normal(p, w, q, z)
        feet = np.array([p + N.out * w, q + N.into * z])
        return Geometry(
            case="meet" if abs(N.a) <= SAME_PLACE * reach else "skew",
            feet=feet,
            origin=feet[1],
            x=N.x,
            **common,
        )
    target = next(point for point in (o, anchor, p) if point is not None)
    N = parallel_normal(p, w, q, z, (target - p) @ w, SAME_PLACE * reach)
    if N.x is None:
        return Geometry(case="same line" if z @ w > 0 else "same line, opposite", **common)
    return Geometry(
        case="parallel" if z @ w > 0 else "antiparallel",
        feet=np.array([p + N.out * w, q + N.into * z]),
        x=N.x,
        **common,
    )


def _loose(p, w, z, o, common):
    """Only the direction of z_i is settled: o_i may stand wherever one row reaches."""
    if tilt(w, z) > ROUNDING:
        return Geometry(case="loose", x=unit(np.cross(w, z)), **common)
    gap = np.zeros(3) if o is None else across(o - p, w)
    apart = np.linalg.norm(gap) > LENGTH * common["reach"]
    return Geometry(case="loose, parallel", x=unit(gap) if apart else None, **common)
