"""What is said of tables and values that learners handed in, and what must not be said of them."""

import numpy as np
import pytest
from claims import judged

from dhlab.course.exercises import exercises
from dhlab.course.exercises.answers09 import MAKERS, PIPER
from dhlab.course.exercises.sheet09 import six_axes
from dhlab.course.kinds import Table
from dhlab.doctor.programs.wrong.products import product
from dhlab.geometry.procedure.frames import assign_frames
from dhlab.robots import load

E = exercises()
DEG = [180 / np.pi, 1, 1, 180 / np.pi]


def changed(key, **entries):
    """The right rows of a table exercise, degrees and metres, with some entries changed."""
    rows = E[key].right_arm(0).table.rows * DEG
    for name, value in entries.items():
        rows[int(name[-1]) - 1, ("theta", "d", "a", "alpha").index(name[:-1])] = value
    return rows.round(9).tolist()


@pytest.mark.parametrize(
    "key, entries, said, unsaid",
    [
        ("06.6", {"d2": 0.1}, "rows 2 and 4", "rows 3"),
        ("06.6", {"d3": 0.1}, "rows 3 and 4", "rows 2"),
        ("06.6", {"d2": 0.05, "d3": 0.05}, "axes 2 to 4 are parallel", "rows 3 and 4"),
        ("06.6", {"theta4": 90}, "row 4 leads", "parallel"),
        ("09.7", {"a3": 0.31}, "row 3, a", "joint"),
        ("09.7", {"d2": 0.1}, "row 2, d", "counted twice"),
        ("09.7", {"d2": 0.1, "alpha5": 30}, "row 2, d; row 5, α", "joint"),
    ],
)
def test_what_is_said_of_steps_along_parallel_axes(key, entries, said, unsaid):
    answer = changed(key, **entries)
    verdict = E[key].judge(answer, 0)
    assert said in verdict.place and unsaid not in str(verdict), verdict
    assert judged(E[key], verdict, answer, 0), verdict


@pytest.mark.parametrize(
    "factors, said",
    [
        ([np.pi / 180, 1, 1, np.pi / 180], "other units: θ and α in radians; degrees are asked"),
        ([1, 1000, 1000, 1], "other units: d and a in millimetres; metres are asked"),
    ],
)
def test_a_slip_of_units_and_one_number_more_are_told_as_two(factors, said):
    rows = np.array(changed("04.5", a2=-0.5)) * factors
    verdict = E["04.5"].judge(rows.tolist())
    assert said in verdict.headline and "; and one number " in verdict.headline
    assert verdict.place == "row 2, a, once that is put right"


AR4 = six_axes(**E["09.2"].given(0)), E["09.2"].given(0)["end"]


def sheet(key, change):
    """The right arm's axes at its zero, changed, as an arm."""
    axes, end = {"09.2": AR4, "09.4": PIPER}[key]
    lines = [(np.array(point, dtype=float), np.array(z, dtype=float)) for point, z in axes]
    change(lines)
    return assign_frames(lines, end=end)


def exchanged(lines):
    lines[4], lines[2] = lines[2], lines[4]


def both_reversed(lines):
    for k in (3, 4):
        lines[k] = lines[k][0], -lines[k][1]


def written_round(lines):
    lines[4] = lines[4][::-1]


def last_in_millimetres(lines):
    for k in (4, 5):
        lines[k] = 1000 * lines[k][0], lines[k][1]


def moved_point(lines):
    lines[4] = lines[4][0] + [0, 0, 0.05], lines[4][1]


@pytest.mark.parametrize("key", ["09.2", "09.4"])
@pytest.mark.parametrize(
    "change, said",
    [
        (exchanged, "the lines of joints 3 and 5 have changed places"),
        (both_reversed, "the directions of joints 4 and 5 are reversed"),
        (written_round, "point and direction of joint 5 have changed places"),
        (last_in_millimetres, "the points of joints 5 and 6 in millimetres"),
        (moved_point, "that of joint 5 is not: look at its point"),
    ],
)
def test_of_a_sheet_lines_are_told_and_not_rows(key, change, said):
    answer = sheet(key, change)
    verdict = E[key].judge(answer, 0)
    assert said in str(verdict) and "row" not in str(verdict), verdict
    assert judged(E[key], verdict, answer, 0), verdict


@pytest.mark.parametrize("key, axes", [("09.2", AR4[0]), ("09.4", PIPER[0]), ("09.4", PIPER)])
def test_a_sheet_is_not_an_arm_yet(key, axes):
    verdict = E[key].judge(axes, 0)
    assert "not yet an arm" in verdict.headline and "dh.assign_frames" in verdict.next


def test_the_doctor_is_asked_about_the_arm_of_the_cell():
    rows = [*MAKERS[:5], [*MAKERS[5][:3], 180]]
    assert "about ours first" in E["09.3"].judge(rows, 0).next


def repaired(key, **more):
    """The right table of a repair with more entries changed."""
    rows = np.array(changed(key))
    for name, value in more.items():
        rows[int(name[-1]) - 1, ("theta", "d", "a", "alpha").index(name[:-1])] = value
    return rows.tolist()


@pytest.mark.parametrize("key", ["07.3", "07.6"])
def test_of_two_changes_the_right_one_is_kept(key):
    mended = repaired(key, alpha5=90)
    verdict = E[key].judge(mended, 0)
    assert verdict.place == "row 5, α was right before"
    assert verdict.next == "Put this one back, and keep the other change."
    neither = np.array(E[key].given(0)["rows"])
    neither[4, 3], neither[0, 2] = 90, 0.2
    verdict = E[key].judge(neither.tolist(), 0)
    assert "were right before" in verdict.place and "keep" not in verdict.next
    for answer in (mended, neither.tolist()):
        assert judged(E[key], E[key].judge(answer, 0), answer, 0)


def test_an_offset_is_looked_for_where_it_is_not_0():
    rows, q = load("irb120").table.rows, np.deg2rad(E["06.10"].given(0)["q"])
    rows[1, 0] = 0
    assert "is θ not 0" in E["06.10"].judge(product(rows, q), 0).next
    twice = np.array(load("irb120").table.rows) / DEG
    for values, said in ((q, "the rows were"), (np.deg2rad(q), "the rows and q were")):
        headline = E["06.10"].judge(product(twice, values), 0).headline
        assert headline == f"{said} converted twice"


TABLES = [key for key, exercise in E.items() if isinstance(exercise, Table)]
ROW = [0, 0.1, 0.2, 90]
NO_TABLES = {  # of a table with n rows: what is handed in, and a part of what is said
    "a number": (lambda n: 5, "found one number"),
    "an array of no dimension": (lambda n: np.array(3.0), "found one number"),
    "one flat row": (lambda n: ROW, "row 1 is 0"),
    "a column": (lambda n: [0] * n, "row 1 is 0, expected 4 numbers"),
    "a column of decimals": (lambda n: np.zeros(n), "row 1 is 0.0, expected 4 numbers"),
    "numbers after a row": (lambda n: [ROW] + [0] * (n - 1), "row 2 is 0, expected 4 numbers"),
    "texts": (lambda n: ["0 1 2 3"] * n, "row 1 is '0 1 2 3', expected 4 numbers"),
    "a short row": (lambda n: [ROW] * (n - 1) + [ROW[:3]], "has 3 numbers, expected 4"),
    "arrays of two sizes": (
        lambda n: [np.array(ROW)] * (n - 1) + [np.array(ROW[:3])],
        "has 3 numbers, expected 4",
    ),
    "rows of one": (lambda n: [[0]] * n, "row 1 has 1 number, expected 4"),
    "numbers in brackets": (
        lambda n: [[[x] for x in ROW]] * n,
        "θ: expected a number, found [0.0]",
    ),
    "rows in brackets": (lambda n: [[ROW]] * n, "row 1 has 1 number, expected 4"),
    "nothing": (lambda n: [], "found an empty table"),
}


@pytest.mark.parametrize("key", TABLES)
def test_what_is_no_table_is_told_in_one_sentence(key):
    joints = len(E[key].right_arm(0))
    for name, (made, said) in NO_TABLES.items():
        verdict = E[key].judge(made(joints))
        assert verdict.status == "wrong" and said in verdict.headline, (name, verdict)
        assert "np." not in verdict.headline and "array" not in verdict.headline, verdict


@pytest.mark.parametrize("key", TABLES)
def test_dots_and_question_marks_beside_what_is_no_row_do_no_harm(key):
    n = len(E[key].right_arm(0))
    for answer in (
        [ROW, ...] + [0] * (n - 2),
        [[..., 0, 0]] + [ROW] * (n - 1),
        [...] + [0] * (n - 1),
    ):
        assert E[key].judge(answer).status == "not attempted"
    for answer in (["?"] + [0] * (n - 1), [["?", 1, 2, 3]] + [np.array(ROW[:3])] * (n - 1)):
        assert "Good to say so" in E[key].judge(answer).headline
