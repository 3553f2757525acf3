"""A table as a learner hands it in: rows, a DHTable or an Arm; and how it may lie."""

from dataclasses import replace
from typing import Any

import numpy as np

from ....arm import Arm
from ....table import DHTable
from ..reading import Unreadable, plain, unusable
from .entries import COLUMNS

__all__ = ["as_arm", "entries", "lies_on_its_side", "turned_round", "numbers"]


def as_arm(answer: Any, right: Arm) -> Arm:
    """The answer as an Arm with the right one's base, tool and signs; rows are degrees and metres.

    Raises
    ------
    ValueError
        It is no table.
    """
    if isinstance(answer, Arm):
        return answer
    if not isinstance(answer, DHTable):
        answer = _rows_of(answer)
        make = DHTable.standard if right.table.convention == "standard" else DHTable.craig
        fits = np.iterable(answer) and len(list(answer)) == len(right)
        answer = make(answer, angle="deg", joints=right.table.joints if fits else None)
    if len(answer) != len(right):
        return Arm(answer)
    return Arm(answer, base=right.base, tool=right.tool, sign=right.sign)


def _rows_of(answer):
    """The rows of an answer as numpy holds them; what is no table is left to DHTable to refuse."""
    found = unusable(answer)
    if found:
        raise ValueError(f"expected a table of numbers, found {found}")
    try:
        return plain(answer)
    except Unreadable:
        return answer


def lies_on_its_side(answer: Any, joints: int) -> bool:
    """Whether an answer has a column for each joint where it must have a row."""
    try:
        shape = plain(answer).shape
    except Unreadable:
        return False
    return shape == (4, joints) != (joints, 4)


def turned_round(arm: Arm) -> Arm:
    """The arm of a table of four joints whose rows and columns have changed places."""
    in_degrees = arm.table.rows * [180 / np.pi, 1, 1, 180 / np.pi]
    make = DHTable.standard if arm.table.convention == "standard" else DHTable.craig
    return replace(arm, table=make(in_degrees.T, angle="deg", joints=arm.table.joints))


def entries(row: Any) -> list[Any]:
    """The four entries of a row; of one in whose place a single thing stands, dots or a number,
    four times that.
    """
    return list(row) if np.iterable(row) and not isinstance(row, str) else [row] * len(COLUMNS)


def numbers(table: DHTable) -> list[list[float]]:
    """The rows of a table, degrees and metres, without the dust of rounding.

    Examples
    --------
    >>> numbers(DHTable.standard([[0, 100, 0, 90]], angle="deg", length="mm"))
    [[0.0, 0.1, 0.0, 90.0]]
    """
    return (table.rows * [180 / np.pi, 1, 1, 180 / np.pi]).round(9).tolist()
