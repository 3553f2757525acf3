"""The time that a search may take: what was not tried is said, whoever asks; long logs are thinned
and that is said too.
"""

import numpy as np
import pytest

import dhlab as dh
from dhlab.doctor import budget, diagnose, diagnose_motion
from dhlab.doctor.arms.search.measured import Measured

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


class Counted:
    """A clock that a look at the measurements moves on, and nothing else: of 0.02 s."""

    def __init__(self):
        self.seconds = 0.0

    def process_time(self):
        return self.seconds

    def looking(self, look):
        def counted(*given):
            self.seconds += 0.02
            return look(*given)

        return counted


def turned_wrist(base, tool, count, **options):
    """A six-axis arm whose one mistake has many twins, its ends unknown."""
    right = dh.load("kr6_r700")
    rows = right.table.rows
    rows[4, 3] *= -1
    q = np.random.default_rng(8).uniform(-2, 2, (count, 6))
    wrong = dh.Arm(dh.DHTable.standard(rows, angle="rad"), base=right.base, sign=right.sign)
    T = dh.transform.rot_x(0.4) @ right.forward(q)
    return lambda: diagnose(wrong, q, T, base=base, tool=tool, **options)


def many_mistakes(count):
    right = dh.load("kr6_r700")
    rows = right.table.rows + np.random.default_rng(9).uniform(-0.3, 0.3, (6, 4))
    q = np.random.default_rng(8).uniform(-2, 2, (count, 6))
    wrong = dh.Arm(dh.DHTable.standard(rows, angle="rad"), base=right.base, sign=right.sign)
    return lambda: diagnose(wrong, q, right.forward(q), budget=BUDGET)


BUDGET = 10.0


@pytest.mark.parametrize(
    "ask",
    [
        turned_wrist("free", "free", 5, noise=(1e-3, 1e-3), budget=BUDGET),
        turned_wrist("fixed", "free", 2, budget=BUDGET),
        many_mistakes(8),
        many_mistakes(3),
        lambda: dh.diagnose_axes(MOVED, END, Q, RIGHT.forward(Q), budget=BUDGET),
        lambda: diagnose_motion(WRONG, *sweeps(RIGHT), budget=BUDGET),
    ],
    ids=["twins", "few poses", "many mistakes", "many mistakes, few poses", "axes", "motion"],
)
def test_the_whole_answer_keeps_the_budget(ask, monkeypatch):
    clock = Counted()
    monkeypatch.setattr(budget, "time", clock)
    monkeypatch.setattr(Measured, "residual", clock.looking(Measured.residual))
    answer = ask()
    assert answer.headline and clock.seconds < BUDGET


@pytest.mark.parametrize("seconds", [0, -1, True, "10", np.inf])
def test_a_budget_that_is_no_time_is_one_sentence(seconds):
    with pytest.raises(ValueError, match="diagnose_axes: budget: expected seconds"):
        dh.diagnose_axes(AXES, END, Q, RIGHT.forward(Q), budget=seconds)


def test_rotations_without_noise_do_not_make_noisy_positions_a_mistake():
    q = np.random.default_rng(5).uniform(-2, 2, (60, 3))
    T = RIGHT.forward(q)
    T[:, :3, 3] += np.random.default_rng(6).normal(0, 1e-3, (60, 3))
    assert diagnose(RIGHT, q, T).verdict == "agrees"
