"""What a student gets back: one page with the course's words on each exercise, and nothing of the tests."""

from pathlib import Path

from ..course.exercises import exercises
from ..doctor import catalogue
from ..files import write_text
from .marks import ERROR, NOT_ALLOWED, NOT_ATTEMPTED, RIGHT, TIMED_OUT, WRONG
from .pages import render, words
from .roster import Student

__all__ = ["feedback_page", "write_feedback"]

SYMBOLS = {RIGHT: "✓", WRONG: "✗", NOT_ATTEMPTED: "○", ERROR: "✗", TIMED_OUT: "✗", NOT_ALLOWED: "✗"}
A_CALL = "seen at "  # how the check names the numbers it called with: an input of the tests


def feedback_page(graded, student=None):
    """The page of one student, as HTML that stands alone: no script, nothing fetched, every text escaped.

    What only the teacher should see (notes, whose answer this would be) is left out, and so are the numbers the checks called with.

    Parameters
    ----------
    graded : Graded
    student : Student, optional
        For the name and the language.

    Returns
    -------
    str

    Examples
    --------
    >>> from dhlab.grading.marks import Graded, Mark
    >>> page = feedback_page(Graded("<ada>", "a.ipynb", "graded", (Mark("05.2", "wrong", 0, 1, headline="<script>"),)))
    >>> "<script>" in page, "&lt;ada&gt;" in page
    (False, True)
    """
    student = student or Student(graded.student)
    said = words(student.language)
    cards = [_card(mark, said) for mark in graded.marks]
    return render("feedback.html", lang=said["lang"], words=said, graded=graded, name=student.name or graded.student, cards=cards,
                  right=sum(mark.status == RIGHT for mark in graded.marks))


def write_feedback(graded, student, folder):
    """Write ``<student>.html`` into a folder, over the page of an earlier run.

    Returns
    -------
    Path
    """
    path = Path(folder) / f"{graded.student}.html"
    write_text(path, feedback_page(graded, student), overwrite=True)
    return path


def _card(mark, said):
    known = exercises().get(mark.exercise)
    mistake = catalogue().get(mark.mistake)
    place = "" if mark.place.startswith(A_CALL) else mark.place
    lines = [(said[label], text) for label, text in (("where", place), ("why", mark.why), ("next", mark.next)) if text]
    return {"mark": mark, "title": known.title if known else "", "symbol": SYMBOLS[mark.status], "lines": lines,
            "lesson": mistake.lesson if mistake and mark.status != RIGHT else ""}
