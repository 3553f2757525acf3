"""Every sentence of every exercise is true of the answer it is said of: decided by a predicate of
its own in ``claims``; a sentence without one fails.
"""

import pytest
from claims import judged, sentence
from claims.advice import unfounded
from draws import few, variants
from wrong_answers import unforeseen, wrong_answers

from dhlab.course.exercises import exercises
from dhlab.course.kinds import Order, Table, Value

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


@pytest.mark.parametrize("key", KEYS)
def test_every_sentence_has_a_predicate_and_is_true(key):
    exercise = ASKED[key]
    for variant in variants(1):
        answers = few(wrong_answers(exercise, variant), 60)
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
