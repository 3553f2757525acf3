"""What the grader keeps on disk: a file of marks per student, written whole or not at all, and ``grades.csv`` made from them."""

import json
import os
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import quote

from .. import files
from .csvtext import csv_text
from .marks import Graded

__all__ = ["Gradebook"]


class Gradebook:
    """The folder that marks are written to.

    Parameters
    ----------
    folder : str or path
        Made when it does not exist.

    Raises
    ------
    ValueError
        The folder cannot be made or written to.
    """

    def __init__(self, folder):
        self.folder = Path(folder)
        try:
            (self.folder / "marks").mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise ValueError(f"grade: {folder}: expected a folder for the marks, found that it cannot be made ({error.strerror}); choose another") from None

    @contextmanager
    def alone(self):
        """While one grader writes here, no other does. The lock ends with the process, however that ends; where the file system knows no locks there is none."""
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
            raise ValueError(f"grade: {self.folder}: expected a folder that nobody else writes to, found that another grader is at work in it; wait for it, or choose another") from None
        except OSError:
            pass
        try:
            yield
        finally:
            os.close(marks)

    def path(self, student):
        """Where a student's marks stand."""
        return self.folder / "marks" / f"{quote(student, safe=' @+')}.json"

    def read(self, student):
        """What was graded before, or None; a file that cannot be read counts as none and is written again."""
        try:
            given = json.loads(files.read_text(self.path(student), "a student's marks"))
            return Graded.from_dict(given)
        except (ValueError, TypeError, KeyError, AttributeError):
            return None

    def write(self, graded):
        """Write one student's marks, whole or not at all."""
        files.write_text(self.path(graded.student), json.dumps(graded.to_dict(), ensure_ascii=False, indent=1) + "\n", overwrite=True)

    def write_grades(self, results, roster=()):
        """``grades.csv``: a line with a status for each student, and the points of each exercise."""
        names = {student.student: student.name for student in roster}
        exercises = list(dict.fromkeys(mark.exercise for graded in results for mark in graded.marks))
        head = ["student", "name", "status", "total", "points", "of", "late_days", "penalty", *exercises, "file", "cage", "notes"]
        files.write_text(self.folder / "grades.csv", csv_text([head, *(self._row(graded, names, exercises) for graded in results)]), overwrite=True)

    @staticmethod
    def _row(graded, names, exercises):
        points = {mark.exercise: _plain(mark.points) for mark in graded.marks}
        numbers = map(_plain, (graded.total, graded.points, graded.of, graded.late_days, graded.penalty))
        return [graded.student, names.get(graded.student, ""), graded.status, *numbers, *(points.get(exercise) for exercise in exercises),
                graded.file, graded.cage, " | ".join(graded.notes)]


def _plain(number):
    """2, not 2.0."""
    return int(number) if number == int(number) else number
