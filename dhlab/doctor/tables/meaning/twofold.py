"""Two columns of one parameter, in degrees and in radians, or in millimetres and in metres."""

import math

from ..language.values import TO_METRES

__all__ = ["say_one_thing"]

FACTORS = {"": 1.0, "rad": 1.0, "deg": math.pi / 180, **TO_METRES}
NEAR = 6e-3  # of the size: 1.57 is a quarter turn


def say_one_thing(columns, units):
    """Whether columns of Cells are the same numbers in units of their own; two in one unit are not.

    Parameters
    ----------
    columns : list of list of Cell or None
    units : list of str
        Of the headings.
    """
    if len(set(units)) < len(units) or len({len(column) for column in columns}) > 1:
        return False
    return all(
        one is not None and other is not None and _same(one, other, unit, units[0])
        for column, unit in zip(columns[1:], units[1:])
        for one, other in zip(column, columns[0])
    )


def _same(one, other, unit, first):
    a, b = (
        cell.value * FACTORS.get(cell.unit or own, 1.0)
        for cell, own in ((one, unit), (other, first))
    )
    names = [[name for name, _ in cell.letters] for cell in (one, other)]
    return names[0] == names[1] and math.isclose(a, b, rel_tol=NEAR, abs_tol=1e-9)
