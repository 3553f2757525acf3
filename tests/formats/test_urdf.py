"""URDF in and out, judged by pinocchio, PyBullet and yourdfpy on the same file."""

import json
import pathlib
import warnings

import numpy as np
import pytest
from draws import few

from dhlab import Arm, DHTable, load, robots
from dhlab.formats.descriptions.urdf import read_urdf, to_urdf
from dhlab.formats.descriptions.urdftree import read_chain
from dhlab.transform import from_xyz_rpy

CHAINS = sorted((pathlib.Path(__file__).parents[1] / "data" / "chains").glob("*.json"))


@pytest.fixture(autouse=True)
def seeded():
    """Every test draws the same numbers, whichever ran before it."""
    global rng
    rng = np.random.default_rng(5)


def chain_urdf(joints, name="robot"):
    """The URDF text of a list of joints as the chain files have them."""
    lines = [f'<robot name="{name}">'] + [
        f'<link name="l{i}"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1"'
        ' iyz="0" izz="1"/></inertial></link>'
        for i in range(len(joints) + 1)
    ]
    for i, joint in enumerate(joints):
        numbers = {key: " ".join(map(repr, joint[key])) for key in ("xyz", "rpy", "axis")}
        limit = (
            f'<limit lower="{joint["lower"]}" upper="{joint["upper"]}" effort="1" velocity="1"/>'
            if "lower" in joint
            else '<limit lower="-3" upper="3" effort="1" velocity="1"/>'
        )
        lines.append(
            f'<joint name="{joint["name"]}" type="{joint["type"]}"><parent link="l{i}"/><child'
            f' link="l{i + 1}"/><origin xyz="{numbers["xyz"]}" rpy="{numbers["rpy"]}"/><axis'
            f' xyz="{numbers["axis"]}"/>{limit}</joint>'
        )
    return "\n".join([*lines, "</robot>"])


@pytest.fixture
def file(tmp_path):
    def write(text, name="robot.urdf"):
        path = tmp_path / name
        path.write_text(text)
        return path

    return write


def read(*args, **kwargs):
    """``read_urdf`` without its warnings of nearly parallel axes, which 1.5708 in a file brings
    up.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return read_urdf(*args, **kwargs)


def by_pinocchio(path, q, base, tip):
    pinocchio = pytest.importorskip("pinocchio")
    model = pinocchio.buildModelFromUrdf(str(path))
    data, poses = model.createData(), []
    base, tip = (model.getFrameId(name) for name in (base, tip))
    for one in q:
        values = []
        for k, joint in enumerate(model.joints[1:]):
            values += [np.cos(one[k]), np.sin(one[k])] if joint.nq == 2 else [one[k]]
        pinocchio.framesForwardKinematics(model, data, np.array(values))
        poses.append((data.oMf[base].inverse() * data.oMf[tip]).homogeneous)
    return np.array(poses)


def by_pybullet(path, q, tip):
    bullet = pytest.importorskip("pybullet")
    client = bullet.connect(bullet.DIRECT)
    try:
        body = bullet.loadURDF(
            str(path),
            useFixedBase=True,
            flags=bullet.URDF_USE_INERTIA_FROM_FILE,
            physicsClientId=client,
        )
        info = [
            bullet.getJointInfo(body, k, physicsClientId=client)
            for k in range(bullet.getNumJoints(body, physicsClientId=client))
        ]
        moving = [k for k, joint in enumerate(info) if joint[2] != bullet.JOINT_FIXED]
        link = next(k for k, joint in enumerate(info) if joint[12].decode() == tip)
        poses = []
        for one in q:
            for k, value in zip(moving, one, strict=True):
                bullet.resetJointState(body, k, value, physicsClientId=client)
            state = bullet.getLinkState(
                body, link, computeForwardKinematics=True, physicsClientId=client
            )
            T = np.eye(4)
            T[:3, :3], T[:3, 3] = (
                np.reshape(bullet.getMatrixFromQuaternion(state[5]), (3, 3)),
                state[4],
            )
            poses.append(T)
        return np.array(poses)
    finally:
        bullet.disconnect(client)


def by_yourdfpy(path, q, base, tip):
    yourdfpy = pytest.importorskip("yourdfpy")
    robot, poses = yourdfpy.URDF.load(str(path), load_meshes=False, build_scene_graph=True), []
    for one in q:
        robot.update_cfg(one)
        poses.append(robot.get_transform(tip, base))
    return np.array(poses)


@pytest.mark.parametrize("convention", ["standard", "craig"])
@pytest.mark.parametrize("path", CHAINS, ids=lambda path: path.stem)
def test_every_chain_has_the_pose_that_pinocchio_gives(path, convention, file):
    joints = json.loads(path.read_text())["joints"]
    urdf = file(chain_urdf(joints))
    arm = read(urdf, convention=convention)
    q = rng.uniform(-2.9, 2.9, (100, len(arm)))
    assert np.abs(arm.forward(q) - by_pinocchio(urdf, q, "l0", f"l{len(joints)}")).max() < 1e-12
    assert arm.table.convention == convention and len(arm) == sum(
        joint["type"] != "fixed" for joint in joints
    )


@pytest.mark.parametrize("path", CHAINS, ids=lambda path: path.stem)
def test_every_chain_is_read_as_yourdfpy_reads_it(path, file):
    joints = json.loads(path.read_text())["joints"]
    urdf = file(chain_urdf(joints))
    arm = read(urdf)
    q = rng.uniform(-2.9, 2.9, (5, len(arm)))
    assert np.abs(arm.forward(q) - by_yourdfpy(urdf, q, "l0", f"l{len(joints)}")).max() < 1e-11


@pytest.mark.parametrize("path", CHAINS, ids=lambda path: path.stem)
def test_the_numbers_of_every_joint_are_those_of_yourdfpy(path, file):
    yourdfpy = pytest.importorskip("yourdfpy")
    n = len(json.loads(path.read_text())["joints"])
    urdf = file(chain_urdf(json.loads(path.read_text())["joints"]))
    theirs = yourdfpy.URDF.load(str(urdf), load_meshes=False, build_scene_graph=False).joint_map
    ours, *_ = read_chain(urdf, None, None)
    assert len(ours) == len(theirs) == n
    for joint in ours:
        other = theirs[joint.name]
        assert joint.kind == other.type and np.array_equal(joint.axis, other.axis)
        assert np.abs(joint.origin - other.origin).max() < 1e-15
        if joint.limits:
            assert joint.limits == (other.limit.lower, other.limit.upper)


@pytest.mark.parametrize("path", CHAINS[::4], ids=lambda path: path.stem)
def test_chains_by_pybullet(path, file):
    joints = json.loads(path.read_text())["joints"]
    urdf = file(chain_urdf(joints))
    arm = read(urdf)
    q = rng.uniform(-2.9, 2.9, (5, len(arm)))
    assert np.abs(arm.forward(q) - by_pybullet(urdf, q, f"l{len(joints)}")).max() < 1e-6


def random_arm(convention, joints, limits):
    n = len(joints)
    rows = np.column_stack(
        [
            rng.uniform(-3, 3, n),
            rng.uniform(-0.3, 0.3, n),
            rng.uniform(-0.4, 0.4, n),
            rng.choice([0, np.pi / 2, 0.7, np.pi], n),
        ]
    )
    table = getattr(DHTable, convention)(rows, angle="rad", joints=joints)
    return Arm(
        table,
        base=from_xyz_rpy([0.1, -0.2, 0.3], [0.3, -1.2, 2]),
        tool=from_xyz_rpy([0, 0.1, 0.05], [1, np.pi / 2, -1]),
        sign=rng.choice([1, -1], n),
        limits=limits,
        name='an "arm" <of> süße & more',
    )


@pytest.mark.parametrize("convention", ["standard", "craig"])
@pytest.mark.parametrize("joints", ["RRRRRR", "RPR", "PPP", "PRPRPRP", "R", "P"])
@pytest.mark.parametrize("limited", [True, False])
def test_written_files_load_in_simulators_and_read_back(
    convention, joints, limited, file, tmp_path
):
    arm = random_arm(convention, joints, [(-3, 2.5)] * len(joints) if limited else None)
    path = tmp_path / "out.urdf"
    assert to_urdf(arm, path) == path.read_text()
    q = rng.uniform(-2, 2, (10, len(arm)))
    back = read(path)
    assert np.abs(back.forward(q) - arm.forward(q)).max() < 1e-13
    assert back.limits == arm.limits and back.table.joints == joints
    assert np.abs(by_pinocchio(path, q, "link_0", "tool") - arm.forward(q)).max() < 1e-13
    assert np.abs(by_pybullet(path, q, "tool") - arm.forward(q)).max() < 1e-6


@pytest.mark.parametrize("name", few(robots(), 20))
def test_round_trip_of_the_library(name, tmp_path):
    arm = load(name)
    to_urdf(arm, tmp_path / "out.urdf")
    back = read(tmp_path / "out.urdf", "link_0", "tool")
    q = rng.uniform(-3, 3, (100, len(arm)))
    assert np.abs(back.forward(q) - arm.forward(q)).max() < 1e-12
    assert back.limits == arm.limits and back.name and "out.urdf" in back.source


def test_rounded_angles_are_warned_of_by_name(file):
    path = file(
        robot(
            ("a", "l0", "l1", "continuous"),
            ("b", "l1", "l2", "continuous", '<origin xyz="0.3 0 0" rpy="0 3.141592653 0"/>'),
            ("c", "l2", "l3", "fixed", '<origin xyz="0.3 0.1 0.2"/>'),
        )
    )
    with pytest.warns(UserWarning, match="robot.urdf: .*parallel") as said:
        arm = read_urdf(path)
    assert said[0].filename == __file__
    q = rng.uniform(-2, 2, (20, 2))
    assert np.abs(arm.forward(q) - by_pinocchio(path, q, "l0", "l3")).max() < 1e-9


def test_writing_never_loses_a_file(tmp_path):
    path = tmp_path / "out.urdf"
    path.write_text("mine")
    with pytest.raises(ValueError, match="exists"):
        to_urdf(load("ur5e"), path)
    assert path.read_text() == "mine" and list(tmp_path.iterdir()) == [path]
    to_urdf(load("ur5e"), path, overwrite=True)
    assert len(read_urdf(path)) == 6
    with pytest.raises(ValueError, match="expected an Arm"):
        to_urdf(load("ur5e").table)


LINKS = "".join(f'<link name="l{i}"/>' for i in range(4))
TURN = (
    '<joint name="{0}" type="{3}"><parent link="{1}"/><child link="{2}"/><axis xyz="0 0'
    ' 1"/>{4}</joint>'
)


def robot(*joints, links=LINKS):
    written = "".join(TURN.format(*joint, *[""] * (5 - len(joint))) for joint in joints)
    return f'<robot name="r">{links}{written}</robot>'


CHAIN = [("a", "l0", "l1", "revolute"), ("b", "l1", "l2", "fixed"), ("c", "l2", "l3", "prismatic")]


def test_defaults_limits_and_parts_of_a_chain(file):
    limits = {
        "a": '<limit lower="-1" upper="2"/>',
        "c": '<limit upper="0.5"/><origin xyz="0 0 1"/>',
    }
    path = file(robot(*[(*joint, limits.get(joint[0], "")) for joint in CHAIN]))
    arm = read_urdf(path)
    assert (arm.table.joints, arm.limits, arm.name, arm.source) == (
        "RP",
        ((-1, 2), (0, 0.5)),
        "r",
        "robot.urdf, from l0 to l3; joints: a, c",
    )
    assert arm.forward([0.3, 0.2])[2, 3] == pytest.approx(1.2) and isinstance(arm.steps, tuple)
    assert len(read_urdf(path, tip="l1")) == len(read_urdf(path, "l1")) == 1
    for limit in ('<limit lower="1" upper="-1"/>', '<limit effort="1" velocity="1"/>', ""):
        assert (
            read_urdf(
                file(robot(("a", "l0", "l1", "revolute", limit), *CHAIN[1:])), tip="l1"
            ).limits
            is None
        )
    assert (
        read_urdf(
            file(
                robot(("a", "l0", "l1", "continuous", '<limit lower="1" upper="2"/>'), *CHAIN[1:])
            ),
            tip="l2",
        ).limits
        is None
    )
    plain = (
        '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="continuous"><parent'
        ' link="a"/><child link="b"/></joint></robot>'
    )
    # the axis of URDF's default
    assert np.allclose(read_urdf(file(plain)).jacobian([0.0])[3:, 0], [1, 0, 0])


def test_what_is_off_the_chain_does_not_matter(file):
    branch = (
        '<joint name="m" type="floating"><parent link="l0"/><child link="x"/><axis'
        ' xyz="nothing"/></joint><link name="x"/><gazebo:odd xyz="1"/><transmission name="t"><joint'
        ' name="a"/></transmission><material name="red"><color rgba="?"/></material>'
    )
    path = file(
        '<?xml version="1.0" encoding="utf-8"?><!-- a remark -->'
        + robot(*CHAIN).replace("</robot>", branch + "</robot>")
    )
    assert len(read_urdf(path, tip="l3")) == 2


@pytest.mark.parametrize(
    "text, kwargs, words",
    [
        ("", {}, "no element found"),
        ("just words", {}, "line 1: expected XML"),
        ("<robot><link name='a'></robot>", {}, "mismatched tag"),
        ("<robot name='r'/>", {}, "0 links and 0 joints"),
        ("<sdf version='1.7'/>", {}, "SDF"),
        ("<mujoco/>", {}, "MuJoCo"),
        ("<svg/>", {}, "<svg>"),
        (robot(("${prefix}a", "l0", "l1", "revolute")), {}, "xacro.*prefix"),
        (
            robot(("a", "l0", "l1", "revolute", '<origin xyz="0 0 ${h}"/>'), *CHAIN[1:]),
            {},
            "xacro.*'h' is not defined",
        ),
        (
            robot(*CHAIN[:2], ("d", "l0", "x", "revolute"), links=LINKS + '<link name="x"/>'),
            {"base": "l0"},
            "found 2 leaves below l0, and 2 chains of 1 joints.*l2, x",
        ),
        (
            robot(*CHAIN),
            {"tip": "l9"},
            "tip: expected a link of the file, found 'l9'; the links are l0, l1, l2, l3",
        ),
        (robot(*CHAIN), {"base": 3}, "base: expected a link"),
        (robot(*CHAIN), {"base": "l2", "tip": "l1"}, "l1 is not below l2"),
        (robot(*CHAIN), {"base": "l3"}, "joints below l3, found none"),
        (robot(*CHAIN), {"base": "l1", "tip": "l2"}, "fixed joints only"),
        (robot(*CHAIN), {"base": "l1", "tip": "l1"}, "fixed joints only"),
        (
            robot(
                ("a", "l0", "l1", "fixed"), ("b", "l0", "l2", "fixed"), ("c", "l0", "l3", "fixed")
            ),
            {},
            "fixed joints only",
        ),
        (robot(*CHAIN[1:]), {}, "one root link, found l0, l1; name one"),
        (
            robot(*CHAIN, ("d", "l3", "l1", "revolute")),
            {},
            "loop: link l1 hangs on the joints a and d",
        ),
        (robot(*CHAIN, ("d", "l3", "l0", "revolute")), {}, "loop without a root"),
        (robot(*CHAIN, ("d", "l3", "l0", "revolute")), {"tip": "l3"}, "loop through l3"),
        (
            robot(*CHAIN[:2], ("c", "l2", "l7", "prismatic")),
            {},
            "joint c: expected a link of the file, found l7",
        ),
        (robot(*CHAIN, links=LINKS + '<link name="l1"/>'), {}, "every link once, found l1 twice"),
        (robot(*CHAIN[:2], ("a", "l2", "l3", "fixed")), {}, "every joint once, found a twice"),
        (
            robot(("a", "l0", "l1", "floating"), *CHAIN[1:]),
            {},
            "joint a: expected revolute.*found floating; it has six",
        ),
        (robot(("a", "l0", "l1", "planar"), *CHAIN[1:]), {}, "found planar"),
        (robot(("a", "l0", "l1", "screw"), *CHAIN[1:]), {}, "found screw"),
        (
            robot(("a", "l0", "l1", "revolute", '<mimic joint="c"/>'), *CHAIN[1:]),
            {},
            "joint a: .*mimics c",
        ),
        (robot(*CHAIN).replace('"0 0 1"', '"0 0 0"'), {}, "axis: expected a direction"),
        (
            robot(*CHAIN).replace('"0 0 1"', '"1"'),
            {},
            "axis xyz: expected 3 finite numbers, found '1'",
        ),
        (
            robot(("a", "l0", "l1", "revolute", '<origin xyz="0,1 0 0"/>'), *CHAIN[1:]),
            {},
            "origin xyz: expected 3",
        ),
        (
            robot(("a", "l0", "l1", "revolute", '<origin rpy="0 nan 0"/>'), *CHAIN[1:]),
            {},
            "origin rpy: expected 3 finite",
        ),
        (
            robot(("a", "l0", "l1", "revolute", '<origin xyz=""/>'), *CHAIN[1:]),
            {},
            "origin xyz: expected 3 finite numbers, found ''",
        ),
        (
            robot(("a", "l0", "l1", "revolute", '<limit lower="-180deg" upper="1"/>'), *CHAIN[1:]),
            {},
            "limit lower",
        ),
        (robot(*CHAIN).replace('<child link="l1"/>', ""), {}, "joint a: expected <parent"),
        (
            robot(("a", "l0", "l1", "revolute", '<limit upper="1e999"/>'), *CHAIN[1:]),
            {},
            "limit upper: expected a finite number, found '1e999'",
        ),
        (robot(*CHAIN).replace('type="fixed"', ""), {}, "found no type"),
        (
            robot(*CHAIN).replace('<link name="l3"/>', "<link/>"),
            {},
            "a link: expected the attribute name",
        ),
    ],
    ids=str,
)
def test_what_is_refused_and_how(text, kwargs, words, file):
    with pytest.raises(ValueError, match=words) as error:
        read_urdf(file(text), **kwargs)
    assert "robot.urdf" in str(error.value) and "\n" not in str(error.value)


BOMB = (
    '<!DOCTYPE robot [<!ENTITY a "ha">'
    + "".join(f'<!ENTITY {b} "{f"&{a};" * 10}">' for a, b in zip("abcdefghi", "bcdefghij"))
    + "]>"
)


@pytest.mark.parametrize(
    "head, inside",
    [
        (BOMB, "&j;"),
        ('<!DOCTYPE robot [<!ENTITY x SYSTEM "file:///etc/passwd">]>', "&x;"),
        ('<!DOCTYPE robot SYSTEM "http://localhost:9/x.dtd">', ""),
        ('<!DOCTYPE robot [<!ENTITY % p SYSTEM "file:///etc/passwd">%p;]>', ""),
    ],
)
def test_no_entities_and_no_document_types(head, inside, file):
    for text in (
        head + f"<robot name='r'>{inside}</robot>",
        head + robot(*CHAIN).replace('name="r"', f'name="{inside}"'),
    ):
        with pytest.raises(ValueError, match="document type"):
            read_urdf(file(text))


def test_entities_without_a_document_type(file):
    with pytest.raises(ValueError, match="undefined entity"):
        read_urdf(file(robot(*CHAIN).replace("</robot>", "&x;</robot>")))


def test_deep_and_missing_files(file, tmp_path):
    with pytest.raises(ValueError, match="joints"):
        read_urdf(file("<robot name='r'>" + "<a>" * 100_000 + "</a>" * 100_000 + "</robot>"))
    with pytest.raises(ValueError, match="no such file"):
        read_urdf(tmp_path / "none.urdf")
    with pytest.raises(ValueError, match="folder"):
        read_urdf(tmp_path)
