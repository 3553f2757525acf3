"""``dhlab doctor program.py`` as a user types it."""

import json

import pytest
from terminal import dhlab

LINK = """\
import numpy as np

print("loaded")

def dh_transform(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st * ca, st * sa, a * ct],
                     [st, ct * ca, -ct * sa, a * st],
                     [0, sa, ca, d],
                     [0, 0, 0, 1]])
"""
ONE_ARM = """
import dhlab as dh

def forward_kinematics(q):
    T = np.eye(4)
    for (theta, d, a, alpha), x in zip(dh.load("ur5e").table.rows, q):
        T = T @ dh_transform(theta + x, d, a, alpha)
    return T
"""


def doctor(tmp_path, text, *arguments):
    path = tmp_path / "program.py"
    path.write_text(text, encoding="utf-8")
    return dhlab("doctor", path, *arguments)


def test_a_program_s_line_is_told(tmp_path):
    wrong = LINK.replace("-ct * sa", "ct * sa")
    told = doctor(tmp_path, wrong)
    assert told.returncode == 0 and "loaded" not in told.stdout
    assert "dh_transform: " in told.stdout and "8: " in told.stdout
    line = json.loads(doctor(tmp_path, wrong, "--json").stdout)["dh_transform"]["lines"][0]
    assert line["number"] == 8 and line["found"] == "[st, ct * ca, ct * sa, a * st],"


def test_a_program_of_one_arm(tmp_path):
    assert "right pose in every call" in doctor(tmp_path, LINK + ONE_ARM, "ur5e").stdout


THREE_AT_ONCE = """
def forward_kinematics(q):
    A = [dh_transform(x + t, 1000 * d, 1000 * a, w) for x, (t, d, a, w) in zip(q, ROWS)]
    return np.matmul(A[0], A[1], A[2])
"""


def test_a_program_in_millimetres_whose_matmul_takes_three(tmp_path):
    """numpy writes the product of two into the third."""
    (tmp_path / "arm.yaml").write_text(
        "convention: standard\nunits: {length: m, angle: deg}\njoints:\n"
        "  - {theta: 0, d: 0.1, a: 0, alpha: 90}\n  - {theta: 0, d: 0, a: 0.4, alpha: 0}\n"
        "  - {theta: 0, d: 0, a: 0.3, alpha: 0}\n"
    )
    rows = "ROWS = [(0, 0.1, 0, np.pi / 2), (0, 0, 0.4, 0), (0, 0, 0.3, 0)]\n"
    told = doctor(tmp_path, LINK + rows + THREE_AT_ONCE, tmp_path / "arm.yaml").stdout
    assert "(A[0]) @ (A[1]) @ (A[2])" in told and "reckons in millimetres" in told


@pytest.mark.parametrize(
    "text, words",
    [
        ("def dh_transform(theta:\n", "line 1: Python cannot read this"),
        ("x = 1\ny = x / 0\n", "line 2: the file stops with ZeroDivisionError"),
        ("x = 1\n", "found neither"),
    ],
)
def test_what_cannot_be_looked_at_is_one_sentence(text, words, tmp_path):
    told = doctor(tmp_path, text)
    assert told.returncode == 2 and words in " ".join(told.stderr.split())
    assert "Traceback" not in told.stderr
