"""The Mark of an answer that is compared with what is right; that of one that took too long."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ...course.verdict import RECORDED
from ..results.marks import ERROR, TIMED_OUT, TO_MARK, Mark
from .shares import share

if TYPE_CHECKING:
    from ...course.kinds.exercise import Exercise
    from ..settings import Settings

__all__ = ["TEXT", "compared", "timed_out"]

TEXT = 300  # characters of a note for the teacher


def compared(
    exercise: Exercise, answer: Any, number: int, settings: Settings, worth: float
) -> Mark:
    """The Mark of an answer, compared with what is right for a number."""
    try:
        with np.errstate(all="ignore"):  # numbers that overflow are nothing to warn the teacher of
            verdict = exercise.judge(answer, number)
    except Exception as error:  # a fault of ours: shown to the teacher, never a silent 0
        headline = "this answer could not be compared; your teacher will look at it"
        note = f"the judge stopped with {type(error).__name__}: {error}"[:TEXT]
        return Mark(exercise.id, ERROR, 0, worth, headline=headline, note=note)
    earned = share(exercise, answer, number, verdict, settings)
    return Mark(
        exercise.id,
        TO_MARK if verdict.status == RECORDED else verdict.status,
        round(earned * worth, 4),
        worth,
        verdict.mistake,
        verdict.headline,
        verdict.place,
        verdict.why,
        verdict.next,
        chosen=verdict.chosen,
    )


def timed_out(exercise: Exercise, worth: float, begun: bool = True) -> Mark:
    """The Mark of what did not come to an end, or was not ``begun`` any more."""
    headline = "this took too long and was stopped"
    if not begun:
        headline = "this program was not called: those before it had taken all the time there is"
    next_ = "Look for a loop that never ends."
    return Mark(exercise.id, TIMED_OUT, 0, worth, headline=headline, next=next_)
