"""From a picture of motion: injected mistakes, and the circles against the table of dh_facts,
section 2.
"""

import json
from dataclasses import replace

import numpy as np
import pytest
from terminal import dhlab

import dhlab as dh
from dhlab.doctor.arms.motion import diagnose_motion

REST = np.array([0.3, 0.4, -0.7, 0.5, 0.9, 0.2])


def sweeps(arm, joints=None, rest=REST):
    """Nine points a joint, one joint after the other."""
    parts = []
    for i in joints or range(1, len(arm) + 1):
        q = np.tile(rest[: len(arm)], (9, 1))
        q[:, i - 1] = (
            np.linspace(0.2, 0.6, 9) if arm.table.joints[i - 1] == "P" else np.linspace(-1, 1, 9)
        )
        parts.append(q)
    return np.vstack(parts)


def changed(arm, row, column, change):
    rows = arm.table.rows
    rows[row - 1, column] += change
    make = dh.DHTable.standard if arm.table.convention == "standard" else dh.DHTable.craig
    return dh.Arm(
        make(rows, angle="rad", joints=arm.table.joints),
        base=arm.base,
        tool=arm.tool,
        sign=arm.sign,
    )


def reversed_joint(arm, joint):
    return replace(arm, sign=arm.sign * np.where(np.arange(len(arm)) == joint - 1, -1, 1))


def injected(arm):
    return {
        "joint 2 reversed": reversed_joint(arm, 2),
        "theta3": changed(arm, 3, 0, np.deg2rad(10)),
        "d1": changed(arm, 1, 1, 0.1),
        "a2": changed(arm, 2, 2, 0.05),
        "alpha1": changed(arm, 1, 3, -2 * arm.table.alpha[0]),
    }


def words_of(answer, joint):
    return next(note for note in answer.notes if note.startswith(f"Joint {joint}:"))


@pytest.mark.slow
@pytest.mark.parametrize("noise", [0, 1e-3])
@pytest.mark.parametrize("name", ["article-6r", "ur5e", "irb120"])
def test_injected_mistakes(name, noise):
    right = dh.load(name)
    q = sweeps(right)
    p = right.forward(q)[:, :3, 3] + np.random.default_rng(1).normal(0, 1, (len(q), 3)) * noise
    fresh = np.random.default_rng(2).uniform(-2, 2, (10, 6))
    for what, wrong in injected(right).items():
        answer = diagnose_motion(wrong, q, p)
        assert answer.verdict == "explained", (what, answer.headline)
        (found,) = answer.findings
        assert np.allclose(
            found.repair.forward(fresh)[:, :3, 3],
            right.forward(fresh)[:, :3, 3],
            atol=1e-6 + 3 * noise,
        ), (what, found.detail)
        assert {
            "theta3": "row 3, theta",
            "d1": "d",
            "a2": "row 2, a",
            "alpha1": "row 1, alpha",
            "joint 2 reversed": "joint 2",
        }[what] in f"{found.place} {found.detail}"
    assert diagnose_motion(right, q, p).verdict == "agrees"


@pytest.mark.slow
# what changes in the table -> what joint 2's circle shows; measured minus the table's is the other
# way round than in dh_facts (but for the height after theta1: that is the cosine of 10°, the same
# both ways)
@pytest.mark.parametrize(
    "wrong, said",
    [
        (lambda arm: changed(arm, 2, 2, 0.05), ["radius by -47.3"]),
        (lambda arm: changed(arm, 1, 3, -np.pi), ["180 ", "the other way round", "height by "]),
        (lambda arm: changed(arm, 4, 3, -np.pi), ["height by 124"]),
        (lambda arm: changed(arm, 1, 1, 0.1), ["shifted by 100"]),
        (lambda arm: changed(arm, 4, 1, -0.2), ["height by 200"]),
        (
            lambda arm: changed(arm, 1, 0, np.deg2rad(10)),
            ["10 ", "shifted by 28", "height by -2.46"],
        ),
        (lambda arm: changed(arm, 2, 0, np.deg2rad(10)), ["only the phase", "-10 "]),
        (lambda arm: changed(arm, 3, 0, np.deg2rad(10)), ["radius by -21"]),
        (lambda arm: reversed_joint(arm, 2), ["180 ", "the other way round"]),
    ],
)
def test_the_circle_of_joint_2_as_in_dh_facts(wrong, said):
    arm = dh.load("article-6r")
    q = sweeps(arm, [2])
    words = words_of(diagnose_motion(wrong(arm), q, arm.forward(q)), 2)
    assert all(part in words for part in said), words


def test_a_harmless_slide_agrees():
    arm = dh.load("article-6r")
    q = sweeps(arm)
    assert (
        diagnose_motion(changed(changed(arm, 4, 1, -0.1), 2, 1, 0.1), q, arm.forward(q)).verdict
        == "agrees"
    )


def test_it_says_what_motion_cannot_show():
    arm = dh.load("article-6r")
    q = sweeps(arm, [1, 2, 6])
    answer = diagnose_motion(arm, q, arm.forward(q))
    assert (
        "proves nothing" in answer.notes[-1]
        and "lies on the axis" in words_of(answer, 6)
        and any("Not moved alone: joint 3, 4, 5" in note for note in answer.notes)
    )


def test_the_accused_row():
    arm = dh.load("irb120")
    q = sweeps(arm)
    answer = diagnose_motion(changed(arm, 3, 2, 0.03), q, arm.forward(q)[:, :3, 3])
    assert (
        "The axis of joint 3 is right, that of joint 4 is not: the mistake is in row 3"
        in answer.notes[0]
        and answer.findings[0].place == "row 3, a"
    )


def test_craig_rows_are_named_as_they_stand():
    arm = dh.load("panda")
    q = sweeps(arm, rest=np.array([0.3, 0.4, -0.7, -1.5, 0.9, 1.2, 0.4]))
    answer = diagnose_motion(changed(arm, 4, 2, 0.05), q, arm.forward(q))
    assert (
        answer.verdict == "explained"
        and answer.findings[0].place == "row 4, a"
        and "a or alpha of row 4" in answer.notes[0]
    )


@pytest.mark.parametrize("name", ["stanford", "cobra600"])
def test_sliding_joints(name):
    arm = dh.load(name)
    joint = arm.table.joints.index("P") + 1
    q = sweeps(arm, rest=np.array([0.3, 0.8, 0.3, 0.5, 0.9, 0.2]))
    right = diagnose_motion(arm, q, arm.forward(q))
    assert (
        right.verdict == "agrees"
        and "it slides" in words_of(right, joint)
        and "agrees with the model in direction and in length" in words_of(right, joint)
    )
    wrong = diagnose_motion(reversed_joint(arm, joint), q, arm.forward(q))
    assert (
        "slides the other way" in words_of(wrong, joint)
        and wrong.verdict == "explained"
        and f"joint {joint}" in wrong.findings[0].detail
    )


def test_a_calibrated_arm_is_no_mistake():
    right = dh.load("ur5e")
    rng = np.random.default_rng(4)
    rows = right.table.rows + rng.normal(0, 1, (6, 4)) * [
        np.deg2rad(0.05),
        5e-4,
        5e-4,
        np.deg2rad(0.05),
    ]
    q = sweeps(right)
    p = dh.Arm(dh.DHTable.standard(rows, angle="rad")).forward(q)[:, :3, 3] + rng.normal(
        0, 1e-4, (len(q), 3)
    )
    assert diagnose_motion(right, q, p).verdict == "calibrated"


def test_two_mistakes_are_not_called_one():
    arm = dh.load("irb120")
    q = sweeps(arm)
    answer = diagnose_motion(changed(changed(arm, 1, 1, 0.1), 3, 0, 0.3), q, arm.forward(q))
    assert answer.verdict == "unexplained" and not answer.findings and "row 1" in answer.notes[0]


def test_degrees_are_no_crash():
    arm = dh.load("ur5e")
    q = sweeps(arm)
    answer = diagnose_motion(arm, np.rad2deg(q), arm.forward(q))
    assert answer.verdict == "unexplained" and any("radians" in note for note in answer.notes)


@pytest.mark.parametrize(
    "arguments, words",
    [
        ((3, [[0] * 6], [[0, 0, 0]]), "expected an Arm"),
        ((dh.load("ur5e"), np.zeros((5, 5)), np.zeros((5, 3))), "joint values"),
        (
            (dh.load("ur5e"), np.random.default_rng(1).uniform(-1, 1, (8, 6)), np.zeros((8, 3))),
            "one joint alone",
        ),
        ((dh.load("ur5e"), np.zeros((5, 6)), np.full((5, 3), np.nan)), "finite"),
    ],
)
def test_bad_input_is_refused_in_one_sentence(arguments, words):
    with pytest.raises(ValueError, match=words) as caught:
        diagnose_motion(*arguments)
    assert "\n" not in str(caught.value)


@pytest.mark.slow
def test_the_command_line(tmp_path):
    arm = dh.load("article-6r")
    changed(arm, 2, 2, 0.05).save(tmp_path / "wrong.yaml")
    q = sweeps(arm)
    rows = np.column_stack([np.rad2deg(q), 1e3 * arm.forward(q)[:, :3, 3]])
    (tmp_path / "sweeps.csv").write_text(
        "q1,q2,q3,q4,q5,q6,x,y,z\n"
        + "\n".join(",".join(repr(float(v)) for v in row) for row in rows)
    )
    files = tmp_path / "wrong.yaml", tmp_path / "sweeps.csv"
    command = ["doctor", *files, "--motion", "--units", "mm,deg"]
    plain = dhlab(*command)
    assert plain.returncode == 0 and "row 2, a" in plain.stdout and "proves nothing" in plain.stdout
    answer = json.loads(dhlab(*command, "--json", "--noise", "0.1mm").stdout)
    assert answer["verdict"] == "explained" and answer["findings"][0]["parameter"] == "a"
