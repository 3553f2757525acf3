"""What a student gets back: one page with the course's words on each exercise, and nothing of the
tests.
"""

import re
from collections.abc import Mapping
from itertools import groupby
from pathlib import Path

from ...course.exercises import exercises
from ...course.kinds import Lettered
from ...doctor import catalogue
from ...formats.files import write_text
from ..inside.wire import error_name
from ..intake.roster import Student
from ..results.marks import (
    ERROR,
    HELD,
    MARKED,
    MISSING,
    NOT_ALLOWED,
    NOT_ATTEMPTED,
    NOT_HANDED_IN,
    RIGHT,
    TIMED_OUT,
    TO_MARK,
    UNREADABLE,
    WRONG,
    Graded,
    Mark,
)
from ..results.names import page_stem
from .answered import Answer
from .pages import duration, render, words
from .sections import section_of_exercise, title_of_lesson

__all__ = ["feedback_page", "write_feedback", "headline"]

SYMBOLS = {
    RIGHT: "✓",
    WRONG: "✗",
    NOT_ATTEMPTED: "○",
    NOT_HANDED_IN: "○",
    ERROR: "✗",
    TIMED_OUT: "✗",
    NOT_ALLOWED: "✗",
    TO_MARK: "○",
    MARKED: "•",
}
# then the program's own words, in which it may tell what it was called with
STOPS = re.compile(r"(the (?:function|cell) stops with )([^:]*)")
A_CALL = "seen at "  # how the check names the numbers it called with: an input of the tests


def feedback_page(
    graded: Graded, student: Student | None = None, answers: Mapping[str, Answer] | None = None
) -> str:
    """The page of one student, as HTML that stands alone: no script, nothing fetched, every text
    escaped.

    What only the teacher should see (notes, whose answer this would be) is left out, and so are the
    numbers the checks called with.

    Parameters
    ----------
    graded : Graded
    student : Student, optional
        For the name and the language.
    answers : mapping, optional
        What the student wrote, by exercise; shown beside the verdict.

    Returns
    -------
    str

    Examples
    --------
    >>> from dhlab.grading.results.marks import Graded, Mark
    >>> wrong = Mark("05.2", "wrong", 0, 1, headline="<script>")
    >>> page = feedback_page(Graded("<ada>", "a.ipynb", "graded", (wrong,)))
    >>> "<script>" in page, "&lt;ada&gt;" in page
    (False, True)
    """
    student = student or Student(graded.student)
    said = words(student.language)
    held = graded.status == HELD  # then nothing is given out
    cards = (
        []
        if held
        else [_card(mark, said, (answers or {}).get(mark.exercise)) for mark in graded.marks]
    )
    no_file = (
        sorted({mark.lesson for mark in graded.marks if mark.status == NOT_HANDED_IN})
        if graded.status not in (MISSING, HELD)
        else []
    )
    sentence = said[
        (
            "no notebook"
            if graded.status == UNREADABLE and not graded.file
            else f"status {graded.status}"
        )
    ]
    return render(
        "feedback.html",
        lang=said["lang"],
        words=said,
        graded=graded,
        held=held,
        name=student.name or graded.student,
        cards=cards,
        lessons=_lessons(cards),
        sentence=sentence,
        no_file=no_file,
        late=duration(graded.late_days, said) if graded.penalty else "",
        right=sum(mark.status == RIGHT for mark in graded.marks),
    )


def write_feedback(
    graded: Graded,
    student: Student | None,
    folder: str | Path,
    answers: Mapping[str, Answer] | None = None,
) -> Path:
    """Write ``<student>.html`` into a folder, over the page of an earlier run.

    Returns
    -------
    Path
    """
    path = Path(folder) / f"{page_stem(graded.student)}.html"
    write_text(path, feedback_page(graded, student, answers), overwrite=True)
    return path


def headline(mark: Mark) -> str:
    """A mark's headline as the student may read it: of an error its kind, and not what the program
    says of it.

    Examples
    --------
    >>> from dhlab.grading.results.marks import Mark
    >>> told = "the function stops with ValueError: called with 0.25"
    >>> headline(Mark("05.4", "wrong", 0, 2, headline=told))
    'the function stops with ValueError'
    """
    stops = STOPS.match(mark.headline)
    return stops[1] + error_name(stops[2]) if stops else mark.headline


def _lessons(cards):
    """(title, points after lateness, possible points, points before it, cards) of each lesson."""
    for lesson, own in groupby(cards, key=lambda card: card["mark"].lesson):
        mine = list(own)
        marks = [card["mark"] for card in mine]
        of = sum(mark.of for mark in marks if mark.status != TO_MARK)
        points = sum(mark.points for mark in marks)
        counted = round(sum(mark.points * (1 - mark.penalty) for mark in marks), 2)
        yield title_of_lesson(lesson), counted, of, points, mine


def _card(mark, said, answer):
    known = exercises().get(mark.exercise)
    chosen = known.read_back(mark.chosen)[1] if isinstance(known, Lettered) and mark.chosen else ""
    mistake = catalogue().get(mark.mistake)
    place = "" if mark.place.startswith(A_CALL) else mark.place
    lines = [
        (said[label], text)
        for label, text in (("where", place), ("why", mark.why), ("next", mark.next))
        if text
    ]
    return {
        "mark": mark,
        "headline": headline(mark),
        "title": known.title if known else "",
        "symbol": SYMBOLS[mark.status],
        "answer": chosen,
        "code": answer.code if answer else "",
        "section": section_of_exercise(mark.exercise) if mark.status != RIGHT else "",
        "lines": lines,
        "lesson": mistake.lesson if mistake and mark.status != RIGHT else "",
    }
