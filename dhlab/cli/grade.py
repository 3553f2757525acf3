"""The verb ``dhlab grade``: returned notebooks to marks, feedback and a class report."""

import json
import sys
from collections import Counter
from pathlib import Path
from typing import Annotated, Any

import typer

from .common import Course, Roster, class_of, settings_of

__all__ = ["grade"]


def grade(
    place: Annotated[
        Path,
        typer.Argument(
            metavar="DIR",
            help="What was handed in: a folder or a zip, as your learning platform gives it.",
        ),
    ],
    out: Annotated[
        Path,
        typer.Option(
            "--out",
            metavar="DIR",
            help=(
                "Where marks, feedback and the class report go; a second run takes up where the"
                " first stopped."
            ),
        ),
    ],
    roster: Roster = "",
    key: Annotated[
        str,
        typer.Option(
            metavar="FILE",
            help="The teacher's key, when dhlab release gave everyone numbers of their own.",
        ),
    ] = "",
    course: Course = "",
    jobs: Annotated[int, typer.Option(min=1, help="Submissions at a time.")] = 1,
    scheduler: Annotated[
        str, typer.Option(metavar="ADDRESS", help="Grade on the workers of this Dask scheduler.")
    ] = "",
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Say what would be graded; run and write nothing.")
    ] = False,
    exercise: Annotated[
        str,
        typer.Option(metavar="ID", help="Grade only this exercise again; the other marks stay."),
    ] = "",
    cage: Annotated[
        str,
        typer.Option(
            metavar="LEVEL",
            help=(
                "bubblewrap (when left out), or landlock or rlimits, which are weaker, where"
                " bubblewrap does not work."
            ),
        ),
    ] = "",
    as_json: Annotated[
        bool, typer.Option("--json", help="Print JSON for a program to read.")
    ] = False,
) -> None:
    """Grade a class: marks and feedback for every student, and a report of what the class got
    wrong.
    """
    from ..grading.grade import grade as grade_all
    from ..grading.handing_out.variants import read_key
    from ..grading.plan import plan
    from ..grading.reports.publish import publish

    students = class_of(roster)
    common: dict[str, Any] = {
        "roster": students,
        "key": read_key(key) if key else None,
        "settings": _in_cage(settings_of(course), cage),
        "exercise": exercise,
    }
    if dry_run:
        _tell_plan(plan(place, **common), as_json)
        return
    reports = []

    def finish(results, planned):
        reports.append(publish(planned, results, students, out))

    try:
        with _Bar() as bar:
            common |= {"progress": bar.update, "finish": finish}
            results, planned = grade_all(
                place, out, jobs=jobs, scheduler=scheduler or None, **common
            )
    except KeyboardInterrupt:
        print(
            "dhlab: grade: stopped; every mark written so far is kept: run the same command again"
            " to go on",
            file=sys.stderr,
        )
        raise
    print(
        json.dumps([graded.to_dict() for graded in results], ensure_ascii=False)
        if as_json
        else _summary(results, planned, reports[0], students)
    )


def _in_cage(settings, level):
    from dataclasses import replace

    from ..grading.settings import LEVELS

    if level and level not in LEVELS:
        raise ValueError(f"grade: --cage: expected {', '.join(LEVELS)}, found {level!r}")
    return replace(settings, cage=level) if level else settings


def _tell_plan(planned, as_json):
    from ..grading.cage.levels import best_level

    level = planned.course.settings.cage or best_level()
    if as_json:
        print(json.dumps(_plan_data(planned, level), ensure_ascii=False))
    else:
        print(_plan_text(planned, level))


def _plan_data(planned, level):
    return {
        "lessons": planned.course.lessons,
        "cage": level,
        "notes": planned.notes,
        "students": {
            student: {
                "notebooks": [notebook.name for notebook in mine.notebooks],
                "handed_in": _when(mine, planned.course),
                "notes": mine.notes,
            }
            for student, mine in planned.found.items()
        },
    }


def _plan_text(planned, level):
    from ..grading.cage.levels import RISKS
    from ..printing import grid_text

    rows = [
        [
            student,
            "; ".join(notebook.name for notebook in mine.notebooks) or "nothing",
            "; ".join(_when(mine, planned.course)),
            " | ".join(mine.notes),
        ]
        for student, mine in planned.found.items()
    ]
    return "\n".join(
        [
            grid_text(["student", "handed in", "when", "notes"], rows),
            "",
            f"Lessons: {', '.join(planned.course.lessons)}.",
            f"Cage: {RISKS[level]}.",
            *(f"Note: {note}." for note in planned.notes),
            "Nothing was run or written.",
        ]
    )


def _when(mine, course):
    """When each notebook was handed in, how that is known, and how late it is for each of its
    lessons that is graded.
    """
    from ..grading.intake.timestamps import handed_in
    from ..grading.reports.pages import duration, words

    told = []
    for notebook in mine.notebooks:
        late = [
            course.settings.lateness(lesson, notebook.when)
            for lesson in sorted(notebook.look.lessons)
            if lesson in course.lessons
        ]
        days, penalty = max(late, default=(0.0, 0.0))
        told.append(
            handed_in(notebook.when, notebook.source, course.settings.zone)
            + (f", {duration(days, words('en'))} late: {100 * penalty:g} % off" if days else "")
        )
    return told


def _summary(results, planned, report, roster):
    from ..grading.cage.levels import RISKS
    from ..grading.reports.classreport import headcount

    counted = ", ".join(
        f"{count} {status}"
        for status, count in Counter(graded.status for graded in results).most_common()
    )
    levels = sorted({graded.cage for graded in results if graded.cage})
    return "\n".join(
        [
            f"{headcount(results, roster)}: {counted}.",
            *(f"Cage: {RISKS[level]}." for level in levels),
            *(f"Note: {note}." for note in planned.notes),
            (
                f"Marks: {report.parent / 'grades.csv'}. Report: {report}. Feedback:"
                f" {report.parent / 'feedback'}."
            ),
        ]
    )


class _Bar:
    """A progress bar on standard error, where somebody is looking."""

    def __enter__(self):
        self._bar = None
        if not sys.stderr.isatty():
            return self
        from rich.console import Console
        from rich.progress import BarColumn, MofNCompleteColumn, Progress, TimeRemainingColumn

        self._bar = Progress(
            "grading",
            BarColumn(),
            MofNCompleteColumn(),
            TimeRemainingColumn(),
            console=Console(stderr=True),
        )
        self._bar.start()
        self._task = self._bar.add_task("grading", total=None)
        return self

    def update(self, done, of):
        if self._bar is not None:
            self._bar.update(self._task, completed=done, total=of)

    def __exit__(self, *error):
        if self._bar is not None:
            self._bar.stop()
