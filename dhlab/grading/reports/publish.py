"""After grading: a page of feedback for each student, and the class report."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from ...course.workspace import handed_out
from ..intake.notebooks import LARGEST, parsed
from ..intake.roster import Student
from ..intake.timestamps import handed_in
from ..results.marks import NOT_ATTEMPTED, Graded
from ..shown import some
from .alike import alike, answers, is_cut
from .answered import keep_answers, own_answers, read_answers
from .classreport import write_class_report
from .feedback import write_feedback
from .made import made_while_running

if TYPE_CHECKING:
    from ..plan import Plan

__all__ = ["publish"]


def publish(
    planned: Plan, results: Sequence[Graded], roster: Sequence[Student], out: str | Path
) -> Path:
    """Write ``feedback/<student>.html`` for everyone and ``class-report.html``; keep what
    everyone wrote, for the review.

    Parameters
    ----------
    planned : Plan
    results : sequence of Graded
    roster : sequence of Student
    out : str or path

    Returns
    -------
    Path
        Of the class report.
    """
    folder = Path(out) / "feedback"
    folder.mkdir(exist_ok=True)
    known = {student.student: student for student in roster}
    codes: dict[str, dict[str, str]] = {}
    shown: list[Graded] = []
    for graded in results:
        mine = planned.found.get(graded.student)
        if mine is not None:
            notebooks = dict(_read(mine.notebooks))
            zone = planned.course.settings.zone
            came = {one.name: handed_in(one.when, one.source, zone) for one in mine.notebooks}
            own = {(name, came[name]): own_answers(one) for name, one in notebooks.items()}
            keep_answers(graded, own, out)
            unseen = (*_unseen(graded, own, came.items()), *_uncompared(graded, notebooks))
            code = _compared(graded, notebooks)
            graded = replace(graded, notes=(*graded.notes, *unseen, *_made(code)))
            if mine.notebooks:
                codes[graded.student] = code
        shown.append(graded)
        student = known.get(graded.student, Student(graded.student))
        write_feedback(graded, student, folder, read_answers(graded.student, out))
    given = {
        exercise: code
        for path in sorted(handed_out().glob("*.ipynb"))
        for exercise, code in answers(json.loads(path.read_text(encoding="utf-8"))).items()
    }
    return write_class_report(shown, roster, out, alike(codes, given, known.keys()))


def _used(graded, notebooks):
    """The notebooks that marks come from, by name; all where none does."""
    used = {mark.file for mark in graded.marks}
    return {name: one for name, one in notebooks.items() if name in used} or notebooks


def _compared(graded, notebooks):
    """The code by exercise, of every file that earned a mark: a newer one may hold next to none."""
    found: dict[str, str] = {}
    for one in _used(graded, notebooks).values():
        for key, code in answers(one).items():
            found[key] = found.get(key, "") + code
    return found


def _uncompared(graded, notebooks):
    for name, one in _used(graded, notebooks).items():
        if is_cut(one):
            yield f"{name}: longer than is compared with others: look at the file"


def _made(code):
    """A sentence on the answers of which nobody can see what ran."""
    if found := made_while_running(code):
        yield (
            f"{some(found, len(found))}: may be made while it runs, from a text, bytes or a file,"
            " and is then not compared: look at the answer"
        )


def _unseen(graded, own, files):
    """A sentence on each file, a name and when it came, that earns marks and of whose answers less
    than half are found here: what is not read is compared with nobody's.
    """
    marked: dict[tuple[str, str], set[str]] = {}
    for mark in graded.marks:
        file = mark.file, mark.handed_in
        if file in files and mark.status != NOT_ATTEMPTED:
            marked.setdefault(file, set()).add(mark.exercise)
    for file, keys in marked.items():
        if 2 * len(keys & own.get(file, {}).keys()) < len(keys):
            yield (
                f"{file[0]}: most of its answers are not found here: not compared, look at the file"
            )


def _read(notebooks):
    """(name, notebook) of a student's files, oldest first: the newest ones, as many as may be read
    together; what cannot be read is nobody's copy and has no answers to show.
    """
    found, left = [], LARGEST
    for one in reversed(notebooks):
        if one.size <= left:
            with contextlib.suppress(ValueError):
                found.append((one.name, parsed(one.read())))
                left -= one.size
    return reversed(found)
