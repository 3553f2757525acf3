"""Programs in any dress, in special calls, without end, and where Python itself stops."""

import sys
import threading

import numpy as np
import pytest

from dhlab.course import check
from dhlab.doctor.programs.functions import diagnose_function
from dhlab.doctor.programs.running import deadline
from dhlab.doctor.programs.running.deadline import OutOfTime, limited


@pytest.fixture(autouse=True)
def _little_time(monkeypatch):
    """The lines that must change are not what is tested here."""
    monkeypatch.setattr("dhlab.doctor.programs.functions.SECONDS", 0.02)
    monkeypatch.setattr("dhlab.course.kinds.functions.SECONDS", 0.02)


def turn(axis, angle, kind=float):
    """A turn about x or z."""
    c, s = np.cos(kind(angle)), np.sin(kind(angle))
    i, j = {"x": (1, 2), "z": (0, 1)}[axis]
    T = np.eye(4, dtype=kind)
    T[[i, i, j, j], [i, j, i, j]] = c, -s, s, c
    return T


def link(theta, d, a, alpha, kind=float):
    T = turn("z", theta, kind) @ turn("x", alpha, kind)
    T[:3, 3] = a * np.cos(theta), a * np.sin(theta), d
    return T


def chain(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ link(row[0] + x, *row[1:])
    return T


def in_single_precision(*row):
    return link(*map(np.float32, row), kind=np.float32)


def single_precision_within(*row):
    return np.eye(4) @ in_single_precision(*row)


def symbols(*row):
    import sympy

    return sympy.Matrix(link(*row).tolist())


@pytest.mark.parametrize(
    "f", [in_single_precision, single_precision_within, symbols, lambda *row: np.matrix(link(*row))]
)
def test_a_right_program_is_right_in_any_dress(f):
    assert diagnose_function(f, "dh_transform"), diagnose_function(f, "dh_transform")
    assert check("05.4", f).status == "right"


def out_of_quarter_turns(theta, d, a, alpha):
    return link(min(theta, np.pi), d, a, alpha)


def without_a_flat_row(theta, d, a, alpha):
    return link(theta, d, a, alpha or 0.1)


def small(theta, d, a, alpha):
    return link(theta, d, np.clip(a, -1, 1), alpha)


def at_most_six(rows, q):
    return chain(rows[:6], q[:6])


def one_is_none(rows, q):
    return chain(rows, q) if len(q) > 1 else np.eye(4)


def lists_repeated(rows, q):
    return chain([(2 * row)[:4] if isinstance(row, list) else row for row in rows], 2 * q)


@pytest.mark.parametrize(
    "f, kind, words",
    [
        (out_of_quarter_turns, "dh_transform", "wrong where θ is above 180°"),
        (without_a_flat_row, "dh_transform", "wrong where α is 0"),
        (small, "dh_transform", "wrong where a length is above 1 m"),
        (at_most_six, "forward_kinematics", "where there are 7 rows, and right in every other"),
        (one_is_none, "forward_kinematics", "wrong where there is one row only"),
    ],
)
def test_a_program_that_is_right_in_general_only_is_not_right(f, kind, words):
    answer = diagnose_function(f, kind)
    assert not answer and words in " ".join(str(answer).split())


def test_lists_may_not_give_another_answer():
    def added(rows, q):
        return chain(rows, (q + q)[: len(q)] if isinstance(q, list) else q)

    def rows_twice(rows, q):
        return chain(rows, q) if isinstance(q, np.ndarray) else chain(rows, q + q) @ turn("z", 1)

    assert diagnose_function(added, "forward_kinematics")
    assert "as lists" in diagnose_function(rows_twice, "forward_kinematics").headline


def in_parts(*row):
    return link(*row)[:3, :3], link(*row)[:3, 3]


def position(*row):
    return link(*row)[:3, 3]


@pytest.mark.parametrize("f", [in_parts, position])
def test_a_part_of_the_pose_is_not_the_pose(f):
    assert diagnose_function(f, "dh_transform").findings[0].mistake == "pose-incomplete"
    assert check("05.4", f).mistake == "pose-incomplete"


def without_end(*row):
    while True:
        try:  # noqa: SIM105 as learners write it
            sum(range(1000))
        except:  # noqa: E722
            pass


def test_a_loop_without_end_is_given_up():
    with pytest.raises(OutOfTime):
        limited(0.05, without_end)
    assert limited(5, lambda x: x + 1, 1) == 2
    found = []
    worker = threading.Thread(target=lambda: found.append(limited(5, lambda x: x + 1, 1)))
    worker.start()  # outside the main thread no timer can be set
    worker.join()
    assert found == [2]


def test_where_no_timer_is_to_be_had_a_thread_is_given_up(monkeypatch):
    monkeypatch.setattr(deadline, "_has_timer", lambda: False)

    def slow():
        while True:
            sum(range(1000))

    with pytest.raises(OutOfTime):
        limited(0.02, slow)
    with pytest.raises(ZeroDivisionError):
        limited(5, lambda: 1 / 0)


def test_where_there_are_no_threads_a_cell_is_given_up(monkeypatch):
    def none(self):
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr(deadline, "_has_timer", lambda: False)
    monkeypatch.setattr(threading.Thread, "start", none)
    names = {}
    exec(compile("def slow():\n    while True:\n        pass", "<cell 1>", "exec"), names)
    traced = sys.gettrace()
    with pytest.raises(OutOfTime):
        limited(0.02, names["slow"])
    assert limited(5, lambda x: x + 1, 1) == 2
    with pytest.raises(ZeroDivisionError):
        limited(5, lambda: 1 / 0)
    assert sys.gettrace() is traced


def interrupted(*row):
    raise KeyboardInterrupt


def endless(theta, d, a, alpha):
    return endless(theta, d, a, alpha)


def no_comma(theta, d, a, alpha):
    return np.array([[1, 0, 0, a] [0, 1, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])  # fmt: skip # noqa


def from_one(rows, q):
    T = np.eye(4)
    for i in range(1, len(q) + 1):
        T = T @ link(rows[i][0] + q[i], *rows[i][1:])
    return T


def three_by_four(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = link(row[0] + x, *row[1:])[:3] @ T[:3]
    return T


def by_name(rows, q):
    return link(rows[0]["theta"] + q[0], *rows[0][1:])


def one_number_functions(rows, q):
    import math

    return link(math.cos(q), 0, 0, 0)


def of_a_length(rows, q):
    len = 0.35
    T = np.eye(4)
    for i in range(len(q)):
        T = T @ link(rows[i][0] + q[i] + len, *rows[i][1:])
    return T


@pytest.mark.parametrize(
    "f, kind, words",
    [
        (interrupted, "dh_transform", "you interrupted"),
        (endless, "dh_transform", "calls itself without end"),
        (no_comma, "dh_transform", "a comma"),
        (from_one, "forward_kinematics", "counts from 0"),
        (three_by_four, "forward_kinematics", "0 0 0 1"),
        (of_a_length, "forward_kinematics", "len(…) is a function of Python's"),
        (by_name, "forward_kinematics", "not by a name"),
        (one_number_functions, "forward_kinematics", "np.cos"),
        (lambda *row: link(*row) + 1j, "dh_transform", "complex"),
        (lambda *row: [[..., 0], [0, 1]], "dh_transform", "three dots"),
        (lambda *row: link(*row) * np.nan, "dh_transform", "NaN"),
    ],
)
def test_where_python_stops_the_line_is_told_in_plain_words(f, kind, words):
    said = str(diagnose_function(f, kind))
    assert words in " ".join(said.split()) and "Traceback" not in said
    if f in (no_comma, from_one, three_by_four, by_name, one_number_functions, endless):
        assert f"in {f.__name__}" in said
