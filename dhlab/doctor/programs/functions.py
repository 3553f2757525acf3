"""``diagnose_function``: a learner's function called on seeded numbers, compared with the right
one, and what is wrong with it in words.
"""

import contextlib
import inspect
from dataclasses import replace

import numpy as np

from ...transform import pose_fault
from ..budget import Budget
from ..catalogue import catalogue
from ..diagnosis import EXPLAINED, UNEXPLAINED, Diagnosis
from ..finding import find
from .compared import (
    EXACT,
    UNKNOWN,
    Answers,
    agrees,
    compared,
    explained,
    explains,
    from_lists,
    residual,
    special,
)
from .explain import hides_the_rest
from .running.answers import answers_in_time
from .running.calling import CallFault, is_stub
from .running.deadline import OutOfTime, limited
from .source.lines import lines_to_change
from .source.precision import single_precision
from .task import KINDS, RIGHT, Task

__all__ = ["diagnose_function"]

SECONDS = 1.85  # of the processor, for everything
AS_ARM = 0.9  # at most, for the program taken for an arm, with one mistake or with two
KEPT = 0.35  # for the second of these, where the search for lines that must change goes before
LEAST = 0.3  # for that search; for anything else it is not worth beginning with less than half
HALVES = 3  # changes of the text that may be one half of what is wrong


def diagnose_function(f, kind, *, arm=None, convention="standard"):
    """What is wrong with a program for forward kinematics, found by calling it.

    The function is called in this process, on seeded general numbers and on special ones (zeros,
    right and whole turns, long and negative lengths, one row and seven), on copies, and twice with
    the same. Right answers agree in any dress: lists, tuples, ``np.matrix``, SymPy, within 1e-6
    (4e-6 where it computes in single precision). Where the function's text can be read, the lines
    are told that must change: its file or cell is tried again with one or two things in it changed,
    until it is right; nothing of that is kept.

    Parameters
    ----------
    f : callable
        ``dh_transform(theta, d, a, alpha)`` or ``forward_kinematics(rows, q)``: radians and metres;
        ``rows`` (n, 4) holds theta offset, d, a, alpha, ``q`` (n,) the joint
        values; the answer is a pose (4, 4).
    kind : "dh_transform" or "forward_kinematics"
    arm : Arm, optional
        The one arm that ``forward_kinematics`` is written for; then it may also take q alone, the
        joint values one by one, or (rows, q, base, tool), and the arm's base and tool belong to the
        pose.
    convention : "standard" or "craig"
        Whose link matrix the program is to compute; in Craig's a row holds a and alpha of the link
        before. A program of the other convention is told so.

    Returns
    -------
    Diagnosis
        ``verdict`` is "agrees", "explained" (one finding, or two mistakes that explain the answers
        together, or ``lines`` whose change makes it right) or "unexplained".

    Raises
    ------
    ValueError
        ``f`` is no function, the kind or the convention is unknown, or ``f`` takes rows and the arm
        is not one of turning joints with rows of that convention. What ``f`` itself raises is
        caught and put into words.

    Examples
    --------
    >>> from dhlab.doctor.programs.wrong.links import standard
    >>> def wrong(theta, d, a, alpha):
    ...     return standard(theta, d, a, -alpha)
    >>> print(diagnose_function(wrong, "dh_transform").headline)
    One mistake explains what this program answers: alpha has the wrong sign.
    >>> bool(diagnose_function(standard, "dh_transform"))
    True
    >>> print(diagnose_function(standard, "dh_transform", convention="craig").findings[0].mistake)
    craig-rows-in-standard-matrix
    """
    if kind not in KINDS:
        raise ValueError(
            'diagnose_function: expected the kind "dh_transform" or "forward_kinematics", found'
            f" {kind!r}; say what f computes"
        )
    if not callable(f):
        raise ValueError(
            f"diagnose_function: expected a function, found {type(f).__name__}; hand in its name"
            " without brackets"
        )
    if convention not in RIGHT:
        raise ValueError(
            'diagnose_function: expected the convention "standard" or "craig", found'
            f" {convention!r}; say whose link matrix f computes"
        )
    task = Task(kind, arm, _names(f, arm), convention)
    task.clock = Budget(SECONDS)
    if is_stub(f):
        return Diagnosis(UNEXPLAINED, "Nothing is written in this function yet.")
    try:
        return _diagnosed(f, task)
    except NotImplementedError:
        return Diagnosis(
            UNEXPLAINED, "Nothing is written in this function yet: it raises NotImplementedError."
        )
    except KeyboardInterrupt:
        return Diagnosis(UNEXPLAINED, "You interrupted the search before it came to an end.")


def _names(f, arm):
    """What a program of a chain is given: for one arm it may know the rows itself, with q as one or
    joint by joint, or ask for base and tool too.
    """
    if arm is None:
        return ("rows", "q")
    try:
        asked = list(inspect.signature(f).parameters)
    except (ValueError, TypeError):
        return ("rows", "q")
    numbered = all(name[-1:].isdigit() for name in asked)
    if len(asked) == len(arm) and (numbered or len(asked) not in (1, 2, 4)):
        return tuple(f"q{i}" for i in range(1, len(arm) + 1))
    return {1: ("q",), 4: ("rows", "q", "base", "tool")}.get(len(asked), ("rows", "q"))


def _diagnosed(f, task):
    """The diagnosis of a function that is called here."""
    try:
        here, there = _answers(f, task)
    except CallFault as fault:
        stopped = fault.mistake != "inputs-changed"  # of lists, np.asarray changes a copy alone
        if task.is_chain and not task.lists and stopped and _takes_lists(f, task):
            return _diagnosed(f, task)
        return _with_lines(_stopped(fault), f, task)
    pairs = not _knows_its_rows(task)  # their lines go before two slips, which take their time
    steps = (compared(here, there, pairs), special(here, there), from_lists(f, here))
    wrong = [step for step in steps if step is not None]  # one that is found is false
    if not wrong:
        return agrees(here)
    bent = pose_fault(here.array) is not None
    task.kept = KEPT if _knows_its_rows(task) and not bent else 0.0
    diagnosis = _with_lines(_as_arm(wrong[0], here, f, 1), f, task, bent)
    return diagnosis if diagnosis.lines else _as_arm(diagnosis, here, f, 2)


def _two_slips(here):
    """Two slips that explain the answers of a program that knows its rows, as time allows."""
    left = here.task.clock.left
    if left > 0 and _knows_its_rows(here.task):
        with contextlib.suppress(OutOfTime):
            return limited(left, explained, here)
    return ()


def _as_arm(diagnosis, here, f, mistakes):
    """The diagnosis of a program that has its table in itself, where no mistake of programs
    explains it: its answers may be those of an arm with one mistake in its table, or with two.
    """
    if not diagnosis.headline.startswith(UNKNOWN):
        return diagnosis
    findings = (_two_slips(here) if mistakes == 2 else ()) or _of_its_arm(here, f, mistakes)
    return explains(findings, diagnosis.before) if findings else diagnosis


def _of_its_arm(here, f, mistakes):
    """What explains the answers as those of another arm, where the program knows its rows."""
    task = here.task
    left = task.clock.left
    if not _knows_its_rows(task) or left < LEAST / 2 or pose_fault(here.array) is not None:
        return ()
    from .search.itsarm import STEP, as_its_arm, is_a_chain  # with scipy, which nothing else needs

    q = np.array([case[-1] for case in here.cases])
    n = q.shape[1]
    rows = task.arm.table.rows
    calls = [task.arguments((rows, values)) for values in (np.zeros(n), *(STEP * np.eye(n)))]
    try:
        called, (zero, *alone) = answers_in_time(f, calls, (4, 4), task.names)
    except CallFault:
        return ()
    if len(called) <= n or not is_a_chain(zero, alone, q, here.array):
        return ()
    return as_its_arm(here.array, task.arm, q, min(AS_ARM, left), mistakes)


def _knows_its_rows(task):
    """Whether a program for one arm has its table written in."""
    return task.is_chain and "rows" not in task.names


def _takes_lists(f, task):
    """Whether a program that stops at arrays takes lists; then it is given those."""
    task.lists = True
    try:
        _answers(f, task)
    except CallFault:
        task.lists = False
    return task.lists


def _answers(f, task):
    """What the function gives in the general calls and in the special ones."""
    found = []
    for cases in task.calls:
        calls = [task.arguments(case) for case in cases]
        called, answers = answers_in_time(f, calls, (4, 4), task.names)
        found.append(([cases[k] for k in called], answers))
    single = single_precision(f, found[0][1])
    return [Answers(*part, task, single) for part in found]


def _with_lines(diagnosis, f, task, bent=False):
    """A diagnosis, with the lines that must change where they are found."""
    calls = [
        (task.arguments(case), task.right(case))
        for case in [*task.simple, *(case for cases in task.calls for case in cases)]
    ]
    left = task.clock.left - task.kept
    lines, steps, whole, better = lines_to_change(
        f, calls, EXACT, max(left, LEAST), task.arm if task.is_chain else None
    )
    diagnosis = replace(diagnosis, lines=lines, repaired=whole)
    if not lines:
        unknown = diagnosis.verdict == UNEXPLAINED
        return (_half(better, task, bent) if unknown else None) or diagnosis
    places = list(dict.fromkeys(f"line {line.number}" for line in lines))
    headline = f"With another {' and '.join(places)} the program is right."
    if diagnosis.headline.startswith(UNKNOWN) or steps < len(diagnosis.findings):
        diagnosis = replace(diagnosis, headline=headline, findings=())
    elif hides_the_rest(diagnosis.findings) and len(places) > 1:
        diagnosis = replace(diagnosis, headline=headline)
    return replace(diagnosis, verdict=EXPLAINED)


def _half(better, task, bent):
    """The diagnosis of a program in which one change of its text leaves one known mistake; None.
    With ``bent`` the answers were no poses, so that they were not looked at as an arm's.
    """
    for lines, g in better[:HALVES]:
        if task.clock.left < LEAST / 2:
            return None
        try:
            here, _ = _answers(g, task)
        except (CallFault, NotImplementedError):
            continue
        if not any(here.off):
            continue
        findings = explained(here) or (bent and _of_its_arm(here, g, 1)) or ()
        if len(findings) == 1:
            (left,), (line,) = findings, lines[:1]
            return Diagnosis(
                EXPLAINED,
                f"Two mistakes together explain what this program does: one in line {line.number},"
                f" and: {catalogue()[left.mistake].title}.",
                findings,
                before=residual(here.array, here.right),
                notes=(f"The other one stands in line {line}.",),
            )
    return None


def _stopped(fault):
    """The diagnosis of a function that gave nothing to compare."""
    notes = tuple(text for text in (fault.place, fault.next) if text)
    if fault.mistake is None:
        return Diagnosis(
            UNEXPLAINED, f"The program cannot be compared: {fault.headline}.", notes=notes
        )
    return Diagnosis(
        EXPLAINED,
        f"One mistake is seen at once: {fault.headline}. Whether it is the only one shows when it"
        " is mended.",
        (find(fault.mistake, fault.place),),
    )
