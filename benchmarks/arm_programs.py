"""Every arm of the library moved by programs that are not ours.

    python benchmarks/arm_programs.py            # Markdown: program, arms, worst deviation
    python benchmarks/arm_programs.py --arms ur5e,panda -m 20

Each program that is installed moves what it can read: pinocchio, PyBullet and yourdfpy the URDF
chain that an arm is derived from or checked by; Robotics Toolbox and ssik the arm's numbers, as
their own code multiplies them. Base, tool, signs and zeros of an arm are put around those by hand.
Two lines are of the table itself: written in the other convention and back, and drawn up anew from
its axes.
"""

import argparse
import contextlib
import io
import logging
import os
import pathlib
import sys
import tempfile
import warnings
from importlib.util import find_spec

import numpy as np

import dhlab as dh
from dhlab.geometry.canonical import joint_axes

HERE = pathlib.Path(__file__).parent
sys.path[:0] = [str(HERE), str(HERE.parent / "tests")]
from arm_files import chain, sources, urdf_text  # noqa: E402
from arms import moved_chain, values  # noqa: E402
from oracles import pose_errors  # noqa: E402


def by_pinocchio(arm, name):
    return moved_chain(name)


def by_yourdfpy(arm, name):
    import yourdfpy

    logging.getLogger("yourdfpy").setLevel(logging.CRITICAL)
    robot = yourdfpy.URDF.load(
        io.BytesIO(urdf_text(chain(name)["joints"]).encode()),
        build_scene_graph=True,
        load_meshes=False,
    )
    end = f"link_{len(chain(name)['joints'])}"

    def pose(row):
        robot.update_cfg(row)
        return robot.get_transform(end, "link_0")

    return lambda q: np.array([pose(row) for row in q])


def by_pybullet(arm, name):
    import pybullet

    joints = chain(name)["joints"]
    with silent(), tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "arm.urdf"
        path.write_text(urdf_text(joints), encoding="utf-8")
        client = pybullet.connect(pybullet.DIRECT)
        body = pybullet.loadURDF(
            str(path), useFixedBase=True, physicsClientId=client,
            flags=pybullet.URDF_USE_INERTIA_FROM_FILE,
        )  # fmt: skip
    moving = [i for i, joint in enumerate(joints) if joint["type"] != "fixed"]

    def pose(row):
        for i, value in zip(moving, row, strict=True):
            pybullet.resetJointState(body, i, value, physicsClientId=client)
        state = pybullet.getLinkState(
            body, len(joints) - 1, computeForwardKinematics=True, physicsClientId=client
        )
        T = np.eye(4)
        T[:3, 3] = state[4]
        T[:3, :3] = np.reshape(pybullet.getMatrixFromQuaternion(state[5]), (3, 3))
        return T

    return lambda q: np.array([pose(row) for row in q])


def by_toolbox(arm, name):
    """Its DHRobot, link by link: revolute and prismatic, either convention."""
    import roboticstoolbox as rtb

    kinds = {
        ("standard", "R"): lambda t, d, a, alpha: rtb.RevoluteDH(d, a, alpha, t),
        ("standard", "P"): lambda t, d, a, alpha: rtb.PrismaticDH(t, a, alpha, d),
        ("craig", "R"): lambda t, d, a, alpha: rtb.RevoluteMDH(d, a, alpha, t),
        ("craig", "P"): lambda t, d, a, alpha: rtb.PrismaticMDH(t, a, alpha, d),
    }
    table = arm.table
    links = [
        kinds[table.convention, letter](*row)
        for row, letter in zip(table.rows, table.joints, strict=True)
    ]
    robot = rtb.DHRobot(links)
    return lambda q: np.array([robot.fkine(row).A for row in q])


def by_ssik(arm, name):
    """Standard rows of turning joints, the angle without its offset."""
    from ssik import Manipulator

    table = arm.to("standard").table if arm.table.convention == "craig" else arm.table
    if set(table.joints) != {"R"} or len(table) not in (6, 7):
        return None
    robot = Manipulator.from_dh(table.alpha, table.a, table.d)
    return lambda q: np.array([np.asarray(robot.fk(row + table.theta)) for row in q])


URDF_PROGRAMS = {"pinocchio": by_pinocchio, "PyBullet": by_pybullet, "yourdfpy": by_yourdfpy}
TABLE_PROGRAMS = {"Robotics Toolbox": by_toolbox, "ssik": by_ssik}
PACKAGES = {
    "pinocchio": "pinocchio",
    "PyBullet": "pybullet",
    "yourdfpy": "yourdfpy",
    "Robotics Toolbox": "roboticstoolbox",
    "ssik": "ssik",
}


@contextlib.contextmanager
def silent():
    """Without the lines that PyBullet writes to the terminal past Python."""
    kept, nowhere = os.dup(1), os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, 1)
        yield
    finally:
        os.dup2(kept, 1)
        os.close(kept)
        os.close(nowhere)


def own_chain(key):
    """The chain that an arm is derived from as it stands; None where a table came first."""
    said = sources().get(key, {})
    return (
        said["chain"]
        if "chain" in said and "table" not in said and said.get("made", True)
        else None
    )


def urdf_deviation(program, key, m):
    """Of the arm from its own chain, (mm, degrees) over m joint values; None without a chain."""
    name = own_chain(key)
    if name is None:
        return None
    arm = dh.load(key)
    q = values(arm, m)
    distance, angle = pose_errors(arm.forward(q), program(arm, name)(q))
    return distance * 1000, np.rad2deg(angle)


def table_deviation(program, key, m):
    """Of the arm from its numbers multiplied elsewhere, without coupling, which has its test."""
    arm = dh.load(key)
    q = values(arm, m)
    moved = arm if program is by_toolbox else _in_standard(arm)
    pose = program(moved, key)
    if pose is None:
        return None
    judged = moved.base @ pose(moved.joint_values(q)) @ moved.tool
    distance, angle = pose_errors(arm.forward(q), judged)
    return distance * 1000, np.rad2deg(angle)


def _in_standard(arm):
    return arm.to("standard") if arm.table.convention == "craig" else arm


def there_and_back(key, m):
    """Through the other convention."""
    arm = dh.load(key)
    q = values(arm, m)
    other = "craig" if arm.table.convention == "standard" else "standard"
    distance, angle = pose_errors(arm.forward(q), arm.to(other).forward(q))
    back = pose_errors(arm.forward(q), arm.to(other).to(arm.table.convention).forward(q))
    return max(distance, back[0]) * 1000, np.rad2deg(max(angle, back[1]))


def anew(key, m):
    """From the arm's axes at zero: the same end, joint by joint."""
    arm = dh.load(key)
    axes = joint_axes(arm)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", dh.NearlyParallelWarning)
        placed = dh.assign_frames(list(zip(axes.p, axes.z, axes.letters)), end=axes.end)
    q = values(arm, m)
    counted = placed.forward(arm.joint_values(q))  # axes know neither signs nor coupling
    if not dh.equivalent(arm, placed):
        return np.inf, np.inf
    distance, angle = pose_errors(arm.forward(q), counted)
    if distance > 1e-6:
        distance, angle = pose_errors(arm.forward(q), placed.forward(q))
    return distance * 1000, np.rad2deg(angle)


def lines(keys, m):
    """(what, arms, worst mm, worst degrees, the arm that is worst), one after the other."""
    for title, package in PACKAGES.items():
        if find_spec(package) is None:
            yield title, "not installed", "", "", ""
            continue
        program, measure = (
            (URDF_PROGRAMS[title], urdf_deviation)
            if title in URDF_PROGRAMS
            else (TABLE_PROGRAMS[title], table_deviation)
        )
        found = {key: measure(program, key, m) for key in keys}
        yield title, *worst(found)
    yield "the other convention and back", *worst({key: there_and_back(key, m) for key in keys})
    yield "drawn up anew from its axes", *worst({key: anew(key, m) for key in keys})


def worst(found):
    """How many arms were moved, and the largest deviations with the arm."""
    moved = {key: pair for key, pair in found.items() if pair is not None}
    if not moved:
        return 0, "", "", ""
    key = max(moved, key=lambda key: moved[key])
    return len(moved), f"{moved[key][0]:.1e}", f"{max(p[1] for p in moved.values()):.1e}", key


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--arms", default="", help="only these, with commas")
    parser.add_argument("-m", type=int, default=200, help="joint values for each arm")
    given = parser.parse_args()
    keys = given.arms.split(",") if given.arms else dh.robots()
    print("| moved by | arms | worst mm | worst ° | worst arm |\n|---|---|---|---|---|")
    for line in lines(keys, given.m):
        print("| " + " | ".join(map(str, line)) + " |", flush=True)


if __name__ == "__main__":
    main()
