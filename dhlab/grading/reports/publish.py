"""After grading: a page of feedback for each student, and the class report."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from ...course.workspace import handed_out
from ..intake.roster import Student
from ..results.marks import Graded
from .alike import alike, answers
from .answered import keep_answers, read_answers
from .classreport import write_class_report
from .feedback import write_feedback

if TYPE_CHECKING:
    from ..plan import Plan

__all__ = ["publish"]

# bytes of a notebook that is looked at for copies; lessons without pictures are far smaller
LARGEST = 2_000_000


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
    for graded in results:
        if graded.student in planned.found:
            mine = planned.found[graded.student].notebooks
            keep_answers(graded, [(each.name, each.read()) for each in mine], out)
        student = known.get(graded.student, Student(graded.student))
        write_feedback(graded, student, folder, read_answers(graded.student, out))
    codes = {student: _code(mine) for student, mine in planned.found.items() if mine.notebooks}
    given = {
        exercise: code
        for path in sorted(handed_out().glob("*.ipynb"))
        for exercise, code in answers(json.loads(path.read_text(encoding="utf-8"))).items()
    }
    return write_class_report(results, roster, out, alike(codes, given))


def _code(mine):
    """The code of each exercise a student answered; what cannot be read is nobody's copy."""
    found: dict[str, str] = {}
    for notebook in mine.notebooks:
        try:
            raw = notebook.read()
            found |= answers(json.loads(raw)) if len(raw) <= LARGEST else {}
        except (ValueError, RecursionError, TypeError):
            continue
    return found
