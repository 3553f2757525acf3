"""What a table and an arm are given, checked: numbers of the right shape, or one sentence that says
what was expected, what was found and what to do.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "COLUMNS",
    "checked_rows",
    "require_finite",
    "checked_joints",
    "checked_signs",
    "checked_coupling",
    "checked_limits",
    "checked_ranges",
]

COLUMNS = ("theta", "d", "a", "alpha")


def checked_rows(rows: Any, where: str) -> NDArray[np.float64]:
    """(n, 4) floats from whatever was given, or a sentence that names the row and the column."""
    if isinstance(rows, (str, bytes, dict)) or not np.iterable(rows):
        raise ValueError(
            f"{where}: expected rows of four numbers (theta, d, a, alpha), found"
            f" {'one number' if _is_number(rows) else type(rows).__name__}; give a list of rows"
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
                f"{where}: row {i} is {_shown(row)}, expected 4 numbers (theta, d, a, alpha); put"
                " each row in brackets of its own"
            )
        row = list(row)
        if len(row) != 4:
            todo = (
                "fill in what is missing"
                if len(row) < 4
                else "take out what is too much (is there an index column, or a decimal comma?)"
            )
            raise ValueError(
                f"{where}: row {i} has {_count(row)}, expected 4 (theta, d, a, alpha); {todo}"
            )
        for k, name in enumerate(COLUMNS):
            numbers[i - 1, k] = _as_number(row[k], f"{where}: row {i}, {name}")
    return numbers


def _count(row):
    return "1 number" if len(row) == 1 else f"{len(row)} numbers"


def _is_number(value):
    array = np.asarray(value)
    return array.shape == () and array.dtype.kind in "iuf"


def _as_number(value: object, where: str) -> float:
    if not _is_number(value):
        todo = (
            "with a decimal point and no quotation marks"
            if isinstance(value, str) and value.count(",") == 1
            else "as a plain number"
        )
        raise ValueError(f"{where}: expected a number, found {_shown(value)}; write it {todo}")
    return float(np.asarray(value))


def _shown(value):
    """What was found, as a person would type it."""
    return repr(value.tolist() if isinstance(value, (np.generic, np.ndarray)) else value)


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


def checked_signs(sign: ArrayLike | None, n: int) -> NDArray[np.float64]:
    """+1 or -1 for each of n joints, read-only."""
    try:
        signs = np.ones(n) if sign is None else np.array(sign, dtype=float)
    except (TypeError, ValueError):
        signs = np.array(np.nan)
    if signs.shape != (n,) or not np.isin(signs, (1, -1)).all():
        raise ValueError(
            f"Arm: sign: expected {n} entries, each 1 or -1, found {sign!r}; write -1 where a joint"
            " counts the other way"
        )
    signs.flags.writeable = False
    return signs


def checked_coupling(coupling: ArrayLike | None, n: int) -> NDArray[np.float64] | None:
    """A read-only matrix, or None where every joint is its own."""
    if coupling is None:
        return None
    try:
        matrix = np.array(coupling, dtype=float)
    except (TypeError, ValueError):
        matrix = np.array(np.nan)
    if matrix.shape != (n, n) or not np.isfinite(matrix).all():
        found = "NaN or infinity" if matrix.shape == (n, n) else repr(coupling)[:60]
        raise ValueError(
            f"Arm: coupling: expected a matrix of {n} rows with {n} finite numbers each, found"
            f" {found}; row i says what joint i makes of each number of q"
        )
    if np.linalg.matrix_rank(matrix) < n:
        raise ValueError(
            "Arm: coupling: expected a matrix that can be inverted, found one in which some joints"
            " cannot be moved apart; look for two equal rows or a row of zeros"
        )
    if np.array_equal(matrix, np.eye(n)):
        return None
    matrix.flags.writeable = False
    return matrix


def checked_limits(limits: Any, n: int) -> tuple[tuple[float, float] | None, ...] | None:
    """(low, high) or None for each of n joints; None where there are none at all."""
    if limits is None:
        return None
    many = np.iterable(limits) and not isinstance(limits, (str, bytes, dict))
    pairs = list(limits) if many else [limits] * (n + 1)
    if len(pairs) != n:
        raise ValueError(
            f"Arm: limits: expected {n} entries, one (low, high) or None per joint, found"
            f" {len(pairs)}"
        )
    return tuple(None if pair is None else _pair(pair, i) for i, pair in enumerate(pairs, 1))


def _pair(pair, i):
    try:
        low, high = (float(value) for value in pair)
    except (TypeError, ValueError):
        low = high = np.nan
    if not (np.isfinite([low, high]).all() and low <= high):
        raise ValueError(
            f"Arm: limits: joint {i}: expected (low, high), two finite numbers with low <= high,"
            f" found {pair!r}; None for a joint without limits"
        )
    return low, high


def checked_ranges(
    limits: Sequence[tuple[float, float] | None] | None, joints: str, count: int, where: str
) -> NDArray[np.float64]:
    """Lowest and highest value of every joint (2, n), a whole turn where none are stated; a
    sentence where a joint slides without limits, or ``count`` is no number of samples.
    """
    if isinstance(count, bool) or not isinstance(count, (int, np.integer)) or count < 1:
        raise ValueError(
            f"{where}: n: expected how many samples, a whole number from 1, found {count!r}"
        )
    pairs = list(limits or [None] * len(joints))
    for i, (pair, letter) in enumerate(zip(pairs, joints), 1):
        if pair is None and letter == "P":
            raise ValueError(
                f"{where}: joint {i} slides and states no limits, so how far it goes is not known;"
                " give the arm limits"
            )
        pairs[i - 1] = pair or (-np.pi, np.pi)
    return np.array(pairs, dtype=float).T
