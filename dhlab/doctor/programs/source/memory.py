"""A function that looks up what it gave to the same numbers before."""

import copy
from functools import wraps

import numpy as np

__all__ = ["remembering"]


def remembering(f, memory):
    """A function with its answers kept, by name and arguments; copies, so that nobody changes them.

    Parameters
    ----------
    f : callable
        Of numbers and arrays; with other arguments it is called.
    memory : dict

    Examples
    --------
    >>> memory, asked = {}, []
    >>> g = remembering(lambda x: asked.append(x) or 2 * x, memory)
    >>> g(3), g(3), asked
    (6, 6, [3])
    """

    @wraps(f)
    def looked_up(*given, **named):
        if named or not all(isinstance(x, (int, float, np.ndarray)) for x in given):
            return f(*given, **named)
        key = f.__name__, *(x.tobytes() if isinstance(x, np.ndarray) else x for x in given)
        if key not in memory:
            memory[key] = f(*given)
        return copy.copy(memory[key])

    return looked_up
