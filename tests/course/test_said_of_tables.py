"""What is said of tables and values that learners handed in, and what must not be said of them."""

import numpy as np
import pytest
from claims import judged

from dhlab.course.exercises import exercises
from dhlab.course.exercises.answers09 import AR4, MAKERS, PIPER
from dhlab.geometry.procedure.frames import assign_frames

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
        ("09.7", {"a3": 0.31}, "row 3 leads", "parallel"),
        ("09.7", {"d2": 0.1}, "a wrong d in any of these rows", "counted twice"),
    ],
)
def test_what_is_said_of_steps_along_parallel_axes(key, entries, said, unsaid):
    answer = changed(key, **entries)
    verdict = E[key].judge(answer, 0)
    assert said in verdict.place and unsaid not in str(verdict), verdict
    assert judged(E[key], verdict, answer, 0), verdict


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
