"""What a learner's function gave, as arrays of one shape; and what keeps an answer from being one,
in words.
"""

import time

import numpy as np

from .calling import Called, CallFault, record, shown
from .deadline import OutOfTime, limited

__all__ = ["answers_in_time", "call_all"]

SECONDS = 8  # of the processor, for all calls of a function together
RANDOM = {"random", "rand", "randn", "randint", "uniform", "default_rng"}
LEAST = 3  # calls; a program that is right in three general ones is right in general


def answers_in_time(f, cases, shape, names, seconds=SECONDS):
    """The answers of ``f`` to as many cases as the time allows for, evenly chosen.

    Parameters
    ----------
    f, cases, shape, names
        As for :func:`call_all`.
    seconds : float
        Of the processor.

    Returns
    -------
    (list of int, list of arrays)
        Which cases were called, and the answers.

    Raises
    ------
    CallFault
        As :func:`call_all`; or not even three calls end in time.
    """
    if isinstance(f, Called):
        return list(range(len(cases))), call_all(f, cases, shape, names)
    start = time.process_time()

    def run(f, *given):
        return limited(max(seconds - (time.process_time() - start), 0.01), f, *given)

    try:
        call_all(f, cases[:1], shape, names, run)
        each = (time.process_time() - start) / 2  # the first case is called twice
        many = max(LEAST, int(seconds / 2 / max(each, 1e-9)))
        last = len(cases) - 1
        chosen = np.linspace(0, last, min(many, last + 1)).round().astype(int).tolist()
        chosen = list(dict.fromkeys(chosen))
        return chosen, call_all(f, [cases[k] for k in chosen], shape, names, run)
    except OutOfTime:
        raise CallFault(
            f"the function takes too long: {len(cases)} calls do not end in {seconds:g} seconds",
            "",
            "Does a loop run for ever? With SymPy, put the numbers in before the matrices are"
            " multiplied, and simplify nothing.",
        ) from None


def _names_in(f, depth=2):
    """The names and texts that a function uses, and those that the functions use that it calls."""
    code = getattr(f, "__code__", None)
    if code is None:
        return set()
    texts = {text for text in code.co_consts if isinstance(text, str)}
    found, around = texts | set(code.co_names), getattr(f, "__globals__", {})
    if depth:
        for name in code.co_names:
            found |= _names_in(around.get(name), depth - 1)
    return found


def call_all(f, cases, shape, names, run=None):
    """The answers of ``f`` to every case, each of the given shape and finite.

    Parameters
    ----------
    f : callable or Called
        Or what :func:`record` noted of one, with the same cases, somewhere else.
    cases : list of tuples
    shape : tuple
        What every answer must have.
    names : sequence of str
        What the arguments are called, for the messages.
    run : callable, optional
        As for :func:`record`.

    Returns
    -------
    list of arrays

    Raises
    ------
    CallFault
        The function stops, returns nothing or something of another shape, changes its inputs, or
        answers differently the second time.
    """
    called = f if isinstance(f, Called) else record(f, cases, names, run)
    if called.unwritten:
        raise NotImplementedError
    if called.fault:
        raise called.fault
    arrays = [
        _as_array(answer, shape, case, names)
        for answer, case in zip(called.answers, cases, strict=True)
    ]
    if not np.array_equal(arrays[0], _as_array(called.again, shape, cases[0], names)):
        if not RANDOM.isdisjoint(_names_in(f)):
            raise CallFault(
                "the function draws random numbers: called twice with the same, it gives another"
                " answer",
                shown(cases[0], names),
                "Begin at places that you choose, or give the generator a seed inside the"
                " function.",
            )
        raise CallFault(
            "the second call with the same numbers gives another answer",
            shown(cases[0], names),
            "Start from np.eye(4) inside the function, and change nothing that lives outside it.",
            "state-between-calls",
        )
    return arrays


def _as_array(answer, shape, case, names):
    if answer is None or answer is Ellipsis:
        raise CallFault(
            "the function returns nothing", shown(case, names), "Is the return missing?"
        )
    array = _numbers(answer)
    if array is None:
        raise _no_numbers(answer, shape, case, names)
    if array.shape != shape:
        raise _other_shape(array, shape, case, names)
    if not np.isfinite(array).all():
        raise CallFault(
            "the answer holds NaN or infinity",
            shown(case, names),
            "Look for a division by zero or a square root of a negative number.",
        )
    return array


def _numbers(answer):
    """The array of an answer, None where it holds something else than numbers."""
    try:
        array = np.asarray(answer)
        if array.dtype.kind == "O":
            array = array.astype(float)
    except (TypeError, ValueError):  # also rows of different lengths
        return None
    return array if array.dtype.kind in "iufb" else None


def _no_numbers(answer, shape, case, names):
    if _has_dots(answer):
        return CallFault(
            "there are still three dots in what the function returns",
            "",
            "Put a number or a formula in place of every ...",
        )
    if shape == (4, 4) and _is_pair(answer):
        return CallFault(
            "rotation and position come back apart, expected one array of 4×4 numbers",
            shown(case, names),
            "T = np.eye(4); T[:3, :3] = R; T[:3, 3] = p",
            "pose-incomplete",
        )
    wanted = "×".join(map(str, shape))
    if _is_complex(answer):
        return CallFault(
            f"the function returns complex numbers, expected an array of {wanted} real ones",
            shown(case, names),
            "Look for a square root of a negative number, or for a j behind a number.",
        )
    found = _found(answer)
    return CallFault(
        f"expected an array of {wanted} numbers, found {found}",
        shown(case, names),
        "Print what the function returns, and its type.",
    )


def _found(answer):
    """What stands where an array of numbers belongs, in words."""
    if isinstance(answer, np.ndarray):
        answer = answer.tolist()
    if not isinstance(answer, (list, tuple)):
        name = type(answer).__name__
        return "a text" if name == "str" else f"an object of the type {name}"
    rows = [row if isinstance(row, (list, tuple)) else [row] for row in answer]
    texts = [one for row in rows for one in row if isinstance(one, str)]
    return (
        f"one with the text {min(texts, key=str.isdigit)!r:.40} in it"
        if texts
        else "one with an entry that is no number"
    )


def _has_dots(answer):
    if isinstance(answer, np.ndarray):
        answer = answer.tolist()
    return answer is Ellipsis or (
        isinstance(answer, (list, tuple)) and any(_has_dots(entry) for entry in answer)
    )


def _is_pair(answer):
    """Whether an answer is a rotation and a position, or the other way round."""
    if not isinstance(answer, (tuple, list)) or len(answer) != 2:
        return False
    parts = [_numbers(part) for part in answer]
    return sorted(np.size(part) for part in parts if part is not None) == [3, 9]


def _is_complex(answer):
    try:
        return np.asarray(answer).dtype.kind == "c"
    except ValueError:
        return False


def _other_shape(array, shape, case, names):
    found = "×".join(map(str, array.shape)) or "a single number"
    mistake, do = None, "Print the shape of what you return."
    if array.shape == shape[::-1]:
        do = "Rows and columns have changed places: return the transpose."
    elif shape == (4, 4) and array.shape == (3, 4):
        mistake, do = "last-row-missing", "A pose needs its fourth row, 0 0 0 1."
    elif shape == (4, 4) and array.size in (3, 9) and array.ndim <= 2:
        mistake = "pose-incomplete"
        do = f"Give the whole pose: its {'position' if array.size == 3 else 'rotation'} is a part."
    elif len(shape) == 2 and array.size == shape[0] != shape[1]:
        do = f"One column comes back of {shape[1]}: is the return inside the loop?"
    elif array.ndim == len(shape) == 2 and array.shape[1] == shape[1] and len(array) < shape[0]:
        do = (
            "Rows are missing: is every case among them, and does the return stand behind the loop?"
        )
    elif len(shape) == 1 and array.size == shape[0]:
        do = "np.ravel(…) around all of them makes one row."
        if array.shape[1:] == (1,):  # what calls it would go on with n×n numbers
            do = "A row and a column add up to a table: np.ravel(…) makes a row of the column."
    elif array.ndim == len(shape) + 1 and array.shape[1:] == shape:
        do = (
            "It comes back inside a list: return it alone."
            if len(array) == 1
            else f"A list of {len(array)} comes back, and one is asked: that one of them, or what"
            " they make together."
        )
    return CallFault(
        f"the answer has the shape {found}, expected {'×'.join(map(str, shape))}",
        shown(case, names),
        do,
        mistake,
    )
