"""``decisions.yaml``: what the teacher decides about marks. Grading reads it and never writes it,
so that it outlives every regrade.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from ...course.exercises import exercises
from ...formats import plainyaml
from ..settings import Settings, moment
from .marks import HELD, MARKED, TO_MARK, Graded, Mark
from .standing import lateness

if TYPE_CHECKING:
    from ...formats.plainyaml import Item

__all__ = ["NAME", "Decided", "Decisions", "read_decisions", "apply"]

NAME = "decisions.yaml"
MOST = 1000  # points
MOST_LINES = 50  # of a rubric


@dataclass(frozen=True)
class Decided:
    """What was decided of one exercise of one student: points (None: as graded), a comment, and
    what it had earned when that was decided (None: not said); of an explanation which answer it is
    about (empty: any), and which lines of its rubric were ticked, from 1.
    """

    points: float | None = None
    comment: str = ""
    was: float | None = None
    answer: str = ""
    ticks: tuple[int, ...] = ()


@dataclass(frozen=True)
class Student:
    """What was decided of one student: due dates by lesson, exercises, a bonus, why it is held."""

    due: Mapping[str, datetime] = field(default_factory=dict)
    exercises: Mapping[str, Decided] = field(default_factory=dict)
    bonus: float = 0.0
    comment: str = ""
    hold: str = ""


@dataclass(frozen=True)
class Decisions:
    """All of it: by student, and the exercises that do not count, each with the reason."""

    students: Mapping[str, Student] = field(default_factory=dict)
    dropped: Mapping[str, str] = field(default_factory=dict)


def read_decisions(path: str | Path, settings: Settings = Settings()) -> Decisions:
    """The Decisions in a file; none where there is no file.

    Parameters
    ----------
    path : str or path
        ::

            dropped: {"05.7": "the task was unclear"}     # counts for nobody
            students:
              ada:
                due: {"05": 2026-11-25}                   # for this student
                exercises:
                  "05.4": {points: 1.5, comment: "Right idea.", was: 0}
                bonus: 1                                  # after lateness
                comment: "Thank you for the talk."
              bo: {hold: "we have to talk"}               # no marks are given out
    settings : Settings
        For the time zone.

    Returns
    -------
    Decisions

    Raises
    ------
    ValueError
        One sentence with the line.
    """
    if not Path(path).exists():
        return Decisions()
    top = plainyaml.fields(
        plainyaml.read(path, "a teacher's decisions"),
        "decisions",
        required=set(),
        allowed={"students", "dropped"},
    )
    dropped = _named(top["dropped"], "dropped") if "dropped" in top else {}
    students = _named(top["students"], "students") if "students" in top else {}
    return Decisions(
        {name: _student(name, item, settings) for name, item in students.items()},
        {_exercise(key, item): plainyaml.text(item, key) for key, item in dropped.items()},
    )


def _named(item: Item, what: str) -> dict[str, Item]:
    if item.value is None:
        return {}
    if not isinstance(item.value, dict):
        raise ValueError(f"{item.where}: {what}: expected names with a colon each; see the docs")
    return item.value


def _student(name, item, settings):
    known = plainyaml.fields(
        item, name, required=set(), allowed={"due", "exercises", "bonus", "comment", "hold"}
    )
    due = _named(known["due"], f"{name}: due") if "due" in known else {}
    decided = _named(known["exercises"], f"{name}: exercises") if "exercises" in known else {}
    words = {
        key: plainyaml.text(known[key], f"{name}: {key}")
        for key in ("comment", "hold")
        if key in known
    }
    return Student(
        {key: moment(entry, f"{name}: due", settings.zone) for key, entry in due.items()},
        {_exercise(key, entry): _decided(key, entry) for key, entry in decided.items()},
        _points(known["bonus"], f"{name}: bonus", -MOST) if "bonus" in known else 0.0,
        **words,
    )


def _exercise(key, item):
    if key not in exercises():
        raise ValueError(
            f'{item.where}: expected the number of an exercise, such as "05.4", found {key!r}'
        )
    return key


def _decided(key, item):
    known = plainyaml.fields(
        item, key, required=set(), allowed={"points", "comment", "was", "answer", "ticks"}
    )
    return Decided(
        _points(known["points"], f"{key}: points") if "points" in known else None,
        plainyaml.text(known["comment"], f"{key}: comment") if "comment" in known else "",
        _points(known["was"], f"{key}: was") if "was" in known else None,
        plainyaml.text(known["answer"], f"{key}: answer") if "answer" in known else "",
        _ticks(known["ticks"], f"{key}: ticks") if "ticks" in known else (),
    )


def _ticks(item, what):
    lines = [plainyaml.number(one, what) for one in plainyaml.entries(item, what)]
    if not all(line == int(line) and 0 < line <= MOST_LINES for line in lines):
        raise ValueError(f"{item.where}: {what}: expected lines of the rubric, such as [1, 3]")
    return tuple(int(line) for line in lines)


def _points(item, what, least=0.0):
    value = plainyaml.number(item, what)
    if not least <= value <= MOST:
        raise ValueError(
            f"{item.where}: {what}: expected points from {least:g} to {MOST}, found {value:g}"
        )
    return value


def apply(
    results: Iterable[Graded], decisions: Decisions, settings: Settings
) -> tuple[list[Graded], list[str]]:
    """(marks with the teacher's decisions, sentences on decisions that no longer fit).

    Examples
    --------
    >>> graded = Graded("ada", "", "graded", (Mark("05.4", "wrong", 0, 2),))
    >>> given = Decisions({"ada": Student(exercises={"05.4": Decided(1.5, was=0)}, bonus=1)})
    >>> (one,), stale = apply([graded], given, Settings())
    >>> one.total, one.marks[0].status, stale
    (2.5, 'wrong', [])
    """
    results = list(results)
    known = {graded.student for graded in results}
    stale = [
        f"{NAME}: decides about {student!r}, of whom there are no marks"
        for student in decisions.students
        if student not in known
    ]
    found = []
    for graded in results:
        mine = decisions.students.get(graded.student, Student())
        stale += _stale(graded, mine, settings)
        found.append(_one(graded, mine, decisions.dropped, settings))
    return found, stale


def _stale(graded, mine, settings):
    earned = {mark.exercise: mark for mark in graded.marks}
    for key, decided in mine.exercises.items():
        where = f"{NAME}: {graded.student}, {key}"
        if key not in earned:
            yield f"{where}: there is no such mark"
        elif of_another(decided, earned[key]):
            yield f"{where}: marked before another answer was handed in: mark it again"
        elif decided.was is not None and abs(decided.was - earned[key].points) > 1e-9:
            yield (
                f"{where}: decided when it had earned {decided.was:g}; it earns"
                f" {earned[key].points:g} now: look at it again"
            )
        elif decided.points is not None and decided.points > earned[key].of:
            yield f"{where}: {decided.points:g} points, but only {earned[key].of:g} are possible"
    for lesson in mine.due:
        if lesson not in settings.lessons or settings.lessons[lesson].due is None:
            yield f"{NAME}: {graded.student}: lesson {lesson} has no due date in course.yaml"


def of_another(decided: Decided, mark: Mark) -> bool:
    """Whether a decision is about an answer that has been replaced since."""
    return bool(decided.answer and mark.answer) and decided.answer != mark.answer


def _one(graded, mine, dropped, settings):
    marks = tuple(_mark(mark, mine, dropped, settings) for mark in graded.marks)
    days, penalty = lateness(marks)
    return replace(
        graded,
        marks=marks,
        late_days=days,
        penalty=penalty,
        bonus=mine.bonus,
        comment=mine.comment,
        status=HELD if mine.hold else graded.status,
        notes=(*graded.notes, f"on hold: {mine.hold}") if mine.hold else graded.notes,
    )


def _mark(mark: Mark, mine: Student, dropped: Mapping[str, str], settings: Settings) -> Mark:
    if mark.exercise in dropped:
        said = f"This exercise is not counted: {dropped[mark.exercise]}"
        return replace(mark, points=0, of=0, comment=said)
    if mark.lesson in mine.due and mark.handed_in:
        came = datetime.strptime(mark.handed_in[:16], "%Y-%m-%d %H:%M").replace(
            tzinfo=settings.zone
        )
        days, penalty = settings.late_after(mine.due[mark.lesson], came)
        mark = replace(mark, late_days=days, penalty=penalty)
    decided = mine.exercises.get(mark.exercise)
    if decided is None or of_another(decided, mark):
        return mark
    if mark.answer:
        status = TO_MARK if decided.points is None else MARKED
        return replace(mark, status=status, points=decided.points or 0, comment=decided.comment)
    points = mark.points if decided.points is None else decided.points
    changed = abs(points - mark.points) > 1e-9
    note = f"by the teacher; the grader gave {mark.points:g}" if changed else ""
    return replace(
        mark,
        points=points,
        comment=decided.comment,
        note="; ".join(filter(None, (mark.note, note))),
    )
