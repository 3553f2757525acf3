"""Lesson 05: what is said of wrong answers fits what was done, in the words of the exercise."""

import numpy as np
import pytest
from draws import variants

from dhlab.course.exercises import exercises
from dhlab.transform import rot_x, rot_z, trans_x, trans_z

VARIANTS = variants(4)
E = {key: e for key, e in exercises().items() if key.startswith("05.")}
HALF = np.pi / 2


def link(theta, d, a, alpha):
    return rot_z(theta) @ trans_z(d) @ trans_x(a) @ rot_x(alpha)


def typed(columns):
    """A dh_transform with other second and third columns; ``columns`` of (cos θ, sin θ, cos α, sin
    α).
    """

    def dh_transform(theta, d, a, alpha):
        T = link(theta, d, a, alpha)
        T[:3, 1:3] = columns(np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha))
        return T

    return dh_transform


COLUMNS = [
    (
        lambda c, s, u, v: [[-s * u, -s * v], [c * u, c * v], [v, u]],
        "matrix-entry-mistyped",
        "column 3 points the wrong way",
    ),
    (
        lambda c, s, u, v: [[s * u, s * v], [-c * u, -c * v], [v, u]],
        "matrix-entry-mistyped",
        "column 2 points the wrong way",
    ),
    (
        lambda c, s, u, v: [[-s * u, -s * v], [c * u, -c * v], [v, u]],
        "matrix-entry-mistyped",
        "one entry is wrong",
    ),
    (
        lambda c, s, u, v: [[-s, s * v], [c, -c * v], [v, u]],
        "matrix-entry-mistyped",
        "2 entries are wrong",
    ),
    (
        lambda c, s, u, v: [[-s * u, -s * v], [c * u, c * v], [v, -u]],
        "mirror",
        "one arrow points the wrong way",
    ),
    (
        lambda c, s, u, v: [[-c * u, c * v], [s * u, -s * v], [v, u]],
        "not-rigid",
        "columns 1 and 2 are not at right angles",
    ),
    (lambda c, s, u, v: [[-s, 0], [c, 0], [v, u]], "not-rigid", "column 2 does not have length 1"),
    (
        lambda c, s, u, v: [[-s * u, s * v], [-c * u, c * v], [v, 1]],
        "matrix-entry-mistyped",
        "3 entries are wrong",
    ),
]


@pytest.mark.parametrize("key", ["05.6", "05.7"])
@pytest.mark.parametrize("columns, mistake, headline", COLUMNS)
def test_a_wrong_column_is_named(key, columns, mistake, headline):
    for variant in VARIANTS:
        verdict = E[key].judge(typed(columns), variant)
        assert (verdict.status, verdict.mistake, verdict.headline) == (
            "wrong",
            mistake,
            headline,
        ) and "second thing" not in str(verdict)
        assert verdict.next and "hint(" not in verdict.next


def test_the_handed_out_program_is_no_attempt_and_hides_where_the_praise_says():
    wrong = typed(lambda c, s, u, v: [[-s * u, s * v], [c * u, c * v], [v, u]])
    assert (
        E["05.7"].judge(wrong).status == "not attempted"
        and E["05.6"].judge(wrong).status == "wrong"
    )
    for theta, alpha, hidden in (
        (0, 0.5, False),
        (0.7, 0, True),
        (HALF, 0.5, True),
        (-HALF, 0.5, True),
        (0.7, 0.5, False),
    ):
        row = theta, 0.2, 0.3, alpha
        assert np.allclose(wrong(*row), link(*row)) == hidden
    assert "α is 0" in E["05.7"].praise and "±90°" in E["05.7"].praise


def test_the_order_of_craig_is_told_and_named_where_moves_are_multiplied():
    def reversed_product(theta, d, a, alpha):
        return rot_x(alpha) @ trans_x(a) @ trans_z(d) @ rot_z(theta)

    for variant in VARIANTS:
        said = [E[key].judge(reversed_product, variant) for key in ("05.4", "05.6")] + [
            E["05.3"].judge(order) for order in ("cdab", "dcba")
        ]
        assert all(
            v.mistake == "standard-rows-in-craig-matrix" and "x moves come before" in v.headline
            for v in said
        )
        assert all("Craig" in v.headline for v in said[:2])


@pytest.mark.parametrize(
    "theta, alpha, named",
    [(-90, HALF, "θ is in degrees"), (-HALF, 90, "α is in degrees"), (-90, 90, "both angles")],
)
def test_the_angle_that_is_in_degrees_is_named(theta, alpha, named):
    for variant in VARIANTS:
        answer = link(theta, E["05.9"].given(variant)["q3"], 0.05, alpha)
        verdict = E["05.9"].judge(answer, variant)
        assert verdict.mistake == "degrees-in-sin-cos" and verdict.headline.startswith(named)


@pytest.mark.parametrize(
    "answer, found",
    [
        (np.array([["1", "?"]]), "one with the text '?' in it"),
        ([[1, {}], [0, 1]], "one with an entry that is no number"),
        ("pose", "a text"),
        ({}, "an object of the type dict"),
    ],
)
def test_what_is_no_array_of_numbers_is_named(answer, found):
    verdict = E["05.6"].judge(lambda theta, d, a, alpha: answer)
    assert verdict.headline == f"expected an array of 4×4 numbers, found {found}"


def test_orders_say_which_move_stands_too_early():
    for order, early in (
        ("cabd", "Tx(a) stands before Rz(θ)"),
        ("dabc", "Rx(α) stands before Tz(d)"),
        ("bdac", "Rx(α) stands before Rz(θ)"),
    ):
        assert E["05.3"].judge(order).headline == early
    assert E["05.3"].judge(["a", "a", "c", "d"]).status == "wrong"


def test_the_turn_about_x_the_other_way():
    for variant in VARIANTS:
        verdict = E["05.1"].judge(lambda alpha: rot_x(-alpha), variant)
        assert (
            verdict.mistake == "rotation-transposed"
            and "second column" in verdict.next
            and "position" not in str(verdict)
        )
        for signs, mistake in (
            ([[1, 1], [1, 1]], "mirror"),
            ([[1, -1], [-1, 1]], "mirror"),
            ([[1, 1], [1, -1]], "matrix-entry-mistyped"),
        ):

            def turn(alpha, signs=signs):
                T = np.eye(4)
                T[1:3, 1:3] = np.array(signs) * [
                    [np.cos(alpha), np.sin(alpha)],
                    [np.sin(alpha), np.cos(alpha)],
                ]
                return T

            verdict = E["05.1"].judge(turn, variant)
            assert verdict.mistake == mistake and "determinant" not in str(verdict)


@pytest.mark.parametrize("variant", VARIANTS)
def test_wrong_origins(variant):
    row = E["05.5"].given(variant)
    t = np.deg2rad(row["theta"])
    verdict = E["05.5"].judge([row["a"] * np.sin(t), row["a"] * np.cos(t), row["d"]], variant)
    assert (
        verdict.mistake == "sin-cos-exchanged"
        and "θ" in verdict.headline
        and "alpha" not in str(verdict)
    )
    assert (
        E["05.5"]
        .judge(np.round([row["a"] * np.cos(t), row["a"] * np.sin(t), row["d"]], 2), variant)
        .mistake
        == "pi-rounded"
    )


@pytest.mark.parametrize("variant", VARIANTS)
def test_wrong_slides(variant):
    q3 = E["05.9"].given(variant)["q3"]
    for row, mistake, headline in (
        ((-HALF, 0, 0.05, HALF), "joint-values-unused", "q3 is left out"),
        ((HALF, q3, 0.05, HALF), "offset-sign", "θ is −90° here, not +90°"),
        ((0, q3, 0.05, HALF), "offset-missing", "θ is −90° here, not 0"),
        ((-1.57, q3, 0.05, 1.57), "pi-rounded", "rounded on the way"),
        ((-1.5708, q3, 0.05, HALF), "pi-rounded", "rounded on the way"),
        ((HALF, q3, 0.05, -HALF), "theta-alpha-exchanged", None),
        ((q3, 0, 0.05, HALF), "prismatic-variable-in-theta", None),
        ((-HALF, q3, 0.05, -HALF), "alpha-sign", "α is +90° here, not −90°"),
    ):
        verdict = E["05.9"].judge(link(*row), variant)
        assert (
            verdict.status == "wrong"
            and verdict.mistake == mistake
            and headline in (None, verdict.headline)
        )
    assert "q[i]" not in E["05.9"].judge(link(-HALF, 0, 0.05, HALF), variant).next
