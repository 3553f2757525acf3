"""The answers of a program beside the right ones, and what can be said of the difference."""

import numpy as np

from ...transform import pose_fault
from ..catalogue import catalogue
from ..diagnosis import AGREES, EXPLAINED, UNEXPLAINED, Diagnosis
from ..finding import find
from .cases import is_long, where
from .explain import explain_all, seen_in
from .running.answers import call_all
from .running.calling import CallFault
from .search.ends import at_the_ends
from .source.precision import SINGLE

__all__ = [
    "EXACT",
    "UNKNOWN",
    "Answers",
    "agrees",
    "compared",
    "explained",
    "explains",
    "from_lists",
    "residual",
    "special",
]

EXACT = 1e-6  # largest deviation of an agreeing answer, absolute and relative
UNKNOWN = "No known mistake"


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


def compared(here, there, pairs=True):
    """None when all general answers are right, otherwise the diagnosis; ``pairs`` as for
    :func:`explained`.
    """
    if not any(here.off):
        return None
    before = residual(here.array, here.right)
    if _remembered(here.given, here.cases, here.off):
        headline = (
            "One mistake is seen at once: the program gives an earlier call's answer again. Whether"
            " it is the only one shows when it is mended."
        )
        return Diagnosis(EXPLAINED, headline, (find("state-between-calls"),), before=before)
    findings = explained(here, pairs, there)
    if findings:
        return explains(findings, before)
    seen = seen_in(here.task.bare(here.array), here.task.bare(here.right), here.task.versions)
    findings = (seen,) if seen else ()
    notes = _hints(here, there)
    return Diagnosis(UNEXPLAINED, _unexplained(here), findings, before=before, notes=notes)


def explains(findings, before):
    """The diagnosis that findings together are."""
    return Diagnosis(EXPLAINED, _headline(findings), findings, before=before)


def explained(here, pairs=True, there=None):
    """The mistakes that together explain the answers, and those of the special calls ``there`` in
    which a length is long; without ``pairs`` no two slips.
    """
    tolerance = here.tolerance if here.tolerance == SINGLE else 1e-9
    task, bare = here.task, here.task.bare
    chains, given = bare(here.right), here.given
    if task.arm is not None:
        found = at_the_ends(here.array, chains, task.arm.base, task.arm.tool, tolerance)
        if found is not None:
            return (found,)
        given = list(bare(here.array))
    cases = list(here.cases)
    for k, case in enumerate(there.cases if there is not None and task.arm is None else ()):
        if is_long(case):
            cases.append(case)
            given = [*given, there.given[k]]
            chains = np.concatenate([chains, there.right[k : k + 1]])
    return explain_all(given, chains, cases, task.versions, tolerance, symptoms=False, pairs=pairs)


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
    if len(titles) == 1 and findings[0].place.count("column") > 1:  # each entry is a mistake
        return f"Mistakes of one kind together explain what this program answers: {titles[0]}."
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


def residual(answers, right):
    """Largest deviation in mm and degrees; the angle is NaN where the answer is no pose."""
    millimetres = 1000 * float(np.linalg.norm(answers[:, :3, 3] - right[:, :3, 3], axis=-1).max())
    if pose_fault(answers) is not None:
        return millimetres, float("nan")
    cosine = (np.einsum("kij,kij->k", answers[:, :3, :3], right[:, :3, :3]) - 1) / 2
    return millimetres, float(np.degrees(np.arccos(np.clip(cosine, -1, 1))).max())


def special(here, there):
    """None when the special answers are right too."""
    if not any(there.off):
        return None
    wrong = there.among(True)
    place = where(here.kind, wrong, here.cases + there.among(False))
    place = f"where {place}" if place else f"at special ones: {_numbers_of(wrong[0], here.task)}"
    return Diagnosis(
        UNEXPLAINED,
        f"Right at general numbers, wrong {place}.",
        before=residual(there.array, there.right),
        notes=(
            "Look for a special case in the program: an if, a division, a rounding of small"
            " numbers to 0, or a number of rows that is written in.",
        ),
    )


def from_lists(f, here):
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
        before=residual(np.array([answer], dtype=float), here.right[:1]),
        notes=(
            "With lists + puts one behind the other and * repeats: begin with"
            " np.asarray(rows, dtype=float).",
        ),
    )


def agrees(here):
    worst = float(np.abs(here.array - here.right).max())
    notes = []
    if worst > 1e-9:
        notes.append(f"Right to {worst:.0e}: the program computes in single precision.")
    if len(here.cases) < len(here.task.calls[0]):
        notes.append(f"It is slow, so that only {len(here.cases)} general calls were made.")
    if here.task.lists:
        notes.append("It takes lists only and stops when rows and q are arrays.")
    return Diagnosis(AGREES, "This program gives the right pose in every call.", notes=tuple(notes))
