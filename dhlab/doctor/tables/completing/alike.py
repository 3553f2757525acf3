"""Whether two tables of one text are one arm: the same numbers in any order, unit and scale."""

from collections import Counter
from dataclasses import replace

import numpy as np

from ..meaning.columns import MOST_TURNS, orders

__all__ = ["holds", "repeats", "same_arm", "stands_for"]


def same_arm(one, other):
    """Whether two tables of a text hold the same numbers, in whatever order, unit and scale: the
    lengths, and the twists where both say which column these are.
    """
    both = one.roles is not None and other.roles is not None
    return all(kinds[0] == kinds[1] for kinds in zip(_numbers(one, both), _numbers(other, both)))


def holds(table, other):
    """Whether all numbers of another table are in a table, in whatever order, unit and scale."""
    both = table.roles is not None and other.roles is not None
    pairs = zip(_numbers(table, both), _numbers(other, both))
    return all(not theirs - own for own, theirs in pairs)


def repeats(longer, found):
    """Whether rows are others once more."""
    rows, once = ([[c.value for c in row] for row in table.rows] for table in (longer, found))
    return rows == once * (len(rows) // len(once))


def stands_for(letters, numbers):
    """Whether one table is another with letters for some of its lengths, row by row."""
    if None in (letters.roles, numbers.roles) or len(letters.rows) != len(numbers.rows):
        return False
    own, theirs = (
        [_with_zero(dict(zip(table.roles, row))) for row in table.rows]
        for table in (letters, numbers)
    )
    named = any(row[role].letters for row in own for role in ("d", "a") if role in row)
    return named and all(
        set(one) == set(other) and all(_agree(one[role], other[role], role) for role in one)
        for one, other in zip(own, theirs)
    )


def _with_zero(row):
    """The Cells of a row, with the zero of a column of its own added to theta."""
    zero, theta = row.pop("offset", None), row.get("theta")
    if zero is None or not zero.value or theta is None:
        return row
    return {**row, "theta": replace(theta, value=theta.value + zero.value)}


def _agree(letter, number, role):
    """Whether a cell of a table in letters says nothing else than the one with numbers."""
    if role in ("d", "a", "r"):
        return (bool(letter.letters) and number.is_constant) or letter.value == number.value
    turned = [
        np.deg2rad(c.value) if abs(c.value) > MOST_TURNS else c.value for c in (letter, number)
    ]
    variable = role == "theta" and not (letter.letters and number.letters)  # or left out
    same = variable or letter.letters == number.letters
    return same and abs(turned[0] - turned[1]) < 1e-3


def _numbers(table, with_twists):
    """The lengths of a table, by the longest of them, and its twists in radians, or nothing."""
    roles = table.roles or next((found.roles for found in orders(table, None)), ())
    cells = [(cell, role) for row in table.rows for cell, role in zip(row, roles) if cell.value]
    lengths = [abs(cell.value) for cell, role in cells if role in ("d", "a", "r")]
    longest = max(lengths, default=1.0)
    twists = [abs(cell.value) for cell, role in cells if role == "alpha" and with_twists]
    return (
        Counter(round(length / longest, 4) for length in lengths),
        Counter(round(np.deg2rad(v) if v > MOST_TURNS else v, 3) for v in twists),
    )
