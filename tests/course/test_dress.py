"""Answers in another dress: right ones pass, and what is said of their form is true of it."""

import numpy as np
import pytest

from dhlab.course.exercises import exercises
from dhlab.course.kinds import Choice, Order, Table, Value

ALL = exercises()
TABLES = [key for key, e in ALL.items() if isinstance(e, Table)]
VECTORS = [
    key
    for key, e in ALL.items()
    if isinstance(e, Value) and np.ndim(e.answer(**e.given(1))) == 1 and e.entries
]
TURNS = np.array([180 / np.pi, 1, 1, 180 / np.pi])


def right_rows(key):
    return (ALL[key].right_arm(1).table.rows * TURNS).tolist()


@pytest.mark.parametrize("key", TABLES)
def test_rows_that_can_be_walked_through_once_are_read(key):
    rows = right_rows(key)
    for walked in (iter(rows), map(list, rows), zip(*zip(*rows)), (row for row in rows)):
        assert ALL[key].judge(walked, 1).status == ALL[key].judge(rows, 1).status
    wrong = [row[:] for row in rows]
    wrong[0][1] += 0.3
    wrong[1][3] += 20
    verdict = ALL[key].judge(iter(wrong), 1)
    assert verdict.status == "wrong" and "empty" not in verdict.headline


@pytest.mark.parametrize("key", TABLES)
def test_a_table_on_its_side_is_called_so_and_no_other(key):
    rows = np.array(right_rows(key))
    said = "rows and columns have changed places"
    assert ALL[key].judge(rows.T, 1).headline == said
    for other in (rows[::-1] + 0.1, rows[:, ::-1] + [[1, 0.2, 3, 4]], rows[:-1]):
        assert ALL[key].judge(other, 1).headline != said


@pytest.mark.parametrize("key", VECTORS)
def test_the_right_numbers_in_another_shape_are_called_right(key):
    e = ALL[key]
    right = np.asarray(e.answer(**e.given(1)), dtype=float)
    for dressed, form in ((right[:, None], "one below the other"), (right[None], "brackets")):
        said = e.judge(dressed, 1).headline
        assert "the right numbers" in said and form in said
        assert "the right numbers" not in e.judge(1.7 * dressed + 0.9, 1).headline


@pytest.mark.parametrize("key", [key for key, e in ALL.items() if isinstance(e, Choice)])
def test_a_letter_is_read_with_what_stands_around_it(key):
    e = ALL[key]
    for name, letter in e.letters(1).items():
        asked = "right" if name == e.correct else "wrong"
        for dressed in (f"({letter})", f"{letter})", f"{letter.upper()}.", f'"{letter}"', [letter]):
            verdict = e.judge(dressed, 1)
            assert verdict.status == asked and verdict.chosen == (name,)
    assert e.judge(list(e.letters(1).values())[:2], 1).chosen == ()


@pytest.mark.parametrize("key", [key for key, e in ALL.items() if isinstance(e, Order)])
def test_a_set_has_no_order_and_is_refused_as_such(key):
    verdict = ALL[key].judge(set(ALL[key].letters(1).values()), 1)
    assert verdict.status == "wrong" and "a set" in verdict.headline


@pytest.mark.parametrize("factor, word", [(100, "Divide centimetres by 100"), (1000, "by 1000")])
def test_the_next_step_after_a_unit_makes_the_lengths_right(factor, word):
    rows = np.array(right_rows("02.7"))
    verdict = ALL["02.7"].judge(rows * [1, factor, factor, 1], 1)
    assert word in verdict.next
    too_small = ALL["02.7"].judge(rows * [1, 1e-3, 1e-3, 1], 1).next
    assert "Divide" not in too_small and "once too often" in too_small
