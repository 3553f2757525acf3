"""Arms of every kind for the tests of the fast paths, and the judge that they are held to: the
plain product, written with scipy's rotations, and its derivative.
"""

import numpy as np
from hypothesis import strategies as st
from oracles import elementary_pose, shift, turn

import dhlab as dh

angles = st.one_of(
    st.floats(-7, 7),
    st.sampled_from([0.0, np.pi / 2, -np.pi / 2, np.pi, -np.pi, 2 * np.pi, 1e-12, 1e-17]),
)
lengths = st.one_of(st.floats(-2, 2), st.just(0.0))


def random_pose(rng):
    return shift(rng.uniform(-1, 1, 3)) @ turn(rng.uniform(-2, 2, 3))


@st.composite
def arms(draw, largest=8, coupled=st.booleans()):
    """Both conventions, turning and sliding joints, signs, offsets, base and tool, coupling."""
    n = draw(st.integers(1, largest))
    rows = [[draw(angles), draw(lengths), draw(lengths), draw(angles)] for _ in range(n)]
    joints = "".join(draw(st.sampled_from("RRRP")) for _ in range(n))
    make = draw(st.sampled_from([dh.DHTable.standard, dh.DHTable.craig]))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    ends = {}
    if draw(st.booleans()):
        ends = {"base": random_pose(rng), "tool": random_pose(rng)}
    coupling = np.eye(n) + rng.uniform(-0.3, 0.3, (n, n)) if draw(coupled) else None
    sign = rng.choice([-1, 1], n)
    return dh.Arm(make(rows, angle="rad", joints=joints), sign=sign, coupling=coupling, **ends)


def values(arm, q):
    """What q makes of the joints, as the definition of an Arm says."""
    moved = arm.sign * q
    return moved if arm.coupling is None else arm.coupling @ moved


def judged_pose(arm, q):
    return arm.base @ elementary_pose(arm.table, values(arm, q)) @ arm.tool


def judged_jacobian(arm, q):
    """The derivative of the judged pose by a step in the complex plane would need complex
    rotations; a central difference is good to 1e-9.
    """
    h, columns = 1e-5, []
    for step in h * np.eye(len(arm)):
        after, before = judged_pose(arm, q + step), judged_pose(arm, q - step)
        spin = (after[:3, :3] - before[:3, :3]) @ judged_pose(arm, q)[:3, :3].T / (2 * h)
        v = (after[:3, 3] - before[:3, 3]) / (2 * h)
        columns.append([*v, spin[2, 1], spin[0, 2], spin[1, 0]])
    return np.array(columns).T


def fanuc():
    """Where motor 2 carries the linkage of joint 3 along: theta3 = q3 - q2."""
    coupling = np.eye(6)
    coupling[2, 1] = -1
    arm = dh.load("article-6r")
    limits = [(-2.0, 2.0)] * 6
    return dh.Arm(arm.table, coupling=coupling, limits=limits, name="parallelogram")
