"""A student's page: the course's words, nothing of the tests, nothing raw, in the student's
language.
"""

import re
from html.parser import HTMLParser

import pytest

from dhlab.course.exercises import exercises
from dhlab.grading.intake.roster import Student
from dhlab.grading.reports.feedback import feedback_page, write_feedback
from dhlab.grading.reports.pages import words
from dhlab.grading.results.marks import OF_MARK, OF_STUDENT, Graded, Mark

HOSTILE = [
    "<script>alert(1)</script>",
    "<img src=x onerror=alert(1)>",
    "</style><b>",
    '"><svg onload=alert(1)>',
    "' onmouseover='x",
    "{{ 7 * 7 }}",
    "{% raw %}",
    "&lt;b&gt;",
    "javascript:alert(1)",
    "<!--",
    "]]>",
    "\x00\x1b[31mred",
    "\u202eevil\u202c",
    "<base href=//x>",
]
TAGS = {
    "html",
    "head",
    "meta",
    "title",
    "style",
    "body",
    "main",
    "h1",
    "h2",
    "pre",
    "h3",
    "p",
    "section",
    "div",
    "span",
    "dl",
    "dt",
    "dd",
}
EMPTY = {"meta"}


class Page(HTMLParser):
    """Every tag and attribute of a page, and its text; closed properly or not."""

    def __init__(self, html):
        super().__init__()
        self.tags, self.attributes, self.text, self.open, self.balanced = set(), set(), "", [], True
        self.feed(html)
        self.balanced = self.balanced and not self.open

    def handle_starttag(self, tag, attrs):
        self.tags.add(tag)
        self.attributes |= set(attrs)
        if tag not in EMPTY:
            self.open.append(tag)

    def handle_endtag(self, tag):
        self.balanced = self.balanced and bool(self.open) and self.open.pop() == tag

    def handle_data(self, data):
        if self.open[-1:] != ["style"]:
            self.text += data


def graded(*marks, **more):
    return Graded(
        **{"student": "ada", "file": "a.ipynb", "status": "graded", "marks": marks, **more}
    )


WRONG = Mark(
    "05.2",
    "wrong",
    0,
    1,
    "order-taken-for-free",
    "The headline.",
    "row 3",
    "The reason.",
    "The next step.",
    "for the teacher alone",
)


def test_the_words_of_the_course_are_there():
    page = Page(
        feedback_page(
            graded(
                WRONG,
                Mark("05.1", "right", 1, 1, headline="Well done.", penalty=0.25),
                penalty=0.25,
                late_days=1.5,
            )
        )
    )
    for said in (
        "The headline.",
        "row 3",
        "The reason.",
        "The next step.",
        "Moves that commute",
        "Well done.",
        "0.75 of 2 points",
        "(1 before lateness)",
        "1 of 2 exercises",
        "1 d 12 h late: 25 %",
    ):
        assert said in page.text
    assert page.balanced and page.tags <= TAGS


@pytest.mark.parametrize(
    "exercise, chosen, said",
    [
        ("05.2", ("none",), "none: every change of order is a mistake"),
        ("05.2", ("?",), "I don't know yet"),
        ("03.1", ("craig", "standard"), "Craig's; standard"),
        ("08.5", ("add-step",), "q = q + dq"),
    ],
)
def test_what_was_chosen_is_shown_in_words(exercise, chosen, said):
    html = feedback_page(graded(Mark(exercise, "wrong", 0, 1, chosen=chosen)))
    page = Page(html)
    assert "Your answer" in page.text and said in page.text
    assert page.balanced and page.tags <= TAGS | {"code"}
    assert ("<code>q = q + dq</code>" in html) == (exercise == "08.5")


@pytest.mark.parametrize("text", HOSTILE)
def test_nothing_is_raw(text):
    plain = Page(feedback_page(graded(WRONG), Student("ada", "Ada")))
    mark = Mark(text, "wrong", 0, 1, text, *[text] * 5)
    page = Page(
        feedback_page(
            Graded(text, text, "graded", (mark,), cage=text, notes=(text,), guess_of=text),
            Student(text, text),
        )
    )
    assert page.tags <= plain.tags and page.balanced
    assert {name for name, _ in page.attributes} == {name for name, _ in plain.attributes} and {
        v for n, v in page.attributes if n == "class"
    } <= {v for n, v in plain.attributes if n == "class"}
    assert not re.search(r"[\x00-\x08\x0b-\x1f\u202a-\u202e\u2066-\u2069]", page.text)
    assert re.sub(r"[\x00-\x1f\u202a-\u202e]", "·", text) in page.text, (
        "what was written is shown as it was written"
    )


def test_what_is_not_the_students_is_not_there():
    page = feedback_page(
        graded(WRONG, notes=("to the teacher",), guess_of="bo", file="where/it/was.ipynb")
    )
    for secret in ("for the teacher alone", "to the teacher", "bo<", "was.ipynb"):
        assert secret not in page


def test_no_input_of_a_test_and_no_right_answer():
    """A function that fails at drawn numbers is told so in the notebook with the numbers, and here
    without.
    """
    verdict = exercises()["05.4"].judge(lambda theta, d, a, alpha: [1, 2])
    assert verdict.place.startswith("seen at theta = ")
    page = feedback_page(
        graded(
            Mark(
                "05.4",
                "wrong",
                0,
                2,
                verdict.mistake,
                verdict.headline,
                verdict.place,
                verdict.why,
                verdict.next,
            )
        )
    )
    assert "seen at" not in page and "theta =" not in page and verdict.headline in page


def test_a_page_stands_alone():
    html = feedback_page(graded(WRONG))
    assert (
        "http" not in html.replace("http-equiv", "")
        and "<script" not in html
        and "src=" not in html
        and "href" not in html
        and "default-src 'none'" in html
    )


def test_what_a_program_says_is_cut_short():
    assert (
        len(feedback_page(graded(Mark("05.2", "wrong", 0, 1, headline="x" * 1_000_000)))) < 20_000
    )


@pytest.mark.parametrize("status", OF_STUDENT)
@pytest.mark.parametrize("language", ["en", "zh_CN"])
def test_every_status_has_its_sentence(status, language):
    marks = tuple(Mark("05.1", each, 0, 1) for each in OF_MARK)
    page = Page(feedback_page(graded(*marks, status=status), Student("ada", language=language)))
    assert (
        # of marks on hold nothing is given out
        all((words(language)[each] in page.text) == (status != "on hold") for each in OF_MARK)
        and words(language)[f"status {status}"] in page.text
    )
    assert bool(words(language)[f"status {status}"]) == (status != "graded")


def test_the_students_language():
    chinese = feedback_page(graded(WRONG), Student("li", "李小龙", language="zh_CN"))
    assert (
        '<html lang="zh-CN">' in chinese
        and "不正确" in chinese
        and "李小龙" in chinese
        and '<p lang="en">The headline.' in chinese
    )
    assert words("zh_CN").keys() == words("en").keys()
    assert all(
        sorted(re.findall(r"{\w+}", words("zh_CN")[key]))
        == sorted(re.findall(r"{\w+}", words("en")[key]))
        for key in words("en")
    )
    assert '<html lang="en">' in feedback_page(graded(WRONG), Student("jo", language="fr"))


def test_writing_again_replaces_and_never_leaves_half_a_page(tmp_path):
    path = write_feedback(graded(WRONG), Student("ada"), tmp_path)
    write_feedback(graded(Mark("05.2", "right", 1, 1)), Student("ada"), tmp_path)
    assert [p.name for p in tmp_path.iterdir()] == [
        "ada.html"
    ] and "The headline." not in path.read_text(encoding="utf-8")
