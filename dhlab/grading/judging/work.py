"""One student's submission through the cage and the judge: what a worker does, here, in another
process or on another machine.
"""

import threading
import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from datetime import datetime
from functools import cached_property

from ...course.kinds import Explain
from ..cage.sight import OPEN, OWN
from ..intake.notebooks import lessons_of, numbers_of
from ..intake.timestamps import handed_in
from ..own_items import install
from ..results.marks import (
    ERROR,
    GRADED,
    MISSING,
    NOT_ATTEMPTED,
    NOT_HANDED_IN,
    RIGHT,
    UNREADABLE,
    Graded,
)
from ..results.standing import NO_FILE, lateness
from .asking import Asked, ask
from .borrowed import borrowed_from
from .explained import OwnWords, explained
from .judge import mark, without_marks
from .questions import Course, call_request, handed_out_checks, request
from .running import cage_of, run_all

__all__ = ["Handed", "Task", "work"]

AGAIN = 0.5  # of the seconds of a notebook, for programs that are called a second time
_lock = threading.Lock()


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
        cage = cage_of(course, OPEN)
        answers, notes, trouble, called = run_all(cage, task, course, variant)
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
        seconds = course.settings.limits.seconds
        # by whether the whole notebook is run: what is called again takes no time from the others
        self.left = {False: seconds, True: seconds * AGAIN}

    @cached_property
    def told(self):
        """What the cage is told of the student's tasks, for all programs."""
        return request(self.course, self.variant)

    def ask(self, exercise, line, handed, whole=False):
        """(what the program of a note gave, the seed of its inputs); ``whole`` as for
        :func:`dhlab.grading.judging.questions.call_request`.
        """
        number, own = self.task.seeds[exercise.id], not exercise.library
        cell = line["cell"] if isinstance(line.get("cell"), int) else 0
        raw, skip = self.called[handed.name]
        asking = call_request(self.told, exercise, cell, skip, whole)
        asked = self._asked(OWN if own else OPEN, asking, raw, exercise, number)
        if own and asked.closed and self.course.settings.own_kinematics:
            again = self._asked(OPEN, asking, raw, exercise, number)
            right = exercise.judge(again.called, number).status == RIGHT
            asked = replace(asked, right_with_library=not again.stopped and right)
        return asked, number

    def _asked(self, room, asking, *of):
        cage = cage_of(self.course, room)
        for _ in range(2):
            if self.left[asking["whole"]] <= 0:
                return Asked(stopped="no time")
            asked = ask(cage, asking, *of)
            self.left[asking["whole"]] -= asked.seconds
            if asked.stopped != "timed out" or not cage.learnt:  # as in _run
                break
        return asked


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
