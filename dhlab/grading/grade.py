"""``grade``: everything that was handed in, graded; a run that was broken off is taken up where it
stopped.
"""

import hashlib
import json
from collections import Counter
from concurrent.futures import FIRST_COMPLETED, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass, replace
from multiprocessing import get_context
from pathlib import Path

from ..course.exercises import exercises
from .handing_out.variants import variants
from .intake.notebooks import lessons_of
from .intake.owners import look_whose
from .intake.submissions import FILE_TIME, PASSED_OVER, submissions
from .judging.questions import Course, handed_out_checks
from .judging.work import Handed, Task, close, work
from .results.gradebook import Gradebook
from .results.standing import left_standing, together
from .settings import Settings

__all__ = ["grade", "plan", "Plan"]

# without a course.yaml a lesson counts when this share of the most common lesson's students handed
# it in
HANDED_IN = 0.2
LOST = 3  # how often a worker may die


@dataclass(frozen=True)
class Plan:
    """What is to be graded: the course, each student's submission, and sentences for the
    teacher.
    """

    course: Course
    found: dict
    notes: tuple


def plan(place, roster=(), key=None, settings=Settings(), exercise=""):
    """Look at what was handed in, without running any of it.

    Parameters
    ----------
    place : str or path
        A folder or a zip.
    roster : sequence of Student
    key : bytes or None
        The teacher's key, when each student had numbers of their own.
    settings : Settings
    exercise : str
        Grade only this one.

    Returns
    -------
    Plan

    Raises
    ------
    ValueError
        Nothing was found, there is no such exercise, or the key is not that of most notebooks.
    """
    if exercise and exercise not in exercises():
        raise ValueError(
            f'grade: expected the number of an exercise, such as "05.1", found {exercise!r}'
        )
    names = [path.stem for path in _handed_out()]
    found, notes = _without_strays(submissions(place, roster, names, settings.zone), roster)
    if not any(mine.notebooks for mine in found.values()):
        raise ValueError(
            f"{place}: expected submissions, found no notebook; is it the right folder?"
        )
    lessons, rare = _lessons(found, settings)
    if exercise and exercise.split(".")[0] not in lessons:
        raise ValueError(
            "grade: expected an exercise of the lessons"
            f" {', '.join(lessons) or '(none was found)'}, found {exercise!r}; name its lesson in"
            " course.yaml"
        )
    numbers = variants(key, found)
    notes += rare + look_whose(found, roster, key, numbers) + _all_late(found, settings)
    course = Course(lessons, settings, numbers, exercise)
    if not course.exercises:
        raise ValueError(
            "grade: expected lessons with exercises that earn points, found"
            f" {', '.join(lessons) or 'none'}; name the lessons in course.yaml"
        )
    return Plan(course, found, tuple(notes))


def _handed_out():
    from ..course.workspace import handed_out

    return sorted(handed_out().glob("*.ipynb"))


def _without_strays(found, roster):
    """(students, notes): without files of no folder that are no notebooks and carry nobody's
    name.
    """
    known = {student.student for student in roster}
    strays = {
        student
        for student, mine in found.items()
        if mine.loose
        and student not in known
        and not mine.notebooks
        and all(note.endswith(PASSED_OVER) for note in mine.notes)
    }
    names = [
        note.partition(": no notebook")[0] for student in strays for note in found[student].notes
    ]
    told = (
        [f"passed over, neither notebooks nor anybody's name: {', '.join(sorted(names))}"]
        if names
        else []
    )
    return {student: mine for student, mine in found.items() if student not in strays}, told


def _all_late(found, settings):
    """A doubt, when every file is later than every due date by the time of the file: a copy has
    often no other.
    """
    dues = [lesson.due for lesson in settings.lessons.values() if lesson.due]
    notebooks = [notebook for mine in found.values() for notebook in mine.notebooks]
    if dues and all(
        notebook.source == FILE_TIME and notebook.when > max(dues) for notebook in notebooks
    ):
        return [
            "every notebook is late by the time of its file: were the files copied? cp -a keeps the"
            " times, cp -r does not"
        ]
    return []


def _lessons(found, settings):
    """The lessons to grade: those of course.yaml, or those that were handed in."""
    if settings.lessons:
        return tuple(sorted(settings.lessons)), []
    seen = Counter(
        lesson
        for mine in found.values()
        for lesson in frozenset().union(
            *(lessons_of(notebook.read()) for notebook in mine.notebooks)
        )
    )
    known = {lesson: count for lesson, count in seen.items() if lesson in handed_out_checks()}
    common = tuple(
        sorted(
            lesson for lesson, count in known.items() if count >= HANDED_IN * max(known.values())
        )
    )
    rare = [
        f"lesson {lesson} was handed in by {count} and does not count; name it in course.yaml if it"
        " should"
        for lesson, count in sorted(known.items())
        if lesson not in common
    ]
    return common, rare


def grade(
    place,
    out,
    *,
    roster=(),
    key=None,
    settings=Settings(),
    jobs=1,
    scheduler=None,
    exercise="",
    progress=lambda done, of: None,
):
    """Grade everything that was handed in; what an earlier run graded, and has not changed since,
    is kept.

    Marks of other lessons, and of work that is not among what is graded now, stand as they are.

    Parameters
    ----------
    place : str or path
        A folder or a zip.
    out : str or path
        The folder for marks and ``grades.csv``.
    roster, key, settings, exercise :
        As :func:`plan`. With an exercise the others keep the marks they have; who has none yet is
        graded whole.
    jobs : int
        Submissions at a time, each in a cage of its own.
    scheduler : str or None
        The address of a Dask scheduler, to grade on its workers.
    progress : callable
        Called with how many are done, and of how many.

    Returns
    -------
    results : list of Graded
        The roster's students first, in its order; last those of earlier runs of whom there is
        nothing now.
    planned : Plan

    Raises
    ------
    ValueError
        One sentence: what was expected, what was found; another grader at work in ``out``, for one.
        Marks written so far stay.
    """
    if Path(out).resolve().is_relative_to(Path(place).resolve()):
        raise ValueError(
            f"grade: {out}: expected a folder for the marks outside the submissions, found it in"
            f" {place}; give another --out"
        )
    planned = plan(place, roster, key, settings, exercise)
    book = Gradebook(out)
    book.check_ours({*planned.found, *book.students()})
    if exercise and not book.students():
        raise ValueError(
            f"grade: {out}: expected marks of which {exercise} is to be graded again, found none;"
            " grade without --exercise first"
        )
    with book.alone():
        todo, kept = _todo(planned, book, key)
        done = len(kept)
        progress(done, len(planned.found))
        for graded in _worked(todo, planned.course, jobs, scheduler):
            book.write(together(book.read(graded.student), graded, exercise))
            done += 1
            progress(done, len(planned.found))
        others = [student for student in book.students() if student not in planned.found]
        results = [
            *map(book.read, planned.found),
            *(left_standing(book.read(student)) for student in others),
        ]
        book.write_grades(results, roster)
    return results, planned


def _todo(planned, book, key):
    """What is left to do, as a generator of tasks that reads each submission only then, and who is
    done.
    """
    kept = set()
    if not planned.course.only:
        for student, mine in planned.found.items():
            before = book.read(student)
            if (
                before is not None
                and before.fingerprint == _task(student, mine, planned.course).fingerprint
            ):
                kept.add(student)
    return (
        _whole(student, mine, planned.course, book)
        for student, mine in planned.found.items()
        if student not in kept
    ), kept


def _whole(student, mine, course, book):
    """(task, course) of a student; an exercise alone is graded only where the rest has been."""
    task = _task(student, mine, course)
    before = book.read(student) if course.only else None
    if course.only and (
        before is None or course.only not in {mark.exercise for mark in before.marks}
    ):
        return task, replace(course, only="")
    return task, course


def _task(student, mine, course):
    handed = tuple(
        Handed(notebook.name, notebook.read(), notebook.when, notebook.source)
        for notebook in mine.notebooks
    )
    told = [
        course.lessons,
        repr(course.settings),
        course.variants.get(student),
        [(h.name, str(h.when), hashlib.sha256(h.raw).hexdigest()) for h in handed],
        mine.notes,
    ]
    return Task(
        student,
        handed,
        tuple(mine.notes),
        hashlib.sha256(json.dumps(told).encode()).hexdigest()[:16],
        mine.numbers_of,
        mine.refused,
    )


def _worked(todo, course, jobs, scheduler):
    """Graded, one after the other, as they come."""
    if scheduler:
        from .dask import over_cluster

        yield from over_cluster(scheduler, todo)
    elif jobs == 1:
        try:
            for task, own in todo:
                yield work(task, own)
        finally:
            close()
    else:
        yield from _pooled(todo, jobs)


def _pooled(todo, jobs):
    """Over processes, a few submissions ahead of each; a worker that dies costs a new pool, not a
    mark.
    """
    again, lost = [], 0
    todo = iter(todo)
    while True:
        waiting = {}
        pool = ProcessPoolExecutor(jobs, mp_context=get_context("spawn"))
        try:
            while True:
                while (
                    len(waiting) < 2 * jobs
                    and (given := again.pop() if again else next(todo, None)) is not None
                ):
                    waiting[pool.submit(work, *given)] = given
                if not waiting:
                    return
                for future in wait(waiting, return_when=FIRST_COMPLETED).done:
                    graded = future.result()
                    del waiting[future]
                    yield graded
        except BrokenProcessPool:
            again += waiting.values()
            lost += 1
            if lost > LOST:
                raise ValueError(
                    "grade: expected workers that live, found that one dies again and again (is"
                    " memory short?); run again with --jobs 1"
                ) from None
        finally:
            pool.shutdown(cancel_futures=True)
