"""Forward kinematics, frames and Jacobian against products of exponentials, elementary matrices and
finite differences.
"""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from oracles import elementary_pose, exponential_pose, pose_errors, shift, turn
from scipy.spatial.transform import Rotation

import dhlab as dh

angles = st.one_of(st.floats(-7, 7), st.sampled_from([0.0, np.pi / 2, -np.pi / 2, np.pi]))
lengths = st.one_of(st.floats(-2, 2), st.just(0.0))


@st.composite
def tables(draw, largest=8):
    n = draw(st.integers(1, largest))
    rows = [[draw(angles), draw(lengths), draw(lengths), draw(angles)] for _ in range(n)]
    joints = "".join(draw(st.sampled_from("RRP")) for _ in range(n))
    make = draw(st.sampled_from([dh.DHTable.standard, dh.DHTable.craig]))
    return make(rows, angle="rad", joints=joints)


@given(tables(), st.integers(0, 2**32 - 1))
def test_forward_is_the_product_of_exponentials(table, seed):
    q = np.random.default_rng(seed).uniform(-3, 3, len(table))
    position, angle = pose_errors(dh.Arm(table).forward(q), exponential_pose(table, q))
    assert position < 1e-12 * 40 and angle < 1e-12


@given(tables(), st.integers(0, 2**32 - 1))
def test_signs_base_and_tool_enter_where_they_belong(table, seed):
    rng = np.random.default_rng(seed)
    n = len(table)
    sign, q = rng.choice([-1, 1], n), rng.uniform(-3, 3, n)
    base, tool = (
        shift(rng.uniform(-1, 1, 3)) @ turn(rng.uniform(-1, 1, 3)),
        shift(rng.uniform(-1, 1, 3)) @ turn(rng.uniform(-1, 1, 3)),
    )
    arm = dh.Arm(table, base=base, tool=tool, sign=sign)
    assert np.allclose(arm.forward(q), base @ elementary_pose(table, q, sign) @ tool, atol=1e-12)
    frames = arm.frames(q)
    assert frames.shape == (n + 1, 4, 4) and np.array_equal(frames[0], base)
    assert np.allclose(frames[-1] @ tool, arm.forward(q), atol=1e-15)


@given(tables(), st.integers(0, 2**32 - 1))
def test_jacobian_is_the_derivative_of_the_pose(table, seed):
    rng = np.random.default_rng(seed)
    n = len(table)
    arm = dh.Arm(
        table,
        base=turn(rng.uniform(-2, 2, 3)),
        tool=shift(rng.uniform(-1, 1, 3)),
        sign=rng.choice([-1, 1], n),
    )
    q, h = rng.uniform(-3, 3, n), 1e-6
    J = arm.jacobian(q)
    for i in range(n):
        step = h * (np.arange(n) == i)
        after, before = arm.forward(q + step), arm.forward(q - step)
        v = (after[:3, 3] - before[:3, 3]) / (2 * h)
        omega = Rotation.from_matrix(after[:3, :3] @ before[:3, :3].T).as_rotvec() / (2 * h)
        assert np.allclose(J[:, i], [*v, *omega], atol=2e-8 * 10)


@pytest.mark.parametrize("shape", [(), (1,), (5,), (2, 3), (0,), (2, 0, 4)])
def test_any_leading_shape_is_a_batch(shape):
    for name in ("ur5e", "panda", "stanford"):
        arm = dh.load(name)
        q = np.random.default_rng(0).uniform(-1, 1, (*shape, len(arm)))
        poses, frames, J = arm.forward(q), arm.frames(q), arm.jacobian(q)
        assert (
            poses.shape == (*shape, 4, 4)
            and frames.shape == (*shape, len(arm) + 1, 4, 4)
            and J.shape == (*shape, 6, len(arm))
        )
        for index in np.ndindex(shape):
            assert np.allclose(
                poses[index], elementary_pose(arm.table, q[index]) @ arm.tool, atol=1e-12
            )
            assert np.allclose(J[index], arm.jacobian(q[index]), rtol=0, atol=1e-14)


def test_integers_and_lists_are_numbers_too():
    arm = dh.load("article-6r")
    assert np.array_equal(
        arm.forward([1, 0, 0, 0, 0, 0]), arm.forward(np.array([1.0, 0, 0, 0, 0, 0]))
    )


def test_the_articles_numbers():
    arm = dh.load("article-6r")
    zero, quarter = arm.forward([0] * 6), arm.forward(np.deg2rad([90, 0, 0, 0, 0, 0]))
    assert np.allclose(
        zero, [[1, 0, 0, 0.75], [0, 0, -1, -0.2], [0, 1, 0, 0.1], [0, 0, 0, 1]], atol=1e-15
    )
    assert np.allclose(quarter[:3, 3], [0.2, 0.75, 0.1], atol=1e-15)
    assert np.linalg.matrix_rank(arm.jacobian([0] * 6)) == 4
    wrist = dh.load("article-6r-wrist").forward([0] * 6)
    assert np.allclose(
        wrist, [[0, 0, 1, 0.85], [0, -1, 0, -0.1], [1, 0, 0, 0.1], [0, 0, 0, 1]], atol=1e-15
    )


@pytest.mark.parametrize(
    "q, words",
    [
        ([0] * 5, "found 5 values"),
        (0.5, "a single number"),
        ([0, 0, 0, np.nan, 0, 0], "joint 4 is NaN"),
        (["a"] * 6, "plain numbers"),
        ([[0] * 6, [0] * 5], "plain numbers"),
        ([1j] * 6, "plain numbers"),
        (None, "plain numbers"),
    ],
)
def test_a_wrong_q_is_one_plain_sentence(q, words):
    with pytest.raises(ValueError, match=words) as error:
        dh.load("ur5e").forward(q)
    assert "expected" in str(error.value) and "\n" not in str(error.value)
