"""Mistakes of joint variables, made without the functions that the doctor knows them by."""

import numpy as np
import pytest

import dhlab as dh
from dhlab.doctor import diagnose

MIRROR = np.diag([1.0, -1, 1, 1])  # in the plane of x and z


@pytest.mark.parametrize("name", ["article-6r", "ur5e", "panda", "stanford"])
def test_the_table_of_the_other_hand(name):
    """The poses of the mirrored arm, by mirroring poses; no table is touched."""
    arm, rng = dh.load(name), np.random.default_rng(1)
    q, fresh = np.abs(rng.uniform(-2, 2, (2, 10, len(arm)))) * np.where(arm.table.prismatic, 0.2, 1)
    answer = diagnose(arm, q, MIRROR @ arm.forward(q) @ MIRROR)
    (finding,) = answer.findings
    assert answer.verdict == "explained" and finding.mistake == "other-hand"
    np.testing.assert_allclose(
        finding.repair.forward(fresh), MIRROR @ arm.forward(fresh) @ MIRROR, atol=1e-9
    )
