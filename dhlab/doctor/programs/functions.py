"""``diagnose_function``: a learner's function called on seeded numbers, compared with the right
one, and what is wrong with it in words.
"""

import inspect
from dataclasses import replace

import numpy as np

from ...transform import pose_fault
from ..catalogue import catalogue
from ..diagnosis import AGREES, EXPLAINED, UNEXPLAINED, Diagnosis
from ..finding import find
from ..mistakes.registry import only_seen
from .answers import answers_in_time, call_all, single_precision
from .calling import CallFault, is_stub
from .cases import where
from .explain import explain_all
from .source.lines import lines_to_change
from .task import KINDS, Task

__all__ = ["diagnose_function"]

# largest deviation of an agreeing answer, absolute and relative; the second in single precision
EXACT, SINGLE = 1e-6, 1e-5
SECONDS = 1.3  # of the processor, to look for the lines that must change
UNKNOWN = "No known mistake"
HALVES = 3  # changes of the text that may be one half of what is wrong


def diagnose_function(f, kind, *, arm=None):
    """What is wrong with a program for forward kinematics, found by calling it.

    The function is called in this process, on seeded general numbers and on special ones (zeros,
    right and whole turns, long and negative lengths, one row and seven), on copies, and twice with
    the same. Right answers agree in any dress: lists, tuples, ``np.matrix``, SymPy, within 1e-6
    (1e-5 where it computes in single precision). Where the function's text can be read, the lines
    are told that must change: its file or cell is tried again with one or two things in it changed,
    until it is right; nothing of that is kept.

    Parameters
    ----------
    f : callable
        ``dh_transform(theta, d, a, alpha)`` or ``forward_kinematics(rows, q)``: radians and metres,
        standard convention; ``rows`` (n, 4) holds theta offset, d, a, alpha, ``q`` (n,) the joint
        values; the answer is a pose (4, 4).
    kind : "dh_transform" or "forward_kinematics"
    arm : Arm, optional
        The one arm that ``forward_kinematics`` is written for; then it may also take q alone, or
        (rows, q, base, tool), and the arm's base and tool belong to the pose.

    Returns
    -------
    Diagnosis
        ``verdict`` is "agrees", "explained" (one finding, or two mistakes that explain the answers
        together, or ``lines`` whose change makes it right) or "unexplained".

    Raises
    ------
    ValueError
        ``f`` is no function, the kind is unknown, or the arm is not one of turning joints with
        standard rows. What ``f`` itself raises is caught and put
        into words.

    Examples
    --------
    >>> from dhlab.doctor.programs.wrong.links import standard
    >>> def wrong(theta, d, a, alpha):
    ...     return standard(theta, d, a, -alpha)
    >>> print(diagnose_function(wrong, "dh_transform").headline)
    One mistake explains what this program answers: alpha has the wrong sign.
    >>> bool(diagnose_function(standard, "dh_transform"))
    True
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
    task = Task(kind, arm, _names(f, arm))
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
    """What a program of a chain is given: for one arm it may know the rows itself, or ask for base
    and tool too.
    """
    try:
        many = len(inspect.signature(f).parameters) if arm is not None else 2
    except (ValueError, TypeError):
        many = 2
    return {1: ("q",), 4: ("rows", "q", "base", "tool")}.get(many, ("rows", "q"))


def _diagnosed(f, task):
    """The diagnosis of a function that is called here."""
    try:
        here, there = _answers(f, task)
    except CallFault as fault:
        if task.is_chain and not task.lists and _takes_lists(f, task):
            return _diagnosed(f, task)
        return _with_lines(_stopped(fault), f, task)
    steps = (_compared(here, there), _special(here, there), _from_lists(f, here))
    wrong = [step for step in steps if step is not None]  # one that is found is false
    return _with_lines(wrong[0], f, task) if wrong else _agrees(here)


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


def _with_lines(diagnosis, f, task):
    """A diagnosis, with the lines that must change where they are found."""
    calls = [
        (task.arguments(case), task.right(case))
        for case in [*task.simple, *(case for cases in task.calls for case in cases)]
    ]
    lines, whole, better = lines_to_change(f, calls, EXACT, SECONDS)
    diagnosis = replace(diagnosis, lines=lines, repaired=whole)
    if lines and (not diagnosis.findings or len(lines) < len(diagnosis.findings)):
        headline = diagnosis.headline
        if headline.startswith(UNKNOWN) or diagnosis.findings:
            places = " and ".join(dict.fromkeys(f"line {line.number}" for line in lines))
            headline = f"No known mistake, but the program is right with another {places}."
        return replace(diagnosis, verdict=EXPLAINED, headline=headline, findings=())
    if diagnosis.verdict == UNEXPLAINED:
        return _half(better, task) or diagnosis
    return diagnosis


def _half(better, task):
    """The diagnosis of a program in which one change of its text leaves one known mistake; None."""
    for lines, g in better[:HALVES]:
        try:
            here, _ = _answers(g, task)
        except (CallFault, NotImplementedError):
            continue
        findings = _explained(here)
        if len(findings) == 1 and any(here.off):
            (left,), (line,) = findings, lines[:1]
            return Diagnosis(
                EXPLAINED,
                f"Two mistakes together explain what this program does: one in line {line.number},"
                f" and: {catalogue()[left.mistake].title}.",
                findings,
                before=_residual(here.array, here.right),
                notes=(f"The other one stands in line {line}.",),
            )
    return None


class Answers:
    """What a program answered, beside what is right.

    ``cases`` are the calls, ``given`` the answers (m, 4, 4), ``right`` the right ones, ``off``
    whether each call went wrong, ``tolerance`` the largest deviation of one that did not.
    """

    def __init__(self, cases, given, task, single):
        self.cases, self.task, self.kind = cases, task, task.kind
        self.given = given
        self.right = np.array([task.right(case) for case in cases])
        self.tolerance = SINGLE if single else EXACT
        self.off = [
            not np.allclose(answer, pose, rtol=self.tolerance, atol=self.tolerance)
            for answer, pose in zip(given, self.right)
        ]

    @property
    def array(self):
        return np.array(self.given, dtype=float)

    def among(self, off):
        """The calls that went wrong, or those that did not."""
        return [case for case, wrong in zip(self.cases, self.off) if wrong == off]


def _stopped(fault):
    """The diagnosis of a function that gave nothing to compare."""
    notes = tuple(text for text in (fault.place, fault.next) if text)
    if fault.mistake is None:
        return Diagnosis(
            UNEXPLAINED, f"The program cannot be compared: {fault.headline}.", notes=notes
        )
    return Diagnosis(
        EXPLAINED,
        f"One mistake explains what this program does: {fault.headline}.",
        (find(fault.mistake, fault.place),),
    )


def _compared(here, there):
    """None when all general answers are right, otherwise the diagnosis."""
    if not any(here.off):
        return None
    before = _residual(here.array, here.right)
    if _remembered(here.given, here.cases, here.off):
        headline = (
            "One mistake explains what this program does: it gives an earlier call's answer again."
        )
        return Diagnosis(EXPLAINED, headline, (find("state-between-calls"),), before=before)
    findings = _explained(here, symptoms=True)
    if findings and not only_seen(findings[0].mistake):
        return Diagnosis(EXPLAINED, _headline(findings), findings, before=before)
    return Diagnosis(
        UNEXPLAINED, _unexplained(here), findings, before=before, notes=_hints(here, there)
    )


def _explained(here, symptoms=False):
    """The mistakes that together explain the answers; of symptoms only where they are wanted."""
    tolerance = here.tolerance if here.tolerance == SINGLE else 1e-9
    bare = here.task.bare
    given = here.given if here.task.arm is None else list(bare(here.array))
    findings = explain_all(given, bare(here.right), here.cases, here.kind, tolerance)
    return findings if symptoms or not findings or not only_seen(findings[0].mistake) else ()


def _remembered(answers, cases, off):
    """A right answer that comes back, exactly, for other numbers: something is kept between the
    calls.
    """
    sizes = [np.shape(case[-1]) for case in cases]
    return any(
        not off[i] and off[k] and sizes[i] == sizes[k] and np.array_equal(answers[i], answers[k])
        for i in range(len(answers))
        for k in range(i + 1, len(answers))
    )


def _headline(findings):
    titles = [catalogue()[finding.mistake].title for finding in findings]
    if len(titles) == 1:
        return f"One mistake explains what this program answers: {titles[0]}."
    if len(set(titles)) == 1:
        return (
            f"{len(titles)} mistakes of one kind together explain what this program answers:"
            f" {titles[0]}."
        )
    return f"Mistakes that together explain what this program answers: {'; '.join(titles)}."


def _unexplained(here):
    if all(np.array_equal(answer, here.given[0]) for answer in here.given):
        return "The answer is the same whatever goes in, and no known mistake explains it."
    difference = np.abs(here.array - here.right).max(axis=0)
    rotation, position = difference[:3, :3].max() > EXACT, difference[:3, 3].max() > EXACT
    words = {
        (True, True): "rotation and position are",
        (True, False): "the rotation is",
        (False, True): "the position is",
        (False, False): "the last row is",
    }
    what = words[bool(rotation), bool(position)]
    return (
        f"{UNKNOWN} explains the answers: {what} wrong in {sum(here.off)} of {len(here.off)} calls."
    )


def _hints(here, there):
    """What can be said of answers that no known mistake explains."""
    fault = pose_fault(here.array)
    notes = [f"Not every answer is a pose: {fault}."] if fault else []
    if all(here.off) and all(there.off):
        return tuple(notes)
    place = where(
        here.kind, here.among(True) + there.among(True), here.among(False) + there.among(False)
    )
    if place:
        notes.append(f"Wrong where {place}, and right in every other call.")
    elif not all(here.off):
        right = len(here.off) - sum(here.off)
        notes.append(
            f"Right in {right} calls; wrong at {_numbers_of(here.among(True)[0], here.task)}. Look"
            " for an if, or for a sign that abs or sqrt took away."
        )
    return tuple(notes)


def _numbers_of(case, task):
    """The arguments of a call, where they are few enough to be read."""
    if task.is_chain:
        return f"{len(case[1])} rows"
    return ", ".join(f"{name} = {value:.3g}" for name, value in zip(task.names, case))


def _residual(answers, right):
    """Largest deviation in mm and degrees; the angle is NaN where the answer is no pose."""
    millimetres = 1000 * float(np.linalg.norm(answers[:, :3, 3] - right[:, :3, 3], axis=-1).max())
    if pose_fault(answers) is not None:
        return millimetres, float("nan")
    cosine = (np.einsum("kij,kij->k", answers[:, :3, :3], right[:, :3, :3]) - 1) / 2
    return millimetres, float(np.degrees(np.arccos(np.clip(cosine, -1, 1))).max())


def _special(here, there):
    """None when the special answers are right too."""
    if not any(there.off):
        return None
    wrong = there.among(True)
    place = where(here.kind, wrong, here.cases + there.among(False))
    place = f"where {place}" if place else f"at special ones: {_numbers_of(wrong[0], here.task)}"
    return Diagnosis(
        UNEXPLAINED,
        f"Right at general numbers, wrong {place}.",
        before=_residual(there.array, there.right),
        notes=(
            "Look for a special case in the program: an if, a division, a rounding of small"
            " numbers to 0, or a number of rows that is written in.",
        ),
    )


def _from_lists(f, here):
    """None when lists give what arrays give, or when the program asks for arrays."""
    if not here.task.is_chain or here.task.lists:
        return None
    rows, q = here.cases[0]
    call = here.task.arguments((rows.tolist(), q.tolist()))
    try:
        (answer,) = call_all(f, [call], (4, 4), here.task.names)
    except CallFault:
        return None
    if np.allclose(answer, here.right[0], rtol=here.tolerance, atol=here.tolerance):
        return None
    return Diagnosis(
        UNEXPLAINED,
        "Right when rows and q are arrays, wrong when the same numbers come as lists.",
        before=_residual(np.array([answer], dtype=float), here.right[:1]),
        notes=(
            "With lists + puts one behind the other and * repeats: begin with"
            " np.asarray(rows, dtype=float).",
        ),
    )


def _agrees(here):
    worst = float(np.abs(here.array - here.right).max())
    notes = []
    if worst > 1e-9:
        notes.append(f"Right to {worst:.0e}: the program computes in single precision.")
    if len(here.cases) < len(here.task.calls[0]):
        notes.append(f"It is slow, so that only {len(here.cases)} general calls were made.")
    if here.task.lists:
        notes.append("It takes lists only and stops when rows and q are arrays.")
    return Diagnosis(AGREES, "This program gives the right pose in every call.", notes=tuple(notes))
