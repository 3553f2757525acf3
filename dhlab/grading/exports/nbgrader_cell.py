"""``check`` in a graded cell of an nbgrader course: it says what the course says, and its value is
the points.
"""

import contextlib
import functools
import io
import warnings
from collections.abc import Callable
from typing import Any

from ...course.exercises import exercises
from ...course.kinds import Function, Table
from ...course.verdict import NOT_ATTEMPTED, WRONG
from ...doctor.programs.calling import is_stub
from ..inside.watch import library
from ..judging.questions import fresh

__all__ = ["graded_check"]


def graded_check(
    points: float, partial: float = 0.0, own_kinematics: float = 0.0
) -> Callable[..., Any]:
    """A ``check`` worth ``points``, by the rules of ``dhlab grade``.

    nbgrader takes the cell's value for the points, and gives none where anything was written to the
    error stream: warnings and prints of the answer are kept out of the cell.

    Parameters
    ----------
    points : float
    partial : float
        The share for a program or a table whose mistake is recognised.
    own_kinematics : float
        The share for a function that calls the library's kinematics where it is to be written.

    Examples
    --------
    >>> check = graded_check(3)
    >>> check("05.2", "b")
    ✓ 05.2  Right: Turn and shift about one axis commute, and so do two shifts: five of the 24
    orders are right.
    3.0
    """

    def check(exercise_id, answer):
        exercise = exercises()[exercise_id]
        used: set[str] = set()
        with (
            contextlib.redirect_stdout(io.StringIO()),
            contextlib.redirect_stderr(io.StringIO()),
            warnings.catch_warnings(),
        ):
            warnings.simplefilter("ignore")
            verdict = exercise.judge(_watched(exercise, answer, used), fresh(0, exercise))
        print(verdict)
        share = verdict.points / verdict.of if verdict.of else 0
        if verdict.status == WRONG and verdict.mistake and isinstance(exercise, (Function, Table)):
            share = partial
        if used and verdict.status != NOT_ATTEMPTED:
            print(
                f"  But the function calls dhlab's own programs ({', '.join(sorted(used))}); here"
                " the task is to write that yourself."
            )
            share *= own_kinematics
        return float(round(points * share, 4))

    return check


def _watched(exercise, answer, used):
    """The answer; a function notes in ``used`` which of the library's programs it calls."""
    if not isinstance(exercise, Function) or not callable(answer) or is_stub(answer):
        return answer

    @functools.wraps(answer)
    def call(*arguments):
        with library(None if getattr(exercise, "library", False) else [exercise.family]) as found:
            try:
                return answer(*arguments)
            finally:
                used.update(found)

    return call
