"""What share of its points an answer earns: what is wrong earns some only where it is work, and the
mistake in it one that was made.
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
    """The share of the points: all, none, or the teacher's share for a program or a table whose
    mistake is recognised and that is work all the same.
    """
    if verdict.status == RIGHT:
        return 1.0
    if verdict.status != WRONG or not verdict.mistake or not settings.partial:
        return 0.0
    # what is to be repaired has a mistake that is recognised when it is handed out
    if not isinstance(exercise, (Function, Table)) or exercise.handed_out:
        return 0.0
    if isinstance(exercise, Function):
        # nbgrader calls a program itself: there only its mistake is known
        computes = not isinstance(answer, Called) or _computes(exercise, answer, number)
        work = computes and not only_seen(verdict.mistake)
    else:
        work = _is_work(exercise, answer, number, verdict.mistake)
    return settings.partial if work else 0.0


def _computes(exercise, called, number):
    """Whether a program gives what is asked for, and something of its own: not the same whatever
    goes in, none of its arguments, and not what a program of the lesson gives.
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


def _is_work(exercise, answer, number, mistake):
    """Whether a table is in the convention that is asked, other numbers than those of the task or
    of an arm of the library, and not one to be copied that has several numbers that are no more
    than wrong. Where the mistake is what is to be found, no other is work.
    """
    if exercise.sparing or mistake == "another-model":
        return False
    right = exercise.right_arm(number)
    arm = exercise.arm_of(answer, right)
    if isinstance(arm, Verdict) or exercise.convention not in ("", arm.table.convention):
        return False
    rows = arm.to(right.table.convention).table.rows
    if _is_given(answer, rows, [*exercise.given(number).values(), *exercise.in_lesson]):
        return False
    if not isinstance(exercise, Copied) or not mistake.endswith("-value"):
        return True
    return bool(differing(arm.table.rows * IN_DEGREES, right.table.rows * IN_DEGREES).sum() <= 1)


def _is_given(answer, rows, given):
    """Whether each number of a table, ``rows`` in rad and m, is that of the task in its place, or
    0: so are the rows that the lesson's cell has filled in. A DHTable may say any unit of them.
    """
    read = [rows * IN_DEGREES]
    if isinstance(answer, (DHTable, Arm)):
        read += [rows, *(numbers * METRES_READ_AS_MM for numbers in (rows, rows * IN_DEGREES))]
    return any(
        not (differing(numbers, one) & (numbers != 0)).any()
        for one in _tables(given)
        for numbers in read
        if one.shape == rows.shape
    )


def _tables(given):
    """What is given as arrays; a table also as it is shown, in degrees."""
    for one in given:
        table = getattr(one, "table", one)
        if isinstance(table, DHTable):
            yield from (table.rows, table.rows * IN_DEGREES)
        else:
            yield as_numbers(one)


def _same(one, other):
    one, other = as_numbers(one), as_numbers(other)
    with np.errstate(all="ignore"):
        return one.shape == other.shape and np.allclose(one, other, equal_nan=True)
