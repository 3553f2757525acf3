"""``dhlab ik`` as a user types it, and what a plain ``import dhlab`` costs."""

import json
import subprocess
import sys

import numpy as np
import pytest
from terminal import dhlab

import dhlab as dh
from dhlab.transform import from_xyz_rpy

POSE = ["--pose", "400,100,300,180,0,0", "--units", "mm,deg"]


def run(*arguments):
    return dhlab("ik", *arguments)


def test_every_solution_reaches_the_pose_that_was_typed():
    done = run("puma560", *POSE, "--json")
    answer, arm = json.loads(done.stdout), dh.load("puma560")
    T = from_xyz_rpy([0.4, 0.1, 0.3], [np.pi, 0, 0])
    assert done.returncode == 0
    assert answer["solved"] is True
    assert len(answer["q"]) == 8
    assert np.allclose(arm.forward(answer["q"]), T, atol=1e-9)
    same = json.loads(
        run("puma560", "--pose", f"0.4 0.1 0.3 {np.pi} 0 0", "--units", "m,rad", "--json").stdout
    )
    assert np.allclose(same["q"], answer["q"])


def test_limits_near_and_redundancy():
    done = run("panda", *POSE, "--limits", "--redundancy", "7=10", "--json")
    q = np.array(json.loads(done.stdout)["q"])
    assert dh.load("panda").within_limits(q).all()
    assert np.allclose(q[:, 6], np.deg2rad(10))
    near = np.rad2deg(q[0]) + 1
    done = run("panda", *POSE, "--near", ",".join(map(str, near)), "--json")
    assert np.abs(np.array(json.loads(done.stdout)["q"])[0] - np.deg2rad(near)).max() < 0.2


def test_out_of_reach_is_said_and_the_exit_status_is_1():
    done = run("ur5e", "--pose", "2000,0,0,0,0,0", "--units", "mm,deg")
    assert done.returncode == 1
    assert "Out of reach" in done.stdout
    assert "nearest pose" in done.stdout
    assert done.stderr == ""


def test_nothing_to_prepare_is_said():
    done = run("stanford", "--prepare")
    assert done.returncode == 0
    assert "nothing to prepare" in done.stderr


@pytest.mark.parametrize(
    "arguments, words",
    [
        (["ur5e"], "expected --pose"),
        (["ur5e", *POSE[:2]], "expected the units"),
        (["ur5e", *POSE[:2], "--units", "mm"], "unit of length and one of angle"),
        (["ur5e", "--pose", "1,2,3", *POSE[2:]], "--pose: expected 6 numbers"),
        (["ur5e", *POSE, "--near", "1,2"], "--near: expected 6 numbers"),
        (["panda", *POSE, "--redundancy", "7"], "such as 3=20"),
        (["panda", *POSE, "--redundancy", "9=1"], "joints from 1 to 7"),
        (["ur5", *POSE], "did you mean"),
    ],
)
def test_mistakes_are_one_sentence(arguments, words):
    done = run(*arguments)
    assert done.returncode == 2
    assert words in done.stderr
    assert done.stderr.count("\n") == 1


def test_import_dhlab_stays_light():
    heavy = (
        "import sys, dhlab; dhlab.load('ur5e');"
        " print([m for m in ('ssik', 'dhlab.inverse') if m in sys.modules])"
    )
    done = subprocess.run([sys.executable, "-c", heavy], capture_output=True, text=True)
    assert done.stdout.strip() == "[]"
