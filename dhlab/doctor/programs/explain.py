"""What is wrong with a program whose answers are known: one slip or two that give the same answers,
then what can be said in general.
"""

from dataclasses import replace

import numpy as np

from ..catalogue import catalogue
from ..finding import find
from ..mistakes.changes import PoseChange, Symptom
from ..mistakes.registry import changes
from .search.asarms import as_another_arm
from .search.slipsearch import search
from .wrong.branches import WRONG_BRANCHES
from .wrong.craig import WRONG_CRAIG, WRONG_CRAIG_PRODUCTS
from .wrong.errors import WRONG_ERRORS
from .wrong.jacobians import WRONG_JACOBIANS
from .wrong.links import WRONG_LINKS
from .wrong.moves import WRONG_COMPOSE, WRONG_ROT_X
from .wrong.products import WRONG_PRODUCTS
from .wrong.solvers import WRONG_SOLVERS

__all__ = ["explain_function", "explain_all", "hides_the_rest", "seen_in", "WRONG_VERSIONS"]

WRONG_VERSIONS = {
    "dh_transform": WRONG_LINKS,
    "forward_kinematics": WRONG_PRODUCTS,
    "rot_x": WRONG_ROT_X,
    "compose": WRONG_COMPOSE,
    "craig_transform": WRONG_CRAIG,
    "craig_kinematics": WRONG_CRAIG_PRODUCTS,
}
NUMBERS = {
    "jacobian": WRONG_JACOBIANS,
    "pose_error": WRONG_ERRORS,
    "inverse_kinematics": WRONG_SOLVERS,
    "branches": WRONG_BRANCHES,
}  # of no poses
WRONG_VERSIONS |= NUMBERS
AND = "; and "  # between the mistakes of a Finding's detail
PARAMETERS = ("theta", "d", "a", "alpha", "q")


def explain_function(answers, expected, cases, kind):
    """The mistake that explains the answers of a pose-valued program.

    Parameters
    ----------
    answers : sequence of arrays
        What the program gave, each as numpy holds it; not all right.
    expected : sequence of (4, 4) arrays
        What is right.
    cases : sequence of tuples
        The arguments of each call.
    kind : str
        A key of :data:`WRONG_VERSIONS`.

    Returns
    -------
    Finding or None
        The best one; ``detail`` names a second mistake where it takes two. None when nothing known
        explains the answers.

    Examples
    --------
    >>> from dhlab.doctor.programs.wrong.links import standard
    >>> from dhlab.transform import inverse
    >>> cases = [(0.3, 0.1, 0.4, 0.5), (1.1, -0.2, 0.3, -0.7)]
    >>> right = [standard(*case) for case in cases]
    >>> explain_function(inverse(right), right, cases, "dh_transform").mistake
    'pose-inverted'
    """
    findings = explain_all(answers, expected, cases, kind)
    if len(findings) < 2:
        return findings[0] if findings else None
    others = AND.join(_named(finding) for finding in findings[1:])
    return replace(findings[0], detail=others)


def _named(finding):
    return catalogue()[finding.mistake].title + (f" ({finding.place})" if finding.place else "")


def explain_all(answers, expected, cases, kind, tolerance=1e-9, symptoms=True, pairs=True):
    """All the mistakes that together explain the answers, a tuple of Findings; parameters as
    :func:`explain_function`. Without ``symptoms`` nothing is told that is only seen; without
    ``pairs`` no two slips are sought.
    """
    if kind in NUMBERS:
        found = _wrong_version(answers, cases, kind)
        return (found,) if found else ()
    if any(np.shape(answer) != (4, 4) for answer in answers):
        return (
            (find("last-row-missing"),)
            if all(np.shape(answer) == (3, 4) for answer in answers)
            else ()
        )
    answers, expected = np.array(answers), np.array(expected, dtype=float)
    if not answers.any() and not _same(answers, expected, tolerance):
        return (find("product-from-zeros"),)
    if answers.dtype.kind in "iub" and not _typed_in(answers, expected):
        return (find("integer-arrays"),)
    if _same(answers, expected, tolerance):
        return ()
    slips, look_alikes = _searched(answers, cases, kind, tolerance, pairs)
    if slips:
        return tuple(_finding(slip, look_alikes if len(slips) == 1 else ()) for slip in slips)
    one_row = as_another_arm(answers, cases, tolerance) if kind == "forward_kinematics" else None
    if one_row is not None:
        return (one_row,)
    topped = _with_right_last_row(answers, expected, tolerance)
    if topped is not None and (slips := _searched(topped, cases, kind, tolerance, pairs)[0]):
        return (find("last-row-missing"), *(_finding(slip, ()) for slip in slips))
    found = (
        _wrong_version(answers, cases, kind)
        or _changed_as_wholes(answers, expected, tolerance)
        or _symptom(answers, expected, kind, symptoms)
    )
    return (found,) if found else ()


def _typed_in(answers, expected):
    """Whether all answers are one array of whole numbers, and not what is left of the right ones
    when they are cut off.
    """
    return bool((answers == answers[0]).all()) and not (answers == np.trunc(expected)).all()


def hides_the_rest(findings):
    """Whether all that is found is an array of whole numbers: what else may be wrong is cut off
    with the digits.
    """
    return [finding.mistake for finding in findings] == ["integer-arrays"]


def _with_right_last_row(answers, expected, tolerance):
    """The answers with 0 0 0 1 below, None where they have it, or where nothing else is wrong."""
    topped = answers.astype(float)
    topped[..., 3, :] = [0, 0, 0, 1]
    return (
        None if _same(topped, answers, tolerance) or _same(topped, expected, tolerance) else topped
    )


def _searched(answers, cases, kind, tolerance, pairs):
    return (
        search(answers, cases, kind, tolerance, pairs)
        if kind in ("dh_transform", "forward_kinematics")
        else ((), ())
    )


def _finding(slip, look_alikes):
    parameter = slip.place if slip.place in PARAMETERS else None
    return find(slip.mistake, slip.place, parameter=parameter, look_alikes=look_alikes)


def _is_of_links(symptom, kind):
    """Whether a symptom tells of the formula of a link, and these are chains."""
    return symptom.mistake == "matrix-entry-mistyped" and kind.endswith("kinematics")


def _wrong_version(answers, cases, kind):
    if kind in ("dh_transform", "forward_kinematics"):
        return None  # the search has seen them all
    with np.errstate(all="ignore"):
        for mistake, place, version in WRONG_VERSIONS.get(kind, ()):
            if all(_same(version(*case), answer) for case, answer in zip(cases, answers)):
                return find(mistake, place)
    return None


def _same(a, b, tolerance=1e-9):
    """``np.allclose`` in less than half of its time: wrong versions are many."""
    b = np.asarray(b) * 1.0  # of truth values as well
    if not np.isfinite(b).all():
        return np.allclose(a, b, rtol=tolerance, atol=tolerance)
    return bool((np.abs(a - b) <= tolerance * (1 + np.abs(b))).all())


def _changed_as_wholes(answers, expected, tolerance):
    """The answers are the right poses, changed as wholes, whatever program made them."""
    for change in changes(PoseChange):
        if _same(answers, change.change(expected), tolerance):
            return find(change.mistake)
    return None


def seen_in(answers, expected, kind):
    """What answers look like that no mistake explains, a Finding or None."""
    return _symptom(answers, expected, kind, True)


def _symptom(answers, expected, kind, all_of_them):
    """What the answers look like, the right ones beside them first; what explains them alone, or
    all of them.
    """
    for symptom in sorted(changes(Symptom), key=lambda symptom: symptom.alone):
        if not (symptom.explains or all_of_them) or _is_of_links(symptom, kind):
            continue
        place = symptom.look(answers, expected)
        if place is not None:
            return find(symptom.mistake, place)
    return None
