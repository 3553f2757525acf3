"""One student's submission through the cage and the judge: what a worker does, here, in another process or on another machine."""

import threading
import time
from dataclasses import dataclass
from datetime import datetime
from multiprocessing import util

from .borrowed import borrowed_from
from .cage import Cage
from .judge import Answers, mark, without_marks
from .marks import GRADED, MISSING, NOT_ATTEMPTED, TIMED_OUT, UNREADABLE, Graded
from .questions import request, warm_modules

__all__ = ["Handed", "Task", "work", "close"]

AGAIN = 3  # how often a notebook is run again without the cell that ended it
_lock, _cages = threading.Lock(), {}


@dataclass(frozen=True)
class Handed:
    """One notebook as handed in: where it was found, its bytes, and when it came."""

    name: str
    raw: bytes
    when: datetime | None = None


@dataclass(frozen=True)
class Task:
    """One student's notebooks, oldest first; notes for the teacher; what the mark depends on, as a fingerprint."""

    student: str
    notebooks: tuple
    notes: tuple = ()
    fingerprint: str = ""


def work(task, course):
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
    common = {"student": task.student, "file": "; ".join(handed.name for handed in task.notebooks), "variant": variant, "fingerprint": task.fingerprint}
    if not task.notebooks:
        status = UNREADABLE if task.notes else MISSING
        return Graded(status=status, marks=without_marks(course, NOT_ATTEMPTED), notes=task.notes, **common)
    with _lock:
        cage = _cage(course)
        answers, notes, trouble = _run_all(cage, task, course, variant)
        level = cage.level
    marks, days, penalty = _marks(course, answers, variant)
    status = trouble or (NOT_ATTEMPTED if all(found.status == NOT_ATTEMPTED for found in marks) else GRADED)
    return Graded(status=status, marks=marks, late_days=days, penalty=penalty, cage=level, notes=(*task.notes, *notes),
                  guess_of=borrowed_from(course, task.student, answers, marks), seconds=round(time.monotonic() - begun, 3), **common)


def _cage(course):
    """This process's cage for a course, built when it is first needed."""
    key = (course.settings.cage, course.settings.limits, course.lessons)
    if key not in _cages:
        close()
        _cages[key] = Cage(course.settings.cage, course.settings.limits, warm_modules(course.lessons))
    return _cages[key]


def close():
    """Close this process's cage."""
    for cage in _cages.values():
        cage.close()
    _cages.clear()


util.Finalize(None, close, exitpriority=1)  # at the end of this process; unlike atexit in workers too


def _run_all(cage, task, course, variant):
    """Run every notebook; (answers, notes, what kept the whole from being graded: a status or None)."""
    answers, notes, runs = Answers(), [], []
    for handed in task.notebooks:
        run, why = _run(cage, handed, course, variant, answers)
        runs.append(run)
        notes += [f"{handed.name}: {note}" for note in why]
    if any(run.ended == "timed out" for run in runs):
        return answers, notes, TIMED_OUT
    unread = all(run.cell is None and (run.ended != "done" or "unreadable" in run.lines[-1]) for run in runs)
    return answers, notes, UNREADABLE if unread else None


def _run(cage, handed, course, variant, answers):
    """Run one notebook; a cell that ends the program costs itself, and the rest is run again without it."""
    skip, notes, left = set(), [], course.settings.limits.seconds
    while True:
        run = cage.run(request(course, variant, skip), handed.raw, left)
        answers.add(run, handed.when)
        left -= run.seconds
        broken = [line["unreadable"] for line in run.lines if isinstance(line.get("unreadable"), str)]
        if broken:
            notes.append(broken[0][:200])
        if run.ended == "done" or run.cell is None or run.cell in skip or len(skip) == AGAIN or left <= 0:
            if run.ended != "done":
                notes.append(f"stopped: {run.ended}")
            return run, notes
        skip.add(run.cell)
        notes.append(f"cell {run.cell + 1} ended the program ({run.ended}); run again without it")


def _marks(course, answers, variant):
    """(marks, days late at most, share of all points lost to lateness)."""
    marks, lost, latest = [], 0.0, 0.0
    for exercise in course.exercises:
        found, when = mark(exercise, answers, variant, course.settings)
        days, penalty = course.settings.lateness(exercise.id.split(".")[0], when)
        marks.append(found)
        lost += found.points * penalty
        latest = max(latest, days)
    points = sum(found.points for found in marks)
    return tuple(marks), latest, round(lost / points, 6) if points else 0.0

