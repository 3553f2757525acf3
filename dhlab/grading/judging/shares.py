"""What share of its points an answer earns. A wrong one earns some (``partial`` in the settings)
only for the student's own work, with one mistake that is recognised.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ...arm import Arm
from ...course.kinds import Function, Table
from ...course.kinds.reading import as_numbers
from ...course.kinds.tabled.arms import IN_DEGREES
from ...course.kinds.tabled.copied import Copied
from ...course.kinds.tabled.entries import differing
from ...course.verdict import RIGHT, WRONG, Verdict
from ...doctor.mistakes.registry import only_seen
from ...doctor.programs.running.calling import Called
from ...table import DHTable

if TYPE_CHECKING:
    from ...course.kinds.exercise import Exercise
    from ..settings import Settings

__all__ = ["share"]

METRES_READ_AS_MM = np.array([1, 1000, 1000, 1])


def share(
    exercise: Exercise, answer: Any, number: int, verdict: Verdict, settings: Settings
) -> float:
    """The share of the points: all, none, or ``settings.partial`` for a program or a table that is
    the student's own work and whose mistake is recognised.
    """
    if verdict.status == RIGHT:
        return 1.0
    if verdict.status != WRONG or not verdict.mistake or not settings.partial:
        return 0.0
    # what is to be repaired is handed out with a mistake that is recognised
    if not isinstance(exercise, (Function, Table)) or exercise.handed_out:
        return 0.0
    if isinstance(exercise, Function):
        # in nbgrader's cell the answer is the program itself: only its mistake is known there
        computes = not isinstance(answer, Called) or _computes(exercise, answer, number)
        work = computes and not only_seen(verdict.mistake)
    else:
        work = _is_own_table(exercise, answer, number, verdict.mistake)
    return settings.partial if work else 0.0


def _computes(exercise, called, number):
    """Whether a program gives results of the shape that is asked for, and computes them: they are
    not all the same, none of its arguments, and not those of a program that the lesson shows.
    """
    given = called.answers
    if called.fault or any(as_numbers(one).shape != exercise.shape for one in given):
        return False
    if all(_same(one, given[0]) for one in given):
        return False
    cases = exercise.cases(number)
    shown = [[program(*case) for case in cases] for program in exercise.in_lesson]
    return not any(
        all(_same(one, other) for one, other in zip(given, others))
        for others in [*zip(*cases), *shown]
    )


def _is_own_table(exercise, answer, number, mistake):
    """Whether a wrong table is the student's own work."""
    # where the mistake is what is to be found, the table was handed out; another-model is an arm of
    # the library in the place of one's own
    if exercise.sparing or mistake == "another-model":
        return False
    right = exercise.right_arm(number)
    arm = exercise.arm_of(answer, right)
    if isinstance(arm, Verdict) or exercise.convention not in ("", arm.table.convention):
        return False
    shown = [*exercise.given(number).values(), *exercise.in_lesson]
    if _is_shown(answer, arm.to(right.table.convention).table.rows, shown):
        return False
    if isinstance(exercise, Copied) and mistake.endswith("-value"):  # a number that is only wrong
        wrong = differing(arm.table.rows * IN_DEGREES, right.table.rows * IN_DEGREES)
        return bool(wrong.sum() <= 1)
    return True


def _is_shown(answer, rows, shown):
    """Whether a table is one that the task or the lesson shows: each of its numbers stands in that
    one at the same place, or is 0, as in the row that the lesson's cell has filled in.

    ``rows`` are those of the answer in rad and m. The units of a DHTable are the student's to name,
    so its numbers are compared as if they had been read in any.
    """
    read = [rows * IN_DEGREES]
    if isinstance(answer, (DHTable, Arm)):
        read += [rows, *(numbers * METRES_READ_AS_MM for numbers in (rows, rows * IN_DEGREES))]
    return any(
        not (differing(numbers, one) & (numbers != 0)).any()
        for one in _tables(shown)
        for numbers in read
        if one.shape == rows.shape
    )


def _tables(shown):
    """What is shown as arrays; a table of dhlab's in radians and in degrees."""
    for one in shown:
        table = getattr(one, "table", one)
        if isinstance(table, DHTable):
            yield from (table.rows, table.rows * IN_DEGREES)
        else:
            yield as_numbers(one)


def _same(one, other):
    one, other = as_numbers(one), as_numbers(other)
    with np.errstate(all="ignore"):
        return one.shape == other.shape and np.allclose(one, other, equal_nan=True)
