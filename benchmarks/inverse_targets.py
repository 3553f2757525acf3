"""Poses that an arm cannot reach, each with a proof that owes nothing to ``dhlab.inverse``."""

import numpy as np
from scipy.optimize import minimize_scalar

import dhlab as dh
from dhlab.transform import from_xyz_rpy, rot_x, rot_z, trans

ELBOWS = ["puma560", "irb120", "kr6_r700", "piper", "ar4", "article-6r-wrist"]
URS = ["ur3e", "ur5e", "ur10e", "ur5_cb", "ur10_cb"]


def random_rotation(rng):
    return from_xyz_rpy([0, 0, 0], rng.uniform(-np.pi, np.pi, 3))


def never_within_reach(rng, count):
    """Farther from the base than all links laid end to end, sliding joints run out as far as their
    limits let them, by 1 mm to 2 m.
    """
    cases, names = [], dh.robots()
    for k in range(count):
        arm = dh.load(names[k % len(names)])
        table = arm.table
        slides = sum(
            max(map(abs, pair))
            for pair, letter in zip(arm.limits or (), table.joints, strict=False)
            if letter == "P"
        )
        longest = np.hypot(table.a, table.d).sum() + slides + np.linalg.norm(arm.tool[:3, 3])
        far = longest + 10 ** rng.uniform(-3, 0.3)
        way = rng.normal(size=3)
        T = trans(arm.base[:3, 3] + far * way / np.linalg.norm(way)) @ random_rotation(rng)
        cases.append((arm, T, {"reach", "limits"} if slides else {"reach"}, None))
    return cases


def just_out_of_reach(rng, count):
    """The wrist centre of a stretched arm moved up to 1 cm further out, straight away from the
    shoulder: out of reach because only the elbow changes that distance, and it is at its greatest.

    Where axis 2 does not cross axis 1 the base could turn round; that brings the shoulder nearer
    only to what lies behind axis 1, and nothing does here.
    """
    cases = []
    while len(cases) < count:
        arm = dh.load(ELBOWS[len(cases) % len(ELBOWS)])
        q = rng.uniform(-np.pi, np.pi, 6)
        q[2] = stretched(arm)
        shoulder, z, centre, first, z1 = skeleton(arm, q)
        out = across(centre - shoulder, z)
        ahead = across(across(shoulder - first, z1), z)
        behind = np.linalg.norm(ahead) > 1e-9 and (ahead + across(out, z1)) @ ahead <= 0
        if behind:
            continue
        short = rng.uniform(1e-5, 1e-2)
        end = arm.forward(q)
        at = centre + short * out / np.linalg.norm(out)
        inside = end[:3, :3].T @ (centre - end[:3, 3])  # the wrist centre, seen from the end
        turn = random_rotation(rng)
        T = trans(at - turn[:3, :3] @ inside) @ turn
        cases.append((arm, T, {"reach", "orientation"}, short))
    return cases


def across(v, z):
    return v - z * (v @ z)


def skeleton(arm, q):
    """Axis 2 (point, direction), the wrist centre, axis 1 (point, direction)."""
    chain = arm.frames(q)
    axes = chain[:-1] if arm.table.convention == "standard" else chain[1:]
    lines = [(axes[i, :3, 3], axes[i, :3, 2]) for i in range(6)]
    (p, z), (first, z1) = lines[1], lines[0]
    (a, u), (b, v) = lines[4], lines[5]
    centre = a + u * (np.cross(b - a, v) @ np.cross(u, v))  # axes 5 and 6 cross at right angles
    return p, z, centre, first, z1


def stretched(arm):
    """The q3 that takes the wrist centre farthest from axis 2, whatever the other joints do."""

    def near(q3):
        p, z, centre, *_ = skeleton(arm, np.array([0, 0, q3, 0.1, 0.2, 0.3]))
        return -np.linalg.norm(across(centre - p, z))

    grid = np.linspace(-np.pi, np.pi, 721)
    best = grid[np.argmin([near(q3) for q3 in grid])]
    return minimize_scalar(
        near, bounds=(best - 0.02, best + 0.02), method="bounded", options={"xatol": 1e-14}
    ).x


def wrong_orientation(rng, count):
    """Positions within reach with an orientation that is not: a UR whose fifth axis would come
    nearer to the first than the wrist's offset d4 allows; a SCARA that would have to tilt its tool.
    """
    cases = []
    for k in range(count):
        if k % 6 == 5:
            arm = dh.load("cobra600")
            T = arm.forward(rng.uniform([-0.8, -1.5, 0.01, -3], [0.8, 1.5, 0.2, 3]))
            cases.append((arm, T @ rot_x(rng.uniform(0.01, 1.5)), {"orientation"}, None))
            continue
        arm = dh.load(URS[k % 6])
        d = arm.table.d
        radius = d[3] - rng.uniform(1e-4, 1e-2)
        turn = rot_z(rng.uniform(-np.pi, np.pi))
        height = d[0] + rng.uniform(0.3, 0.5) * -arm.table.a[1]
        level = rot_x(np.pi / 2)  # the tool axis lies level, and points away from axis 1
        T = turn @ trans([0, -radius - d[5], height]) @ level @ rot_z(rng.uniform(-np.pi, np.pi))
        cases.append((arm, arm.base @ T, {"orientation"}, None))
    return cases
