"""Numbers as a learner hands them in: lists, arrays of any precision, tables of pandas, numbers of
SymPy; and a plain sentence for what holds no numbers.
"""

import re
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Unreadable", "as_numbers", "is_array_of", "plain", "split_at_commas", "unusable"]

DECIMAL_COMMA = re.compile(r"\s*[-+]?\d+,\d+\s*")
NO_IMAGINARY = 1e-9  # what an imaginary part may be to be the dust of rounding


class Unreadable(ValueError):
    """What was found in the place of numbers, in words."""


def plain(answer: Any) -> NDArray[Any]:
    """An answer as an array of integers or decimals.

    Raises
    ------
    Unreadable
        It holds anything else.

    Examples
    --------
    >>> plain([1, 2.5])
    array([1. , 2.5])
    >>> plain(np.ma.masked_array([1.0, 2.0], mask=[False, True]))
    Traceback (most recent call last):
    ...
    dhlab.course.kinds.reading.Unreadable: a masked array in which 1 of 2 numbers is hidden
    """
    found = unusable(answer)
    if found:
        raise Unreadable(found)
    array = _array(answer)
    if array.dtype.kind == "c":
        return array.real
    if array.dtype.kind in "iufb":
        return array if array.dtype.kind != "b" else array.astype(float)
    if array.dtype.kind == "U" and array.ndim:
        commas = any(DECIMAL_COMMA.fullmatch(text) for text in array.flat)
        raise Unreadable(f"text {'with decimal commas' if commas else 'where a number belongs'}")
    if array.dtype.kind != "O":
        raise Unreadable(type(answer).__name__)
    try:
        return array.astype(float)
    except (TypeError, ValueError):
        raise Unreadable(type(answer).__name__) from None


def unusable(answer: Any) -> str:
    """What keeps an answer from being read as real numbers though it looks like numbers, in words;
    "" where nothing does.

    Examples
    --------
    >>> unusable([1, 2j])
    'complex numbers, with an imaginary part that is not 0'
    """
    if hasattr(answer, "mask") and np.ma.is_masked(answer):  # np.ma loads when it is asked for
        hidden = int(np.ma.getmaskarray(answer).sum())
        are = "is" if hidden == 1 else "are"
        return f"a masked array in which {hidden} of {answer.size} numbers {are} hidden"
    try:
        array = _array(answer)
    except Unreadable:
        return ""
    if array.dtype.kind == "c" and np.abs(array.imag).max(initial=0) > NO_IMAGINARY:
        return "complex numbers, with an imaginary part that is not 0"
    if array.dtype.kind == "O" and any(getattr(x, "free_symbols", ()) for x in array.flat):
        return "a formula in which letters are left; put the numbers in"
    return ""


def _array(answer):
    if hasattr(answer, "to_numpy"):  # pandas
        answer = answer.to_numpy()
    try:
        return np.asarray(answer)
    except ValueError:
        raise Unreadable("rows of different lengths") from None


def split_at_commas(array: NDArray[Any], amount: int) -> bool:
    """Whether an answer may be so many numbers with decimal commas: Python reads ``0,5`` as two
    whole numbers.

    Examples
    --------
    >>> split_at_commas(np.array([0, 5, 1, 25, 3]), 3), split_at_commas(np.array([0.5, 1.25]), 1)
    (True, False)
    """
    return amount < array.size <= 2 * amount and bool(np.all(array == np.round(array)))


def as_numbers(answer: Any) -> NDArray[np.float64]:
    """The answer as an array of decimals, whatever its shape; of no numbers, an empty one.

    Examples
    --------
    >>> as_numbers([1, 2]), as_numbers("two")
    (array([1., 2.]), array([], dtype=float64))
    """
    try:
        return plain(answer).astype(float)
    except Unreadable:
        return np.empty(0)


def is_array_of(answer: NDArray[np.float64], value: ArrayLike) -> bool:
    """Whether an array, already of decimals, has the shape and the numbers of a value."""
    return answer.shape == np.shape(value) and np.allclose(answer, value, rtol=1e-3, atol=1e-3)
