"""The grades as learning platforms take them in: Canvas's and Moodle's CSV. A status that is no
mark stays an empty cell, never a silent 0.
"""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from ...formats.files import read_text
from ..intake.roster import Student
from ..results.csvtext import csv_text
from ..results.marks import GRADED, NOT_ATTEMPTED, TIMED_OUT, Graded

__all__ = ["read_marks", "canvas_csv", "moodle_csv"]

WITH_MARK = (GRADED, NOT_ATTEMPTED, TIMED_OUT)


def read_marks(folder: str | Path) -> dict[str, Graded]:
    """What ``dhlab grade`` left in its folder, by student.

    Parameters
    ----------
    folder : str or path
        The ``--out`` of the grader.

    Returns
    -------
    dict of str to Graded

    Raises
    ------
    ValueError
        There are no marks in it, or a file is not one of the grader's.
    """
    paths = sorted((Path(folder) / "marks").glob("*.json"))
    if not paths:
        raise ValueError(
            f"{folder}: expected a folder that dhlab grade has written, found no marks in it; give"
            " its --out"
        )
    return {graded.student: graded for graded in map(_read, paths)}


def _read(path):
    try:
        told = json.loads(read_text(path, "a student's marks"))
        return Graded.from_dict(told.get("decided", told))
    except (KeyError, TypeError, AttributeError, json.JSONDecodeError):
        raise ValueError(
            f"{path}: expected marks that dhlab grade wrote, found something else; delete it and"
            " grade again"
        ) from None


def canvas_csv(marks: Mapping[str, Graded], roster: Sequence[Student] = ()) -> str:
    """Canvas's gradebook import: its five columns of names and ids, a row of possible points, one
    column of points after lateness.

    Canvas finds a student by the SIS id or the login; the roster's ``student`` is given as both.

    Examples
    --------
    >>> from dhlab.grading.results.marks import Graded, Mark
    >>> marks = Mark("05.1", "right", 1, 1), Mark("05.2", "wrong", 0, 2)
    >>> print(canvas_csv({"ada": Graded("ada", "", "graded", marks)}), end="")
    Student,ID,SIS User ID,SIS Login ID,Section,dhlab 05
    Points Possible,,,,,3
    ada,,ada,ada,,1
    """
    title, of = _column(marks)
    rows = [
        ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", title],
        ["Points Possible", "", "", "", "", of],
    ]
    rows += [
        [
            student.name or student.student,
            "",
            student.student,
            student.student,
            "",
            _points(marks.get(student.student)),
        ]
        for student in _students(marks, roster)
    ]
    return csv_text(rows)


def moodle_csv(marks: Mapping[str, Graded], roster: Sequence[Student] = ()) -> str:
    """Moodle's grade import: id number, e-mail, name, points after lateness; the teacher maps the
    columns on Moodle's own page.

    Examples
    --------
    >>> from dhlab.grading.results.marks import Graded, Mark
    >>> graded = Graded("ada", "", "missing", (Mark("05.1", "not attempted", 0, 1),))
    >>> print(moodle_csv({"ada": graded}, [Student("ada", "Ada", "ada@example.org")]), end="")
    ID number,Email address,Full name,dhlab 05
    ada,ada@example.org,Ada,
    """
    title, _ = _column(marks)
    rows = [["ID number", "Email address", "Full name", title]]
    rows += [
        [student.student, student.email, student.name, _points(marks.get(student.student))]
        for student in _students(marks, roster)
    ]
    return csv_text(rows)


def _students(marks, roster):
    """The roster, since a platform may refuse a whole file for one person it does not know; without
    one, everybody who was graded.
    """
    return roster or [Student(student) for student in marks]


def _column(marks):
    """What the column is called, after the lessons in it, and the possible points."""
    lessons = sorted(
        {mark.exercise.partition(".")[0] for graded in marks.values() for mark in graded.marks}
    )
    return f"dhlab {' '.join(lessons)}", _number(
        max((graded.of for graded in marks.values()), default=0)
    )


def _points(graded):
    return _number(graded.total) if graded is not None and graded.status in WITH_MARK else None


def _number(value):
    return int(value) if value == int(value) else value
