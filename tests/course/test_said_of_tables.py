"""What is said of tables and values that learners handed in, and what must not be said of them."""

import numpy as np
import pytest
from claims import judged

from dhlab.course.exercises import exercises

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
