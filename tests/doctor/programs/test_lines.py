"""The line that must change, told by trying; judged by a product of turns that is not dhlab's."""

import importlib.util
import math

import numpy as np
import pytest

import dhlab as dh
from dhlab.doctor.programs.functions import diagnose_function

PROGRAM = """\
import math
import numpy as np

TOOL = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0.1], [0, 0, 0, 1]])

def link(theta, d, a, alpha):
    ct, st = math.cos(theta), math.sin(theta)
    ca, sa = math.cos(alpha), math.sin(alpha)
    return np.array([[ct, -st * ca, st * sa, a * ct],
                     [st, ct * ca, -ct * sa, a * st],
                     [0, sa, ca, d],
                     [0, 0, 0, 1]])

def forward_kinematics(rows, q):
    T = np.eye(4)
    for i in range(len(q)):
        theta, d, a, alpha = rows[i]
        T = T @ link(theta + q[i], d, a, alpha)
    return T
"""
KIND = "forward_kinematics"
ROWS = np.array([[0.2, 0.3, 0.1, -1.1], [-0.4, 0.05, 0.4, 0.3], [0.6, -0.2, 0.3, 1.4]])


def written(folder, text):
    """The function of a file that holds this text."""
    path = folder / "program.py"
    path.write_text(text, encoding="utf-8")
    spec = importlib.util.spec_from_file_location("program", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return getattr(module, KIND)


def reference(rows, q):
    """Origin and axes, carried from link to link."""
    p, x, y, z = np.zeros(3), *np.eye(3)
    for (theta, d, a, alpha), angle in zip(rows, q):
        c, s = math.cos(theta + angle), math.sin(theta + angle)
        x, y = c * x + s * y, c * y - s * x
        p = p + d * z + a * x
        c, s = math.cos(alpha), math.sin(alpha)
        y, z = c * y + s * z, c * z - s * y
    return np.vstack([np.column_stack([x, y, z, p]), [0, 0, 0, 1]])


def is_right(text):
    space = {}
    exec(text, space)
    poses = np.array([[0.7, -1.9, 2.4], [-2.6, 0.3, 1.1]])
    return all(np.allclose(space[KIND](ROWS, q), reference(ROWS, q), atol=1e-12) for q in poses)


@pytest.mark.parametrize(
    "line, found, wrong",
    [
        (18, "T = T @ link", "T = T * link"),
        (18, "T @ link(theta + q[i], d, a, alpha)", "link(theta + q[i], d, a, alpha) @ T"),
        (18, "theta + q[i]", "q[i]"),
        (18, "q[i]", "q[i - 1]"),
        ((17, 18), "q[i], d, a, alpha", "q[i], a, d, alpha"),
        (18, "T = T @", "T ="),
        (16, "range(len(q))", "range(len(q) - 1)"),
        (16, "range(len(q))", "range(1, len(q) + 1)"),
        (10, "ct * ca, -ct", "ct * ca -ct"),
        (10, "-ct * sa", "ct * sa"),
        (8, "math.sin(alpha)", "math.cos(alpha)"),
        (19, "return T", "return T @ TOOL"),
        (19, "    return T", "        return T"),
    ],
)  # fmt: skip
def test_the_line_that_must_change_is_told(line, found, wrong, tmp_path):
    text = PROGRAM.replace(found, wrong)
    assert text != PROGRAM and not (found in wrong and wrong in PROGRAM)
    answer = diagnose_function(written(tmp_path, text), KIND)
    assert not answer and len(answer.lines) == 1, answer
    assert answer.lines[0].found == text.splitlines()[answer.lines[0].number - 1].strip()
    assert is_right(answer.repaired)
    assert answer.lines[0].number in np.atleast_1d(line)
    assert f"{answer.lines[0].number}: " in str(answer) and answer.to_dict()["lines"]


def test_what_is_kept_between_calls_is_found(tmp_path):
    text = PROGRAM.replace("(rows, q):\n    T = np.eye(4)", "(rows, q, T=np.eye(4)):").replace(
        "T = T @", "T @="
    )
    answer = diagnose_function(written(tmp_path, text), KIND)
    assert answer.findings[0].mistake == "state-between-calls" and is_right(answer.repaired)
    assert len(answer.lines) == 1


def test_two_lines_are_told_of_two_mistakes(tmp_path):
    text = PROGRAM.replace("-ct * sa", "ct * sa").replace("q[i], d", "q[i - 1], d")
    answer = diagnose_function(written(tmp_path, text), KIND)
    assert [line.number for line in answer.lines] == [10, 18] and is_right(answer.repaired)


APART = """\
import numpy as np

def turn(theta, alpha):
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st * ca, st * sa],
                     [st, ct * ca, -ct * sa],
                     [0.0, sa, ca]])

def forward_kinematics(rows, q):
    R = np.eye(3)
    p = np.zeros(3)
    for k in range(len(rows)):
        theta = rows[k][0] + q[k]
        d, a, alpha = rows[k][1:]
        step = np.array([a * np.cos(theta), a * np.sin(theta), d])
        p = p + R @ step
        R = R @ turn(theta, alpha)
    T = np.eye(4)
    T[:3, :3] = R
    T[:3, 3] = p
    return T
"""


@pytest.mark.slow
@pytest.mark.parametrize(
    "program, lines, wrong",
    [  # of each two, none alone makes anything right
        (PROGRAM, {7, 18}, {"= math.cos(theta), math.sin(theta)":
            "= round(math.cos(theta), 3), round(math.sin(theta), 3)", "theta + q": "theta - q"}),
        (PROGRAM, {11, 17}, {"[0, sa, ca, d]": "[0, ca, sa, d]", "q[i], d, a": "q[i], a, d"}),
        (APART, {16, 17}, {"a * np.cos(theta), a * np.sin(theta)":
            "a * np.sin(theta), a * np.cos(theta)", "p + R @ step": "p + step"}),
        (APART, {8, 18}, {"[0.0, sa, ca]": "[0.0, ca, sa]", "R @ turn(theta, alpha)":
            "turn(theta, alpha) @ R"}),
        (APART, {17, 18}, {"p + R @ step": "p + step", "R @ turn(theta, alpha)":
            "turn(theta, alpha) @ R"}),
    ],
)  # fmt: skip
def test_two_lines_are_told_where_neither_alone_mends_much(
    program, lines, wrong, tmp_path, monkeypatch
):
    monkeypatch.setattr("dhlab.doctor.programs.functions.SECONDS", 20)  # on any machine
    text = program
    for old, new in wrong.items():
        assert text.count(old) == 1
        text = text.replace(old, new)
    answer = diagnose_function(written(tmp_path, text), KIND)
    assert is_right(program) and not is_right(text) and is_right(answer.repaired)
    assert {line.number for line in answer.lines} == lines


def test_the_callers_table_is_kept(tmp_path):
    text = """\
import numpy as np

def forward_kinematics(table, q):
    rows = np.asarray(table)
    rows[:, 0] += q
    T = np.eye(4)
    for t, d, a, alpha in rows:
        c, s, k, h = np.cos(t), np.sin(t), np.cos(alpha), np.sin(alpha)
        T = T @ [[c, -s * k, s * h, a * c], [s, c * k, -c * h, a * s], [0, h, k, d], [0, 0, 0, 1]]
    return T
"""
    answer = diagnose_function(written(tmp_path, text), KIND)
    assert [finding.mistake for finding in answer.findings] == ["inputs-changed"]
    assert [line.number for line in answer.lines] == [4] and "np.array(table)" in answer.repaired


def test_two_mistakes_in_one_line_are_named_and_their_line_is_told_once(tmp_path):
    text = PROGRAM.replace(
        "T @ link(theta + q[i], d, a, alpha)", "link(theta - q[i], d, a, alpha) @ T"
    )
    answer = diagnose_function(written(tmp_path, text), KIND)
    assert {finding.mistake for finding in answer.findings} == {
        "offset-subtracted", "product-reversed"}  # fmt: skip
    (line,) = answer.lines
    assert line.number == 18 and is_right(answer.repaired)


def test_an_array_of_whole_numbers_is_not_called_the_one_mistake_beside_another(tmp_path):
    text = """\
import numpy as np

def dh_transform(theta, d, a, alpha):
    A = np.zeros((4, 4), dtype=int)
    A[0] = [np.cos(theta), -np.sin(theta) * np.cos(alpha), np.sin(theta) * np.sin(alpha), 0]
    A[1] = [np.sin(theta), np.cos(theta) * np.cos(alpha), -np.cos(theta) * np.sin(alpha), 0]
    A[0, 3], A[1, 3] = a * np.cos(theta), a * np.sin(theta)
    A[2] = [0, np.sin(alpha), np.cos(alpha), d]
    A[3, 2] = 1
    return A
"""
    path = tmp_path / "whole.py"
    path.write_text(text, encoding="utf-8")
    spec = importlib.util.spec_from_file_location("whole", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    answer = diagnose_function(module.dh_transform, "dh_transform")
    assert {line.number for line in answer.lines} == {4, 9}
    assert "One mistake" not in answer.headline and "line 9" in answer.headline


def test_a_program_of_one_arm_may_know_the_arm(tmp_path):
    text = PROGRAM.replace("def forward_kinematics(rows, q):", f"ROWS = {ROWS.tolist()}\n"
                           "def forward_kinematics(q):\n    rows = ROWS")  # fmt: skip
    tool = dh.transform.trans_z(0.1)
    arm = dh.Arm(dh.DHTable.standard(ROWS, angle="rad"), tool=tool)
    ends_in_tool = text.replace("return T", "return T @ TOOL")
    assert diagnose_function(written(tmp_path, ends_in_tool), KIND, arm=arm)
    answer = diagnose_function(written(tmp_path, text), KIND, arm=arm)
    assert answer.lines[0].instead == "return T @ TOOL"
    other = ends_in_tool.replace("[0, 0, 1, 0.1]", "[0, 0, 1, 0.135]")
    answer = diagnose_function(written(tmp_path, other), KIND, arm=arm)
    assert answer.lines[0].instead.count("[0, 0, 1, 0.1]") == 1
    assert diagnose_function(written(tmp_path, ends_in_tool), KIND, arm=arm.to("craig"))
    with pytest.raises(ValueError, match="whose joints all turn"):
        diagnose_function(written(tmp_path, PROGRAM), KIND, arm=arm.to("craig"))


def test_who_does_more_than_calculate_is_called_but_not_tried(tmp_path):
    text = PROGRAM.replace("-ct * sa", "ct * sa") + "\n\ndef log(T):\n    open('log', 'w')\n"
    kept = text.replace("    return T", "    log(T) if len(q) > 99 else None\n    return T")
    assert not diagnose_function(written(tmp_path, kept), KIND).lines
    assert diagnose_function(written(tmp_path, text), KIND).lines  # log is not needed


def test_nothing_is_told_of_what_no_small_change_repairs(tmp_path, monkeypatch):
    monkeypatch.setattr("dhlab.doctor.programs.functions.SECONDS", 0.3)
    text = PROGRAM.replace("    return T\n", "    return T @ T.T @ link(0.1, 0.2, sum(q), 0.4)\n")
    answer = diagnose_function(written(tmp_path, text.replace("ct, -st", "ca, -st")), KIND)
    assert not answer.lines and answer.repaired is None


TYPED = """\
from math import cos, sin

import numpy as np


def forward_kinematics(q):
    q1, q2, q3 = q
    c1, s1 = cos(q1), sin(q1)
    c2, s2 = cos(q2 - np.pi / 2), sin(q2 - np.pi / 2)
    c3, s3 = cos(q3), sin(q3)
    A1 = np.array([[c1, 0, -s1, 0],
                   [s1, 0, c1, 0],
                   [0, -1, 0, 0.29],
                   [0, 0, 0, 1]])
    A2 = np.array([[c2, -s2, 0, 0.27 * c2],
                   [s2, c2, 0, 0.27 * s2],
                   [0, 0, 1, 0],
                   [0, 0, 0, 1]])
    A3 = np.array([[c3, 0, s3, 0.07 * c3],
                   [s3, 0, -c3, 0.07 * s3],
                   [0, 1, 0, 0.3],
                   [0, 0, 0, 1]])
    return A1 @ A2 @ A3
"""
TYPED_ROWS = [[0, 0.29, 0, -90], [-90, 0, 0.27, 0], [0, 0.3, 0.07, 90]]


@pytest.mark.slow
@pytest.mark.parametrize(
    "lines, wrong",
    [
        ({11, 20}, {"c1, 0, -s1": "c1, 0, s1", "-c3, 0.07": "c3, 0.07"}),
        ({9, 10}, {"(q2 - np.pi / 2)": "(q2)", "cos(q3), sin(q3)": "cos(q2), sin(q2)"}),
    ],
)
def test_two_lines_are_told_of_an_arm_whose_matrices_are_typed(lines, wrong, tmp_path):
    text = TYPED
    for right, slip in wrong.items():
        assert right in text
        text = text.replace(right, slip)
    arm = dh.Arm(dh.DHTable.standard(TYPED_ROWS, angle="deg"))
    assert diagnose_function(written(tmp_path, TYPED), KIND, arm=arm)
    answer = diagnose_function(written(tmp_path, text), KIND, arm=arm)
    assert {line.number for line in answer.lines} == lines, answer
    space = {}
    exec(answer.repaired, space)
    q = [0.7, -1.9, 2.4]
    pose = reference([np.array(r) * [np.pi / 180, 1, 1, np.pi / 180] for r in TYPED_ROWS], q)
    assert np.allclose(space[KIND](q), pose)
