"""Independent judges: URDF chains by their joint numbers, products of exponentials, tables as
elementary matrices. None of it uses dhlab.
"""

import json
from pathlib import Path

import numpy as np
from scipy.linalg import expm
from scipy.spatial.transform import Rotation

CHAINS = Path(__file__).parent / "data" / "chains"

# table, chain, offsets (deg) and signs that dh_facts found to be missing from the table, agreement
# in mm as dh_facts states it
AGREEING = [
    ("ur5e", "ur5e", 1e-4),
    ("ur3e", "ur3e", 1e-4),
    ("ur10e", "ur10e", 1e-4),
    ("ur5_cb", "ur5_cb", 1e-4),
    ("ur5_cb.rtb", "ur5_cb", 1e-4),
    ("ur10_cb", "ur10_cb", 1e-4),
    ("puma560.rtb_urdf_like", "puma560_rtb", 1e-3),
    ("panda", "panda", 1e-4),
    ("panda", "panda_pybullet", 1e-4),
    ("panda.rtb_tool", "panda_hand", 1e-4),
    ("panda.deluca_std", "panda", 1e-4),
    ("iiwa14", "iiwa14", 1.0),
    ("iiwa14.arte_cop_std", "iiwa14", 1.0),
    ("iiwa14", "iiwa_pybullet", 1e-4),
    ("kr6_r700", "kr6_r700", 1e-4),
    ("irb120", "irb120", 1e-4),
    ("ar4", "ar4_mk3", 4e-3),
    ("piper", "piper_2025", 0.15),
    ("xarm6", "xarm6", 5e-3),
    ("xarm6", "xarm6_pybullet", 5e-3),
]


def shift(xyz):
    T = np.eye(4)
    T[:3, 3] = xyz
    return T


def turn(vector):
    """A rotation vector as a 4×4 pose."""
    T = np.eye(4)
    T[:3, :3] = Rotation.from_rotvec(vector).as_matrix()
    return T


def chain_joints(name):
    """The joints of a stored URDF chain."""
    return json.loads((CHAINS / f"{name}.json").read_text())["joints"]


def chain_pose(joints, q):
    """The end pose of a URDF chain: origin (fixed-axis rpy), then the motion about or along the
    joint's axis.
    """
    T, moving = np.eye(4), iter(q)
    for joint in joints:
        T = T @ shift(joint["xyz"])
        T[:3, :3] = T[:3, :3] @ Rotation.from_euler("xyz", joint["rpy"]).as_matrix()
        if joint["type"] != "fixed":
            axis = np.array(joint["axis"]) / np.linalg.norm(joint["axis"])
            T = T @ (
                shift(axis * next(moving))
                if joint["type"] == "prismatic"
                else turn(axis * next(moving))
            )
    return T


def elementary_pose(table, q, sign=None):
    """The product of the four elementary matrices of every row of a DHTable, written out with
    scipy's rotations.
    """
    q = (np.asarray(q) * (1 if sign is None else sign))[: len(table.rows)]
    theta, d, a, alpha = np.transpose(table.rows)
    slides = np.array([letter == "P" for letter in table.joints], dtype=bool)
    z_moves, x_moves = np.zeros((2, len(table.rows), 4, 4))
    z_moves[:, :3, :3] = _turns(theta + np.where(slides, 0, q), [0, 0, 1])
    x_moves[:, :3, :3] = _turns(alpha, [1, 0, 0])
    z_moves[:, 2, 3], x_moves[:, 0, 3] = d + np.where(slides, q, 0), a
    z_moves[:, 3, 3] = x_moves[:, 3, 3] = 1
    T = np.eye(4)
    for z, x in zip(z_moves, x_moves):
        T = T @ (z @ x if table.convention == "standard" else x @ z)
    return T


def _turns(angles, axis):
    return Rotation.from_rotvec(np.outer(angles, axis)).as_matrix()


def exponential_pose(table, q):
    """The same by the product of exponentials: screw axes at q = 0, matrix exponentials of their
    twists, then the zero pose.

    Lynch and Park, Modern Robotics, section 4.1: T(q) = exp(S_1 q_1) … exp(S_n q_n) M.
    """
    n = len(table)
    before = [
        elementary_pose(_rows(table, 0, i), np.zeros(i)) if i else np.eye(4) for i in range(n + 1)
    ]
    T = np.eye(4)
    for i in range(n):
        A = before[i]
        if table.convention == "craig":
            alpha, a = table.alpha[i], table.a[i]
            A = A @ shift([a, 0, 0]) @ turn([alpha, 0, 0])
        z, p = A[:3, 2], A[:3, 3]
        omega, v = (np.zeros(3), z) if table.joints[i] == "P" else (z, np.cross(p, z))
        twist = np.zeros((4, 4))
        twist[:3, :3] = [
            [0, -omega[2], omega[1]],
            [omega[2], 0, -omega[0]],
            [-omega[1], omega[0], 0],
        ]
        twist[:3, 3] = v
        T = T @ expm(twist * q[i])
    return T @ before[n]


class _rows:
    """Rows i to j of a table, for ``elementary_pose``."""

    def __init__(self, table, i, j):
        self.rows, self.joints, self.convention = (
            table.rows[i:j],
            table.joints[i:j],
            table.convention,
        )


def fit_base_and_tool(model, judged):
    """Constant B and E with B · model · E = judged, from two batches of poses: rotations of the
    relative motions aligned, then least squares.
    """
    X = [np.linalg.inv(model[0]), np.linalg.inv(judged[0])]
    a = np.array([Rotation.from_matrix((T @ X[0])[:3, :3]).as_rotvec() for T in model[1:]])
    b = np.array([Rotation.from_matrix((T @ X[1])[:3, :3]).as_rotvec() for T in judged[1:]])
    keep = np.linalg.norm(a, axis=1) < 2.6  # near 180° a rotation vector's sign is not certain
    B = np.eye(4)
    B[:3, :3] = Rotation.align_vectors(b[keep], a[keep])[0].as_matrix()
    rows, right = [], []
    for T, U in zip(model[1:], judged[1:]):
        G, H = T @ X[0], U @ X[1]  # H B = B G: (R_H - 1) p_B = R_B p_G - p_H
        rows.append(H[:3, :3] - np.eye(3))
        right.append(B[:3, :3] @ G[:3, 3] - H[:3, 3])
    B[:3, 3] = np.linalg.lstsq(np.vstack(rows), np.hstack(right), rcond=1e-9)[0]
    for _ in range(50):
        # average over all poses, in turns, so that no pose carries the noise of published numbers
        E = _mean(np.linalg.inv(B @ model) @ judged)
        B = _mean(judged @ np.linalg.inv(model @ E))
    return B, E


def _mean(poses):
    T = shift(poses[:, :3, 3].mean(axis=0))
    T[:3, :3] = Rotation.from_matrix(poses[:, :3, :3]).mean().as_matrix()
    return T


def pose_errors(T, U):
    """Largest distance (m) and largest angle (rad) between two batches of poses; the angle from the
    skew part, good when tiny.
    """
    R = np.swapaxes(T[..., :3, :3], -1, -2) @ U[..., :3, :3]
    skew = (
        np.stack(
            [R[..., 2, 1] - R[..., 1, 2], R[..., 0, 2] - R[..., 2, 0], R[..., 1, 0] - R[..., 0, 1]],
            -1,
        )
        / 2
    )
    angle = np.arctan2(np.linalg.norm(skew, axis=-1), (np.trace(R, axis1=-2, axis2=-1) - 1) / 2)
    return np.linalg.norm(T[..., :3, 3] - U[..., :3, 3], axis=-1).max(), angle.max()


def chain_disagreement(arm, chain, seed=0, m=100):
    """Largest distance (m) and angle (rad) between an arm and a stored URDF chain over m random q,
    through the best constant base and tool.
    """
    q = np.random.default_rng(seed).uniform(-np.pi, np.pi, (m, len(arm)))
    joints = chain_joints(chain)
    judged = np.array([chain_pose(joints, row) for row in q])
    model = arm.forward(q)
    B, E = fit_base_and_tool(model, judged)
    return pose_errors(B @ model @ E, judged)


def whole_pose_and_jacobian(arm, q):
    """End pose and geometric Jacobian of an arm, base, tool, signs and coupling included: the
    product of elementary matrices and, by the product rule, its derivatives; ω from dR Rᵀ.
    """
    table, factors, generators, places = arm.table, [arm.base], [], []
    mixed = np.eye(len(table)) if arm.coupling is None else arm.coupling
    turned = mixed @ (arm.sign * np.asarray(q))
    for (theta, d, a, alpha), letter, value in zip(table.rows, table.joints, turned, strict=True):
        theta, d = (theta, d + value) if letter == "P" else (theta + value, d)
        x_moves = shift([a, 0, 0]) @ turn([alpha, 0, 0])
        z_moves = turn([0, 0, theta]) @ shift([0, 0, d])
        standard = table.convention == "standard"
        places.append(len(factors) + (not standard))
        factors += [z_moves, x_moves] if standard else [x_moves, z_moves]
        G = np.zeros((4, 4))
        if letter == "P":
            G[2, 3] = 1
        else:
            G[0, 1], G[1, 0] = -1, 1
        generators.append(G)
    factors.append(arm.tool)
    T, J = _multiplied(factors), np.empty((6, len(table)))
    for i, (G, k) in enumerate(zip(generators, places, strict=True)):
        dT = _multiplied([*factors[:k], G, *factors[k:]])
        W = dT[:3, :3] @ T[:3, :3].T
        J[:, i] = [*dT[:3, 3], W[2, 1], W[0, 2], W[1, 0]]
    return T, J @ mixed @ np.diag(arm.sign)  # by the counts of the controller: the chain rule


def _multiplied(factors):
    T = np.eye(4)
    for factor in factors:
        T = T @ factor
    return T
