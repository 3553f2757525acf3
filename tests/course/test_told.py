"""What is told, and when: units before all else, plain sentences for what holds no numbers, and a
debugging task bit by bit.
"""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab.course import check, session
from dhlab.course.exercises import exercises
from dhlab.course.exercises.answers04 import rows_read
from dhlab.course.progress import Log

E = exercises()


class Frame:
    """A table of pandas, as far as it matters here."""

    def __init__(self, values):
        self.values = values

    def to_numpy(self):
        return self.values


def right(key, variant=0):
    return np.asarray(E[key].answer(**E[key].given(variant)), dtype=float)


@pytest.fixture
def fresh(monkeypatch, tmp_path):
    """A session in which nothing has been checked."""
    monkeypatch.setattr(session, "_log", Log())
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize("key", ["01.3", "02.3", "06.10"])
def test_right_numbers_pass_in_any_dress(key):
    import sympy

    value = right(key)
    for dress in (
        value.tolist(),
        value.astype(np.float32),
        value.astype(complex),
        np.ma.masked_array(value),
        np.asmatrix(value),
        Frame(value),
        [sympy.Float(x, 17) for x in value] if value.ndim == 1 else sympy.Matrix(value),
    ):
        assert E[key].judge(dress).status == "right", type(dress)


def with_a_letter(v):
    import sympy

    return [sympy.Symbol("x"), *v[1:]]


@pytest.mark.parametrize(
    "spoil, words",
    [
        (lambda v: v + 0.1j, "complex numbers, with an imaginary part that is not 0"),
        (lambda v: np.ma.masked_array(v, v == v[0]), "1 of 3 numbers is hidden"),
        (
            lambda v: [pytest.importorskip("sympy").Symbol("x"), *v[1:]],
            "a formula in which letters are left",
        ),
        (lambda v: [[1], [1, 2]], "rows of different lengths"),
        (lambda v: [str(x) for x in v], "text where a number belongs"),
    ],
)
def test_what_holds_no_numbers_is_told_in_a_plain_sentence(spoil, words):
    assert words in E["01.3"].judge(spoil(right("01.3"))).headline


def test_decimal_commas_are_told_in_text_and_as_the_two_numbers_that_python_makes_of_each():
    verdict = E["00.1"].judge(["4,59", "4,35", 8])
    assert verdict.headline == "expected 3 numbers, found text with decimal commas"
    assert verdict.next == "Write a decimal point, and no quotation marks: 0.5."
    asked = "Is there a decimal comma? Python reads 0,5 as two numbers; write 0.5."
    assert E["00.1"].judge([4, 59, 4, 35, 8]).next == asked  # 4,59, 4,35, 8
    assert E["00.1"].judge([4.59, 4.35, 8, 1]).next != asked
    assert "with a decimal point" in E["02.7"].judge([["0,1", 0, 0, 0]] * 6).headline
    assert "a decimal comma" in E["02.7"].judge([[0, 1, 0, 0, 0]] * 6).headline


@pytest.mark.parametrize("key", ["00.1", "02.1", "02.3", "02.7", "04.2", "05.4", "06.6", "09.1"])
def test_a_question_mark_is_always_an_answer(key):
    for answer in ("?", ["?"] * 4):
        verdict = E[key].judge(answer)
        assert verdict.status == "wrong" and verdict.headline == E[key].undecided


def test_a_list_that_is_half_filled_is_not_attempted_yet():
    for key, answer, place in (
        ("02.1", ["a", ..., ..., ...], "place 2; place 3; place 4"),
        ("02.3", [30, ..., 0.2, 60], "number 2"),
        ("01.2", [[0, -1, 0, ...], *np.eye(4)[1:].tolist()], "row 1"),
        ("04.5", [[0, ..., 0, ...], ..., [0, 0, 0, 0]], "row 1, d and α; row 2"),
        ("05.9", [[1, 0, 0, 0], [0, 1, 0, ...], [0, 0, 1, ...], [0, 0, 0, 1]], "row 2; row 3"),
    ):
        verdict = E[key].judge(answer)
        assert (verdict.status, verdict.place) == ("not attempted", place)


@pytest.mark.parametrize(
    "key, fill, so_far",
    [
        ("01.2", lambda v: [[..., x, ..., y] for _, x, _, y in v[:3]] + [[0, 0, 0, 1]], True),
        ("01.2", lambda v: [[..., -x, ..., y] for _, x, _, y in v[:3]] + [[0, 0, 0, 1]], False),
        ("02.3", lambda v: [v[0], ..., v[2], ...], True),
        ("02.3", lambda v: [v[0], ..., "x", ...], False),
        ("01.7", lambda v: [v[0], ...], False),
    ],
)
def test_of_half_an_answer_what_is_there_is_said_to_be_right_where_it_is(key, fill, so_far):
    verdict = E[key].judge(fill(right(key)))
    assert verdict.status == "not attempted"
    assert verdict.headline == "the part that is filled in is right" * so_far


@pytest.mark.parametrize("key", ["02.7", "03.7", "04.5", "06.6"])
@pytest.mark.parametrize("open_", [..., "?"])
def test_of_half_a_table_what_is_there_is_said_to_be_right_where_it_is(key, open_):
    rows = (E[key].right_arm().table.rows * [180 / np.pi, 1, 1, 180 / np.pi]).tolist()
    rows[0][0], rows[1][3], rows[-1] = open_, open_, open_
    assert "part that is filled in is right" in E[key].judge(rows).headline
    rows[0][1] += 0.1
    assert "part that is filled in" not in E[key].judge(rows).headline


def test_a_question_mark_beside_right_numbers_hears_that_they_are():
    values = right("02.3").tolist()
    headline = E["02.3"].judge([*values[:3], "?"]).headline
    assert headline == f"{E['02.3'].undecided} The part that is filled in is right."
    assert E["02.3"].judge([values[0] + 1, *values[1:3], "?"]).headline == E["02.3"].undecided


MAKERS = [[0, 0.1, 0, 90], [0, 0, 0.4, 0], [0, 0, 0.35, 0], [0, 0.1, 0, 90]]


@pytest.mark.parametrize(
    "key, answer, words",
    [
        ("02.3", lambda v: [np.deg2rad(v[0]), *v[1:]], "θ in radians"),
        ("02.3", lambda v: [v[0], 1000 * v[1], v[2], v[3]], "d in millimetres"),
        (
            "02.3",
            lambda v: [np.deg2rad(v[0]), 1000 * v[1], 1000 * v[2], np.deg2rad(v[3])],
            "θ and α in radians, d and a in millimetres",
        ),
        ("01.7", lambda v: 1000 * v, "the numbers in millimetres"),
        (
            "06.10",
            lambda v: v * np.array([[1, 1, 1, 1000]] * 3 + [[1] * 4]),
            "last column in millimetres",
        ),
    ],
)
def test_units_are_told_of_numbers(key, answer, words):
    assert words in E[key].judge(answer(right(key))).headline


def test_of_a_number_that_must_be_0_no_unit_is_told():
    """3 cm for 0 are no millimetres, also where another number is in another unit."""
    row = right("02.8")
    headline = E["02.8"].judge([np.deg2rad(row[0]), 0.03, *row[2:]]).headline
    assert row[1] == 0 and "θ in radians" not in headline and "millimetres" not in headline


def test_units_are_told_of_tables_and_placements():
    rows = np.array(rows_read(**E["04.5"].given(0)))
    for factors, words in (
        ([np.pi / 180, 1, 1, np.pi / 180], "θ and α in radians"),
        ([1, 1000, 1000, 1], "d and a in millimetres"),
        ([1, 1, 100, 1], "a in centimetres"),
    ):
        assert words in E["04.5"].judge((rows * factors).tolist()).headline
    axes, end = E["04.2"].given(0).values()
    (_, a, h), x, y = axes[1][0], [1, 0, 0], [0, 1, 0]
    tool = np.array(end)
    frames = [[[0, 0, 1], [0, 0, 0], x], [x, [0, a, h], y]]
    frames.append([tool[:3, 2], tool[:3, 3], tool[:3, 0]])
    assert E["04.2"].judge(frames).status == "right"
    thousand = [[z, np.multiply(1000, o), x] for z, o, x in frames]
    said = E["04.2"].judge(thousand)
    assert said.mistake == "length-unit" and "origins in millimetres" in said.headline


def test_a_mistyped_number_is_no_slip_of_units():
    value = right("02.3")
    for k in range(4):
        for other in (0, 2 * value[k], value[k] + 5):
            answer = [*value[:k], other, *value[k + 1 :]]
            assert "units" not in E["02.3"].judge(answer).headline


def test_a_sign_to_be_found_is_told_in_three_steps(fresh):
    def other_sign(theta, d, a, alpha):
        T = dh.transform.rot_z(theta) @ dh.transform.trans_z(d)
        T = T @ dh.transform.trans_x(a) @ dh.transform.rot_x(alpha)
        T[0, 2] *= -1
        return T

    first, second, third, fourth = (check("05.7", other_sign) for _ in range(4))
    assert not first.place and "column" not in str(first) and "sign" not in str(first)
    assert second.place and "sign" not in str(second) and second.headline == first.headline
    assert third == fourth and "sign" in str(third) and "row 1, column 3" in third.place


def test_a_colleagues_frames_do_not_tell_which_step_is_wrong_at_once(fresh):
    given = E["04.7"].given(0)
    tried = [[list(part) for part in frame] for frame in given["frames"]]
    tried[3][2] = [-1, 0, 0]
    first, second, third = (check("04.7", tried) for _ in range(3))
    assert "o1" not in str(first) and "foot" not in str(first)
    assert second.place == "o1" and "foot" not in str(second)
    assert "foot" in str(third)


def test_the_given_order_earns_nothing():
    verdict = E["05.3"].judge(["rz", "tz", "tx", "rx"])
    assert verdict.points == 0 and "order that was given" in verdict.headline


def test_a_makers_sheet_is_accepted_and_told_how_far_off_it_is():
    piper = dh.load("piper")
    assert "this arm was loaded" in E["09.4"].judge(piper).headline
    verdict = E["09.4"].judge(replace(piper, source=""))
    assert verdict.status == "right" and "within 0.0" in verdict.headline
    other = dh.load("piper.sdk_old")
    q = E["09.4"].poses_at(0)
    off = np.linalg.norm((other.forward(q) - dh.load("piper").forward(q))[:, :3, 3], axis=1).max()
    assert f"up to {1000 * off:.0f} mm" in E["09.4"].judge(other).headline


def test_drawn_poses_are_rotations_to_the_last_digit():
    """So that nothing but the answer can bend space."""
    for case in E["01.4"].cases(3):
        for T in case:
            assert np.allclose(T[:3, :3].T @ T[:3, :3], np.eye(3), atol=1e-14)
    for slip in (
        lambda A, B: np.block([[B[:3, :3] @ A[:3, :3], (A @ B)[:3, 3:]], [np.zeros((1, 3)), 1]]),
        lambda A, B: np.block(
            [[A[:3, :3] @ B[:3, :3], A[:3, :3] @ B[:3, 3:]], [np.zeros((1, 3)), 1]]
        ),
    ):
        verdict = E["01.4"].judge(slip)
        assert verdict.mistake and "bends" not in str(verdict)


def test_four_decimals_of_a_pose_pass_and_fewer_are_called_rounded():
    for variant in range(5):
        value = right("06.10", variant)
        assert E["06.10"].judge(value.round(4), variant).status == "right"
        verdict = E["06.10"].judge(value.round(2), variant)
        assert "rounded too early" in verdict.headline
        off = value.round(2)
        off[0, 3] += 0.01
        assert "rounded" not in E["06.10"].judge(off, variant).headline


def test_whole_numbers_that_were_rounded_are_not_said_to_be_cut_off():
    for variant in range(20):
        value = right("09.10", variant)
        verdict = E["09.10"].judge([int(value[0]), round(value[1])], variant)
        assert "cut off" not in str(verdict) and "array" not in str(verdict)


def test_centimetres_are_divided_by_a_hundred():
    value = right("05.5")
    assert "by 100," in E["05.5"].judge(100 * value).next
    assert "by 1000," in E["05.5"].judge(1000 * value).next


def test_two_offsets_that_make_up_for_each_other_are_not_put_down_to_lengths():
    rows = [[0, 0.1, 0, 90], [45, 0, 0.4, 0], [-45, 0, 0.35, 0]]
    rows += [[0, 0.1, 0, 90], [0, 0, 0, -90], [0, 0.1, 0, 0]]
    verdict = E["06.6"].judge(rows)
    assert "the rotation is right at every pose" in verdict.place and "length" not in verdict.place
    rows[1][0], rows[2][0], rows[1][2] = 90, -90, 0.5
    assert "length" in str(E["06.6"].judge(rows))


def test_the_table_of_the_other_convention_is_not_the_one_that_is_asked():
    for key, other in (("03.7", "standard"), ("03.8", "craig")):
        assert E[key].judge(E[key].right_arm().to(other)).status == "wrong"
        assert E[key].judge(E[key].right_arm()).status == "right"
    arm = E["09.7"].right_arm().to("craig")
    for answer in (arm, arm.table):
        verdict = E["09.7"].judge(answer)
        assert verdict.status == "wrong" and "Craig's rows of the right arm" in verdict.headline
    assert E["09.7"].judge(arm.to("standard").table).status == "right"


def test_an_angle_of_no_size_is_not_shown_in_powers_of_ten():
    turned = right("08.13") + [0, 0, 0, 0, 0, 0.5]
    headline = E["08.13"].judge(turned).headline
    assert "e-" not in headline and "28.6°" in headline


def test_the_way_back_in_the_goals_axes_is_not_said_to_be_right_anywhere():
    def back(T, T_goal):
        turn = vector(T_goal[:3, :3].T @ T[:3, :3])
        return np.hstack([T_goal[:3, 3] - T[:3, 3], turn])

    def vector(R):
        return Rotation.from_matrix(R).as_rotvec()

    goal = Rotation.from_rotvec([0.3, -0.2, 0.5]).as_matrix()
    unturned = np.eye(4), np.block([[goal, np.zeros((3, 1))], [np.zeros((1, 3)), np.ones((1, 1))]])
    assert not np.allclose(back(*unturned)[3:], [0.3, -0.2, 0.5])  # wrong at R = 1 too
    verdict = str(E["08.4"].judge(back))
    assert "leads back from the goal" in verdict and "right where" not in verdict


def test_two_slips_at_once_are_both_told():
    value = right("02.4")
    a, alpha = value[2], value[3]
    for answer, both in (
        ([value[0] - 180, value[1], a, -alpha], ("half a turn", "α has the wrong sign")),
        ([-value[0], value[1], a, -alpha], ("θ has the other sign", "α has the wrong sign")),
        ([np.deg2rad(value[0]), value[1], -a, alpha], ("minus sign", "θ in radians")),
    ):
        said = E["02.4"].judge(answer).headline
        assert said.startswith("two slips: ") and all(part in said for part in both)
    plate = right("01.2")
    left_handed = plate * [1, -1, 1, 1]
    said = E["01.2"].judge(left_handed.T).headline
    assert "left hand" in said and "transposed" in said
    no_pose = plate.copy()
    no_pose[3, 0] = 0.3  # to be inverted it is no pose, and nothing is said of an inverse
    assert E["01.2"].judge(no_pose).headline == "these are not the numbers"


def test_a_number_beyond_a_turn_is_no_nearer_to_the_right_angle():
    stop, at_stop = (E["09.10"].given(0)[name] for name in ("stop", "at_stop"))
    answer = [-1, np.deg2rad(stop) + at_stop * 360 / 4096]
    assert E["09.10"].judge(answer).headline == "these are not the numbers"


def test_what_is_said_of_one_mistake_alone_is_not_said_of_two():
    def exchanged_and_turned(theta, d, a, alpha):
        T = dh.transform.rot_z(theta) @ dh.transform.trans_z(a)
        return T @ dh.transform.trans_x(d) @ dh.transform.rot_x(-alpha)

    said = str(E["05.4"].judge(exchanged_and_turned))
    assert "several slips: a and d have changed places; and alpha has the wrong sign" in said
    assert "The rotation is right" not in said


def test_the_second_try_names_every_place(fresh):
    def spoilt(theta, d, a, alpha):
        T = E["05.7"].handed_out(theta, d, a, alpha)
        T[0, 1] *= -1
        return T

    _, second, _ = (check("05.7", spoilt) for _ in range(3))
    assert second.place == "row 1, column 2, right as it was handed out; row 2, column 3"


def test_a_message_of_python_is_shown_without_the_matrix_it_prints():
    def subtracted(T, T_goal):
        turn = Rotation.from_matrix(T_goal[:3, :3] - T[:3, :3]).as_rotvec()
        return np.hstack([T_goal[:3, 3] - T[:3, 3], turn])

    verdict = E["08.4"].judge(subtracted)
    assert "[[" not in verdict.headline and "is no rotation" in verdict.next
