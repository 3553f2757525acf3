"""Why there is no solution, and what comes nearest."""

import numpy as np
import pytest
from draws import few
from oracles import exponential_pose, pose_errors

import dhlab as dh
from dhlab.inverse.reach import elbow_arm
from dhlab.transform import from_xyz_rpy, rot_x, trans


def planar():
    rows = [[0, 0, 0.4, 0], [0, 0, 0.3, 0], [0, 0, 0.1, 0]]
    return dh.Arm(dh.DHTable.standard(rows, angle="deg"), name="planar")


@pytest.mark.parametrize("gap", [1e-6, 1e-3, 0.3])
def test_out_of_reach_and_by_how_much(gap):
    arm = planar()
    answer = arm.solve(trans([0.8 + gap, 0, 0]))
    assert not answer and len(answer) == 0 and answer.reason.kind == "reach"
    assert np.isclose(answer.reason.metres, gap, rtol=1e-3)
    assert np.isclose(answer.nearest.metres, gap, rtol=1e-3) and answer.nearest.radians < 1e-2
    assert np.allclose(arm.forward(answer.nearest.q), answer.nearest.pose)


def test_a_hole_in_the_middle():
    rows = [[0, 0, 0.5, 0], [0, 0, 0.3, 0]]
    arm = dh.Arm(dh.DHTable.standard(rows, angle="deg"))
    answer = arm.solve(trans([0.15, 0, 0]))
    assert answer.reason.kind == "reach" and np.isclose(answer.reason.metres, 0.05, rtol=1e-6)


def test_an_orientation_that_is_impossible():
    arm = dh.load("cobra600")
    answer = arm.solve(arm.forward([0.1, 0.2, 0.1, 0.3]) @ rot_x(0.1))
    assert answer.reason.kind == "orientation" and "4 joints" in answer.reason.sentence
    assert np.isclose(answer.reason.radians, 0.1, rtol=1e-6)
    assert np.isclose(answer.nearest.radians, 0.1, rtol=1e-2) and answer.nearest.metres < 1e-3


@pytest.mark.parametrize("short", [1e-4, 5e-3, 0.2])
def test_the_wrist_centre_says_it_exactly(short):
    """Corke's Puma stretched: upper arm 0.4318 m, forearm √(0.0203² + 0.4318²) m."""
    arm = dh.load("puma560")
    for q3 in np.pi / 2 + np.arctan2(0.0203, 0.4318) + np.array([0, np.pi]):
        T = arm.forward([0.4, 0.3, q3, 0.5, 0.6, 0.7])
        shoulder, z = arm.frames([0.4, 0.3, q3, 0.5, 0.6, 0.7])[1, :3, [3, 2]]
        out = T[:3, 3] - shoulder
        out -= z * (z @ out)
        if np.linalg.norm(out) > 0.5:
            break
    longest = 0.4318 + np.hypot(0.0203, 0.4318)
    assert np.isclose(np.linalg.norm(out), longest)
    answer = arm.solve(trans(short * out / longest) @ T)
    assert not answer and answer.reason.certain
    assert np.isclose(answer.reason.short, short, rtol=1e-9)
    assert "Exactly" in answer.reason.sentence


ELBOWS = ["puma560", "irb120", "kr6_r700", "ar4", "article-6r-wrist"]


@pytest.mark.parametrize("name", few(ELBOWS, 3))
def test_the_exact_reach_agrees_with_what_can_be_solved(judge, name):
    judge("ssik")
    arm, rng = dh.load(name), np.random.default_rng(1)
    elbow, met = elbow_arm(arm), set()
    for _ in range(30):
        T = from_xyz_rpy(rng.uniform(-0.8, 0.8, 3), rng.uniform(-3, 3, 3))
        short, words = elbow.shortfall(T)
        assert bool(arm.solve(T, method="closed form")) == (short == 0) == (words == "")
        met.add(short == 0)
    assert met == {True, False}


def test_a_limit_in_the_way():
    rows = [[0, 0, 0.4, 0], [0, 0, 0.3, 0]]
    limits = np.deg2rad([[-180, 180], [-50, 50]])
    arm = dh.Arm(dh.DHTable.standard(rows, angle="deg"), limits=limits, name="two links")
    T = arm.forward(np.deg2rad([10, 60]))
    assert arm.solve(T)
    answer = arm.solve(T, limits=True)
    assert not answer and answer.reason.kind == "limits"
    assert np.isclose(np.rad2deg(answer.reason.radians), 10)
    assert "joint 2 at 60° (limit 50°)" in answer.reason.sentence
    assert arm.within_limits(answer.nearest.q).all() and len(answer.outside) == 1


def test_another_value_of_the_redundancy_would_do():
    arm = dh.load("panda")
    T = arm.forward([0.1, 0.7, 0.3, -0.4, 0.5, 1.6, 0.7])
    answer = arm.solve(T, redundancy=0.9)
    assert not answer and answer.reason.kind == "redundancy"
    assert np.abs(arm.forward(answer.nearest.q) - T).max() < 1e-8


def test_far_away_is_never_called_solved():
    rng = np.random.default_rng(2)
    for name in ("ur5e", "panda", "xarm6", "jaco6"):
        arm = dh.load(name)
        table = arm.table
        longest = np.hypot(table.a, table.d).sum() + np.linalg.norm(arm.tool[:3, 3])
        way = rng.normal(size=3)
        T = trans(arm.base[:3, 3] + 1.01 * longest * way / np.linalg.norm(way))
        answer = arm.solve(T)
        assert not answer and answer.reason.kind == "reach"
        assert answer.reason.metres > 0.0099 * longest


def test_a_ur_cannot_bring_its_wrist_to_its_first_axis():
    arm = dh.load("ur5e")
    d = arm.table.d
    level = trans([0, -(d[3] - 0.005) - d[5], 0.4]) @ rot_x(np.pi / 2)
    answer = arm.solve(level)
    assert not answer and answer.reason.kind == "orientation" and not answer.reason.certain
    near = answer.nearest
    judged = arm.base @ exponential_pose(arm.table, arm.sign * near.q) @ arm.tool
    metres, radians = pose_errors(judged, level)
    assert np.isclose(metres, near.metres) and np.isclose(radians, near.radians)


def test_the_reason_is_put_into_words():
    answer = planar().solve(trans([1.0, 0, 0]))
    text = repr(answer)
    assert "no solution" in text and "200 mm" in text and "nearest pose" in text
    told = answer.to_dict()
    assert told["solved"] is False and told["reason"]["kind"] == "reach" and told["nearest"]["q"]
    assert "<p>" in answer._repr_html_()


def test_the_elbow_is_found_whatever_the_base_and_tool():
    arm = dh.load("kr6_r700")
    moved = dh.Arm(
        arm.table, base=from_xyz_rpy([1, 2, 3], [0.3, 0.2, 0.1]), tool=trans([0, 0.1, 0.2])
    )
    elbow, again = elbow_arm(arm), elbow_arm(moved)
    for part in ("forward", "aside", "upper", "fore"):
        assert np.isclose(getattr(elbow, part), getattr(again, part))
    assert again.shortfall(moved.forward([0.1, -1, 1, 0.4, 0.5, 0.6])) == (0.0, "")
