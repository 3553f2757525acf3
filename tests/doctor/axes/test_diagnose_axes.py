"""Which axis of a sheet is wrong: mistakes made in the sheet, poses made by SciPy's rotations."""

import numpy as np
import pytest
from draws import few
from scipy.spatial.transform import Rotation

import dhlab as dh

SHEET = [  # waist, shoulder, elbow, pitch, roll
    ([0, 0, 0.2], [0, 0, 1]),
    ([0.05, 0, 0.4], [0, 1, 0]),
    ([0.05, 0, 0.8], [0, 1, 0]),
    ([0.45, 0, 0.8], [0, 1, 0]),
    ([0.5, 0, 0.8], [1, 0, 0]),
]
END = dh.transform.from_xyz_rpy([0.6, 0, 0.8], [0, np.pi / 2, 0])
Q = np.random.default_rng(11).uniform(-2, 2, (8, 5))


def measured(sheet, end=END, q=Q, noise=None):
    poses = []
    for values in q:
        T = end
        for (p, z), value in reversed(list(zip(sheet, values))):
            motion = np.eye(4)
            motion[:3, :3] = Rotation.from_rotvec(value * np.array(z)).as_matrix()
            motion[:3, 3] = p - motion[:3, :3] @ p
            T = motion @ T
        poses.append(T)
    T = np.array(poses)
    if noise:
        rng = np.random.default_rng(12)
        T[:, :3, 3] += rng.normal(0, noise[0], (len(q), 3))
        turns = Rotation.from_rotvec(rng.normal(0, noise[1], (len(q), 3))).as_matrix()
        T[:, :3, :3] = T[:, :3, :3] @ turns
    return T


def test_a_right_sheet_agrees():
    assert dh.diagnose_axes(SHEET, END, Q, measured(SHEET)).verdict == "agrees"
    noise = (1e-3, 3e-3)
    answer = dh.diagnose_axes(SHEET, END, Q, measured(SHEET, noise=noise), noise=noise)
    assert answer.verdict == "agrees" and not answer.findings


@pytest.mark.parametrize("joint", few(range(5), 2))
@pytest.mark.parametrize("kind", ["point", "direction", "sense"])
def test_the_axis_is_named_and_by_how_much(joint, kind):
    wrong = [[np.array(p, float), np.array(z, float)] for p, z in SHEET]
    p, z = wrong[joint]
    side = np.eye(3)[(np.argmax(z) + 1) % 3]
    if kind == "point":
        wrong[joint][0] = p + 0.01 * side
    elif kind == "direction":
        wrong[joint][1] = Rotation.from_rotvec(np.deg2rad(3) * side).apply(z)
    else:
        wrong[joint][1] = -z
    noise = (5e-4, 1e-3)
    answer = dh.diagnose_axes(wrong, END, Q, measured(SHEET, noise=noise), noise=noise)
    finding = answer.findings[0]
    assert (answer.verdict, finding.joint, finding.parameter) == ("explained", joint + 1, kind)
    found_p, found_z, _ = answer.sheet.axes[joint]
    assert np.arccos(np.clip(found_z @ z, -1, 1)) < np.deg2rad(0.3)
    off = found_p - p
    assert np.linalg.norm(off - z * (off @ z)) < 1.5e-3
    words = {"point": "mm away along -", "direction": "° off: ", "sense": "its sense is turned"}
    assert words[kind] in finding.detail


def test_the_zero_pose_and_the_end_are_named():
    shifted = Q + [0, 0, np.pi / 2, 0, 0]
    answer = dh.diagnose_axes(SHEET, END, Q, measured(SHEET, q=shifted))
    assert (answer.findings[0].mistake, answer.findings[0].joint) == ("axis-zero", 3)
    assert answer.findings[0].detail == "the sheet shows the joint at 90°, not at 0"
    q = np.random.default_rng(5).uniform(-2, 2, (4, 5))
    np.testing.assert_allclose(
        answer.findings[0].repair.forward(q),
        measured(SHEET, q=q + [0, 0, np.pi / 2, 0, 0]),
        atol=1e-5,
    )
    answer = dh.diagnose_axes(SHEET, END @ dh.transform.trans([0, 0, 0.1]), Q, measured(SHEET))
    assert answer.findings[0].mistake == "axis-end" and "100 mm" in answer.findings[0].detail


@pytest.mark.slow
def test_two_wrong_axes_are_both_told():
    wrong = [list(axis) for axis in SHEET]
    wrong[1] = ([0.05, 0, 0.42], [0, 1, 0])
    wrong[4] = ([0.5, 0, 0.8], [-1, 0, 0])
    answer = dh.diagnose_axes(wrong, END, Q, measured(SHEET), noise=(1e-4, 1e-4), budget=60)
    assert answer.verdict == "explained" and "axis 2 and axis 5" in answer.headline
    assert [(f.joint, f.parameter) for f in answer.findings] == [(2, "point"), (5, "sense")]
    assert "along -z" in answer.findings[0].detail
    assert np.allclose(answer.sheet.axes[1][0][2], SHEET[1][0][2], atol=1e-3)


def test_what_is_no_sheet_is_said_in_a_sentence():
    with pytest.raises(ValueError, match=r"^diagnose_axes: joint 2: direction: expected a vector"):
        dh.diagnose_axes([SHEET[0], ([0, 0, 0], [0, 0, 0])], END, Q[:, :2], measured(SHEET))


def test_one_position_explains_nothing():
    """Three numbers, and some sixty ways to be wrong: what fits is listed, nothing is claimed."""
    wrong = [list(axis) for axis in SHEET]
    wrong[2] = ([0.05, 0, 0.83], [0, 1, 0])
    points = measured(SHEET)[:1, :3, 3]
    answer = dh.diagnose_axes(wrong, END, Q[:1], points, noise=1e-3)
    assert answer.verdict == "undecided" and not answer.findings
    assert len(answer.fits) > 1 and answer.next_pose is not None
    assert "cannot tell which axis" in answer.headline


def test_a_shift_of_three_sigma_is_not_called_right():
    wrong = [list(axis) for axis in SHEET]
    wrong[1] = ([0.05, 0, 0.4035], [0, 1, 0])
    noise = (1e-3, 3e-3)
    answer = dh.diagnose_axes(wrong, END, Q, measured(SHEET, noise=noise), noise=noise)
    assert answer.verdict == "explained" and answer.findings[0].joint == 2
