"""The Mark of a program. It is called with the statements that it is seen to depend on and, where
that is not right, with its whole notebook.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from ...course.verdict import NOT_ATTEMPTED, RIGHT
from ..results.marks import ERROR, NOT_ALLOWED, TIMED_OUT, Mark
from .compared import compared, timed_out

if TYPE_CHECKING:
    from ...course.kinds import Function
    from ..settings import Settings
    from .asking import Asked

__all__ = ["ABSENT", "READ", "program"]

READ = "Run the notebook from top to bottom and read the last line of the message."
NUMPY = "Write it with numpy alone."
ABSENT = (
    "A module that it imports is not there where it is graded: write it with numpy alone, and put "
    "functions of your own into the notebook."
)
WITH_ALL = "right with its whole notebook, and not with what it is seen to depend on alone"


def program(
    exercise: Function, ask: Callable[..., tuple[Asked, int]], settings: Settings, worth: float
) -> Mark:
    """The Mark of a program; ``ask(whole=False)`` calls it, and gives what it gave and the seed of
    its inputs.

    Reading alone may miss a statement on which it depends. So one that is not right is called once
    more with its whole notebook, and what that gives counts where it is worth no less.
    """
    asked, number = ask()
    found = _called(exercise, asked, number, settings, worth)
    if found.status in (RIGHT, TIMED_OUT):
        return found
    whole, _ = ask(whole=True)
    if whole.stopped or _gave_the_same(asked, whole):
        return found
    again = _called(exercise, whole, number, settings, worth)
    # of one that stops with the whole notebook too, the cause is what it wants of dhlab
    caused = found.status == NOT_ALLOWED and whole.called.fault
    if again.status == RIGHT:
        return replace(again, note=WITH_ALL)
    return found if found.points > again.points or (caused and not again.points) else again


def _gave_the_same(asked, whole):
    """Whether a program gave the same both times; its mistake is then not looked for again, which
    is slow.
    """
    one, other = asked.called, whole.called
    if asked.stopped or one.fault or other.fault:
        return False
    return len(one.answers) == len(other.answers) and all(
        map(np.array_equal, (*one.answers, one.again), (*other.answers, other.again))
    )


def _called(exercise, asked, number, settings, worth):
    """The Mark of a program that was called."""
    if asked.stopped in ("timed out", "no time"):
        return timed_out(exercise, worth, begun=asked.stopped == "timed out")
    if asked.stopped == "stub":
        return Mark(exercise.id, NOT_ATTEMPTED, 0, worth)
    if asked.stopped == "crashed":
        headline = "the program ended itself while it was called"
        return Mark(exercise.id, ERROR, 0, worth, headline=headline, next=READ)
    if asked.stopped and not asked.closed:
        headline = "run with only the cells that it depends on, there is no program"
        next_ = "Define it at the top level of a cell, above its check."
        return Mark(exercise.id, ERROR, 0, worth, headline=headline, next=next_)
    found = (
        Mark(exercise.id, ERROR, 0, worth)
        if asked.stopped
        else compared(exercise, asked.called, number, settings, worth)
    )
    if found.status == RIGHT:
        return found
    if asked.closed:
        return _own(found, asked, settings)
    return _without(found, asked) if asked.absent else found


def _without(found, asked):
    """The Mark of a program that is not right without a package that is not there."""
    names = ", ".join(asked.absent)
    headline = f"this program uses a package that is not there where it is graded ({names})"
    return Mark(found.exercise, ERROR, 0, found.of, headline=headline, next=NUMPY)


def _own(found, asked, settings):
    """The Mark of a program that wants what it was to write, and is not right without it; the
    teacher may have set a share for it, which it earns when it is right with it.
    """
    earned = settings.own_kinematics * found.of if asked.right_with_library else 0
    return Mark(
        found.exercise,
        NOT_ALLOWED,
        round(earned, 4),
        found.of,
        headline=(
            f"this program uses dhlab's own programs ({', '.join(asked.closed)}); here the task is"
            " to write that yourself, and it is graded without them"
        ),
        next=f"{NUMPY[:-1]}; the library's answer is there to compare with.",
    )
