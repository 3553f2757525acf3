"""What costs the grader itself nothing more, however much of it is handed in; and rows and cells of
the exports that a name cannot make.
"""

import csv
import io
import sys
from itertools import product
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parent))
import corpus
from corpus import answer

from dhlab.course.exercises import exercises
from dhlab.grading.cage.listener import Run
from dhlab.grading.exports.gradebooks import canvas_csv
from dhlab.grading.grade import grade
from dhlab.grading.inside.book import MOST
from dhlab.grading.intake.roster import Student
from dhlab.grading.judging.borrowed import _tail
from dhlab.grading.judging.judge import Answers, mark
from dhlab.grading.judging.work import Handed
from dhlab.grading.results.csvtext import csv_text
from dhlab.grading.results.marks import Graded, Mark
from dhlab.grading.settings import Settings


def test_forged_notes_are_judged_no_oftener_than_a_notebook_sends_them():
    exercise, open_ = exercises()["05.5"], {"check": "05.5", "value": [{"...": 1}, 1.0, 2.0]}
    judged = []

    class Counted(type(exercise)):
        def judge(self, answer, variant=0):
            judged.append(answer)
            return super().judge(answer, variant)

    answers = Answers()
    answers.add(Run([open_] * 30_000, "done"), Handed("a.ipynb", b"{}"))
    counted = Counted(**vars(exercise))
    found, _ = mark(counted, answers, 0, Settings(), lambda *given: None)
    assert found.status == "not attempted" and 0 < len(judged) <= MOST


def test_the_last_note_counts_among_many():
    right, wrong = ({"check": "05.2", "value": letter} for letter in ("any", "?"))
    key = exercises()["05.2"].correct
    answers = Answers()
    answers.add(Run([wrong] * 200 + [right | {"value": key}], "done"), Handed("a.ipynb", b"{}"))
    found, _ = mark(exercises()["05.2"], answers, 0, Settings(), lambda *given: None)
    assert found.status == "right"


@pytest.mark.parametrize("seed", range(5))
def test_the_chance_to_fit_is_that_over_all_sets(seed):
    rng = np.random.default_rng(seed)
    rare = rng.uniform(0.003, 0.6, 9)
    evidence = -np.log(rare[rng.permutation(9)[:4]]).sum()
    exact = sum(
        np.prod(np.where(chosen, rare, 1 - rare))
        for chosen in product([True, False], repeat=9)
        if -np.log(rare[list(chosen)]).sum() >= evidence - 1e-9
    )
    assert exact <= _tail(rare, evidence) * (1 + 1e-9) and _tail(rare, evidence) < 1.05 * exact


def test_the_chance_over_sixty_answers_is_found_too():
    rare = np.full(60, 0.5)
    assert _tail(rare, -60 * np.log(0.5)) == pytest.approx(0.5**60, rel=1e-6)


@pytest.mark.parametrize("name", ["Points Possible", "Mr points  possible", "xPOINTS POSSIBLEx"])
def test_canvas_takes_no_student_for_the_row_of_points(name):
    marks = {s: Graded(s, "", "graded", (Mark("05.1", "right", 1, 1),)) for s in ("ada", "m")}
    text = canvas_csv(marks, [Student("ada", "Ada"), Student("m", name)])
    rows = list(csv.reader(io.StringIO(text)))
    words = ["points possible" in " ".join(row[0].split()).lower() for row in rows]
    assert words == [False, True, False, False] and rows[3][2:4] == ["m", "m"]


@pytest.mark.parametrize(
    "name", ['x;"=1+1;y', 'x;" "" =1+1', 'x\t"@SUM(1)', 'x\n"-1+1;', 'x; "＝1']
)
def test_no_quote_in_a_cell_begins_a_formula(name):
    text = csv_text([["ada", name, "graded"], [name, "", name]])
    for delimiter in ",;\t":
        cells = [c for row in csv.reader(io.StringIO(text), delimiter=delimiter) for c in row]
        assert not [c for c in cells if c.lstrip(' "').startswith(tuple("=+-@＝"))], cells


@pytest.mark.cage
def test_what_an_error_says_moves_no_cursor(tmp_path):
    make = answer("05.9", "del A_3\nraise ValueError('\\x9b2J\\x7f\\u202ex')")
    corpus.put(tmp_path / "class" / "mallory", make, {})
    ((found,), _) = grade(tmp_path / "class", tmp_path / "out")
    note = {one.exercise: one.note for one in found.marks}["05.9"]
    assert note.isprintable() and note.startswith("ValueError: ·2J")
    text = (tmp_path / "out" / "marks" / "mallory.json").read_text(encoding="utf-8")
    assert not {"\x9b", "\x7f", "\u202e"} & set(text)
