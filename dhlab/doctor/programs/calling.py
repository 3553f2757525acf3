"""Calling a learner's function: on copies, quietly, twice, and with what goes wrong put into
words.
"""

import contextlib
import copy
import dis
import inspect
import io
import traceback
import warnings
from dataclasses import dataclass

import numpy as np

__all__ = ["is_stub", "record", "call_all", "Called", "CallFault"]


class CallFault(Exception):
    """What kept the answers from being compared: ``headline``, ``place``, ``next`` and perhaps the
    id of a ``mistake``.
    """

    def __init__(self, headline, place="", next="", mistake=None):
        super().__init__(headline)
        self.headline, self.place, self.next, self.mistake = headline, place, next, mistake


@dataclass(frozen=True)
class Called:
    """What a function gave when it was called: the answer to every case and, again, to the first;
    or the fault that stopped it.

    ``unwritten``: it raises NotImplementedError.
    """

    answers: tuple = ()
    again: object = None
    fault: CallFault | None = None
    unwritten: bool = False


def is_stub(f):
    """Whether a function's body is still the one that was handed out: nothing but ``...``, ``pass``
    or a docstring.

    Examples
    --------
    >>> def f(x):
    ...     "Returns x twice."
    >>> is_stub(f), is_stub(lambda x: 2 * x)
    (True, False)
    """
    code = getattr(f, "__code__", None)
    if code is None:
        return False
    steps = [
        step
        for step in dis.get_instructions(code)
        if step.opname not in ("RESUME", "NOP", "CACHE", "COPY_FREE_VARS")
    ]
    names = [step.opname for step in steps]
    if names not in (["LOAD_CONST", "RETURN_VALUE"], ["RETURN_CONST"]):
        return False
    return steps[0].argval is None or steps[0].argval is Ellipsis


def record(f, cases, names):
    """Call a function on every case, and on the first once more; what goes wrong is noted, not
    raised.

    Parameters
    ----------
    f : callable
    cases : list of tuples
    names : sequence of str
        What the arguments are called, for the messages.

    Returns
    -------
    Called
        Its answers are as the function gave them, of any type and shape.

    Examples
    --------
    >>> record(lambda x: x + 1, [(1,), (2,)], ["x"])
    Called(answers=(2, 3), again=2, fault=None, unwritten=False)
    """
    try:
        _fits(f, names)
        with (
            contextlib.redirect_stdout(io.StringIO()),
            warnings.catch_warnings(),
            np.errstate(all="ignore"),
        ):
            warnings.simplefilter("ignore")
            return Called(tuple(_call(f, case, names) for case in cases), _call(f, cases[0], names))
    except CallFault as fault:
        return Called(fault=fault)
    except NotImplementedError:
        return Called(unwritten=True)


def call_all(f, cases, shape, names):
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

    Returns
    -------
    list of arrays

    Raises
    ------
    CallFault
        The function stops, returns nothing or something of another shape, changes its inputs, or
        answers differently the second time.
    """
    called = f if isinstance(f, Called) else record(f, cases, names)
    if called.unwritten:
        raise NotImplementedError
    if called.fault:
        raise called.fault
    arrays = [
        _as_array(answer, shape, case, names)
        for answer, case in zip(called.answers, cases, strict=True)
    ]
    if not np.array_equal(arrays[0], _as_array(called.again, shape, cases[0], names)):
        raise CallFault(
            "the second call with the same numbers gives another answer",
            _shown(cases[0], names),
            "Start from np.eye(4) inside the function, and change nothing that lives outside it.",
            "state-between-calls",
        )
    return arrays


def _fits(f, names):
    """Whether the function takes as many arguments as it will be given; said before Python says it
    less plainly.
    """
    try:
        signature = inspect.signature(f)
    except (ValueError, TypeError):  # no signature to be had
        return
    try:
        signature.bind(*names)
    except TypeError:
        takes = ", ".join(signature.parameters) or "nothing"
        raise CallFault(
            f"TypeError: the function cannot be called with {len(names)} arguments"
            f" ({', '.join(names)})",
            f"it takes {takes}",
            f"Give it the arguments {', '.join(names)}, in this order.",
        ) from None


def _call(f, case, names):
    given = copy.deepcopy(case)
    try:
        answer = copy.deepcopy(f(*given))
    except NotImplementedError:
        raise
    except (Exception, SystemExit) as error:
        place = "; ".join(filter(None, (_line_of(error, f), _shown(case, names))))
        raise CallFault(
            f"the function stops with {type(error).__name__}: {str(error)[:200]}",
            place,
            f"Call it yourself, {_call_text(f, case)}, and read the last line of the message.",
        ) from None
    if not all(np.array_equal(before, after) for before, after in zip(case, given)):
        raise CallFault(
            "the function changes the numbers it was given",
            _shown(case, names),
            "Work on a copy, or write x = x + … in place of x += …",
            "inputs-changed",
        )
    return answer


def _call_text(f, case):
    """The call as one would type it, where its numbers are few."""
    name = getattr(f, "__name__", "f")
    if all(np.ndim(value) == 0 for value in case):
        return f"{name}({', '.join(f'{float(value):.3g}' for value in case)})"
    return "with a short table of your own"


def _line_of(error, f):
    """The line inside the learner's function where it stopped."""
    frames = (
        [
            frame
            for frame in traceback.extract_tb(error.__traceback__)
            if frame.filename == getattr(f, "__code__", f).co_filename
        ]
        if hasattr(f, "__code__")
        else []
    )
    return (
        f"line {frames[-1].lineno - f.__code__.co_firstlineno + 1} of {f.__name__}:"
        f" {frames[-1].line}"
        if frames and frames[-1].line
        else ""
    )


def _as_array(answer, shape, case, names):
    if answer is None or answer is Ellipsis:
        raise CallFault(
            "the function returns nothing", _shown(case, names), "Is the return missing?"
        )
    array = _numbers(answer)
    if array is None:
        raise _no_numbers(answer, shape, case, names)
    if array.shape != shape:
        raise _other_shape(array, shape, case, names)
    if not np.isfinite(array).all():
        raise CallFault(
            "the answer holds NaN or infinity",
            _shown(case, names),
            "Look for a division by zero or a square root of a negative number.",
        )
    return array


def _numbers(answer):
    """The array of an answer, None where it holds something else than numbers."""
    try:
        array = np.asarray(answer)
    except ValueError:  # rows of different lengths
        array = np.asarray(None)
    if array.dtype.kind == "O":
        try:
            array = array.astype(float)
        except (TypeError, ValueError):
            return None
    return array if array.dtype.kind in "iufb" else None


def _no_numbers(answer, shape, case, names):
    if any(entry is Ellipsis for entry in np.asarray(answer, dtype=object).flat):
        return CallFault(
            "there are still three dots in what the function returns",
            "",
            "Put a number or a formula in place of every ...",
        )
    wanted = "×".join(map(str, shape))
    return CallFault(
        f"the function returns {type(answer).__name__}, expected an array of {wanted} numbers",
        _shown(case, names),
    )


def _other_shape(array, shape, case, names):
    found = "×".join(map(str, array.shape)) or "a single number"
    mistake = "last-row-missing" if array.shape == (3, 4) and shape == (4, 4) else None
    turned = (
        "Rows and columns have changed places: return the transpose."
        if array.shape == shape[::-1]
        else "Print the shape of what you return."
    )
    return CallFault(
        f"the answer has the shape {found}, expected {'×'.join(map(str, shape))}",
        _shown(case, names),
        "A pose needs its fourth row, 0 0 0 1." if mistake else turned,
        mistake,
    )


def _shown(case, names):
    """The call, for a reader who wants to repeat it."""

    def text(value):
        array = np.asarray(value)
        return (
            f"{float(array):.3g}"
            if array.ndim == 0
            else f"{'×'.join(map(str, array.shape))} numbers"
        )

    return "seen at " + ", ".join(f"{name} = {text(value)}" for name, value in zip(names, case))
