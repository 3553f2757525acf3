"""Run by ``run_autograder`` on Gradescope: one submission through the cage, and
``results/results.json`` as Gradescope wants it.
"""

import json
import secrets
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

from ...course.exercises import exercises
from ...course.workspace import handed_out
from ...formats.files import write_text
from ..cage.levels import best_level
from ..cage.sight import OPEN
from ..intake.notebooks import numbers_of
from ..intake.submissions import submissions
from ..judging.questions import Course, seed
from ..judging.running import cage_of
from ..judging.work import Handed, Task, work
from ..reports.feedback import headline
from ..reports.pages import words
from ..results.marks import RIGHT
from ..settings import Settings, read_settings

__all__ = ["results"]


def results(root: Path) -> dict[str, Any]:
    """What Gradescope shows, for the submission in ``root/submission``.

    Parameters
    ----------
    root : path
        ``/autograder`` on Gradescope.

    Returns
    -------
    dict
        ``results.json``: an output, and a test for each exercise.

    Raises
    ------
    ValueError
        There is no closed room here, and course.yaml does not say to do without.
    """
    source = root / "source"
    settings = (
        read_settings(source / "course.yaml") if (source / "course.yaml").exists() else Settings()
    )
    lessons = tuple(settings.lessons) or tuple(
        sorted({path.name[:2] for path in handed_out().glob("[0-9][0-9]*-*.ipynb")})
    )
    student, variant = _student(root)
    handed_in = submissions(root / "submission").values()
    found = [notebook for one in handed_in for notebook in one.notebooks]
    notes = tuple(note for one in handed_in for note in one.notes)
    settings = replace(settings, percent_per_day=0.0)
    course = _in_a_cage(Course(lessons, settings, {student: variant}))
    if course.settings.cage == "rlimits":  # nothing keeps a submission from reading the others
        write_text(_variants(root), json.dumps({student: variant}), overwrite=True)
    number = secrets.token_hex(16)  # nobody knows it before
    task = Task(
        student,
        tuple(Handed(one.name, one.read(), one.when) for one in found),
        notes,
        refused=bool(notes),
        number=number,
        seeds={e.id: seed(None, number, student, e.id) for e in course.exercises},
    )
    strange = [
        handed.name
        for handed in task.notebooks
        if (given := numbers_of(handed.raw)) and given != {variant}
    ]
    return _shown(work(task, course), strange)


def _in_a_cage(course):
    """The course with the strongest walls that work, which are kept for the submission: Gradescope
    runs each in a container of its own, where bubblewrap may not work. Limits alone, in which a
    submission could look its answers up, must be named in course.yaml.
    """

    def at(level):
        return replace(course, settings=replace(course.settings, cage=level))

    level = course.settings.cage or best_level(lambda level: cage_of(at(level), OPEN))
    if level == "rlimits" and not course.settings.cage:
        raise ValueError(
            "grade: expected bubblewrap or Landlock, found that neither works in this container;"
            " write cage: rlimits into course.yaml and export again if you trust whoever hands in"
        )
    return at(level)


def _variants(root):
    return root / "source" / "variants.json"


def _student(root):
    """(address, variant) of who handed in; of a group, the first whose numbers are known."""
    known = json.loads(_variants(root).read_text(encoding="utf-8"))
    metadata = json.loads((root / "submission_metadata.json").read_text(encoding="utf-8"))
    users = metadata.get("users") or []
    # of an account without an address it is null
    emails = [(user.get("email") or "unknown").casefold() for user in users] or ["unknown"]
    email = next((email for email in emails if email in known), emails[0])
    return email, known.get(email, 0)


def _shown(graded, strange=()):
    said = words("en")
    ran = f"Run in: {graded.cage}." if graded.cage else ""
    told = (
        f"{', '.join(strange)}: these are not the numbers you were marked by; tell your teacher."
        if strange
        else ""
    )
    return {
        "output": " ".join(filter(None, (said[f"status {graded.status}"], told, ran))),
        "stdout_visibility": "hidden",
        "execution_time": round(graded.seconds),
        "tests": [_test(mark, said) for mark in graded.marks],
    }


def _test(mark, said):
    lines = [
        headline(mark),
        *(
            f"{said[label]}: {text}"
            for label, text in (("why", mark.why), ("next", mark.next))
            if text
        ),
    ]
    return {
        "number": mark.exercise,
        "name": exercises()[mark.exercise].title,
        "score": mark.points,
        "max_score": mark.of,
        "status": "passed" if mark.status == RIGHT else "failed",
        "output": "\n".join([said[mark.status], *filter(None, lines)]),
    }


def main():
    """Write the results of the submission under the folder that is given."""
    root = Path(sys.argv[1])
    try:
        told = results(root)
    except ValueError as error:  # Gradescope shows it to the teacher, and gives no marks
        sys.exit(str(error))
    text = json.dumps(told, ensure_ascii=False, indent=1) + "\n"
    write_text(root / "results" / "results.json", text, overwrite=True)


if __name__ == "__main__":
    main()
