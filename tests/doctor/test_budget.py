"""The time that a search may take: what was not tried is said, whoever asks; long logs are thinned
and that is said too.
"""

import numpy as np
import pytest

import dhlab as dh
from dhlab.doctor import diagnose, diagnose_motion

AXES = [([0, 0, 0.2], [0, 0, 1]), ([0, 0, 0.4], [0, 1, 0]), ([0.4, 0, 0.4], [0, 1, 0])]
END = dh.transform.trans([0.7, 0, 0.4])
RIGHT = dh.assign_frames(AXES, end=END)
Q = np.random.default_rng(3).uniform(-2, 2, (9, 3))
MOVED = [(np.add(p, 0.03 * k), np.add(z, 0.05 * k)) for k, (p, z) in enumerate(AXES, 1)]
WRONG = dh.assign_frames(MOVED, end=END)
NONE = 1e-9  # seconds


def sweeps(arm, each=9):
    q = np.tile([0.3, 0.4, -0.7], (3 * each, 1))
    for i in range(3):
        q[each * i : each * (i + 1), i] = np.linspace(-1, 1, each)
    return q, arm.forward(q)[:, :3, 3]


@pytest.mark.parametrize(
    "ask",
    [
        lambda: diagnose(WRONG, Q, RIGHT.forward(Q), budget=NONE),
        lambda: dh.diagnose_axes(MOVED, END, Q, RIGHT.forward(Q), noise=(1e-4, 1e-4), budget=NONE),
        lambda: diagnose_motion(WRONG, *sweeps(RIGHT), budget=NONE),
    ],
)
def test_what_was_not_tried_is_said(ask):
    answer = ask()
    assert answer.findings == () and answer.before
    assert any("Not everything was tried" in note for note in answer.notes)


def test_a_long_log_is_thinned_evenly_and_that_is_said():
    q = np.random.default_rng(4).uniform(-2, 2, (6000, 3))
    rows = RIGHT.table.rows
    rows[1, 2] += 0.01
    wrong = dh.Arm(dh.DHTable.standard(rows, angle="rad"), base=RIGHT.base, tool=RIGHT.tool)
    answer = diagnose(wrong, q, RIGHT.forward(q))
    assert answer.findings[0].place == "row 2, a"
    assert "Of 6000 poses one in 12 was used, 500 in all." in answer.notes
    assert len(answer.compared[1]) == len(answer.compared[2]) == 500
    assert any("one in 12" in n for n in dh.diagnose_axes(AXES, END, q, RIGHT.forward(q)).notes)


@pytest.mark.parametrize("seconds", [0, -1, True, "10", np.inf])
def test_a_budget_that_is_no_time_is_one_sentence(seconds):
    with pytest.raises(ValueError, match="diagnose_axes: budget: expected seconds"):
        dh.diagnose_axes(AXES, END, Q, RIGHT.forward(Q), budget=seconds)


def test_rotations_without_noise_do_not_make_noisy_positions_a_mistake():
    q = np.random.default_rng(5).uniform(-2, 2, (60, 3))
    T = RIGHT.forward(q)
    T[:, :3, 3] += np.random.default_rng(6).normal(0, 1e-3, (60, 3))
    assert diagnose(RIGHT, q, T).verdict == "agrees"
