"""dhlab against other people's libraries and against URDF."""

import numpy as np
import pytest
from oracles import AGREEING, chain_disagreement, pose_errors

import dhlab as dh


@pytest.mark.parametrize("table, chain, millimetres", AGREEING)
def test_tables_agree_with_the_urdf(table, chain, millimetres):
    position, angle = chain_disagreement(dh.load(table), chain)
    assert position * 1e3 <= millimetres and np.rad2deg(angle) < 0.01


def test_the_upright_ur5_table_agrees_once_its_offsets_are_taken_off():
    arte = dh.load("ur5_cb.arte")
    q = np.random.default_rng(0).uniform(-3, 3, (50, 6))
    moved = dh.Arm(
        dh.DHTable.standard(
            arte.table.rows + np.outer(np.deg2rad([0, 90, 0, 90, 0, 0]), [1, 0, 0, 0]), angle="rad"
        )
    )
    from oracles import fit_base_and_tool

    model, judged = moved.forward(q), dh.load("ur5_cb").forward(q)
    B, E = fit_base_and_tool(model, judged)
    assert max(pose_errors(B @ model @ E, judged)) < 1e-9


def test_a_wrong_table_does_not_agree():
    position, _ = chain_disagreement(dh.load("ar4.maker_cpp_mod"), "ar4_mk3")
    assert position > 0.1


@pytest.mark.parametrize(
    "name", ["article-6r", "puma560", "panda.deluca_std", "stanford", "irb120"]
)
def test_roboticstoolbox(judge, name):
    rtb = judge("roboticstoolbox")
    arm = dh.load(name)
    links = [
        (
            rtb.PrismaticDH(theta=th, a=a, alpha=al, offset=d)
            if letter == "P"
            else rtb.RevoluteDH(d=d, a=a, alpha=al, offset=th)
        )
        for (th, d, a, al), letter in zip(arm.table.rows, arm.table.joints)
    ]
    robot = rtb.DHRobot(links)
    q = np.random.default_rng(1).uniform(-3, 3, (50, len(arm)))
    assert max(pose_errors(arm.forward(q), np.array([robot.fkine(row).A for row in q]))) < 1e-12
    assert np.allclose(arm.jacobian(q), [robot.jacob0(row) for row in q], atol=1e-12)


@pytest.mark.parametrize("name", ["panda", "xarm6", "piper", "kr6_r700"])
def test_roboticstoolbox_for_craig_tables(judge, name):
    rtb = judge("roboticstoolbox")
    arm = dh.load(name)
    robot = rtb.DHRobot(
        [rtb.RevoluteMDH(d=d, a=a, alpha=al, offset=th) for th, d, a, al in arm.table.rows]
    )
    q = np.random.default_rng(2).uniform(-3, 3, (50, len(arm)))
    assert (
        max(
            pose_errors(
                arm.forward(q), np.array([robot.fkine(row * arm.sign).A for row in q]) @ arm.tool
            )
        )
        < 1e-12
    )


def test_the_toolboxs_own_puma(judge):
    rtb = judge("roboticstoolbox")
    robot, arm = rtb.models.DH.Puma560(), dh.load("puma560")
    q = np.random.default_rng(3).uniform(-3, 3, (50, 6))
    assert max(pose_errors(arm.forward(q), np.array([robot.fkine(row).A for row in q]))) < 1e-12


@pytest.mark.parametrize("name", ["article-6r", "puma560", "panda", "stanford", "cobra600", "ar4"])
def test_pinocchio(judge, name):
    pin = judge("pinocchio")
    arm = dh.load(name)
    model, end = pinocchio_model(pin, arm)
    data = model.createData()
    for q in np.random.default_rng(4).uniform(-2, 2, (20, len(arm))):
        pin.computeJointJacobians(model, data, q)
        pin.updateFramePlacements(model, data)
        assert max(pose_errors(arm.forward(q), data.oMf[end].homogeneous)) < 1e-12
        J = pin.getFrameJacobian(model, data, end, pin.ReferenceFrame.LOCAL_WORLD_ALIGNED)
        assert np.allclose(arm.jacobian(q), J, atol=1e-12)


def pinocchio_model(pin, arm):
    """The arm as a pinocchio tree: a joint about (along) z at every row's axis, fixed placements
    between.
    """
    from oracles import shift, turn

    model, parent, placement = pin.Model(), 0, arm.base
    for i, ((theta, d, a, alpha), letter, sign) in enumerate(
        zip(arm.table.rows, arm.table.joints, arm.sign)
    ):
        x_moves, offset = (
            shift([a, 0, 0]) @ turn([alpha, 0, 0]),
            turn([0, 0, theta]) @ shift([0, 0, d]),
        )
        if arm.table.convention == "craig":
            placement = placement @ x_moves
        make = (
            pin.JointModelPrismaticUnaligned if letter == "P" else pin.JointModelRevoluteUnaligned
        )
        parent = model.addJoint(
            parent, make(np.array([0, 0, sign])), pin.SE3(placement), f"joint {i + 1}"
        )
        placement = offset if arm.table.convention == "craig" else offset @ x_moves
    end = model.addFrame(
        pin.Frame("end", parent, pin.SE3(placement @ arm.tool), pin.FrameType.OP_FRAME)
    )
    return model, end
