"""``diagnose_function``: a learner's function called on seeded numbers, compared with the right
one, and what is wrong with it in words.
"""

from functools import cache

import numpy as np

from ...transform import pose_fault
from ..catalogue import catalogue
from ..diagnosis import AGREES, EXPLAINED, UNEXPLAINED, Diagnosis
from ..finding import find
from ..mistakes.registry import only_seen
from .calling import CallFault, call_all, is_stub
from .cases import SPECIAL, general_chain, general_row
from .explain import explain_all
from .wrong.links import standard
from .wrong.products import product

__all__ = ["diagnose_function"]

NAMES = {"dh_transform": ("theta", "d", "a", "alpha"), "forward_kinematics": ("rows", "q")}
RIGHT = {"dh_transform": standard, "forward_kinematics": product}
SEED = 4
CALLS = 16
LINKS = (
    2,
    3,
    4,
    5,
    6,
    3,
    7,
    4,
    2,
    5,
    3,
    6,
)  # rows of the chains, so that no program can be right for one length alone
EXACT, SINGLE = (
    1e-6,
    1e-5,
    # largest deviation of an agreeing answer, absolute and relative; the second where it comes in
    # single precision
)


def diagnose_function(f, kind):
    """What is wrong with a program for forward kinematics, found by calling it.

    The function is called in this process, on seeded general numbers and on a few special ones
    (zeros, right angles), on copies, and twice with the same. Right answers agree in any dress:
    lists, tuples, ``np.matrix``, within 1e-6 (1e-5 where they are ``float32``).

    Parameters
    ----------
    f : callable
        ``dh_transform(theta, d, a, alpha)`` or ``forward_kinematics(rows, q)``: radians and metres,
        standard convention; ``rows`` (n, 4) holds theta offset, d, a, alpha, ``q`` (n,) the joint
        values; the answer is a pose (4, 4).
    kind : "dh_transform" or "forward_kinematics"

    Returns
    -------
    Diagnosis
        ``verdict`` is "agrees", "explained" (one finding, or two mistakes that explain the answers
        together) or "unexplained".

    Raises
    ------
    ValueError
        ``f`` is no function, or the kind is unknown. What ``f`` itself raises is caught and put
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
    if kind not in NAMES:
        raise ValueError(
            'diagnose_function: expected the kind "dh_transform" or "forward_kinematics", found'
            f" {kind!r}; say what f computes"
        )
    if not callable(f):
        raise ValueError(
            f"diagnose_function: expected a function, found {type(f).__name__}; hand in its name"
            " without brackets"
        )
    if is_stub(f):
        return Diagnosis(UNEXPLAINED, "Nothing is written in this function yet.")
    cases, special = _cases(kind)
    try:
        answers = call_all(f, cases, (4, 4), NAMES[kind])
        answers_there = call_all(f, special, (4, 4), NAMES[kind])
    except NotImplementedError:
        return Diagnosis(
            UNEXPLAINED, "Nothing is written in this function yet: it raises NotImplementedError."
        )
    except CallFault as fault:
        return _stopped(fault)
    steps = (
        _compared(answers, cases, kind),
        _special(answers_there, special, kind),
        _agrees(answers, cases, kind),
    )
    return next(
        diagnosis for diagnosis in steps if diagnosis is not None
    )  # not "or": a diagnosis of something wrong is false


@cache
def _cases(kind):
    """General calls and special ones."""
    rng = np.random.default_rng(SEED)
    if kind == "dh_transform":
        return [general_row(rng) for _ in range(CALLS)], SPECIAL[kind]
    rows, q = SPECIAL[kind][0]
    return [general_chain(rng, n) for n in LINKS], (*SPECIAL[kind], (rows[:1], q[:1]))


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


def _tolerance(answers):
    return SINGLE if all(answer.dtype == np.float32 for answer in answers) else EXACT


def _off(answers, right, tolerance):
    return [
        not np.allclose(answer, pose, rtol=tolerance, atol=tolerance)
        for answer, pose in zip(answers, right)
    ]


def _compared(answers, cases, kind):
    """None when all general answers are right, otherwise the diagnosis."""
    right = np.array([RIGHT[kind](*case) for case in cases])
    off = _off(answers, right, _tolerance(answers))
    if not any(off):
        return None
    before = _residual(np.array(answers, dtype=float), right)
    if _remembered(answers, cases, off):
        headline = (
            "One mistake explains what this program does: it gives an earlier call's answer again."
        )
        return Diagnosis(EXPLAINED, headline, (find("state-between-calls"),), before=before)
    findings = explain_all(
        answers, right, cases, kind, _tolerance(answers) if answers[0].dtype == np.float32 else 1e-9
    )
    if findings and not only_seen(findings[0].mistake):
        return Diagnosis(EXPLAINED, _headline(findings), findings, before=before)
    return Diagnosis(
        UNEXPLAINED,
        _unexplained(answers, right, off),
        findings,
        before=before,
        notes=_hints(answers, right, cases, off, kind),
    )


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


def _unexplained(answers, right, off):
    if all(np.array_equal(answer, answers[0]) for answer in answers):
        return "The answer is the same whatever goes in, and no known mistake explains it."
    difference = np.abs(np.array(answers) - right).max(axis=0)
    rotation, position = difference[:3, :3].max() > EXACT, difference[:3, 3].max() > EXACT
    words = {
        (True, True): "rotation and position are",
        (True, False): "the rotation is",
        (False, True): "the position is",
        (False, False): "the last row is",
    }
    what = words[bool(rotation), bool(position)]
    return f"No known mistake explains the answers: {what} wrong in {sum(off)} of {len(off)} calls."


def _hints(answers, right, cases, off, kind):
    """What can be said of answers that no known mistake explains."""
    fault = pose_fault(np.array(answers, dtype=float))
    notes = [f"Not every answer is a pose: {fault}."] if fault else []
    if 0 < sum(off) < len(off):
        k = off.index(True)
        numbers = (
            ", ".join(f"{name} = {value:.3g}" for name, value in zip(NAMES[kind], cases[k]))
            if kind == "dh_transform"
            else ""
        )
        shown = numbers or f"{len(cases[k][1])} rows"
        notes.append(
            f"Right in {len(off) - sum(off)} calls; wrong at {shown}. Look for an if, or for a sign"
            " that abs or sqrt took away."
        )
    return tuple(notes)


def _residual(answers, right):
    """Largest deviation in mm and degrees; the angle is NaN where the answer is no pose."""
    millimetres = 1000 * float(np.linalg.norm(answers[:, :3, 3] - right[:, :3, 3], axis=-1).max())
    if pose_fault(answers) is not None:
        return millimetres, float("nan")
    cosine = (np.einsum("kij,kij->k", answers[:, :3, :3], right[:, :3, :3]) - 1) / 2
    return millimetres, float(np.degrees(np.arccos(np.clip(cosine, -1, 1))).max())


def _special(answers, cases, kind):
    """None when the special answers are right too."""
    right = np.array([RIGHT[kind](*case) for case in cases])
    off = _off(answers, right, _tolerance(answers))
    if not any(off):
        return None
    return Diagnosis(
        UNEXPLAINED,
        "Right at general numbers, wrong where angles are 0 or 90° or there is one row only.",
        before=_residual(np.array(answers, dtype=float), right),
        notes=(
            (
                "Look for a special case in the program: an if, a division, or a rounding of small"
                " numbers to 0."
            ),
        ),
    )


def _agrees(answers, cases, kind):
    right = np.array([RIGHT[kind](*case) for case in cases])
    worst = float(np.abs(np.array(answers, dtype=float) - right).max())
    notes = (
        (f"Right to {worst:.0e}: the program computes in single precision.",)
        if worst > 1e-9
        else ()
    )
    return Diagnosis(AGREES, "This program gives the right pose in every call.", notes=notes)
