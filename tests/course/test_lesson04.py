"""Lesson 04: valid placements in many dresses pass, wrong ones fail and are named; the pictures'
frames and the expected table are one arm.
"""

from itertools import pairwise, permutations, product

import numpy as np
import pytest
from claims import boards, sentence
from draws import few, variants
from geometry_cases import exponentials, pose_error
from oracles import elementary_pose
from wrong_answers import wrong_frames

import dhlab as dh
from dhlab.course.exercises import exercises
from dhlab.course.exercises.answers04 import rows_read
from dhlab.course.kinds.frames.placed import MISTAKES, Frames
from dhlab.doctor import catalogue
from dhlab.doctor.tables.rows import wrong_tables
from dhlab.placing.board import Placement

X, Y, Z = np.eye(3)
E = exercises()
FRAMES = [key for key, e in E.items() if key.startswith("04.") and isinstance(e, Frames)]
VARIANTS = variants(6)


def solved(key, given):
    """Right frames, written down from the drawing of each task."""
    points, end = [p for p, *_ in given["axes"]], np.array(given["end"])
    if key == "04.2":
        _, a, h = points[1]
        return [[Z, [0, 0, 0], X], [X, [0, a, h], Y], [end[:3, 2], end[:3, 3], end[:3, 0]]]
    if key == "04.4":
        x, _, h = points[2]
        return [[Z, [0, 0, 0], X], [Y, [0, 0, h], X], [Y, [x, 0, h], X], [X, [x, 0, h], Z]]
    if key == "04.7":
        return [[Z, [0, 0, 0], X], [Y, points[1], X], [Y, points[2], X], [Y, end[:3, 3], X]]
    if key in ("04.12", "04.13", "04.14"):
        centre = [0.75, -0.1, 0.1]
        half = [[Z, [0, 0, 0], X], *([-Y, [x, 0, 0.1], X] for x in (0, 0.4, 0.75))]
        return (
            half
            if key == "04.12"
            else [*half, [-Z, centre, X], [-Y, centre, X], [-Y, end[:3, 3], X]]
        )
    if key == "04.15":
        heights, fore = [p[2] for p in points], points[4][0]
        return [
            [Z, [0, 0, 0], X],
            [Y, [0, 0, heights[1]], X],
            [Y, [0, 0, heights[2]], Z],
            [X, [0, 0, heights[3]], Z],
            [Y, [fore, 0, heights[3]], Z],
            [X, [fore, 0, heights[3]], Z],
            [X, end[:3, 3], Z],
        ]
    _, side, h = points[3]
    return [
        [Z, [0, 0, 0], X],
        [Y, [0, 0, h], X],
        [X, [0, side, h], Z],
        [X, points[3], Y],
        [X, end[:3, 3], Z],
    ]


BROKEN = {"04.7": 1, "04.14": 4}  # whose origin breaks a rule
# where the origin may slide along its own z, and by how much it slides here
SLIDES = {
    "04.2": [0],
    "04.4": [0, 2],
    "04.7": [0, 2],
    "04.10": [0, 3, 4],
    "04.12": [0, 2, 3],
    "04.13": [0, 2, 3, 6],
    "04.14": [0, 2, 3, 6],
    "04.15": [0, 2, 6],
}


def dressed(key, rows):
    """The same frames in other valid choices: arrows turned round, origins slid, directions of
    another length, points a hair off.
    """
    yield rows
    for z, x in ((-1, 1), (1, -1), (-1, -1)):
        yield [[z * np.asarray(r[0]), r[1], x * np.asarray(r[2])] for r in rows]
    yield [
        [
            3 * np.asarray(r[0]),
            np.asarray(r[1]) + 0.17 * np.asarray(r[0]) * (i in SLIDES[key]),
            r[2],
        ]
        for i, r in enumerate(rows)
    ]
    yield [[tuple(np.asarray(part) + 1e-4) for part in r] for r in rows]


@pytest.mark.parametrize("key", [key for key in FRAMES if key not in BROKEN])
@pytest.mark.parametrize("variant", VARIANTS)
def test_right_placements_pass_in_many_dresses(key, variant):
    rows = solved(key, E[key].given(variant))
    verdicts = [E[key].judge(answer, variant) for answer in dressed(key, rows)]
    assert [v.status for v in verdicts] == ["right"] * 6 and all(
        v.points == v.of for v in verdicts
    ), verdicts
    assert any("another right one" in v.headline for v in verdicts)


@pytest.mark.parametrize("key", BROKEN)
@pytest.mark.parametrize("variant", VARIANTS)
def test_of_somebodys_frames_only_what_broke_a_rule_may_be_changed(key, variant):
    given = E[key].given(variant)
    mended = [list(frame) for frame in given["frames"]]
    mended[BROKEN[key]][1] = solved(key, given)[BROKEN[key]][1]
    longer = [[3 * np.asarray(z), o, 2 * np.asarray(x)] for z, o, x in mended]
    hair = [[np.asarray(part) + 1e-4 for part in row] for row in mended]
    for answer in (mended, longer, hair):
        assert E[key].judge(answer, variant).status == "right"
    for i, part in ((2, 0), (2, 1), (3, 1), (len(mended) - 1, 2)):
        more = [list(row) for row in mended]
        more[i][part] = more[i][part] + 0.1 * Y if part == 1 else -np.asarray(more[i][part])
        verdict = E[key].judge(more, variant)
        assert verdict.status == "wrong"
        if "every rule is kept" in verdict.headline:
            assert verdict.place.startswith(f"{'zox'[part]}{i}: ")
            assert boards.true_of(verdict, more, given)
    assert "allowed" not in str(verdict.at_try(1)) + str(verdict.at_try(2))


def table_of(frames):
    """θ, d, a, α of frames, by the scalar and cross products of their arrows."""
    for (z, o, x), (w, p, u) in pairwise([[np.asarray(v, dtype=float) for v in r] for r in frames]):
        yield [
            np.arctan2(np.cross(x, u) @ z, x @ u),
            (p - o) @ z,
            (p - o) @ u,
            np.arctan2(np.cross(z, w) @ u, z @ w),
        ]


@pytest.mark.parametrize("turned", [(), (5,), (2, 4)])
def test_a_table_is_called_that_of_lesson_06_when_it_is(turned):
    frames = solved("04.13", E["04.13"].given(0))
    for i in turned:
        frames[i][2] = -np.asarray(frames[i][2])
    angles = np.exp(1j * (np.array(list(table_of(frames))) - dh.load("article-6r").table.rows))
    said = E["04.13"].judge(frames).headline
    assert np.allclose(angles, 1) == ("is that of lesson 06" in said)
    assert np.allclose(angles, 1) != ("another right one than that of lesson 06" in said)


def test_a_z3_that_must_move_later_on_is_told():
    rows = solved("04.12", E["04.12"].given(0))
    assert "axis of joint 4" not in str(E["04.12"].judge(rows))
    for z, o, x in ((Z, rows[3][1], X), (-Y, [0.7, 0, 0.1], X)):
        verdict = E["04.12"].judge([*rows[:3], [z, o, x]])
        assert verdict.status == "right" and "does not lie on the axis of joint 4" in str(verdict)


def test_of_the_first_frame_no_z_before_it_is_spoken_of():
    for key in ("04.2", "04.10", "04.15"):
        rows = solved(key, E[key].given(0))
        for x in (Z, [1, 0, 1]):
            verdict = E[key].judge([[rows[0][0], rows[0][1], x], *rows[1:]])
            assert verdict.place == "x0" and "two z" not in str(verdict)
            assert "before" not in str(verdict)


@pytest.mark.parametrize("order", [(0, 2, 1), (2, 1, 0), (1, 2, 0)])
def test_columns_in_another_order_are_named(order):
    rows = solved("04.2", E["04.2"].given(0))
    given = [[row[k] for k in order] for row in rows]
    names = ", ".join(("z", "origin", "x")[k] for k in order)
    assert f"the rows hold {names};" in E["04.2"].judge(given).headline


@pytest.mark.slow
@pytest.mark.parametrize("key", FRAMES)
@pytest.mark.parametrize("variant", few([0, 3], 1))
def test_wrong_placements_fail_and_are_named(key, variant):
    """What is accepted is the arm, by products of exponentials; what is refused has a name of the
    catalogue.
    """
    given = E[key].given(variant)
    axes = [(p, d, *(letter or ["R"])) for p, d, *letter in given["axes"]]
    q = np.random.default_rng(4).uniform(-2, 2, (5, len(axes)))
    refused, seen = [], set()
    for answer in wrong_frames(solved(key, given), given["axes"]):
        verdict = E[key].judge(answer, variant)
        if verdict.status == "right":
            board = Placement(given["axes"], given["end"])
            assert all(
                board.set_z(i, r[0]) and board.set_origin(i, r[1]) and board.set_x(i, r[2])
                for i, r in enumerate(answer)
            )
            assert (
                max(pose_error(exponentials(axes, np.array(given["end"]), q), board.arm.forward(q)))
                < 1e-12
            )
        elif "every rule is kept" in verdict.headline:
            assert boards.true_of(verdict, answer, given)
        else:
            assert (
                verdict.status == "wrong"
                and verdict.mistake in catalogue()
                and verdict.place[0] in "zox"
            ), verdict
            refused.append(verdict.headline)
            seen.add(verdict.mistake)
    assert len(set(refused)) >= 10 and len(seen) >= 3
    for nonsense in ("up", [0, 0, 0], [np.nan, 0, 1], [0, 1]):
        rows = [list(r) for r in solved(key, given)]
        rows[1][2] = nonsense
        assert E[key].judge(rows, variant).status == "wrong"


def test_every_rule_that_can_be_broken_has_a_mistake():
    assert set(MISTAKES.values()) <= catalogue().keys() and len(MISTAKES) >= 10


def test_a_part_is_told_what_is_right_so_far():
    given = E["04.4"].given(0)
    rows = solved("04.4", given)
    half = [rows[0], rows[1], [rows[2][0], ..., ...], [..., ..., ...]]
    verdict = E["04.4"].judge(half)
    assert (
        verdict.status == "not attempted"
        and "z0, o0, x0, z1, o1, x1, z2" in verdict.place
        and "z3" in verdict.next
    )
    half[1] = [Z, ..., ...]
    assert E["04.4"].judge(half).mistake == "frame-at-other-end"


@pytest.mark.parametrize(
    "answer, words",
    [
        (solved("04.4", E["04.4"].given(0))[:3], "expected 4 rows"),
        ([[Z, [0, 0, 0]]] * 4, "found 2 entries"),
        (7, "found int"),
        ([[X]] * 4, "expected z, origin and x for frame 0"),
    ],
)
def test_another_shape_is_a_sentence(answer, words):
    assert words in E["04.4"].judge(answer).headline


def test_what_is_handed_out_is_no_attempt_and_one_step_mends_it():
    for variant in VARIANTS:
        given = E["04.7"].given(variant)
        assert E["04.7"].judge(given["frames"], variant).status == "not attempted"
        assert (
            E["04.7"]
            .judge([[tuple(part) for part in row] for row in given["frames"]], variant)
            .status
            == "not attempted"
        )
        for i, part in product(range(4), range(3)):
            rows = [list(row) for row in given["frames"]]
            rows[i][part] = solved("04.7", given)[i][part]
            status = E["04.7"].judge(rows, variant).status
            assert status == (
                "right"
                if (i, part) == (1, 1)
                else (
                    "not attempted"
                    if np.allclose(rows[i][part], given["frames"][i][part])
                    else "wrong"
                )
            )


def test_variants_differ_and_are_repeatable():
    for key in FRAMES:
        drawn = [repr(E[key].given(v)) for v in range(12)]
        assert len(set(drawn)) >= 4 and drawn == [repr(E[key].given(v)) for v in range(12)]


def test_lines_of_z():
    for letters in permutations("abcdef", 3):
        verdict = E["04.1"].judge(list(letters))
        assert (verdict.status == "right") == (letters == ("d", "e", "b")) and (
            verdict.status == "right" or verdict.mistake
        ), letters
    assert (
        E["04.1"].judge("d, E, b").status == "right"
        and E["04.1"].judge(["d", "d", "e"]).mistake == "frame-at-other-end"
    )


def read(variant=0):
    """The rows of 04.5's frames."""
    return rows_read(**E["04.5"].given(variant))


@pytest.mark.parametrize("variant", VARIANTS)
def test_the_table_of_04_5_is_that_of_the_frames_in_the_lesson(variant):
    """Its four frames, as the lesson gives them, from the rows by elementary matrices."""
    task, rows = E["04.5"].given(variant), read(variant)
    for i, (z, o, x) in enumerate(task["frames"]):
        T = (
            np.eye(4)
            if i == 0
            else elementary_pose(dh.DHTable.standard(rows[:i], angle="deg"), np.zeros(i))
        )
        np.testing.assert_allclose(T[:3, [2, 3, 0]].T, [z, o, x], atol=1e-12)
    np.testing.assert_allclose(T, task["end"], atol=1e-12)


def test_everybody_reads_a_table_of_their_own():
    assert len({str(read(variant)) for variant in range(50)}) > 30


@pytest.mark.slow
def test_the_table_of_the_frames_of_04_5_passes_and_wrong_ones_are_named():
    exercise = E["04.5"]
    (_, h, _, _), (_, side, upper, _), (_, _, fore, _) = rows = read()
    # x1 turned round
    flipped = [[180, h, 0, -90], [-90, side, upper, 0], [-90, 0, fore, -90]]
    slid = [[0, h, 0, 90], [90, 0, upper, 0], [-90, side, fore, -90]]  # o2 slid along z2
    for other in (flipped, slid):
        assert "a table of other frames" in exercise.judge(other).headline
    for answer in (
        rows,
        np.array(rows),
        [[theta + 360, d, a, alpha - 360] for theta, d, a, alpha in rows],
    ):
        assert exercise.judge(answer).status == "right", answer
    q, seen = exercise.poses_at(0), set()
    for mistake, place, table in wrong_tables(exercise.right_arm().table):
        if np.abs(dh.Arm(table).forward(q) - exercise.right_arm().forward(q)).max() > 1e-9:
            verdict = exercise.judge(table)
            told = verdict.mistake or "number" in verdict.headline
            assert verdict.status == "wrong" and told, (mistake, place)
            seen.add(verdict.mistake)
    assert len(seen) >= 10


@pytest.mark.parametrize(
    "changes, mistake, words",
    [
        ([(1, 2, lambda a: -a)], "length-sign", "has the other sign @ row 2, a"),
        ([(1, 0, -90)], "offset-sign", "has the other sign @ row 2, θ"),
        ([(1, 0, -90), (2, 0, 90)], "offset-sign", "the other sign @ row 2, θ; row 3, θ"),
        ([(1, 0, 0), (2, 0, 0)], "offset-missing", "are 0, and should not be @ row 2, θ; row 3, θ"),
        ([(0, 3, -90)], "alpha-sign", "has the other sign @ row 1, α"),
        ([(0, 1, lambda d: d + 0.1)], "length-value", "is not right @ row 1, d"),
        ([(0, 1, lambda d: d + 0.1), (1, 0, 30)], None, "are not right @ row 1, d; row 2, θ"),
        ([(2, 2, lambda a: 1000 * a)], "length-unit", "millimetres"),
        ([(1, 0, np.pi / 2), (2, 0, -np.pi / 2)], "angle-unit", "θ in radians"),
        (
            [(1, 0, np.pi / 2), (2, 0, -np.pi / 2), (2, 3, -np.pi / 2)],
            "angle-unit",
            "θ and α3 in radians",
        ),
        ([(1, 0, -90), (0, 3, -90)], None, "2 numbers have the other sign @ row 1, α; row 2, θ"),
    ],
)
@pytest.mark.parametrize("variant", [0, 7])
def test_misread_numbers_are_named_one_by_one(changes, mistake, words, variant):
    rows = read(variant)
    for i, k, value in changes:
        rows[i][k] = value(rows[i][k]) if callable(value) else value
    for answer in (rows, np.array(rows), dh.DHTable.standard(rows, angle="deg")):
        verdict = E["04.5"].judge(answer, variant)
        assert (
            verdict.status == "wrong"
            and verdict.mistake == mistake
            and words in sentence(verdict)
            and "offset" not in str(verdict)
        ), verdict


@pytest.mark.parametrize("variant", VARIANTS)
def test_a_right_table_of_other_frames_is_told_so(variant):
    (_, h, _, _), (_, side, upper, _), (_, _, fore, _) = read(variant)
    slid = [[0, h, 0, 90], [90, 0, upper, 0], [-90, side, fore, -90]]
    whole_turns = [[360, h, 0, 90], [90, side, upper, 360], [-90, 0, fore, 270]]
    assert "another d2, d3" in E["04.5"].judge(slid, variant).headline
    assert "another" not in E["04.5"].judge(whole_turns, variant).headline


@pytest.mark.parametrize("variant", VARIANTS)
def test_the_worked_steps_are_not_the_answer_of_04_2(variant):
    task = E["04.2"].given(variant)
    tool = np.array(task["end"])
    ends = [[Z, [0, 0, 0], X], [tool[:3, 2], tool[:3, 3], tool[:3, 0]]]
    copied = [ends[0], [Y, [0.1, 0, 0.4], X], ends[1]]
    assert E["04.2"].judge(copied, variant).status == "wrong"


@pytest.mark.parametrize("variant", VARIANTS)
def test_why_an_origin_is_refused(variant):
    """Each place has a reason of its own; only a point beside z hears of the housing."""
    given = E["04.2"].given(variant)
    side, a, h = given["axes"][1][0]
    rows = solved("04.2", given)
    said = {}
    for name, origin in (
        ("foot on z0", [0, 0, h]),
        ("housing", [side, a, h]),
        ("beside", [side, 0, h]),
    ):
        rows[1] = [X, origin, Y]
        said[name] = E["04.2"].judge(rows, variant)
    assert len({v.why for v in said.values()}) == 3 and [
        name for name, v in said.items() if "housing" in v.why
    ] == ["beside"]
    given = E["04.4"].given(variant)
    rows = solved("04.4", given)
    rows[1][1] = given["axes"][1][0]
    verdict = E["04.4"].judge(rows, variant)
    assert (
        verdict.mistake == "origin-off-common-normal"
        and "both axes" in verdict.next
        and "shortest" not in str(verdict)
    )


@pytest.mark.parametrize("variant", VARIANTS)
def test_what_was_allowed_is_said(variant):
    frames = [list(row) for row in E["04.7"].given(variant)["frames"]]
    frames[2][0] = [0, 1, 0]
    verdict = E["04.7"].judge(frames, variant)
    assert verdict.place == "o1" and verdict.headline.endswith("z2 was allowed as handed out.")
    frames[2][2] = [1, 0, 0]
    assert "z2 and x2 were allowed" in E["04.7"].judge(frames, variant).headline
    frames = [list(row) for row in E["04.7"].given(variant)["frames"]]
    frames[1][1] = [9, 9, 9]
    assert "allowed" not in E["04.7"].judge(frames, variant).headline


@pytest.mark.parametrize("variant", [0, 3])
def test_a_slide_does_not_turn(variant):
    rows = solved("04.10", E["04.10"].given(variant))
    rows[2][0] = Z
    verdict = E["04.10"].judge(rows, variant)
    assert (
        verdict.mistake == "z-across-joint-axis"
        and "Joint 3 slides" in verdict.headline
        and "turn" not in str(verdict)
        and "stands still" not in str(verdict)
    )


@pytest.mark.parametrize("i, x", [(2, 3), (4, 4)])
def test_an_origin_that_lays_a_line_elsewhere_is_told_with_the_x_that_misses(i, x):
    rows = solved("04.10", E["04.10"].given(0))
    rows[3][2] = Z
    rows[i][1] = [rows[i][1][0], 0, rows[i][1][2]]
    rows[4][1] = rows[4][1] if i == 2 else np.array(rows[4][1]) * [1, 0, 1]
    verdict = E["04.10"].judge(rows)
    assert verdict.place == f"x{x}" and f"z{i} runs through your o{i}." in verdict.headline
    assert boards.true_of(verdict, rows, E["04.10"].given(0))


def test_the_tools_own_frame_is_not_always_frame_n():
    """What the lesson says of frame n: the tool's origin may be out of reach, and where axis n
    meets the tool's line one row arrives.
    """
    given = E["04.4"].given(0)
    rows, end = solved("04.4", given), np.array(given["end"])
    rows[3] = [end[:3, 2], end[:3, 3], end[:3, 0]]
    assert E["04.4"].judge(rows).place == "o3"
    q, z = given["axes"][2][0], end[:3, 2]
    rows[3][1] = [end[0, 3] - (end[0, 3] - q[0]) * z[0], end[1, 3], q[2]]
    assert E["04.4"].judge(rows).status == "right"


def test_ada_and_bo():
    """What the lesson says of their tables: no row the same, the step of 0.1 m, five changes for a
    reversed z.
    """
    axes = [([0, 0, 0], Z), ([0.1, -0.1, 0.4], Y), ([0.1, 0, 0.8], Y)]
    end = np.array([[0, 0, 1, 0.5], [0, 1, 0, 0.1], [-1, 0, 0, 0.8], [0, 0, 0, 1]])
    boards = []
    for rows in (
        [[Z, [0, 0, 0], X], [Y, [0.1, 0, 0.4], X], [Y, [0.1, 0, 0.8], Z], [X, [0.1, 0.1, 0.8], -Z]],
        [
            [Z, [0, 0, 0.2], Y],
            [-Y, [0.1, 0, 0.4], -X],
            [Y, [0.1, 0.3, 0.8], Z],
            [Y, [0.5, 0.1, 0.8], X],
        ],
    ):
        board = Placement(axes, end)
        assert all(
            board.set_z(i, z) and board.set_origin(i, o) and board.set_x(i, x)
            for i, (z, o, x) in enumerate(rows)
        )
        boards.append(board)
    ada, bo = (board.arm for board in boards)
    q = np.random.default_rng(1).uniform(-3, 3, (20, 3))
    truth = exponentials([(p, z, "R") for p, z in axes], end, q)
    assert max(*pose_error(truth, ada.forward(q)), *pose_error(truth, bo.forward(q))) < 1e-13
    assert (np.abs(ada.table.rows - bo.table.rows) > 1e-9).any(axis=1).all() and (
        np.abs(ada.table.rows - bo.table.rows) > 1e-9
    ).sum() > 6
    rows = ada.table.rows
    rows[1, 1] = 0.1
    twice = dh.Arm(dh.DHTable.standard(rows, angle="rad"), tool=ada.tool)
    np.testing.assert_allclose(
        np.linalg.norm((twice.forward(q) - ada.forward(q))[:, :3, 3], axis=1), 0.1
    )
    assert boards[0].set_z(2, -Y)
    turned = boards[0].arm
    assert turned.sign.tolist() == [1, 1, -1] and max(pose_error(truth, turned.forward(q))) < 1e-13
    changed = np.argwhere(
        np.abs(np.exp(1j * turned.table.rows) - np.exp(1j * ada.table.rows)) > 1e-9
    ).tolist()
    assert changed == [
        [1, 3],
        [2, 1],
        [2, 3],
    ]  # alpha2, d3, alpha3; theta3 = 180° is its own negative here, and q3 counts the other way


def test_the_cases_of_04_11_are_those_of_the_axes():
    """By directions and by the distance of the lines, from the numbers that 04.13 gives."""
    lines = [(np.array(p, float), np.array(d, float)) for p, d in E["04.13"].given(0)["axes"]]
    right = []
    for (p, w), (q, z) in pairwise(lines):
        normal = np.cross(w, z)
        if np.linalg.norm(normal) < 1e-9:
            right.append("line" if np.linalg.norm(np.cross(q - p, w)) < 1e-9 else "parallel")
        else:
            right.append("meet" if abs((q - p) @ normal) < 1e-9 else "skew")
    for cases in product(["parallel", "skew", "line", "meet"], repeat=5):
        verdict = E["04.11"].judge(list(cases))
        assert (verdict.status == "right") == (list(cases) == right)
        if verdict.status == "wrong":
            first = next(i for i in range(5) if cases[i] != right[i])
            assert verdict.headline == f"axes {first + 1} and {first + 2} lie otherwise"
