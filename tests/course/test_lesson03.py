"""Lesson 03: right answers in several forms pass, wrong ones fail by name, and what the lesson says
of published tables is true.
"""

import re
from itertools import permutations, product

import numpy as np
import pytest
from draws import few, variants
from oracles import elementary_pose, shift, turn
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab.course.building import reading
from dhlab.course.exercises import exercises
from dhlab.doctor import catalogue
from dhlab.doctor.programs.wrong.craig import MOVES as CRAIG_MOVES
from dhlab.doctor.programs.wrong.craig import in_order
from dhlab.doctor.tables.rows import wrong_tables

VARIANTS = variants(20)
EXERCISES = {key: e for key, e in exercises().items() if key.startswith("03.")}
MOVES = {
    "a": turn([0, 0, 0.3]),
    "b": shift([0, 0, 0.2]),
    "c": shift([0.4, 0, 0]),
    "d": turn([0.5, 0, 0]),
}
ARTICLE = dh.load("article-6r")
Q = np.random.default_rng(3).uniform(0.3, 1.2, (4, 7)) * [1, -1, 1, -1, 1, -1, 1]


def fails_by_name(key, answers, variant=0):
    """How many of the answers are refused, and how many of these with a mistake of the catalogue;
    right ones must not be among them.
    """
    verdicts = [EXERCISES[key].judge(answer, variant) for answer in answers]
    assert all(v.status == "wrong" and v.points == 0 and v.headline for v in verdicts), [
        v for v in verdicts if v.status != "wrong"
    ]
    assert all(v.mistake is None or v.mistake in catalogue() for v in verdicts)
    return len(verdicts), sum(v.mistake is not None for v in verdicts)


def passes(key, answers, variant=0):
    return all(EXERCISES[key].judge(answer, variant).status == "right" for answer in answers)


def craig_from_standard(rows):
    """By hand: θ and d stay, the pairs go down one row."""
    return [[*row[:2], *pair] for row, pair in zip(rows, [[0, 0], *(row[2:] for row in rows)])]


def standard_from_craig(rows):
    return [[*row[:2], *pair] for row, pair in zip(rows, [*(row[2:] for row in rows[1:]), [0, 0]])]


@pytest.mark.parametrize("key, right", [("03.1", "csccss"), ("03.5", "csscsc")])
def test_sorting_into_the_two_conventions(key, right):
    assert passes(key, [right, list(right), tuple(right.upper()), ", ".join(right)])
    assert fails_by_name(
        key, [list(letters) for letters in product("cs", repeat=6) if "".join(letters) != right]
    ) == (63, 63)
    assert fails_by_name(key, ["cs", right + "c", "abcdef", 5])[0] == 4


def test_whose_frame_it_is_seen_from_the_frames():
    arm = dh.load("article-6r-wrist")
    axes = [
        arm.frames(Q[0, :6])[i - 1][:3, 2] for i in range(1, 7)
    ]  # standard: z_{i-1} is the axis of joint i
    craig = arm.to("craig")
    assert np.allclose([craig.frames(Q[0, :6])[i][:3, 2] for i in range(1, 7)], axes), (
        "Craig's z_i is the axis of joint i"
    )
    aside = arm.table.rows
    aside[5, 2] = 0.1  # the last link leads away from the last axis
    arm = dh.Arm(dh.DHTable.standard(aside, angle="rad"))
    moved = {"standard": [], "craig": []}
    for name, steps in moved.items():
        for i in range(1, 7):
            turned = Q[0, :6] + 0.7 * (np.arange(6) == i - 1)
            steps.append(
                np.linalg.norm(
                    arm.to(name).frames(turned)[i][:3, 3] - arm.to(name).frames(Q[0, :6])[i][:3, 3]
                )
            )
    assert max(moved["craig"]) < 1e-12 and max(moved["standard"]) > 0.1
    assert moved["standard"][5] > 0.05, "the standard plate {n} need not sit on a joint's axis"


def test_every_order_that_gives_craigs_matrix_passes_and_no_other():
    book = np.array(
        [
            [np.cos(0.3), -np.sin(0.3), 0, 0.4],
            [
                np.sin(0.3) * np.cos(0.5),
                np.cos(0.3) * np.cos(0.5),
                -np.sin(0.5),
                -np.sin(0.5) * 0.2,
            ],
            [np.sin(0.3) * np.sin(0.5), np.cos(0.3) * np.sin(0.5), np.cos(0.5), np.cos(0.5) * 0.2],
            [0, 0, 0, 1],
        ]
    )  # Craig, eq. 3.6
    right = [
        order
        for order in permutations("abcd")
        if np.allclose(np.linalg.multi_dot([MOVES[k] for k in order]), book)
    ]
    assert len(right) == 5 and passes("03.2", right)
    wrong = [order for order in permutations("abcd") if order not in right]
    assert fails_by_name("03.2", [*wrong, "aabb", "abca"]) == (21, 19)
    assert (
        sum(
            EXERCISES["03.2"].judge(order).mistake == "craig-rows-in-standard-matrix"
            for order in wrong
        )
        == 5
    )


def test_the_choice():
    assert passes("03.4", ["a", "A", " a "]) and fails_by_name("03.4", "bcd") == (3, 3)
    assert fails_by_name("03.4", ["?", "e", 1, ["b", "c"], {"a"}, "because", 2.5])[0] == 7


def test_no_constant_base_and_tool_repair_the_wrong_matrix():
    """T' = B T E for all q would make T'(q)^-1 T'(r) and T(q)^-1 T(r) similar, with the same angle
    of turn.
    """
    mixed_up = dh.DHTable.craig(ARTICLE.table.rows, angle="rad")
    angles = [
        [
            Rotation.from_matrix(
                (
                    np.linalg.inv(elementary_pose(table, Q[k, :6]))
                    @ elementary_pose(table, Q[k + 1, :6])
                )[:3, :3]
            ).magnitude()
            for k in range(3)
        ]
        for table in (ARTICLE.table, mixed_up)
    ]
    assert np.abs(np.subtract(*angles)).max() > 0.1
    assert not dh.equivalent(ARTICLE, dh.Arm(mixed_up), base="free", tool="free")


def test_what_the_second_prediction_comes_to():
    mixed_up = dh.DHTable.craig(ARTICLE.table.rows, angle="rad")
    right, wrong = (
        elementary_pose(ARTICLE.table, np.zeros(6)),
        elementary_pose(mixed_up, np.zeros(6)),
    )
    assert (
        np.allclose(right[:3, :3], wrong[:3, :3])
        and np.allclose(right[:3, 3], [0.75, -0.2, 0.1])
        and np.allclose(wrong[:3, 3], [0.75, -0.2, -0.1])
    )
    cup = np.deg2rad([30, 60, -80, -30, 40, 0])
    assert np.linalg.norm(
        elementary_pose(ARTICLE.table, cup)[:3, 3] - elementary_pose(mixed_up, cup)[:3, 3]
    ) == pytest.approx(0.30, abs=0.01)


def test_the_published_rows_are_those_of_the_library():
    text = (
        (reading.SOLUTIONS / "03-conventions.md")
        .read_text(encoding="utf-8")
        .replace("−", "-")
        .replace("°", "")
    )
    printed = [
        [float(x) for x in re.findall(r"-?[\d.]+", line.split("|", 3)[3])]
        for line in re.findall(r"^\| \d \|.*$", text, re.MULTILINE)
    ]
    for row, name, letter in zip(
        printed, ["panda", "ur5e", "puma560", "iiwa14", "stanford", "xarm6"], "csscsc"
    ):
        table = dh.load(name).table
        assert np.allclose(
            row,
            [table.a[0], np.rad2deg(table.alpha[0]), table.a[-1], np.rad2deg(table.alpha[-1])],
            atol=1e-4,
        )
        assert table.convention[0] == letter
    jaco = dh.load("jaco6").table
    assert jaco.convention == "standard" and np.allclose(
        [jaco.alpha[0], jaco.alpha[-1]], [np.pi / 2, np.pi]
    )


def test_a_standard_table_may_have_zeros_in_row_1():
    """A cylindrical arm, as the lesson says: joint 2 slides along the line that joint 1 turns
    about.
    """
    x, _, z = np.eye(3)
    end = np.array([[0, 0, 1, 0.4], [0, 1, 0, 0], [-1, 0, 0, 0.3], [0, 0, 0, 1]])
    table = dh.assign_frames(
        [([0, 0, 0], z), ([0, 0, 0.3], z, "P"), ([0, 0, 0.3], x, "P")], end=end
    ).table
    assert table.convention == "standard" and table.a[0] == table.alpha[0] == 0


def by_moves(names):
    return lambda *row: np.linalg.multi_dot([CRAIG_MOVES[name](row) for name in names.split()])


@pytest.mark.parametrize("variant", [0, 3])
@pytest.mark.parametrize(
    "names, words",
    [
        ("Rx Tx Rz", "d has no effect"),
        ("Rx Rz Tz", "a has no effect"),
        ("Tx Rz Tz", "alpha has no effect"),
        ("Rx Tx Tz", "theta has no effect"),
        ("Rz Tz Tx Rx", "this is the standard matrix"),
        ("Rz Tx Rx Tz", "neither Craig's matrix nor the standard"),
    ],
)
def test_a_missing_move_and_another_order_are_said(names, words, variant):
    said = str(EXERCISES["03.3"].judge(by_moves(names), variant))
    assert words in said and "commute" not in said and "published" not in said


def test_the_words_are_those_of_this_lesson():
    assert (
        "this is the standard matrix" in EXERCISES["03.2"].judge("abcd").headline
        and EXERCISES["03.2"].judge("abcd").mistake == "craig-rows-in-standard-matrix"
    )
    assert EXERCISES["03.5"].judge("csscss").headline == "the zeros of table 6 stand in row 1"
    assert (
        "look again at statement 6:" in EXERCISES["03.1"].judge("csccsc").headline
        and "plate" in EXERCISES["03.1"].judge("csccsc").headline
    )
    turned = EXERCISES["03.3"].judge(
        lambda theta, d, a, alpha: in_order(["Rx", "Tx", "Rz", "Tz"], theta, d, a, -alpha)
    )
    assert turned.mistake == "alpha-sign" and "x_{i-1}" in turned.why


@pytest.mark.parametrize("variant", [0, 5, 11])
def test_half_a_conversion_under_a_right_first_row_is_named(variant):
    """03.7 hands out row 1: rows 2 and 3 alone say what was done."""
    rows = EXERCISES["03.7"].given(variant)["rows"]
    first = [*rows[0][:2], 0, 0]
    (t2, d2, a2, al2), (t3, d3, a3, al3), (a1, al1) = rows[1], rows[2], rows[0][2:]
    for second, third, place in (
        ([t2, d2, a1, al2], [t3, d3, a2, al3], "a moved"),
        ([t2, d2, a2, al1], [t3, d3, a3, al2], "α moved"),
        (rows[1], rows[2], "row 1 is right, and the others"),
        ([t2, d2, a3, al3], [t3, d3, 0, 0], "moved up"),
        ([t2, d2, a3, al3], [t3, d3, a1, al1], "moved up"),
        (rows[0], rows[1], "θ and d moved"),
        ([t2, d2, a1, al1], rows[2], "row 3 is still that"),
        (rows[1], [t3, d3, a2, al2], "row 2 is still that"),
    ):
        verdict = EXERCISES["03.7"].judge([first, second, third], variant)
        assert verdict.mistake == "conversion-incomplete" and place in verdict.headline, verdict
    other_sign = EXERCISES["03.7"].judge([first, [t2, d2, a1, -al1], [t3, d3, a2, al2]], variant)
    assert other_sign.mistake == "alpha-sign" and not other_sign.why


@pytest.mark.parametrize(
    "spoil, words",
    [
        (lambda a, alpha: (-a, -alpha), "have the other sign"),
        (lambda a, alpha: (alpha, a), "a and α have changed places"),
        (lambda a, alpha: (1000 * a, np.deg2rad(alpha)), "in other units"),
    ],
)
@pytest.mark.parametrize("variant", [0, 5, 11])
def test_of_a_converted_table_only_what_was_changed_is_named(spoil, words, variant):
    right = craig_from_standard(EXERCISES["03.7"].given(variant)["rows"])
    given = [right[0], *([theta, d, *spoil(a, alpha)] for theta, d, a, alpha in right[1:])]
    said = EXERCISES["03.7"].judge(given, variant)
    assert words in said.headline
    assert "θ" not in said.headline + said.place and " d " not in said.headline + said.place
    assert not any(row in said.headline + said.place for row in ("row 1", "all rows"))


def test_right_rows_without_the_tool_are_another_arm():
    right = craig_from_standard(EXERCISES["03.7"].given(0)["rows"])
    verdict = EXERCISES["03.7"].judge(dh.Arm(dh.DHTable.craig(right, angle="deg")))
    assert verdict.status == "wrong" and "only the end is not" in verdict.place


@pytest.mark.parametrize("variant", [0, 4])
def test_what_was_right_before_is_named_before_all_else(variant):
    standard, broken = EXERCISES["03.9"].given(variant).values()
    right = craig_from_standard(standard)
    for rows in (right, broken):
        other = [list(row) for row in rows]
        other[1][0] += 30
        assert EXERCISES["03.9"].judge(other, variant).place == "row 2, θ"


@pytest.mark.parametrize("variant", [0, 4])
def test_a_column_mended_in_part_is_told_which_part(variant):
    standard, broken = EXERCISES["03.9"].given(variant).values()
    right = craig_from_standard(standard)
    for rows in ([1], [0], [0, 2], [1, 2, 3]):
        partly = [list(row) for row in broken]
        for i in rows:
            partly[i][2] = right[i][2]
        assert (
            EXERCISES["03.9"].judge(partly, variant).place
            == f"right so far, a of row {', '.join(str(i + 1) for i in rows)}"
        )


def test_why_the_published_pairs_differ():
    assert passes("03.6", ["abcde", list("abcde"), tuple("ABCDE")])
    assert fails_by_name(
        "03.6",
        [list(letters) for letters in permutations("abcdef", 5) if letters != tuple("abcde")],
    ) == (719, 719)

    def poses(name, q):
        arm = dh.load(name)
        return [
            arm.base @ elementary_pose(arm.table, row[: len(arm)], arm.sign) @ arm.tool for row in q
        ]

    assert np.allclose(poses("panda", Q), poses("panda.deluca_std", Q), atol=1e-12)
    hand = np.linalg.inv(poses("panda", Q)) @ poses("panda.rtb_tool", Q)
    assert (
        np.allclose(hand, hand[0])
        and np.isclose(hand[0, 2, 3], 0.103)
        and np.isclose(np.rad2deg(Rotation.from_matrix(hand[0, :3, :3]).magnitude()), 45)
    )
    differing = dh.load("ur5_cb").table.rows - dh.load("ur5_cb.rtb").table.rows
    assert np.count_nonzero(differing) == 1 and np.isclose(differing[0, 1], -0.0003)
    moved = Q.copy()
    moved[:, :6] += np.deg2rad([0, -90, 0, -90, 0, 90])
    assert np.allclose(np.abs(dh.load("ur5_cb").table.a), dh.load("ur5_cb.arte").table.a)
    assert np.allclose(poses("ur5_cb", moved), poses("ur5_cb.arte", Q), atol=1e-9)
    other_way = np.linalg.inv(poses("iiwa14", Q * [1, 1, 1, -1, 1, 1, 1])) @ poses(
        "iiwa14.arte_std", Q
    )
    assert np.allclose(other_way, other_way[0], atol=1e-9)


@pytest.mark.slow
@pytest.mark.parametrize("variant", VARIANTS)
def test_from_standard_to_craig(variant):
    rows = EXERCISES["03.7"].given(variant)["rows"]
    right = craig_from_standard(rows)
    flipped = [list(row) for row in right]  # x2 turned round: a and α of row 3, θ2 and θ3
    flipped[1][0] += 180
    flipped[2] = [flipped[2][0] - 180, flipped[2][1], -flipped[2][2], -flipped[2][3]]
    by_library = dh.DHTable.standard(rows, angle="deg")
    assert passes(
        "03.7",
        [
            right,
            np.array(right),
            flipped,
            dh.DHTable.craig(right, angle="deg"),
            dh.Arm(by_library).to("craig"),
        ],
        variant,
    )
    seen, named = fails_by_name(
        "03.7", [wrong for _, _, wrong in EXERCISES["03.7"].mistakes(rows)], variant
    )
    assert seen == named >= 14
    tool = shift([rows[-1][2], 0, 0]) @ turn([np.deg2rad(rows[-1][3]), 0, 0])
    assert np.allclose(
        elementary_pose(dh.DHTable.craig(right, angle="deg"), Q[0]) @ tool,
        elementary_pose(by_library, Q[0]),
    )


@pytest.mark.parametrize("variant", VARIANTS)
def test_from_craig_to_standard(variant):
    rows = EXERCISES["03.8"].given(variant)["rows"]
    right = standard_from_craig(rows)
    assert rows[0][2:] == [0, 0] and np.allclose(
        elementary_pose(dh.DHTable.craig(rows, angle="deg"), Q[1]),
        elementary_pose(dh.DHTable.standard(right, angle="deg"), Q[1]),
    )
    turns = [[theta + 360, d, a, alpha - 360] for theta, d, a, alpha in right]
    assert passes(
        "03.8",
        [
            right,
            tuple(map(tuple, right)),
            turns,
            dh.Arm(dh.DHTable.craig(rows, angle="deg")).to("standard").table,
        ],
        variant,
    )
    seen, named = fails_by_name(
        "03.8", [wrong for _, _, wrong in EXERCISES["03.8"].mistakes(rows)], variant
    )
    assert seen == named == 20


@pytest.mark.slow
@pytest.mark.parametrize("variant", VARIANTS)
def test_the_half_converted_table(variant):
    exercise = EXERCISES["03.9"]
    standard, broken = exercise.given(variant).values()
    for untouched in (broken, np.array(broken), dh.DHTable.craig(broken, angle="deg")):
        assert exercise.judge(untouched, variant).status == "not attempted"
    right = craig_from_standard(standard)
    assert passes("03.9", [right, np.array(right), dh.DHTable.craig(right, angle="deg")], variant)
    assert [
        i for i in range(4) if not np.allclose(np.array(broken)[:, i], np.array(right)[:, i])
    ] == [2], "one column is wrong"
    wrong = [
        rows
        for _, _, rows in exercise.mistakes(standard, broken)
        if not np.allclose(rows, broken) and not np.allclose(rows, right)
    ]
    seen, named = fails_by_name("03.9", wrong, variant)
    assert seen == named >= 5


@pytest.mark.slow
@pytest.mark.parametrize("key", ["03.7", "03.8", "03.9"])
def test_wrong_tables_are_named(key):
    exercise = EXERCISES[key]
    q, arm = exercise.poses_at(0), exercise.right_arm()
    visible = [
        table
        for _, _, table in few(wrong_tables(arm.table), 60)
        if not np.allclose(dh.Arm(table, tool=arm.tool).forward(q), arm.forward(q), atol=1e-9)
    ]
    seen, named = fails_by_name(
        key, [table for table in visible if table.joints == arm.table.joints]
    )
    assert seen >= 40 and named >= 10
    assert (
        fails_by_name(
            key,
            [
                [[0, 0, 0, 0]],
                [[0] * 3] * len(arm),
                "rows",
                [["a", 0, 0, 0]] * len(arm),
                np.zeros((len(arm), 4)),
                np.full((len(arm), 4), np.nan),
            ],
        )[0]
        == 6
    )


@pytest.mark.parametrize("variant", VARIANTS)
def test_a_table_with_no_name(variant):
    exercise = EXERCISES["03.10"]
    rows, q_check, p_check, q = exercise.given(variant).values()
    tables = [dh.DHTable.standard(rows, angle="deg"), dh.DHTable.craig(rows, angle="deg")]
    misses = [
        np.linalg.norm(elementary_pose(table, np.deg2rad(q_check))[:3, 3] - p_check)
        for table in tables
    ]
    assert min(misses) < 1e-3 and max(misses) > 0.05, "the check pose decides"
    end = elementary_pose(tables[int(np.argmin(misses))], np.deg2rad(q))[:3, 3]
    assert passes("03.10", [end, end.tolist(), tuple(end.round(4))], variant)
    wrong = [
        value
        for _, _, value in exercise.mistakes(*exercise.given(variant).values())
        if not np.allclose(value, end, atol=2e-3, rtol=2e-3)
    ]
    seen, named = fails_by_name("03.10", wrong, variant)
    assert seen == named >= 10


def test_a_whole_pose_is_told_to_hold_the_point():
    exercise = EXERCISES["03.10"]
    pose = np.eye(4)
    pose[:3, 3] = exercise.expected(0)
    assert "whole pose" in exercise.judge(pose).headline
    assert "whole pose" not in exercise.judge(np.eye(4)).headline
    assert "last column" in exercise.judge(pose[3, :3]).next


def test_no_habit_gives_the_convention_away():
    drawn = [EXERCISES["03.10"].given(variant) for variant in range(40)]
    for rows in (given["rows"] for given in drawn):
        assert all(rows[i][2] or rows[i][3] for i in (0, -1)), "a row of zeros"
    conventions = {
        (
            min(
                ("standard", "craig"),
                key=lambda name: np.linalg.norm(
                    elementary_pose(
                        getattr(dh.DHTable, name)(g["rows"], angle="deg"), np.deg2rad(g["q_check"])
                    )[:3, 3]
                    - g["p_check"]
                ),
            ),
            round(g["rows"][0][1], 3),
        )
        for g in drawn
    }
    assert len(conventions) == 4, "both arms in both conventions"
