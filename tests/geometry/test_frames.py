"""Frames from joint axes, judged by products of exponentials and by URDF chains; no DH matrix is
used as a judge.
"""

import copy
import pickle
import warnings

import numpy as np
import pytest
from geometry_cases import (
    CALIBRATED,
    CHAINS,
    chain_axes,
    chain_poses,
    exponentials,
    pose_error,
    random_axes,
    read_chain,
)
from hypothesis import given
from hypothesis import strategies as st

import dhlab as dh
from dhlab.geometry.procedure.frames import NearlyParallelWarning, PlacedArm, assign_frames
from dhlab.transform import trans

X, Y, Z = np.eye(3)
O = np.zeros(3)
BOTH = pytest.mark.parametrize("convention", ["standard", "craig"])


def error(arm, axes, end, count=20, seed=0):
    """Against the product of exponentials, at q = 0 and at random q."""
    q = np.vstack(
        [np.zeros(len(axes)), np.random.default_rng(seed).uniform(-3, 3, (count, len(axes)))]
    )
    return max(pose_error(exponentials(axes, end, q), arm.forward(q)))


@BOTH
@pytest.mark.parametrize("path", CHAINS, ids=lambda p: p.stem)
def test_urdf_chains(path, convention):
    chain = read_chain(path)
    axes, end = chain_axes(chain)
    arm = assign_frames(axes, end=end, convention=convention)
    q = np.random.default_rng(1).uniform(-3, 3, (100, len(axes)))
    metres, radians = pose_error(chain_poses(chain, q), arm.forward(q))
    assert metres <= 1e-12 and radians <= 1e-12
    assert arm.table.convention == convention and not arm.warnings


@BOTH
@given(seed=st.integers(0, 10**6))
def test_random_axes_with_special_cases(convention, seed):
    axes, end, _ = random_axes(np.random.default_rng(seed))
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", NearlyParallelWarning)
        arm = assign_frames(axes, end=end, convention=convention)
    tolerance = 1e-12 * max(1, np.abs(arm.table.rows[:, 1:3]).max())
    assert error(arm, axes, end) < tolerance
    assert np.abs(arm.forward(np.zeros(len(axes))) - end).max() < tolerance


@BOTH
@given(seed=st.integers(0, 10**6), data=st.data())
def test_every_choice_gives_the_same_arm(convention, seed, data):
    rng = np.random.default_rng(seed)
    axes, end, _ = random_axes(rng)
    n = len(axes)
    choices = {
        "x_signs": {i: int(rng.choice([1, -1])) for i in range(n + 1)},
        "z_signs": {k: int(rng.choice([1, -1])) for k in range(1, n + 1)},
        "slides": {0: rng.uniform(-1, 1)},
        "x_along": {0: rng.normal(size=3)},
        "prismatic": data.draw(st.sampled_from(["auto", "previous", "next", "given"])),
    }
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", NearlyParallelWarning)
        arm = assign_frames(axes, end=end, convention=convention, **choices)
    assert error(arm, axes, end) < 1e-12 * max(1, np.abs(arm.table.rows[:, 1:3]).max())
    assert arm.sign.tolist() == [choices["z_signs"][k] for k in range(1, n + 1)]


@BOTH
def test_z_lies_on_the_joint_axes_and_x_on_the_common_normals(convention):
    axes, end = chain_axes(read_chain(CHAINS[0]))
    arm = assign_frames(axes, end=end, convention=convention)
    frames = arm.frames(np.zeros(6))
    first = 0 if convention == "standard" else 1
    for k, (p, z, _) in enumerate(axes):
        F = frames[k + first]
        np.testing.assert_allclose(F[:3, 2], z, atol=1e-12)
        np.testing.assert_allclose(np.cross(F[:3, 3] - p, z), 0, atol=1e-12)
    for k in range(1, 6):
        x = frames[k][:3, 0]
        assert abs(x @ axes[k - 1][1]) < 1e-12 and abs(x @ axes[k][1]) < 1e-12


def test_slides_and_x_along_do_what_they_say():
    axes = [(O, Z), (0.4 * X, Z), (0.4 * X, Z), (0.4 * X, Y)]
    end = trans([0.4, 0.2, 0])
    plain = assign_frames(axes, end=end)
    slid = assign_frames(axes, end=end, slides={1: 0.1}, x_along={2: [1, 1, 0]})
    assert plain.table.d[0] == 0 and slid.table.d[0] == pytest.approx(0.1)
    np.testing.assert_allclose(
        slid.frames([0] * 4)[2, :3, 0], np.array([1, 1, 0]) / np.sqrt(2), atol=1e-12
    )
    assert error(slid, [(*a, "R") for a in axes], end) < 1e-13


@BOTH
def test_a_slide_is_the_slide_of_the_arm(convention):
    axes, end = [(O, Z), (0.4 * X, -Z), (0.7 * X, Y)], trans([0.7, 0.2, 0])
    plain, slid = (
        assign_frames(axes, end=end, convention=convention),
        assign_frames(axes, end=end, convention=convention, slides={1: 0.1}),
    )
    np.testing.assert_allclose(plain.slide(1, 0.1).table.rows, slid.table.rows, atol=1e-14)


@BOTH
def test_flips_are_the_flips_of_the_arm(convention):
    axes, end = chain_axes(read_chain(CHAINS[3]))
    plain = assign_frames(axes, end=end, convention=convention)
    x_flipped = assign_frames(axes, end=end, convention=convention, x_signs={3: -1})
    np.testing.assert_allclose(
        np.cos(plain.flip_x(3).table.rows), np.cos(x_flipped.table.rows), atol=1e-12
    )
    np.testing.assert_allclose(
        np.sin(plain.flip_x(3).table.rows), np.sin(x_flipped.table.rows), atol=1e-12
    )


def test_steps_in_words():
    axes, end = chain_axes(read_chain(next(p for p in CHAINS if p.stem == "ur5e")))
    arm = assign_frames(axes, end=end)
    text = "\n".join(arm.steps)
    assert "z2 ∥ z1: the common normal is free; taken through o1, so d2 = 0" in text
    assert (
        "z0 and z1 meet" in text and "Row 6: theta6" in text and "arm.tool is the identity" in text
    )
    craig = "\n".join(assign_frames(axes, end=end, convention="craig").steps)
    assert "z3 ∥ z2: the common normal is free; taken through the foot of x1, so d2 = 0" in craig


@pytest.mark.parametrize(
    "second, word",
    [
        ((0.3 * X, Z), "z1 ∥ z0"),
        ((0.3 * X, -Z), "z1 ∥ -z0"),
        ((0.3 * Z, Z), "z1 lies on z0: "),
        ((0.3 * Z, -Z), "z1 lies on z0, the other way"),
        ((0.3 * Z, Y), "z0 and z1 meet"),
        ((0.3 * X, Y), "z0 and z1 are skew"),
        ((O, Y, "P"), "Joint 2 slides"),
    ],
)
def test_each_case_is_named_and_right(second, word):
    axes, end = [(O, Z), second, (0.5 * X + 0.1 * Y, [1, 2, 3])], trans([0.5, 0.1, 0.7])
    arm = assign_frames(axes, end=end)
    assert any(word in step for step in arm.steps)
    full = [(np.array(p), np.array(z), *(letter or ["R"])) for p, z, *letter in axes]
    assert error(arm, full, end) < 1e-14


def test_a_vertical_first_axis_needs_no_base():
    arm = assign_frames([([0, 0, 0.3], Z), ([0, 0, 0.3], Y)], end=trans([0.5, 0, 0.3]))
    np.testing.assert_array_equal(arm.base, np.eye(4))
    assert arm.table.d[0] == 0.3


@pytest.mark.parametrize("letters", ["P", "PP", "PPP", "RPP", "PPR", "PPPPRP"])
@BOTH
def test_sliding_joints_only(letters, convention):
    axes = [(O, (X, Y, Z, X + Y, Z, Y)[k], letter) for k, letter in enumerate(letters)]
    end = trans([0.1, 0.2, 0.3])
    for how in ("auto", "previous", "next", "given"):
        assert (
            error(assign_frames(axes, end=end, convention=convention, prismatic=how), axes, end)
            < 1e-14
        )


def test_the_place_of_a_sliding_axis_does_not_matter():
    here, there = (
        [(O, Z), (0.2 * Z, Y), (p, X, "P"), (0.6 * X + 0.2 * Z, X)]
        for p in ([0, 0, 0.2], [1, 2, 3])
    )
    assert assign_frames(here, end=trans([0.7, 0, 0.2])) == assign_frames(
        there, end=trans([0.7, 0, 0.2])
    )


def lines_of(rows):
    """Joint axes and end of a standard table, by four elementary moves per row written out."""
    T, axes = np.eye(4), []
    for theta, d, a, alpha in rows:
        axes.append((T[:3, 3].copy(), T[:3, 2].copy(), "R"))
        c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
        T = T @ np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
        T = T @ np.array([[1, 0, 0, a], [0, ca, -sa, 0], [0, sa, ca, 0], [0, 0, 0, 1]])
    return axes, T


def test_nearly_parallel_axes_of_a_calibrated_ur5():
    axes, end = lines_of(CALIBRATED)
    with pytest.warns(NearlyParallelWarning) as caught:
        arm = assign_frames(axes, end=end)
    assert "d2 = 574.24 m, d3 = -507.36 m" in str(caught[0].message) and "d4 = -66.77 m" in str(
        caught[1].message
    )
    np.testing.assert_allclose(np.abs(arm.table.d), np.abs(CALIBRATED[:, 1]), rtol=1e-9)
    assert error(arm, axes, end) < 1e-11
    assert (
        "parallel=" in str(caught[0].message)
        and arm.warnings[0] in arm.steps
        and str(caught[0].filename) == __file__
    )
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        snapped = assign_frames(axes, end=end, parallel=0.004)
    q = np.random.default_rng(2).uniform(-3, 3, (200, 6))
    assert np.abs(snapped.table.d).max() < 0.3
    # the warning says up to 5.5 mm
    assert 1e-3 < pose_error(exponentials(axes, end, q), snapped.forward(q))[0] < 5.5e-3


def test_axes_too_nearly_parallel_for_an_exact_table():
    axes = [(O, Z, "R"), (0.4 * X, np.array([1e-10, 0, 1]), "R"), (0.7 * X, Y, "R")]
    end = trans([0.7, 0.1, 0.2])
    with pytest.warns(NearlyParallelWarning, match="taken as parallel"):
        arm = assign_frames(axes, end=end)
    assert arm.table.alpha[0] == 0 and error(arm, axes, end) < 3e-10


@pytest.mark.parametrize("angle", [1e-3, 1e-5, 1e-7, 1e-8, 1e-9, 1e-11, 1e-13, 1e-15])
def test_nearly_parallel_costs_at_most_what_is_possible(angle):
    """The exact table loses eps / angle to rounding, the parallel one angle; the better of the two
    is taken.
    """
    axes = [
        (O, Z, "R"),
        (0.4 * X, np.array([angle, 0, 1]), "R"),
        (0.7 * X, np.array([0, 0, 1.0]), "R"),
        (0.7 * X, Y, "R"),
    ]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", NearlyParallelWarning)
        arm = assign_frames(axes, end=trans([0.7, 0.1, 0.2]))
    assert error(arm, axes, trans([0.7, 0.1, 0.2])) < max(1e-14, min(3 * angle, 5e-15 / angle))


def test_axes_that_cross_at_a_tiny_angle_are_exact():
    axes = [(O, Z, "R"), (0.3 * Z, np.array([0, 1e-7, 1]), "R"), (0.7 * X, Y, "R")]
    arm = assign_frames(axes, end=trans([0.7, 0.1, 0.2]))
    assert error(arm, axes, trans([0.7, 0.1, 0.2])) < 1e-12


def test_a_slight_tilt_of_the_tool_is_held_by_the_tool():
    end = trans([0.4, 0, 0.1])
    end[:3, :3] = [[1, 0, 0], [0, np.cos(1e-6), -np.sin(1e-6)], [0, np.sin(1e-6), np.cos(1e-6)]]
    axes = [(O, Y, "R"), (0.3 * X, Z, "R")]
    arm = assign_frames(axes, end=end)
    assert arm.table.alpha[-1] == 0 and error(arm, axes, end) < 1e-14 and not arm.warnings


def test_what_an_arm_carries_is_kept():
    arm = assign_frames(
        [(O, Z), (X, Z)], end=trans([2, 0, 0]), limits=[(-1, 1), None], name="two", source="here"
    )
    assert (arm.name, arm.source, arm.limits) == ("two", "here", ((-1.0, 1.0), None))
    for other in (pickle.loads(pickle.dumps(arm)), copy.deepcopy(arm)):
        assert (
            isinstance(other, PlacedArm)
            and other == arm
            and other.steps == arm.steps
            and hash(other) == hash(arm)
        )
    assert arm == dh.Arm(
        arm.table, base=arm.base, tool=arm.tool, limits=arm.limits
    ) and "two" in str(arm)
    with pytest.raises(AttributeError):
        arm.steps = ()


GOOD = [(O, Z), (X, Z)]


@pytest.mark.parametrize(
    "axes, keywords, words",
    [
        ([], {}, "empty list"),
        ("axes", {}, "found str"),
        ([(O, O)], {}, "joint 1: direction: expected a vector with a length"),
        ([(O, [0, 0, np.nan])], {}, "joint 1: direction: expected three finite numbers"),
        ([(O, Z), ([1, 2], Z)], {}, "joint 2: point: expected three finite numbers"),
        ([(O, Z), ("abc", Z)], {}, "joint 2: point"),
        ([(O, Z), ([[1], [2, 3]], Z)], {}, "joint 2: point"),
        ([(O,)], {}, "joint 1: expected"),
        ([(O, Z, "R", 1)], {}, "found 4 entries"),
        ([3.0], {}, "joint 1"),
        ([(O, Z, "S")], {}, "found 'S'"),
        (GOOD, {"end": np.eye(3)}, "end: expected a 4×4 pose"),
        (GOOD, {"end": np.diag([1, 1, -1, 1])}, "mirror"),
        (GOOD, {"convention": "modified"}, '"modified" is "craig" here'),
        (GOOD, {"x_signs": {5: -1}}, "expected numbers from 0 to 2"),
        (GOOD, {"z_signs": {0: -1}}, "expected numbers from 1 to 2"),
        (GOOD, {"x_signs": {1: 2}}, "expected 1 or -1"),
        (GOOD, {"x_signs": [1, -1]}, "expected a dict"),
        (GOOD, {"slides": {1: np.inf}}, "finite number"),
        ([(O, Z), (X, Y)], {"slides": {1: 0.1}}, "cannot slide"),
        (GOOD, {"x_along": {1: X}}, "x1 is not free"),
        (GOOD, {"prismatic": "last"}, "prismatic"),
        (GOOD, {"parallel": 10}, "radians"),
        (GOOD, {"parallel": "1 deg"}, "expected an angle in rad"),
    ],
)
def test_bad_input_is_one_plain_sentence(axes, keywords, words):
    with pytest.raises(ValueError) as caught:
        assign_frames(axes, **{"end": np.eye(4), **keywords})
    message = str(caught.value)
    assert words in message and message.startswith("assign_frames") and "\n" not in message


def test_long_and_short_directions():
    for scale in (1e-300, 1e300, 1):
        arm = assign_frames([(O, scale * Z), (X, scale * np.array([0, 1, 0]))], end=np.eye(4))
        np.testing.assert_allclose(abs(arm.table.alpha[0]), np.pi / 2)
