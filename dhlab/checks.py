"""What a table and an arm are given, checked: numbers of the right shape, or one sentence that says
what was expected, what was found and what to do.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["COLUMNS", "checked_rows", "require_finite", "checked_joints"]

COLUMNS = ("theta", "d", "a", "alpha")


def checked_rows(rows: Any, where: str) -> NDArray[np.float64]:
    """(n, 4) floats from whatever was given, or a sentence that names the row and the column."""
    if isinstance(rows, (str, bytes, dict)) or not np.iterable(rows):
        raise ValueError(
            f"{where}: expected rows of four numbers (theta, d, a, alpha), found"
            f" {type(rows).__name__}; give a list of rows"
        )
    rows = list(rows)
    if not rows:
        raise ValueError(
            f"{where}: expected at least one row (theta, d, a, alpha), found an empty table; give"
            " one row per joint"
        )
    numbers = np.empty((len(rows), 4))
    for i, row in enumerate(rows, 1):
        if isinstance(row, (str, bytes, dict)) or not np.iterable(row):
            raise ValueError(
                f"{where}: row {i} is {row!r}, expected 4 numbers (theta, d, a, alpha); put each"
                " row in brackets of its own"
            )
        row = list(row)
        if len(row) != 4:
            todo = (
                "fill in what is missing"
                if len(row) < 4
                else "take out what is too much (is there an index column?)"
            )
            raise ValueError(
                f"{where}: row {i} has {len(row)} numbers, expected 4 (theta, d, a, alpha); {todo}"
            )
        for k, name in enumerate(COLUMNS):
            numbers[i - 1, k] = _as_number(row[k], f"{where}: row {i}, {name}")
    return numbers


def _as_number(value: object, where: str) -> float:
    array = np.asarray(value)
    if array.shape != () or array.dtype.kind not in "iuf":
        raise ValueError(f"{where}: expected a number, found {value!r}; write it as a plain number")
    return float(array)


def require_finite(numbers: NDArray[np.float64], where: str) -> None:
    """A sentence that names the row and the column of the first number that is not finite."""
    bad = np.argwhere(~np.isfinite(numbers))
    if len(bad):
        i, k = bad[0]
        raise ValueError(
            f"{where}: row {i + 1}, {COLUMNS[k]}: expected a finite number, found {numbers[i, k]};"
            " look at where it was computed"
        )


def checked_joints(joints: str | Sequence[str] | None, n: int, where: str) -> str:
    """ "RRP" from a string or a list of letters; all "R" from None."""
    if joints is None:
        joints = "R" * n
    letters = list(joints) if np.iterable(joints) else [joints]
    for i, letter in enumerate(letters, 1):
        if not isinstance(letter, str) or letter not in ("R", "P"):
            raise ValueError(
                f'{where}: joint {i} is {letter!r}, expected "R" (revolute) or "P" (prismatic)'
            )
    if len(letters) != n or n == 0:
        raise ValueError(
            f'{where}: found {len(letters)} joint letters for {n} rows; expected one "R" or "P" per'
            " row and at least one row"
        )
    return "".join(letters)
