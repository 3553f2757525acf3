"""Every sentence of every exercise is true of the answer it is said of: decided by a predicate of
its own in ``claims``; a sentence without one fails.
"""

import numpy as np
import pytest
from claims import boards, judged, sentence
from claims.advice import unfounded
from draws import few, variants
from wrong_answers import double_slips, unforeseen, wrong_answers, wrong_frames

from dhlab.course.exercises import exercises
from dhlab.course.kinds import Order, Table, Value
from dhlab.course.kinds.frames.placed import Frames
from dhlab.geometry.procedure.frames import assign_frames

ASKED = {key: e for key, e in exercises().items() if isinstance(e, (Value, Table, Order))}
KEYS = [  # a table is compared with some hundred others for each verdict; 07.7 calibrates an arm
    pytest.param(key, marks=pytest.mark.slow) if isinstance(e, Table) or key == "07.7" else key
    for key, e in ASKED.items()
]


def refused(exercise, answers, variant):
    """(answer, verdict) of each that is told something."""
    for answer in answers:
        verdict = exercise.judge(answer, variant)
        if verdict.status == "wrong":
            yield answer, verdict


@pytest.mark.slow
@pytest.mark.parametrize("key", KEYS)
def test_every_sentence_has_a_predicate_and_is_true(key):
    exercise = ASKED[key]
    for variant in variants(1):
        # of a table a few, so that most mistakes are met in one row
        most = 20 if isinstance(exercise, Table) else 40
        answers = few(wrong_answers(exercise, variant), most)
        for answer, verdict in refused(exercise, answers, variant):
            assert judged(exercise, verdict, answer, variant) is not None, (
                f"no predicate: {sentence(verdict)}"
            )
            assert judged(exercise, verdict, answer, variant), f"not true: {verdict} of {answer}"
            assert not [*unfounded(exercise, verdict, answer, variant)], f"{verdict} of {answer}"


@pytest.mark.parametrize("key", KEYS)
def test_a_mistake_that_no_list_foresees_is_told_where_it_is(key):
    """What is named all the same must be true."""
    exercise = ASKED[key]
    answers = unforeseen(exercise, 1)
    seen = list(refused(exercise, answers, 1))
    assert len(seen) >= min(5, len(answers)), "five answers and more are refused"
    for answer, verdict in seen:
        assert judged(exercise, verdict, answer, 1), f"not true: {verdict} of {answer}"
        assert not [*unfounded(exercise, verdict, answer, 1)], f"{verdict} of {answer}"


@pytest.mark.parametrize(
    "key", ["02.3", "02.4", "02.7", "02.8", "03.7", "03.8", "03.9", "04.5", "09.7"]
)
@pytest.mark.parametrize("variant", variants(2))
def test_of_two_slips_by_hand_nothing_untrue_is_said(key, variant):
    exercise = ASKED[key]
    for answer, verdict in refused(exercise, double_slips(exercise, variant, 12), variant):
        assert judged(exercise, verdict, answer, variant), f"not true: {verdict} of {answer}"
        assert not [*unfounded(exercise, verdict, answer, variant)], f"{verdict} of {answer}"


def placed(given):
    """Right frames of a task, as rows of z, origin and x."""
    arm = assign_frames(given["axes"], end=given["end"])
    return [[T[:3, 2], T[:3, 3], T[:3, 0]] for T in arm.frames(np.zeros(len(arm)))]


def in_millimetres(rows):
    """All origins, one origin, and one number of an origin in millimetres."""
    yield [[z, 1000 * o, x] for z, o, x in rows]
    for i, (z, o, x) in enumerate(rows):
        for times in ([1000] * 3, [1000, 1, 1], [1, 1, 1000]):
            yield [*rows[:i], [z, o * times, x], *rows[i + 1 :]]


@pytest.mark.slow
@pytest.mark.parametrize("key", [key for key, e in exercises().items() if isinstance(e, Frames)])
def test_what_is_said_of_placed_frames_is_true(key):
    exercise = exercises()[key]
    given = exercise.given(1)
    rows = placed(given)
    for answer in few([*in_millimetres(rows), *wrong_frames(rows, given["axes"])], 25):
        verdict = exercise.judge(answer, 1)
        if verdict.status == "wrong":
            true = boards.true_of(verdict, answer, given)
            assert true is not None, f"no predicate: {verdict}"
            assert true, f"not true: {verdict} of {answer}"
            assert not [*unfounded(exercise, verdict, answer, 1)], f"{verdict} of {answer}"
