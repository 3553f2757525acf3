"""Slips in programs of other styles: with methods, with flat lists, with R and p apart; the line is
told, and with it changed the program is right by a product that is not dhlab's.
"""

import numpy as np
import pytest
from test_lines import KIND, ROWS, is_right, reference, written

import dhlab as dh
from dhlab.doctor.programs.functions import diagnose_function
from dhlab.transform import rot_y, trans_x

APART = """\
import numpy as np

def Rz(t):
    return np.array([[np.cos(t), -np.sin(t), 0], [np.sin(t), np.cos(t), 0], [0, 0, 1]])

def Rx(t):
    return np.array([[1, 0, 0], [0, np.cos(t), -np.sin(t)], [0, np.sin(t), np.cos(t)]])

def forward_kinematics(rows, q):
    R, p = np.eye(3), np.zeros(3)
    for i, (theta, d, a, alpha) in enumerate(rows):
        turn = Rz(theta + q[i])
        p = p + R @ (np.array([0, 0, d]) + turn @ np.array([a, 0, 0]))
        R = R @ turn @ Rx(alpha)
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T
"""
FLAT = """\
import math
import numpy as np

def product(A, B):
    C = [0.0] * 16
    for i in range(4):
        for j in range(4):
            s = 0.0
            for k in range(4):
                s += A[4 * i + k] * B[4 * k + j]
            C[4 * i + j] = s
    return C

class Chain:
    def __init__(self, rows):
        self.links = []
        for row in rows:
            self.links.append(row)

    def link(self, i, angle):
        theta, d, a, alpha = self.links[i]
        c, s = math.cos(theta + angle), math.sin(theta + angle)
        ca, sa = math.cos(alpha), math.sin(alpha)
        return [c, -s * ca, s * sa, a * c, s, c * ca, -c * sa, a * s, 0, sa, ca, d, 0, 0, 0, 1]

def forward_kinematics(rows, q):
    T = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]
    chain = Chain(rows)
    for i in range(len(rows)):
        T = product(T, chain.link(i, q[i]))
    return np.array(T).reshape(4, 4)
"""


@pytest.mark.parametrize(
    "text, lines, found, wrong",
    [
        (APART, 7, "[[1, 0, 0], [0, np.cos(t), -np.sin(t)], [0, np.sin(t), np.cos(t)]]",
         "[[np.cos(t), 0, np.sin(t)], [0, 1, 0], [-np.sin(t), 0, np.cos(t)]]"),
        (APART, 13, "(np.array([0, 0, d]) + turn @ np.array([a, 0, 0]))",
         "turn @ (np.array([0, 0, d]) + R.T @ np.array([a, 0, 0]))"),
        (APART, 12, "theta + q[i]", "max(-np.pi, min(np.pi, theta + q[i]))"),
        (FLAT, (6, 7, 9), "            s = 0.0\n", ""),
        (FLAT, (16, 18), "    def __init__(self, rows):\n        self.links = []\n",
         "    links = []\n\n    def __init__(self, rows):\n"),
        (FLAT, 23, "math.cos(alpha), math.sin(alpha)", "math.cos(alpha / 2), math.sin(alpha / 2)"),
    ],
    ids=["about y", "one bracket", "held within pi", "sum not reset", "of the class", "half"],
)  # fmt: skip
def test_the_line_is_told(text, lines, found, wrong, tmp_path):
    assert text.count(found) == 1
    program = text.replace(found, wrong)
    if not wrong:
        program = program.replace("    C = [0.0] * 16\n", "    C = [0.0] * 16\n    s = 0.0\n")
    answer = diagnose_function(written(tmp_path, program), KIND)
    assert answer.verdict == "explained", str(answer)
    assert is_right(answer.repaired), str(answer)
    wanted = lines if isinstance(lines, tuple) else (lines,)
    assert {line.number for line in answer.lines} <= set(wanted), str(answer)


def test_what_is_made_of_base_and_tool_has_a_name(tmp_path):
    base, tool = trans_x(0.3) @ rot_y(0.4), rot_y(-1.1) @ trans_x(0.2)
    arm = dh.Arm(dh.DHTable.standard(ROWS, angle="rad"), base=base, tool=tool)

    def chain(rows, q):
        return np.asarray(reference(rows, q))

    made = {
        "tool-missing": lambda rows, q: base @ chain(rows, q),
        "base-missing": lambda rows, q: chain(rows, q) @ tool,
        "tool-on-wrong-side": lambda rows, q: tool @ base @ chain(rows, q),
        "base-on-wrong-side": lambda rows, q: chain(rows, q) @ tool @ base,
        "ends-exchanged": lambda rows, q: tool @ chain(rows, q) @ base,
        "ends-left-out": chain,
        "end-inverted": lambda rows, q: np.linalg.inv(base) @ chain(rows, q) @ tool,
    }
    found = {name: diagnose_function(f, KIND, arm=arm).findings for name, f in made.items()}
    assert [finding.mistake for (finding,) in found.values()] == list(made)
