"""Placing frames step by step: every valid choice passes and gives the same arm, every kind of
wrong one is refused under its own rule.

The valid choices are found here by least squares and singular vectors, and the arms are judged by
products of exponentials: no formula of the library is used.
"""

import warnings

import numpy as np
import pytest
from draws import few
from geometry_cases import (
    CALIBRATED,
    CHAINS,
    chain_axes,
    exponentials,
    pose_error,
    random_axes,
    read_chain,
)

import dhlab as dh
from dhlab.geometry.procedure.frames import NearlyParallelWarning
from dhlab.placing.board import Placement
from dhlab.transform import from_xyz_rpy, trans

X, Y, Z = np.eye(3)
O = np.zeros(3)
BOTH = pytest.mark.parametrize("convention", ["standard", "craig"])


# --- a learner who knows the rules ---


def feet(p, w, q, z):
    """The nearest points of two lines that are not parallel, by least squares."""
    s, t = np.linalg.lstsq(np.column_stack([w, -z]), q - p, rcond=None)[0]
    return p + s * w, q + t * z


def normal_to(*vectors, rng):
    """A random unit vector at right angles to these: from the null space."""
    *_, right = np.linalg.svd(np.atleast_2d(vectors))
    rank = np.linalg.matrix_rank(np.atleast_2d(vectors), tol=1e-9)
    v = right[rank:].T @ rng.normal(size=3 - rank)
    return v / np.linalg.norm(v)


class Learner:
    """Makes random valid choices; ``slip`` moves points and directions by as much as a hand may be
    off.
    """

    def __init__(self, axes, end, convention, rng, slip=0.0):
        self.task, self.axes, self.end, self.rng, self.slip = (
            Placement(axes, end, convention),
            axes,
            end,
            rng,
            slip,
        )
        self.standard, self.n = convention == "standard", len(axes)
        self.lines = {}

    def axis(self, i):
        """The joint axis that z_i must lie on, or None."""
        k = i + self.standard
        return self.axes[k - 1] if 1 <= k <= self.n else None

    def near(self, v, size=1.0):
        return v + self.slip * size * self.rng.uniform(-1, 1, 3)

    def solve(self):
        order = range(self.n + 1) if self.standard else range(self.n, -1, -1)
        for i in order:
            self.lay_z(i)
        for i in order:
            self.put_origin(i, self.lines.get(i - 1 if self.standard else i + 1))
        return self.task

    def lay_z(self, i):
        axis = self.axis(i)
        if axis is None:
            directions = [
                self.end[:3, 2],
                self.axes[-1 if self.standard else 0][1],
                self.rng.normal(size=3),
            ]
            z = directions[self.rng.integers(3)] * self.rng.choice([1, -1])
            point = None if self.rng.random() < 0.5 else self.rng.uniform(-0.5, 0.5, 3)
        else:
            z = axis[1] * self.rng.choice([1, -1]) * 10.0 ** self.rng.integers(-3, 4)
            point = (
                self.rng.uniform(-0.5, 0.5, 3)
                if axis[2] == "P" and self.rng.random() < 0.5
                else None
            )
            if axis[2] == "R" and self.rng.random() < 0.5:
                point = self.near(axis[0] + 0.3 * axis[1], self.task.reach)
        judgement = self.task.set_z(i, self.near(z / np.linalg.norm(z)) * np.linalg.norm(z), point)
        assert judgement, judgement
        z = self.task.z[i] if axis is None else axis[1] * np.sign(self.task.z[i] @ axis[1])
        p = axis[0] if axis is not None and axis[2] == "R" else point
        self.lines[i] = [p, z]

    def put_origin(self, i, other):
        p, z = self.lines[i]
        if other is None:
            o = self.rng.uniform(-0.5, 0.5, 3) if p is None else p + z * self.rng.uniform(-0.5, 0.5)
            x = normal_to(z, rng=self.rng)
        else:
            o, x = self.on_normal(*other, p, z)
        judgement = self.task.set_origin(i, self.near(o, self.task.reach))
        assert judgement, judgement
        self.lines[i] = [o if self.slip == 0 else self.task.o[i], z]
        if self.slip and other is not None and np.linalg.norm(np.cross(z, other[1])) < 1e-9:
            x = self.on_normal(*other, self.task.o[i], z, slide=False)[1]
        judgement = self.task.set_x(i, self.near(x * self.rng.choice([1, -1])))
        assert judgement, judgement

    def on_normal(self, p, w, q, z, slide=True):
        if np.linalg.norm(np.cross(w, z)) > 1e-9:
            x = normal_to(w, z, rng=self.rng)
            loose = p + x * self.rng.uniform(-0.4, 0.4) + w * self.rng.uniform(-0.4, 0.4)
            return (loose if q is None else feet(p, w, q, z)[1]), x
        o = (
            self.rng.uniform(-0.5, 0.5, 3)
            if q is None
            else q + z * self.rng.uniform(-0.5, 0.5) * slide
        )
        gap = o - p - w * ((o - p) @ w)
        return o, (
            gap / np.linalg.norm(gap) if np.linalg.norm(gap) > 1e-9 else normal_to(z, rng=self.rng)
        )


def solved(seed, convention, slip=0.0):
    rng = np.random.default_rng(seed)
    axes, end, cases = random_axes(rng)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", NearlyParallelWarning)
        return Learner(axes, end, convention, rng, slip).solve(), axes, end, cases


def error(arm, axes, end):
    q = np.vstack([np.zeros(len(axes)), np.random.default_rng(5).uniform(-3, 3, (12, len(axes)))])
    return max(pose_error(exponentials(axes, end, q), arm.forward(q)))


@pytest.mark.slow
@BOTH
def test_every_valid_choice_gives_the_arm(convention):
    """Sets of axes: skew, parallel, antiparallel, meeting, on one line, sliding; each solved by
    random valid choices.
    """
    met, signs = set(), set()
    for seed in few(range(200), 35):
        task, axes, end, cases = solved(seed, convention)
        arm = task.arm
        assert task.finished and arm.table.convention == convention
        size = max(1, np.abs(arm.table.rows[:, 1:3]).max())
        assert error(arm, axes, end) < 1e-11 * size, seed
        assert dh.equivalent(task.model, arm), seed
        met |= {*cases, *(axis[2] for axis in axes)}
        signs |= {*arm.sign}
    assert met >= {
        "skew",
        "parallel",
        "antiparallel",
        "intersecting",
        "coincident",
        "coincident, opposite",
        "R",
        "P",
    } and signs == {1.0, -1.0}


@pytest.mark.slow
@BOTH
@pytest.mark.parametrize(
    "n, letter, scale", [(1, None, 1), (2, None, 1), (5, "P", 1), (4, None, 1e-3), (4, None, 1e3)]
)
def test_short_sliding_tiny_and_huge_arms(convention, n, letter, scale):
    for seed in few(range(30), 10):
        rng = np.random.default_rng(seed)
        axes, end, _ = random_axes(rng, n)
        axes = [(scale * p, z, letter or own) for p, z, own in axes]
        end[:3, 3] *= scale
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", NearlyParallelWarning)
            arm = Learner(axes, end, convention, rng).solve().arm
        assert error(arm, axes, end) < 1e-11 * max(1, np.abs(arm.table.rows[:, 1:3]).max()), seed


@pytest.mark.slow
@BOTH
def test_a_hand_may_be_a_little_off_and_the_arm_is_exact(convention):
    for seed in few(range(60), 20):
        task, axes, end, _ = solved(seed, convention, slip=5e-4)
        assert error(task.arm, axes, end) < 1e-11 * max(
            1, np.abs(task.arm.table.rows[:, 1:3]).max()
        ), seed


def test_a_finished_frame_may_be_changed():
    """Turning a z or an x round keeps what still fits; the arm stays the same arm."""
    for seed in few(range(40), 15):
        task, axes, end, _ = solved(seed, "standard")
        for i in range(len(axes)):
            assert task.set_z(i, -task.z[i], task.o[i]) and task.set_x(i, -task.x[i])
        assert task.finished and error(task.arm, axes, end) < 1e-11 * max(
            1, np.abs(task.arm.table.rows[:, 1:3]).max()
        )


def choices_of(axes, end):
    """Frames placed by what ``choices`` offers, z as given."""
    task = Placement(axes, end)
    for i in range(len(axes) + 1):
        assert task.set_z(
            i, axes[i][1] if i < len(axes) else end[:3, 2], end[:3, 3] if i == len(axes) else None
        )
        found = task.choices(i)
        assert task.set_origin(i, found.origin if found.origin is not None else found.line[0])
        found = task.choices(i)
        assert task.set_x(
            i, found.x if found.x is not None else np.cross(task.z[i], [0.3, 0.5, 0.7])
        )
    return task


@pytest.mark.parametrize("path", CHAINS[:6], ids=lambda p: p.stem)
def test_real_arms_placed_by_what_choices_offers(path):
    axes, end = chain_axes(read_chain(path))
    task = choices_of(axes, end)
    assert dh.equivalent(task.model, task.arm) and error(task.arm, axes, end) < 1e-12


def test_nearly_parallel_axes_of_a_calibrated_arm():
    """The common normals of a real UR5 run away to hundreds of metres, and are taken all the
    same.
    """
    axes, T = [], np.eye(4)
    for theta, d, a, alpha in CALIBRATED:
        axes.append((T[:3, 3].copy(), T[:3, 2].copy(), "R"))
        T = T @ from_xyz_rpy([0, 0, d], [0, 0, theta]) @ from_xyz_rpy([a, 0, 0], [alpha, 0, 0])
    with pytest.warns(NearlyParallelWarning):
        arm = choices_of(axes, T).arm
    assert np.abs(arm.table.d).max() > 500 and error(arm, axes, T) < 1e-11


def broken(task, i, z, o, x):
    """How far frame i, as handed in, is from a row and from its axis (m + 1): right angles, the
    meeting of lines, z on its axis.
    """
    j = i - 1 if task.standard else i + 1
    off = abs(x @ z)
    k = task.joint(i)
    if k and task.axes[k - 1].letter == "R":
        off = max(off, np.linalg.norm(np.cross(o - task.axes[k - 1].p, task.axes[k - 1].z)))
    if j in task.o:
        off = max(off, abs(x @ task.z[j]), abs((o - task.o[j]) @ np.cross(x, task.z[j])))
    return off


@pytest.mark.slow
def test_nothing_wrong_passes_and_nothing_right_is_refused():
    """Random candidates for the origin and x of one frame, judged by the definition of a row."""
    counts = {True: 0, False: 0}
    for seed in few(range(150), 25):
        task, axes, _end, _ = solved(seed, "standard")
        rng = np.random.default_rng(seed)
        i = int(rng.integers(1, len(axes) + 1))
        assert task.set_z(i, task.z[i])  # a line that was free to choose is free again
        z, right_o, right_x = task.z[i], task.o[i].copy(), task.x[i].copy()
        for o in (right_o, right_o + 0.1 * z, task.o[i - 1], right_o + rng.normal(size=3)):
            for x in (
                right_x,
                -right_x,
                np.cross(right_x, z),
                z,
                task.x[i - 1],
                rng.normal(size=3),
            ):
                x = x / np.linalg.norm(x)
                off = broken(task, i, z, o, x)
                if 1e-9 < off < 0.03 * max(1, task.reach):
                    continue  # within what a hand may be off
                accepted = bool(task.set_origin(i, o)) and bool(task.set_x(i, x))
                assert accepted == (off <= 1e-9), (seed, i, off)
                counts[accepted] += 1
                assert task.set_origin(i, right_o) and task.set_x(i, right_x)
    assert counts[True] > 100 and counts[False] > 400


# --- wrong choices ---

# z0 up; z1 skew to it; z2 parallel to z1; z3 meets z2; z4 on one line with z3; joint 6 slides,
# parallel to nothing
AXES = [
    (O, Z),
    ([0.1, 0, 0.4], Y),
    ([0.5, 0, 0.4], Y),
    ([0.5, 0.2, 0.4], X),
    ([0.7, 0.2, 0.4], -X),
    ([0.7, 0.2, 0.4], [1, 2, 3], "P"),
]
END = from_xyz_rpy([0.9, 0.4, 0.7], [0.4, 0.5, 0.6])


def begun(upto):
    """Frames 0 … upto - 1 placed by hand, and every z."""
    task = Placement(AXES, END)
    points, xs = (
        [O, [0.1, 0, 0.4], [0.5, 0, 0.4], [0.5, 0.2, 0.4], [0.6, 0.2, 0.4]],
        [X, X, X, Z, Y],
    )
    for i, (_, z, *_letter) in enumerate(AXES):
        assert task.set_z(i, z)
    for i in range(upto):
        assert task.set_origin(i, points[i]) and task.set_x(i, xs[i])
    return task


def test_the_example_can_be_finished():
    task = begun(5)
    assert task.missing == ("z6", "o5", "x5", "o6", "x6") and not task.finished
    assert task.set_origin(5, [0.8, 0.2, 0.4]) and task.set_x(5, np.cross([1, 0, 0], [1, 2, 3]))
    assert (
        task.set_z(6, END[:3, 2], END[:3, 3])
        and task.set_origin(6, task.choices(6).origin)
        and task.set_x(6, task.choices(6).x)
    )
    assert dh.equivalent(task.model, task.arm) and len(task.arm.steps) == 21
    with pytest.raises(ValueError, match="18 steps left; the next is z1"):
        bare = Placement(AXES, END)
        assert bare.set_z(0, Z) and bare.set_origin(0, O) and bare.set_x(0, X)
        bare.arm


WRONG = [
    (
        "z-on-wrong-joint",
        0,
        lambda t: t.set_z(1, Z),
        "the axis of joint 1; in the standard convention z1 is the axis of joint 2",
    ),
    ("z-on-wrong-joint", 0, lambda t: t.set_z(2, Y, [0.1, 0, 0.4]), "the axis of joint 2"),
    ("z-on-wrong-joint", 0, lambda t: t.set_z(2, X), "the axis of joint 4"),
    ("z-beside-axis", 0, lambda t: t.set_z(1, Y, [0.2, 0, 0.4]), "0.1 m beside"),
    ("z-across-axis", 0, lambda t: t.set_z(3, Z), "turns about"),
    ("z-across-axis", 0, lambda t: t.set_z(5, [3, 0, -1]), "slides along"),
    ("z-not-along-axis", 0, lambda t: t.set_z(1, [0, 1, 0.3]), "17° away"),
    ("no-direction", 0, lambda t: t.set_z(1, O), "not all 0"),
    ("no-direction", 0, lambda t: t.set_z(1, [0, 1]), "three finite numbers"),
    ("no-point", 0, lambda t: t.set_z(1, Y, [0, np.inf, 0]), "three finite numbers"),
    ("order", 0, lambda t: Placement(AXES, END).set_origin(1, O), "z1 first"),
    ("order", 0, lambda t: t.set_x(1, X), "o1 first"),
    ("order", 5, lambda t: (t.set_z(6, Z), t.set_origin(6, O))[1], "o5 first"),
    (
        "origin-on-other-axis",
        1,
        lambda t: t.set_origin(1, [0, 0, 0.4]),
        "the foot of the common normal on z0",
    ),
    ("origin-on-other-axis", 1, lambda t: t.set_origin(1, [0, 0, 0.1]), "a point of z0"),
    ("origin-on-other-axis", 2, lambda t: t.set_origin(2, [0.1, 0.3, 0.4]), "a point of z1"),
    ("origin-off-z", 1, lambda t: t.set_origin(1, [0.1, 0, 0.7]), "0.3 m beside z1"),
    ("origin-off-z", 0, lambda t: t.set_origin(0, X), "1 m beside z0"),
    ("origin-not-at-foot", 1, lambda t: t.set_origin(1, [0.1, 0.2, 0.4]), "would miss z0"),
    (
        "origin-not-at-meeting",
        3,
        lambda t: t.set_origin(3, [0.6, 0.2, 0.4]),
        "at the meeting point",
    ),
    ("not-one-row", 5, lambda t: t.set_origin(5, [0.8, 0.3, 0.4]), "No single row leads here"),
    ("no-point", 1, lambda t: t.set_origin(1, "here"), "three finite numbers"),
    ("no-point", 1, lambda t: t.set_origin(1, [1, 2, np.nan]), "three finite numbers"),
    (
        "x-along-z",
        1,
        lambda t: (t.set_origin(1, [0.1, 0, 0.4]), t.set_x(1, Y))[1],
        "along z1 itself",
    ),
    (
        "x-not-across-z",
        1,
        lambda t: (t.set_origin(1, [0.1, 0, 0.4]), t.set_x(1, [1, 1, 0]))[1],
        "45°, not 90°",
    ),
    ("x-not-across-z", 0, lambda t: (t.set_origin(0, O), t.set_x(0, [1, 0, 1]))[1], "45°, not 90°"),
    (
        "x-not-across-other",
        1,
        lambda t: (t.set_origin(1, [0.1, 0, 0.4]), t.set_x(1, Z))[1],
        "not to z0",
    ),
    (
        "x-misses-other-axis",
        2,
        lambda t: (t.set_origin(2, [0.5, 0.3, 0.4]), t.set_x(2, Z))[1],
        "passes z1 by",
    ),
    (
        "x-in-plane",
        3,
        lambda t: (t.set_origin(3, [0.5, 0.2, 0.4]), t.set_x(3, Y))[1],
        "the plane of z2 and z3",
    ),
    (
        "x-in-plane",
        3,
        lambda t: (t.set_origin(3, [0.5, 0.2, 0.4]), t.set_x(3, [1, 1, 0]))[1],
        "z2 × z3 or against it",
    ),
    (
        "x-not-across-z",
        4,
        lambda t: (t.set_origin(4, [0.6, 0.2, 0.4]), t.set_x(4, [-1, 1, 0]))[1],
        "not 90°",
    ),
    ("no-direction", 1, lambda t: (t.set_origin(1, [0.1, 0, 0.4]), t.set_x(1, O))[1], "not all 0"),
    (
        "no-direction",
        1,
        lambda t: (t.set_origin(1, [0.1, 0, 0.4]), t.set_x(1, [np.nan, 0, 1]))[1],
        "three finite numbers",
    ),
    (
        "no-direction",
        1,
        lambda t: (t.set_origin(1, [0.1, 0, 0.4]), t.set_x(1, None))[1],
        "three finite numbers",
    ),
]


@pytest.mark.parametrize("rule, upto, step, words", WRONG)
def test_each_wrong_choice_is_refused_under_its_rule(rule, upto, step, words):
    task = begun(upto)
    before = task.missing
    judgement = step(task)
    assert not judgement and judgement.rule == rule and words in judgement.message
    assert (
        judgement.message.endswith(".")
        and " ".join(str(judgement).split()) == f"✗ {judgement.step}: {judgement.message}"
    )
    assert judgement.step in task.missing or (
        judgement.step in {"z1", "z2", "z3", "z5"} and task.missing == before
    )


def test_a_tool_that_one_row_does_not_reach():
    """The tool's own frame is not at the end of a row; its z axis is met at the foot of the common
    normal.
    """
    task = Placement(
        [(O, Z), ([0.3, 0, 0], Y)],
        trans([0.5, 0.1, 0.2]) @ from_xyz_rpy([0, 0, 0], [0.5, 0.2, 0.1]),
    )
    end = task.end
    for i, (z, o, x) in enumerate([(Z, O, X), (Y, [0.3, 0, 0], X)]):
        assert task.set_z(i, z) and task.set_origin(i, o) and task.set_x(i, x)
    assert task.set_z(2, end[:3, 2])
    refused = task.set_origin(2, end[:3, 3])
    assert refused.rule == "not-one-row" and "the tool" in refused.message
    foot = feet(np.array([0.3, 0, 0]), Y, end[:3, 3], end[:3, 2])[1]
    assert task.set_origin(2, foot) and task.set_x(2, np.cross(Y, end[:3, 2]))
    assert error(task.arm, [(O, Z, "R"), (np.array([0.3, 0, 0]), Y, "R")], end) < 1e-14


def test_craigs_frame_is_on_its_own_joint():
    task = Placement(AXES[:3], END, "craig")
    refused = task.set_z(1, Y)
    assert (
        refused.rule == "z-on-wrong-joint"
        and "in Craig's convention z1 is the axis of joint 1" in refused.message
    )
    assert task.set_z(1, Z) and task.set_z(2, Y) and task.joint(0) is None and task.joint(3) == 3
    refused = task.set_origin(1, [0.1, 0, 0.4])
    assert refused.rule == "origin-on-other-axis" and "on z2" in refused.message
    assert task.set_origin(1, [0, 0, 0.4])


def test_a_joint_taken_against_its_direction_counts_the_other_way():
    task = Placement([(O, Z), ([0.4, 0, 0], Z)], trans([0.7, 0, 0]))
    assert "sign is -1" in task.set_z(1, -Z).message
    for i, point in enumerate([O, [0.4, 0, 0], [0.7, 0, 0]]):
        assert (i == 1 or task.set_z(i, Z)) and task.set_origin(i, point) and task.set_x(i, X)
    assert task.arm.sign.tolist() == [1, -1] and dh.equivalent(task.arm, task.model)


def test_what_no_longer_fits_is_put_away():
    task = begun(5)
    assert task.set_origin(5, [0.8, 0.2, 0.4]) and task.set_x(5, np.cross([1, 0, 0], [1, 2, 3]))
    assert (
        task.set_z(6, Z, [0.8, 0.2, 0.9])
        and task.set_origin(6, task.choices(6).origin)
        and task.set_x(6, task.choices(6).x)
    )
    assert task.finished
    # the line of the sliding joint moves, so the last frame's place is no longer right
    assert task.set_origin(5, [0.9, 0.2, 0.4])
    assert (
        task.missing == ("o6", "x6") and 6 not in task.frames and "o6" not in " ".join(task.steps)
    )
    assert not task.set_origin(5, [5, 5, 5]) and task.o[5].tolist() == [0.9, 0.2, 0.4]


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: Placement([], np.eye(4)), "empty list"),
        (lambda: Placement([(O, Z)], np.eye(3)), "4×4 pose"),
        (lambda: Placement([(O, Z)], np.eye(4), "modified"), "craig"),
        (lambda: Placement([(O, Z)], np.eye(4)).set_z(2, Z), "a frame from 0 to 1, found 2"),
        (lambda: Placement([(O, Z)], np.eye(4)).set_x("0", Z), "a frame from 0 to 1"),
        (lambda: Placement([(O, Z)], np.eye(4)).choices(1), "depends on z1"),
    ],
)
def test_errors_are_sentences(call, words):
    with pytest.raises(ValueError, match=words) as caught:
        call()
    assert "\n" not in str(caught.value)
