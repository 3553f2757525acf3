"""``plan``: what is to be graded, found out without running any of it."""

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from ..course.exercises import exercises
from .handing_out.variants import variants
from .intake.files import FILE_TIME
from .intake.owners import look_whose
from .intake.roster import Student
from .intake.submissions import PASSED_OVER, Submission, submissions, voters
from .judging.questions import Course, handed_out_checks
from .own_items import own_checks
from .settings import Settings

__all__ = ["plan", "Plan"]


# without a course.yaml a lesson counts when so many handed it in, as a share of those who handed in
# the most common lesson; where nobody is on a roster, files of strangers may be among them
HANDED_IN, OF_STRANGERS = 0.2, 0.5


@dataclass(frozen=True)
class Plan:
    """What is to be graded: the course, each student's submission, and sentences for the
    teacher.
    """

    course: Course
    found: dict[str, Submission]
    notes: tuple[str, ...]


def plan(
    place: str | Path,
    roster: Sequence[Student] = (),
    key: bytes | None = None,
    settings: Settings = Settings(),
    exercise: str = "",
) -> Plan:
    """Look at what was handed in, without running any of it.

    Parameters
    ----------
    place : str or path
        A folder or a zip.
    roster : sequence of Student
    key : bytes or None
        The teacher's key, when each student had numbers of their own.
    settings : Settings
    exercise : str
        Grade only this one.

    Returns
    -------
    Plan

    Raises
    ------
    ValueError
        Nothing was found, there is no such exercise, or the key is not that of most notebooks.
    """
    if exercise and exercise not in exercises():
        raise ValueError(
            f'grade: expected the number of an exercise, such as "05.1", found {exercise!r}'
        )
    names = [path.stem for path in _handed_out()]
    names += [f"{lesson}-own" for lesson in own_checks()]
    found, notes = _without_strays(submissions(place, roster, names, settings.zone), roster)
    if not any(mine.notebooks for mine in found.values()):
        raise ValueError(
            f"{place}: expected submissions, found no notebook; is it the right folder?"
        )
    lessons, rare = _lessons(found, settings, {student.student for student in roster})
    if exercise and exercise.split(".")[0] not in lessons:
        raise ValueError(
            "grade: expected an exercise of the lessons"
            f" {', '.join(lessons) or '(none was found)'}, found {exercise!r}; name its lesson in"
            " course.yaml"
        )
    numbers = variants(key, found)
    notes += rare + look_whose(found, roster, key, numbers) + _all_late(voters(found), settings)
    course = Course(lessons, settings, numbers, exercise)
    if not course.exercises:
        raise ValueError(
            "grade: expected lessons with exercises that earn points, found"
            f" {', '.join(lessons) or 'none'}; name the lessons in course.yaml"
        )
    return Plan(course, found, tuple(notes))


def _handed_out():
    from ..course.workspace import handed_out

    return sorted(handed_out().glob("*.ipynb"))


def _without_strays(found, roster):
    """(students, notes): without files of no folder that are no notebooks and carry nobody's
    name.
    """
    known = {student.student for student in roster}
    strays = {
        student
        for student, mine in found.items()
        if mine.loose
        and student not in known
        and not mine.notebooks
        and all(note.endswith(PASSED_OVER) for note in mine.notes)
    }
    names = [
        note.partition(": no notebook")[0] for student in strays for note in found[student].notes
    ]
    told = (
        [f"passed over, neither notebooks nor anybody's name: {', '.join(sorted(names))}"]
        if names
        else []
    )
    return {student: mine for student, mine in found.items() if student not in strays}, told


def _all_late(found, settings):
    """A doubt, when every file is later than every due date by the time of the file: a copy has
    often no other.
    """
    dues = [lesson.due for lesson in settings.lessons.values() if lesson.due]
    notebooks = [notebook for mine in found.values() for notebook in mine.notebooks]
    if dues and all(
        notebook.source == FILE_TIME and notebook.when > max(dues) for notebook in notebooks
    ):
        return [
            "every notebook is late by the time of its file: were the files copied? cp -a keeps the"
            " times, cp -r does not"
        ]
    return []


def _lessons(found, settings, roster):
    """The lessons to grade: those of course.yaml, or those that the class handed in."""
    if settings.lessons:
        return tuple(sorted(settings.lessons)), []
    deciding = voters(found)
    seen, known = _handed_in(found), _handed_in(deciding)
    share = HANDED_IN if deciding.keys() & roster else OF_STRANGERS
    common = tuple(
        sorted(
            lesson
            for lesson, count in known.items()
            # what one student alone hands in counts for nobody else
            if count >= max(share * max(known.values()), min(2, max(known.values())))
        )
    )
    rare = [
        f"lesson {lesson} was handed in by {count} and does not count; name it in course.yaml if it"
        " should"
        for lesson, count in sorted(seen.items())
        if lesson not in common
    ]
    few = [
        f"lesson {lesson} was handed in by {known[lesson]} of {len(deciding)} and counts for"
        " everybody; name the lessons in course.yaml if it should not"
        for lesson in common
        if 2 * known[lesson] < max(known.values())
    ]
    return common, [*rare, *few]


def _handed_in(found):
    """How many handed in each lesson of the course."""
    seen = Counter(
        lesson
        for mine in found.values()
        for lesson in frozenset().union(*(notebook.look.lessons for notebook in mine.notebooks))
    )
    return {lesson: count for lesson, count in seen.items() if lesson in handed_out_checks()}
