"""``dhlab course preview``: an exercise of each kind, as the page "Add an exercise" shows them."""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from dhlab.cli.course import preview as verb
from dhlab.course.building.faults import runs
from dhlab.course.exercises import exercises
from dhlab.course.preview import preview

PAGE = Path(__file__).parents[2] / "docs" / "add-an-exercise.md"
BLOCK = re.compile(r"^:caption: kinds.py\n\n(.*?)^```$", re.DOTALL | re.MULTILINE)


@pytest.fixture(scope="module")
def kinds():
    found = {}
    exec(compile(BLOCK.search(PAGE.read_text(encoding="utf-8"))[1], "kinds.py", "exec"), found)
    return {exercise.id: exercise for exercise in found["EXERCISES"]}


@pytest.mark.parametrize("key", ["90.1", "90.2", "90.3", "90.4"])
def test_the_right_answer_of_each_kind_is_right(kinds, key):
    shown = preview(kinds[key])
    assert kinds[key].title in shown and shown.count(f"\u2713 {key}  Right") == 1
    assert "\nmend " not in shown


def test_an_order_and_an_explanation(kinds):
    assert kinds["90.5"].judge(["a", "b"]).status == "right"
    assert "turn about z" in preview(kinds["90.5"])
    assert "names the axis (2)" in preview(kinds["90.6"])


def test_a_solution_may_hold_an_exercise_of_each_kind(kinds, monkeypatch):
    monkeypatch.setattr(runs, "exercises", lambda: kinds)
    assert [runs._full(key) for key in kinds] == ["right"] * 5 + ["recorded"]


def test_every_wrong_answer_is_shown_with_what_is_said_of_it():
    exercise = exercises()["05.9"]
    shown = preview(exercise, 3)
    known = list(exercise.mistakes(**exercise.given(3)))
    assert shown.count("\nwrong ") == len(known) and shown.count("\u2717 05.9") == len(known)
    assert all(mistake in shown for mistake, _, _ in known)


def test_what_is_wrong_is_told_with_its_line(kinds, monkeypatch):
    from dhlab.course.exercises import lesson05

    wrong = replace(exercises()["05.9"], hints=("a"), praise="", mistakes=lambda **given: ())
    listed = [wrong if exercise.id == "05.9" else exercise for exercise in lesson05.EXERCISES]
    monkeypatch.setattr(lesson05, "EXERCISES", listed)
    shown = preview(wrong)
    lines = Path(lesson05.__file__).read_text(encoding="utf-8").splitlines()
    line = next(k for k, text in enumerate(lines, 1) if 'id="05.9"' in text)
    for said in ("expected two hints", "expected praise", "5 wrong values or more, found 0"):
        assert re.search(rf"mend +lesson05.py, line {line}: .*{said}", shown), said
    scalar = replace(kinds["90.1"], answer=lambda: "much")
    assert "expected answer= to give numbers, found 'much'" in preview(scalar)


def test_the_verb(capsys):
    verb("05.2", 0, "", False)
    assert "Moves that commute" in capsys.readouterr().out
    with pytest.raises(ValueError, match="found '77.1'"):
        verb("77.1", 0, "", False)
