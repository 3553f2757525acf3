"""From the lines that came out of the cage to marks. Everything here happens outside, and nothing
that came out is trusted.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ...course.kinds import Function, Table
from ...course.verdict import NOT_ATTEMPTED, RIGHT, WRONG
from ...doctor import catalogue
from ...doctor.programs.calling import Called, CallFault
from ..inside.wire import DECODED, decode
from ..results.marks import ERROR, NOT_ALLOWED, TIMED_OUT, Mark
from .questions import fresh

if TYPE_CHECKING:
    from ...course.kinds.exercise import Exercise
    from ..cage.listener import Run
    from ..settings import Settings
    from .questions import Course
    from .work import Handed

__all__ = ["mark", "Answers"]

TEXT = 300


class Answers:
    """What one student's notebooks sent: the notes of each exercise, in order, and what happened to
    the cells.
    """

    def __init__(self) -> None:
        self.notes: dict[str, list[tuple[dict[str, Any], Handed]]] = {}
        self.troubles: dict[str, tuple[str, str]] = {}
        self.ids: dict[int, list[str]] = {}
        # how the last run of a notebook ended, when that was before its end
        self.cut: str | None = None

    def add(self, run: Run, handed: Handed) -> None:
        """Take in one run of one notebook, a Handed."""
        for line in run.lines:
            if isinstance(line.get("check"), str):
                self.notes.setdefault(line["check"], []).append((line, handed))
            ids = (
                [key for key in line.get("ids", ()) if isinstance(key, str)]
                if isinstance(line.get("ids", ()), list)
                else []
            )
            if line.get("ended") in ("error", "timed out"):
                self._trouble(ids, line["ended"], line.get("message"))
            elif "cell" in line and isinstance(line["cell"], int):
                self.ids[line["cell"]] = ids
        self.cut = None if run.ended == "done" else run.ended
        if self.cut and run.cell is not None:
            self._trouble(self.ids.get(run.cell, ()), run.ended, "")

    def _trouble(self, ids, kind, message):
        for key in ids:
            self.troubles.setdefault(
                key, (kind, message[:TEXT] if isinstance(message, str) else "")
            )


def mark(
    exercise: Exercise, answers: Answers, variant: int, settings: Settings
) -> tuple[Mark, Handed | None]:
    """(Mark, the notebook it comes from) of one exercise: the last attempt that was noted counts.

    Parameters
    ----------
    exercise : Exercise
    answers : Answers
    variant : int
    settings : Settings

    Returns
    -------
    Mark, Handed or None
    """
    worth = settings.points(exercise)
    for line, handed in reversed(answers.notes.get(exercise.id, ())):
        found = _judged(exercise, line, variant, settings, worth)
        if found.status != NOT_ATTEMPTED:
            return found, handed
    return _without_answer(exercise, answers, worth), None


def _judged(exercise, line, variant, settings, worth):
    if "stopped" in line:
        return _timed_out(exercise, worth)
    try:
        answer = _answer(line, exercise)
    except DECODED:
        headline = (
            "the answer cannot be read: give plain numbers, text, a list, a table or a function"
        )
        return Mark(exercise.id, WRONG, 0, worth, headline=headline)
    try:
        verdict = exercise.judge(answer, fresh(variant, exercise))
    except Exception as error:  # a fault of ours: shown to the teacher, never a silent 0
        headline = "this answer could not be compared; your teacher will look at it"
        note = f"the judge stopped with {type(error).__name__}: {error}"[:TEXT]
        return Mark(exercise.id, ERROR, 0, worth, headline=headline, note=note)
    found = Mark(
        exercise.id,
        verdict.status,
        round(_share(exercise, verdict, settings) * worth, 4),
        worth,
        verdict.mistake,
        verdict.headline,
        verdict.place,
        verdict.why,
        verdict.next,
        chosen=verdict.chosen,
    )
    used = _used(line)
    if used and isinstance(exercise, Function) and verdict.status != NOT_ATTEMPTED:
        return _own(found, used, settings)
    return found


def _used(line):
    """The library's programs that were called for an answer."""
    used = line.get("used", ())
    return [name for name in used if isinstance(name, str)] if isinstance(used, list) else []


def _answer(line, exercise):
    """The answer in a line: a value, or what a function gave."""
    if "calls" in line and isinstance(exercise, Function):
        calls = [decode(value) for value in line["calls"]]
        if len(calls) != len(exercise.cases(0)):
            raise ValueError("expected an answer to every call")
        return Called(tuple(calls), decode(line["again"]))
    if "fault" in line and isinstance(exercise, Function):
        headline, place, next_, mistake = (str(text)[:TEXT] for text in line["fault"])
        return Called(
            fault=CallFault(headline, place, next_, mistake if mistake in catalogue() else None)
        )
    return decode(line["value"])


def _share(exercise, verdict, settings):
    """The share of the points: all, none, or the teacher's share for a program or a table whose
    mistake is recognised.
    """
    if verdict.status == RIGHT:
        return 1.0
    return (
        settings.partial
        if verdict.status == WRONG and verdict.mistake and isinstance(exercise, (Function, Table))
        else 0.0
    )


def _own(found, used, settings):
    names = ", ".join(sorted({name[:40] for name in used if name.isidentifier()}))
    if set(used) == {"setprofile"}:
        headline = "while the check called it, this function switched off what watches it"
    else:
        headline = (
            f"this function calls dhlab's own programs ({names}); here the task is to write that"
            " yourself"
        )
    return Mark(
        found.exercise,
        NOT_ALLOWED,
        round(found.points * settings.own_kinematics, 4),
        found.of,
        headline=headline,
        next="Write it with numpy alone; the library's answer is there to compare with.",
        note=f"answers {found.status}; called: {names}",
    )


def _timed_out(exercise, worth, note=""):
    return Mark(
        exercise.id,
        TIMED_OUT,
        0,
        worth,
        headline="this took too long and was stopped",
        next="Look for a loop that never ends.",
        note=note,
    )


def _without_answer(exercise, answers, worth):
    """The mark of an exercise for which no attempt was noted."""
    kind, message = answers.troubles.get(
        exercise.id,
        (answers.cut, "the notebook ended before this exercise was reached" if answers.cut else ""),
    )
    if kind == "timed out":
        return _timed_out(exercise, worth)
    if kind is None:
        return Mark(exercise.id, NOT_ATTEMPTED, 0, worth)
    said = (
        message
        if exercise.id not in answers.troubles
        else (
            f"the cell stops with {message}"
            if message
            else "the notebook's program ended itself in this cell"
        )
    )
    return Mark(
        exercise.id,
        ERROR,
        0,
        worth,
        headline=said,
        next="Run the notebook from top to bottom and read the last line of the message.",
    )


def without_marks(course: Course, status: str) -> tuple[Mark, ...]:
    """A mark for every exercise of somebody who handed in nothing that could be graded."""
    return tuple(Mark(e.id, status, 0, course.settings.points(e)) for e in course.exercises)
