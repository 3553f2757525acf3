"""Lesson 09: sheets and files against URDF chains that know no dhlab; right answers in several
dresses, wrong ones named; the post-test.
"""

import json
import re
import warnings
from itertools import permutations
from xml.etree import ElementTree

import numpy as np
import pytest
from draws import few, variants
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab.course import report
from dhlab.course.building import reading
from dhlab.course.exercises import exercises
from dhlab.course.exercises.answers09 import PIPER
from dhlab.course.exercises.sheet09 import six_axes
from dhlab.doctor.tables.rows import wrong_tables
from dhlab.formats.axisfile import AxisSheet
from dhlab.robots.examples import FOLDER, example
from dhlab.transform import from_xyz_rpy
from dhlab.view.explorer.placing import axes_of
from tests.oracles import CHAINS, chain_joints, chain_pose, elementary_pose

FILES = {"ur5e": "ur5e", "ar4": "ar4_mk3", "piper": "piper_2025"}


def craig_and_standard(variant=0):
    """The table of 09.7 in degrees and metres, and what it is in the standard convention."""
    craig = exercises()["09.7"].given(variant)["table"].rows * [180 / np.pi, 1, 1, 180 / np.pi]
    craig = craig.round(9)
    return craig, np.column_stack([craig[:, :2], np.vstack([craig[1:, 2:], [0, 0]])])


REPAIRED = [
    [0, 0.16977, 0, 0],
    [-90, 0, 0.0642, -90],
    [0, -0.007, 0.305, 0],
    [0, 0.22263, 0, -90],
    [0, 0, 0, 90],
    [180, 0.041, 0, -90],
]


def numbers(text):
    return [float(value) for value in text.split()]


@pytest.mark.parametrize("name, chain", FILES.items())
def test_the_urdf_files_are_their_sources_digit_for_digit(name, chain):
    stored, read = (
        chain_joints(chain),
        ElementTree.parse(example(f"{name}.urdf")).getroot().findall("joint"),
    )
    assert [joint.get("name") for joint in read] == [joint["name"] for joint in stored]
    for joint, wanted in zip(read, stored):
        origin, axis = joint.find("origin"), joint.find("axis")
        assert numbers(origin.get("xyz")) == [float(v) for v in wanted["xyz"]] and numbers(
            origin.get("rpy")
        ) == [float(v) for v in wanted["rpy"]]
        assert (axis is None and wanted["type"] == "fixed") or numbers(axis.get("xyz")) == [
            float(v) for v in wanted["axis"]
        ]
    source = json.loads((CHAINS / f"{chain}.json").read_text())
    about = (FOLDER / "README.md").read_text(encoding="utf-8")
    assert (
        source["version"][:8] in about
        and source["licence"].split()[0] in about
        and source["licence"] in example(f"{name}.urdf").read_text()
    )


@pytest.mark.parametrize("name, chain", FILES.items())
def test_the_urdf_files_read_as_their_chains(name, chain):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        arm = dh.read_urdf(example(f"{name}.urdf"))
    for q in np.random.default_rng(3).uniform(-3, 3, (20, 6)):
        np.testing.assert_allclose(arm.forward(q), chain_pose(chain_joints(chain), q), atol=1e-9)


def test_an_unknown_file_is_one_sentence():
    with pytest.raises(ValueError, match="expected one of ar4-measured.csv, ar4.urdf"):
        example("../robots/ur5e.yaml")


def test_the_pipers_sheet_is_the_arm():
    piper = exercises()["09.4"].right_arm()
    for q in np.random.default_rng(4).uniform(-2, 2, (20, 6)):
        wanted = chain_pose(
            chain_joints("piper_2025"), q
        )  # the file's own base and end, to its rounding of 0.1 mm
        assert (
            np.abs(piper.forward(q) - wanted)[:3, 3].max() < 3e-4
            and np.abs(piper.forward(q) - wanted)[:3, :3].max() < 1e-3
        )


def test_the_lessons_sheets_are_the_exercises():
    text = reading.sources(["09"])[0].read_text(encoding="utf-8")
    assert (
        "wrist = np.array([-34.52, 0, 205.36])" in text
        and "([-282.4, 0, 161.62], [0, 1, 0])" in text
    )
    np.testing.assert_allclose(PIPER[0][3][0], [-0.03452, 0, 0.20536])


def test_the_measured_poses_are_the_chain_with_the_stated_noise():
    q, poses = dh.read_poses(example("ar4-measured.csv"), 6, length="mm", angle="deg")
    table = dh.DHTable.craig(REPAIRED, angle="deg")
    model = np.array(
        [elementary_pose(table, row, sign=[-1, 1, 1, 1, 1, 1]) for row in q]
    )  # agrees with the chain within 4 µm (test above)
    off = poses[:, :3, 3] - model[:, :3, 3]
    turn = Rotation.from_matrix(poses[:, :3, :3] @ np.swapaxes(model[:, :3, :3], 1, 2)).as_rotvec()
    assert 0.3e-3 < off.std() < 0.8e-3 and np.abs(off).max() < 2e-3
    assert np.deg2rad(0.05) < turn.std() < np.deg2rad(0.2)
    assert (np.abs(np.sin(2 * q)) > np.sin(np.deg2rad(15))).all(), "no zeros and no right angles"


@pytest.mark.parametrize("variant", variants(12))
def test_the_ar4_passes_in_any_description(variant):
    exercise = exercises()["09.2"]
    given = exercise.given(variant)
    axes, end = six_axes(**given), given["end"]
    elsewhere = [([*np.add(point, np.multiply(0.3, z))], np.multiply(5, z)) for point, z in axes]
    right = [
        dh.assign_frames(axes, end=end),
        dh.assign_frames(elsewhere, end=end),
        dh.assign_frames(axes, end=end, convention="craig"),
        dh.assign_frames(axes, end=end, x_signs={3: -1}, z_signs={2: -1}),
    ]
    assert all(exercise.judge(arm, variant).status == "right" for arm in right)
    assert exercise.judge(dh.load("ar4"), variant).mistake == "another-model"
    flange_5 = [*axes[:4], (end[:3, 3], axes[4][1]), axes[5]]
    verdict = exercise.judge(dh.assign_frames(flange_5, end=end), variant)
    assert verdict.headline == "axis 5 goes through the flange"


@pytest.mark.parametrize("variant", variants(12))
def test_the_ar4_moves_as_its_sheet_says(variant):
    """The right arm, moved joint by joint: which way the hand goes, by plain geometry."""
    exercise = exercises()["09.2"]
    given, arm = exercise.given(variant), exercise.right_arm(variant)
    hand, flange = given["hand"], given["end"][:3, 3]
    small = 0.01 * np.eye(6)
    zero, *moved = (
        elementary_pose(arm.table, q, arm.sign) for q in np.vstack([0 * small[:1], small])
    )
    zero, *moved = (arm.base @ T @ arm.tool for T in (zero, *moved))
    np.testing.assert_allclose(zero, given["end"], atol=1e-9)
    (x, y, _), (a, b, _) = moved[0][:3, 3], flange
    assert b * x - a * y > 0, "joint 1 counts clockwise from above"
    rise = moved[4][2, 3] - flange[2]
    up = {"as the hand nods up": 1, "as the hand nods down": -1}[given["q5 grows"]]
    assert rise == pytest.approx(up * hand * np.sin(0.01))
    # who faces the flange looks along −x: y points to the right, z up
    thumb = moved[5][:3, :3] @ zero[:3, :3].T @ [0, 0, 1]
    left = {"anticlockwise": 1, "clockwise": -1}[given["q6 grows"]]
    assert -thumb[1] == pytest.approx(left * np.sin(0.01))
    np.testing.assert_allclose(moved[5][:3, 3], flange, atol=1e-9)


def test_lengths_and_senses_of_the_sheet_are_everybodys_own():
    sheets = [exercises()["09.2"].given(variant) for variant in range(40)]
    assert len({str(sheet["axes"]) for sheet in sheets}) > 35
    assert len({(sheet["q5 grows"], sheet["q6 grows"]) for sheet in sheets}) == 4


def test_the_piper_passes_in_any_description():
    axes, end = PIPER
    right = [
        dh.assign_frames(axes, end=end),
        dh.assign_frames(axes, end=end).to("craig"),
        dh.assign_frames(axes, end=end, x_signs={2: -1, 4: -1}),
        dh.assign_frames([(point, 2 * np.array(z)) for point, z in axes], end=end),
    ]
    assert all(exercises()["09.4"].judge(arm).status == "right" for arm in right)


@pytest.mark.slow
@pytest.mark.parametrize("key", ["09.2", "09.4"])
def test_wrong_axes_fail_and_are_named(key):
    exercise, seen, named = exercises()[key], 0, set()
    q = exercise.poses_at(0)
    for mistake, place, arm in exercise.mistakes(**exercise.given(0)):
        if np.allclose(arm.forward(q), exercise.right_arm().forward(q), atol=1e-9):
            continue
        verdict = exercise.judge(arm)
        assert (
            verdict.status == "wrong"
            and verdict.mistake is not None
            and "joint" not in verdict.headline[:5]
        ), (mistake, place)
        seen, named = seen + 1, named | {verdict.mistake}
    assert seen >= 25 and len(named) >= 5
    for stranger in (
        dh.load("ur5e"),
        dh.load("panda"),
        dh.DHTable.standard([[0, 0.1, 0, 0]], angle="deg"),
        "piper",
    ):
        assert exercise.judge(stranger).status == "wrong"


@pytest.mark.slow
@pytest.mark.parametrize(
    "key, right", [("09.3", REPAIRED), ("09.7", craig_and_standard()[1].tolist())]
)
def test_tables_pass_in_three_dresses_and_wrong_ones_are_named(key, right):
    exercise = exercises()[key]
    turned = [[theta + 360, d, a, alpha - 360] for theta, d, a, alpha in right]
    for rows in (
        right,
        np.array(right),
        turned,
        exercise.right_arm(),
        exercise.right_arm().flip_x(3),
    ):
        assert exercise.judge(rows).status == "right", rows
    q, seen = exercise.poses_at(0), 0
    for mistake, place, table in few(wrong_tables(exercise.right_arm().table), 60):
        wrong = dh.Arm(
            table,
            base=exercise.right_arm().base,
            tool=exercise.right_arm().tool,
            sign=exercise.right_arm().sign,
        )
        if np.allclose(wrong.forward(q), exercise.right_arm().forward(q), atol=1e-9):
            continue
        verdict, seen = exercise.judge(wrong), seen + 1
        by_number = "number" in verdict.headline
        assert verdict.status == "wrong" and (verdict.mistake or by_number), (mistake, place)
    assert seen >= 30


@pytest.mark.parametrize("alpha, mistake", [(90, "alpha-sign"), (180, None), (0, None)])
def test_the_repair_is_one_number(alpha, mistake):
    verdict = exercises()["09.3"].judge([*REPAIRED[:5], [180, 0.041, 0, alpha]])
    assert verdict.status == "wrong" and (mistake is None or verdict.mistake == mistake)


def test_the_doctor_finds_what_the_lesson_says_it_finds():
    q, poses = dh.read_poses(example("ar4-measured.csv"), 6, length="mm", angle="deg")
    for data in (poses, poses[:, :3, 3]):
        typed = dh.Arm(
            dh.DHTable.craig([*REPAIRED[:5], [180, 0.041, 0, 180]], angle="deg"),
            sign=[-1, 1, 1, 1, 1, 1],
        )
        finding = dh.diagnose(typed, q, data, noise=(0.0005, 0.002)).findings[0]
        assert (finding.joint, finding.parameter) == (6, "alpha") and "-90°" in finding.detail
    repaired = dh.Arm(dh.DHTable.craig(REPAIRED, angle="deg"), sign=[-1, 1, 1, 1, 1, 1])
    assert dh.diagnose(repaired, q, poses, noise=(0.0005, 0.002)).verdict == "agrees"


def test_one_order_of_the_work_and_every_other_is_named():
    exercise = exercises()["09.1"]
    for order in permutations("abcde"):
        verdict = exercise.judge(list(order))
        assert (verdict.status == "right") == ("".join(order) == "dbcae") and (
            verdict.status == "right" or verdict.mistake
        )
    assert (
        exercise.judge("dbcae").status
        == exercise.judge("d, b, c, a, e").status
        == exercise.judge(("D", "B", "C", "A", "E")).status
        == "right"
    )


@pytest.mark.parametrize("variant", variants(12))
def test_what_lies_between_two_axes_by_geometry(variant):
    exercise = exercises()["09.6"]
    table, joint = exercise.given(variant).values()
    rows = table.rows
    rows[:, 0] += np.linspace(0.3, 1.1, len(rows))

    class Upto:
        convention = "craig"

    poses = []
    for i in (joint, joint + 1):
        Upto.rows, Upto.joints = rows[:i], table.joints[:i]
        poses.append(elementary_pose(Upto, np.zeros(i)))
    (z, p), (w, o) = ((T[:3, 2], T[:3, 3]) for T in poses)
    normal = np.cross(z, w)
    by_geometry = [np.rad2deg(np.arccos(z @ w)), abs((o - p) @ normal) / np.linalg.norm(normal)]
    assert exercise.judge(by_geometry, variant).status == "right"
    assert (
        exercise.judge(tuple(by_geometry), variant).status
        == exercise.judge(np.array(by_geometry), variant).status
        == "right"
    )
    wrong = [
        by_geometry[::-1],
        [by_geometry[0], 0],
        [180 - by_geometry[0], by_geometry[1]],
        [0, 0],
        by_geometry[0],
        [np.deg2rad(by_geometry[0]), by_geometry[1]],
    ]
    assert all(exercise.judge(answer, variant).status == "wrong" for answer in wrong)


HALVES = [
    ("craig-rows-in-standard-matrix", "still Craig's rows", lambda craig, right: craig),
    (
        "a-alpha-from-previous-row",
        "move up",
        lambda craig, right: np.column_stack([craig[:, :2], np.vstack([[0, 0], craig[:-1, 2:]])]),
    ),
    (
        "conversion-incomplete",
        "a moved, α did not",
        lambda craig, right: np.column_stack([craig[:, :2], right[:, 2], craig[:, 3]]),
    ),
    (
        "conversion-incomplete",
        "α moved, a did not",
        lambda craig, right: np.column_stack([craig[:, :3], right[:, 3]]),
    ),
    ("conversion-incomplete", "last row", lambda craig, right: np.vstack([right[:-1], craig[-1]])),
    ("angle-unit", "radians", lambda craig, right: right * [np.pi / 180, 1, 1, np.pi / 180]),
]


def test_the_table_of_09_7_is_everybodys_own_and_of_the_kr6s_build():
    tables = [craig_and_standard(variant)[0] for variant in range(50)]
    assert len({str(rows) for rows in tables}) > 40
    kr6 = (dh.load("kr6_r700").table.rows * [180 / np.pi, 1, 1, 180 / np.pi]).round(9)
    for rows in tables:
        np.testing.assert_array_equal(rows[:, [0, 3]], kr6[:, [0, 3]])
        np.testing.assert_array_equal(rows[:, 1:3] != 0, kr6[:, 1:3] != 0)


def test_the_table_that_is_given_is_no_answer_to_09_7_nor_is_any_makers():
    exercise, kr6 = exercises()["09.7"], dh.load("kr6_r700")
    given = exercise.given(1)["table"]
    for answer in (given, dh.Arm(given), kr6, kr6.table, kr6.to("standard"), given.rows.tolist()):
        assert exercise.judge(answer, 1).status == "wrong"
    assert exercise.judge(dh.Arm(given).to("standard"), 1).status == "right"


@pytest.mark.parametrize("variant", [0, 2])
@pytest.mark.parametrize("mistake, words, made", HALVES, ids=[words for _, words, _ in HALVES])
def test_half_a_conversion_is_named(mistake, words, made, variant):
    rows = made(*craig_and_standard(variant))
    verdict = exercises()["09.7"].judge(rows.tolist(), variant)
    assert (
        verdict.mistake == mistake
        and words in verdict.headline
        and "DOWN" not in str(verdict)
        and "loop" not in str(verdict)
    )


@pytest.mark.parametrize("variant", [0, 2])
def test_the_bare_sheet_put_in_as_it_stands(variant):
    axes, end = PIPER
    as_it_stands = dh.assign_frames(
        [(np.multiply(1000, point), z) for point, z in axes],
        end=from_xyz_rpy(1000 * end[:3, 3], [0, 85, 0]),
    )
    verdict = exercises()["09.4"].judge(as_it_stands, variant)
    assert verdict.mistake == "length-unit" and "both units" in verdict.headline
    assert (
        "this is still the arm"
        in exercises()["09.3"].judge([*REPAIRED[:5], [180, 0.041, 0, 180]], variant).headline
    )


def test_a_letter_twice_in_the_order_of_the_work():
    assert exercises()["09.1"].judge(["d", "b", "c", "a", "a"]).headline == "a stands there twice"


def test_the_hands_arrow_by_a_step_along_it():
    exercise = exercises()["09.5"]
    T = exercise.given(2)["T"]
    arrow = (T @ [0, 0, 1, 1] - T @ [0, 0, 0, 1])[:3]
    assert all(
        exercise.judge(right, 2).status == "right"
        for right in (arrow, arrow.tolist(), tuple(arrow))
    )
    wrong = [
        T[2, :3],
        T[:3, 0],
        T[:3, 1],
        T[:3, 3],
        -arrow,
        np.linalg.inv(T)[:3, 3],
        T[0, :3],
        T[:3, :3] @ arrow,
        np.cross(arrow, [0, 0, 1]),
        [0, 0, 1],
        T,
        0.3,
    ]
    verdicts = [exercise.judge(answer, 2) for answer in wrong]
    assert (
        all(v.status == "wrong" for v in verdicts)
        and sum(v.mistake is not None for v in verdicts) == 6
    )


def test_the_wrong_program_is_no_attempt_until_it_is_changed():
    from dhlab.course.exercises.posttest09 import reversed_product

    exercise = exercises()["09.8"]
    assert exercise.judge(reversed_product).status == "not attempted"
    assert np.allclose(
        reversed_product([[0.3, 0.1, 0.2, 0.5]], [0.4]),
        exercise.answer(np.array([[0.3, 0.1, 0.2, 0.5]]), [0.4]),
    )


def test_the_flange_of_a_seven_axis_arm_hides_the_last_rows_angles():
    panda = dh.load("panda")
    q = np.random.default_rng(5).uniform(-2, 2, (12, 7))
    rows = panda.table.rows
    rows[6, 0] += 0.7
    turned = dh.Arm(dh.DHTable.craig(rows, angle="rad"), tool=panda.tool)
    np.testing.assert_allclose(turned.forward(q)[:, :3, 3], panda.forward(q)[:, :3, 3], atol=1e-12)
    assert np.abs(turned.forward(q) - panda.forward(q)).max() > 0.1


def test_the_post_test_is_on_arms_no_other_lesson_uses():
    others = "\n".join(
        path.read_text(encoding="utf-8")
        for path in reading.sources()
        if not path.name.startswith("09")
    )
    assert not re.search(r"kr6_r700|iiwa7", others)


def test_ur5es_sheet_is_the_makers_arm():
    text = reading.sources(["09"])[0].read_text(encoding="utf-8")
    cell = re.search(r"^axes = \[.*?\)\]", text, re.DOTALL | re.MULTILINE)[0]
    scope = {"dh": dh, "end": from_xyz_rpy([-0.8172, -0.2329, 0.0628], [np.pi / 2, 0, 0])}
    exec(cell, scope)
    assert dh.equivalent(dh.assign_frames(scope["axes"], end=scope["end"]), dh.load("ur5e"))


# --- any arm comes in by any door ---


def five_axes():
    """An arm of five axes as a sheet knows it: no limits."""
    return axes_of(dh.load("xarm5"))


def a_sheet(folder):
    axes, end = five_axes()
    AxisSheet(tuple(axes), end=end).save(folder / "mine.yaml")
    return "dh.load('mine.yaml')", None


def axes_by_hand(folder):
    return "dh.assign_frames(five_axes()[0], end=five_axes()[1])", None


def a_urdf(folder):
    (folder / "mine.urdf").write_text(example("ar4.urdf").read_text())
    return "dh.load('mine.urdf')", None


def a_table(folder):
    dh.Arm(dh.load("wx200").table).save(folder / "mine.csv")
    return "dh.load('mine.csv')", None


def a_file_of_poses(folder):
    """A sheet filled in with a tape, 4 mm."""
    arm = dh.load("so101")
    plan, rng = dh.doctor.protocol(arm), np.random.default_rng(2)
    points = 1000 * arm.forward(plan.q)[:, :3, 3] + rng.normal(0, 4, (len(plan.q), 3))
    head, names, *lines = plan.to_csv().splitlines()
    filled = [
        line.removesuffix(",,,") + "".join(f",{x:.0f}" for x in p) for line, p in zip(lines, points)
    ]
    (folder / "mine.csv").write_text("\n".join([head, names, *filled]))
    return (
        "dh.load('so101')",
        "my_q, my_poses = dh.read_poses('mine.csv', len(my_arm), length='mm', angle='deg')",
    )


@pytest.mark.slow
@pytest.mark.parametrize(
    "door",
    [a_sheet, axes_by_hand, a_urdf, a_table, a_file_of_poses],
    ids=lambda door: door.__name__,
)
def test_the_page_takes_an_arm_by_every_door(door, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    arm, poses = door(tmp_path)
    text = reading.sources(["09"])[0].read_text(encoding="utf-8")
    cell = re.search(r"^my_arm = .*?^page$", text, re.M | re.S)[0]
    cell = re.sub(r"(?<=^my_arm = ).*", lambda found: arm, cell, flags=re.M)
    cell = re.sub(
        r"^my_poses = .*",
        lambda found: poses or "my_poses = my_arm.forward(my_q)",
        cell,
        flags=re.M,
    )
    if poses:
        cell = cell.replace("noise=(0.0005, 0.002)", "noise=0.004")
    scope = {"dh": dh, "np": np, "example": example, "report": report, "five_axes": five_axes}
    exec(cell, scope)
    assert "agrees" in str(scope["page"])
    assert len(scope["my_arm"]) == scope["my_q"].shape[1] and len(scope["my_q"]) >= 8
