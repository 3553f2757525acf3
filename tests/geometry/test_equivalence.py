"""When two tables are one arm, judged by brute-force poses and by what the published tables are
known to be.
"""

import contextlib

import numpy as np
import pytest
from draws import few
from geometry_cases import (
    CALIBRATED,
    PUBLISHED,
    TRUE_CHANGES,
    incomplete_recipes,
    moves,
    pose_error,
    random_arm,
    random_pose,
    random_walk,
    sampled_difference,
    shifted,
    true_change,
    with_rows,
)
from hypothesis import example, given
from hypothesis import strategies as st

import dhlab as dh
from dhlab.geometry import freedoms
from dhlab.geometry.differences import ANGLE
from dhlab.geometry.equivalence import equivalent
from dhlab.geometry.procedure import prismatic
from dhlab.geometry.procedure.frames import assign_frames
from dhlab.geometry.zeros import with_zeros
from dhlab.transform import rot_x, trans, trans_z

SEEDS = st.integers(0, 10**6)
FREE = pytest.mark.parametrize(
    "base, tool", [("fixed", "fixed"), ("fixed", "free"), ("free", "fixed"), ("free", "free")]
)


def freed(arm, rng, base, tool):
    """The arm on another base and with another tool, as far as these are free."""
    B = random_pose(rng) @ arm.base if base == "free" else arm.base
    E = arm.tool @ random_pose(rng) if tool == "free" else arm.tool
    return with_rows(arm, arm.table.rows, base=B, tool=E)


@FREE
@given(seed=SEEDS)
def test_twelve_free_moves_are_accepted(base, tool, seed):
    rng = np.random.default_rng(seed)
    arm = random_arm(rng)
    kinds, walked = random_walk(arm, rng)
    assert sampled_difference(arm, walked, rng) < 1e-11
    result = equivalent(arm, freed(walked, rng, base, tool), base=base, tool=tool)
    assert result and str(result).startswith("The same arm"), kinds


@pytest.mark.slow
@FREE
@given(seed=SEEDS)
@example(seed=212)
def test_one_true_change_is_rejected(base, tool, seed):
    """1e-6 m or rad in any entry; whether it shows when base or tool are free is for the sampled
    poses to say. What they show may be less than the tolerance: then either word is right.
    """
    rng = np.random.default_rng(seed)
    arm = random_arm(rng)
    _, walked = random_walk(arm, rng)
    for kind in TRUE_CHANGES:
        changed = true_change(walked, rng, kind, 1e-6)
        seen = sampled_difference(walked, changed, rng, base, tool)
        result = equivalent(arm, changed, base=base, tool=tool)
        if seen > 100 * ANGLE:
            assert not result, (kind, seen)
        elif (base, tool) != ("free", "free"):
            # with both free, the judge sees some changes only to second order: its silence proves
            # nothing
            assert result or seen > 1e-13, (kind, seen)
        assert seen > 1e-8 or (base, tool) != ("fixed", "fixed")
        assert result or result.reason in ("axis", "sense", "end")


def test_a_change_of_which_little_shows_is_rejected():
    """1e-6 m in an entry, nearly along a joint axis of a 0.3 m arm, so that 2e-10 m are left."""
    rng = np.random.Generator(np.random.PCG64(212))  # these numbers, under make fuzz too
    arm = random_arm(rng)
    _, walked = random_walk(arm, rng)
    changed = {kind: true_change(walked, rng, kind, 1e-6) for kind in ("theta", "d", "a")}["a"]
    assert 1e-10 < sampled_difference(walked, changed, rng, "fixed", "free") < 1e-9
    assert not equivalent(arm, changed, tool="free")


@pytest.mark.slow
@given(seed=SEEDS)
@example(seed=5078)  # all lengths are 0, and the base's are not
def test_every_single_move_keeps_the_pose_and_is_named(seed):
    rng = np.random.default_rng(seed)
    arm = random_arm(rng)
    for kind, make in moves(arm, rng):
        try:
            moved = make()
        except ValueError:
            assert kind in ("slide", "twist")
            continue
        q = rng.uniform(-2, 2, (8, len(arm)))
        assert max(pose_error(arm.forward(q), moved.forward(q))) < 1e-13
        for other in (moved, rounded(moved, rng)):
            result = equivalent(arm, other)
            assert result
            if kind in ("flip-x", "flip-z", "convention"):
                inner = [
                    c.kind
                    for c in result.differences
                    if c.joint not in (0, len(arm)) and c.kind not in ("base", "tool")
                ]
                assert inner in ([kind], []) and kind in [c.kind for c in result.differences]


def rounded(arm, rng):
    """The arm with base and tool off by up to 2 units in the last place, as on another machine."""
    base, tool = arm.base.copy(), arm.tool.copy()
    for T in (base, tool):
        T[:3] += np.spacing(T[:3]) * rng.integers(-2, 3, (3, 4))
    return with_rows(arm, arm.table.rows, base=base, tool=tool)


@given(seed=SEEDS)
def test_the_named_choices_lead_from_one_table_to_the_other(seed):
    """Slides, twists and flips made in the order told give table b, entry by entry, up to base and
    tool.
    """
    rng = np.random.default_rng(seed)
    arm = random_arm(rng, joints="R" * rng.integers(3, 8))
    walked = arm
    for _ in range(12):
        options = [
            make
            for kind, make in moves(walked, rng)
            if kind in ("flip-x", "flip-z", "slide", "twist")
        ]
        with contextlib.suppress(ValueError):
            walked = options[rng.integers(len(options))]()
    replayed = arm
    for c in equivalent(arm, walked).differences:
        step = {"slide": freedoms.slide, "twist": freedoms.twist}.get(c.kind)
        if step:
            replayed = step(replayed, c.joint, c.amount)
        elif c.kind in ("flip-x", "flip-z"):
            replayed = getattr(replayed, c.kind.replace("-", "_"))(c.joint)
    inner = slice(1, -1)  # rows 1 and n also hold what base and tool take up
    for column in ("theta", "alpha"):
        turn = getattr(replayed.table, column)[inner] - getattr(walked.table, column)[inner]
        np.testing.assert_allclose(np.exp(1j * turn), 1, atol=1e-6)
    for column in ("d", "a"):
        np.testing.assert_allclose(
            getattr(replayed.table, column)[inner], getattr(walked.table, column)[inner], atol=1e-7
        )
    np.testing.assert_array_equal(replayed.sign[inner], walked.sign[inner])


@pytest.mark.parametrize("seed", few(range(20), 8))
def test_incomplete_recipes_are_rejected(seed):
    rng = np.random.default_rng(seed)
    n = rng.integers(4, 8)
    arm = dh.Arm(
        dh.DHTable.standard(
            rng.uniform([-3, 0.1, 0.1, 0.3], [3, 0.5, 0.5, 1.3], (n, 4)), angle="rad"
        )
    )
    for name, wrong in incomplete_recipes(arm, rng.integers(1, n)):
        assert sampled_difference(arm, wrong, rng) > 1e-3
        assert not equivalent(arm, wrong), name


@pytest.mark.parametrize(
    "recipe", ["alpha4 left out of a flip with a4 = 0", "0.1 in rows 2 and 4", "alpha alone"]
)
def test_controls_on_the_articles_arm(recipe):
    arm = dh.load("article-6r")
    rows = arm.table.rows.copy()
    if recipe.startswith("alpha4"):
        rows[3, 0] += np.pi
        rows[4, 0] -= np.pi
    elif recipe.startswith("0.1"):
        rows[1, 1] = 0.1
    else:
        rows[3, 3] += np.pi
    assert not equivalent(arm, with_rows(arm, rows))


def test_every_split_of_d_over_parallel_axes_is_accepted():
    arm = dh.load("article-6r")
    for split in ([0, 0, 0.1], [0.1, 0, 0], [0, 0.1, 0], [0.138, -0.131, 0.093]):
        rows = arm.table.rows.copy()
        rows[1:4, 1] = split
        assert equivalent(arm, with_rows(arm, rows))


def test_words_of_the_free_choices():
    arm = dh.load("article-6r")
    both = equivalent(arm, arm.flip_x(2).slide(2, -0.1).slide(3, -0.1).slide(2, 0.2).slide(3, 0.2))
    assert (
        both.message
        == "The same arm: table b is table a with 0.1 m slid along the parallel axes 2-3-4 from row"
        " 4 to row 2, and x2 flipped (theta2, a2, alpha2, theta3)."
    )
    assert [(c.kind, c.joint) for c in both.differences] == [
        ("slide", 2),
        ("flip-x", 2),
        ("slide", 3),
    ]
    assert both.differences[0].amount == pytest.approx(0.1)
    z = equivalent(arm, arm.flip_z(3))
    assert [(c.kind, c.joint) for c in z.differences] == [
        ("flip-z", 3)
    ] and "joint 4 counts the other way" in str(z)
    craig = equivalent(arm, arm.to("craig"))
    assert [c.kind for c in craig.differences] == ["convention"] and "Craig's convention" in str(
        craig
    )
    assert equivalent(arm, arm).message == "The same arm, in the same table."
    assert equivalent(arm.table, arm.table)
    moved_base = equivalent(arm, freedoms.move_base(arm, 0.5, 0.1))
    assert moved_base.differences[0].kind == "base" and moved_base.differences[
        0
    ].amount == pytest.approx((0.1, 0.5))
    assert equivalent(arm, freedoms.move_tool(arm, 0.5, 0.1)).differences[0].kind == "tool"
    assert equivalent(arm, shifted(arm, [0, 0, 1]), base="free").differences[0].kind == "base"


def test_the_stanford_arms_prismatic_shift():
    table, moved = (
        dh.load("stanford.rtb_std"),
        prismatic.shift_prismatic(dh.load("stanford.rtb_std"), 3, 0.0203),
    )
    assert moved.table.a[2] == pytest.approx(0) and moved.table.d[1] == pytest.approx(0.1337)
    (choice,) = equivalent(table, moved).differences
    assert (choice.kind, choice.joint, choice.amount) == (
        "prismatic-shift",
        3,
        pytest.approx(0.0203),
    )


@pytest.mark.filterwarnings("ignore::dhlab.geometry.procedure.frames.NearlyParallelWarning")
@given(seed=SEEDS)
def test_a_sliding_axis_placed_anywhere_is_one_arm(seed):
    rng = np.random.default_rng(seed)
    axes = [
        (rng.uniform(-1, 1, 3), rng.normal(size=3), letter)
        for letter in rng.permutation(list("RRPPR"))
    ]
    end = random_pose(rng)
    one, other = (
        assign_frames(
            [(p if c == "R" else rng.uniform(-1, 1, 3), z, c) for p, z, c in axes],
            end=end,
            prismatic="given",
        )
        for _ in range(2)
    )
    result = equivalent(one, other)
    assert result and {c.joint for c in result.differences if c.kind == "prismatic-shift"} == {
        k for k, a in enumerate(axes, 1) if a[2] == "P"
    }


def test_words_of_true_differences():
    arm = dh.load("article-6r")

    def against(row, column, by, **keywords):
        rows = arm.table.rows.copy()
        rows[row, column] += by
        return equivalent(arm, with_rows(arm, rows), **keywords)

    turned = against(1, 3, np.deg2rad(12))
    assert (
        turned.joint == 3
        and turned.angle == pytest.approx(np.deg2rad(12))
        and "Joint 3's axis is turned by 12°" in str(turned)
    )
    away = against(2, 2, 0.007)
    assert (
        away.joint == 4
        and away.distance == pytest.approx(0.007)
        and "The axis of joint 4 is 7 mm away" in str(away)
    )
    end = against(5, 1, 0.1)
    assert (
        end.joint is None
        and end.reason == "end"
        and "only the end differs: 100 mm along z" in str(end)
    )
    assert "With tool free they are the same arm" in str(end)
    relative = against(2, 2, 0.007, base="free", tool="free")
    assert (
        relative.joint == 4
        and "357 mm" in str(relative)
        and relative.distance == pytest.approx(0.007)
    )
    reversed_3 = equivalent(arm, with_rows(arm, arm.table.rows, sign=[1, 1, -1, 1, 1, 1]))
    assert (
        reversed_3.reason == "sense"
        and reversed_3.joint == 3
        and "counts the other way" in str(reversed_3)
    )
    lifted = equivalent(arm, shifted(arm, [0, 0, 0.3]))
    # axis 1 is vertical: lifting it leaves it in place
    assert lifted.joint == 2 and "With base free they are the same arm" in str(lifted)
    zero = equivalent(arm, with_zeros(arm, [1] * 6, [0, 0.2, 0, 0, 0, 0]))
    assert "joint 2's zero moved by 11.4592°" in str(zero) and zero.zeros.offset[
        1
    ] == pytest.approx(0.2)


def test_unlike_joints_are_no_exception():
    arm = dh.load("article-6r")
    count = equivalent(arm, dh.load("panda"))
    assert (
        not count
        and count.reason == "count"
        and count.message == "Table a has 6 joints, table b 7 joints."
    )
    kind = equivalent(arm, dh.load("stanford"))
    assert not kind and kind.reason == "type" and kind.joint == 3


@pytest.mark.parametrize("one, other, fixed, free, words", PUBLISHED)
def test_published_pairs(one, other, fixed, free, words):
    a, b = dh.load(one), dh.load(other)
    result = equivalent(a, b)
    assert bool(result) == fixed and words in str(result)
    assert bool(equivalent(a, b, base="free", tool="free")) == free
    assert bool(equivalent(b, a)) == fixed


@pytest.mark.parametrize(
    "one, other",
    [
        ("ur5_cb.maker", "ur5_cb.arte"),
        ("piper.sdk_old", "piper.sdk_new"),
        ("iiwa14.kst_mod", "iiwa14.arte_std"),
    ],
)
def test_the_zeros_told_are_right(one, other):
    a, b = dh.load(one), dh.load(other)
    z = equivalent(a, b).zeros
    rng = np.random.default_rng(0)
    q = rng.uniform(-2, 2, (20, len(a)))
    T, U = a.forward(z.sign * q + z.offset), b.forward(q)
    if z.tool == "free":
        T, U = T @ np.linalg.inv(T[0]), U @ np.linalg.inv(U[0])
    assert max(pose_error(T, U)) < 1e-12


@given(seed=SEEDS)
def test_zeros_and_signs_are_found(seed):
    rng = np.random.default_rng(seed)
    n = rng.integers(4, 8)
    arm = dh.Arm(
        dh.DHTable.standard(
            rng.uniform([-3, 0.1, 0.1, 0.3], [3, 0.5, 0.5, 1.3], (n, 4)), angle="rad"
        )
    )
    sign, offset = rng.choice([1, 1, 1, -1], n), rng.uniform(-1, 1, n) * (rng.random(n) < 0.5)
    offset[1] = 0.5  # of the first and the last joint base and tool freedom say as much
    zeros = equivalent(arm, with_zeros(arm, sign, offset)).zeros
    np.testing.assert_array_equal(zeros.sign, sign)
    np.testing.assert_allclose(zeros.offset, offset, atol=1e-6)


R, P = "R", "P"
SPECIAL = {  # arms whose axes leave the common frame undetermined when base and tool are free
    "one joint": [([0, 0, 0], [0, 0, 1], R)],
    "one slide": [([0, 0, 0], [0, 0, 1], P)],
    "planar": [([k, 0, 0], [0, 0, 1], R) for k in (0, 0.4, 0.7)],
    "planar, turned over": [([k, 0, 0], [0, 0, s], R) for k, s in ((0, 1), (0.4, -1), (0.7, 1))],
    "one line": [([0, 0, k], [0, 0, 1], R) for k in (0, 0.4, 0.7)],
    "one point": [([0, 0, 0], z, R) for z in ([0, 0, 1], [0, 1, 0], [1, 1, 1])],
    "gantry": [([0, 0, 0], z, P) for z in ([1, 0, 0], [0, 1, 0], [0, 0, 1])],
    "one rail": [([0, 0, 0], [1, 0, 0], P)] * 3,
    "scara": [
        ([0, 0, 0], [0, 0, 1], R),
        ([0.4, 0, 0], [0, 0, 1], R),
        ([0.7, 0, 0], [0, 0, -1], P),
        ([0.7, 0, 0], [0, 0, -1], R),
    ],
    "cylindrical": [
        ([0, 0, 0], [0, 0, 1], R),
        ([0, 0, 0], [0, 0, 1], P),
        ([0, 0, 0], [1, 0, 0], P),
    ],
    "turn and parallel slides": [
        ([0, 0, 0], [0, 0, 1], R),
        ([0, 0, 0], [0, 0, 1], P),
        ([0.3, 0, 0], [0, 0, 1], R),
    ],
}


@FREE
@pytest.mark.parametrize("name", SPECIAL)
def test_special_arms_on_any_base(name, base, tool):
    rng = np.random.default_rng(len(name))
    for _ in few(range(5), 2):
        B = random_pose(rng)
        arm = shifted(assign_frames(SPECIAL[name], end=random_pose(rng)), [0, 0, 0])
        arm = with_rows(arm, arm.table.rows, base=B @ arm.base)
        _, walked = random_walk(arm, rng)
        assert equivalent(arm, freed(walked, rng, base, tool), base=base, tool=tool)


@pytest.mark.parametrize("name", ["planar", "scara", "one point"])
def test_special_arms_that_differ_on_a_free_base(name):
    axes = SPECIAL[name]
    arm = assign_frames(axes, end=np.eye(4))
    p, z, letter = axes[1]
    wider = [
        axes[0],
        (
            np.array(p) * 1.001,
            np.array(z) + np.array([0.001, 0, 0]) * (name == "one point"),
            letter,
        ),
        *axes[2:],
    ]
    other = assign_frames(wider, end=np.eye(4))
    for base in ("fixed", "free"):
        assert not equivalent(arm, other, base=base, tool="free")


def test_a_mirror_image_is_another_arm():
    rng = np.random.default_rng(3)
    axes = [(rng.uniform(-0.5, 0.5, 3), rng.normal(size=3)) for _ in range(5)]
    mirror = np.diag([1, 1, -1])
    arm, image = (
        assign_frames([(M @ p, M @ z * np.linalg.det(M)) for p, z in axes], end=np.eye(4))
        for M in (np.eye(3), mirror)
    )
    for tool in ("fixed", "free"):
        assert not equivalent(arm, image, base="free", tool=tool)


def test_small_large_and_faraway_arms():
    rng = np.random.default_rng(4)
    arm = random_arm(rng, "standard", "RRRRRR")
    for scale in (1e-3, 100):
        rows = arm.table.rows * [1, scale, scale, 1]
        sized = with_rows(arm, rows, base=np.eye(4), tool=np.eye(4))
        _, walked = random_walk(sized.flip_x(2).flip_z(3), rng, 0)
        assert equivalent(sized, walked)
        rows = rows.copy()
        rows[2, 1] += 1e-6 * max(1, scale)
        assert not equivalent(sized, with_rows(sized, rows))
    far = shifted(arm, [1000, 2000, 0])
    assert (
        equivalent(far, far.flip_x(2).flip_z(4))
        and equivalent(far, arm, base="free")
        and not equivalent(far, shifted(far, [1e-6, 0, 0]))
    )


def test_a_calibrated_table_with_lengths_of_574_m():
    arm = dh.Arm(dh.DHTable.standard(CALIBRATED, angle="rad"))
    assert equivalent(arm, arm.flip_x(2).flip_z(3).to("craig"))
    rows = CALIBRATED.copy()
    rows[1, 1] += 1e-6
    assert not equivalent(arm, with_rows(arm, rows))
    assert not equivalent(arm, dh.load("ur5_cb"))


def test_parts_that_base_and_tool_freedom_hide_are_free_only_then():
    arm = dh.load("article-6r")
    rows = arm.table.rows.copy()
    rows[0, 0] += 0.3
    rows[0, 1] += 0.2
    rows[5] += [0.1, 0.1, 0.1, 0.1]
    rows[5, 0] += 0.4
    changed = with_rows(arm, rows)
    assert equivalent(arm, changed, base="free", tool="free")
    assert not equivalent(arm, changed, base="free") and not equivalent(arm, changed, tool="free")


def test_tool_and_base_on_the_right_side():
    arm = dh.load("ur5e")
    tool, base = trans_z(0.1) @ rot_x(0.2), trans([1, 2, 3]) @ rot_x(0.4)
    with_tool, on_base = (
        with_rows(arm, arm.table.rows, tool=tool),
        with_rows(arm, arm.table.rows, base=base),
    )
    assert equivalent(arm, with_tool, tool="free") and not equivalent(arm, with_tool, base="free")
    assert equivalent(arm, on_base, base="free") and not equivalent(arm, on_base, tool="free")


def test_the_result_in_a_notebook_and_as_data():
    arm = dh.load("ur5e")
    html = equivalent(arm, arm.flip_x(2))._repr_html_()
    assert "The same arm" in html and "<li>x2 flipped" in html
    assert "Not the same arm" in equivalent(arm, dh.load("ur5_cb"))._repr_html_()


@pytest.mark.parametrize(
    "a, b, keywords, words",
    [
        ([[0, 0, 1, 0]], None, {}, "expected an Arm or a DHTable, found list"),
        (None, None, {}, "found NoneType"),
        (dh.load("ur5e"), dh.load("ur5e"), {"base": "loose"}, 'base: expected "fixed" or "free"'),
        (dh.load("ur5e"), dh.load("ur5e"), {"tool": True}, 'tool: expected "fixed" or "free"'),
    ],
)
def test_bad_input(a, b, keywords, words):
    with pytest.raises(ValueError, match=words):
        equivalent(a, b, **keywords)
