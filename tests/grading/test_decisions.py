"""What a teacher decides outlives every regrade, and every mark is what is worked out by hand."""

import csv
import sys
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from dhlab.grading.exports.gradebooks import read_marks
from dhlab.grading.reports.feedback import feedback_page
from dhlab.grading.results.decisions import apply, read_decisions
from dhlab.grading.results.gradebook import Gradebook
from dhlab.grading.results.marks import Graded, Mark
from dhlab.grading.settings import Lesson, Settings

SETTINGS = Settings(
    {"05": Lesson(datetime(2026, 11, 20, 12, tzinfo=UTC))}, percent_per_day=10, floor=50
)
TEXT = """
dropped: {"05.7": "the task was unclear"}
students:
  ada:
    due: {"05": 2026-11-22 12:00}
    exercises:
      "05.4": {points: 1.5, comment: "<b>Right idea.</b>", was: 0}
    bonus: 1
    comment: "Thank you for the talk."
  bo: {hold: "two of the same"}
  cy: {exercises: {"05.4": {points: 2, was: 1}}}
  nobody: {bonus: 1}
"""


def graded(student):
    """Handed in on the 22nd at 8: two days begun after the due date."""
    marks = tuple(
        Mark(key, status, points, of, handed_in="2026-11-22 08:00, zip", late_days=1.8, penalty=0.2)
        for key, status, points, of in (
            ("05.1", "right", 1, 1),
            ("05.4", "wrong", 0, 2),
            ("05.7", "right", 1, 1),
        )
    )
    return Graded(student, "x.ipynb", "graded", marks, late_days=1.8, penalty=0.2)


@pytest.fixture
def decisions(tmp_path):
    (tmp_path / "decisions.yaml").write_text(TEXT, encoding="utf-8")
    return read_decisions(tmp_path / "decisions.yaml", SETTINGS)


def test_every_mark_is_as_worked_out_by_hand(decisions):
    class_ = [graded(student) for student in ("ada", "bo", "cy", "dee")]
    assert [one.total for one in class_] == [1.6] * 4
    found, stale = apply(class_, decisions, SETTINGS)
    by = {one.student: one for one in found}
    # 1 + 1.5, not late any more, and 1; 05.7 counts for nobody
    assert (by["ada"].points, by["ada"].of, by["ada"].penalty, by["ada"].total) == (2.5, 3, 0, 3.5)
    assert (by["cy"].points, by["cy"].total) == (3, 2.4)
    assert (by["dee"].points, by["dee"].of, by["dee"].total) == (1, 3, 0.8)
    assert by["bo"].status == "on hold"
    assert any("nobody" in note for note in stale)
    assert any("cy, 05.4: decided when it had earned 1; it earns 0 now" in note for note in stale)
    assert len(stale) == 2


def test_decisions_outlive_three_regrades_and_reach_whoever_reads_the_marks(tmp_path, decisions):
    book = Gradebook(tmp_path / "out")
    with book.alone():
        for points in (0, 0, 2):
            machine = [
                replace(
                    one,
                    marks=tuple(
                        replace(mark, points=points) if mark.exercise == "05.4" else mark
                        for mark in one.marks
                    ),
                )
                for one in (graded("ada"), graded("bo"), graded("dee"))
            ]
            found, stale = apply(machine, decisions, SETTINGS)
            for one, with_decisions in zip(machine, found):
                book.write(one, with_decisions)
            book.write_grades(found)
            assert book.read("ada") == machine[0], "the grader's own marks stand as they are"
            assert read_marks(tmp_path / "out")["ada"].total == 3.5
            assert ("ada, 05.4" in " ".join(stale)) == (points == 2)
    with open(tmp_path / "out" / "grades.csv", encoding="utf-8-sig") as file:
        rows = {row["student"]: row for row in csv.DictReader(file)}
    assert (rows["ada"]["total"], rows["ada"]["bonus"], rows["ada"]["05.4"]) == ("3.5", "1", "1.5")
    assert (rows["bo"]["status"], rows["bo"]["total"], rows["bo"]["05.1"]) == ("on hold", "", "")


def test_feedback_has_the_teachers_words_and_nothing_of_a_mark_on_hold(decisions):
    (ada, bo), _ = apply([graded("ada"), graded("bo")], decisions, SETTINGS)
    page = feedback_page(ada)
    assert "Thank you for the talk." in page and "&lt;b&gt;Right idea.&lt;/b&gt;" in page
    assert "not counted: the task was unclear" in page and "3.5 of 3" in page
    held = feedback_page(bo)
    assert "on hold" in held and "05.1" not in held and "two of the same" not in held


@pytest.mark.parametrize(
    "text, words",
    [
        ('students: {ada: {exercises: {"05.44": {points: 1}}}}', "05.44"),
        ("students: {ada: {bonus: much}}", "expected a number"),
        ("students: {ada: {points: 3}}", "unknown key"),
        ('students: {ada: {exercises: {"05.4": {points: -1}}}}', "from 0 to"),
        ('students: {ada: {due: {"05": soon}}}', "expected a date"),
        ("students: [ada]", "names with a colon"),
    ],
)
def test_a_wrong_decision_is_told_with_its_line(tmp_path, text, words):
    (tmp_path / "decisions.yaml").write_text(text, encoding="utf-8")
    with pytest.raises(ValueError, match=f"line 1: .*{words}"):
        read_decisions(tmp_path / "decisions.yaml")
