"""The doctor in a workshop: two mistakes and a tape measure, one bad line, other units, noise that
is none; what it says where it cannot explain.
"""

from dataclasses import replace

import numpy as np
import pytest
from draws import few
from scipy.spatial.transform import Rotation
from test_poses import NOISE, entry, general, noisy

import dhlab as dh
from dhlab.doctor import diagnose
from dhlab.transform import from_xyz_rpy


def turned_joint_and_offset(right):
    rows, sign = right.table.rows, right.sign.copy()
    rows[1, 0] -= np.pi / 2
    sign[2] *= -1
    return replace(
        right, table=dh.DHTable.standard(rows, angle="rad", joints=right.table.joints), sign=sign
    )


def bent_and_longer(right):
    return entry(entry(right, 2, 2, lambda a: 1.1 * a), 4, 3, np.negative)


# every second of them holds both pairs of mistakes, and a base that is free and one that is not
PAIRS = [
    (True, turned_joint_and_offset),
    (False, turned_joint_and_offset),
    (False, bent_and_longer),
    (True, bent_and_longer),
]


@pytest.mark.slow
@pytest.mark.parametrize("free, wrong_of", few(PAIRS, 2))
def test_two_mistakes_are_found_from_positions_alone(free, wrong_of):
    """Of which at least one turns what is behind it: the tape measure sees no rotation."""
    right = dh.load("article-6r")
    q = general(right, 20, 5)
    moved = from_xyz_rpy([0.3, -0.1, 0.5], [0.2, -0.4, 1.0]) if free else np.eye(4)
    p = (moved @ right.forward(q))[:, :3, 3] + np.random.default_rng(6).normal(0, 1e-3, (20, 3))
    answer = diagnose(
        wrong_of(right), q, p, noise=1e-3, base="free" if free else "fixed", budget=60
    )
    assert answer.verdict == "explained" and len(answer.findings) == 2
    fresh = general(right, 10, 7)
    repaired = answer.findings[0].repair.forward(fresh)[:, :3, 3]
    assert np.linalg.norm(repaired - (moved @ right.forward(fresh))[:, :3, 3], axis=1).max() < 5e-3


@pytest.mark.slow
@pytest.mark.parametrize("wrong", [False, True])
def test_one_bad_measurement_is_pointed_out(wrong):
    right = dh.load("ur5e")
    q = general(right, 12, 1)
    poses = noisy(right.forward(q), np.random.default_rng(2))
    poses[4, 0, 3] += 0.1
    arm = entry(right, 4, 3, np.negative) if wrong else right
    answer = diagnose(arm, q, poses, noise=NOISE)
    assert answer.headline.endswith("but number 5.") and any(
        "5th line" in note and "mm in x" in note for note in answer.notes
    )
    assert [f.mistake for f in answer.findings] == (
        ["alpha-sign"] if wrong else []
    ) and answer.verdict == ("explained" if wrong else "unexplained")


@pytest.mark.slow
def test_what_is_right_all_the_same_is_said():
    """Whatever is tried before: a second is as good as ten."""
    right = dh.load("ur5e")
    q = general(right, 12, 1)
    T = noisy(right.forward(q), np.random.default_rng(2))
    lengths = right.table.rows * [1, 1.3, 0.8, 1]
    assert (
        "rotation is right at every pose"
        in diagnose(
            dh.Arm(dh.DHTable.standard(lengths, angle="rad")), q, T, noise=NOISE, budget=1
        ).notes[-1]
    )
    scrambled = T.copy()
    scrambled[:, :3, :3] = Rotation.random(12, random_state=np.random.RandomState(3)).as_matrix()
    assert (
        "position is right at every pose"
        in diagnose(right, q, scrambled, noise=NOISE, budget=1).notes[-1]
    )
    louder = noisy(right.forward(q), np.random.default_rng(2), (3e-3, 3 * NOISE[1]))
    assert "times the noise" in diagnose(right, q, louder, noise=NOISE, budget=1).notes[-1]
    both = (
        from_xyz_rpy([0.1, 0.2, 0.3], [0.1, 1.0, -0.4])
        @ T
        @ from_xyz_rpy([0.02, 0, 0.1], [0.5, 0.1, 0.2])
    )
    assert "another base and another tool" in " ".join(
        diagnose(right, q, both, noise=NOISE, budget=1).notes
    )


@pytest.mark.parametrize(
    "wrong_of, mistake",
    [
        (lambda rows: rows * [1, 1, 1, np.pi / 180], "angle-unit"),
        (lambda rows: rows * [np.pi / 180, 1, 1, np.pi / 180], "angle-unit"),
        (lambda rows: rows * [1, 0.1, 0.1, 1], "length-unit"),
        (lambda rows: rows, None),
    ],
    ids=["alpha in radians", "all in radians", "centimetres", "right"],
)
def test_a_table_in_another_unit_is_named(wrong_of, mistake):
    right = dh.load("article-6r")
    rows = right.table.rows
    rows[1, 0] = np.pi / 2
    right = dh.Arm(dh.DHTable.standard(rows, angle="rad"))
    q = general(right, 10, 1)
    answer = diagnose(
        dh.Arm(dh.DHTable.standard(wrong_of(rows), angle="rad")),
        q,
        noisy(right.forward(q), np.random.default_rng(2)),
        noise=NOISE,
    )
    assert [f.mistake for f in answer.findings] == ([mistake] if mistake else [])


@pytest.mark.slow
def test_a_missing_length_is_no_unit_and_a_small_repair_keeps_its_own_name():
    rows = dh.load("article-6r").table.rows
    rows[2, 2], rows[5, 0] = 0.045, np.pi  # the sign of an offset of 180° says nothing
    right = dh.Arm(dh.DHTable.standard(rows, angle="rad"))
    q = general(right, 10, 1)
    poses = noisy(right.forward(q), np.random.default_rng(2))
    answer = diagnose(entry(right, 3, 2, lambda a: 0.0), q, poses, noise=NOISE)
    assert [f.mistake for f in answer.findings] == [
        "length-value"
    ] and "should be 45" in answer.findings[0].detail
    two = diagnose(
        entry(entry(right, 2, 2, lambda a: a + 0.005), 4, 3, np.negative), q, poses, noise=NOISE
    )
    assert {f.mistake for f in two.findings} == {"length-value", "alpha-sign"}


def test_zeros_that_are_off_are_listed():
    right = dh.load("article-6r")
    rows = right.table.rows
    rows[:, 0] += np.deg2rad([2, -3, 4, 1.5, -2, 3])
    q = general(right, 10, 1)
    answer = diagnose(
        dh.Arm(dh.DHTable.standard(rows, angle="rad")),
        q,
        noisy(right.forward(q), np.random.default_rng(2)),
        noise=NOISE,
    )
    assert [f.mistake for f in answer.findings] == ["offset-value"] and all(
        f"theta{i}" in answer.findings[0].detail for i in range(2, 6)
    )


def test_the_size_once_repaired_is_that_of_the_mended_measurements():
    right = dh.load("article-6r")
    q = general(right, 10, 1)
    poses = noisy(right.forward(q), np.random.default_rng(2))
    poses[:, :3, 3] = poses[:, [1, 0, 2], 3]
    answer = diagnose(right, q, poses, noise=NOISE)
    assert (
        answer.findings[0].place == "x and y have changed places"
        and answer.after[0] < 6 < 100 < answer.before[0]
    )


@pytest.mark.parametrize(
    "noise, words", [((4.0, 0.01), "4 mm are 0.004"), (1e-3, "expected two numbers")]
)
def test_noise_that_cannot_be_meant_is_refused(noise, words):
    right = dh.load("article-6r")
    q = general(right, 10, 1)
    with pytest.raises(ValueError, match=words):
        diagnose(right, q, right.forward(q), noise=noise)


@pytest.mark.parametrize("factor", [1e-3, 1e3])
def test_noise_is_not_measured_by_a_table_in_another_unit(factor):
    right = dh.load("article-6r")
    q = general(right, 10, 1)
    p = right.forward(q)[:, :3, 3] + np.random.default_rng(2).normal(0, 4e-3, (10, 3))
    wrong = dh.Arm(dh.DHTable.standard(right.table.rows * [1, factor, factor, 1], angle="rad"))
    assert [f.mistake for f in diagnose(wrong, q, p, noise=4e-3).findings] == ["length-unit"]
    assert [f.mistake for f in diagnose(right, q, p * factor, noise=4e-3 * factor).findings] == [
        "length-unit"
    ]
