"""Two arms side by side: what is the same is told alike, what was changed by its amount."""

import numpy as np
import pytest
from draws import few

import dhlab as dh
from dhlab.geometry.zeros import with_zeros
from dhlab.transform import from_xyz_rpy

ARMS = few(dh.robots(), 6)


@pytest.fixture
def rng():
    return np.random.default_rng(7)


def redescribed(arm, rng):
    """The same arm in another right table."""
    other = arm.to("craig" if arm.table.convention == "standard" else "standard")
    for i in rng.integers(0, len(arm) + 1, 3):
        other = other.flip_x(int(i)).flip_z(int(i))
    return other


@pytest.mark.parametrize("name", ARMS)
def test_another_right_table_shows_no_difference(name, rng):
    arm = dh.load(name)
    found = dh.compare(arm, redescribed(arm, rng))
    assert found and found.kind == "same"
    assert all(joint.counts_alike and not joint.lengths() for joint in found.joints)
    assert found.base.same and found.tool.same and max(found.apart) < 1e-9


@pytest.mark.parametrize("name", ARMS)
def test_signs_and_zeros_that_are_told_are_those_of_the_motion(name, rng):
    """By the arms' own poses: b at q stands where a stands at sense · q + zero, up to base and
    tool."""
    arm = dh.load(name)
    sign = rng.choice([1, -1], len(arm))
    zero = np.where(arm.table.prismatic, 0.02, rng.choice([0, np.pi / 2, 0.3, np.pi], len(arm)))
    base, tool = from_xyz_rpy([1, 2, 3], [0.1, 0.2, 0.3]), from_xyz_rpy([0, 0.1, 0], [1, 0, 0])
    other = redescribed(with_zeros(arm, sign, zero), rng)
    other = dh.Arm(other.table, base @ other.base, other.tool @ tool, sign=other.sign)
    found = dh.compare(arm, other)
    assert found.kind in ("zeros", "ends") and not found.base.same
    assert max(found.apart_matched) < 1e-9
    senses, zeros = (
        np.array([getattr(j, what) for j in found.joints]) for what in ("sense", "zero")
    )
    q = rng.uniform(-2, 2, (5, len(arm)))
    here, there = arm.forward(senses * q + zeros), other.forward(q)
    between = np.linalg.inv(here[1:]) @ here[:-1]  # free of the base; the tool is left
    same = np.linalg.inv(there[1:]) @ there[:-1]
    np.testing.assert_allclose(
        np.trace(between[:, :3, :3], axis1=1, axis2=2), np.trace(same[:, :3, :3], axis1=1, axis2=2)
    )


@pytest.mark.parametrize("name", ARMS)
def test_a_length_that_was_changed_is_told_by_its_amount(name, rng):
    arm = dh.load(name)
    rows = arm.table.rows
    turning = "RR" if arm.table.convention == "standard" else "RRR"  # a sliding axis has no place
    i = next(i for i in range(1, len(arm)) if arm.table.joints[i - 1 : i + 2].startswith(turning))
    shift = 0.003 if rows[i, 2] >= 0 else -0.003  # never through 0, where x would turn round
    rows[i, 2] += shift
    longer = dh.DHTable(arm.table.convention, *rows.T, arm.table.joints)
    found = dh.compare(arm, dh.Arm(longer, arm.base, arm.tool, sign=arm.sign))
    told = {(j.joint, what): gap for j in found.joints for what, gap in j.lengths().items()}
    assert found.kind == "lengths"
    joint = i + 1 if arm.table.convention == "standard" else i
    assert {key for key in told if key[1] == "a"} == {(joint, "a")}
    assert abs(abs(told[joint, "a"]) - 0.003) < 1e-9


def test_nearly_parallel_axes_are_told_in_small_numbers():
    """A UR as its maker calibrated it: the common normals of its axes 2 to 4 run away."""
    right = dh.load("ur5e")
    axes = [list(axis) for axis in _axes(right)]
    axes[2][1] = axes[2][1] + np.array([0.001, 0, 0.0002])
    with pytest.warns(dh.NearlyParallelWarning):
        calibrated = dh.assign_frames(axes, end=right.forward([0] * 6))
    assert np.abs(calibrated.table.d).max() > 50
    found = dh.compare(right, calibrated)
    assert max(abs(gap) for joint in found.joints for gap in joint.lengths().values()) < 0.01
    assert any(joint.beta for joint in found.joints)
    assert "Hayati" in str(found)


def _axes(arm):
    frames = arm.frames([0] * len(arm))
    return [(frame[:3, 3], frame[:3, 2]) for frame in frames[:-1]]


def test_arms_that_cannot_be_compared_are_told_in_a_sentence():
    found = dh.compare(dh.load("ur5e"), dh.load("panda"))
    assert found.kind == "joints" and not found.joints
    assert str(found) == "Table a has 6 joints, table b 7 joints."
    with pytest.raises(ValueError, match="^compare: expected an Arm or a DHTable, found str"):
        dh.compare("ur5e", "panda")


def test_axes_parallel_in_one_arm_and_across_in_the_other_are_told():
    rows = [[0, 0.1, 0, 0], [0, 0, 0.4, 90], [0, 0.1, 0.2, 0]]
    a = dh.Arm(dh.DHTable.standard(rows, angle="deg"))
    for alpha, length in ((90, 0), (90, 0.05), (-90, 0.05)):
        rows[0][2:] = length, alpha
        found = dh.compare(a, dh.Arm(dh.DHTable.standard(rows, angle="deg")))
        assert not found and "alpha1" in str(found)
