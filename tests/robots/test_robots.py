"""The library: every table complete, every check pose given."""

import numpy as np
import pytest
from draws import few
from oracles import elementary_pose

import dhlab as dh
from dhlab.robots import entry, search

FEW = few(dh.robots(), 24)
TABLES = [f"{key}.{table}" for key in FEW for table in entry(key).tables]


def test_the_arms_that_people_ask_for_are_there():
    asked = (
        "gen3 gen3_lite jaco2 mycobot_280 so101 xarm7 kr210_r2700 lrmate200id m1013 tm5_900 ur20"
        " fr3 irb2400 gp7 tx2_60 cr5 aubo_i5 lwr4 ned puma560 panda iiwa14 article-6r"
    )
    assert set(asked.split()) <= set(dh.robots())
    assert len(dh.robots()) >= 60


@pytest.mark.parametrize("name", TABLES)
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
            T,
            arm.base @ elementary_pose(arm.table, arm.joint_values(check.q)) @ arm.tool,
            atol=1e-12,
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
        ("", "dhlab robots lists"),
        ("no.yaml", "no such file"),
        (3, "dhlab robots lists"),
        ("../ur5e", "found no"),
    ],
)
def test_an_unknown_name_is_one_plain_sentence(name, words):
    with pytest.raises(ValueError, match=words):
        dh.load(name)


def test_words_find_their_arms():
    assert search("kinova gen3") == ["gen3", "gen3_6dof", "gen3_lite"]
    assert "lrmate200id" in search("LR Mate 200iD") and search("IRB-2400") == ["irb2400"]
    assert search("no such maker") == []
