"""A course that nbgrader generates, grades and exports: sources with hidden tests, settings,
students, due dates.
"""

import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import nbformat

from ...course.building.reading import read_source, sources
from ...formats.files import write_text
from ..handing_out.release import make_folder
from ..intake.roster import Student
from ..judging.questions import scored
from ..results.csvtext import csv_text
from ..settings import Settings

__all__ = ["export_nbgrader", "source_notebook"]

STUB = "...  # your code here"
REGION = "### BEGIN SOLUTION"
CHECK = re.compile(r'^check\("([^"]+)"', re.MULTILINE)
CONFIG = '''"""The settings of this course for nbgrader."""

c = get_config()  # noqa: F821  (nbgrader gives it)
c.CourseDirectory.course_id = "dhlab"
# the default raises, and an untouched cell is no error here
c.ClearSolutions.code_stub = {{"python": "{stub}"}}
c.Execute.timeout = {timeout}
c.OverwriteCells.add_missing_cells = True  # a deleted check costs nobody a mark
c.AssignLatePenalties.plugin_class = "dhlab.grading.exports.nbgrader_late.Lateness"
c.Lateness.percent_per_day = {percent_per_day}
c.Lateness.floor = {floor}
c.Lateness.grace_hours = {grace_hours}
'''


def export_nbgrader(
    out: str | Path, roster: Sequence[Student] = (), settings: Settings | None = None
) -> list[str]:
    """Write a course folder for nbgrader; nothing that exists is overwritten.

    Parameters
    ----------
    out : str or path
    roster : sequence of Student
        For ``students.csv``, which ``nbgrader db student import`` reads.
    settings : Settings, optional
        Lessons, points, due dates and lateness; every lesson when it names none.

    Returns
    -------
    list of str
        The assignments, such as ``["05-link-matrix"]``.

    Raises
    ------
    ValueError
        The lessons' sources are not there (they are in the repository, not in an installed
        package), or a file exists.
    """
    out, settings = Path(out), settings or Settings()
    chosen: dict[str, list[Path]] = {}  # an assignment: a lesson with all its sittings
    for path in sources():
        if not settings.lessons or path.name[:2] in settings.lessons:
            first = next((name for name in chosen if name[:2] == path.name[:2]), path.stem)
            chosen.setdefault(first, []).append(path)
    if not chosen:
        raise ValueError(
            "export nbgrader: expected the lessons' sources in solutions/, found none; run it in a"
            " clone of the repository"
        )
    texts = _texts(chosen, roster, settings)
    there = [name for name in texts if (out / name).exists()]
    if there:
        raise ValueError(
            f"{out}: expected a new course folder, found one that exists with {there[0]} in it;"
            " choose another --out"
        )
    for name, text in texts.items():
        make_folder((out / name).parent)
        write_text(out / name, text)
    return list(chosen)


def _texts(chosen, roster, settings):
    """The files of the course folder: by their place in it, what is to stand there."""
    late = {name: getattr(settings, name) for name in ("percent_per_day", "floor", "grace_hours")}
    timeout = round(settings.limits.cell_seconds)
    lessons = [(name, settings.lessons.get(name[:2])) for name in chosen]
    due = [(name, lesson.due.isoformat()) for name, lesson in lessons if lesson and lesson.due]
    people = [_person(student) for student in roster]
    return {
        "nbgrader_config.py": CONFIG.format(stub=STUB, timeout=timeout, **late),
        "students.csv": csv_text([("id", "first_name", "last_name", "email"), *people]),
        "assignments.csv": csv_text([("name", "duedate"), *due]),
    } | {
        f"source/{name}/{path.stem}.ipynb": nbformat.writes(source_notebook(path, settings)) + "\n"
        for name, paths in chosen.items()
        for path in paths
    }


def source_notebook(path: Path, settings: Settings) -> Any:
    """A lesson as nbgrader's instructor version: every answer a solution cell, every check a graded
    one that hands back points.
    """
    notebook = read_source(path)
    marked = {exercise.id: exercise for exercise in scored((path.name[:2],))}
    for cell in notebook.cells:
        if cell.cell_type != "code":
            continue
        cell.metadata.pop("nbgrader", None)
        checked = CHECK.search(cell.source)
        if REGION in cell.source:
            name = cell.metadata.get("exercise", cell["id"]).replace(".", "-")
            cell.metadata["nbgrader"] = _role(f"answer-{name}", solution=True)
        elif checked and checked[1] in marked:
            exercise = marked[checked[1]]
            points = settings.points(exercise)
            cell.source = _graded(cell.source, points, settings)
            cell.metadata["nbgrader"] = _role(
                f"check-{exercise.id.replace('.', '-')}", points=points
            )
    return notebook


def _role(grade_id, *, solution=False, points=None):
    graded = {} if points is None else {"points": points}
    return {
        "grade": points is not None,
        "grade_id": grade_id,
        "locked": not solution,
        "schema_version": 3,
        "solution": solution,
        "task": False,
    } | graded


def _graded(source, points, settings):
    """The learner's line stays as it is; what is hidden before it puts another ``check`` in the
    place of the course's own.
    """
    return "\n".join(
        [
            "### BEGIN HIDDEN TESTS",
            "from dhlab.grading.exports.nbgrader_cell import graded_check",
            f"check = graded_check(points={points!r}, partial={settings.partial!r})",
            "### END HIDDEN TESTS",
            source,
        ]
    )


def _person(student):
    first, _, last = student.name.rpartition(" ")
    return student.student, first, last, student.email
