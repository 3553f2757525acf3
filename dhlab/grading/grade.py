"""``grade``: everything that was handed in, graded; a run that was broken off is taken up where it stopped."""

import hashlib
import json
import re
from collections import Counter
from concurrent.futures import FIRST_COMPLETED, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass, replace
from multiprocessing import get_context

from ..course.exercises import exercises
from .gradebook import Gradebook
from .judge import replaced
from .questions import Course, handed_out_checks
from .settings import Settings
from .submissions import submissions
from .variants import variants
from .work import Handed, Task, close, work

__all__ = ["grade", "plan", "Plan"]

CHECKED = re.compile(rb"""check\(\s*\\?["']([0-9A-Za-z]+)\.""")
HANDED_IN = 0.2  # without a course.yaml a lesson counts when this share of the most common lesson's students handed it in
LOST = 3  # how often a worker may die


@dataclass(frozen=True)
class Plan:
    """What is to be graded: the course, each student's submission, and sentences for the teacher."""

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
        Nothing was found, or there is no such exercise.
    """
    if exercise and exercise not in exercises():
        raise ValueError(f'grade: expected the number of an exercise, such as "05.1", found {exercise!r}')
    names = [path.stem for path in _handed_out()]
    found = submissions(place, roster, names)
    if not any(mine.notebooks for mine in found.values()):
        raise ValueError(f"{place}: expected submissions, found no notebook; is it the right folder?")
    lessons, notes = _lessons(found, settings, exercise)
    course = Course(lessons, settings, variants(key, found), exercise)
    if not course.exercises:
        raise ValueError(f"grade: expected lessons with exercises that earn points, found {', '.join(lessons) or 'none'}; name the lessons in course.yaml")
    unknown = [student for student, mine in found.items() if not mine.on_roster]
    notes += [f"{student}: not on the roster; graded all the same" for student in unknown]
    return Plan(course, found, tuple(notes))


def _handed_out():
    from ..course.workspace import handed_out
    return sorted(handed_out().glob("*.ipynb"))


def _lessons(found, settings, exercise):
    """The lessons to grade: those of course.yaml, that of the one exercise, or those that were handed in."""
    if exercise:
        return (exercise.split(".")[0],), []
    if settings.lessons:
        return tuple(sorted(settings.lessons)), []
    seen = Counter(lesson for mine in found.values() for lesson in _seen(mine))
    known = {lesson: count for lesson, count in seen.items() if lesson in handed_out_checks()}
    common = tuple(sorted(lesson for lesson, count in known.items() if count >= HANDED_IN * max(known.values())))
    rare = [f"lesson {lesson} was handed in by {count} and does not count; name it in course.yaml if it should" for lesson, count in sorted(known.items()) if lesson not in common]
    return common, rare


def _seen(mine):
    """The lessons a student's notebooks seem to be of, from their bytes alone."""
    return {raw.decode() for _, read, _ in mine.notebooks for raw in CHECKED.findall(read())}


def grade(place, out, *, roster=(), key=None, settings=Settings(), jobs=1, scheduler=None, exercise="", progress=lambda done, of: None):
    """Grade everything that was handed in; what an earlier run graded, and has not changed since, is kept.

    Parameters
    ----------
    place : str or path
        A folder or a zip.
    out : str or path
        The folder for marks and ``grades.csv``.
    roster, key, settings, exercise :
        As :func:`plan`. With an exercise the others keep the marks they have.
    jobs : int
        Submissions at a time, each in a cage of its own.
    scheduler : str or None
        The address of a Dask scheduler, to grade on its workers.
    progress : callable
        Called with how many are done, and of how many.

    Returns
    -------
    results : list of Graded
        The roster's students first, in its order.
    planned : Plan

    Raises
    ------
    ValueError
        One sentence: what was expected, what was found; another grader at work in ``out``, for one. Marks written so far stay.
    """
    book = Gradebook(out)
    planned = plan(place, roster, key, settings, exercise)
    with book.alone():
        todo, kept = _todo(planned, book, key)
        done = len(kept)
        progress(done, len(planned.found))
        for graded in _worked(todo, planned.course, jobs, scheduler):
            book.write(_merged(graded, book, exercise))
            done += 1
            progress(done, len(planned.found))
        results = [book.read(student) for student in planned.found]
        book.write_grades(results, roster)
    return results, planned


def _todo(planned, book, key):
    """What is left to do, as a generator of tasks that reads each submission only then, and who is done."""
    kept = set()
    if not planned.course.only:
        for student, mine in planned.found.items():
            before = book.read(student)
            if before is not None and before.fingerprint == _task(student, mine, planned.course).fingerprint:
                kept.add(student)
    return (_whole(student, mine, planned.course, book) for student, mine in planned.found.items() if student not in kept), kept


def _whole(student, mine, course, book):
    """(task, course) of a student; an exercise alone is graded only where the rest has been."""
    task = _task(student, mine, course)
    if course.only and book.read(student) is None:
        return task, replace(course, only="")
    return task, course


def _task(student, mine, course):
    handed = tuple(Handed(name, read(), when) for name, read, when in mine.notebooks)
    told = [course.lessons, repr(course.settings), course.variants.get(student), [(h.name, str(h.when), hashlib.sha256(h.raw).hexdigest()) for h in handed], mine.notes]
    return Task(student, handed, tuple(mine.notes), hashlib.sha256(json.dumps(told).encode()).hexdigest()[:16])


def _merged(graded, book, exercise):
    """With one exercise regraded, the other marks as they were."""
    before = book.read(graded.student) if exercise else None
    return graded if before is None else replaced(before, graded)


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
    """Over processes, a few submissions ahead of each; a worker that dies costs a new pool, not a mark."""
    again, lost = [], 0
    todo = iter(todo)
    while True:
        waiting = {}
        pool = ProcessPoolExecutor(jobs, mp_context=get_context("spawn"))
        try:
            while True:
                while len(waiting) < 2 * jobs and (given := again.pop() if again else next(todo, None)) is not None:
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
                raise ValueError("grade: expected workers that live, found that one dies again and again (is memory short?); run again with --jobs 1") from None
        finally:
            pool.shutdown(cancel_futures=True)
