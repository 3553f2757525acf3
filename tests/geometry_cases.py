"""Random arms, random rewritings, random true changes, URDF chains and judges for the tests and
benchmarks of the geometry room.
"""

import json
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab.geometry import freedoms
from dhlab.geometry.procedure import prismatic
from dhlab.transform import from_xyz_rpy, inverse, trans

CHAINS = sorted((Path(__file__).parent / "data" / "chains").glob("*.json"))
TURN = np.deg2rad([0, 0, 90, -90, 180, 45, 20])


# --- judges: nothing below this line uses a DH matrix ---


def pose_error(T, U):
    """Largest distance (m) and angle (rad) between two batches of poses."""
    D = inverse(T) @ U
    R = D[..., :3, :3]
    # sin(angle / 2), exact for small angles
    chord = np.linalg.norm(R - np.eye(3), axis=(-2, -1)) / np.sqrt(8)
    return (
        np.linalg.norm(T[..., :3, 3] - U[..., :3, 3], axis=-1).max(),
        2 * np.arcsin(np.clip(chord, 0, 1)).max(),
    )


def screw(p, z, letter, q):
    """The motion of one joint by q (m,): a turn about the line (p, z), or a slide along z; (m, 4,
    4).
    """
    z = np.asarray(z, dtype=float) / np.linalg.norm(z)
    T = np.tile(np.eye(4), (len(q), 1, 1))
    if letter == "P":
        T[:, :3, 3] = np.outer(q, z)
        return T
    R = Rotation.from_rotvec(np.outer(q, z)).as_matrix()
    T[:, :3, :3] = R
    T[:, :3, 3] = np.asarray(p) - R @ np.asarray(p)
    return T


def exponentials(axes, end, q):
    """Product of exponentials for axes (point, direction, letter) at the zero pose; q (m, n) -> (m,
    4, 4).
    """
    T = np.tile(np.eye(4), (len(q), 1, 1))
    for k, (p, z, letter) in enumerate(axes):
        T = T @ screw(p, z, letter, q[:, k])
    return T @ end


def read_chain(path):
    return json.loads(Path(path).read_text())


def chain_axes(chain):
    """Joint axes (point, direction, letter) at the zero pose and the end pose there, of a URDF
    chain.
    """
    T, axes = np.eye(4), []
    for joint in chain["joints"]:
        T = T @ from_xyz_rpy(joint["xyz"], joint["rpy"])
        if joint["type"] != "fixed":
            axes.append(
                (
                    T[:3, 3].copy(),
                    T[:3, :3] @ joint["axis"],
                    "P" if joint["type"] == "prismatic" else "R",
                )
            )
    return axes, T


def chain_poses(chain, q):
    """The URDF's own forward kinematics, joint by joint; q (m, n) -> (m, 4, 4)."""
    T, k = np.tile(np.eye(4), (len(q), 1, 1)), 0
    for joint in chain["joints"]:
        T = T @ from_xyz_rpy(joint["xyz"], joint["rpy"])
        if joint["type"] != "fixed":
            T = T @ screw(
                np.zeros(3), joint["axis"], "P" if joint["type"] == "prismatic" else "R", q[:, k]
            )
            k += 1
    return T


# --- random arms ---


def random_pose(rng, size=0.5):
    return from_xyz_rpy(rng.uniform(-size, size, 3), rng.uniform(-3, 3, 3))


def random_arm(rng, convention=None, joints=None):
    """3 to 7 joints, a third of the entries special (parallel, antiparallel, perpendicular,
    intersecting, coincident), some sliding.
    """
    n = rng.integers(3, 8)
    letters = joints or "".join(rng.choice(["R", "R", "R", "P"], n))
    n = len(letters)
    theta = np.where(rng.random(n) < 0.4, rng.choice(TURN, n), rng.uniform(-3, 3, n))
    alpha = np.where(rng.random(n) < 0.6, rng.choice(TURN, n), rng.uniform(-3, 3, n))
    d, a = (np.where(rng.random(n) < 0.4, 0.0, rng.uniform(-0.6, 0.6, n)) for _ in range(2))
    rows = np.column_stack([theta, d, a, alpha])
    make = {"standard": dh.DHTable.standard, "craig": dh.DHTable.craig}[
        convention or rng.choice(["standard", "craig"])
    ]
    return dh.Arm(
        make(rows, angle="rad", joints=letters),
        base=random_pose(rng),
        tool=random_pose(rng, 0.2),
        sign=rng.choice([1, -1], n),
    )


def random_axes(rng, n=None):
    """3 to 7 joint axes, each with a chance of standing specially to the one before; and an end
    pose.
    """
    axes = [(rng.uniform(-0.5, 0.5, 3), _direction(rng), rng.choice(["R", "R", "R", "P"]))]
    cases = []
    for _ in range((n or rng.integers(3, 8)) - 1):
        p, z, _letter = axes[-1]
        case = rng.choice(
            [
                "skew",
                "parallel",
                "antiparallel",
                "intersecting",
                "coincident",
                "coincident, opposite",
                "perpendicular",
            ]
        )
        across = np.cross(z, rng.normal(size=3))
        w = {
            "parallel": z,
            "antiparallel": -z,
            "coincident": z,
            "coincident, opposite": -z,
            "perpendicular": across / np.linalg.norm(across),
        }.get(case, _direction(rng))
        on_line = p + rng.uniform(-0.5, 0.5) * z
        q = (
            on_line
            if case.startswith(("intersecting", "coincident"))
            else rng.uniform(-0.5, 0.5, 3)
        )
        axes.append(
            (
                q + rng.uniform(-0.3, 0.3) * w,
                w * rng.uniform(0.5, 2),
                rng.choice(["R", "R", "R", "P"]),
            )
        )
        axes[-1] = (axes[-1][0], axes[-1][1] / np.linalg.norm(axes[-1][1]), axes[-1][2])
        cases.append(case)
    end = random_pose(rng)
    how = rng.integers(4)  # the tool: anywhere, along the last axis, on it, across it
    if how:
        end[:3, :3] = (
            _along(axes[-1][1], rng)
            if how < 3
            else _along(np.cross(axes[-1][1], [0.3, 0.5, 0.7]), rng)
        )
    if how == 2:
        end[:3, 3] = axes[-1][0] + 0.1 * axes[-1][1]
    return axes, end, cases


def _direction(rng):
    v = (
        np.eye(3)[rng.integers(3)] * rng.choice([1, -1])
        if rng.random() < 0.4
        else rng.normal(size=3)
    )
    return v / np.linalg.norm(v)


def _along(z, rng):
    z = z / np.linalg.norm(z)
    x = np.cross(z, rng.normal(size=3))
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(z, x), z])


# --- rewritings and true changes ---


def moves(arm, rng):
    """Every free move this arm has, as (kind, the arm after it), each with random amounts."""
    n, h, phi = len(arm), rng.uniform(-0.4, 0.4), rng.uniform(-3, 3)
    found = [
        ("base", lambda: freedoms.move_base(arm, phi, h)),
        ("tool", lambda: freedoms.move_tool(arm, phi, h)),
        (
            "convention",
            lambda: arm.to("craig" if arm.table.convention == "standard" else "standard"),
        ),
    ]
    for i in range(n + 1):
        found += [("flip-x", lambda i=i: arm.flip_x(i)), ("flip-z", lambda i=i: arm.flip_z(i))]
        found += [("slide", lambda i=i: arm.slide(i, h))] * 2 + [
            ("twist", lambda i=i: freedoms.twist(arm, i, phi))
        ] * 2
    found += [
        ("prismatic-shift", lambda k=k: prismatic.shift_prismatic(arm, k + 1, h))
        for k in np.flatnonzero(arm.table.prismatic)
    ] * 3
    return found


def random_move(arm, rng):
    """One free move: its kind and the arm after it. A move that this arm does not have is drawn
    again.
    """
    choices = moves(arm, rng)
    kinds = sorted({kind for kind, _ in choices})
    while True:
        kind = rng.choice(kinds)
        of_kind = [make for name, make in choices if name == kind]
        try:
            return kind, of_kind[rng.integers(len(of_kind))]()
        except ValueError:
            continue


def random_walk(arm, rng, steps=12):
    kinds = []
    for _ in range(steps):
        kind, arm = random_move(arm, rng)
        kinds.append(kind)
    return kinds, arm


def with_rows(arm, rows, sign=None, base=None, tool=None):
    t = arm.table
    theta, d, a, alpha = np.asarray(rows).T
    return dh.Arm(
        dh.DHTable(t.convention, theta, d, a, alpha, t.joints),
        base=arm.base if base is None else base,
        tool=arm.tool if tool is None else tool,
        sign=arm.sign if sign is None else sign,
    )


TRUE_CHANGES = ("theta", "d", "a", "alpha", "base", "tool", "sign")


def true_change(arm, rng, kind, size):
    """The arm with one entry changed by ``size`` (m or rad), or one joint counted the other way."""
    rows, i, size = arm.table.rows.copy(), rng.integers(len(arm)), size * rng.choice([1, -1])
    if kind in ("theta", "d", "a", "alpha"):
        rows[i, ("theta", "d", "a", "alpha").index(kind)] += size
        return with_rows(arm, rows)
    if kind == "sign":
        sign = arm.sign.copy()
        sign[i] *= -1
        return with_rows(arm, rows, sign=sign)
    xyz, rpy = np.zeros(3), np.zeros(3)
    (xyz if rng.random() < 0.5 else rpy)[rng.integers(3)] = size
    D = from_xyz_rpy(xyz, rpy)
    return (
        with_rows(arm, rows, base=arm.base @ D)
        if kind == "base"
        else with_rows(arm, rows, tool=D @ arm.tool)
    )


def sampled_difference(a, b, rng, base="fixed", tool="fixed", count=12):
    """Brute force: the largest difference of the poses (m + rad) over random q, up to a constant
    base or tool pose when that is free.
    """
    q = rng.uniform(-2, 2, (count, len(a)))
    T, U = a.forward(q), b.forward(q)
    if (base, tool) == ("free", "free"):
        # T_b = X T_a Y: what conjugation by X cannot change of T(q) T(q')^-1
        V, W = T @ inverse(T[0]), U @ inverse(U[0])
        V, W = (np.concatenate([m, m[1:] @ inverse(m[:-1])]) for m in (V, W))
        return np.abs(_invariants(V) - _invariants(W)).max()
    if base == "free":
        T, U = inverse(T[0]) @ T, inverse(U[0]) @ U
    if tool == "free":
        T, U = T @ inverse(T[0]), U @ inverse(U[0])
    return sum(pose_error(T, U))


def _invariants(T):
    """Of a rigid move, what no change of frame alters: cos(angle), and the shift along the axis
    times sin(angle).
    """
    R = T[..., :3, :3]
    w = np.stack(
        [R[..., 2, 1] - R[..., 1, 2], R[..., 0, 2] - R[..., 2, 0], R[..., 1, 0] - R[..., 0, 1]],
        axis=-1,
    )
    return np.stack([np.trace(R, axis1=-2, axis2=-1), (w * T[..., :3, 3]).sum(axis=-1)], axis=-1)


def shifted(arm, xyz):
    return with_rows(arm, arm.table.rows, base=trans(xyz) @ arm.base)


def incomplete_recipes(arm, i):
    """The negative controls: flips of frame i that leave something out; (name, arm) pairs, for a
    standard table.
    """
    rows, sign, pi = arm.table.rows, arm.sign, np.pi
    edits = {
        "flip X: only a": [(i - 1, 2, "-")],
        "flip X: a, theta_i, theta_i+1, not alpha": [(i - 1, 2, "-"), (i - 1, 0, pi), (i, 0, -pi)],
        "flip X: a, alpha, not the thetas": [(i - 1, 2, "-"), (i - 1, 3, "-")],
        "flip Z: only alpha_i": [(i - 1, 3, pi)],
        "flip Z: both alphas": [(i - 1, 3, pi), (i, 3, -pi)],
        "flip Z: all but the joint direction": [
            (i - 1, 3, pi),
            (i, 3, -pi),
            (i, 0, "-"),
            (i, 1, "-"),
        ],
    }
    for name, changes in edits.items():
        new = rows.copy()
        for row, column, how in changes:
            new[row, column] = -new[row, column] if how == "-" else new[row, column] + how
        yield name, with_rows(arm, new, sign=sign)


# --- published tables ---

# a factory-calibrated UR5: Universal_Robots_ROS_Driver issue 457 (theta, d, a, alpha)
CALIBRATED = np.transpose(
    [
        [
            -9.62699668632896e-06,
            -1.43707039992005,
            2.02543119975016,
            -0.588254688694989,
            4.13647390228702e-05,
            8.1737464953645e-06,
        ],
        [
            0.0888794492754001,
            574.241384579456,
            -507.363402098168,
            -66.7676839353205,
            0.0949734691141216,
            0.0825625014554953,
        ],
        [
            0.000279332356195598,
            -0.0566854832098269,
            -0.32646702272051,
            1.49388687216263e-05,
            2.23692592990586e-07,
            0,
        ],
        [
            1.57033858830411,
            -0.000733893428160216,
            0.00325607356326439,
            1.57040005185553,
            -1.57101000328584,
            0,
        ],
    ]
)

PUBLISHED = [  # what dh_facts, section 4, says of each pair
    ("panda.maker_mod", "panda.deluca_std", True, True, "in place of Craig's"),
    (
        "panda.maker_mod",
        "panda.rtb_tool",
        False,
        True,
        "only the end differs: 103 mm along z of the end and turned by 45°",
    ),
    ("puma560.corke_std", "puma560.craig_mod", False, False, "Joint 2"),
    ("puma560.craig_mod", "puma560.akb_mod", False, False, "The axis of joint 3 is 0.2 mm away"),
    ("puma560.corke_std", "puma560.akb_mod", False, False, "Joint 2"),
    ("ur5_cb.maker", "ur5_cb.rtb", False, True, "The axis of joint 2 is 0.3 mm away"),
    (
        "ur5_cb.maker",
        "ur5_cb.arte",
        False,
        False,
        "joint 2's zero moved by -90°, joint 4's zero moved by -90°",
    ),
    ("ur5_cb.maker", "ur5e", False, False, "The axis of joint 2 is 73.341 mm away"),
    (
        "piper.sdk_old",
        "piper.sdk_new",
        False,
        False,
        "joint 2's zero moved by 2°, joint 3's zero moved by -2°",
    ),
    ("iiwa14.kst_mod", "iiwa14.arte_std", False, False, "Joint 4 counts the other way"),
    ("iiwa14.kst_mod", "iiwa14.arte_cop_std", False, True, "only the end differs: 15 mm along -z"),
    ("iiwa14.arte_std", "iiwa14.arte_cop_std", False, False, "joint 4 counted the other way"),
]
