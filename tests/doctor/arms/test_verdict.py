"""Never a false clean bill, never a vacuous explanation: what few poses, exact ones and coarse ones
may be said to show.
"""

from dataclasses import replace

import numpy as np
import pytest
from draws import few
from scipy.spatial.transform import Rotation
from test_poses import NOISE, entry, general, noisy, remade, told

import dhlab as dh
from dhlab.doctor import diagnose
from dhlab.doctor.arms.digits import written_noise
from dhlab.transform import rot_z


def rounded(T):
    """Positions in whole millimetres, rotation vectors in thousandths of a radian."""
    T = T.copy()
    T[:, :3, 3] = T[:, :3, 3].round(3)
    vectors = Rotation.from_matrix(T[:, :3, :3]).as_rotvec().round(3)
    T[:, :3, :3] = Rotation.from_rotvec(vectors).as_matrix()
    return T


@pytest.mark.parametrize("name", few(dh.robots(), 6))
def test_one_rounded_pose_of_a_right_table_explains_nothing(name):
    right = dh.load(name)
    for seed in range(3):
        q = general(right, 1, seed)
        T = rounded(right.forward(q))
        for poses in (T, T[:, :3, 3]):
            answer = diagnose(right, q, poses)
            assert not answer.findings and answer.verdict in ("agrees", "undecided")


def test_the_digits_say_how_coarse_the_numbers_are():
    p = np.array([[0.4123, -0.2001, 0.07]])
    R = Rotation.from_euler("xyz", [[10.5, -20.1, 33.3]], degrees=True).as_matrix()
    position, turn = written_noise(p, R)
    assert np.allclose([position, turn], np.array([1e-4, np.deg2rad(0.1)]) / np.sqrt(12))
    assert written_noise(p * np.pi, Rotation.from_rotvec([[0.1**0.5, 0.2, 0.3]]).as_matrix()) == (
        0,
        0,
    )
    quaternion = Rotation.from_quat(
        [[0.123, -0.456, 0.789, 0.393]]
    ).as_matrix()  # nearly of length 1
    assert np.isclose(written_noise(p, quaternion)[1], 2e-3 / np.sqrt(12))


def test_the_other_convention_comes_before_six_free_numbers():
    panda = dh.load("panda")
    wrong = dh.Arm(
        dh.DHTable.standard(panda.table.rows, angle="rad"), base=panda.base, tool=panda.tool
    )
    q = general(panda, 1)
    answer = diagnose(wrong, q, rounded(panda.forward(q)))
    first = (*answer.findings, *answer.fits)[0]
    assert first.mistake == "craig-rows-in-standard-matrix"


def test_a_free_base_takes_all_of_one_pose():
    arm = dh.load("ur5e")
    q = general(arm, 1)
    answer = diagnose(arm, q, rot_z(1.0) @ arm.forward(q), base="free")
    assert answer.verdict == "undecided" and not answer.findings and not answer
    assert answer.next_pose.shape == (6,) and "free base" in answer.headline


@pytest.mark.slow
def test_two_noisy_poses_of_a_wrong_table_are_no_clean_bill():
    right, rng = dh.load("ur5e"), np.random.default_rng(3)
    q = general(right, 2)
    answer = diagnose(entry(right, 4, 1, lambda d: d - 0.007), q, noisy(right.forward(q), rng))
    assert answer.verdict != "agrees" and " right" not in answer.headline
    assert answer.to_dict()["fits"] == [f.to_dict() for f in answer.fits]


@pytest.mark.slow
def test_one_axis_off_by_a_centimetre_is_two_lengths_and_no_calibration():
    """The axis of joint 3 moved by 10 mm towards that of joint 2: a2 shorter, a3 longer."""
    table = dh.load("ur5e")
    rows = table.table.rows
    rows[1, 2] += 0.01
    rows[2, 2] -= 0.01
    q = general(table, 8)
    answer = diagnose(table, q, remade(table, rows).forward(q), budget=60)
    assert answer.verdict == "explained"
    assert sorted(f.place for f in answer.findings) == ["row 2, a", "row 3, a"]


@pytest.mark.slow
def test_a_calibrated_arm_is_told_number_by_number():
    table, rng = dh.load("irb120"), np.random.default_rng(4)
    off = rng.normal(0, 1, (6, 4)) * [5e-4, 5e-4, 5e-4, 5e-4]
    q = general(table, 12)
    answer = diagnose(table, q, remade(table, table.table.rows + off).forward(q))
    assert answer.verdict == "calibrated" and " right" not in answer.headline
    listed = next(note for note in answer.notes if note.startswith("The numbers that are off"))
    assert listed.count("mm") >= 3 and listed.count("°") >= 3


@pytest.mark.slow
def test_many_mistakes_are_told_after_the_arm_is_rebuilt():
    right = dh.load("ur5e")
    wrong = entry(entry(right, 2, 2, np.negative), 1, 3, np.negative)
    wrong = entry(entry(wrong, 4, 1, lambda d: d + 0.05), 5, 0, lambda theta: theta + np.pi / 2)
    q, fresh = general(right, 10), general(right, 5, seed=2)
    answer = diagnose(wrong, q, right.forward(q), budget=60)
    assert answer.verdict == "explained" and len(answer.findings) == 4
    assert np.allclose(answer.findings[0].repair.forward(fresh), right.forward(fresh), atol=1e-6)


def test_what_can_hardly_be_meant_is_said_first():
    right = dh.load("ur5e")
    q = np.tile(general(right, 1), (8, 1))
    assert "one and the same" in diagnose(right, q, right.forward(q)).notes[0]
    degrees = np.random.default_rng(1).integers(-90, 90, (6, 6)).astype(float)
    T = right.forward(np.deg2rad(degrees))
    assert "are these degrees?" in diagnose(right, degrees, T).notes[0]
    metres = remade(right, right.table.rows * [1, 1000, 1000, 1])
    answer = diagnose(metres, np.deg2rad(degrees), T)
    assert "another unit" in answer.notes[0] and told(answer) >= {"length-unit"}


def test_a_small_arm_has_small_noise():
    """A finger of 20 mm, 0.1 mm wrong in one length, is wrong; no micrometre decides."""
    rows = dh.load("article-6r").table.rows * [1, 0.02, 0.02, 1]
    right = dh.Arm(dh.DHTable.standard(rows, angle="rad"))
    q = general(right, 6)
    answer = diagnose(entry(right, 2, 2, lambda a: a + 1e-4), q, right.forward(q))
    assert answer.verdict == "explained" and answer.findings[0].place == "row 2, a"
    assert diagnose(right, q, noisy(right.forward(q), np.random.default_rng(1), (2e-5, 1e-3)))


def test_a_budget_is_kept_and_what_was_not_tried_is_said():
    right = dh.load("panda")
    q = general(right, 10)
    shuffled = np.random.default_rng(8).permutation(q)
    answer = diagnose(right, shuffled, right.forward(q), noise=NOISE, budget=0.3)
    assert answer.verdict == "unexplained" and "Not everything was tried" in answer.notes[0]
    for budget in (0, -1, np.nan, "long", True):
        with pytest.raises(ValueError, match="budget"):
            diagnose(right, q, right.forward(q), budget=budget)


@pytest.mark.slow
@pytest.mark.parametrize("turned", [False, True])
def test_another_model_and_a_bent_link_and_a_flange(turned):
    right = dh.load("ur10e")
    q = general(right, 8)
    model = diagnose(dh.load("ur3e"), q, right.forward(q))
    assert [f.mistake for f in model.findings] == ["another-model"]
    series = diagnose(dh.load("ur10_cb"), q[:6], right.forward(q[:6]))
    assert [f.mistake for f in series.findings] == ["another-model"]
    assert any("Universal Robots UR10e (ur10e" in note for note in series.notes)
    bend = np.arctan2(24, 128) * (-1 if turned else 1)
    straight = dh.DHTable.standard(
        [[0, 0.077, 0, 90], [0, 0, 0.128, 0], [0, 0, 0.124, 0], [0, 0, 0.126, 0]], angle="deg"
    )
    rows = straight.rows
    rows[1, 0], rows[1, 2], rows[2, 0] = bend, np.hypot(0.128, 0.024), -bend
    q = general(dh.Arm(straight), 8)
    bent = dh.Arm(dh.DHTable.standard(rows, angle="rad"))
    assert "bent-link" in told(diagnose(straight, q, bent.forward(q)))
    panda = dh.load("panda")
    hand = replace(panda, tool=panda.tool @ rot_z(-np.pi / 4))
    q = general(panda, 4)
    answer = diagnose(panda, q, hand.forward(q))
    assert answer.verdict == "explained" and "flange-frame" in told(answer)


def test_rough_positions_with_free_ends_give_no_clean_bill():
    """Fifteen numbers, of which the ends take nine: a wrong offset would hide in them."""
    arm = dh.load("article-6r")
    q = np.random.default_rng(3).uniform(-2, 2, (5, 6))
    p = arm.forward(q)[:, :3, 3].round(3)
    answer = diagnose(arm, q, p, base="free", tool="free")
    assert answer.verdict == "undecided" and not answer.findings
    assert "5 positions with a free base and tool cannot tell" in answer.headline
    assert diagnose(arm, q, p).verdict == "agrees"
