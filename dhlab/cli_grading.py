"""The verbs ``dhlab release`` and ``dhlab export``: lessons for a class, and the course and its grades for other programs."""

from pathlib import Path
from typing import Annotated

import typer

__all__ = ["release", "export"]

Roster = Annotated[str, typer.Option(metavar="FILE.csv", help="The class: a column student and, where known, name, email, language.")]
Course = Annotated[str, typer.Option(metavar="FILE.yaml", help="Lessons, due dates, points, lateness, limits.")]
Key = Annotated[str, typer.Option(metavar="FILE", help="The teacher's key, from dhlab release.")]
Out = Annotated[Path, typer.Option("--out", metavar="FILE", help="A new file.")]
Marks = Annotated[Path, typer.Argument(metavar="GRADED", help="The folder that dhlab grade wrote to.")]

export = typer.Typer(help="The course for nbgrader or Gradescope, the grades for Canvas or Moodle.", rich_markup_mode=None)


def release(out: Annotated[Path, typer.Option("--out", metavar="DIR", help="Where the lessons go; nothing in it is overwritten.")],
            roster: Roster = "", course: Course = "",
            key: Annotated[str, typer.Option(metavar="FILE", help="Your key; teacher.key beside the roster when left out. Made when it is not there.")] = "",
            same: Annotated[bool, typer.Option("--same", help="The same numbers for everybody; no key.")] = False):
    """Hand out: a folder of lessons per student, each with the student's own numbers; without a roster, one folder for all."""
    from .grading.release import KEY_NAME, key_of
    from .grading.release import release as hand_out
    if key and (same or not roster):
        raise ValueError("release: --key draws each student's own numbers; it goes with --roster and without --same")
    students, lessons = _students(roster), tuple(_settings(course).lessons)
    place = Path(key) if key else Path(roster).parent / KEY_NAME
    secret, new = (None, False) if same or not students else key_of(place, out)
    written, kept = hand_out(out, students, secret, lessons, place if new else None)
    print(f"{len(students) or 1} {'folders' if len(students) > 1 else 'folder'} in {out}: {written} files written, {kept} there already.")
    if secret:
        print(f"{'Your new key' if new else 'Your key'}: {place}. Keep it, and keep it to yourself: without it nobody can grade these lessons, with it anybody can tell everyone's numbers.")


@export.command()
def nbgrader(out: Annotated[Path, typer.Option("--out", metavar="DIR", help="A new course folder.")], roster: Roster = "", course: Course = ""):
    """A course that nbgrader generates, grades and exports; everybody has the same numbers."""
    from .grading.exports.nbgrader import export_nbgrader
    names = export_nbgrader(out, _students(roster), _settings(course))
    print(f"{len(names)} assignments in {out}. In that folder:\n  nbgrader db student import students.csv\n  nbgrader db assignment import assignments.csv")
    print("\n".join(f"  nbgrader generate_assignment {name}" for name in names))


@export.command()
def gradescope(out: Out, roster: Roster = "", course: Course = "", key: Key = ""):
    """An autograder zip for a Gradescope programming assignment."""
    from .grading.exports.gradescope import export_gradescope
    from .grading.release import KEY_NAME
    from .grading.variants import read_key
    beside = Path(roster).parent / KEY_NAME
    if roster and not key and beside.exists():
        raise ValueError(f"export gradescope: expected --key, since {beside} stands beside the roster, found none; give --key {beside}, or move it away when everybody has the same numbers")
    count = export_gradescope(out, _students(roster), read_key(key) if key else None, course)
    print(f"{out}: an autograder of {count} files. Upload it as it is; the key is not in it.")


@export.command()
def canvas(marks: Marks, out: Out, roster: Roster = ""):
    """A CSV for the import of Canvas's gradebook."""
    from .grading.exports.gradebooks import canvas_csv
    _write_grades(canvas_csv, marks, out, roster)


@export.command()
def moodle(marks: Marks, out: Out, roster: Roster = ""):
    """A CSV for the grade import of Moodle."""
    from .grading.exports.gradebooks import moodle_csv
    _write_grades(moodle_csv, marks, out, roster)


def _write_grades(as_csv, marks, out, roster):
    from . import files
    from .grading.exports.gradebooks import WITH_MARK, read_marks
    found, students = read_marks(marks), _students(roster)
    files.write_text(out, as_csv(found, students))
    strangers = sorted(found.keys() - {student.student for student in students}) if students else []
    empty = sum(student not in found or found[student].status not in WITH_MARK for student in ([each.student for each in students] or found))
    print(f"{out}: written." + (f" Empty, since there is nothing to mark: {empty}." if empty else "") + (f" Left out, since they are not on the roster: {', '.join(strangers)}." if strangers else ""))


def _students(path):
    from .grading.roster import read_roster
    return read_roster(path) if path else ()


def _settings(path):
    from .grading.settings import Settings, read_settings
    return read_settings(path) if path else Settings()
