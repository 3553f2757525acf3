"""The verb ``dhlab export``: the course and its grades for other programs."""

from pathlib import Path
from typing import Annotated

import typer

from .common import Course, Roster, class_of, settings_of

__all__ = ["export"]

Key = Annotated[str, typer.Option(metavar="FILE", help="The teacher's key, from dhlab release.")]
Out = Annotated[Path, typer.Option("--out", metavar="FILE", help="A new file.")]
Marks = Annotated[
    Path, typer.Argument(metavar="GRADED", help="The folder that dhlab grade wrote to.")
]
ByLesson = Annotated[
    bool, typer.Option("--by-lesson", help="A column for each lesson, and one for a bonus.")
]

export = typer.Typer(
    help="The course for nbgrader or Gradescope, the grades for Canvas or Moodle.",
    rich_markup_mode=None,
)


@export.command()
def nbgrader(
    out: Annotated[Path, typer.Option("--out", metavar="DIR", help="A new course folder.")],
    roster: Roster = "",
    course: Course = "",
) -> None:
    """A course that nbgrader generates, grades and exports; everybody has the same numbers."""
    from ..grading.exports.nbgrader import export_nbgrader

    names = export_nbgrader(out, class_of(roster), settings_of(course))
    print(
        f"{len(names)} assignments in {out}. In that folder:\n  nbgrader db student import"
        " students.csv\n  nbgrader db assignment import assignments.csv"
    )
    print("\n".join(f"  nbgrader generate_assignment {name}" for name in names))


@export.command()
def gradescope(out: Out, roster: Roster = "", course: Course = "", key: Key = "") -> None:
    """An autograder zip for a Gradescope programming assignment."""
    from ..grading.exports.gradescope import export_gradescope
    from ..grading.handing_out.release import KEY_NAME
    from ..grading.handing_out.variants import read_key

    beside = Path(roster).parent / KEY_NAME
    if roster and not key and beside.exists():
        raise ValueError(
            f"export gradescope: expected --key, since {beside} stands beside the roster, found"
            f" none; give --key {beside}, or move it away when everybody has the same numbers"
        )
    count = export_gradescope(out, class_of(roster), read_key(key) if key else None, course)
    print(f"{out}: an autograder of {count} files. Upload it as it is; the key is not in it.")


@export.command()
def canvas(marks: Marks, out: Out, roster: Roster = "", by_lesson: ByLesson = False) -> None:
    """A CSV for the import of Canvas's gradebook."""
    from ..grading.exports.gradebooks import canvas_csv

    _write_grades(canvas_csv, marks, out, roster, by_lesson)


@export.command()
def moodle(marks: Marks, out: Out, roster: Roster = "", by_lesson: ByLesson = False) -> None:
    """A CSV for the grade import of Moodle."""
    from ..grading.exports.gradebooks import moodle_csv

    _write_grades(moodle_csv, marks, out, roster, by_lesson)


def _write_grades(as_csv, marks, out, roster, by_lesson):
    from ..formats import files
    from ..grading.exports.gradebooks import WITH_MARK, read_marks, settled

    (found, waiting, single), students = settled(read_marks(marks)), class_of(roster)
    files.write_text(out, as_csv(found, students, by_lesson))
    strangers = sorted(found.keys() - {student.student for student in students}) if students else []
    empty = sum(
        student not in found or found[student].status not in WITH_MARK
        for student in [each.student for each in students] or found
    )
    print(
        f"{out}: written."
        + (f" Empty, since there is nothing to mark: {empty}." if empty else "")
        + (
            f" Left out, since they are not on the roster: {', '.join(strangers)}."
            if strangers
            else ""
        )
        + "".join(
            f" {exercise} does not count yet, for anybody: {count} to be marked in dhlab review."
            for exercise, count in waiting.items()
        )
        + "".join(
            f" {exercise} is to be marked for {count} in dhlab review, without points until then."
            for exercise, count in single.items()
        )
    )
