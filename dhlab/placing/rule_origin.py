"""The rules for o_i: where the common normal, and with it one row of the table, arrives on z_i."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..geometry.lines import across, nearest_on
from .geometry import Geometry, Line
from .words import NO_POINT, Judgement, beside, vector

__all__ = ["judge_origin"]


def judge_origin(found: Geometry, point: ArrayLike) -> tuple[Judgement, NDArray[np.float64] | None]:
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
    p = vector(point)
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
        return Judgement(f"o{found.i}", True, *_right_origin(found, exact)), exact
    return Judgement(f"o{found.i}", False, *_origin_fault(found, p)), None


def _reached(found, p):
    """The nearest point that one row reaches: any where there is no other line; else in the plane
    through it across which x stands, or, parallel, any.
    """
    if found.other is None:
        return p
    q, w = found.other
    if found.case == "loose, parallel":
        return nearest_on(q, w, p) if _on_other(found, p) else p
    side = np.cross(w, found.x)
    return p - side * ((p - q) @ side)


def _on_other(found, p):
    q, w = found.other
    return np.linalg.norm(across(p - q, w)) <= found.near


def _right_origin(found, o):
    i, (z, w) = found.i, found.names
    if found.case == "loose" and _on_other(found, o):
        return (
            "one-row",
            f"{w} runs through this point, and so does {z}: they meet here, and a is 0.",
        )
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


def _origin_fault(found: Geometry, p: NDArray[np.float64]) -> tuple[str, str]:
    i, (z, w) = found.i, found.names
    if found.line is None:
        return (
            "not-one-row",
            (
                f"No single row leads here: x{i} must be at right angles to {w} and {z}, and its"
                f" line must meet {w}. Choose a line along {z}, and on it the point where it"
                f" meets {w} or comes nearest to it; what is left goes into the next row, or behind"
                " the last one into the tool."
            ),
        )
    if np.linalg.norm(p - nearest_on(*found.line, p)) > found.near:
        return _off_line(found, found.line, p)
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


def _off_line(found: Geometry, line: Line, p: NDArray[np.float64]) -> tuple[str, str]:
    """What is said of a point that is not on the line of z_i."""
    i, (z, w) = found.i, found.names
    if found.other is None or np.linalg.norm(p - nearest_on(*found.other, p)) > found.near:
        return (
            "origin-off-z",
            (
                f"This point is {beside(*line, p)} m beside {z}. o{i} lies on {z},"
                " wherever the housing of the joint may be."
            ),
        )
    feet = found.feet if found.case == "skew" else None  # of parallel lines, any point is one
    if feet is not None and np.linalg.norm(p - feet[0]) <= found.near:
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
