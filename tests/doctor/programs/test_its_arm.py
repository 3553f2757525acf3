"""Programs for one arm with the table in them, made wrong in one number, one sense or two: what is
told must be what was made, at its place. The programs multiply elementary moves of their own.
"""

import numpy as np
import pytest

import dhlab as dh
from dhlab.doctor.programs.functions import diagnose_function

TURNING = [[0, 0.29, 0, -90], [-90, 0, 0.27, 0], [0, 0, 0.07, -90], [0, 0.302, 0.04, 90]]
SLIDING = [[0, 0.4, 0.1, 90], [30, 0.3, 0.05, 60], [90, 0.12, 0.03, 0]]


def program(rows, joints, sense=1.0):
    """A function of q alone; not one line of it is in this file's text as a table."""
    rows = np.array(rows, float) * [np.pi / 180, 1, 1, np.pi / 180]

    def turn(angle, i, j):
        T = np.eye(4)
        T[[i, i, j, j], [i, j, i, j]] = np.cos(angle), -np.sin(angle), np.sin(angle), np.cos(angle)
        return T

    def pose(q):
        T = np.eye(4)
        for (theta, d, a, alpha), letter, value in zip(rows, joints, sense * np.asarray(q)):
            slid, moved = np.eye(4), np.eye(4)
            slid[2, 3] = d + value * (letter == "P")
            moved[0, 3] = a
            T = T @ turn(theta + value * (letter == "R"), 0, 1) @ slid @ moved @ turn(alpha, 1, 2)
        return T

    return pose


def told(rows, joints, changes, sense=1.0):
    arm = dh.Arm(dh.DHTable.standard(rows, angle="deg", joints=joints))
    wrong = np.array(rows, float)
    for entry, value in changes.items():
        wrong[entry] = value
    return arm, diagnose_function(program(wrong, joints, sense), "forward_kinematics", arm=arm)


@pytest.mark.slow
@pytest.mark.parametrize(
    "joints, changes, names",
    [
        ("RRRR", {(2, 2): 70}, ["length-unit"]),
        ("RRRR", {(1, 0): 0}, ["offset-missing"]),
        ("RRRR", {(2, 1): 0.07, (2, 2): 0}, ["a-d-exchanged"]),
        ("RRRR", {(1, 0): 0, (2, 2): 0.4}, ["offset-missing", "length-value"]),
        ("RRRR", {(2, 3): 90, (1, 2): 0.72}, ["alpha-sign", "length-value"]),
        ("RPR", {(1, 1): 0}, ["prismatic-constant-lost"]),
        ("RPR", {(1, 3): -60, (2, 2): 0.21}, ["alpha-sign", "length-value"]),
    ],
)
def test_what_stands_wrong_in_its_table_is_named_at_its_row(joints, changes, names):
    rows = TURNING if joints == "RRRR" else SLIDING
    assert diagnose_function(
        program(rows, joints), "forward_kinematics", arm=told(rows, joints, {})[0]
    )
    _, answer = told(rows, joints, changes)
    assert answer.verdict == "explained" and len(answer.findings) == len(names)
    found = {mistake for f in answer.findings for mistake in (f.mistake, *f.look_alikes)}
    assert set(names) <= found, answer
    places = {f.joint for f in answer.findings if f.place}  # none: wherever it may stand
    assert places <= {row + 1 for row, _ in changes}, answer


def test_a_joint_that_counts_backwards_is_told_beside_a_wrong_length():
    sense = np.array([1, -1, 1, 1.0])
    _, answer = told(TURNING, "RRRR", {(2, 2): 0.4}, sense)
    names = {mistake for f in answer.findings for mistake in (f.mistake, *f.look_alikes)}
    assert {"joint-reversed", "length-value"} <= names, answer


def test_joint_values_may_come_one_by_one():
    arm = dh.Arm(dh.DHTable.standard(TURNING, angle="deg"))
    right, wrong = np.array(TURNING, float), np.array(TURNING, float)
    wrong[2, 2] = 0.4
    pose = program(right, "RRRR")
    assert diagnose_function(
        lambda q1, q2, q3, q4: pose([q1, q2, q3, q4]), "forward_kinematics", arm=arm
    )
    off = program(wrong, "RRRR")
    answer = diagnose_function(
        lambda th1, th2, th3, th4: off([th1, th2, th3, th4]), "forward_kinematics", arm=arm
    )
    assert [f.joint for f in answer.findings] == [3], answer


def test_what_is_no_other_arm_with_two_mistakes_is_not_named():
    arm = dh.Arm(dh.DHTable.standard(TURNING, angle="deg"))
    wrong = [[10, 0.2, 0.1, -60], [-80, 0.1, 0.2, 20], [5, 0.1, 0.17, -70], [3, 0.2, 0.01, 50]]
    answer = diagnose_function(program(wrong, "RRRR"), "forward_kinematics", arm=arm)
    assert answer.verdict == "unexplained" and not answer.findings
