"""The grades as learning platforms take them in: Canvas's and Moodle's CSV. A status that is no
mark stays an empty cell, never a silent 0.
"""

import json
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from ...formats.files import read_text
from ..intake.roster import Student
from ..results.csvtext import csv_text
from ..results.marks import (
    GRADED,
    HELD,
    NOT_ATTEMPTED,
    NOT_HANDED_IN,
    RIGHT,
    TIMED_OUT,
    TO_MARK,
    WRONG,
    Graded,
)
from ..results.standing import lateness

__all__ = ["read_marks", "settled", "canvas_csv", "moodle_csv"]

POINTS_POSSIBLE = "Points Possible"
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


def settled(
    marks: Mapping[str, Graded],
) -> tuple[dict[str, Graded], dict[str, int], dict[str, int]]:
    """(the marks without exercises that a person is still to mark for somebody, how many each of
    these waits for, and the same of exercises that programs mark): what counts for one counts for
    all. Where programs mark, and letters of one student are left to the teacher, the others keep
    what they have; who waits has no points for it yet.

    Examples
    --------
    >>> from dhlab.grading.results.marks import Graded, Mark
    >>> marks = Mark("05.1", "right", 1, 1), Mark("05.2", "marked", 2, 2)
    >>> ada = Graded("ada", "", "graded", marks)
    >>> waits = Mark("05.1", "to be marked", 0, 1), Mark("05.2", "to be marked", 0, 2)
    >>> found, waiting, single = settled({"ada": ada, "bo": Graded("bo", "", "graded", waits)})
    >>> found["ada"].total, found["ada"].of, waiting, single
    (1.0, 1, {'05.2': 1}, {'05.1': 1})
    """
    every = [mark for graded in marks.values() if graded.status != HELD for mark in graded.marks]
    waiting = Counter(mark.exercise for mark in every if mark.status == TO_MARK)
    judged = {mark.exercise for mark in every if mark.status in (RIGHT, WRONG)}
    open_ = waiting.keys() - judged
    found = {
        student: _of_these(graded, [mark for mark in graded.marks if mark.exercise not in open_])
        for student, graded in marks.items()
    }
    return (
        found if open_ else dict(marks),
        {key: count for key, count in waiting.items() if key in open_},
        {key: count for key, count in waiting.items() if key in judged},
    )


def _of_these(graded, marks, bonus=None):
    days, penalty = lateness(marks)
    bonus = graded.bonus if bonus is None else bonus
    return replace(graded, marks=tuple(marks), late_days=days, penalty=penalty, bonus=bonus)


def canvas_csv(
    marks: Mapping[str, Graded], roster: Sequence[Student] = (), by_lesson: bool = False
) -> str:
    """Canvas's gradebook import: its five columns of names and ids, a row of possible points, and
    the points after lateness, in one column or in one for each lesson.

    Canvas finds a student by the SIS id or the login; the roster's ``student`` is given as both.

    Examples
    --------
    >>> from dhlab.grading.results.marks import Graded, Mark
    >>> marks = Mark("05.1", "right", 1, 1), Mark("06.2", "wrong", 0, 2)
    >>> ada, roster = Graded("ada", "", "graded", marks), [Student("ada", "Ada", section="B")]
    >>> print(canvas_csv({"ada": ada}, roster), end="")
    Student,ID,SIS User ID,SIS Login ID,Section,dhlab 05 06
    Points Possible,,,,,3
    Ada,,ada,ada,B,1
    >>> print(canvas_csv({"ada": ada}, roster, by_lesson=True), end="")
    Student,ID,SIS User ID,SIS Login ID,Section,dhlab 05,dhlab 06
    Points Possible,,,,,1,2
    Ada,,ada,ada,B,1,0
    """
    columns = _columns(marks, by_lesson)
    rows = [
        ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", *(each[0] for each in columns)],
        [POINTS_POSSIBLE, "", "", "", "", *(each[1] for each in columns)],
    ]
    rows += [
        [
            _canvas_name(student),
            "",
            student.student,
            student.student,
            student.section,
            *(points.get(student.student) for _, _, points in columns),
        ]
        for student in _students(marks, roster)
    ]
    return csv_text(rows)


def moodle_csv(
    marks: Mapping[str, Graded], roster: Sequence[Student] = (), by_lesson: bool = False
) -> str:
    """Moodle's grade import: id number, e-mail, name, points after lateness, in one column or in
    one for each lesson; the teacher maps the columns on Moodle's own page.

    Examples
    --------
    >>> from dhlab.grading.results.marks import Graded, Mark
    >>> graded = Graded("ada", "", "missing", (Mark("05.1", "not attempted", 0, 1),))
    >>> print(moodle_csv({"ada": graded}, [Student("ada", "Ada", "ada@example.org")]), end="")
    ID number,Email address,Full name,dhlab 05
    ada,ada@example.org,Ada,
    """
    columns = _columns(marks, by_lesson)
    rows = [["ID number", "Email address", "Full name", *(each[0] for each in columns)]]
    rows += [
        [
            student.student,
            student.email,
            student.name,
            *(points.get(student.student) for _, _, points in columns),
        ]
        for student in _students(marks, roster)
    ]
    return csv_text(rows)


def _canvas_name(student):
    """Canvas finds nobody by this cell; but a row in which it holds the words of the second row is
    another second row to it.
    """
    taken = POINTS_POSSIBLE.casefold() in " ".join(student.name.split()).casefold()
    return student.student if taken or not student.name else student.name


def _students(marks, roster):
    """The roster, since a platform may refuse a whole file for one person it does not know; without
    one, everybody who was graded.
    """
    return roster or [Student(student) for student in marks]


def _columns(marks, by_lesson):
    """(what a column is called, the possible points, the points of each student who has some)."""
    lessons = sorted({mark.lesson for graded in marks.values() for mark in graded.marks})
    if not by_lesson:
        parts = [(f"dhlab {' '.join(lessons)}", marks)]
    else:
        parts = [(f"dhlab {lesson}", _lesson(marks, lesson)) for lesson in lessons]
        bonus = {student: _of_these(graded, ()) for student, graded in marks.items()}
        if any(graded.bonus for graded in marks.values()):
            parts.append(("dhlab bonus", bonus))
    return [
        (
            title,
            _number(max((graded.of for graded in found.values()), default=0)),
            {
                student: _number(graded.total)
                for student, graded in found.items()
                if graded.status in WITH_MARK
            },
        )
        for title, found in parts
    ]


def _lesson(marks, lesson):
    """The marks of one lesson, without bonus, of those who handed it in."""
    found = {
        student: _of_these(graded, [mark for mark in graded.marks if mark.lesson == lesson], 0)
        for student, graded in marks.items()
    }
    return {
        student: graded
        for student, graded in found.items()
        if any(mark.status != NOT_HANDED_IN for mark in graded.marks)
    }


def _number(value):
    return int(value) if value == int(value) else value
