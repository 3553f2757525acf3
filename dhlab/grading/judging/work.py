"""One student's submission through the cage and the judge: what a worker does, here, in another
process or on another machine.
"""

import json
import threading
import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from datetime import datetime, tzinfo
from functools import cached_property
from multiprocessing import util
from typing import Any

from ...course.kinds import Explain
from ..cage.cage import Cage
from ..cage.sight import OPEN, OWN
from ..cage.stage import library
from ..intake.notebooks import lessons_of, numbers_of
from ..own_items import install
from ..results.marks import (
    ERROR,
    GRADED,
    MISSING,
    NOT_ATTEMPTED,
    NOT_HANDED_IN,
    RIGHT,
    TIMED_OUT,
    UNREADABLE,
    Graded,
)
from ..results.standing import NO_FILE, lateness
from .asking import Asked, ask
from .borrowed import borrowed_from
from .explained import OwnWords, explained
from .judge import Answers, mark, without_marks
from .questions import (
    Course,
    call_request,
    handed_out_cells,
    handed_out_checks,
    named_modules,
    request,
)

__all__ = ["Handed", "Task", "work", "handed_in", "close"]

LARGE = 1_000_000  # bytes of a notebook with pictures; a lesson as handed out has a tenth
TOGETHER = 2  # times the seconds of a notebook: all those of one student
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

    @cached_property
    def numbers(self) -> frozenset[int]:
        """Whose numbers it draws, looked up once."""
        return numbers_of(self.raw)


@dataclass(frozen=True)
class Task:
    """One student's notebooks, oldest first; notes for the teacher; what the mark depends on, as a
    fingerprint; whose numbers the notebooks draw, if another's; whether there is something that
    cannot be read; the number that is recorded with the marks, and the seeds that it gives for the
    inputs of each program."""

    student: str
    notebooks: tuple[Handed, ...]
    notes: tuple[str, ...] = ()
    fingerprint: str = ""
    numbers_of: str | None = None
    refused: bool = False
    number: str = ""
    seeds: Mapping[str, int] = field(default_factory=dict)


def work(task: Task, course: Course) -> Graded:
    """Grade one student. A fault of the grader's own costs nobody else anything, and is told.

    Parameters
    ----------
    task : Task
    course : Course

    Returns
    -------
    Graded
    """
    try:
        if course.settings.items:  # this may be another process than the one that read them
            install(course.settings.items)
        return _work(task, course)
    except Exception as error:
        if isinstance(error, ValueError) and str(error).startswith("grade:"):
            raise  # there is no cage: nobody can be graded
        said = f"could not be graded, the grader stopped with {type(error).__name__}: {error}"
        return Graded(
            task.student,
            "; ".join(handed.name for handed in task.notebooks),
            UNREADABLE,
            without_marks(course, ERROR),
            variant=course.variants.get(task.student, 0),
            notes=(*task.notes, said[:300]),
            number=task.number,
        )


def _work(task, course):
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
        number=task.number,
    )
    if not task.notebooks:
        status = NOT_ATTEMPTED if task.refused else NOT_HANDED_IN
        return replace(graded, marks=without_marks(course, status))
    with _lock:
        cage = _cage(course, OPEN)
        answers, notes, trouble, called = _run_all(cage, task, course, variant)
        programs = _Programs(task, course, variant, called)
        said = OwnWords(task.notebooks)
        found = [
            _mark(exercise, answers, variant, course.settings, programs.ask, said)
            for exercise in course.exercises
        ]
    marks, missing = _by_lesson(found, task.notebooks)
    untouched = all(mark.status in (NOT_ATTEMPTED, NOT_HANDED_IN) for mark in marks)
    days, penalty = lateness(marks)
    return replace(
        graded,
        status=trouble or (NOT_ATTEMPTED if untouched else GRADED),
        marks=marks,
        late_days=days,
        penalty=penalty,
        cage=cage.level,
        notes=(*task.notes, *notes, *missing),
        guess_of=borrowed_from(course, task.student, answers, marks),
        seconds=round(time.monotonic() - begun, 3),
    )


class _Programs:
    """Calls a student's programs, each in the room that its task allows."""

    def __init__(self, task, course, variant, called):
        self.task, self.course, self.variant, self.called = task, course, variant, called
        self.left = course.settings.limits.seconds

    def ask(self, exercise, line, handed):
        """(what the program of a note gave, the seed of its inputs)."""
        number, own = self.task.seeds[exercise.id], not exercise.library
        asked = self._asked(exercise, line, handed, number, OWN if own else OPEN)
        if own and asked.closed and self.course.settings.own_kinematics:
            again = self._asked(exercise, line, handed, number, OPEN)
            right = exercise.judge(again.called, number).status == RIGHT
            asked = replace(asked, right_with_library=not again.stopped and right)
        return asked, number

    def _asked(self, exercise, line, handed, number, room):
        cell = line["cell"] if isinstance(line.get("cell"), int) else 0
        raw, skip = self.called[handed.name]
        asking = call_request(self.course, self.variant, exercise, cell, skip)
        cage = _cage(self.course, room)
        for whole in (False, True):
            if self.left <= 0:
                return Asked(stopped="timed out")
            asked = ask(cage, asking | {"whole": whole}, raw, exercise, number)
            self.left -= asked.seconds
            if asked.stopped == "timed out" and cage.learnt and self.left > 0:  # as in _run
                asked = ask(cage, asking | {"whole": whole}, raw, exercise, number)
                self.left -= asked.seconds
            # reading alone may miss what a program depends on
            if not asked.missing:
                break
        return asked


def _cage(course, room):
    """This process's cage for a course, built when it is first needed."""
    key = (course.settings.cage, course.settings.limits, course.lessons, room)
    if key not in _cages:
        if _cages and next(iter(_cages))[:3] != key[:3]:
            close()
        warm = [*(library() if room == OPEN else ()), *named_modules(course.lessons)]
        cells = handed_out_cells(course.lessons)
        _cages[key] = Cage(course.settings.cage, course.settings.limits, warm, room, cells)
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
    None, of each notebook what its programs are called from: its code, and the cells that were not
    run).
    """
    answers, notes, runs, called = Answers(), [], [], {}
    seconds = course.settings.limits.seconds
    left = TOGETHER * seconds
    for number, (handed, large) in enumerate(_slim(cage, task.notebooks)):
        notes += large
        most = min(seconds, left / (len(task.notebooks) - number))
        run, why, called[handed.name], used = _run(cage, handed, course, variant, answers, most)
        left -= used
        runs.append(run)
        notes += [f"{handed.name}: {note}" for note in why]
    if any(run.ended == "timed out" for run in runs):
        return answers, notes, TIMED_OUT, called
    unread = all(
        run.cell is None and (run.ended != "done" or "unreadable" in run.lines[-1]) for run in runs
    )
    return answers, notes, UNREADABLE if unread else None, called


def _slim(cage, notebooks):
    """(notebook, notes): large ones without their outputs; these are taken out in the cage, where
    it costs nobody else anything. What is still large then is no notebook, and is cut off.
    """
    for handed in notebooks:
        if len(handed.raw) <= LARGE:
            yield handed, []
            continue
        run = cage.run({"slim": 1, "cell_seconds": 10}, handed.raw, 20)
        raw = _code(run)
        told = [] if raw else [f"{handed.name}: large, and not for its outputs: not run"]
        yield replace(handed, raw=raw or handed.raw[:LARGE]), told


def _code(run):
    """The notebook without what is not code, as it was told before any of it ran; empty where it
    was not told.
    """
    slim = run.lines[0].get("slim") if run.lines else None
    return json.dumps(slim).encode() if slim else b""


def _run(cage, handed, course, variant, answers, most):
    """Run one notebook for so many seconds at most; a cell that ends the program costs itself, and
    the rest is run again without it.
    """
    skip: set[int] = set()
    notes, left, raw = [], most, handed.raw
    while True:
        run = cage.run(request(course, variant, skip), raw, left)
        raw = _code(run) or raw
        left -= run.seconds
        late = any(line.get("ended") == "timed out" for line in run.lines)
        if late and cage.learnt and left > 0:
            continue  # it may have loaded for too long what those after it have loaded for them
        answers.add(run, handed)
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
            return run, notes, (raw, sorted(skip)), most - left
        skip.add(run.cell)
        notes.append(f"cell {run.cell + 1} ended the program ({run.ended}); run again without it")


def _mark(exercise, answers, variant, settings, ask_program, said):
    """The mark of an exercise, with the file it comes from and what its lateness costs."""
    found, handed = mark(exercise, answers, variant, settings, ask_program)
    if isinstance(exercise, Explain):
        found, handed = explained(found, handed, said)
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
