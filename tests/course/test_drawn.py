"""Wrong answers drawn: what is marked does not fit, what stands before it does, and nothing of a
right answer is drawn.

Joint axes are found here by turning one joint of the right arm and looking at what stays in place.
"""

import numpy as np
import pytest
from wrong_answers import wrong_answers

from dhlab.course import session
from dhlab.course.exercises import exercises
from dhlab.course.kinds import Table, Value
from dhlab.course.kinds.frames.placed import Frames
from dhlab.course.kinds.tabled.repaired import Impostor, Repair
from dhlab.view.pictures import tried as module

TABLES = [
    key
    for key, one in exercises().items()
    if isinstance(one, Table) and not isinstance(one, (Impostor, Repair))
]
POSES = [key for key, one in exercises().items() if isinstance(one, Value) and one.units == "pose"]


@pytest.fixture
def asked(monkeypatch):
    """What would be drawn: lines, frames, mark."""
    calls = []
    monkeypatch.setattr(
        module, "tried", lambda lines, frames, mark, **_: calls.append((lines, frames, mark))
    )
    return calls


def axis_of(arm, k):
    """A point and the direction of joint k's axis at q = 0: what a turn leaves in place."""
    turned = np.zeros(len(arm))
    turned[k] = 0.5
    T = arm.forward(turned) @ np.linalg.inv(arm.forward(0 * turned))
    R, p = T[:3, :3], T[:3, 3]
    if np.allclose(R, np.eye(3)):
        return None, p / np.linalg.norm(p)
    w = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / (2 * np.sin(0.5))
    return np.linalg.lstsq(np.eye(3) - R, p, rcond=None)[0], w


def fits(part, line, sign):
    """Whether a frame's z is the axis, in the sense in which the joint counts."""
    p, w = line
    beside = 0 if p is None else np.linalg.norm(np.cross(part["o"] - p, w))
    return np.allclose(sign * part["z"], w, atol=1e-6) and beside < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("key", TABLES)
def test_of_a_table_the_first_axis_that_does_not_fit_is_marked(key, asked):
    exercise = exercises()[key]
    right, marked = exercise.right_arm(), set()
    for answer in wrong_answers(exercise, 0, 40):
        exercise.drawn(answer)
        if not asked:
            continue
        arm, (_, frames, mark) = exercise.arm_of(answer, right), asked.pop()
        if np.allclose(arm.forward(exercise.poses_at(0)), right.forward(exercise.poses_at(0))):
            continue
        marked.add(mark)
        if mark.endswith("the end"):
            assert not np.allclose(arm.forward(0 * right.sign), right.forward(0 * right.sign))
            continue
        standard = arm.table.convention == "standard"
        for name, part in frames.items():
            k = int(name) - (not standard)
            if 0 <= k < len(right):
                fitting = fits(part, axis_of(right, k), arm.sign[k])
                assert fitting == (name != mark[1:]), (answer, mark, name)
    assert marked


@pytest.mark.parametrize("key", POSES)
def test_of_a_pose_a_column_that_differs_is_marked(key, asked):
    exercise = exercises()[key]
    right = np.asarray(exercise.answer(**exercise.given(0)), dtype=float)
    for k, letter in enumerate("xyzo"):
        wrong = right.copy()
        wrong[:3, k] *= -1
        exercise.drawn(wrong)
        assert asked.pop()[2][0] == letter
    exercise.drawn(1000 * right)
    exercise.drawn("left")
    assert not asked


@pytest.mark.parametrize("key", ["02.3", "02.4", "02.8"])
def test_of_a_row_the_first_thing_that_does_not_fit_is_marked(key, asked):
    exercise = exercises()[key]
    theta, d, a, alpha = np.asarray(exercise.answer(**exercise.given(0)), dtype=float)
    turns = {"z1": (theta, d, a, alpha + 20), "o1": (theta, d, a + 0.1, alpha)}
    for mark, row in {**turns, "z1 ": (theta + 30, d, a, alpha)}.items():
        exercise.drawn(row)
        lines, frames, found = asked.pop()
        if np.isclose(alpha % 180, 0) and mark == "z1 ":  # parallel axes: only the place is wrong
            mark = "o1"
        assert found == mark.strip()
        T, (_, (point, z, _)) = frames["1"], lines
        at = np.array([a * np.cos(np.deg2rad(theta)), a * np.sin(np.deg2rad(theta)), d])
        assert np.linalg.norm(np.cross(at - point, z)) < 1e-9 < np.linalg.norm(at - point)
        assert tuple(T["o"]) != tuple(at) or mark.startswith("z")
    exercise.drawn((theta, d, a, alpha))
    exercise.drawn((theta, d, np.nan, alpha))
    exercise.drawn((theta + 360, d, a, alpha))
    assert not asked


def test_a_placed_frame_is_drawn_as_it_was_placed_and_only_when_all_is_told():
    key = "04.7"  # told bit by bit
    frames = [list(row) for row in exercises()[key].given(0)["frames"]]
    frames[0][2] = [0, 0, 1]
    assert isinstance(exercises()[key], Frames)
    told = [session.check(key, frames) for _ in range(3)]
    assert [one.drawn is None for one in told] == [True, True, False]
    assert "<img" not in told[1]._repr_html_()
    picture = told[2].drawn()
    assert "x0, along (0, 0, 1)" in picture.alt and "<img" in told[2]._repr_html_()
    np.testing.assert_allclose(np.diff(picture.points["marked:x0"], axis=0)[0, :2], 0, atol=1e-9)
