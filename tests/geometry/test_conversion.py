"""Standard ↔ Craig and the moves of an arm: the same pose for every q, judged by elementary
matrices written out here.
"""

import numpy as np
import pytest
from draws import few
from geometry_cases import pose_error, random_arm
from hypothesis import given
from hypothesis import strategies as st

import dhlab as dh
from dhlab.geometry import freedoms
from dhlab.geometry.conversion import to_convention
from dhlab.geometry.procedure import prismatic

SEEDS = st.integers(0, 10**6)


def by_hand(arm, q):
    """base · A_1 … A_n · tool from the four elementary moves in the order of the convention, one q
    at a time.
    """

    def turn(angle, axis):
        c, s = np.cos(angle), np.sin(angle)
        return np.array(
            [[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
            if axis == "z"
            else [[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]]
        )

    def shift(x, z):
        return np.array([[1, 0, 0, x], [0, 1, 0, 0], [0, 0, 1, z], [0, 0, 0, 1.0]])

    T = arm.base
    for (theta, d, a, alpha), s, letter, value in zip(
        arm.table.rows, arm.sign, arm.table.joints, q
    ):
        theta, d = (theta + s * value, d) if letter == "R" else (theta, d + s * value)
        about_z, about_x = turn(theta, "z") @ shift(0, d), shift(a, 0) @ turn(alpha, "x")
        T = T @ about_z @ about_x if arm.table.convention == "standard" else T @ about_x @ about_z
    return T @ arm.tool


@pytest.mark.parametrize("first, second", [("standard", "craig"), ("craig", "standard")])
@given(seed=SEEDS)
def test_both_ways_keep_every_pose(first, second, seed):
    rng = np.random.default_rng(seed)
    arm = random_arm(rng, first)
    other = arm.to(second)
    back = other.to(first)
    for q in rng.uniform(-2, 2, (5, len(arm))):
        assert max(pose_error(by_hand(arm, q), by_hand(other, q))) < 1e-13
        assert max(pose_error(by_hand(arm, q), by_hand(back, q))) < 1e-13
    assert other.table.convention == second and back.table.convention == first
    np.testing.assert_array_equal(other.table.theta, arm.table.theta)
    np.testing.assert_array_equal(other.table.d, arm.table.d)


@pytest.mark.parametrize("name", few(dh.robots(), 20))
def test_the_library_converts_both_ways(name):
    arm = dh.load(name)
    other = arm.to("craig" if arm.table.convention == "standard" else "standard")
    q = np.random.default_rng(0).uniform(-2, 2, (20, len(arm)))
    assert max(pose_error(arm.forward(q), other.forward(q))) < 1e-14 * 10
    assert (other.name, other.source, other.limits) == (arm.name, arm.source, arm.limits)
    np.testing.assert_array_equal(other.sign, arm.sign)


def test_the_panda_of_two_publishers_is_one_conversion():
    converted = dh.load("panda.maker_mod").to("standard").table.rows
    published = dh.load("panda.deluca_std").table.rows
    np.testing.assert_allclose(converted[:-1], published[:-1], atol=1e-15)


def test_the_same_convention_is_the_same_arm_and_a_table_may_be_given():
    arm = dh.load("ur5e")
    assert arm.to("standard") is arm
    assert to_convention(arm.table, "craig").table.convention == "craig"


@pytest.mark.parametrize("convention", ["modified", "", None, 3])
def test_an_unknown_convention(convention):
    with pytest.raises(ValueError, match='expected "standard" or "craig"'):
        dh.load("ur5e").to(convention)


@given(seed=SEEDS)
def test_moves_keep_every_pose(seed):
    rng = np.random.default_rng(seed)
    arm = random_arm(rng)
    i, q = rng.integers(0, len(arm) + 1), rng.uniform(-2, 2, len(arm))
    moved = [
        arm.flip_x(i),
        arm.flip_z(i),
        freedoms.move_base(arm, 0.3, 0.2),
        freedoms.move_tool(arm, 0.3, 0.2),
    ]
    moved += [
        prismatic.shift_prismatic(arm, k + 1, 0.2) for k in np.flatnonzero(arm.table.prismatic)
    ]
    for other in moved:
        assert max(pose_error(by_hand(arm, q), by_hand(other, q))) < 1e-13


@given(seed=SEEDS)
def test_two_flips_give_the_table_back(seed):
    rng = np.random.default_rng(seed)
    arm = random_arm(rng)
    i = rng.integers(0, len(arm) + 1)
    for flip in (freedoms.flip_x, freedoms.flip_z):
        twice = flip(flip(arm, i), i)
        np.testing.assert_allclose(twice.table.rows, arm.table.rows, atol=1e-15)
        np.testing.assert_array_equal(twice.sign, arm.sign)
        np.testing.assert_array_equal(twice.base, arm.base)


@pytest.mark.parametrize("convention", ["standard", "craig"])
def test_slide_and_twist(convention):
    make = getattr(dh.DHTable, convention)
    arm = dh.Arm(
        make(
            [
                [0.1, 0.2, 0.3, 180],
                [0.4, 0.5, 0, 180],
                [0.6, 0.7, 0, 0],
                [1, 0.2, 0.3, 90],
                [1, 0.1, 0.1, 70],
            ],
            angle="deg",
        )
    )
    q = np.array([0.3, 0.5, -0.7, 0.2, 1])
    slid = {i for i in range(6) if _stays(lambda i=i: arm.slide(i, 0.3), arm, q)}
    twisted = {i for i in range(6) if _stays(lambda i=i: freedoms.twist(arm, i, 0.3), arm, q)}
    assert slid == ({0, 1, 2, 3} if convention == "standard" else {0, 1, 2, 5})
    assert twisted == ({0, 2, 3} if convention == "standard" else {1, 2, 5})


def _stays(move, arm, q):
    try:
        moved = move()
    except ValueError:
        return False
    assert max(pose_error(by_hand(arm, q), by_hand(moved, q))) < 1e-14
    return True


@pytest.mark.parametrize(
    "move, words",
    [
        (lambda arm: arm.slide(1, 0.1), "alpha1 = 90° is neither 0° nor 180°"),
        (lambda arm: freedoms.twist(arm, 2, 0.1), "a2 = -0.425 m is not 0"),
        (lambda arm: arm.flip_x(7), "flip_x: expected a frame from 0 to 6, found 7"),
        (lambda arm: arm.flip_z(-1), "flip_z: expected a frame from 0 to 6"),
        (lambda arm: arm.flip_z(True), "flip_z: expected a frame"),
        (lambda arm: arm.slide("2", 0.1), "slide: expected a frame"),
        (lambda arm: prismatic.shift_prismatic(arm, 3, 0.1), "the joints of this arm are RRRRRR"),
    ],
)
def test_moves_that_do_not_exist(move, words):
    with pytest.raises(ValueError, match=words):
        move(dh.load("ur5e"))


def test_a_move_keeps_what_the_arm_carries():
    arm = dh.load("panda")
    for moved in (arm.flip_x(3), arm.flip_z(3), arm.to("standard")):
        assert (moved.name, moved.source, moved.limits) == (arm.name, arm.source, arm.limits)
