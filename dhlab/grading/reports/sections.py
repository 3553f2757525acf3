"""Where the course treats an exercise or a mistake, and what to ask a class: read from the lessons,
the exercises and what the teacher's sheets ask.
"""

import json
import re
from functools import cache
from pathlib import Path

from ...course.kinds import Choice
from ...course.kinds.exercise import Exercise
from ...course.workspace import handed_out
from ...doctor import catalogue
from ...formats import plainyaml

__all__ = [
    "question",
    "section_of_exercise",
    "section_of_mistake",
    "sheet_question",
    "title_of_lesson",
]

DISCUSSION = Path(__file__).parents[2] / "course" / "discussion.yaml"
CALL = re.compile(r'^check\("([^"]+)"', re.MULTILINE)


@cache
def _lessons():
    """(title, {exercise: section}, {mistake: section}) of each notebook, by name."""
    return {
        path.stem: _read(json.loads(path.read_text(encoding="utf-8")))
        for path in sorted(handed_out().glob("[0-9][0-9]*-*.ipynb"))
    }


def _read(notebook):
    title = section = ""
    exercises: dict[str, str] = {}
    mistakes: dict[str, str] = {}
    for cell in notebook["cells"]:
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            heading = re.search(r"^(##?) (.+)$", source, re.MULTILINE)
            title, section = (title or heading[2], heading[2]) if heading else (title, section)
            if "mistake" in cell["metadata"]:
                mistakes[cell["metadata"]["mistake"]] = section
        else:
            exercises |= dict.fromkeys(CALL.findall(source), section)
    return title, exercises, mistakes


def section_of_exercise(exercise: str) -> str:
    """The lesson and the heading under which an exercise stands.

    Examples
    --------
    >>> section_of_exercise("05.3")
    '05 The link matrix: four moves, one formula, “The order of the moves”'
    """
    for title, exercises, _ in _lessons().values():
        if exercise in exercises:
            return f"{title}, “{exercises[exercise]}”"
    return ""


def title_of_lesson(lesson: str) -> str:
    """The title of a lesson's first sitting; its number where there is no such lesson.

    Examples
    --------
    >>> title_of_lesson("05")
    '05 The link matrix: four moves, one formula'
    """
    titles = [title for name, (title, _, _) in _lessons().items() if name.startswith(f"{lesson}-")]
    return titles[0] if titles else lesson


def section_of_mistake(mistake: str) -> str:
    """The heading under which a mistake is refuted, or the title of the lesson that treats it.

    Examples
    --------
    >>> section_of_mistake("every-order-taken-for-wrong")
    '05 The link matrix: four moves, one formula, “The order of the moves”'
    """
    for title, _, mistakes in _lessons().values():
        if mistake in mistakes:
            return f"{title}, “{mistakes[mistake]}”"
    lesson = catalogue()[mistake].lesson
    title = title_of_lesson(lesson)
    return title if title != lesson else f"lesson {lesson}"


def question(exercise: Exercise | None, mistake: str) -> str:
    """What to ask a class in which many made this mistake in this exercise: a wrong option in their
    own words, or what the mistake looks like.
    """
    if isinstance(exercise, Choice):
        claims = [key for key, option in exercise.options.items() if option.mistake == mistake]
        if claims:
            _, text = exercise.read_back((claims[0],))  # letters differ from student to student
            return f"Somebody says: “{text}”. What would convince them?"
    return f"“{catalogue()[mistake].see}” What was done here, and which one test shows it?"


def sheet_question(lesson: str) -> str:
    """The question to discuss of a lesson's teacher sheet; empty when it has none.

    Examples
    --------
    >>> sheet_question("05")[:35]
    'A program passes a test at θ = 0 an'
    """
    return _discussion().get(lesson, "")


@cache
def _discussion():
    return plainyaml.read(DISCUSSION, "the questions to discuss").plain()
