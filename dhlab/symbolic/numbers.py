"""Floats as the exact numbers they stand for, in SymPy: 0.35 is 7/20, 1.5707963267948966 is π/2;
and the elementary moves made of them.
"""

from functools import cache
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from .. import units
from ..transform import to_xyz_rpy

Expression = Any  # SymPy is an optional dependency, so its types are not named
Matrix = Any

__all__ = ["Expression", "Matrix", "the_sympy", "exact", "exact_pose", "elementary"]

# a stored number with more digits came out of a computation: it is rounded before it is made exact
DIGITS = 12


@cache
def the_sympy() -> ModuleType:
    """The module, or a sentence that says how to get it."""
    try:
        import sympy
    except ImportError:
        raise ValueError(
            "dhlab.symbolic: expected SymPy, found it is not installed; run pip install"
            " dhlab-kinematics[symbolic]"
        ) from None
    return sympy


def exact(value: Expression, kind: str = "length") -> Expression:
    """The exact number that a float stands for: a decimal as a fraction, an angle that is a decimal
    number of degrees as a part of π.

    Parameters
    ----------
    value : number or SymPy expression
        Radians or metres; an expression is handed back as it is.
    kind : "angle" or "length"

    Returns
    -------
    sympy expression

    Examples
    --------
    >>> exact(np.pi / 2, "angle"), exact(0.35), exact(1.5708, "angle")
    (pi/2, 7/20, 3927/2500)
    """
    sympy = the_sympy()
    if isinstance(value, sympy.Basic):
        return value
    if (
        isinstance(value, bool)
        or np.ndim(value)
        or np.asarray(value).dtype.kind not in "iuf"
        or not np.isfinite(value)
    ):
        raise ValueError(f"exact: expected a finite number or a SymPy expression, found {value!r}")
    plain = sympy.Rational(_digits(value))
    if kind != "angle":
        return plain
    degrees = sympy.Rational(_digits(float(value) / units.ANGLE["deg"]))
    off = abs(float(degrees) * units.ANGLE["deg"] - value)
    as_turn = off < 1e-15 * max(1.0, abs(value)) and len(str(degrees)) <= len(str(plain))
    return degrees * sympy.pi / 180 if as_turn else plain


def _digits(value):
    rounded = round(float(value), DIGITS) + 0.0
    return repr(rounded if abs(rounded - value) < 1e-15 * max(1.0, abs(value)) else float(value))


def exact_pose(T: ArrayLike) -> Matrix:
    """A pose (4, 4) with exact roll, pitch, yaw and shift, as a SymPy matrix."""
    (x, y, z), rpy = to_xyz_rpy(T)
    roll, pitch, yaw = (exact(angle, "angle") for angle in rpy)
    pose = (
        elementary("Rot", "z", yaw) * elementary("Rot", "y", pitch) * elementary("Rot", "x", roll)
    )
    pose[:3, 3] = the_sympy().Matrix([exact(x), exact(y), exact(z)])
    return pose


def elementary(kind: str, axis: str, value: Expression) -> Matrix:
    """``Rot`` about or ``Trans`` along ``x``, ``y`` or ``z`` by an expression, as a SymPy matrix
    (4, 4).
    """
    sympy = the_sympy()
    matrix, k = sympy.eye(4), "xyz".index(axis)
    if kind == "Trans":
        matrix[k, 3] = value
        return matrix
    i, j = (k + 1) % 3, (k + 2) % 3
    c, s = sympy.cos(value), sympy.sin(value)
    matrix[i, i], matrix[i, j], matrix[j, i], matrix[j, j] = c, -s, s, c
    return matrix
