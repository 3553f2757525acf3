"""Where an arm ends in a URDF; xacro files; axes that rounded angles keep from being parallel."""

import warnings

import numpy as np
import pytest
from terminal import dhlab

import dhlab as dh

JOINT = (
    '<joint name="{0}" type="{3}"><parent link="{1}"/><child link="{2}"/><axis xyz="0 0 1"/>'
    '<origin xyz="0 0.1 0.23" rpy="{4} 0 0"/>{5}</joint>'
)


def urdf(*joints):
    """Joints as (name, parent, child, type, roll, more)."""
    filled = [(*joint, *("revolute", "0.5", "")[len(joint) - 3 :]) for joint in joints]
    links = dict.fromkeys(link for joint in filled for link in joint[1:3])
    body = "".join(f'<link name="{link}"/>' for link in links)
    return f'<robot name="r">{body}{"".join(JOINT.format(*joint) for joint in filled)}</robot>'


ARM = [("j1", "base", "l1"), ("j2", "l1", "l2"), ("j3", "l2", "l3")]
FIXED = ("fixed", "0")
MIMIC = ("prismatic", "0", '<mimic joint="f1"/>')
CASES = {
    "two fingers": ([*ARM, ("f1", "l3", "p1", "prismatic"), ("f2", "l3", "p2", *MIMIC)], "l3"),
    "one jaw": ([*ARM, ("gripper", "l3", "jaw")], "l3"),
    "a hand and a tool frame": (
        [
            *ARM,
            ("h", "l3", "hand", *FIXED),
            ("t", "hand", "hand_tcp", *FIXED),
            ("finger_1", "hand", "p1"),
            ("finger_2", "hand", "p2"),
        ],
        "hand_tcp",
    ),
    "a camera": ([*ARM, ("c", "l1", "camera", *FIXED), ("t", "l3", "tool0", *FIXED)], "tool0"),
    "a gripper that rolls": ([*ARM, ("gripper_roll", "l3", "gripper_base")], "gripper_base"),
}


@pytest.mark.parametrize("name", CASES)
def test_a_gripper_s_joint_is_no_joint_of_the_arm(name, tmp_path):
    joints, end = CASES[name]
    path = tmp_path / "arm.urdf"
    path.write_text(urdf(*joints))
    with warnings.catch_warnings(record=True) as noted:
        warnings.simplefilter("always")
        arm = dh.read_urdf(path)
    assert f"from base to {end};" in arm.source
    assert len(arm) == (4 if name == "a gripper that rolls" else 3)
    said = [str(note.message) for note in noted]
    assert len(said) == (name != "a gripper that rolls")
    assert all("longest chain of arm joints" in words for words in said)
    last = joints[-1][2]
    done = dhlab("from-urdf", path, "--end", last, "--json")
    assert done.returncode == (2 if "mimic" in str(joints[-1]) else 0)


XACRO = """<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find arm_description)/urdf/part.xacro"/>
  <link name="l0"/><xacro:part k="1" length="$(arg length)"/><xacro:part k="2" length="0.2"/>
</robot>"""
PART = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="part" params="k length">
  <link name="l${k}"><visual><geometry><mesh filename="$(find meshes)/x.stl"/></geometry></visual>
  </link><joint name="j${k}" type="continuous"><parent link="l${k-1}"/><child link="l${k}"/>
  <origin xyz="${length} 0 0"/><axis xyz="0 0 1"/></joint></xacro:macro></robot>"""


def test_a_xacro_file_is_expanded_with_what_it_is_given(tmp_path):
    pytest.importorskip("xacro")
    folder = tmp_path / "arm_description" / "urdf"
    folder.mkdir(parents=True)
    (folder / "arm.urdf.xacro").write_text(XACRO)
    (folder / "part.xacro").write_text(PART)
    done = dhlab("from-urdf", folder / "arm.urdf.xacro")
    assert done.returncode == 2 and "--arg length=VALUE" in done.stderr
    arm = dh.read_urdf(folder / "arm.urdf.xacro", arguments={"length": 0.3})
    np.testing.assert_allclose(arm.forward([0, 0])[:3, 3], [0.5, 0, 0], atol=1e-12)
    moved = tmp_path / "arm.urdf.xacro"
    moved.write_text(XACRO.replace("arm_description", "elsewhere"))
    done = dhlab("from-urdf", moved, "--arg", "length=0.3")
    assert done.returncode == 2 and "--package elsewhere=FOLDER" in done.stderr
    given = ("--package", f"elsewhere={folder.parent}", "--arg", "length=0.3")
    assert dhlab("from-urdf", moved, *given, "--out", tmp_path / "t.yaml").returncode == 0
    assert dh.equivalent(dh.load(tmp_path / "t.yaml"), arm)


def test_a_property_that_nothing_uses_is_no_macro(tmp_path):
    path = tmp_path / "plain.urdf"
    text = urdf(*ARM).replace("<link", '<xacro:property name="pi" value="${3}"/><link', 1)
    path.write_text(text)
    assert len(dh.read_urdf(path)) == 3


@pytest.mark.parametrize("angle, cost", [("1.5708", 0.1), ("1.57", 5)])
def test_rounded_angles_cost_what_is_said(angle, cost, tmp_path):
    path = tmp_path / "rounded.urdf"
    parallel = [
        ("j1", "base", "l1"),
        ("x", "l1", "l1b", "fixed", angle),
        ("j2", "l1b", "l2", "revolute", "-1.570796326794897"),
        ("j3", "l2", "l3", "revolute", "0.7"),
        ("j4", "l3", "l4", "revolute", "0"),
    ]
    path.write_text(urdf(*parallel))
    with pytest.warns(dh.NearlyParallelWarning) as said:
        arm = dh.read_urdf(path)
    exact = dh.read_urdf(path, parallel=0) if cost < 1 else arm
    q = np.random.default_rng(4).uniform(-3, 3, (200, 4))
    off = 1e3 * np.linalg.norm((arm.forward(q) - exact.forward(q))[:, :3, 3], axis=1).max()
    assert off < cost
    if cost < 1:
        assert "were taken as parallel, which costs up to" in str(said[0].message)
        assert np.abs(arm.table.d).max() < 1 < np.abs(exact.table.d).max()
    else:
        assert "--parallel" in str(said[-1].message) and "--hayati" in str(said[-1].message)
