"""The doctor's answers to programs: a corpus in learners' styles, and what keeps a program from
being compared.
"""

import numpy as np
import pytest
from wrong_programs import LINK, RIGHT, WRONG, program

from dhlab.doctor import catalogue
from dhlab.doctor.mistakes.entries import MONOMIALS, RIGHT_ENTRIES
from dhlab.doctor.programs.explain import explain_all, explain_function
from dhlab.doctor.programs.functions import diagnose_function
from dhlab.doctor.programs.wrong.links import standard
from dhlab.doctor.programs.wrong.products import product
from dhlab.kinematics import link_matrices
from dhlab.transform import rot_y

CHAIN = (
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(row[0] + x, *row[1:])
    return T
"""
)


@pytest.mark.slow
@pytest.mark.parametrize(
    "kind, expected, text",
    WRONG,
    ids=[f"{k}-{'+'.join(ids)}" for k, (_, ids, _) in enumerate(WRONG)],
)
def test_wrong_programs_are_named(kind, expected, text):
    answer = diagnose_function(program(kind, text), kind)
    found = [finding.mistake for finding in answer.findings]
    assert answer.verdict == "explained" and not answer and found
    assert set(expected) <= {*found, *answer.findings[0].look_alikes}, str(answer)
    assert len(found) == 1 or len(expected) == 2
    assert (
        catalogue()[found[0]].title in str(answer)
        and answer.to_dict()["verdict"] == "explained"
        and answer._repr_html_()
    )


@pytest.mark.parametrize("kind, text", RIGHT)
def test_right_programs_agree(kind, text, capsys):
    answer = diagnose_function(program(kind, text), kind)
    assert answer.verdict == "agrees" and answer and not answer.findings
    assert capsys.readouterr().out == ""


def test_the_corpus_is_what_it_says():
    assert (
        len(WRONG) >= 60
        and len(RIGHT) >= 12
        and sum(len(expected) == 2 for _, expected, _ in WRONG) >= 10
    )
    assert len({text for _, _, text in WRONG}) == len(WRONG)
    assert {name for _, expected, _ in WRONG for name in expected} <= catalogue().keys()
    assert not any("dhlab" in text for _, _, text in WRONG)


def _chains(rng, m=6):
    for n in rng.integers(2, 6, m):
        rows = rng.uniform(0.15, 0.6, (n, 4)) * rng.choice([-1, 1], (n, 4))
        yield rows * [2.3, 1, 1, 2.3], rng.uniform(0.2, 1.4, n)


@pytest.mark.slow
@pytest.mark.parametrize("entry", RIGHT_ENTRIES)
def test_every_mistyped_entry_is_found_at_its_place(entry):
    rows = np.random.default_rng(3).uniform(0.2, 1.2, (8, 4))
    for monomial in MONOMIALS:
        answers = link_matrices("standard", *rows.T)
        answers[(slice(None), *entry)] = monomial(*rows.T)
        if monomial == RIGHT_ENTRIES[entry]:
            assert (
                explain_all(answers, link_matrices("standard", *rows.T), rows, "dh_transform") == ()
            )
            continue
        finding = explain_function(
            answers, link_matrices("standard", *rows.T), rows, "dh_transform"
        )
        alike = (
            finding.mistake != "matrix-entry-mistyped"
            and "matrix-entry-mistyped" in finding.look_alikes
        )
        assert alike or finding.place.startswith(f"row {entry[0] + 1}, column {entry[1] + 1}: "), (
            monomial,
            finding,
        )


@pytest.mark.slow
def test_garbage_is_not_explained():
    rng = np.random.default_rng(5)
    for _ in range(20):
        cases = list(_chains(rng))
        right = [product(*case) for case in cases]
        other = [product(*case) for case in _chains(rng)]
        assert explain_all(other, right, cases, "forward_kinematics") == ()
    for noise in (0.05, 0.3):
        answer = diagnose_function(
            lambda *row, noise=noise: standard(*row) @ rot_y(noise * np.sin(7 * sum(row))),
            "dh_transform",
        )
        assert answer.verdict == "unexplained" and not answer.findings and answer.before[1] > 1


@pytest.mark.parametrize(
    "f, kind, words",
    [
        (lambda rows, q: 1 / 0, "forward_kinematics", "ZeroDivisionError"),
        (lambda rows: np.eye(4), "forward_kinematics", "2 arguments"),
        (lambda theta, d, a: np.eye(4), "dh_transform", "it takes theta, d, a"),
        (lambda *row: np.full((4, 4), np.inf), "dh_transform", "NaN or infinity"),
        (lambda *row: print(row), "dh_transform", "returns nothing"),
        (lambda *row: "T", "dh_transform", "a text"),
        (lambda *row: np.eye(2), "dh_transform", "2×2"),
        (lambda rows, q: [np.eye(4)] * len(q), "forward_kinematics", "shape"),
        (lambda *row: exit(), "dh_transform", "SystemExit"),
        (lambda *row: np.eye(4), "dh_transform", "same whatever"),
        (lambda *row: {}[row], "dh_transform", "KeyError"),
        (lambda theta, d, a, alpha: ..., "dh_transform", "Nothing is written"),
    ],
)
def test_what_cannot_be_compared_is_said(f, kind, words):
    answer = diagnose_function(f, kind)
    assert (
        answer.verdict == "unexplained" and words in str(answer) and "Traceback" not in str(answer)
    )


def test_a_sign_lost_in_abs_is_seen_only_where_it_acts():
    answer = diagnose_function(
        lambda theta, d, a, alpha: standard(abs(theta), d, a, alpha), "dh_transform"
    )
    assert (
        answer.findings[0].mistake == "sign-lost"
        and answer.findings[0].place == "the sine of theta"
    )
    in_one = diagnose_function(
        lambda theta, d, a, alpha: standard(theta, d, a, 2 * alpha if a < -0.3 else alpha),
        "dh_transform",
    )
    assert in_one.verdict == "unexplained" and "Right in" in str(in_one)
    only_special = diagnose_function(
        lambda theta, d, a, alpha: standard(theta, d, a, alpha) * (theta != 0 or np.nan_to_num(2)),
        "dh_transform",
    )
    assert (
        only_special.verdict == "unexplained"
        and "Right at general numbers" in only_special.headline
    )


def test_wrong_use_is_one_sentence():
    with pytest.raises(ValueError, match="without brackets"):
        diagnose_function(np.eye(4), "dh_transform")
    with pytest.raises(ValueError, match="expected the kind"):
        diagnose_function(standard, "fk")


def test_the_course_hears_of_both_mistakes():
    cases = list(_chains(np.random.default_rng(6)))
    right = [product(*case) for case in cases]
    answers = [np.linalg.inv(product(rows * [0, 1, 1, 1], q)) for rows, q in cases]
    finding = explain_function(answers, right, cases, "forward_kinematics")
    said = finding.message
    assert all(catalogue()[name].title in said for name in ("pose-inverted", "offset-missing"))


def test_the_same_program_twice_gets_the_same_answer():
    f = program(
        "forward_kinematics", CHAIN.replace("T @ dh", "dh").replace("*row[1:])", "*row[1:]) @ T")
    )
    assert str(diagnose_function(f, "forward_kinematics")) == str(
        diagnose_function(f, "forward_kinematics")
    )


def _reversed_at(k):
    def f(rows, q):
        sense = np.ones(len(q))
        sense[k : k + 1 or None] = -1
        return product(rows, q * sense)

    return f


@pytest.mark.parametrize(
    "f, mistake, place",
    [
        (_reversed_at(2), "joint-reversed", "joint 3"),
        (_reversed_at(-1), "joint-reversed", "the last row"),
        (lambda rows, q: product(rows, q) @ rot_y(0.3), "tool-missing", "a turn by 17.19°"),
        (lambda rows, q: rot_y(0.3) @ product(rows, q), "base-turned", "before the first link"),
        (
            lambda rows, q: product(rows * np.where(np.arange(len(q)) == 1, -1, 1)[:, None], q),
            "unexplained",
            "",
        ),
    ],
)
def test_a_program_may_be_right_for_another_arm(f, mistake, place):
    answer = diagnose_function(f, "forward_kinematics")
    if mistake == "unexplained":
        assert answer.verdict == mistake and not answer.findings
    else:
        assert answer.findings[0].mistake == mistake and place in answer.findings[0].place


def test_zeros_are_no_whole_numbers():
    """A matrix that is filled by adding to zeros and never added to."""
    answer = diagnose_function(lambda theta, d, a, alpha: np.zeros((4, 4), int), "dh_transform")
    assert [finding.mistake for finding in answer.findings] == ["product-from-zeros"]


def test_a_cache_that_leaves_an_argument_out_is_seen():
    kept = {}

    def cached(theta, d, a, alpha):
        return kept.setdefault((d, a, alpha), standard(theta, d, a, alpha))

    assert not diagnose_function(cached, "dh_transform")


def test_lengths_that_are_left_out_are_no_whole_numbers():
    answer = diagnose_function(lambda t, d, a, alpha: standard(t, 0, 0, alpha), "dh_transform")
    assert not answer and "integer-arrays" not in {f.mistake for f in answer.findings}


@pytest.mark.parametrize(
    "cut, mistake, place",
    [(int, "integer-arrays", "d"), (lambda d: 0, "length-value", "d has no effect")],
)
def test_a_length_that_is_cut_is_not_said_to_have_no_effect(cut, mistake, place):
    answer = diagnose_function(
        lambda theta, d, a, alpha: standard(theta, cut(d), a, alpha), "dh_transform"
    )
    assert [(f.mistake, f.place) for f in answer.findings] == [(mistake, place)]
