"""Degrees and millimetres, for the places where a human writes or reads; everything inside is
radians and metres.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, TypeVar

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from .table import DHTable

Number = TypeVar("Number", float, NDArray[np.float64])

__all__ = ["ANGLE", "LENGTH", "scale_of", "convert", "shortest", "written", "written_rows"]

ANGLE = {"rad": 1.0, "deg": np.pi / 180}
LENGTH = {"m": 1.0, "mm": 1e-3}


def scale_of(unit: str | None, kind: str, where: str) -> float:
    """How many radians (or metres) one ``unit`` is.

    Parameters
    ----------
    unit : str
        ``"deg"`` or ``"rad"`` for an angle, ``"m"`` or ``"mm"`` for a length.
    kind : "angle" or "length"
    where : str
        Names the place in the error, such as ``"DHTable.standard"``.

    Raises
    ------
    ValueError
        The unit is missing or unknown.

    Examples
    --------
    >>> scale_of("mm", "length", "my table")
    0.001
    """
    known = ANGLE if kind == "angle" else LENGTH
    if not isinstance(unit, str) or unit not in known:
        found = "no unit" if unit is None else repr(unit)
        choices = " or ".join(f'"{name}"' for name in known)
        raise ValueError(
            f"{where}: expected the unit of the {kind}s, {choices}, found {found}; name it, as in"
            f' {kind}="{min(known)}"'
        )
    return known[unit]


def convert(value: Number, scale: float) -> Number:
    """``value · scale``; lengths in mm are divided, since 162.5 / 1000 is the float 0.1625 and
    162.5 · 0.001 need not be.
    """
    return value / 1000 if scale == 1e-3 else value * scale


def shortest(value: float, scale: float) -> str | None:
    """The shortest decimal in the human unit that reads back as exactly ``value``; ``None`` when
    there is none.

    Examples
    --------
    >>> shortest(np.pi / 2, ANGLE["deg"]), shortest(0.1625, LENGTH["mm"])
    ('90', '162.5')
    """
    human = float(value) / scale
    for digits in range(1, 18):
        text = f"{human:.{digits}g}"
        if convert(float(text), scale) == value:
            return _plain(text)
    return None


def _plain(text):
    """``9e+01`` as ``90``: a table is read by people; very small and very large numbers keep their
    exponent.
    """
    value = float(text)
    if value == 0:
        return "0"
    if 1e-5 <= abs(value) < 1e7:
        return np.format_float_positional(value, trim="-")
    return text


def written(value: float, unit: str) -> str:
    """A number in a file's unit that reads back as ``value``, or as the nearest there is (within
    1e-15 of it).

    Examples
    --------
    >>> written(np.pi, "deg")
    '180'
    """
    scale = {**ANGLE, **LENGTH}[unit]
    return shortest(value, scale) or repr(float(value) / scale)


def written_rows(table: DHTable, angle: str, length: str) -> Iterator[list[str]]:
    """The four texts of every row of a table, in a file's units."""
    for row in table.rows:
        yield [written(value, unit) for value, unit in zip(row, (angle, length, length, angle))]
