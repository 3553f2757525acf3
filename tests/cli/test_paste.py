"""``dhlab paste`` as a user types it: from a file, from standard input, asked and answered."""

import json

import numpy as np
import pytest
from terminal import dhlab

import dhlab as library

UR3E = """DH parameters UR3e
theta  d [m]    a [m]     alpha [rad]
q1     0.15185  0         pi/2
q2     0        -0.24355  0
q3     0        -0.2132   0
q4     0.13105  0         pi/2
q5     0.08535  0         -pi/2
q6     0.0921   0         0
"""
LETTERS = "standard DH\ntheta d a alpha\nq1 L1 0 90\nq2 0 L2 0\n"


def test_a_table_from_standard_input_asks_for_the_convention_and_is_answered(tmp_path):
    asked = dhlab("paste", typed=UR3E)
    assert asked.returncode == 0 and "Question: For which matrix" in asked.stdout
    assert "--convention standard" in asked.stdout

    file = tmp_path / "ur3e.yaml"
    told = dhlab("paste", "-", "--convention", "standard", "--out", file, typed=UR3E)
    assert told.returncode == 0 and "Read as columns theta, d, a, alpha" in told.stdout
    assert library.equivalent(library.load(file), library.load("ur3e"))


def test_a_reading_is_taken_by_its_number_and_nothing_is_written_before_that(tmp_path):
    text, out = tmp_path / "notes.txt", tmp_path / "arm.yaml"
    text.write_text(UR3E)
    open_still = dhlab("paste", text, "--out", out)
    assert open_still.returncode == 2 and "--take" in open_still.stderr and not out.exists()
    readings = json.loads(dhlab("paste", text, "--json").stdout)["readings"]
    assert dhlab("paste", text, "--take", 2, "--out", out).returncode == 0
    assert library.load(out).table.convention == readings[1]["arm"]["convention"]


def test_letters_get_their_values_and_calibrations_their_nominal_table():
    asked = dhlab("paste", typed=LETTERS)
    assert asked.returncode == 2 and "L1, L2 have no value" in asked.stderr
    told = dhlab("paste", "--value", "L1=0.1", "--value", "L2=0.4", "--json", typed=LETTERS)
    (reading,) = json.loads(told.stdout)["readings"]
    assert np.allclose(reading["arm"]["rows"], [[0, 0.1, 0, np.pi / 2], [0, 0, 0.4, 0]])

    deltas = "\n".join(f"delta_{name} = [0, 0, 0.001, 0, 0, 0]" for name in ("theta", "a", "d"))
    deltas += "\ndelta_alpha = [0, 0, 0, 0, 0, 0]"
    assert "which robot" in dhlab("paste", typed=deltas).stderr
    told = dhlab("paste", "--nominal", "ur3e", "--json", typed=deltas)
    (reading,) = json.loads(told.stdout)["readings"]
    nominal = library.load("ur3e").table.rows
    assert np.allclose(
        np.array(reading["arm"]["rows"]) - nominal,
        [[0] * 4] * 2 + [[0.001] * 3 + [0]] + [[0] * 4] * 3,
    )


def test_the_right_arm_picks_the_reading():
    told = dhlab("paste", "--right", "ur3e", "--json", typed=UR3E)
    answer = json.loads(told.stdout)
    assert answer["matches"] is True and len(answer["readings"]) == 1


@pytest.mark.parametrize(
    "arguments, typed, words",
    [
        ((), "hello", "at least one row"),
        (("no-such-file.txt",), "", "no-such-file.txt"),
        (("--value", "L1"), LETTERS, "expected a name and a number"),
        (("--take", "9"), UR3E, "from 1 to 2"),
        (("--convention", "modified"), UR3E, "standard or craig"),
    ],
)
def test_errors_are_one_sentence(arguments, typed, words):
    answer = dhlab("paste", *arguments, typed=typed)
    assert answer.returncode == 2 and words in answer.stderr and answer.stderr.count("\n") == 1
