"""Which arm is this table? Every table of the library, tables written in another way, and arms
that the library does not have.
"""

import sys

import numpy as np
import pytest
from draws import few

import dhlab as dh
from dhlab.geometry.zeros import with_zeros
from dhlab.robots import entry, likeness
from dhlab.robots.likeness import like

KEYS = dh.robots()


def names(table):
    return [found.name.partition(".")[0] for found in like(table)]


@pytest.mark.parametrize("key", few(KEYS, 20))
def test_every_table_finds_its_arm(key):
    for arm in entry(key).tables.values():
        assert key in names(arm.table)


def rewritten(arm, rng, folder):
    """The same arm as another publisher would write it."""
    n = len(arm)
    if arm.coupling is None and arm.table.joints == "R" * n:
        arm = with_zeros(arm, rng.choice([1, -1], n), rng.choice([0, np.pi / 2, 0.3], n))
    for _ in range(4):
        arm = (arm.flip_x, arm.flip_z)[rng.integers(2)](int(rng.integers(1, n)))
        i = int(rng.integers(1, n))
        if arm.table.convention == "standard" and abs(np.sin(arm.table.alpha[i - 1])) < 1e-12:
            arm = arm.slide(i, 0.1)
    table = arm.to(rng.choice(["standard", "craig"])).table
    path = folder / "table.csv"
    table.save(path, angle=str(rng.choice(["deg", "rad"])), length=str(rng.choice(["m", "mm"])))
    return dh.load(path)


@pytest.mark.parametrize("k", few(range(100), 20))
def test_a_table_written_in_another_way_finds_its_arm(k, tmp_path):
    rng = np.random.default_rng(k)
    key = KEYS[rng.integers(len(KEYS))]
    assert key in names(rewritten(dh.load(key), rng, tmp_path))


@pytest.mark.parametrize("k", few(range(50), 10))
def test_a_foreign_arm_finds_none(k):
    """An arm of the library with one length of its own."""
    rng = np.random.default_rng(k)
    arm = dh.load(KEYS[rng.integers(len(KEYS))]).to("standard")
    t = arm.table
    a = np.array(t.a)
    a[int(rng.integers(len(arm) - 1))] += 0.0137
    assert like(dh.DHTable("standard", t.theta, t.d, a, t.alpha, t.joints)) == []


@pytest.mark.parametrize("key", few(KEYS, 10))
def test_without_its_file_an_arm_is_foreign(key, monkeypatch):
    table = dh.load(key).table
    found = names(table)
    others = [other for other in KEYS if other not in found]
    monkeypatch.setattr(sys.modules["dhlab.robots"], "robots", lambda: others)
    assert all(max(one.length, one.angle) > likeness.EXACT for one in like(table))


def test_it_tells_the_families_apart():
    assert names(dh.load("ur10_cb").table) == ["ur10_cb"]
    assert names(dh.load("jaco6").table) == ["jaco6"]
    in_mm = dh.load("ur10e").table
    in_mm = dh.DHTable(
        "standard", in_mm.theta, in_mm.d * 1000, in_mm.a * 1000, in_mm.alpha, "R" * 6
    )
    assert names(in_mm) == ["ur10e"]
    said = str(like(dh.load("ur5e").flip_z(2).table)[0])
    assert "base and tool aside; joint 3 counted the other way" in said
    with pytest.raises(ValueError, match="like: expected"):
        like("ur5e")
    assert likeness.ROUNDED[0] > likeness.EXACT
