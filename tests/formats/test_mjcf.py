"""MuJoCo's MJCF: against the library's Panda, against a chain multiplied by hand, and against
MuJoCo itself where it is installed.
"""

import numpy as np
import pytest

import dhlab as dh
from dhlab.transform import rot_x, rot_y, rot_z, trans

PANDA = [  # pos, quat of each link in the one before, as Franka's description has them
    ("0 0 0.333", "1 0 0 0"),
    ("0 0 0", "1 -1 0 0"),
    ("0 -0.316 0", "1 1 0 0"),
    ("0.0825 0 0", "1 1 0 0"),
    ("-0.0825 0.384 0", "1 -1 0 0"),
    ("0 0 0", "1 1 0 0"),
    ("0.088 0 0", "1 1 0 0"),
]
FINGERS = """<body name="flange" pos="0 0 0.107">
  <body name="left"><joint name="finger_1" type="slide" axis="0 1 0"/></body>
  <body name="right"><joint name="finger_2" type="slide" axis="0 -1 0"/></body></body>"""

MIXED = """<mujoco model="mixed">
  <compiler angle="degree" eulerseq="xYz"/>
  <default>
    <joint axis="0 1 0" range="-90 120"/>
    <default class="rail"><joint type="slide" axis="1 0 0" range="-0.1 0.4"/></default>
  </default>
  <worldbody>
    <body name="a" pos="0.1 0.2 0.3" euler="10 20 30">
      <joint name="one" pos="0.01 0.02 0.03" ref="15"/>
      <body name="b" pos="0 0 0.4" axisangle="0 0 2 40" childclass="rail">
        <joint name="two"/>
        <body name="c" zaxis="0 1 1">
          <joint name="three" type="hinge" axis="0 0 3" limited="false"/>
          <site name="end" pos="0.05 0 0.1" xyaxes="0 1 0 -1 0 0"/>
        </body></body></body>
  </worldbody></mujoco>"""


def panda():
    text, close = "", FINGERS
    for k, (pos, quat) in enumerate(PANDA, 1):
        text += f'<body name="link{k}" pos="{pos}" quat="{quat}"><joint name="joint{k}"/>'
        close += "</body>"
    return f'<mujoco model="panda"><worldbody>{text}{close}</worldbody></mujoco>'


def written(folder, text):
    path = folder / "model.xml"
    path.write_text(text)
    return path


def test_the_panda_is_the_library_s_and_its_fingers_are_left_out(tmp_path):
    with pytest.warns(UserWarning, match=r"up to flange.*left out: finger_1, finger_2.*--end"):
        arm = dh.read_mjcf(written(tmp_path, panda()))
    found = dh.compare(dh.load("panda"), arm)
    assert found.kind in ("same", "ends") and len(arm) == 7
    q = np.random.default_rng(1).uniform(-2, 2, 7)
    np.testing.assert_allclose(
        arm.forward(q)[:3, 3], dh.load("panda").forward(q)[:3, 3], atol=1e-12
    )


def test_what_the_format_says_of_bodies_and_joints(tmp_path):
    arm = dh.read_mjcf(written(tmp_path, MIXED), tip="end")
    assert arm.table.joints == "RPR" and arm.limits[2] is None
    np.testing.assert_allclose(arm.limits[:2], [(-np.pi / 2, 2 * np.pi / 3), (-0.1, 0.4)])
    deg = np.pi / 180
    for q in np.random.default_rng(2).uniform(-1, 1, (5, 3)):
        # x moving, y fixed, z moving
        T = trans([0.1, 0.2, 0.3]) @ rot_y(20 * deg) @ rot_x(10 * deg) @ rot_z(30 * deg)
        anchor = [0.01, 0.02, 0.03]
        T = T @ trans(anchor) @ rot_y(q[0] - 15 * deg) @ trans(np.negative(anchor))
        T = T @ trans([0, 0, 0.4]) @ rot_z(40 * deg) @ trans([q[1], 0, 0])
        T = T @ rot_x(-45 * deg) @ rot_z(q[2]) @ trans([0.05, 0, 0.1]) @ rot_z(90 * deg)
        np.testing.assert_allclose(arm.forward(q), T, atol=1e-12)


@pytest.mark.parametrize("text, tip", [(MIXED, "end"), (panda(), "flange")])
def test_mujoco_says_the_same(tmp_path, text, tip):
    mujoco = pytest.importorskip("mujoco")
    path = written(tmp_path, text.replace("<joint ", "<geom size='.1' mass='1'/><joint "))
    arm = dh.read_mjcf(path, tip=tip)
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    for q in np.random.default_rng(3).uniform(-1, 1, (5, len(arm))):
        data.qpos[: len(arm)] = q
        mujoco.mj_kinematics(model, data)
        frame = data.site(tip) if tip == "end" else data.body(tip)
        T = arm.forward(q)
        np.testing.assert_allclose(T[:3, 3], frame.xpos, atol=1e-9)
        np.testing.assert_allclose(T[:3, :3].ravel(), frame.xmat, atol=1e-9)


@pytest.mark.parametrize(
    "change, words",
    [
        (("worldbody>", "world>"), "mixed.*|expected a body or a site of the file, found 'end'"),
        (('type="hinge"', 'type="ball"'), "joint three: expected hinge or slide, found 'ball'"),
        (('axis="0 0 3"', 'axis="0 0 0"'), "joint three: axis: expected a direction"),
        (('pos="0 0 0.4"', 'pos="0 0"'), "body b: pos: expected 3 finite numbers, found '0 0'"),
        (("mujoco", "robot"), "expected an MJCF file.*found <robot>"),
    ],
)
def test_what_cannot_be_read_is_one_sentence(tmp_path, change, words):
    with pytest.raises(ValueError, match=words) as raised:
        dh.read_mjcf(written(tmp_path, MIXED.replace(*change)), tip="end")
    assert "model.xml: " in str(raised.value) and "\n" not in str(raised.value)
