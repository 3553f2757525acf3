"""``check`` in a graded cell of an nbgrader course: it says what the course says, and its value is
the points.
"""

import contextlib
import io
import warnings
from collections.abc import Callable
from typing import Any

from ...course.exercises import exercises
from ...course.kinds import Function
from ..judging.shares import share
from ..settings import Settings

__all__ = ["graded_check"]

FRESH = 2**31  # functions are graded on other inputs than the notebook's own check uses


def graded_check(points: float, partial: float = 0.0) -> Callable[..., Any]:
    """A ``check`` worth ``points``, by the rules of ``dhlab grade``, but for one: whether a program
    calls dhlab's own is not looked at, since here it runs beside them.

    nbgrader takes the cell's value for the points, and gives none where anything was written to the
    error stream: warnings and prints of the answer are kept out of the cell.

    Parameters
    ----------
    points : float
    partial : float
        The share for a program or a table whose mistake is recognised.

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
        with (
            contextlib.redirect_stdout(io.StringIO()),
            contextlib.redirect_stderr(io.StringIO()),
            warnings.catch_warnings(),
        ):
            warnings.simplefilter("ignore")
            number = FRESH if isinstance(exercise, Function) else 0
            verdict = exercise.judge(answer, number)
        print(verdict)
        earned = share(exercise, answer, number, verdict, Settings(partial=partial))
        return float(round(points * earned, 4))

    return check
