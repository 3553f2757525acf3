"""How exact the core is: every arm against its URDF, against other libraries, and against products
of exponentials; and how fast a batch is.

    python benchmarks/accuracy.py
"""

import sys
import timeit
from pathlib import Path

import numpy as np

import dhlab as dh

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))
from oracles import AGREEING, chain_disagreement, exponential_pose, pose_errors
from test_oracles import pinocchio_model


def urdf_table():
    """Largest error of every table against its URDF chain, 100 random q, through the best constant
    base and tool.
    """
    print("| table | URDF chain | position, mm | rotation, deg |\n|---|---|---|---|")
    for table, chain, _ in AGREEING:
        position, angle = chain_disagreement(dh.load(table), chain)
        print(f"| {table} | {chain} | {position * 1e3:.2g} | {np.rad2deg(angle):.2g} |")


def library_table():
    """Largest error against roboticstoolbox and pinocchio on the article's arm and the Puma, poses
    and Jacobians.
    """
    import pinocchio as pin
    import roboticstoolbox as rtb

    print("\n| arm | judge | position, m | rotation, rad | Jacobian |\n|---|---|---|---|---|")
    for name in ("article-6r", "puma560"):
        arm = dh.load(name)
        q = np.random.default_rng(0).uniform(-3, 3, (200, 6))
        robot = rtb.DHRobot(
            [rtb.RevoluteDH(d=d, a=a, alpha=al, offset=th) for th, d, a, al in arm.table.rows]
        )
        poses = np.array([robot.fkine(row).A for row in q])
        _row(name, "roboticstoolbox", arm, q, poses, np.array([robot.jacob0(row) for row in q]))
        model, end = pinocchio_model(pin, arm)
        poses, J = zip(*(_pinocchio(pin, model, end, row) for row in q))
        _row(name, "pinocchio", arm, q, np.array(poses), np.array(J))


def _row(name, judge, arm, q, poses, J):
    position, angle = pose_errors(arm.forward(q), poses)
    print(
        f"| {name} | {judge} | {position:.2g} | {angle:.2g} |"
        f" {np.abs(arm.jacobian(q) - J).max():.2g} |"
    )


def _pinocchio(pin, model, end, q):
    data = model.createData()
    pin.computeJointJacobians(model, data, q)
    pin.updateFramePlacements(model, data)
    return data.oMf[end].homogeneous, pin.getFrameJacobian(
        model, data, end, pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
    )


def exponential_table(trials=500):
    """Largest error of random tables, 1 to 8 joints of both kinds and conventions, against the
    product of exponentials.
    """
    rng, worst = np.random.default_rng(0), np.zeros(2)
    for _ in range(trials):
        n = int(rng.integers(1, 9))
        make = dh.DHTable.standard if rng.random() < 0.5 else dh.DHTable.craig
        table = make(
            rng.uniform(-2, 2, (n, 4)), angle="rad", joints="".join(rng.choice(["R", "P"], n))
        )
        q = rng.uniform(-3, 3, n)
        worst = np.maximum(worst, pose_errors(dh.Arm(table).forward(q), exponential_pose(table, q)))
    print(
        f"\n{trials} random tables against products of exponentials: {worst[0]:.2g} m,"
        f" {worst[1]:.2g} rad"
    )


def speed():
    """One call for 10,000 configurations against a loop of single calls and against
    roboticstoolbox, as ratios of this run.
    """
    import roboticstoolbox as rtb

    arm = dh.load("puma560")
    robot = rtb.DHRobot(
        [rtb.RevoluteDH(d=d, a=a, alpha=al, offset=th) for th, d, a, al in arm.table.rows]
    )
    q = np.random.default_rng(0).uniform(-3, 3, (10_000, 6))
    batch = min(timeit.repeat(lambda: arm.forward(q), number=1, repeat=5)) / len(q)
    single = (
        min(timeit.repeat(lambda: [arm.forward(row) for row in q[:500]], number=1, repeat=5)) / 500
    )
    other = (
        min(timeit.repeat(lambda: [robot.fkine(row) for row in q[:500]], number=1, repeat=5)) / 500
    )
    print(
        "\none pose in a batch : one pose alone : one of roboticstoolbox's = 1 :"
        f" {single / batch:.0f} : {other / batch:.0f}"
    )


if __name__ == "__main__":
    urdf_table()
    library_table()
    exponential_table()
    speed()
