"""What the grader keeps on disk: a file of marks per student, written whole or not at all, and
``grades.csv`` made from them.
"""

import json
import os
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import unquote

from ...formats import files
from ..intake.roster import Student
from .changes import Change
from .csvtext import csv_text
from .marks import HELD, NOT_HANDED_IN, TO_MARK, Graded
from .names import OURS, marks_stem, page_stem

__all__ = ["Gradebook"]


CHANGES = "changes.csv"
HEAD = ["student", "name", "status", "total", "points", "of", "late_days", "penalty"]


class Gradebook:
    """The folder that marks are written to.

    Parameters
    ----------
    folder : str or path
        Made, when it does not exist, by :meth:`alone`.
    """

    def __init__(self, folder: str | Path) -> None:
        self.folder = Path(folder)

    @contextmanager
    def alone(self) -> Iterator[None]:
        """While one grader writes here, no other does. The lock ends with the process, however that
        ends; where the file system knows no locks there is none.
        """
        try:
            (self.folder / "marks").mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise ValueError(
                f"grade: {self.folder}: expected a folder for the marks, found that it cannot be"
                f" made ({error.strerror}); choose another"
            ) from None
        try:
            from fcntl import LOCK_EX, LOCK_NB, flock
        except ImportError:  # not on Windows
            yield
            return
        marks = os.open(self.folder / "marks", os.O_RDONLY)
        try:
            flock(marks, LOCK_EX | LOCK_NB)
        except BlockingIOError:
            os.close(marks)
            raise ValueError(
                f"grade: {self.folder}: expected a folder that nobody else writes to, found that"
                " another grader is at work in it; wait for it, or choose another"
            ) from None
        except OSError:
            pass
        try:
            yield
        finally:
            os.close(marks)

    def path(self, student: str) -> Path:
        """Where a student's marks stand."""
        return self.folder / "marks" / f"{marks_stem(student)}.json"

    def students(self) -> list[str]:
        """Everybody whose marks stand here."""
        return [
            self._student(path)
            for path in sorted((self.folder / "marks").glob("*.json"))
            if not path.name.startswith(".")
        ]

    @staticmethod
    def _student(path):
        """Whose marks a file holds; a name that was too long stands in the file alone."""
        if "~" not in path.stem:
            return unquote(path.stem)
        try:
            return str(json.loads(files.read_text(path, "a student's marks"))["student"])
        except (ValueError, TypeError, KeyError):
            return unquote(path.stem)

    def read(self, student: str) -> Graded | None:
        """What was graded before, or None; ValueError when the file holds no marks of ours."""
        path = self.path(student)
        if not path.exists():
            return None
        text = files.read_text(path, "a student's marks")
        try:
            return Graded.from_dict(json.loads(text))
        except (ValueError, TypeError, KeyError, AttributeError):
            raise ValueError(
                f"grade: {path}: expected marks that dhlab wrote, found something else; move it"
                " away, and run again to grade this student anew"
            ) from None

    def decided(self) -> dict[str, Graded]:
        """Everybody's marks after the run before, with what the teacher had decided then."""
        found = {}
        for student in self.students():
            if self.read(student) is not None:
                told = json.loads(files.read_text(self.path(student), "a student's marks"))
                found[student] = Graded.from_dict(told.get("decided", told))
        return found

    def write_changes(self, found: Sequence[Change]) -> None:
        """``changes.csv``: what the last run changed; a run that changes nothing leaves it."""
        if found:
            text = csv_text([list(Change._fields), *map(list, found)])
            files.write_text(self.folder / CHANGES, text, overwrite=True)

    def check_ours(self, students: Iterable[str]) -> None:
        """ValueError when a file stands in the way that dhlab did not write; nothing has been
        written then.
        """
        sheet, pages = (
            self.folder / "grades.csv",
            [
                *self.folder.glob("class-report*.html"),
                *(self.folder / "feedback" / f"{page_stem(student)}.html" for student in students),
            ],
        )
        changed = (self.folder / CHANGES, ",".join(Change._fields))
        for path, sign in [(sheet, ",".join(HEAD)), changed, *((page, OURS) for page in pages)]:
            if path.exists() and sign not in self._beginning(path):
                raise ValueError(
                    f"grade: {path}: expected a place for what dhlab writes, found a file that it"
                    " did not write; move it away, or give another --out"
                )
        for student in self.students():
            self.read(student)

    @staticmethod
    def _beginning(path):
        try:
            with open(path, "rb") as file:
                return file.read(1000).decode("utf-8", "replace")
        except OSError:
            return ""

    def write(self, graded: Graded, decided: Graded | None = None) -> None:
        """Write one student's marks, whole or not at all; beside them, where they differ, the same
        with the teacher's decisions.
        """
        told = graded.to_dict()
        if decided is not None and decided != graded:
            told["decided"] = decided.to_dict()
        text = json.dumps(told, ensure_ascii=False, indent=1) + "\n"
        path = self.path(graded.student)
        if not path.exists() or path.read_bytes() != text.encode():
            files.write_text(path, text, overwrite=True)

    def write_grades(self, results: Sequence[Graded], roster: Sequence[Student] = ()) -> None:
        """``grades.csv``: a line with a status for each student, and the points of each
        exercise.
        """
        names = {student.student: student.name for student in roster}
        exercises = list(
            dict.fromkeys(mark.exercise for graded in results for mark in graded.marks)
        )
        exercises.sort(
            key=lambda key: (
                key.partition(".")[0],
                int(key.partition(".")[2]) if key.partition(".")[2].isdigit() else 0,
                key,
            )
        )
        bonus = ["bonus"] if any(graded.bonus for graded in results) else []
        head = [*HEAD, *exercises, *bonus, "handed_in", "file", "cage", "notes"]
        files.write_text(
            self.folder / "grades.csv",
            csv_text([head, *(self._row(graded, names, exercises, bonus) for graded in results)]),
            overwrite=True,
        )

    @staticmethod
    def _row(graded, names, exercises, bonus):
        points: dict[str, int | float | str] = {
            mark.exercise: TO_MARK if mark.status == TO_MARK else _plain(mark.points)
            for mark in graded.marks
            if mark.status != NOT_HANDED_IN and graded.status != HELD
        }
        numbers: list[int | float | None] = [
            _plain(number)
            for number in (
                *(graded.total, graded.points, graded.of),
                *(graded.late_days, graded.penalty),
            )
        ]
        if graded.status == HELD:  # no marks are given out
            numbers = [None] * len(numbers)
        return [
            graded.student,
            names.get(graded.student, ""),
            graded.status,
            *numbers,
            *(points.get(exercise) for exercise in exercises),
            *(_plain(graded.bonus) for _ in bonus),
            handed_in(graded.marks),
            graded.file,
            graded.cage,
            " | ".join(graded.notes),
        ]


def handed_in(marks):
    """When the latest answer of each lesson came, and how that is known: "2026-11-17 10:03, zip";
    with the lessons where they differ.
    """
    latest: dict[str, str] = {}
    for mark in marks:
        if mark.handed_in:
            latest[mark.lesson] = max(latest.get(mark.lesson, ""), mark.handed_in)
    return (
        next(iter(latest.values()))
        if len(set(latest.values())) == 1
        else "; ".join(f"{lesson}: {when}" for lesson, when in sorted(latest.items()))
    )


def _plain(number):
    """2, not 2.0."""
    return int(number) if number == int(number) else number
