"""Circles against the figures of dh_facts.md section 2 (computed by other programs); offsets and
noise against those put in.
"""

import re

import numpy as np
import pytest
from draws import few

from dhlab import Arm, DHTable, load
from dhlab.measure import calibrate_offsets, fit_circles
from dhlab.measure.offsetmodel import OffsetModel
from dhlab.transform import from_xyz_rpy

ARTICLE = [
    [0, 0.1, 0, 90],
    [0, 0, 0.4, 0],
    [0, 0, 0.35, 0],
    [0, 0.1, 0, 90],
    [0, 0, 0, -90],
    [0, 0.1, 0, 0],
]
FIXED = np.array([0.3, 0.4, -0.7, 0.5, 0.9, 0.2])


@pytest.fixture(autouse=True)
def seeded():
    """Every test draws the same numbers, whichever ran before it."""
    global rng
    rng = np.random.default_rng(3)


def sweep(joint, m=25, low=-1.2, high=1.2, fixed=FIXED):
    q = np.tile(fixed, (m, 1))
    q[:, joint - 1] = np.linspace(low, high, m)
    return q


def article(changes=(), **kwargs):
    rows = np.array(ARTICLE, dtype=float)
    for i, column, value in changes:
        rows[i - 1, column] = value
    return Arm(DHTable.standard(rows, angle="deg"), **kwargs)


# row, column, value; then radius mm, axis deg, axis shift mm, height mm, phase deg, from
# dh_facts.md section 2 (None: not given)
FACTS = [
    ([(2, 2, 0.45)], 47.3, 0, 0, 0, 1.4),
    ([(1, 3, -90)], 0, 180, 0, -324, 39),
    ([(4, 3, -90)], 0, 0, 0, -124, 0),
    ([(1, 1, 0.2)], 0, 0, 100, 0, 0),
    ([(4, 1, -0.1)], 0, 0, 0, -200, 0),
    ([(1, 0, 10)], 0, 10, 28, -2.5, None),
    ([(2, 0, 10)], 0, 0, 0, 0, 10),
    ([(3, 0, 10)], 21, 0, 0, 0, 4.0),
    ([(4, 1, 0), (2, 1, 0.1)], 0, 0, 0, 0, 0),
]


@pytest.mark.parametrize("changes, radius, axis, shift, height, phase", FACTS, ids=str)
def test_joint_2_of_the_article_against_the_facts(changes, radius, axis, shift, height, phase):
    q = sweep(2)
    (circle,) = fit_circles(q, article(changes).forward(q), article()).circles
    found = circle.differs
    deg = 180 / np.pi
    expected = {
        "radius": (radius, 1000),
        "shift": (shift, 1000),
        "height": (height, 1000),
        "axis": (axis, deg),
        "phase": (phase, deg),
    }
    for name, (value, scale) in expected.items():
        if value is not None and not (axis == 180 and name == "height"):
            # which way up the height counts is not said there
            assert abs(found[name][0]) * scale == pytest.approx(
                abs(value), abs=1.2 if name == "height" else 0.6
            ), name


def test_joint_2_turned_round():
    q = sweep(2)
    (circle,) = fit_circles(q, article(sign=[1, -1, 1, 1, 1, 1]).forward(q), article()).circles
    assert (
        circle.differs["axis"][0] == pytest.approx(np.pi)
        and "turns the other way round" in circle.words
    )
    assert all(
        abs(circle.differs[name][0]) < 1e-9 for name in ("radius", "shift", "height", "phase")
    )


@pytest.mark.parametrize("name", ["article-6r", "ur5e", "panda", "irb120", "ar4", "iiwa14"])
@pytest.mark.parametrize("arc", [0.2, 2.0, 6.2])
def test_the_model_agrees_with_itself(name, arc):
    arm = load(name)
    q = np.vstack(
        [
            sweep(i, 12, -arc / 2, arc / 2, rng.uniform(-1, 1, len(arm)))
            for i in range(1, len(arm) + 1)
        ]
    )
    report = fit_circles(q, arm.forward(q)[:, :3, 3], arm)
    assert len(report.circles) == len(arm) and report.left_out == 0
    for circle in report.circles:
        assert circle.fault or "agrees" in circle.words
        assert all(abs(value) < 1e-7 for value, _ in circle.differs.values())


def test_words_name_the_place():
    def words(changes, joint, convention="standard"):
        q, model, true = sweep(joint), article(), article(changes)
        if convention == "craig":
            model, true = model.to("craig"), true.to("craig")
        return fit_circles(q, true.forward(q), model).circles[0].words

    assert "only the phase" in words([(2, 0, 10)], 2) and "zero offset of joint 2" in words(
        [(2, 0, 10)], 2
    )
    assert "look at the base and at the rows before joint 2" in words([(1, 1, 0.2)], 2)
    assert "look at row 2, at the rows behind it" in words([(2, 2, 0.45)], 2)
    assert "a and alpha of the rows up to 2" in words([(1, 1, 0.2)], 2, "craig")
    assert "agrees" in words([(4, 1, 0), (2, 1, 0.1)], 2)


def test_the_numbers_of_a_cell_stay_on_one_line_on_a_narrow_screen():
    q = np.vstack([sweep(4), sweep(6)])
    points = article().forward(q)[:, :3, 3] + 1e-4 * rng.normal(size=(len(q), 3))
    shown = fit_circles(q, points, article())._repr_html_()
    cells = re.findall(r"<td>(.*?)</td>", shown)
    assert any("±" in cell for cell in cells) and any(cell.count(".") == 3 for cell in cells)
    assert not [cell for cell in cells if " " in cell]


def test_joint_6_draws_no_circle_and_an_arc_proves_nothing():
    q = np.vstack([sweep(5), sweep(6)])
    points = article().forward(q)[:, :3, 3]
    for noise in (None, 1e-4):
        report = fit_circles(
            q, points + (noise or 0) * rng.normal(size=points.shape), article(), noise=noise
        )
        assert (
            "no circle to compare" in str(report)
            and "lies on the axis" in report.circles[1].words
            and not report.circles[0].fault
        )
        assert (
            "proves nothing about a table" in str(report)
            and "proves nothing" in report._repr_html_()
        )
    # no model, noise not told
    assert (
        "no circle"
        in fit_circles(q, points + 1e-4 * rng.normal(size=points.shape)).circles[1].words
    )


def test_every_table_draws_a_circle_but_a_coupled_joint_does_not():
    q = sweep(2)
    wild = Arm(DHTable.craig(rng.uniform(-1, 1, (6, 4)), angle="rad"))
    assert fit_circles(q, wild.forward(q)).circles[0].off_circle < 1e-12
    coupled = q.copy()
    coupled[:, 2] -= q[:, 1] / 2
    (circle,) = fit_circles(q, article().forward(coupled), article(), noise=1e-5).circles
    assert circle.off_circle > 3e-4 and "coupling" in circle.words


@pytest.mark.slow
def test_standard_deviations_of_circles_are_honest():
    q, model, noise = np.vstack([sweep(2, 30), sweep(3, 15, 0, 0.8)]), article(), 1e-4
    points, scores = model.forward(q)[:, :3, 3], []
    for _ in few(range(150), 75):
        for given in (noise, None):
            report = fit_circles(
                q, points + noise * rng.normal(size=points.shape), model, noise=given
            )
            scores.append(
                [
                    [
                        c.differs[k][0] / c.differs[k][1]
                        for k in ("height", "radius", "phase", "axis", "shift")
                    ]
                    for c in report.circles
                ]
            )
    rms = np.sqrt((np.array(scores) ** 2).mean(axis=0))
    assert (np.abs(rms - 1) < 0.2).all(), rms


def test_other_sweeps():
    arm = load("stanford")
    q = sweep(3, fixed=np.array([0.1, 0.2, 0.5, 0.3, 0.4, 0.5]))
    assert "slides" in fit_circles(q, arm.forward(q), arm).circles[0].words
    assert "straight line" in fit_circles(q, arm.forward(q)).circles[0].words
    q = np.vstack([sweep(2), [FIXED - 0.1, FIXED + 0.5], sweep(4), sweep(2, fixed=FIXED - 0.3)])
    report = fit_circles(q, article().forward(q), article())
    assert (
        [c.joint for c in report.circles] == [2, 4, 2]
        and report.left_out == 2
        and "2 measurements belong" in str(report)
    )
    shuffled = sweep(2)[rng.permutation(25)]
    assert (
        "agrees" in fit_circles(shuffled, article().forward(shuffled), article()).circles[0].words
    )
    degrees = np.rad2deg(sweep(2, low=-1.5, high=1.5))
    assert (
        "radians" in fit_circles(degrees, article().forward(np.deg2rad(degrees))).circles[0].words
    )
    assert (
        "arc is short"
        in fit_circles(sweep(2, low=0, high=0.3), article().forward(sweep(2, low=0, high=0.3)))
        .circles[0]
        .words
    )
    with pytest.raises(ValueError, match="one joint alone moves"):
        fit_circles(rng.uniform(-1, 1, (20, 6)), rng.uniform(-1, 1, (20, 3)))


@pytest.mark.parametrize("base", [False, True])
@pytest.mark.parametrize("tool", [False, True])
@pytest.mark.parametrize("full", [False, True])
def test_derivatives_of_the_offset_model(base, tool, full):
    arm, q = load("stanford"), rng.uniform(-2, 2, (5, 6))
    poses = arm.forward(q) if full else arm.forward(q)[:, :3, 3]
    model, weights, h = OffsetModel(arm, q, poses, base, tool), (0.7, 0.3), 1e-6
    x = rng.normal(0, 0.5, model.size)
    differences = [
        (model.residual(x + h * e, weights) - model.residual(x - h * e, weights)) / (2 * h)
        for e in np.eye(model.size)
    ]
    assert np.abs(model.jacobian(x, weights) - np.column_stack(differences)).max() < 1e-8


B, E = from_xyz_rpy([1, 2, 3], [0.3, 2, 1]), from_xyz_rpy([0.1, 0, 0.2], [0.1, 0.3, -2])
# data, base, tool -> joints of article-6r whose offset cannot be known
HIDDEN = [
    ("poses", "fixed", "fixed", {}),
    ("positions", "fixed", "fixed", {6: "does not show in positions"}),
    ("poses", "free", "fixed", {1: "where the base stands"}),
    ("poses", "fixed", "free", {6: "how the tool sits"}),
    ("poses", "free", "free", {1: "where the base stands", 6: "how the tool sits"}),
    ("positions", "free", "fixed", {1: "where the base stands", 6: "does not show"}),
    ("positions", "fixed", "free", {6: "how the tool sits"}),
]


@pytest.mark.parametrize("data, base, tool, hidden", HIDDEN, ids=str)
@pytest.mark.parametrize("trial", range(3))
def test_offsets_of_up_to_30_degrees_come_back(data, base, tool, hidden, trial):
    arm, q, wrong = article(), rng.uniform(-2.5, 2.5, (30, 6)), np.deg2rad(rng.uniform(-30, 30, 6))
    poses = (
        (B if base == "free" else np.eye(4))
        @ arm.forward(q + wrong)
        @ (E if tool == "free" else np.eye(4))
    )
    poses = poses if data == "poses" else poses[:, :3, 3]
    result = calibrate_offsets(arm, q, poses, base=base, tool=tool)
    seen = [i for i in range(6) if i + 1 not in hidden]
    assert (
        np.abs(result.offsets - wrong)[seen].max() < 1e-7
        and result.after.worst_position < 1e-7 < result.before.position
    )
    assert sorted(i for group in result.undetermined for i in group.joints) == sorted(hidden)
    for group in result.undetermined:
        assert (
            hidden[group.joints[0]] in group.words
            and np.isinf(result.sigma[group.joints[0] - 1])
            and result.offsets[group.joints[0] - 1] == 0
        )
        assert group.words in str(result) and "not determined" in str(result)
    end = result.arm.forward(q)
    assert np.abs((end if data == "poses" else end[:, :3, 3]) - poses).max() < 1e-7
    assert np.array_equal(result.arm.base, arm.base) == (base == "fixed")


@pytest.mark.parametrize("name", ["ur5e", "panda", "stanford", "ar4", "irb120"])
def test_offsets_of_other_arms(name):
    arm = load(name)
    n, slides = len(arm), arm.table.prismatic
    wrong = np.where(slides, 0.03, np.deg2rad(rng.uniform(-30, 30, n)))
    true = Arm(
        DHTable(
            arm.table.convention,
            arm.table.theta + np.where(slides, 0, wrong),
            arm.table.d + np.where(slides, wrong, 0),
            arm.table.a,
            arm.table.alpha,
            arm.table.joints,
        ),
        arm.base,
        arm.tool,
        sign=arm.sign,
    )
    q = rng.uniform(-2, 2, (25, n))
    result = calibrate_offsets(arm, q, true.forward(q))
    assert not result.undetermined and np.abs(result.offsets - wrong).max() < 1e-8
    assert np.abs(result.arm.table.rows - true.table.rows).max() < 1e-8


def test_far_offsets_come_back_without_whole_turns():
    arm = load("ur5e")
    for _ in range(15):
        q, wrong = rng.uniform(-2.5, 2.5, (6, 6)), np.deg2rad(rng.uniform(-90, 90, 6))
        result = calibrate_offsets(arm, q, arm.forward(q + wrong), noise=(1e-4, 1e-3))
        assert np.abs(result.offsets - wrong).max() < 1e-7


def test_joints_that_stay_together_cannot_be_told_apart():
    q = np.tile(FIXED, (20, 1))
    q[:, 0] = np.linspace(-2, 2, 20)  # only joint 1 moves: positions show the arm in one shape
    arm = article()
    result = calibrate_offsets(arm, q, arm.forward(q + [0.1, 0, 0, 0, 0, 0])[:, :3, 3])
    five, six = result.undetermined
    assert (
        five.joints == (1, 2, 3, 4, 5)
        and "cannot be told apart by positions" in five.words
        and six.joints == (6,)
    )
    q[:, 4] = rng.uniform(-2, 2, 20)
    result = calibrate_offsets(arm, q, arm.forward(q + np.deg2rad([5, 5, 5, 5, 5, 0]))[:, :3, 3])
    assert [group.joints for group in result.undetermined] == [(6,)]
    q[:, 4], q[:, 5] = FIXED[4], 0.0
    q[:, 3] = rng.uniform(-2, 2, 20)
    rows = np.array(ARTICLE, dtype=float)
    rows[3, 1] = rows[5, 1] = 0  # the point on axis 4: positions see joints 1, 2 and 3 alone
    wrist = Arm(DHTable.standard(rows, angle="deg"))
    result = calibrate_offsets(wrist, q, wrist.forward(q)[:, :3, 3])
    assert sorted(i for group in result.undetermined for i in group.joints) == [4, 5, 6]


@pytest.mark.slow
def test_noise_is_estimated_and_standard_deviations_are_honest():
    arm, wrong, scores, found = article(), np.deg2rad([4, -3, 2, 5, -6, 1]), [], []
    for trial in range(60):
        q = rng.uniform(-2, 2, (20, 6))
        poses = arm.forward(q + wrong)
        poses[:, :3, 3] += 1e-4 * rng.normal(size=(20, 3))
        poses[:, :3, :3] = (
            poses[:, :3, :3]
            @ from_xyz_rpy(np.zeros((20, 3)), 1e-3 * rng.normal(size=(20, 3)))[:, :3, :3]
        )
        result = calibrate_offsets(arm, q, poses, noise=None if trial % 2 else (1e-4, 1e-3))
        scores.append((result.offsets - wrong) / result.sigma)
        found.append(result.noise)
    assert np.abs(np.sqrt((np.array(scores) ** 2).mean(axis=0)) - 1).max() < 0.35
    assert np.abs(np.mean(found[1::2], axis=0) / (1e-4, 1e-3) - 1).max() < 0.1


def test_what_offsets_do_not_explain_is_said():
    arm, q = article(), rng.uniform(-2, 2, (20, 6))
    result = calibrate_offsets(arm, q, article([(2, 2, 0.45)]).forward(q), noise=(1e-4, 1e-3))
    assert (
        result.explained is False
        and "do not explain" in str(result)
        and "dhlab.diagnose" in result._repr_html_()
    )
    near = np.tile(FIXED, (8, 1)) + 0.002 * rng.normal(size=(8, 6))
    vague = calibrate_offsets(arm, near, arm.forward(near)[:, :3, 3], noise=1e-3)
    assert (
        any(group.vague and "only to about" in group.words for group in vague.undetermined)
        and vague.explained
    )
    assert repr(vague) == "<Calibration of 6 joints from 8 poses>"


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda a, q, T: calibrate_offsets("ur5e", q, T), "expected an Arm"),
        (
            lambda a, q, T: calibrate_offsets(a, q, T, base="loose"),
            'base: expected "fixed" or "free"',
        ),
        (lambda a, q, T: calibrate_offsets(a, q[:, :5], T), "q: expected one row of 6"),
        (lambda a, q, T: calibrate_offsets(a, q, T[:3]), r"expected \(9, 3\) positions"),
        (lambda a, q, T: calibrate_offsets(a, q, T * np.nan), "NaN"),
        (lambda a, q, T: calibrate_offsets(a, q, 2 * T), "row 1: expected a 4×4 pose"),
        (lambda a, q, T: calibrate_offsets(a, q, T, noise=1e-4), r"expected \(m, rad\)"),
        (lambda a, q, T: calibrate_offsets(a, q, T, noise=(1e-4, 0)), "above 0"),
        (lambda a, q, T: calibrate_offsets(a, q[:1], T[:1]), "expected more measurements"),
        (lambda a, q, T: fit_circles(q, T, "ur5e"), "expected an Arm or nothing"),
        (lambda a, q, T: fit_circles("q", T), "q: expected one row"),
        (lambda a, q, T: fit_circles(q, T, noise="small"), "noise"),
    ],
)
def test_what_is_refused_and_how(call, words):
    arm, q = article(), rng.uniform(-1, 1, (9, 6))
    with pytest.raises(ValueError, match=words) as error:
        call(arm, q, arm.forward(q))
    assert "\n" not in str(error.value)
