"""The doctor from poses: what it finds, what it leaves alone, what it refuses. Judged at fresh
configurations and by ``equivalent``.
"""

import json
from dataclasses import replace

import numpy as np
import pytest
from draws import few
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab.doctor import catalogue, diagnose
from dhlab.transform import rot_x, rot_z, trans

NOISE = (1e-3, np.deg2rad(0.2))
ARMS = ("article-6r", "panda", "irb120", "stanford")
# every second of them holds each arm, and a base that is free and one that is not
ENDS_OF_ARMS = [
    *(("ar4", True), ("ar4", False)),
    *(("panda", False), ("panda", True)),
    *(("iiwa14", True), ("iiwa14", False)),
]


def general(arm, m, seed=1):
    q = np.random.default_rng(seed).uniform(-2.5, 2.5, (m, len(arm)))
    return np.where(arm.table.prismatic, np.abs(q) / 5, q)


def remade(arm, rows=None, **parts):
    """The arm with other rows, made anew through all checks."""
    rows = arm.table.rows if rows is None else rows
    make = dh.DHTable.standard if arm.table.convention == "standard" else dh.DHTable.craig
    return replace(arm, table=make(rows, angle="rad", joints=arm.table.joints), **parts)


def noisy(T, rng, noise=NOISE):
    T = T.copy()
    T[:, :3, 3] += rng.normal(0, noise[0], (len(T), 3))
    T[:, :3, :3] = (
        T[:, :3, :3] @ Rotation.from_rotvec(rng.normal(0, noise[1], (len(T), 3))).as_matrix()
    )
    return T


def entry(arm, row, column, change):
    rows = arm.table.rows
    rows[row - 1, column] = change(rows[row - 1, column])
    return remade(arm, rows)


def singles(arm):
    """(mistake, joint, wrong arm): the alpha and the length with the largest effect that the arm
    has, a joint, base, units.
    """
    twist = int(np.flatnonzero(np.abs(np.sin(arm.table.alpha)) > 0.5)[1]) + 1
    length = int(np.argmax(np.abs(arm.table.a) if arm.table.a.any() else np.abs(arm.table.d))) + 1
    column = 2 if arm.table.a.any() else 1
    yield "alpha-sign", twist, entry(arm, twist, 3, np.negative)
    yield "length-sign", length, entry(arm, length, column, np.negative)
    yield "length-value", length, entry(arm, length, column, lambda v: 1.17 * v)
    yield (
        "joint-reversed",
        2,
        replace(arm, sign=arm.sign * np.where(np.arange(len(arm)) == 1, -1, 1)),
    )
    yield "length-unit", None, remade(arm, arm.table.rows * [1, 1000, 1000, 1])
    yield "base-turned", None, replace(arm, base=rot_z(0.8) @ arm.base)


def told(answer):
    return {f.mistake for f in answer.findings} | {
        name for f in answer.findings for name in f.look_alikes
    }


@pytest.mark.slow
@pytest.mark.parametrize("name", ARMS)
def test_exact_singles(name):
    right = dh.load(name)
    q, fresh = general(right, 10), general(right, 20, seed=2)
    for mistake, joint, wrong in singles(right):
        answer = diagnose(wrong, q, right.forward(q))
        assert answer.verdict == "explained" and mistake in told(answer), (mistake, str(answer))
        repair = answer.findings[0].repair
        assert np.allclose(repair.forward(fresh), right.forward(fresh), atol=1e-6), mistake
        if repair.table.convention == right.table.convention and (repair.sign == right.sign).all():
            assert dh.equivalent(repair, right, base="free", tool="free"), mistake
        if answer.findings[0].mistake == mistake and joint:
            assert answer.findings[0].joint == joint
        assert answer.before[0] > 1 and answer.after[0] < 1e-3 and str(answer)


@pytest.mark.slow
@pytest.mark.parametrize("name", ARMS)
def test_singles_with_noise(name):
    right = dh.load(name)
    rng = np.random.default_rng(5)
    q, fresh = general(right, 10), general(right, 20, seed=2)
    T = noisy(right.forward(q), rng)
    for mistake, _, wrong in singles(right):
        answer = diagnose(wrong, q, T, noise=NOISE)
        assert answer.verdict == "explained" and mistake in told(answer), (mistake, str(answer))
        assert np.abs(answer.findings[0].repair.forward(fresh) - right.forward(fresh)).max() < 0.01
    assert diagnose(right, q, T, noise=NOISE).verdict == "agrees"
    assert diagnose(right, q, right.forward(q)).verdict == "agrees"


@pytest.mark.slow
@pytest.mark.parametrize("name", few(["article-6r", "irb120"], 1))
def test_positions_in_another_base_frame(name):
    right = dh.load(name)
    rng = np.random.default_rng(6)
    q = general(right, 20)
    p = (trans([0.4, -0.3, 0.2]) @ rot_z(1.1) @ rot_x(0.4) @ right.forward(q))[
        :, :3, 3
    ] + rng.normal(0, 1e-3, (20, 3))
    for mistake, _, wrong in list(singles(right))[:4]:
        answer = diagnose(wrong, q, p, noise=1e-3, base="free")
        assert answer.verdict == "explained" and mistake in told(answer), (mistake, str(answer))
        assert np.isnan(answer.before[1]) and answer.to_dict()["before"]["deg"] is None
    assert diagnose(right, q, p, noise=1e-3, base="free").verdict == "agrees"
    assert diagnose(right, q, p, noise=1e-3).verdict == "explained"  # the base is what differs


@pytest.mark.slow
@pytest.mark.parametrize("name, free", few(ENDS_OF_ARMS, 3))
def test_lost_signs_and_a_lost_tool_show_in_positions(name, free):
    right, rng = dh.load(name), np.random.default_rng(8)
    moved = trans([0.4, -0.3, 0.2]) @ rot_z(1.1) @ rot_x(0.4) if free else np.eye(4)
    q, fresh = general(right, 20), general(right, 8, seed=2)
    p = (moved @ right.forward(q))[:, :3, 3] + rng.normal(0, 1e-3, (20, 3))
    rows = right.table.rows
    rows[:, 1:] = np.abs(rows[:, 1:])
    for mistake, wrong in (
        ("lengths-made-positive", remade(right, rows)),
        ("tool-missing", remade(right, tool=right.tool @ trans([0.06, -0.05, 0.11]))),
    ):
        answer = diagnose(wrong, q, p, noise=1e-3, base="free" if free else "fixed")
        assert answer.verdict == "explained" and mistake in told(answer), str(answer)
        found, wanted = (
            answer.findings[0].repair.forward(fresh)[:, :3, 3],
            (moved @ right.forward(fresh))[:, :3, 3],
        )
        assert np.linalg.norm(found - wanted, axis=1).max() < 5e-3, str(answer)


def test_a_name_and_its_number_belong_together():
    right, rng = dh.load("article-6r"), np.random.default_rng(9)
    q = general(right, 20)
    p = right.forward(q)[:, :3, 3] + rng.normal(0, 1e-3, (20, 3))
    answer = diagnose(entry(right, 5, 3, np.negative), q, p, noise=1e-3)
    assert (
        answer.findings[0].mistake == "alpha-sign"
        and answer.findings[0].detail == "alpha5 is 90°, should be -90°"
    )
    assert (
        "offset-missing" in told(answer)
        and "The same arm comes of this: theta5 is 0°, should be 180°." in answer.notes
    )


@pytest.mark.slow
@pytest.mark.parametrize("name", few(ARMS, 1))
def test_a_calibrated_arm_is_no_mistake(name):
    right = dh.load(name)
    rng = np.random.default_rng(7)
    for noise in (NOISE, None):
        rows = right.table.rows + rng.normal(0, 1, (len(right), 4)) * [
            np.deg2rad(0.05),
            5e-4,
            5e-4,
            np.deg2rad(0.05),
        ]
        q = general(right, 10)
        T = remade(right, rows).forward(q)
        answer = diagnose(right, q, noisy(T, rng) if noise else T, noise=noise)
        assert answer.verdict in ("agrees", "calibrated") and not answer.findings, str(answer)


@pytest.mark.slow
@pytest.mark.parametrize("name", few(["article-6r", "panda"], 1))
def test_garbage_is_unexplained(name):
    right = dh.load(name)
    q = general(right, 10)
    answer = diagnose(right, np.random.default_rng(8).permutation(q), right.forward(q), noise=NOISE)
    assert (
        answer.verdict == "unexplained"
        and not answer.findings
        and not answer
        and "belong together" in answer.notes[-1]
    )


def test_too_few_or_special_poses_are_said():
    arm = dh.load("article-6r")
    q = general(arm, 2)
    assert any("1 more" in note for note in diagnose(arm, q, arm.forward(q)).notes)
    assert any("4 more" in note for note in diagnose(arm, q, arm.forward(q)[:, :3, 3]).notes)
    quarters = np.random.default_rng(9).integers(-2, 3, (8, 6)) * np.pi / 2
    assert any(
        "multiples of 90°" in note for note in diagnose(arm, quarters, arm.forward(quarters)).notes
    )


def test_a_table_is_taken_for_an_arm():
    arm = dh.load("article-6r")
    q = general(arm, 6)
    assert diagnose(arm.table, q, arm.forward(q))


GOOD = np.random.default_rng(1).uniform(-1, 1, (5, 6))
POSES = dh.load("article-6r").forward(GOOD)
HOLE = POSES[:, :3, 3].copy()
HOLE[2, 1] = np.nan


@pytest.mark.parametrize(
    "arguments, options, words",
    [
        (("ur5e", GOOD, POSES), {}, "expected an Arm"),
        ((None, GOOD[:, :5], POSES), {}, "expected 6"),
        ((None, GOOD, POSES[:4]), {}, "as many poses"),
        ((None, GOOD, POSES[:, :3]), {}, "as many poses"),
        ((None, GOOD[:0], POSES[:0]), {}, "expected"),
        ((None, GOOD, HOLE), {}, "finite"),
        ((None, GOOD * np.nan, POSES), {}, "NaN"),
        ((None, GOOD, 2 * POSES), {}, "poses"),
        ((None, GOOD, POSES), {"base": "unknown"}, '"fixed" or "free"'),
        ((None, GOOD, POSES), {"tool": True}, '"fixed" or "free"'),
        ((None, GOOD, POSES), {"noise": -1}, "noise"),
        ((None, GOOD, POSES), {"noise": (1, 2, 3)}, "noise"),
    ],
)
def test_bad_input_is_refused_in_one_sentence(arguments, options, words):
    arm, q, poses = arguments
    with pytest.raises(ValueError, match=words) as caught:
        diagnose(dh.load("article-6r") if arm is None else arm, q, poses, **options)
    assert "\n" not in str(caught.value)


@pytest.fixture(scope="module")
def answer():
    right = dh.load("article-6r")
    q = general(right, 8)
    return diagnose(
        entry(replace(right, name="<b>bold</b>"), 4, 3, np.negative), q, right.forward(q)
    )


def test_plain_values_and_words(answer):
    plain = json.loads(json.dumps(answer.to_dict(), allow_nan=False))
    assert (
        plain["verdict"] == "explained"
        and plain["findings"][0]["mistake"] == "alpha-sign"
        and len(plain["findings"][0]["repair"]["rows"]) == 6
    )
    assert (
        str(answer).startswith(answer.headline)
        and catalogue()["alpha-sign"].title in str(answer)
        and repr(answer) == str(answer)
    )


def test_html_escapes(answer):
    page = replace(answer, headline="a < b & <script>", notes=("<i>",))._repr_html_()
    assert (
        "<script>" not in page
        and "&lt;script&gt;" in page
        and "&lt;i&gt;" in page
        and "<b>bold" not in page
    )


def test_the_picture_is_drawn_when_asked_for():
    from dhlab.doctor import Diagnosis

    arm = dh.load("article-6r")
    answer = Diagnosis("agrees", "The table agrees.", compared=(arm, GOOD, POSES))
    assert "picture" not in vars(answer) and "compared" not in repr(answer)
    assert (
        answer.picture is answer.picture
        and "mm" in answer.picture.alt
        and "<figure" in answer._repr_html_()
    )
    assert Diagnosis("agrees", "The table agrees.").picture is None
