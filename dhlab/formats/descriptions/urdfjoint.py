"""The numbers of one URDF joint, read strictly, with the defaults that URDF gives them."""

from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np
from numpy.typing import NDArray

from ...transform import from_xyz_rpy
from ..plainyaml import FLOAT
from .urdfxml import EXPAND, XACRO

__all__ = ["Joint", "read_joint", "unrounded"]

MOVABLE = ("revolute", "continuous", "prismatic")
LIMITED = ("revolute", "prismatic")


@dataclass(frozen=True, eq=False)
class Joint:
    """A joint of the chain.

    ``origin`` (4, 4) is its frame in the frame of the joint before, ``axis`` (3,) its direction in
    its own frame, as the file has it. ``limits`` is (lower, upper) in radians or metres, either of
    them None when the file does not state it; None when it states neither or the joint has none.
    """

    name: str
    kind: str
    origin: NDArray[np.float64]
    axis: NDArray[np.float64]
    limits: tuple[float | None, float | None] | None


def read_joint(element: Element, path: str | Path, *, unround: bool = False) -> Joint:
    """The :class:`Joint` in a ``<joint>``.

    Parameters
    ----------
    element : xml.etree.ElementTree.Element
        With a name.
    path : str or path
        Of the file, for errors.
    unround : bool
        Take the angles of rpy for what they are rounded from; see :func:`unrounded`.

    Raises
    ------
    ValueError
        A kind that a DH row cannot hold, a joint that mimics another, no direction, or numbers that
        a lenient parser would take for others.
    """
    where = f"{path}: joint {element.get('name')}"
    kind = _kind(element, where)
    xyz = _floats(element, "origin", "xyz", 3, where) or [0, 0, 0]
    rpy = _floats(element, "origin", "rpy", 3, where) or [0, 0, 0]
    if unround:
        rpy = [unrounded(angle) for angle in rpy]
    axis = _floats(element, "axis", "xyz", 3, where) or [1, 0, 0]
    if kind != "fixed" and axis == [0, 0, 0]:
        raise ValueError(
            f"{where}: axis: expected a direction, found 0 0 0; write the axis, such as 0 0 1"
        )
    limits = _limits(element, where) if kind in LIMITED else None
    return Joint(
        element.get("name", ""), kind, from_xyz_rpy(xyz, rpy), np.array(axis, float), limits
    )


def unrounded(angle: float) -> float:
    """The multiple of 90° (or, from four decimals on, of 15°) that was rounded or cut off to this
    number, or is within 1e-8 of it; the number itself where there is none.

    Parameters
    ----------
    angle : float
        Radians, as a file has it.

    Returns
    -------
    float

    Examples
    --------
    >>> unrounded(1.57) == unrounded(1.5707) == unrounded(1.570796327) == np.pi / 2
    True
    >>> unrounded(0.5236) == np.pi / 6, unrounded(0.52), unrounded(1.6)
    (True, 0.52, 1.6)
    """
    decimals = len(np.format_float_positional(angle, trim="-").partition(".")[2])
    for step, least in ((np.pi / 2, 2), (np.pi / 12, 4)):
        exact = round(angle / step) * step
        off, unit = abs(angle) - abs(exact), 10.0**-decimals
        rounded = decimals >= least and -unit <= off <= unit / 2
        if rounded or abs(off) < 1e-8:
            return float(exact)
    return angle


def _kind(element, where):
    kind = element.get("type")
    if kind not in (*MOVABLE, "fixed"):
        hint = {
            "floating": "; it has six freedoms, a DH row has one",
            "planar": "; it has three freedoms, a DH row has one",
        }.get(kind, "")
        raise ValueError(
            f"{where}: expected revolute, continuous, prismatic or fixed, found"
            f" {kind or 'no type'}{hint}; choose a base behind it"
        )
    if kind != "fixed" and element.find("mimic") is not None:
        raise ValueError(
            f"{where}: expected a joint of its own, found one that mimics"
            f" {element.find('mimic').get('joint')}; a DH table gives every joint its own variable:"
            " choose a tip before it"
        )
    return kind


def _limits(element, where):
    lower, upper = (_floats(element, "limit", key, 1, where) for key in ("lower", "upper"))
    return (lower and lower[0], upper and upper[0]) if lower or upper else None


def _floats(element, tag, key, n, where):
    """The ``n`` numbers of an attribute, or None when the file does not have it."""
    child = element.find(tag)
    text = None if child is None else child.get(key)
    if text is None:
        return None
    where = f"{where}: {tag} {key}"
    if XACRO.search(text):
        raise ValueError(f"{where}: expected numbers, found the xacro expression {text}; {EXPAND}")
    words = text.split()
    if len(words) != n or not all(FLOAT.match(word) and np.isfinite(float(word)) for word in words):
        raise ValueError(
            f"{where}: expected {'a finite number' if n == 1 else f'{n} finite numbers'}, found"
            f" {text[:60]!r}; write numbers with spaces between them and decimal points"
        )
    return [float(word) for word in words]
