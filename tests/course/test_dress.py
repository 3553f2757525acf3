"""Answers in another dress: right ones pass, and what is said of their form is true of it; next
steps that fit the answer.
"""

from enum import Enum

import numpy as np
import pytest

from dhlab.course.exercises import exercises
from dhlab.course.kinds import Choice, Order, Table, Value
from dhlab.geometry.procedure.frames import assign_frames

ALL = exercises()
TABLES = [key for key, e in ALL.items() if isinstance(e, Table)]
VECTORS = [
    key
    for key, e in ALL.items()
    if isinstance(e, Value) and e.entries and np.ndim(e.answer(**e.given(1))) == 1
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


@pytest.mark.parametrize("key", ["04.4", "04.7", "04.14"])
def test_so_are_frames_and_what_only_a_dict_holds(key):
    wrong = [[[0, 0, 1], [0.3, 0, 0], [0, 1, 0]] for _ in ALL[key].given(1)["axes"]] * 2
    said = str(ALL[key].judge(wrong, 1))
    for walked in (iter(wrong), dict(enumerate(wrong)).values()):
        assert str(ALL[key].judge(walked, 1)) == said and "found 0" not in said


@pytest.mark.parametrize("key", [key for key, e in ALL.items() if isinstance(e, Order)])
def test_letters_of_an_enum_are_read(key):
    ids = list(ALL[key].items)[: ALL[key].size] * ALL[key].size
    kind = Enum("kind", {f"item{k}": one for k, one in enumerate(ALL[key].items)}, type=str)
    for letters in (ids[: ALL[key].size], ids[:1]):
        named = [kind(one) for one in letters]
        assert str(ALL[key].judge(named, 1)) == str(ALL[key].judge(letters, 1))


@pytest.mark.parametrize("key", TABLES)
def test_a_table_on_its_side_is_called_so_and_no_other(key):
    rows = np.array(right_rows(key))
    said = "rows and columns have changed places"
    assert ALL[key].judge(rows.T, 1).headline == said
    for other in (rows[::-1] + 0.1, rows[:, ::-1] + [[1, 0.2, 3, 4]], rows[:-1]):
        assert ALL[key].judge(other, 1).headline != said


@pytest.mark.filterwarnings("ignore:the matrix subclass")
@pytest.mark.parametrize("key", VECTORS)
def test_a_vector_may_stand_as_a_column_or_as_a_row(key):
    e = ALL[key]
    right = np.asarray(e.answer(**e.given(1)), dtype=float)
    for vector in (right, 1.7 * right + 0.9):
        said = str(e.judge(vector, 1))
        for dressed in (vector[:, None], vector[None], np.matrix(vector), np.matrix(vector).T):
            assert str(e.judge(dressed, 1)) == said


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


@pytest.mark.parametrize("key", ["04.4", "04.10", "04.13", "04.15"])
def test_only_a_frame_with_one_before_it_is_compared_with_the_z_before(key):
    given = ALL[key].given(1)
    z0 = np.array(given["axes"][0][1], dtype=float)
    beside = np.cross(z0, [0.6, 0.8, 0.1]) + given["axes"][0][0]
    frames = [[z0, beside, np.cross(z0, [0.6, 0.8, 0.1])]] + [[...] * 3 for _ in given["axes"]]
    verdict = ALL[key].judge(frames, 1)
    assert "z0" in verdict.headline and "the z before" not in verdict.next


@pytest.mark.parametrize("many", [1, 2, 4])
def test_whoever_returns_a_list_is_told_how_long_it_is_and_of_no_loop(many):
    verdict = ALL["03.3"].judge(lambda *row: [np.eye(4) * k for k in range(many)], 1)
    assert "loop" not in verdict.next and "the last" not in verdict.next
    assert (f"list of {many}" if many > 1 else "alone") in verdict.next


@pytest.mark.parametrize(
    "t, x, said", [(-1, 1, "theta turns"), (1, -1, "alpha turns"), (-1, -1, "theta and alpha turn")]
)
def test_a_turn_with_the_other_sign_is_called_by_its_angle(t, x, said):
    turn = ALL["03.3"].answer
    verdict = ALL["03.3"].judge(lambda theta, d, a, alpha: turn(t * theta, d, a, x * alpha), 1)
    assert verdict.headline.startswith(said) and "row vectors" not in str(verdict)


def test_a_last_row_carries_the_shift_of_the_matrix_on_its_left():
    """The reason that is given, tried: with 0 0 0 0 below, the shift on the left is lost."""
    rng = np.random.default_rng(3)
    left, right = np.eye(4), np.eye(4)
    left[:3, 3], right[:3, 3] = rng.uniform(1, 2, (2, 3))
    without = right * [[1], [1], [1], [0]]
    assert np.allclose((left @ without)[:3, 3], right[:3, 3])
    assert np.allclose((left @ right)[:3, 3], left[:3, 3] + right[:3, 3])
    why = ALL["01.4"].judge(lambda a, b: np.diag([1, 1, 1, 0]) @ a @ b, 1).why
    assert "on its left" in why and "lost" in why


@pytest.mark.parametrize("beside", [0.05, 0.4, 1.0])
def test_an_origin_beside_its_axis_is_not_taken_for_millimetres(beside):
    """One origin alone, of an axis through the base's origin: any unit makes it small."""
    frames = [[[0, 0, 1], [beside, 0, 0], [1, 0, 0]], *([...] * 3 for _ in range(3))]
    verdict = ALL["04.4"].judge(frames, 1)
    assert "millimetres" not in verdict.headline and f"{beside:g} m beside z0" in verdict.headline


@pytest.mark.parametrize("key", VECTORS)
@pytest.mark.parametrize("kind", [int, float])
def test_zeros_are_called_zeros_and_not_numbers_cut_off(key, kind):
    e = ALL[key]
    right = np.asarray(e.answer(**e.given(1)), dtype=float)
    verdict = e.judge(np.zeros(right.shape, dtype=kind), 1)
    assert verdict.status == "wrong" and "right numbers" not in verdict.headline


@pytest.mark.parametrize("key", ["04.2", "04.4", "04.12"])
def test_bare_arrows_are_not_read_as_frames(key):
    frame = [[0, 0, 1], [0, 0, 0], [1, 0, 0]]
    count = len(ALL[key].given(1)["axes"]) + 1
    assert "found a single one" in ALL[key].judge(frame, 1).headline
    mixed = ALL[key].judge([frame, [0, 0, 1], *[...] * (count - 2)], 1).headline
    assert "for frame 1, three lists, found [0, 0, 1]" in mixed
    begun = ALL[key].judge([frame, *[...] * (count - 1)], 1)
    assert begun.status == "not attempted" and begun.place == "right so far: z0, o0, x0"


@pytest.mark.parametrize("factor, unit", [(1000, "millimetres"), (100, "centimetres")])
@pytest.mark.parametrize("axes, name", [((2,), "z of o2"), ((0, 2), "o2"), ((0,), "x of o2")])
def test_one_origin_or_a_part_of_it_in_other_units_is_called_so(factor, unit, axes, name):
    """04.12: axes 2 and 3 are parallel, at y free, so that x and z of o2 alone are given."""
    given = ALL["04.12"].given(1)
    placed = assign_frames(given["axes"], end=given["end"]).frames(np.zeros(len(given["axes"])))
    frames = [[T[:3, 2], T[:3, 3].copy(), T[:3, 0]] for T in placed]
    assert ALL["04.12"].judge(frames, 1).status == "right"
    frames[2][1][list(axes)] *= factor
    verdict = ALL["04.12"].judge(frames, 1)
    assert verdict.headline == f"in other units: {name} in {unit}; metres are asked"


def test_an_origin_hundreds_of_metres_away_is_asked_for_its_unit():
    """The last origin may stand anywhere along its axes, 750 in place of 0.75 too."""
    given = ALL["04.12"].given(0)
    placed = assign_frames(given["axes"], end=given["end"]).frames(np.zeros(len(given["axes"])))
    frames = [[T[:3, 2], T[:3, 3].copy(), T[:3, 0]] for T in placed]
    frames[3][1][0] *= 1000
    away = np.linalg.norm(frames[3][1])
    verdict = ALL["04.12"].judge(frames, 0)
    assert verdict.status == "wrong" and verdict.headline == f"o3 lies {away:.0f} m from the base"
