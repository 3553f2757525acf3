"""Each room is loaded when it is asked for, and nothing large is computed before."""

import subprocess
import sys

POSES = """
import sys
import numpy as np
import dhlab as dh

arm = dh.load("article-6r")
q = np.random.default_rng(1).uniform(-2, 2, (6, 6))
assert dh.diagnose(arm, q, arm.forward(q)).verdict == "agrees"
print(*[name for name in sys.modules if name.startswith("dhlab.doctor.")])
"""
PROGRAMS = """
from dhlab.doctor.programs.explain import WRONG_VERSIONS

print(*[kind for kind, versions in WRONG_VERSIONS.items() if "_kept" in vars(versions)])
assert len(WRONG_VERSIONS["rot_x"]) > 10 and "_kept" in vars(WRONG_VERSIONS["rot_x"])
"""


def said_by(program):
    run = [sys.executable, "-c", program]
    return subprocess.run(run, capture_output=True, text=True, check=True).stdout.split()


def test_an_arm_is_diagnosed_without_the_programs():
    loaded = said_by(POSES)
    assert "dhlab.doctor.mistakes.faults" in loaded and "dhlab.doctor.arms.poses" in loaded
    assert not any(
        name.startswith(("dhlab.doctor.programs", "dhlab.doctor.tables")) for name in loaded
    )


def test_wrong_versions_are_made_when_they_are_first_looked_at():
    assert said_by(PROGRAMS) == []
