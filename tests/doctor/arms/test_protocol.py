"""The tape-measure protocol: which poses, and that the doctor can work with what is measured
there.
"""

import json
from functools import cache

import numpy as np
import pytest
from terminal import dhlab

import dhlab as dh
from dhlab.doctor import diagnose
from dhlab.doctor.arms.protocol import protocol
from dhlab.doctor.mistakes.faults import faults
from dhlab.formats.posefile import read_poses
from dhlab.transform import rot_x, trans


@cache
def planned(name):
    """The protocol of an arm of the library, worked out once for all tests."""
    return protocol(dh.load(name))


@pytest.mark.slow
@pytest.mark.parametrize("name", ["article-6r", "panda", "stanford", "cobra600"])
def test_the_poses_are_drivable(name):
    arm = dh.load(name)
    plan = protocol(arm)
    turns = np.rad2deg(plan.q[:, ~arm.table.prismatic])
    assert (
        plan.q.shape == (8, len(arm))
        and len(np.unique(plan.q, axis=0)) == 8
        and arm.within_limits(plan.q).all()
    )
    assert (
        np.allclose(turns, 5 * np.round(turns / 5))
        and (np.abs(turns - 90 * np.round(turns / 90)) > 4).all()
    )
    assert plan.above and (arm.forward(plan.q)[:, 2, 3] > 0).all()
    slides = plan.q[:, arm.table.prismatic]
    assert np.allclose(slides, np.round(slides, 2)) and (slides != 0).all()


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ur5e", "irb120"])
def test_what_the_poses_show(name):
    """Every mistake that moves the point by 5 cm somewhere moves it by what is promised at one of
    the poses.
    """
    arm, plan = dh.load(name), planned(name)
    anywhere = np.random.default_rng(1).uniform(-2, 2, (50, 6))
    for fault in faults(arm):
        far = np.linalg.norm(
            (fault.arm.forward(anywhere) - arm.forward(anywhere))[:, :3, 3], axis=1
        ).max()
        here = np.linalg.norm(
            (fault.arm.forward(plan.q) - arm.forward(plan.q))[:, :3, 3], axis=1
        ).max()
        assert far < 0.05 or here > 0.02, (fault.mistake, fault.joint, far, here)


def test_a_point_on_the_last_axis_is_said_and_a_pointer_helps():
    arm, plan = dh.load("ur5e"), planned("ur5e")
    assert (
        plan.still == (6,)
        and plan.hidden == ("theta6", "alpha6")
        and "axis of joint 6" in plan.text
        and "pointer" in plan.text
    )
    with_pointer = protocol(
        dh.Arm(arm.table, arm.base, trans([0.1, 0, 0.05]), arm.limits, arm.sign)
    )
    assert (
        with_pointer.still == ()
        and with_pointer.hidden == ()
        and "pointer" not in with_pointer.text
    )


def test_the_sheet_is_read_back_and_leads_to_the_mistake(tmp_path):
    right = dh.load("irb120")
    rows = right.table.rows
    rows[1, 2] += 0.1
    wrong = dh.Arm(
        dh.DHTable.standard(rows, angle="rad"),
        limits=right.limits,
        sign=right.sign,
        base=right.base,
        tool=right.tool,
    )
    plan = protocol(wrong)
    about, header, *lines = plan.to_csv().splitlines()
    p = 1e3 * (right.forward(plan.q)[:, :3, 3] + np.random.default_rng(2).normal(0, 4e-3, (8, 3)))
    filled = [line[:-3] + "," + ",".join(f"{v:.0f}" for v in row) for line, row in zip(lines, p)]
    (tmp_path / "sheet.csv").write_text("\n".join([about, header, *filled]) + "\n")
    q, points = read_poses(tmp_path / "sheet.csv", 6, "mm", "deg")
    assert np.allclose(q, plan.q, atol=1e-12)
    answer = diagnose(wrong, q, points, noise=4e-3)
    assert (
        answer.verdict == "explained"
        and abs(answer.findings[0].repair.table.a[1] - right.table.a[1]) < 0.015
    )
    assert diagnose(right, q, points, noise=4e-3).verdict == "agrees"


@pytest.mark.slow
def test_odd_arms():
    lying = dh.Arm(dh.load("ur5e").table, base=rot_x(np.pi / 2))
    assert protocol(lying, 6).q.shape == (6, 6)
    narrow = dh.Arm(dh.load("article-6r").table, limits=[(-0.05, 0.05)] * 6)
    assert narrow.within_limits(protocol(narrow).q).all()
    planar = dh.DHTable.standard([[0, 0, 0.4, 0], [0, 0, 0.3, 0]], angle="deg")
    assert protocol(planar, 3).q.shape == (3, 2)


def test_the_same_poses_every_time_and_plain_values():
    plan = protocol(dh.load("ur5e"))
    assert np.array_equal(plan.q, planned("ur5e").q) and json.loads(json.dumps(plan.to_dict()))[
        "hidden"
    ] == ["theta6", "alpha6"]


@pytest.mark.parametrize(
    "arguments, words",
    [
        ((3,), "expected an Arm"),
        ((dh.load("ur5e"), 2), "3 to 40"),
        ((dh.load("ur5e"), 8.0), "whole number"),
        ((dh.load("ur5e"), True), "whole number"),
    ],
)
def test_what_cannot_be_is_refused(arguments, words):
    with pytest.raises(ValueError, match=words):
        protocol(*arguments)


@pytest.mark.slow
def test_the_command_line(tmp_path):
    def doctor(*arguments):
        return dhlab("doctor", *arguments)

    sheet = str(tmp_path / "sheet.csv")
    answer = doctor("ur5e", "--protocol", "--sheet", sheet)
    assert (
        answer.returncode == 0
        and "8 poses" in answer.stdout
        and (tmp_path / "sheet.csv").read_text().count("\n") == 10
    )
    assert len(json.loads(doctor("ur5e", "--protocol", "--json").stdout)["q"]) == 8
    unfilled = doctor("ur5e", sheet, "--units", "mm,deg")
    assert unfilled.returncode == 2 and "empty cell" in unfilled.stderr
