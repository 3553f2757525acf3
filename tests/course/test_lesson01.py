"""Lesson 01: wrong answers are met in the words of the task, whatever their shape; no two of them
are taken for each other.
"""

from itertools import combinations, permutations

import numpy as np
import pytest
from draws import variants

from dhlab.course.exercises import exercises
from dhlab.doctor.programs.explain import WRONG_VERSIONS
from dhlab.transform import from_xyz_rpy, trans

VARIANTS = variants(20)
EXERCISES = {key: e for key, e in exercises().items() if key.startswith("01.")}
LATER = (
    "loop",
    "range(",
    "T_06",
    "Your matrix",
    "A_1",
    "position is right",
    "rotation is right",
    "last link",
)


def said(key, answer, variant=0):
    """The verdict on a wrong answer, in which nothing of a later lesson stands."""
    verdict = EXERCISES[key].judge(answer, variant)
    assert verdict.status == "wrong" and verdict.headline and verdict.next
    assert not any(word in str(verdict) for word in LATER), verdict
    return verdict


@pytest.mark.parametrize("key", ["01.1", "01.3", "01.7"])
@pytest.mark.parametrize("variant", VARIANTS)
def test_no_two_mistakes_have_one_answer(key, variant):
    exercise = EXERCISES[key]
    given = exercise.given(variant)
    wrong = [(mistake, np.asarray(value)) for mistake, _, value in exercise.mistakes(**given)]
    for mistake, value in wrong:
        assert said(key, value, variant).mistake == mistake
    for (_, one), (_, other) in combinations(
        [("right", np.asarray(exercise.answer(**given))), *wrong], 2
    ):
        assert np.abs(one - other).max() > 2e-3


@pytest.mark.parametrize("variant", VARIANTS)
def test_an_arrow_with_its_zero(variant):
    T = EXERCISES["01.1"].given(variant)["T_01"]
    assert (
        "last 0" in said("01.1", T[:, 0], variant).headline
        and "last 0" in said("01.1", T[:, [0]], variant).headline
    )
    assert EXERCISES["01.1"].judge(T[:3, [0]], variant).status == "right"
    for row in (T[0], T[0, :3], T[[0], :]):
        assert said("01.1", row, variant).mistake == "rotation-transposed"
    assert said("01.1", T[:, 1], variant).headline == "expected 3 numbers, found 4 numbers"


@pytest.mark.parametrize("variant", VARIANTS)
def test_a_point_of_the_second_plate(variant):
    T, p = EXERCISES["01.3"].given(variant).values()
    R, t, p = T[:3, :3], T[:3, 3], np.array(p)
    words = {
        "shift of plate 1 is missing": R @ p,
        "shifted first": R @ (p + t),
        "turned the wrong way": p @ R + t,
        "p_12 itself": p,
        "were added": p + t,
        "origin of plate 1": t,
        "the other way": R.T @ (p - t),
        "in place of @": R * p + t,
        "the turned p_12 was taken away": t - R @ p,
        "the shift of plate 1 was taken away": R @ p - t,
    }
    for headline, answer in words.items():
        told = said("01.3", answer, variant).headline
        assert headline in told and "two slips" not in told
    for answer in (T @ [*p, 1], T @ np.array([[*p, 1]]).T):
        assert "1 at the end" in said("01.3", answer, variant).headline
    assert said("01.3", T @ [*p, 0], variant).mistake == "product-stops-early"
    for right in ((T @ trans(p))[:3, [3]], (T @ [*p, 1])[:3]):
        assert EXERCISES["01.3"].judge(right, variant).status == "right"


@pytest.mark.parametrize("variant", VARIANTS)
def test_the_tip_of_the_gripper(variant):
    A, B = EXERCISES["01.7"].given(variant).values()
    R, p, t = A[:3, :3], A[:3, 3], B[:3, 3]
    words = {
        "flange's origin": p,
        "were added": p + t,
        "reverse order": (B @ A)[:3, 3],
        "turned the wrong way": R.T @ t + p,
        "from the base to the flange": R @ t,
        "shifted first": R @ (p + t),
        "the tool's shift was taken away": p - R @ t,
        "the way to the flange was taken away": R @ t - p,
        "1 at the end": (A @ B)[:, 3],
        "whole pose": A @ B,
    }
    for headline, answer in words.items():
        told = said("01.7", answer, variant).headline
        assert headline in told and "two slips" not in told


def test_the_order_of_the_chain():
    for letters in permutations("abcdef", 4):
        if letters != tuple("ecad"):
            verdict = said("01.5", list(letters))
            assert verdict.mistake == (
                "pose-inverted" if {"f", "b"} & set(letters) else "product-reversed"
            )
    assert said("01.5", "ecaf").place == "T_2F, then T_TF: F does not meet T"
    assert said("01.5", "cadf").place == "the product begins with 1 and ends with F"
    assert "reverse order" in said("01.5", "dace").headline


def test_composing():
    for mistake, _, version in WRONG_VERSIONS["compose"]:
        if mistake in (
            "product-reversed",
            "translations-not-rotated",
            "pose-inverted",
            "matrix-transposed",
            "product-stops-early",
            "product-starts-late",
        ):
            assert said("01.4", version).mistake == mistake


@pytest.mark.parametrize("variant", [0, 1, 2])
def test_building_with_degrees(variant):
    verdict = said(
        "01.2", from_xyz_rpy(list(EXERCISES["01.2"].given(variant).values()), [0, 0, 90]), variant
    )
    assert verdict.mistake == "degrees-in-sin-cos" and "jumps" not in str(verdict)
