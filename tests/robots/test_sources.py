"""Every arm against what it is made of, by the chains in tests/data and scipy; its table in the
other convention, and made anew from its axes.
"""

import pathlib
import sys
import warnings

import numpy as np
import pytest
from draws import few
from oracles import elementary_pose

import dhlab as dh
from dhlab.geometry.canonical import joint_axes
from dhlab.geometry.procedure.frames import NearlyParallelWarning
from dhlab.robots import entry
from dhlab.robots.entries import FOLDER

sys.path.insert(0, str(pathlib.Path(__file__).parents[2] / "benchmarks"))
from arm_files import sources, text_of
from arms import compared

MADE = [key for key, said in sources().items() if said.get("made", True)]
# by their text: to read all entries costs every worker of the tests seconds
COUPLED = [key for key in MADE if "controller:" in (FOLDER / f"{key}.yaml").read_text("utf-8")]
FEW = few(dh.robots(), 24)


@pytest.mark.parametrize("key", few(sources(), 12))
def test_the_sources_agree_with_the_arm(key):
    """The URDF that a table is from within what its rounded angles make, others within 1 mm."""
    for name, _, found in compared(key, 10):
        assert found is not None, name
        distance, angle, fitted = found
        assert distance < (1.5 if fitted else 0.6) and angle < 0.1, (name, found)


@pytest.mark.parametrize("key", few(MADE, 8))
def test_the_file_is_what_its_sources_make(key):
    assert (FOLDER / f"{key}.yaml").read_text("utf-8") == text_of(key)


@pytest.mark.parametrize("key", COUPLED[:4])
def test_a_controllers_joint_3_is_coupled_as_two_publishers_say(key):
    ours, theirs = (entry(key).tables[name] for name in ("controller", "catalogue"))
    q = np.random.default_rng(0).uniform(-1.5, 1.5, (20, 6))
    judged = np.array([elementary_pose(theirs.table, row) for row in theirs.joint_values(q)])
    model = ours.forward(q)
    apart = np.linalg.inv(model) @ judged  # the tool
    assert np.ptp(apart[:, :3, :3], axis=0).max() < 1e-12
    level = ours.forward(q * [1, 0, 1, 1, 1, 1])  # joint 2 does not turn the hand
    assert np.abs(level[:, :3, :3] - model[:, :3, :3]).max() < 1e-12


@pytest.mark.parametrize("key", FEW)
def test_an_arm_of_the_same_axes_is_the_same_arm(key):
    arm = dh.load(key)
    axes = joint_axes(arm)
    lines = list(zip(axes.p, axes.z, axes.letters))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", NearlyParallelWarning)
        anew = dh.assign_frames(lines, end=axes.end)
    assert dh.equivalent(arm, anew)
    assert dh.equivalent(arm, arm.to("craig").to("standard"))
