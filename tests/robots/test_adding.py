"""A new arm from a URDF or a table: what is written is right, and what contradicts is refused."""

import numpy as np
import pytest
from oracles import elementary_pose

import dhlab as dh
from dhlab.formats import plainyaml
from dhlab.formats.descriptions.urdfjoint import unrounded
from dhlab.robots import example
from dhlab.robots.adding import add
from dhlab.robots.entries import read_entry


def added(path):
    return read_entry(path.stem, plainyaml.read(path))


def test_a_urdf_becomes_a_library_file_with_its_poses(tmp_path):
    path = add(
        example("ur5e.urdf"),
        key="mine",
        name="My UR5e",
        source="https://example.org/ur5e",
        tip="tool0",
        licence="BSD-3-Clause",
        folder=tmp_path,
    )
    made = added(path)
    arm, [check] = made.tables["derived"], made.checks["derived"]
    judged = dh.read_urdf(example("ur5e.urdf"), tip="tool0").forward(check.q)
    assert np.allclose(judged[:3, 3], check.xyz, atol=1e-8)
    T = arm.base @ elementary_pose(arm.table, check.q, arm.sign) @ arm.tool
    assert np.allclose(T[:3, 3], check.xyz, atol=2e-9) and np.allclose(
        T[:3, :3], check.R, atol=2e-9
    )
    assert made.licence == "BSD-3-Clause" and made.links == ("https://example.org/ur5e",)
    with pytest.raises(ValueError, match="expected a new file"):
        add(example("ur5e.urdf"), key="mine", name="x", source="y", tip="tool0", folder=tmp_path)


def test_a_second_source_that_agrees_stands_beside_it(tmp_path):
    dh.load("ur5e").flip_x(2).to("craig").table.save(tmp_path / "other.csv")
    path = add(
        example("ur5e.urdf"),
        key="mine",
        name="x",
        source="y",
        tip="tool0",
        second=tmp_path / "other.csv",
        folder=tmp_path,
    )
    made = added(path)
    assert list(made.tables) == ["derived", "second"] and "the same arm" in made.second


def test_a_second_source_that_contradicts_is_refused(tmp_path):
    dh.load("ur5_cb").table.save(tmp_path / "cb.csv")
    with pytest.raises(ValueError, match=r"expected the arm of .*cb\.csv, found another\. Joint"):
        add(
            example("ur5e.urdf"),
            key="mine",
            name="x",
            source="y",
            tip="tool0",
            second=tmp_path / "cb.csv",
            folder=tmp_path,
        )
    assert not (tmp_path / "mine.yaml").exists()


@pytest.mark.parametrize("key", ["", "My Arm", "../x", "a.b"])
def test_a_key_that_is_no_files_name_is_refused(key, tmp_path):
    with pytest.raises(ValueError, match="expected a key of small letters"):
        add(example("ur5e.urdf"), key=key, name="x", source="y", folder=tmp_path)


@pytest.mark.parametrize(
    "written, meant",
    [(1.57, 90), (-1.5708, -90), (3.14, 180), (1.571, 90), (0.7854, 45), (2.0944, 120)],
)
def test_a_rounded_angle_is_what_it_stands_for(written, meant):
    assert unrounded(written) == pytest.approx(np.deg2rad(meant), abs=1e-15)


@pytest.mark.parametrize("angle", [0.0, 1.5, 1.58, 0.785, 0.1, 1.5608, -1.5706])
def test_another_angle_stays(angle):
    assert unrounded(angle) == angle
