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

from .stops import in_words

__all__ = [
    "Called",
    "CallFault",
    "Fault",
    "call",
    "fits",
    "is_stub",
    "line_of",
    "quiet",
    "record",
    "shown",
]


MOST_WORDS = 200  # letters of a message of Python's that are shown
LONG = 200  # bytes of code; no stub has as many


class Fault(Exception):
    """What a call ended with: its ``kind``, "stops", "changed" or "interrupted", the ``error`` that
    stopped it, and the ``line`` of the function, counted from its first; 0 when it is not known.
    """

    def __init__(self, kind, error=None, line=0):
        super().__init__(kind)
        self.kind, self.error, self.line = kind, error, line


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

    ``unwritten``: it raises NotImplementedError. Of one that was called somewhere else: whether its
    text says that it computes in single precision, and how many functions made matrices for it.
    """

    answers: tuple = ()
    again: object = None
    fault: CallFault | None = None
    unwritten: bool = False
    single: bool = False
    made: int = 0


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
    if code is None or len(code.co_code) > LONG:
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


def record(f, cases, names, run=None):
    """Call a function on every case, and on the first once more; what goes wrong is noted, not
    raised.

    Parameters
    ----------
    f : callable
    cases : list of tuples
    names : sequence of str
        What the arguments are called, for the messages.
    run : callable, optional
        ``run(f, *arguments)`` calls it, with a limit of time, say; f(*arguments) when left out.

    Returns
    -------
    Called
        Its answers are as the function gave them, of any type and shape.

    Examples
    --------
    >>> record(lambda x: x + 1, [(1,), (2,)], ["x"])
    Called(answers=(2, 3), again=2, fault=None, unwritten=False, single=False, made=0)
    """
    if not fits(f, names):
        return Called(fault=_misfit(f, names))
    try:
        with quiet():
            answers = tuple(_told(f, case, names, run) for case in cases)
            return Called(answers, _told(f, cases[0], names, run))
    except CallFault as fault:
        return Called(fault=fault)
    except NotImplementedError:
        return Called(unwritten=True)


@contextlib.contextmanager
def quiet():
    """Without what a learner's program prints and warns of."""
    with (
        contextlib.redirect_stdout(io.StringIO()),
        warnings.catch_warnings(),
        np.errstate(all="ignore"),
    ):
        warnings.simplefilter("ignore")
        yield


def fits(f, names):
    """Whether a function takes as many arguments as it will be given; true where it does not say.

    Examples
    --------
    >>> fits(lambda theta, d: 0, ["theta", "d"]), fits(lambda: 0, ["theta"])
    (True, False)
    """
    try:
        signature = inspect.signature(f)
    except (ValueError, TypeError):
        return True
    try:
        signature.bind(*names)
    except TypeError:
        return False
    return True


def _misfit(f, names):
    """Said before Python says it less plainly."""
    takes = ", ".join(inspect.signature(f).parameters) or "nothing"
    return CallFault(
        f"TypeError: the function cannot be called with {len(names)} arguments"
        f" ({', '.join(names)})",
        f"it takes {takes}",
        f"Give it the arguments {', '.join(names)}, in this order.",
    )


def call(f, case, run=None):
    """What a function gives for one case, called with copies.

    Raises
    ------
    Fault
        It stops, or changes the numbers it was given.
    NotImplementedError
        The function raises it: it is not written yet.
    """
    given = copy.deepcopy(case)
    try:
        answer = copy.deepcopy(run(f, *given) if run else f(*given))
    except NotImplementedError:
        raise
    except KeyboardInterrupt:
        raise Fault("interrupted") from None
    except (Exception, SystemExit) as error:
        raise Fault("stops", error, _line_within(error, f)) from None
    # what cannot be changed is its own copy
    if not all(a is b or np.array_equal(a, b) for a, b in zip(case, given)):
        raise Fault("changed")
    return answer


def _told(f, case, names, run):
    """The same, with what goes wrong in words."""
    try:
        return call(f, case, run)
    except Fault as fault:
        raise _in_words(fault, f, case, names) from None


def _in_words(fault, f, case, names):
    if fault.kind == "interrupted":
        return CallFault(
            "you interrupted the function",
            shown(case, names),
            "Look for a loop that never ends, or shorten what it computes, and try again.",
        )
    if fault.kind == "changed":
        return CallFault(
            "the function changes the numbers it was given",
            shown(case, names),
            "Work on a copy, or write x = x + … in place of x += …",
            "inputs-changed",
        )
    error = fault.error
    return CallFault(
        f"the function stops with {type(error).__name__}: {_first_words(error)}",
        "; ".join(filter(None, (line_of(error, f), shown(case, names)))),
        in_words(error)
        or f"Call it yourself, {_call_text(f, case)}, and read the last line of the message.",
    )


def _first_words(error):
    """An error's message up to the numbers that it may print, in one line."""
    words = str(error).split("[[")[0].split("\n")[0].strip()
    return words[:MOST_WORDS].removesuffix(":")


def _call_text(f, case):
    """The call as one would type it, where its numbers are few."""
    name = getattr(f, "__name__", "f")
    if all(np.ndim(value) == 0 for value in case):
        return f"{name}({', '.join(f'{float(value):.3g}' for value in case)})"
    return "with small numbers of your own"


def line_of(error, f):
    """The learner's own line in which an error arose, with its number in the file or cell; "" when
    it is not known.
    """
    last = _own_frame(error, f)
    if last is None:
        return ""
    where = f"line {last.lineno}, in {last.name}"
    return f"{where}: {last.line}" if last.line else where


def _line_within(error, f):
    """The line in which an error arose, counted from the first of the function; 0 when it is not
    known.
    """
    last = _own_frame(error, f)
    return last.lineno - f.__code__.co_firstlineno + 1 if last else 0


def _own_frame(error, f):
    """The last step of an error's way that stands in the learner's own file or cell, or None."""
    file = getattr(getattr(f, "__code__", None), "co_filename", None)
    own = [frame for frame in traceback.extract_tb(error.__traceback__) if frame.filename == file]
    return own[-1] if own else None


def shown(case, names):
    """The call, for a reader who wants to repeat it."""

    def text(value):
        array = np.asarray(value)
        return (
            f"{float(array):.3g}"
            if array.ndim == 0
            else f"{'×'.join(map(str, array.shape))} numbers"
        )

    return "seen at " + ", ".join(f"{name} = {text(value)}" for name, value in zip(names, case))
