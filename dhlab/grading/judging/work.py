"""One student's submission through the cage and the judge: what a worker does, here, in another
process or on another machine.
"""

import threading
import time
from dataclasses import dataclass, replace
from datetime import datetime, tzinfo
from multiprocessing import util
from typing import Any

from ..cage.cage import Cage
from ..intake.notebooks import lessons_of
from ..results.marks import (
    GRADED,
    MISSING,
    NOT_ATTEMPTED,
    NOT_HANDED_IN,
    TIMED_OUT,
    UNREADABLE,
    Graded,
)
from ..results.standing import NO_FILE, lateness
from .borrowed import borrowed_from
from .judge import Answers, mark, without_marks
from .questions import Course, handed_out_checks, request, warm_modules

__all__ = ["Handed", "Task", "work", "handed_in", "close"]

AGAIN = 3  # how often a notebook is run again without the cell that ended it
_lock = threading.Lock()
_cages: dict[tuple[Any, ...], Cage] = {}


@dataclass(frozen=True)
class Handed:
    """One notebook as handed in: where it was found, its bytes, when it came and how that is
    known.
    """

    name: str
    raw: bytes
    when: datetime | None = None
    source: str = ""


@dataclass(frozen=True)
class Task:
    """One student's notebooks, oldest first; notes for the teacher; what the mark depends on, as a
    fingerprint; whose numbers the notebooks draw, if another's; whether there is something that
    cannot be read."""

    student: str
    notebooks: tuple[Handed, ...]
    notes: tuple[str, ...] = ()
    fingerprint: str = ""
    numbers_of: str | None = None
    refused: bool = False


def work(task: Task, course: Course) -> Graded:
    """Grade one student.

    Parameters
    ----------
    task : Task
    course : Course

    Returns
    -------
    Graded
    """
    begun = time.monotonic()
    variant = course.variants.get(task.student, 0)
    graded = Graded(
        task.student,
        "; ".join(handed.name for handed in task.notebooks),
        UNREADABLE if task.refused else MISSING,
        (),
        variant=variant,
        notes=task.notes,
        numbers_of=task.numbers_of,
        fingerprint=task.fingerprint,
    )
    if not task.notebooks:
        status = NOT_ATTEMPTED if task.refused else NOT_HANDED_IN
        return replace(graded, marks=without_marks(course, status))
    with _lock:
        cage = _cage(course)
        answers, notes, trouble = _run_all(cage, task, course, variant)
    found = [_mark(exercise, answers, variant, course.settings) for exercise in course.exercises]
    marks, said = _by_lesson(found, task.notebooks)
    untouched = all(mark.status in (NOT_ATTEMPTED, NOT_HANDED_IN) for mark in marks)
    days, penalty = lateness(marks)
    return replace(
        graded,
        status=trouble or (NOT_ATTEMPTED if untouched else GRADED),
        marks=marks,
        late_days=days,
        penalty=penalty,
        cage=cage.level,
        notes=(*task.notes, *notes, *said),
        guess_of=borrowed_from(course, task.student, answers, marks),
        seconds=round(time.monotonic() - begun, 3),
    )


def _cage(course):
    """This process's cage for a course, built when it is first needed."""
    key = (course.settings.cage, course.settings.limits, course.lessons)
    if key not in _cages:
        close()
        _cages[key] = Cage(
            course.settings.cage, course.settings.limits, warm_modules(course.lessons)
        )
    return _cages[key]


def close() -> None:
    """Close this process's cage."""
    for cage in _cages.values():
        cage.close()
    _cages.clear()


# at the end of this process; unlike atexit in workers too
util.Finalize(None, close, exitpriority=1)


def _run_all(cage, task, course, variant):
    """Run every notebook; (answers, notes, what kept the whole from being graded: a status or
    None).
    """
    answers, notes, runs = Answers(), [], []
    for handed in task.notebooks:
        run, why = _run(cage, handed, course, variant, answers)
        runs.append(run)
        notes += [f"{handed.name}: {note}" for note in why]
    if any(run.ended == "timed out" for run in runs):
        return answers, notes, TIMED_OUT
    unread = all(
        run.cell is None and (run.ended != "done" or "unreadable" in run.lines[-1]) for run in runs
    )
    return answers, notes, UNREADABLE if unread else None


def _run(cage, handed, course, variant, answers):
    """Run one notebook; a cell that ends the program costs itself, and the rest is run again
    without it.
    """
    skip: set[int] = set()
    notes, left = [], course.settings.limits.seconds
    while True:
        run = cage.run(request(course, variant, skip), handed.raw, left)
        answers.add(run, handed)
        left -= run.seconds
        broken = [
            line["unreadable"] for line in run.lines if isinstance(line.get("unreadable"), str)
        ]
        if broken:
            notes.append(broken[0][:200])
        if (
            run.ended == "done"
            or run.cell is None
            or run.cell in skip
            or len(skip) == AGAIN
            or left <= 0
        ):
            if run.ended != "done":
                notes.append(f"stopped: {run.ended}")
            return run, notes
        skip.add(run.cell)
        notes.append(f"cell {run.cell + 1} ended the program ({run.ended}); run again without it")


def _mark(exercise, answers, variant, settings):
    """The mark of an exercise, with the file it comes from and what its lateness costs."""
    found, handed = mark(exercise, answers, variant, settings)
    if handed is None:
        return found
    days, penalty = settings.lateness(found.lesson, handed.when)
    return replace(
        found,
        file=handed.name,
        handed_in=handed_in(handed.when, handed.source, settings.zone),
        late_days=days,
        penalty=penalty,
    )


def handed_in(when: datetime | None, source: str, zone: tzinfo) -> str:
    """When a file came, in words: in the course's time zone, and how it is known; empty when it is
    not.
    """
    return f"{when.astimezone(zone):%Y-%m-%d %H:%M}, {source}" if when else ""


def _sittings(lesson):
    return sum(sitting[:2] == lesson for sitting in handed_out_checks())


def _by_lesson(marks, notebooks):
    """(marks, notes): the lessons of which there is no file, and which of several files of one
    lesson was used.
    """
    lessons = {handed.name: lessons_of(handed.raw) for handed in notebooks}
    there = frozenset().union(*lessons.values()) | {
        found.lesson for found in marks if found.status != NOT_ATTEMPTED
    }
    if not all(lessons.values()):  # a notebook that does not say what it is may be of any lesson
        there |= {found.lesson for found in marks}
    notes = []
    for lesson in sorted({found.lesson for found in marks}):
        files = [name for name, of in lessons.items() if lesson in of]
        used = sorted({found.file for found in marks if found.lesson == lesson and found.file})
        if lesson not in there:
            notes.append(f"lesson {lesson}: {NO_FILE}")
        elif len(files) > max(1, _sittings(lesson)) and used:
            notes.append(
                f"lesson {lesson}: {len(files)} files; the answers are those of"
                f" {' and '.join(used)}"
            )
    return (
        tuple(
            found if found.lesson in there else replace(found, status=NOT_HANDED_IN)
            for found in marks
        ),
        notes,
    )
