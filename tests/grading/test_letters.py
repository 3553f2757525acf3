"""Letters count in the order in which a notebook showed its options; one that does not say whose
numbers it has is not taken at its word.
"""

import re
from types import SimpleNamespace

import pytest

from dhlab.course.exercises import exercises
from dhlab.grading.handing_out.variants import variant
from dhlab.grading.inside.wire import encode
from dhlab.grading.judging.judge import Answers, mark
from dhlab.grading.judging.work import Handed
from dhlab.grading.results.decisions import Decided, Decisions, Student, apply
from dhlab.grading.results.marks import Graded
from dhlab.grading.settings import Settings

OWN = variant(b"k" * 32, "ada")
QUESTION = exercises()["05.2"]


def letter(number):
    """The letter of the right option, read off the list that a notebook of these numbers shows."""
    right = re.escape(QUESTION.options[QUESTION.correct].text)
    return re.search(rf'^- `"(\w)"` {right}$', QUESTION.shown(number), re.MULTILINE)[1]


def marked(answer, raw):
    """The mark of an answer that a notebook of these bytes gave."""
    answers = Answers()
    line = {"check": QUESTION.id, "value": encode(answer)}
    answers.add(SimpleNamespace(lines=[line], ended="done", cell=None), Handed("a.ipynb", raw))
    return mark(QUESTION, answers, OWN, Settings(), ask=None)[0]


RELEASED = f'{{"variant": {OWN}}}'.encode()
WITHOUT = [b"{}", b'{"source": "set_variant(1)"}', b'{"variant": 0}']


def test_the_order_of_ones_own_copy_counts():
    assert letter(OWN) != letter(0)
    assert marked(letter(OWN), RELEASED).status == "right"
    assert marked(letter(0), RELEASED).status == "wrong"


@pytest.mark.parametrize("raw", WITHOUT)
def test_without_numbers_what_is_right_in_one_order_alone_is_for_the_teacher(raw):
    for number, whose in ((0, "the lesson for all"), (OWN, "this student's own copy")):
        found = marked(letter(number), raw)
        assert (found.status, found.points, found.of) == ("to be marked", 0, 1)
        assert found.note == f"right by the letters of {whose} alone" and found.chosen == ()
        assert "does not say in which order" in found.headline
    wrong = next(each for each in "abcd" if each not in (letter(0), letter(OWN)))
    assert marked(wrong, raw).status == "wrong"
    assert marked(QUESTION.correct, raw).status == "right", "no letter, but the option's own name"


def test_of_a_copy_with_anothers_numbers_no_option_is_told():
    """Whoever was sent the wrong folder wrote the letter of another option than in the own one."""
    theirs = next(n for n in range(OWN + 1, OWN + 99) if letter(n) not in (letter(OWN), letter(0)))
    found = marked(letter(theirs), f'{{"variant": {theirs}}}'.encode())
    assert (found.status, found.points, found.chosen, found.mistake) == ("wrong", 0, (), None)
    assert "another order" in found.headline and not found.why
    assert marked("z", f'{{"variant": {theirs}}}'.encode()).headline.startswith("expected one of")


def test_the_teachers_mark_stands_for_that_answer_alone():
    held = marked(letter(0), b"{}")
    given = Decisions({"ada": Student(exercises={QUESTION.id: Decided(1, answer=held.answer)})})

    def decided(found):
        ((one,), stale) = apply([Graded("ada", "a", "graded", (found,))], given, Settings())
        return one.marks[0].status, one.total, len(stale)

    assert decided(held) == ("marked", 1, 0)
    assert decided(marked(letter(OWN), b"{}")) == ("to be marked", 0, 1)
