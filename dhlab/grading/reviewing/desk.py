"""What lies on the teacher's desk: the marks of a class, what was answered, what was decided."""

import base64
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from ...course.exercises import exercises
from ...course.kinds import Explain, Lettered
from ..intake.roster import Student
from ..reports.answered import read_answers
from ..results.decisions import MOST, NAME, Decided, of_another, read_decisions
from ..results.decisions import Student as Of
from ..results.gradebook import Gradebook
from ..results.marks import ERROR, NOT_ALLOWED, NOT_HANDED_IN, TIMED_OUT, TO_MARK, WRONG, Graded
from ..shown import readable
from .edit import decide, hold
from .pictures import openable

__all__ = ["Desk"]

LONGEST = 4000  # letters of a comment
NOT_SHOWN = "# a picture is not shown: it is too large to be opened, or no picture"


class Desk:
    """The folder that ``dhlab grade`` wrote to, as the review shows it.

    Parameters
    ----------
    folder : str or path
    roster : sequence of Student
        For the names, and the order.

    Raises
    ------
    ValueError
        There are no marks in the folder, or the decisions cannot be read.
    """

    def __init__(self, folder: str | Path, roster: Sequence[Student] = ()) -> None:
        self.folder, self.decisions = Path(folder), Path(folder) / NAME
        book = Gradebook(folder)
        known = {student: book.read(student) for student in book.students()}
        order = [s.student for s in roster if s.student in known]
        order += [student for student in known if student not in set(order)]
        self.marks = {student: mine for student in order if (mine := known[student])}
        if not self.marks:
            raise ValueError(
                f"{folder}: expected a folder that dhlab grade has written, found no marks in it;"
                " give its --out"
            )
        self.names = {student.student: student.name for student in roster}
        read_decisions(self.decisions)

    def show(self) -> dict[str, Any]:
        """The whole class for the page: titles of exercises, and each student's marks with what is
        decided; no answers yet.
        """
        decided = read_decisions(self.decisions).students
        titles = {
            mark.exercise: exercises()[mark.exercise].title
            for mine in self.marks.values()
            for mark in mine.marks
            if mark.exercise in exercises()
        }
        order = {key: place for place, key in enumerate(exercises())}
        return {
            "exercises": [
                {"id": key, "title": titles[key]} | _asked(exercises()[key])
                for key in sorted(titles, key=lambda key: order[key])
            ],
            "students": [
                self._student(mine, decided.get(student, Of()))
                for student, mine in self.marks.items()
            ],
        }

    def answers(self, student: str) -> Mapping[str, list]:
        """What a student wrote, by exercise, as [text, the kinds of its pictures]; of an answer in
        letters also what it says.
        """
        kept = read_answers(student, self.folder)
        shown = {key: openable(own.pictures) for key, own in kept.items()}
        found = {
            key: f"{readable(own.code)}\n\n{NOT_SHOWN}".strip()
            if len(shown[key]) < len(own.pictures)
            else readable(own.code)
            for key, own in kept.items()
        }
        for mark in self.marks[student].marks:
            known = exercises().get(mark.exercise)
            if mark.chosen and isinstance(known, Lettered) and "?" not in mark.chosen:
                letters, text = known.read_back(mark.chosen)
                found[mark.exercise] = (
                    f"{found.get(mark.exercise, '')}\n\n# {text} ({letters} in the lesson for all)"
                ).strip()
        kinds = {key: [picture.kind for picture in own] for key, own in shown.items()}
        return {key: [text, kinds.get(key, [])] for key, text in found.items()}

    def picture(self, student: str, exercise: str, place: int) -> tuple[str, bytes] | None:
        """(kind, bytes) of a picture of an answer; None where there is none."""
        answer = read_answers(student, self.folder).get(exercise)
        shown = openable(answer.pictures) if answer else []
        if student not in self.marks or place >= len(shown):
            return None
        kind, data = shown[place]
        return kind, base64.b64decode(data)

    def save(self, given: Any) -> dict[str, Any]:
        """Take a decision in: of an exercise its ``points`` (None: as graded) and ``comment``, or
        of a student ``hold``, the reason; what is then decided of the student.

        Raises
        ------
        ValueError
            There is no such student or exercise, or points that are none.
        """
        mine = self.marks.get(str(given.get("student"))) if isinstance(given, dict) else None
        if mine is None:
            raise ValueError(
                "review: expected a student of whom there are marks; load the page anew"
            )
        if "hold" in given:
            hold(self.decisions, mine.student, _text(given["hold"]))
        else:
            mark = {mark.exercise: mark for mark in mine.marks}.get(str(given.get("exercise")))
            if mark is None:
                raise ValueError("review: expected an exercise that is marked; load the page anew")
            points = _points(given.get("points"), mark.of)
            said = {"points": points, "comment": _text(given.get("comment", ""))}
            was = None if points is None or mark.answer else mark.points
            about = {
                "was": was,
                "answer": mark.answer if points is not None else None,
                "ticks": _ticks(given.get("ticks", []), mark.exercise),
            }
            decide(self.decisions, mine.student, mark.exercise, said | about)
        decided = read_decisions(self.decisions).students.get(mine.student, Of())
        return self._student(mine, decided)

    def _student(self, mine: Graded, decided: Of) -> dict[str, Any]:
        return {
            "id": mine.student,
            "name": self.names.get(mine.student) or mine.student,
            "status": mine.status,
            "hold": decided.hold,
            "notes": list(mine.notes),
            "marks": {
                mark.exercise: _mark(mark, decided.exercises.get(mark.exercise, Decided()))
                for mark in mine.marks
                if mark.status != NOT_HANDED_IN
            },
        }


def _asked(exercise):
    """The question and what earns points, where a person marks."""
    if not isinstance(exercise, Explain):
        return {}
    return {"question": exercise.question, "rubric": exercise.rubric}


def _mark(mark, decided):
    if of_another(decided, mark):
        decided = Decided()
    lines = {"Where": mark.place, "Why": mark.why, "Next": mark.next, "Note": mark.note}
    return {
        "status": mark.status,
        "points": mark.points,
        "of": mark.of,
        "headline": mark.headline,
        "lines": [[label, text] for label, text in lines.items() if text],
        "file": mark.file,
        "came": mark.handed_in,
        # what a program cannot settle by itself
        "look": mark.status in (ERROR, TIMED_OUT, NOT_ALLOWED, TO_MARK)
        or (mark.status == WRONG and mark.mistake is None and not mark.chosen),
        "given": decided.points,
        "comment": decided.comment,
        "ticks": list(decided.ticks),
        "stale": decided.was is not None and abs(decided.was - mark.points) > 1e-9,
    }


def _text(value):
    if not isinstance(value, str) or len(value) > LONGEST:
        raise ValueError(
            f"review: expected a text of at most {LONGEST} letters; write a shorter one"
        )
    return "".join(c if c.isprintable() or c == "\n" else " " for c in value).strip()


def _ticks(value, exercise):
    """The lines of a rubric, from 1."""
    rubric = getattr(exercises().get(exercise), "rubric", ())
    lines = range(1, len(rubric) + 1)
    if not isinstance(value, list) or not all(type(k) is int and k in lines for k in value):
        raise ValueError("review: expected lines of the rubric; load the page anew")
    return sorted(set(value))


def _points(value, of):
    if value is None:
        return None
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0 <= value <= MOST:
        raise ValueError(f"review: expected points from 0 to {of:g}, found none; write a number")
    return float(value)
