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
from .answers import answers_in_time, call_all, single_precision
from .calling import CallFault, is_stub
from .cases import SPECIAL, general_chain, general_row, where
from .explain import explain_all
from .wrong.links import standard
from .wrong.products import product

__all__ = ["diagnose_function"]

NAMES = {"dh_transform": ("theta", "d", "a", "alpha"), "forward_kinematics": ("rows", "q")}
RIGHT = {"dh_transform": standard, "forward_kinematics": product}
SEED = 4
CALLS = 16
# rows of the chains, so that no program can be right for one length alone
LINKS = (2, 3, 4, 5, 6, 3, 7, 4, 2, 5, 3, 6)
LEAST_CALLS = min(CALLS, len(LINKS))
# largest deviation of an agreeing answer, absolute and relative; the second in single precision
EXACT, SINGLE = 1e-6, 1e-5


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
    try:
        return _diagnosed(f, kind)
    except NotImplementedError:
        return Diagnosis(
            UNEXPLAINED, "Nothing is written in this function yet: it raises NotImplementedError."
        )
    except CallFault as fault:
        return _stopped(fault)
    except KeyboardInterrupt:
        return Diagnosis(UNEXPLAINED, "You interrupted the search before it came to an end.")


def _diagnosed(f, kind):
    """The diagnosis of a function that is called here."""
    cases, special = _cases(kind)
    cases, answers = answers_in_time(f, cases, (4, 4), NAMES[kind])
    special, answers_there = answers_in_time(f, special, (4, 4), NAMES[kind])
    single = single_precision(f, answers)
    here, there = (
        Answers(*part, kind, single) for part in ((cases, answers), (special, answers_there))
    )
    steps = (_compared(here, there), _special(here, there), _from_lists(f, here), _agrees(here))
    return next(
        diagnosis for diagnosis in steps if diagnosis is not None
    )  # not "or": a diagnosis of something wrong is false


class Answers:
    """What a program answered, beside what is right.

    ``cases`` are the calls, ``given`` the answers (m, 4, 4), ``right`` the right ones, ``off``
    whether each call went wrong, ``tolerance`` the largest deviation of one that did not.
    """

    def __init__(self, cases, given, kind, single):
        self.cases, self.kind = cases, kind
        self.given = given
        self.right = np.array([RIGHT[kind](*case) for case in cases])
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


@cache
def _cases(kind):
    """General calls and special ones."""
    rng = np.random.default_rng(SEED)
    if kind == "dh_transform":
        return [general_row(rng) for _ in range(CALLS)], SPECIAL[kind]
    return [general_chain(rng, n) for n in LINKS], SPECIAL[kind]


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
    tolerance = here.tolerance if here.tolerance == SINGLE else 1e-9
    findings = explain_all(here.given, here.right, here.cases, here.kind, tolerance)
    if findings and not only_seen(findings[0].mistake):
        return Diagnosis(EXPLAINED, _headline(findings), findings, before=before)
    return Diagnosis(
        UNEXPLAINED, _unexplained(here), findings, before=before, notes=_hints(here, there)
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
        f"No known mistake explains the answers: {what} wrong in {sum(here.off)} of"
        f" {len(here.off)} calls."
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
            f"Right in {right} calls; wrong at {_numbers_of(here.among(True)[0], here.kind)}. Look"
            " for an if, or for a sign that abs or sqrt took away."
        )
    return tuple(notes)


def _numbers_of(case, kind):
    """The arguments of a call, where they are few enough to be read."""
    if kind == "dh_transform":
        return ", ".join(f"{name} = {value:.3g}" for name, value in zip(NAMES[kind], case))
    return f"{len(case[1])} rows"


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
    place = f"where {place}" if place else f"at special ones: {_numbers_of(wrong[0], here.kind)}"
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
    if here.kind != "forward_kinematics":
        return None
    rows, q = here.cases[0]
    try:
        (answer,) = call_all(f, [(rows.tolist(), q.tolist())], (4, 4), NAMES[here.kind])
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
    if len(here.cases) < LEAST_CALLS:
        notes.append(f"It is slow, so that only {len(here.cases)} general calls were made.")
    return Diagnosis(AGREES, "This program gives the right pose in every call.", notes=tuple(notes))
