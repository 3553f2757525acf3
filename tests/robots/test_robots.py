"""The library: every table complete, every check pose given."""

import numpy as np
import pytest
from oracles import elementary_pose

import dhlab as dh
from dhlab.robots import entry

ALL = [f"{key}.{table}" for key in dh.robots() for table in entry(key).tables]
NINETEEN = {
    "ur5e",
    "ur3e",
    "ur10e",
    "ur5_cb",
    "ur10_cb",
    "puma560",
    "panda",
    "iiwa14",
    "iiwa7",
    "kr6_r700",
    "irb120",
    "stanford",
    "cobra600",
    "ar4",
    "piper",
    "xarm6",
    "jaco6",
    "article-6r",
    "article-6r-wrist",
}


def test_the_nineteen_arms():
    assert set(dh.robots()) == NINETEEN


@pytest.mark.parametrize("name", ALL)
def test_every_table_gives_its_check_poses(name):
    key, table = name.split(".")
    arm, checks = dh.load(name), entry(key).checks[table]
    assert arm.source and arm.name and checks
    assert any(not np.isin(check.q, 0).all() for check in checks), (
        "a check pose at q = 0 alone proves little"
    )
    for check in checks:
        T = arm.forward(check.q)
        assert np.allclose(T[:3, 3], check.xyz, atol=1e-6), check.source
        assert check.R is None or np.allclose(T[:3, :3], check.R, atol=2e-9), check.source
        assert np.allclose(
            T, arm.base @ elementary_pose(arm.table, check.q, arm.sign) @ arm.tool, atol=1e-12
        )


def test_the_best_table_comes_first():
    for key, table in (
        ("piper", "sdk_new"),
        ("ar4", "mk3_lateral_mod"),
        ("ur5e", "maker"),
        ("panda", "maker_mod"),
        ("puma560", "corke_std"),
    ):
        assert dh.load(key).table == dh.load(f"{key}.{table}").table


def test_limits_are_stated_and_never_enforced():
    panda = dh.load("panda")
    assert np.allclose(np.rad2deg(panda.limits[3]), (-176.001, -3.999))
    assert not panda.within_limits([0] * 7)[3] and np.isfinite(panda.forward([0] * 7)).all()
    assert dh.load("stanford").limits[2] == (0.3048, 1.27)
    assert dh.load("ur3e").limits[5] is None


@pytest.mark.parametrize(
    "name, words",
    [
        ("ur5", "did you mean ur5e|did you mean ur5_cb"),
        ("ur5e.makr", "found 'makr'"),
        ("", "the arms are"),
        ("no.yaml", "no such file"),
        (3, "the arms are"),
        ("../ur5e", "found no"),
    ],
)
def test_an_unknown_name_is_one_plain_sentence(name, words):
    with pytest.raises(ValueError, match=words):
        dh.load(name)
