"""DHTable and Arm: what they take, what they refuse and in which words."""

import copy
import pickle

import numpy as np
import pytest

import dhlab as dh
from dhlab.printing import table_html

ROWS = [[0, 0.1, 0, 90], [0, 0, 0.4, 0]]


def test_units_and_columns():
    table = dh.DHTable.standard([[30, 100, 200, -90]], angle="deg", length="mm")
    assert np.allclose(
        [table.theta, table.d, table.a, table.alpha], [[np.pi / 6], [0.1], [0.2], [-np.pi / 2]]
    )
    assert (table.convention, table.joints, len(table)) == ("standard", "R", 1)
    assert dh.DHTable.craig(ROWS, angle="deg", joints=["R", "P"]).joints == "RP"


def test_a_table_is_frozen_and_a_value():
    table = dh.DHTable.standard(ROWS, angle="deg")
    with pytest.raises(AttributeError):
        table.a = table.d
    with pytest.raises(ValueError):
        table.a[0] = 1
    given = np.array(ROWS, dtype=float)
    other = dh.DHTable.standard(given, angle="deg")
    given[0, 1] = 7
    assert other == table and hash(other) == hash(table)
    assert pickle.loads(pickle.dumps(table)) == copy.deepcopy(table) == table
    assert (
        table != dh.DHTable.craig(ROWS, angle="deg")
        and table != dh.DHTable.standard(ROWS, angle="deg", joints="RP")
        and table != 3
    )
    assert eval(repr(table), {"DHTable": dh.DHTable}) == table


def test_printed_as_a_person_would_draw_it():
    arm = dh.Arm(
        dh.DHTable.standard([[-90, 0.1, 0, 90], [45, 0.2, 0.4, 0]], angle="deg", joints="RP"),
        sign=[-1, 1],
        name="two",
    )
    text = str(arm)
    assert "lengths in m, angles in deg" in text and "-q1 - 90" in text and "q2 + 0.2" in text
    html = arm._repr_html_()
    assert "<caption>two: standard DH" in html and "−q1 − 90" in html and html.count("<tr>") == 3
    in_mm = table_html(arm.table, length="mm")
    assert "lengths in mm" in in_mm and "<td>400</td>" in in_mm and "q2 + 200" in in_mm
    assert "a<sub>i−1</sub>" in dh.DHTable.craig(ROWS, angle="deg")._repr_html_()
    evil = dh.Arm(arm.table, name="<script>alert(1)</script>", source="<img src=x>")
    assert "<script>" not in evil._repr_html_() and "<img" not in evil._repr_html_()


@pytest.mark.parametrize(
    "rows, options, words",
    [
        (ROWS, {}, "unit of the angles"),
        (ROWS, {"angle": "degrees"}, "found 'degrees'"),
        (ROWS, {"angle": "deg", "length": "cm"}, "unit of the lengths"),
        ([], {"angle": "deg"}, "empty table"),
        (None, {"angle": "deg"}, "NoneType"),
        ("abc", {"angle": "deg"}, "str"),
        ([[0, 0.1, 0]], {"angle": "deg"}, "row 1 has 3 numbers, expected 4"),
        ([ROWS[0], [1, 2, 3, 4, 5]], {"angle": "deg"}, "row 2 has 5 numbers"),
        ([ROWS[0], [0, "x", 0, 0]], {"angle": "deg"}, "row 2, d: expected a number, found 'x'"),
        ([[0, np.nan, 0, 0]], {"angle": "deg"}, "row 1, d: expected a finite"),
        ([[0, 0, np.inf, 0]], {"angle": "rad"}, "row 1, a: expected a finite"),
        (ROWS, {"angle": "deg", "joints": "RX"}, "joint 2 is 'X'"),
        (ROWS, {"angle": "deg", "joints": "R"}, "1 joint letters for 2 rows"),
        (ROWS, {"angle": "deg", "joints": "RRR"}, "3 joint letters"),
        ([1, 2, 3, 4], {"angle": "deg"}, "row 1 is 1"),
        ([[0, 0, 0, 1j]], {"angle": "deg"}, "alpha: expected a number"),
        ([[0, True, 0, 0]], {"angle": "deg"}, "d: expected a number"),
    ],
)
@pytest.mark.parametrize("make", [dh.DHTable.standard, dh.DHTable.craig])
def test_bad_rows_are_one_plain_sentence(make, rows, options, words):
    with pytest.raises(ValueError) as error:
        make(rows, **options)
    assert (
        words in str(error.value)
        and "expected" in str(error.value)
        and "\n" not in str(error.value)
    )


@pytest.mark.parametrize(
    "options, words",
    [
        ({"base": np.eye(3)}, "base: expected a 4×4 pose"),
        ({"tool": np.diag([1, 1, 2, 1])}, "not rigid"),
        ({"tool": np.diag([1, 1, -1, 1])}, "mirror"),
        ({"tool": [[1, 0, 0, np.nan], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}, "NaN"),
        ({"base": "up"}, "4×4"),
        ({"sign": [1]}, "sign: expected 2"),
        ({"sign": [1, 0]}, "each 1 or -1"),
        ({"sign": ["a", "b"]}, "sign"),
        ({"limits": [(0, 1)]}, "limits: expected 2"),
        ({"limits": [(1, 0), None]}, "low <= high"),
        ({"limits": [(0, np.nan), None]}, "joint 1"),
        ({"limits": 3}, "limits: expected 2"),
        ({"name": 3}, "name: expected text"),
    ],
)
def test_bad_parts_of_an_arm_are_one_plain_sentence(options, words):
    with pytest.raises(ValueError) as error:
        dh.Arm(dh.DHTable.standard(ROWS, angle="deg"), **options)
    assert words in str(error.value) and "\n" not in str(error.value)


def test_an_arm_wants_a_table():
    with pytest.raises(ValueError, match="expected a DHTable"):
        dh.Arm(ROWS)


def test_an_arm_is_a_value():
    arm = dh.load("panda")
    assert (
        pickle.loads(pickle.dumps(arm)) == arm
        and hash(copy.deepcopy(arm)) == hash(arm)
        and arm != dh.load("panda.rtb_tool")
    )
    with pytest.raises(ValueError):
        arm.tool[0, 0] = 2
