"""Whose numbers a student's wrong answers are right for, when that is no accident.

Some exercises have a handful of right values, so that in a large class any answer is right for
somebody. Each fitting exercise therefore counts by how rarely a stranger's numbers would fit it,
and nobody is named unless a class of strangers would hardly ever fit as well.
"""

from collections.abc import Iterable
from typing import Any

import numpy as np

from ...course.kinds import Value
from ...course.verdict import WRONG
from ..inside.wire import DECODED, decode
from ..results.marks import Mark
from .judge import Answers
from .questions import Course

__all__ = ["borrowed_from"]

# that a class in which nobody copied has somebody who fits a given student's wrong answers as well
# as this
CHANCE = 0.01
# numbers from which it is estimated how many values an exercise has; they come from the class and,
# where it is small, are drawn
DRAWS = 300
GRAIN = 1e-3  # of the logarithm of a chance


def borrowed_from(
    course: Course, student: str, answers: Answers, marks: Iterable[Mark]
) -> str | None:
    """The student for whose numbers this one's wrong answers are right, or None when nobody fits,
    several fit alike, or chance explains it.

    Parameters
    ----------
    course : Course
    student : str
    answers : Answers
    marks : iterable of Mark

    Returns
    -------
    str or None
    """
    own = course.variants.get(student)
    others = {
        other: variant
        for other, variant in course.variants.items()
        if other != student and variant != own
    }
    wrong = {mark.exercise for mark in marks if mark.status == WRONG}
    asked = [
        (exercise, given)
        for exercise in course.exercises
        if isinstance(exercise, Value)
        and exercise.id in wrong
        and (given := _last(answers, exercise)) is not None
    ]
    fits = np.array(
        [_is_right(exercise, tuple(others.values()), given) for exercise, given in asked]
    )
    if not fits.any():
        return None
    rare = np.array(
        [_share(exercise, given, right) for (exercise, given), right in zip(asked, fits)]
    )
    evidence = -np.log(rare) @ fits
    if np.sum(evidence == evidence.max()) > 1 or len(others) * _tail(rare, evidence.max()) > CHANCE:
        return None
    return list(others)[evidence.argmax()]


def _last(answers, exercise):
    try:
        return np.asarray(decode(answers.notes[exercise.id][-1][0]["value"]), dtype=float)
    except DECODED:
        return None


def _is_right(exercise, variants, given):
    """For which of the variants the answer is right."""
    expected = np.array([_expected(exercise, variant) for variant in variants])
    if not variants or given.shape != expected.shape[1:]:
        return np.zeros(len(variants), dtype=bool)
    return ~exercise.differs(given, expected).reshape(len(variants), -1).any(axis=1)


def _share(exercise, given, fits):
    """How many of all variants the answer is right for, as a share; never 0, since only some were
    looked at.
    """
    drawn = _is_right(exercise, tuple(range(1, 1 + max(0, DRAWS - len(fits)))), given)
    return (1 + fits.sum() + drawn.sum()) / (1 + len(fits) + len(drawn))


_known: dict[tuple[str, int], Any] = {}


def _expected(exercise, variant):
    """The right value of a variant, computed once."""
    if (exercise.id, variant) not in _known:
        _known[exercise.id, variant] = np.asarray(
            exercise.answer(**exercise.given(variant)), dtype=float
        )
    return _known[exercise.id, variant]


def _tail(rare, evidence):
    """The chance that a stranger's numbers fit at least this well: over all sets of exercises that
    they could fit, each with its own chance. There are 2**n sets: those of one sum, but for a
    grain, count together.
    """
    steps = np.round(-np.log(rare) / GRAIN).astype(int)
    chances = np.zeros(1 + steps.sum())
    chances[0] = 1
    for p, step in zip(rare, steps):
        fits = np.roll(chances, step) * p
        chances = chances * (1 - p) + fits
    least = int(evidence / GRAIN) - len(steps)  # what rounding may have taken is given back
    return chances[max(0, least) :].sum()
