"""``grade``: everything that was handed in, graded; a run that was broken off is taken up where it
stopped.
"""

import hashlib
import json
import secrets
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from .intake.roster import Student
from .judging.questions import Course, seed
from .judging.running import close
from .judging.work import Handed, Task, work
from .plan import Plan, plan
from .results.changes import changes
from .results.decisions import NAME, apply, read_decisions
from .results.gradebook import Gradebook
from .results.marks import Graded
from .results.standing import left_standing, together
from .settings import Settings

__all__ = ["grade"]

SHOWN = 10  # marks that a regrade has changed
LOST = 3  # how often a worker may die
MOST_WAITING = 50_000_000  # bytes of notebooks that are read ahead


def grade(
    place: str | Path,
    out: str | Path,
    *,
    roster: Sequence[Student] = (),
    key: bytes | None = None,
    settings: Settings = Settings(),
    jobs: int = 1,
    scheduler: str | None = None,
    exercise: str = "",
    progress: Callable[[int, int], None] = lambda done, of: None,
    finish: Callable[[list[Graded], Plan], None] = lambda results, planned: None,
) -> tuple[list[Graded], Plan]:
    """Grade everything that was handed in; what an earlier run graded, and has not changed since,
    is kept.

    What the teacher decided in ``decisions.yaml`` in that folder is part of what is returned and of
    ``grades.csv``; it is read and never written. Marks of other lessons, and of work that is not
    among what is graded now, stand as they are.

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
    finish : callable
        Called at the end with what is returned, before another grader may write in ``out``.

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
    decisions = read_decisions(book.folder / NAME, planned.course.settings)
    book.check_ours({*planned.found, *book.students()})
    if exercise and not book.students():
        raise ValueError(
            f"grade: {out}: expected marks of which {exercise} is to be graded again, found none;"
            " grade without --exercise first"
        )
    with book.alone():
        earlier = book.decided()
        todo, kept = _todo(planned, book, key)
        done = len(kept)
        progress(done, len(planned.found))
        for graded in _worked(todo, planned.course, jobs, scheduler):
            book.write(together(book.read(graded.student), graded, exercise))
            done += 1
            progress(done, len(planned.found))
        others = [student for student in book.students() if student not in planned.found]
        results = [
            *(graded for student in planned.found if (graded := book.read(student))),
            *(left_standing(graded) for student in others if (graded := book.read(student))),
        ]
        decided, stale = apply(results, decisions, planned.course.settings)
        for graded, with_decisions in zip(results, decided):
            book.write(graded, with_decisions)
        book.write_grades(decided, roster)
        changed = changes(earlier, decided)
        book.write_changes(changed)
        planned = replace(planned, notes=(*planned.notes, *stale, *_told(changed)))
        finish(decided, planned)
    return decided, planned


def _told(changed):
    """What a regrade changed, in a few sentences; all of it is in a file."""
    for each in changed[:SHOWN]:
        yield f"{each.student}, {each.exercise}: {each.before} before, {each.now} now: {each.why}"
    if len(changed) > SHOWN:
        yield f"and {len(changed) - SHOWN} more marks have changed; all are in changes.csv"


def _todo(planned, book, key):
    """What is left to do, as a generator of tasks that reads each submission only then, and who is
    done.
    """
    kept = set()
    if not planned.course.only:
        for student, mine in planned.found.items():
            before = book.read(student)
            if before is not None and before.fingerprint == _fingerprint(
                student, mine, planned.course
            ):
                kept.add(student)
    return (
        _whole(student, mine, planned.course, book, key)
        for student, mine in planned.found.items()
        if student not in kept
    ), kept


def _whole(student, mine, course, book, key):
    """(task, course) of a student; an exercise alone is graded only where the rest has been."""
    before = book.read(student)
    number = (before and before.number) or secrets.token_hex(16)
    task = replace(
        _task(student, mine, course),
        number=number,
        seeds={e.id: seed(key, number, student, e.id) for e in course.exercises},
    )
    if course.only and (
        before is None or course.only not in {mark.exercise for mark in before.marks}
    ):
        whole = replace(course, only="")
        seeds = {e.id: seed(key, number, student, e.id) for e in whole.exercises}
        return replace(task, seeds=seeds), whole
    return task, course


def _task(student, mine, course):
    handed = tuple(
        Handed(notebook.name, notebook.read(), notebook.when, notebook.source)
        for notebook in mine.notebooks
    )
    return Task(
        student,
        handed,
        tuple(mine.notes),
        _fingerprint(student, mine, course),
        mine.numbers_of,
        mine.refused,
    )


def _fingerprint(student, mine, course):
    told = [
        course.lessons,
        repr(course.settings),
        course.variants.get(student),
        [(one.name, str(one.when), one.look.print) for one in mine.notebooks],
        mine.notes,
    ]
    return hashlib.sha256(json.dumps(told).encode()).hexdigest()[:16]


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


def _room_for_more(waiting, jobs):
    """Whether another submission may be read: a few for each worker, large ones one by one."""
    held = sum(len(handed.raw) for task, _ in waiting.values() for handed in task.notebooks)
    return not waiting or (len(waiting) < 2 * jobs and held < MOST_WAITING)


def _pooled(todo, jobs):
    """Over processes, a few submissions ahead of each; a worker that dies costs a new pool, not a
    mark.
    """
    from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
    from concurrent.futures.process import BrokenProcessPool
    from multiprocessing import get_context

    again: list[tuple[Task, Course]] = []
    lost = 0
    todo = iter(todo)
    while True:
        waiting: dict[Future[Graded], tuple[Task, Course]] = {}
        pool = ProcessPoolExecutor(jobs, mp_context=get_context("spawn"))
        try:
            while True:
                while (
                    _room_for_more(waiting, jobs)
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
