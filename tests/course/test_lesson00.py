"""Lesson 00: the warm-up is judged, the pre-test never is; its first answers are kept for the end
of the course.
"""

import json

import numpy as np
import pytest
from draws import variants

import dhlab as dh
from dhlab.course import session, then_and_now, workspace
from dhlab.course.building import contract, reading
from dhlab.course.exercises import exercises
from dhlab.course.kinds import PreTest
from dhlab.course.progress import Log
from dhlab.doctor import catalogue

QUESTIONS = {key: e for key, e in exercises().items() if isinstance(e, PreTest)}


def by_hand(R, v):
    """The product written out, row against vector."""
    return [sum(R[i][k] * v[k] for k in range(3)) for i in range(3)]


@pytest.mark.parametrize("variant", variants(20))
def test_the_warm_up_takes_right_answers_and_names_wrong_ones(variant):
    exercise = exercises()["00.1"]
    R, v = exercise.given(variant).values()
    assert np.allclose(R @ R.T, np.eye(3), atol=2e-3), "a turn, to the printed digits"
    for right in (by_hand(R, v), np.einsum("ij,j->i", R, v), tuple(np.dot(R, v).tolist())):
        assert exercise.judge(right, variant).status == "right"
    wrong = [
        np.dot(v, R),
        [sum(R[i][k] * v[k] for i in range(3)) for k in range(3)],
        [R[k][k] * v[k] for k in range(3)],
        v,
        R[:, 0],
        R[0],
        R @ R @ v,
        R,
        1.0,
        np.zeros(3),
        [1, 2],
        np.array(by_hand(R, v)) + 0.1,
    ]
    verdicts = [exercise.judge(answer, variant) for answer in wrong]
    assert all(v.status == "wrong" for v in verdicts)
    assert sum(v.mistake is not None for v in verdicts) >= 7


@pytest.mark.parametrize("variant", [0, 1, 5])
def test_what_the_text_invites_to_try_is_answered_in_its_words(variant):
    exercise = exercises()["00.1"]
    R, v = exercise.given(variant).values()
    entrywise, reversed_ = exercise.judge(R * v, variant), exercise.judge(v @ R, variant)
    assert entrywise.mistake == "elementwise-product" and "* in place of @" in entrywise.headline
    assert reversed_.mistake == "row-vector-convention" and "columns of R" in reversed_.headline
    for verdict in (entrywise, reversed_, exercise.judge(np.diag(R) * v, variant)):
        assert not any(word in str(verdict) for word in ("link", "block", "rot_z"))
    assert exercise.judge(R * 2, variant).headline == "expected 3 numbers, found 3×3 numbers"


def test_an_unanswered_prediction_points_to_its_own_cell():
    for key in ("00.P1", "01.P1", "02.P3"):
        verdict = exercises()[key].judge(...)
        assert (
            verdict.status == "not attempted"
            and verdict.next == "Replace the dots in this cell and run it again."
        )


@pytest.mark.parametrize("key", ["00.P1", "04.P4"])
def test_a_guess_has_no_hint_and_says_so_calmly(key):
    assert str(session.hint(key)).startswith("A guess has no hint") and "\n" not in session.hint(
        key
    )


def test_an_unknown_number_is_told_in_one_line():
    with pytest.raises(ValueError, match="found 'x'; write it as in \"00.1\"$"):
        session.hint("x")


def test_no_option_of_the_pre_test_stands_out_by_its_length():
    for key in ("00.4", "00.5"):
        lengths = sorted(len(option.text) for option in QUESTIONS[key].options.values())
        assert lengths[-1] < 1.5 * lengths[0], key


def test_five_questions_each_with_its_lesson():
    assert len(QUESTIONS) == 5
    for exercise in QUESTIONS.values():
        assert exercise.points == 0 and exercise.lesson in ("01", "02", "03", "05", "07")
        assert (reading.SOLUTIONS / "teacher" / "00-start-here.md").read_text(
            encoding="utf-8"
        ).count(exercise.id) == 1


@pytest.mark.parametrize("key", QUESTIONS)
def test_every_answer_is_noted_none_judged(key):
    exercise = QUESTIONS[key]
    for letter in (*exercise.options, "?", " A "):
        verdict = exercise.judge(letter)
        said = str(verdict) + verdict._repr_html_()
        assert (
            verdict.status == "recorded"
            and verdict.points == verdict.of == 0
            and f"Lesson {exercise.lesson}" in said
        )
        assert not any(word in said.lower() for word in ("is right", "wrong", "not yet", "✓", "✗"))
        chosen = next(iter(exercise.options)) if letter == " A " else letter
        assert verdict.chosen == (chosen,) and verdict.known == (chosen == exercise.correct)
        assert (verdict.mistake is None) == (
            verdict.known or letter == "?"
        ) and verdict.mistake in {None, *catalogue()}
    for nonsense in ("z", 3, ["a", "b"], ""):
        assert (
            exercise.judge(nonsense).status == "wrong"
            and "expected one of" in exercise.judge(nonsense).headline
        )


def test_nothing_shown_tells_the_right_answer_from_a_wrong_one():
    for exercise in QUESTIONS.values():
        shown = {letter: exercise.judge(letter)._repr_html_() for letter in exercise.options}
        right = shown.pop(exercise.correct)
        assert all(
            page.replace(exercise.options[letter].answer, "").count("<div>") == right.count("<div>")
            for letter, page in shown.items()
        )


def test_the_first_answer_counts_and_meets_the_post_test(tmp_path, monkeypatch):
    workspace.prepare(tmp_path)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(session, "_log", Log())
    assert "not in this course folder" in str(then_and_now())
    for key, exercise in QUESTIONS.items():
        session.check(key, exercise.correct if key in ("00.2", "00.5") else "?")
        session.check(key, exercise.correct)
    lines = [
        json.loads(line)
        for line in (tmp_path / ".dhlab" / "progress.jsonl").read_text().splitlines()
    ]
    assert len(lines) == 10 and all(isinstance(line["known"], bool) for line in lines)
    monkeypatch.setattr(session, "_log", Log())
    rows = then_and_now().to_dict().values()
    assert [row["then"] for row in rows].count(True) == 2 and not any(row["now"] for row in rows)
    assert (
        "then 2 of 5, now 0 of 5" in str(then_and_now())
        and "then 2 of 5" in then_and_now()._repr_html_()
    )


def test_every_question_is_asked_again():
    assert sorted(e.mirrors for e in exercises().values() if e.mirrors) == sorted(QUESTIONS)


def test_the_second_cup_is_hit_with_the_same_reversed_axis():
    arm = dh.load("article-6r")
    rows = arm.table.rows
    rows[3, 3] *= -1
    wrong, q = dh.Arm(dh.DHTable.standard(rows, angle="rad")), np.deg2rad([0, 60, -80, -30, 90, 0])
    assert np.allclose(wrong.forward(q)[:3, 3], [0.465, -0.1, 0.403], atol=5e-4) and np.allclose(
        arm.forward(q)[:3, 3], wrong.forward(q)[:3, 3], atol=1e-12
    )
    assert "arrived = [0.465, -0.1, 0.403]" in reading.sources(["00"])[0].read_text(
        encoding="utf-8"
    )


def test_waivers_are_printed_with_their_reason():
    table, failures = contract.report(["00"])
    waived = [line for line in table.splitlines() if " waived " in line]
    assert failures == [] and len(waived) == sum(lesson == "00" for lesson, _ in contract.WAIVED)
    assert all(any(reason in line for reason in contract.WAIVED.values()) for line in waived)


def test_single_lessons_by_number():
    assert [path.name[:2] for path in reading.sources(["05", "01"])] == ["01", "05"]
    with pytest.raises(ValueError, match="found '12'"):
        reading.sources(["12"])
