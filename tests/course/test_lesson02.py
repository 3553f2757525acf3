"""Lesson 02: right answers in several forms pass, wrong ones fail by name, and what the lesson
claims is true.
"""

from dataclasses import replace
from itertools import permutations, product

import numpy as np
import pytest
from draws import few, variants
from oracles import shift, turn
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab.course.exercises import exercises
from dhlab.doctor import catalogue
from dhlab.doctor.tables.rows import wrong_tables

VARIANTS = variants(20)
EXERCISES = {key: e for key, e in exercises().items() if key.startswith("02.")}


def one_row(theta, d, a, alpha):
    """The pose of one standard row, radians and metres, with scipy's rotations."""
    return turn([0, 0, theta]) @ shift([a, 0, d]) @ turn([alpha, 0, 0])


def nearest_row(T):
    """How near to a pose any row comes (m and entries of R), over many starts."""
    found = []
    for theta, alpha in product((-2.5, -0.8, 0.8, 2.5), repeat=2):
        fit = least_squares(
            lambda row: (one_row(*row) - T)[:3].ravel(),
            (theta, 0.0, 0.1, alpha),
            xtol=1e-12,
            ftol=1e-12,
            gtol=1e-12,
        )
        found.append(np.abs(fit.fun).max())
        if found[-1] < 1e-9:
            break
    return min(found)


def read_with_scipy(T):
    """θ, d, a, α in degrees and metres: Euler angles z, x, z, of which the last is 0."""
    theta, alpha, nothing = Rotation.from_matrix(T[:3, :3]).as_euler("ZXZ", degrees=True)
    if abs(nothing) > 90:  # scipy keeps the middle angle positive
        theta, alpha = theta + 180, -alpha
    theta = (theta + 180) % 360 - 180
    return [
        theta,
        T[2, 3],
        T[0, 3] * np.cos(np.deg2rad(theta)) + T[1, 3] * np.sin(np.deg2rad(theta)),
        alpha,
    ]


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


def test_matching_the_four_numbers():
    for right in (["b", "e", "a", "d"], "bead", "B, E, A, D", ("b", " e", "a ", "D")):
        assert EXERCISES["02.1"].judge(right).status == "right"
    others = [
        list(letters)
        for letters in permutations("abcdef", 4)
        if list(letters) != ["b", "e", "a", "d"]
    ]
    assert fails_by_name("02.1", others) == (359, 359)
    assert (
        EXERCISES["02.1"].judge("baed").mistake == "a-d-exchanged"
        and EXERCISES["02.1"].judge("deab").mistake == "theta-alpha-exchanged"
    )
    assert (
        EXERCISES["02.1"].judge("fead").place == "θ"
        and EXERCISES["02.1"].judge("becd").place == "a"
    )
    assert (
        EXERCISES["02.1"].judge("ebad").place == "θ, d"
        and EXERCISES["02.1"].judge("beab").headline == "b stands there twice"
    )


@pytest.mark.parametrize("key", ["02.2", "02.5"])
def test_choices(key):
    exercise = EXERCISES[key]
    assert all(
        exercise.judge(dress).status == "right"
        for dress in (exercise.correct, exercise.correct.upper(), f" {exercise.correct} ")
    )
    wrong = [letter for letter in exercise.options if letter != exercise.correct]
    assert fails_by_name(key, wrong) == (3, 3)
    assert fails_by_name(key, ["?", "z", "θ", 4, 2.5, ["a", "b"], {"a": 1}])[0] == 7


@pytest.mark.parametrize("key", ["02.3", "02.4"])
@pytest.mark.parametrize("variant", VARIANTS)
def test_reading_a_row(key, variant):
    exercise = EXERCISES[key]
    T = exercise.given(variant)["T_01"]
    row = read_with_scipy(T)
    assert np.allclose(
        one_row(np.deg2rad(row[0]), row[1], row[2], np.deg2rad(row[3])), T, atol=1e-9
    )
    for right in (row, tuple(row), np.array(row, dtype=np.float32)):
        assert exercise.judge(right, variant).status == "right"
    seen, named = fails_by_name(key, [value for _, _, value in exercise.mistakes(T)], variant)
    assert seen == named >= 9
    assert (
        fails_by_name(
            key, [row[:3], row + [0], [np.nan] * 4, "row", [x + 1 for x in row], T], variant
        )[0]
        == 6
    )


@pytest.mark.slow
@pytest.mark.parametrize(
    "key, variant", few([(key, k) for k in VARIANTS for key in ("02.3", "02.4", "02.8")], 3)
)
def test_whole_turns_make_no_difference(key, variant):
    given = EXERCISES[key].given(variant)
    known = list(EXERCISES[key].mistakes(**given))
    exercise = replace(EXERCISES[key], mistakes=lambda **given: known)
    row = np.array(exercise.answer(**given))
    named = [exercise.judge(value, variant).mistake for _, _, value in known]
    assert None not in named
    for turns in ([360, 0, 0, 0], [-360, 0, 0, 0], [0, 0, 0, 360], [720, 0, 0, -720]):
        assert exercise.judge((row + turns).tolist(), variant).status == "right"
        turned = [np.add(value, turns) for _, _, value in known]
        assert [exercise.judge(value, variant).mistake for value in turned] == named
    for length in (1, 2):
        assert exercise.judge(row + 360 * np.eye(4)[length], variant).status == "wrong"
    assert exercise.judge(row + [180, 0, 0, 0], variant).status == "wrong"


@pytest.mark.parametrize("variant", variants(4))
def test_slips_of_a_row_are_said_as_they_are(variant):
    exercise = EXERCISES["02.3"]
    T = exercise.given(variant)["T_01"]
    theta, d, a, alpha = read_with_scipy(T)
    said = exercise.judge([theta, d, T[:3, 0] * T[:3, 3], alpha], variant)
    assert said.mistake == "elementwise-product" and "a is an array" in said.headline
    assert "d is an array" in exercise.judge([theta, T[:3, 3], a, alpha], variant).headline
    assert exercise.judge([theta, d, a, -alpha], variant).mistake == "alpha-sign"
    assert exercise.judge([[1, 2], [1], 3, "x"], variant).status == "wrong"


@pytest.mark.parametrize("variant", VARIANTS)
def test_a_formula_that_loses_a_sign_does_not_pass(variant):
    """Of 02.3, in which no sign and no quadrant can be guessed."""
    T = EXERCISES["02.3"].given(variant)["T_01"]
    theta, d, a, alpha = read_with_scipy(T)
    x, p = T[:3, 0], T[:3, 3]
    for k, other in (
        (0, np.rad2deg(np.arccos(x[0]))),
        (0, np.rad2deg(np.arctan(x[1] / x[0]))),
        (0, np.rad2deg(np.arcsin(x[1]))),
        (2, np.linalg.norm(p[:2])),
        (3, np.rad2deg(np.arccos(T[2, 2]))),
        (3, np.rad2deg(np.arctan(T[2, 1] / T[2, 2]))),
        (3, np.rad2deg(np.arcsin(T[2, 1]))),
    ):
        row = [theta, d, a, alpha]
        row[k] = other
        verdict = EXERCISES["02.3"].judge(row, variant)
        assert verdict.status == "wrong" and "θdaα"[k] in verdict.headline + verdict.place
        assert ("np.arccos" in verdict.why) == (k == 3 and np.isclose(other, -alpha))


@pytest.mark.parametrize("variant", VARIANTS)
def test_one_condition_alone_tells_no_pose_that_a_row_makes(variant):
    poses = EXERCISES["02.6"].given(variant).values()
    leaning = [abs(T[2, 0]) < 1e-9 for T in poses]
    passing = [abs(T[0, 0] * T[1, 3] - T[1, 0] * T[0, 3]) < 1e-9 for T in poses]
    for answer in (leaning, passing):
        assert EXERCISES["02.6"].judge(answer, variant).status == "wrong"


@pytest.mark.slow
@pytest.mark.parametrize("variant", VARIANTS)
def test_which_poses_one_row_can_make(variant):
    exercise = EXERCISES["02.6"]
    poses = exercise.given(variant)
    nearest = [nearest_row(T) for T in poses.values()]
    assert all(miss < 1e-7 or miss > 0.02 for miss in nearest)
    right = [miss < 1e-7 for miss in nearest]
    for dress in (right, [int(x) for x in right], np.array(right, dtype=float)):
        assert exercise.judge(dress, variant).status == "right"
    assert fails_by_name(
        "02.6", [list(p) for p in product((0, 1), repeat=4) if list(p) != right], variant
    ) == (15, 15)
    assert "exchanged" in exercise.judge([not x for x in right], variant).headline
    lost = max(k for k in range(4) if right[k])
    said = exercise.judge([x and k != lost for k, x in enumerate(right)], variant)
    assert (
        said.headline == f"{list(poses)[lost]} can be made by one row"
        and f'leftovers(poses["{list(poses)[lost]}"])' in said.next
        and not said.why
    )


def test_the_reasons_for_a_misjudged_pose():
    poses = EXERCISES["02.6"].given(0)
    right = [nearest_row(T) < 1e-7 for T in poses.values()]
    reasons = {
        EXERCISES["02.6"].judge([not x if k == i else x for i, x in enumerate(right)]).mistake
        for k in range(4)
    }
    assert reasons == {
        "origin-off-common-normal",
        "x-not-across-z",
        "minus-taken-for-error",
        "measured-in-other-frame",
    }


@pytest.mark.slow
@pytest.mark.parametrize("variant", VARIANTS)
def test_a_printed_table_in_our_columns(variant):
    exercise = EXERCISES["02.7"]
    printed = exercise.given(variant)["rows"]
    half = [[0, 90, -90][int(np.sign(alpha))] for *_, alpha in printed]
    ours = [[0, d, a, alpha] for (_, a, d, _), alpha in zip(printed, half)]
    slid = [list(row) for row in ours]
    slid[1][1], slid[3][1] = ours[1][1] + 0.1, ours[3][1] - 0.1  # along the parallel axes 2, 3, 4
    flipped = [list(row) for row in ours]
    flipped[1] = [180, ours[1][1], -ours[1][2], 0]  # x2 turned round
    flipped[2][0] = -180
    for right in (ours, np.array(ours), slid, flipped, dh.DHTable.standard(ours, angle="deg")):
        assert exercise.judge(right, variant).status == "right"
    wrong = [rows for _, _, rows in exercise.mistakes(**exercise.given(variant))]
    seen, named = fails_by_name("02.7", wrong, variant)
    assert seen == named == 2
    ours = np.array(ours)
    zero = 1.0 * (ours == 0)
    for rows, words, place in (
        (printed, "as printed", ""),
        (np.abs(ours), "3 minus signs are gone", "row 2, a; row 3, a; row 5, α"),
        (ours * [1, 1, 1, -1], "3 numbers have the other sign", "row 1, α; row 4, α; row 5, α"),
        (ours * [1, 1, -1, 1], "2 minus signs are gone", "row 2, a; row 3, a"),
        (ours[:, [0, 1, 2, 3]][[0, 1, 2, 4, 3, 5]], "rows 4 and 5 have changed places", ""),
        (ours * [1, 1, 1, (np.pi / 180) ** 2], "taken times π/180 and not 180/π", ""),
        (ours[:, :3], "row 1 has 3 numbers, expected 4 (θ, d, a, α)", ""),
        (ours + [0, 0.01, 0, 0] * (1 - zero), "4 numbers are not right", None),
    ):
        said = exercise.judge(rows.tolist() if isinstance(rows, np.ndarray) else rows, variant)
        assert words in said.headline and place in (None, said.place), said


@pytest.mark.slow
def test_wrong_tables_of_a_printed_one_are_named():
    exercise = EXERCISES["02.7"]
    q = exercise.poses_at(0)
    right = exercise.right_arm().forward(q)
    visible = [
        table
        for _, _, table in wrong_tables(exercise.right_arm().table)
        if not np.allclose(dh.Arm(table).forward(q), right, atol=1e-9)
    ]
    seen, named = fails_by_name("02.7", visible)
    assert seen == len(visible) and named >= 10
    assert exercise.judge(exercise.given(0)["rows"]).mistake == "columns-misread"
    assert (
        fails_by_name(
            "02.7", [[[0, 0, 0, 0]], [[0] * 4] * 6, [[0] * 3] * 6, "table", [["q1", 0, 0, 0]] * 6]
        )[0]
        == 5
    )


@pytest.mark.parametrize("variant", VARIANTS)
def test_the_bent_upper_arm(variant):
    exercise = EXERCISES["02.8"]
    q2 = exercise.given(variant)["q2"]
    tip = (
        turn([0, 0, np.deg2rad(q2)]) @ shift([0, 0.2845, 0]) @ shift([0.0535, 0, 0])
    )  # walked along the tube
    x, y, z = tip[:3, 3]
    right = [np.rad2deg(np.arctan2(y, x)), z, np.hypot(x, y), 0.0]
    right[0] = right[0] + 360 * round((q2 + 79.35 - right[0]) / 360)
    for dress in (
        right,
        tuple(right),
        [q2 + 79.34995, 0, 0.28948866, 0],
    ):  # the last as the maker prints it
        assert exercise.judge(dress, variant).status == "right"
    rounded = exercise.judge([round(right[0]), *right[1:]], variant)
    assert "rounded too early" in rounded.headline
    seen, named = fails_by_name("02.8", [value for _, _, value in exercise.mistakes(q2)], variant)
    assert seen == named >= 15


def test_what_the_predictions_come_to():
    before, after = one_row(0.7, 0.3, 0.4, 0.9), one_row(0.7, 0.3, 0.4, 2.1)
    assert (
        np.allclose(before[:3, 3], after[:3, 3])
        and np.allclose(before[:3, 0], after[:3, 0])
        and not np.allclose(before[:3, 2], after[:3, 2])
    )
    assert np.linalg.norm(one_row(0.7, 0.3, 0.4, 0.9)[:3, 3]) == pytest.approx(0.5)
    assert (
        nearest_row(shift([0, 0.1, 0])) > 0.02 and nearest_row(one_row(np.pi / 2, 0, 0.1, 0)) < 1e-9
    )
    assert np.allclose(
        one_row(np.pi / 2, 0, 0.1, 0) @ one_row(-np.pi / 2, 0, 0, 0), shift([0, 0.1, 0])
    ), "two rows make the step aside"
    urdf_origin = shift([0.1, 0.05, 0.3]) @ turn([0, 0.5, 0])
    assert nearest_row(urdf_origin) > 0.02
