"""Arms whose joints are coupled: the coupling left out, counted twice, with the wrong sign; and
other mistakes of such an arm. The poses come from the plain table, each joint's angle worked out by
hand.
"""

from dataclasses import replace

import numpy as np
import pytest

import dhlab as dh
from dhlab.doctor import diagnose

PLAIN = dh.load("m20ia")  # joint 3's own angle
Q = np.random.default_rng(5).uniform(-1.2, 1.2, (7, 6))


def with_coupling(value, arm=PLAIN):
    coupling = np.eye(6)
    coupling[2, 1] = value
    return replace(arm, coupling=None if value == 0 else coupling)


def measured(value, q=Q):
    """Poses of a controller whose joint 3 turns by q3 + value q2; 0.3 mm of noise."""
    angles = q.copy()
    angles[:, 2] += value * q[:, 1]
    rng = np.random.default_rng(6)
    T = PLAIN.forward(angles)
    T[:, :3, 3] += rng.normal(0, 3e-4, (len(q), 3))
    return T


@pytest.mark.parametrize(
    "told, true, words",
    [
        (0, 1, "turns by q3, should turn by q3 + q2"),
        (2, 1, "turns by q3 + 2 q2, should turn by q3 + q2"),
        (-1, 1, "turns by q3 - q2, should turn by q3 + q2"),
        (1, 0, "turns by q3 + q2, should turn by q3"),
        (0, -1, "turns by q3, should turn by q3 - q2"),
    ],
)
def test_the_coupling_is_named_and_repaired(told, true, words):
    answer = diagnose(with_coupling(told), Q, measured(true), noise=(3e-4, 1e-4))
    first = answer.findings[0]
    assert (answer.verdict, first.mistake, first.joint) == ("explained", "joints-coupled", 3)
    assert words in str(answer)
    other = Q[::-1] * [1, -0.7, 0.4, 1, 0.3, 1]
    angles = other + np.outer(true * other[:, 1], np.eye(6)[2])
    assert np.allclose(first.repair.forward(other), PLAIN.forward(angles), atol=1e-9)


def test_a_right_coupled_arm_agrees():
    assert diagnose(with_coupling(1), Q, measured(1), noise=(3e-4, 1e-4)).verdict == "agrees"


def test_another_mistake_of_a_coupled_arm_is_named():
    rows = PLAIN.table.rows
    rows[3, 1] += 0.02
    wrong = with_coupling(1, dh.Arm(dh.DHTable.standard(rows, angle="rad")))
    first = diagnose(wrong, Q, measured(1), noise=(3e-4, 1e-4)).findings[0]
    assert (first.mistake, first.joint, first.parameter) == ("length-value", 4, "d")
