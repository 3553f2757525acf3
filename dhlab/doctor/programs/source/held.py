"""What the names of a program hold, seen while it runs once."""

import numpy as np

from ..running.watched import watched
from .text import CODE

__all__ = ["kinds_of"]


def kinds_of(f, *given):
    """By name, the kinds of what was held when functions of the text ended: a number, numbers in
    one, two or more dimensions, a function, another type.

    Parameters
    ----------
    f : callable
        Made by a Text.
    *given
        Its arguments.

    Returns
    -------
    dict of sets
    """
    found = {}

    def look(frame, _):
        if frame.f_code.co_filename == CODE:
            for name, value in frame.f_locals.items():
                found.setdefault(name, set()).add(_kind(value))

    with watched(look):
        f(*given)
    return found


def _kind(value):
    if callable(value):
        return "function"
    if isinstance(value, (list, tuple, np.ndarray, int, float, np.number)):
        try:
            numbers = np.asarray(value)
        except ValueError:  # rows of other lengths
            return type(value)
        return numbers.ndim if numbers.dtype.kind in "iuf" else type(value)
    return type(value)
