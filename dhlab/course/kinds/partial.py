"""Answers that are filled in only in part: dots or "?" stand in some of their places."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .exercise import undecided, untouched

__all__ = ["PART_IS_RIGHT", "filled_up", "is_open"]

PART_IS_RIGHT = "the part that is filled in is right"


def is_open(entry: Any) -> bool:
    """Whether a place is still to be filled in."""
    return untouched(entry) or undecided(entry)


def filled_up(answer: Any, right: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """The numbers of an answer, the right ones in its open places; None where it has another shape,
    holds text, or nothing is filled in.

    Examples
    --------
    >>> filled_up([1, ..., "?"], np.array([7.0, 8.0, 9.0]))
    array([1., 8., 9.])
    """
    given = np.array(answer, dtype=object)
    if given.shape != right.shape:
        return None
    open_ = np.vectorize(is_open, otypes=[bool])(given)
    try:
        return None if open_.all() else np.where(open_, right, given).astype(float)
    except (TypeError, ValueError):
        return None
