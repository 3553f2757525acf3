"""Every exercise: right answers written differently pass, wrong ones fail and are named, an
untouched stub is no error.
"""

import inspect
from dataclasses import replace

import numpy as np
import pytest
from draws import few, variants
from right_ways_08 import RIGHT_WAYS

import dhlab as dh
from dhlab.course import check
from dhlab.course.exercises import exercises
from dhlab.course.exercises.offsets06 import UPRIGHT
from dhlab.course.kinds import Choice, Function, Order, Prediction, Table, Value
from dhlab.doctor.programs.explain import WRONG_VERSIONS
from dhlab.doctor.tables.rows import wrong_tables

SCORED = {key: e for key, e in exercises().items() if not isinstance(e, Prediction)}
VALUES = [key for key, e in SCORED.items() if isinstance(e, Value)]
FUNCTIONS = [key for key, e in SCORED.items() if isinstance(e, Function)]
VARIANTS = variants(6)


@pytest.mark.parametrize("key", SCORED)
def test_an_untouched_stub_is_not_attempted(key):
    def stub(*args):
        """What is asked."""

    untouched = [..., None, (..., ...), [...] * 4]
    if isinstance(SCORED[key], Function):

        def refuses(*args):
            raise NotImplementedError

        untouched += [stub, refuses]
    for answer in untouched:
        verdict = SCORED[key].judge(answer)
        assert verdict.status == "not attempted" and verdict.points == 0


NONSENSE = [
    float("nan"),
    "nonsense",
    {},
    [],
    [[]],
    object(),
    np.array([]),
    np.eye(4) * 7,
    lambda *a: print(),
    lambda *a: "x",
    3 + 4j,
    b"x",
    [[1], [1, 2]],
]


@pytest.mark.parametrize("key", SCORED)
def test_nonsense_is_wrong_and_never_an_error(key):
    taken = {}
    for answer in NONSENSE:
        try:
            verdict = SCORED[key].judge(answer)
            said = verdict.headline and "Traceback" not in str(verdict) and verdict._repr_html_()
            if not (verdict.status == "wrong" and verdict.points == 0 and said):
                taken[repr(answer)] = verdict
        except Exception as error:
            taken[repr(answer)] = error
    assert taken == {}


@pytest.mark.slow
@pytest.mark.parametrize("key", [key for key, e in SCORED.items() if isinstance(e, Table)])
def test_a_number_that_overflows_in_another_unit_is_wrong_and_no_error(key):
    for column in range(4):
        rows = SCORED[key].right_arm().table.rows.copy()
        rows[1, column] = 1e308
        assert SCORED[key].judge(rows, 0).status == "wrong"


@pytest.mark.parametrize("key", VALUES)
@pytest.mark.parametrize("variant", VARIANTS)
def test_values_right_in_any_dress(key, variant):
    exercise = SCORED[key]
    right = np.asarray(exercise.answer(**exercise.given(variant)), dtype=float)
    for answer in (
        right,
        right.tolist(),
        tuple(right.tolist()) if right.ndim else float(right),
        right.astype(np.float32),
        right + 1e-12,
        np.asmatrix(right) if right.ndim == 2 else right,
    ):
        assert exercise.judge(answer, variant).status == "right", key


@pytest.mark.parametrize("key", VALUES)
@pytest.mark.parametrize("variant", VARIANTS)
def test_known_wrong_values_fail_and_are_named(key, variant):
    given = SCORED[key].given(variant)
    known = list(SCORED[key].mistakes(**given))  # worked out once, not for every answer
    exercise = replace(SCORED[key], mistakes=lambda **given: known)
    right = np.asarray(exercise.answer(**given), dtype=float)
    seen = named = 0
    for _mistake, _, value in known:
        if np.allclose(value, right, rtol=2 * exercise.tolerance, atol=2 * exercise.tolerance):
            continue
        verdict = exercise.judge(value, variant)
        assert verdict.status == "wrong"
        seen, named = seen + 1, named + (verdict.mistake is not None)
    assert seen >= 5 and named == seen


@pytest.mark.parametrize("key", [key for key in VALUES if SCORED[key].given(0)])
def test_values_of_other_variants_are_wrong(key):
    exercise = SCORED[key]
    other = exercise.answer(**exercise.given(3))
    assert exercise.judge(other, 0).status == "wrong"


def remembering(function):
    """The function, which does not work the same call out again."""
    known = {}

    def remembered(*case):
        key = tuple(np.asarray(argument).tobytes() for argument in case)
        if key not in known:
            known[key] = function(*case)
        return np.copy(known[key])

    return remembered


@pytest.mark.slow
@pytest.mark.parametrize("key", FUNCTIONS)
def test_wrong_versions_fail_and_are_named(key, monkeypatch):
    """Each is compared with all, so that each is remembered."""
    family = SCORED[key].family
    exercise = replace(SCORED[key], answer=remembering(SCORED[key].answer))
    versions = [(*named, remembering(version)) for *named, version in WRONG_VERSIONS[family]]
    monkeypatch.setitem(WRONG_VERSIONS, family, versions)
    assert len({mistake for mistake, _, _ in versions}) >= 10
    for mistake, place, version in few(versions, 35):
        verdict = exercise.judge(version)
        if exercise.handed_out is not None and verdict.status == "not attempted":
            continue
        assert verdict.status == "wrong" and verdict.mistake == mistake, (mistake, place, verdict)


def closed(theta, d, a, alpha):
    c, s = np.cos(theta), np.sin(theta)
    u, v = np.cos(alpha), np.sin(alpha)
    return [[c, -s * u, s * v, a * c], [s, c * u, -c * v, a * s], [0, v, u, d], [0, 0, 0, 1]]


def by_blocks(theta, d, a, alpha):
    from scipy.spatial.transform import Rotation

    T = np.eye(4, dtype=np.float64)
    T[:3, :3] = (Rotation.from_euler("z", theta) * Rotation.from_euler("x", alpha)).as_matrix()
    T[:3, 3] = Rotation.from_euler("z", theta).apply([a, 0, d])
    return np.matrix(T)


def as_complex(theta, d, a, alpha):
    e, f = np.exp(1j * theta), np.exp(1j * alpha)
    print("thinking ...")
    return np.array(
        [
            [e.real, -e.imag * f.real, e.imag * f.imag, a * e.real],
            [e.imag, e.real * f.real, -e.real * f.imag, a * e.imag],
            [0, f.imag, f.real, d],
            [0, 0, 0, 1],
        ]
    )


def recursive(rows, q):
    return (
        np.eye(4)
        if len(q) == 0
        else np.array(closed(rows[0][0] + q[0], *rows[0][1:])) @ recursive(rows[1:], q[1:])
    )


def with_reduce(rows, q):
    from functools import reduce

    return reduce(
        np.matmul, [np.array(closed(r[0] + x, r[1], r[2], r[3])) for r, x in zip(rows, q)]
    ).tolist()


def with_the_library(rows, q):
    return dh.Arm(dh.DHTable.standard(rows, angle="rad")).forward(q)


def craig_closed(theta, d, a, alpha):
    c, s, u, v = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return [[c, -s, 0, a], [s * u, c * u, -v, -v * d], [s * v, c * v, u, u * d], [0, 0, 0, 1]]


def craig_by_blocks(theta, d, a, alpha):
    from scipy.spatial.transform import Rotation

    turned = Rotation.from_euler("x", alpha)
    return np.vstack(
        [
            np.column_stack(
                [
                    (turned * Rotation.from_euler("z", theta)).as_matrix(),
                    turned.apply([0, 0, d]) + [a, 0, 0],
                ]
            ),
            [0, 0, 0, 1],
        ]
    )


RIGHT_FUNCTIONS = {
    "03.3": [
        craig_closed,
        craig_by_blocks,
        lambda th, d, a, al: np.linalg.inv(closed(-th, -d, -a, -al)),
    ],
    "01.4": [
        lambda A, B: A @ B,
        lambda A, B: np.dot(A, B).tolist(),
        lambda A, B: np.block(
            [[A[:3, :3] @ B[:3, :3], A[:3, :3] @ B[:3, 3:] + A[:3, 3:]], [np.zeros((1, 3)), 1]]
        ),
    ],
    "05.1": [
        lambda al: closed(0, 0, 0, al),
        lambda al: np.array(closed(0, 0, 0, al)),
        lambda al: by_blocks(0, 0, 0, al),
    ],
    "05.4": [closed, by_blocks, as_complex],
    "05.6": [closed, by_blocks, as_complex],
    "05.7": [closed, by_blocks, as_complex],
    "06.2": [recursive, with_reduce, with_the_library],
    "06.7": [recursive, with_reduce, with_the_library],
    "07.2": [recursive, with_reduce, with_the_library],
    "09.8": [recursive, with_reduce, with_the_library],
    **RIGHT_WAYS,
}


@pytest.mark.slow
@pytest.mark.parametrize("key", FUNCTIONS)
def test_three_right_ways_pass(key):
    for f in RIGHT_FUNCTIONS[key]:
        for variant in VARIANTS:
            verdict = SCORED[key].judge(f, variant)
            assert verdict.status == "right" and verdict.points == verdict.of, (key, verdict)


def _state(rows, q, T=np.eye(4)):  # noqa: B008  (the mistake that is meant)
    for row, x in zip(rows, q):
        T[:] = T @ closed(row[0] + x, *row[1:])
    return T


def _spoils_its_input(rows, q):
    q += rows[:, 0]
    return recursive(rows * [0, 1, 1, 1], q)


@pytest.mark.parametrize(
    "f, words",
    [
        (_state, "another answer"),
        (_spoils_its_input, "changes the numbers"),
        (lambda rows, q: np.eye(3), "shape 3×3"),
        (lambda rows, q: 1 / 0, "ZeroDivisionError"),
        (lambda rows: np.eye(4), "TypeError"),
        (lambda rows, q: np.full((4, 4), np.nan), "NaN"),
        (lambda rows, q: print(q), "returns nothing"),
        (lambda rows, q: np.eye(4), "same whatever"),
        (lambda rows, q: recursive(rows, q)[:3], "shape 3×4"),
        (lambda rows, q: "T", "a text"),
    ],
)
def test_what_goes_wrong_with_a_program_is_said(f, words, capsys):
    verdict = check("06.2", f)
    assert verdict.status == "wrong" and words in str(verdict)
    assert capsys.readouterr().out == ""


def test_every_right_table_passes():
    right = dh.Arm(dh.DHTable.standard(UPRIGHT, angle="deg"))
    slid = [list(row) for row in UPRIGHT]
    slid[1][1], slid[3][1] = 0.1, 0.0  # d moved along the parallel axes 2, 3, 4
    flipped = [list(row) for row in UPRIGHT]  # x2 turned round: a2, alpha2, theta2, theta3
    flipped[1] = [270, 0, -0.4, 0]
    flipped[2][0] = -270
    turns = [[theta + 360, d, a, alpha - 360] for theta, d, a, alpha in UPRIGHT]
    for answer in (
        UPRIGHT,
        [tuple(row) for row in UPRIGHT],
        np.array(UPRIGHT),
        right,
        right.table,
        slid,
        flipped,
        turns,
    ):
        assert check("06.6", answer).status == "right"


@pytest.mark.slow
def test_wrong_tables_fail_and_are_named():
    exercise = SCORED["06.6"]
    assert isinstance(exercise, Table)
    visible = 0
    for mistake, place, table in few(wrong_tables(exercise.right_arm().table), 40):
        if np.allclose(
            dh.Arm(table).forward(exercise.poses_at(0)),
            exercise.right_arm().forward(exercise.poses_at(0)),
            atol=1e-9,
        ):
            continue
        verdict = exercise.judge(table)
        visible += 1
        assert verdict.status == "wrong" and verdict.mistake is not None, (mistake, place, verdict)
    assert visible >= 10
    assert "found 5" in str(check("06.6", UPRIGHT[:5])) and "row 2" in str(
        check("06.6", [UPRIGHT[0], [..., 0, 0.4, 0], *UPRIGHT[2:]])
    )


@pytest.mark.parametrize("key", [key for key, e in SCORED.items() if isinstance(e, Choice)])
def test_choices(key):
    exercise = SCORED[key]
    for letter, (key, option) in zip("abcdef", exercise.options.items()):
        for dress in (letter, letter.upper(), f" {letter} ", key):
            verdict = exercise.judge(dress)
            assert (
                verdict.status == ("right" if key == exercise.correct else "wrong")
                and verdict.headline == option.answer
                and verdict.chosen == (key,)
                and (verdict.status == "right" or verdict.next)
            )
            assert (verdict.mistake is None) == (key == exercise.correct)
    assert exercise.judge("?").status == "wrong" and exercise.judge("?").chosen == ("?",)
    assert "expected one of" in exercise.judge("z").headline


def test_the_four_other_orders_of_the_moves_pass_and_no_other():
    from itertools import permutations

    from dhlab.transform import rot_x, rot_z, trans_x, trans_z

    exercise = SCORED["05.3"]
    assert isinstance(exercise, Order)
    moves = {"a": rot_z(0.3), "b": trans_z(0.2), "c": trans_x(0.4), "d": rot_x(0.5)}
    for order in permutations("abcd"):
        w, x, y, z = (moves[letter] for letter in order)
        right = np.allclose(w @ x @ y @ z, closed(0.3, 0.2, 0.4, 0.5)) and order != tuple("abcd")
        verdict = exercise.judge(list(order))
        assert (verdict.status == "right") == right and (right or verdict.mistake)
    assert (
        exercise.judge("badc").status == "right" and exercise.judge("a, c, b, d").status == "right"
    )


def test_numbers_come_from_the_seed_alone():
    for exercise in SCORED.values():
        assert repr(exercise.given(5)) == repr(exercise.given(5))
    assert repr(SCORED["01.1"].given(5)) != repr(SCORED["01.1"].given(6))


def test_the_storys_numbers_come_from_one_reversed_axis():
    arm, cup = dh.load("article-6r"), np.deg2rad([30, 60, -80, -30, 40, 0])
    rows = arm.table.rows
    rows[3, 3] *= -1
    arrived = dh.Arm(dh.DHTable.standard(rows, angle="rad")).forward(cup)[:3, 3]
    assert np.allclose(arrived, [0.434, 0.224, 0.376], atol=5e-4)


def test_no_hint_holds_the_answer():
    for exercise in SCORED.values():
        assert len(exercise.hints) == 2
        if isinstance(exercise, Choice):
            assert exercise.options[exercise.correct].text not in " ".join(exercise.hints)
        if isinstance(exercise, Function):
            assert not any("return" in h or ("@" in h and "=" in h) for h in exercise.hints), (
                exercise.id
            )


def test_feedback_never_holds_expected_numbers():
    for key in VALUES:
        exercise = SCORED[key]
        right = np.asarray(exercise.answer(**exercise.given(0)), dtype=float)
        said = str(exercise.judge((right + 0.37).tolist()))
        assert not any(f"{value:.3f}" in said for value in np.ravel(right) if abs(value) > 0.01), (
            key
        )
    assert "expected" not in inspect.signature(check).parameters


@pytest.mark.parametrize(
    "exercise", [e for e in exercises().values() if isinstance(e, Order)], ids=lambda e: e.id
)
def test_any_letters_in_any_number_get_a_verdict(exercise):
    rng = np.random.default_rng(3)
    letters, places = exercise.letters(), exercise.size
    for length in (*[places] * 300, places - 1, places + 1, 0):
        given = rng.choice(list(letters), length).tolist()
        verdict = exercise.judge([letters[key] for key in given])
        assert verdict == exercise.judge(given), "letters and ids say the same"
        assert (verdict.status == "right") == (length == places and bool(exercise.accepts(given)))
        assert length == 0 or verdict.headline
    first, letter = next(iter(letters.items()))
    assert (
        exercise.repeats
        or exercise.judge([first] * places).headline == f"{letter} stands there twice"
    )
    for undecided in ("?", ["?"] * places, [letter, "?"]):
        assert exercise.judge(undecided).headline == exercise.undecided
