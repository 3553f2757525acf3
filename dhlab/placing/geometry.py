"""What bare joint axes leave open for one frame: the geometry behind :mod:`dhlab.placing`.

A frame stands on its own line (that of z_i) and has at most one other line to look at: that of
z_{i-1} (standard) or z_{i+1} (Craig), because a row leads from one to the other along their common
normal. How the two lines lie to each other decides what is right.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..geometry.lines import across, common_normal, parallel_normal, tilt, unit
from ..geometry.procedure.normals import ROUNDING, SAME_PLACE

__all__ = ["Geometry", "Line", "geometry", "LENGTH"]

Line = tuple[NDArray[np.float64], NDArray[np.float64]]  # a point (3,) and a unit vector (3,)

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
    names: tuple[str, str]
    reach: float
    case: str
    line: Line | None = None
    other: Line | None = None
    feet: NDArray[np.float64] | None = None
    origin: NDArray[np.float64] | None = None
    x: NDArray[np.float64] | None = None

    @property
    def near(self) -> float:
        """Metres; points nearer than this are taken as meant for each other."""
        return LENGTH * self.reach


def geometry(
    i: int,
    names: tuple[str, str],
    reach: float,
    z: NDArray[np.float64],
    line: Line | None,
    other: Line | None,
    anchor: NDArray[np.float64] | None = None,
    o: NDArray[np.float64] | None = None,
) -> Geometry:
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
    bare = Geometry(i, names, reach, "start", line, other)
    if other is None:
        return bare
    if line is None:
        return _loose(bare, *other, z, o)
    (q, _), (p, w) = line, other
    if tilt(w, z) > ROUNDING:
        N = common_normal(p, w, q, z)
        feet = np.array([p + N.out * w, q + N.into * z])
        case = "meet" if abs(N.a) <= SAME_PLACE * reach else "skew"
        return replace(bare, case=case, feet=feet, origin=feet[1], x=N.x)
    target = next(point for point in (o, anchor, p) if point is not None)
    N = parallel_normal(p, w, q, z, float((target - p) @ w), SAME_PLACE * reach)
    if N.x is None:
        return replace(bare, case="same line" if z @ w > 0 else "same line, opposite")
    feet = np.array([p + N.out * w, q + N.into * z])
    return replace(bare, case="parallel" if z @ w > 0 else "antiparallel", feet=feet, x=N.x)


def _loose(bare, p, w, z, o):
    """Only the direction of z_i is settled: o_i may stand wherever one row reaches."""
    if tilt(w, z) > ROUNDING:
        return replace(bare, case="loose", x=unit(np.cross(w, z)))
    gap = np.zeros(3) if o is None else across(o - p, w)
    apart = np.linalg.norm(gap) > LENGTH * bare.reach
    return replace(bare, case="loose, parallel", x=unit(gap) if apart else None)
