"""Python's errors in a learner's words: what most likely stands in the line where a program for
poses stops.
"""

import builtins
import re
import traceback

__all__ = ["in_words"]

COMMA = "a comma, or a * between two factors, is missing there: (…) (…) and […] […] are no lists."
FOUR = "A row holds four numbers in this order: θ offset, d, a, α."
WRITTEN_OVER = (
    "{0}(…) is a function of Python's, and {0} is a number or a list in this program: give that"
    " another name; in a notebook, restart the kernel then."
)
OF_VECTORS = "np.dot and @ of two vectors give one number, np.cross gives three."
# (kind of error, what its message holds, what to do): the first that fits is told
_WORDS = (
    ("TypeError", r"list indices must be integers or slices, not tuple", f"Perhaps {COMMA}"),
    (
        "TypeError",
        r"'(list|tuple|int|float|numpy\.\w+)' object is not callable",
        f"Perhaps {COMMA} Or a variable has the name of the function that is called.",
    ),
    (
        "IndexError",
        r"only integers, slices",
        f"{FOUR} Take a number out by its place, row[0] to row[3], not by a name or a decimal.",
    ),
    (
        "IndexError|KeyError",
        r"out of (bounds|range)|^\d+$",
        "Python counts from 0: n things have the places 0 to n - 1, and len(…) says how many there"
        " are, in every call another number perhaps. Print the index that is used there.",
    ),
    (
        "KeyError|AttributeError|TypeError",
        r"^'\w+'$|object has no attribute '(theta|offset|d|a|alpha|get|items|keys|type)'"
        r"|string ind|argument after \*\* must be a mapping",
        f"{FOUR} It is no dictionary and has no names: take row[0] to row[3].",
    ),
    (
        "TypeError",
        r"only (size-1|length-1|0-dimensional) arrays|only .*arrays can be converted",
        "A function of math, or float(…), takes one number and is given several: an index is"
        " missing, or np.cos and np.sin are meant.",
    ),
    (
        "ValueError",
        r"does not have enough dimensions \(has 0",
        "One of the two is None, a single number or three dots: does every function that is called"
        " there return its matrix, and are no dots left?",
    ),
    (
        "ValueError",
        r"matmul|not aligned|broadcast together|dot:",
        "These two have shapes that cannot be combined: print both with .shape. A pose is 4×4; a"
        " 3×4 block lacks its last row 0 0 0 1, a 3×3 block its fourth row and column.",
    ),
    (
        "ValueError",
        r"setting an array element with a sequence|inhomogeneous",
        "The parts have different lengths, or one entry is an array and not a number: print the"
        f" shape of each. {OF_VECTORS}",
    ),
    (
        "ValueError",
        r"could not broadcast input",
        "What is put there has another shape than the place it is to fill: print both shapes."
        f" {OF_VECTORS}",
    ),
    (
        "ValueError|TypeError",
        r"(too many|not enough) values to unpack|cannot unpack",
        f"As many names as values must stand on the left. {FOUR} Or are two arguments exchanged?",
    ),
    (
        "TypeError",
        r"'NoneType'",
        "Something that is used there is None: a function that it calls has no return.",
    ),
    (
        "TypeError",
        r"sequence by non-int|'(list|tuple)'|can only concatenate|unhashable",
        "Lists do not calculate: make them arrays first, with np.array(…).",
    ),
    (
        "UFuncTypeError|_UFuncOutputCastingError|TypeError",
        r"Cannot cast ufunc|same_kind",
        "This array holds whole numbers only. Give it dtype=float where it is made.",
    ),
    (
        "UnboundLocalError",
        "",
        "This name gets its value further down, or only in a branch that was not taken: give it one"
        " before the loop.",
    ),
    (
        "NameError",
        r"name '(np|numpy|math|sin|cos|pi|sp|sympy)'",
        "It was not imported where the function stands: import numpy as np, or from numpy import"
        " sin, cos, pi.",
    ),
    ("NameError", "", "Nothing has this name there: look for another spelling of it."),
    (
        "RecursionError",
        "",
        "The function calls itself without end: the case in which it answers by itself is missing"
        " or never reached.",
    ),
    ("ZeroDivisionError", "", "A length or an angle may be 0: nothing may be divided by it."),
    (
        "TypeError",
        r"positional argument|unexpected keyword|multiple values",
        "A function is called with other arguments than it takes: count them in its def line.",
    ),
    ("AttributeError", r"^module ", "This module has nothing of that name: look at its spelling."),
    (
        "TypeError",
        r"not iterable|has no len|not subscriptable",
        "One number stands there where a list or an array is meant.",
    ),
    (
        "ValueError",
        r"math domain|expected a (non)?negative",
        "acos and asin take numbers from -1 to 1, sqrt takes none below 0.",
    ),
    (
        "ValueError",
        r"determinant|orthogonal|rotation matri",
        "What is handed on there is no rotation. A product of two rotations is one, if it is made"
        " with @; what *, + and - make of them is none.",
    ),
    (
        "LinAlgError",
        "",
        "This matrix has no inverse. np.linalg.solve(A, b) takes the matrix first; forward"
        " kinematics inverts nothing.",
    ),
)


def in_words(error):
    """What an error most likely means; "" where nobody can say.

    Parameters
    ----------
    error : BaseException

    Returns
    -------
    str
        A sentence or two.

    Examples
    --------
    >>> in_words(IndexError("list index out of range"))[:21]
    'Python counts from 0:'
    >>> in_words(ValueError("a value of their own"))
    ''
    """
    kind, message = type(error).__name__, str(error)
    over = _written_over(error) if message.endswith("object is not callable") else None
    if over:
        return WRITTEN_OVER.format(over)
    return next(
        (
            words
            for kinds, pattern, words in _WORDS
            if kind in kinds.split("|") and re.search(pattern, message)
        ),
        "",
    )


def _written_over(error):
    """Which of Python's functions, called in the line that stopped, has its name given to something
    else there; None.
    """
    frames = [frame for frame, _ in traceback.walk_tb(error.__traceback__)]
    if not frames:
        return None
    names = {**frames[-1].f_globals, **frames[-1].f_locals}
    (last,) = traceback.extract_tb(error.__traceback__, limit=-1)
    called = re.findall(r"(?<![\w.])([a-z]+)\s*\(", last.line or "")
    return next(
        (
            name
            for name in called
            if callable(getattr(builtins, name, None)) and not callable(names.get(name, print))
        ),
        None,
    )
