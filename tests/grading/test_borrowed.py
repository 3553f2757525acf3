"""Whose numbers: a class of strangers in which nobody is named, copyists who are, and what chance
says by counting.
"""

from itertools import product

import numpy as np
import pytest
from draws import few

from dhlab.course.exercises import exercises
from dhlab.course.kinds import Value
from dhlab.grading.handing_out.variants import variants
from dhlab.grading.inside.wire import encode
from dhlab.grading.judging.borrowed import CHANCE, _is_right, _tail, borrowed_from
from dhlab.grading.judging.judge import Answers
from dhlab.grading.judging.questions import Course
from dhlab.grading.results.marks import Mark
from dhlab.grading.settings import Settings

# its number is computed from forty poses; it would make this test long and says nothing that the
# others do not
SLOW = "07"
LESSONS = tuple(
    sorted(
        {
            key[:2]
            for key, e in exercises().items()
            if isinstance(e, Value) and e.points and key[:2] != SLOW
        }
    )
)
VALUES = [
    e for key, e in exercises().items() if isinstance(e, Value) and e.points and key[:2] in LESSONS
]


def sent(values):
    """What came out of the cage: a last value for each exercise."""
    answers = Answers()
    answers.notes = {
        key: [({"check": key, "value": encode(value)}, None)] for key, value in values.items()
    }
    return answers


@pytest.fixture(scope="module")
def course():
    """The course of a class. The right values of its numbers are worked out once in a process, so
    that the tests of this file, which use this, run in one.
    """

    def of(key, size, lessons=LESSONS):
        students = [f"s{k:03d}" for k in range(size)]
        return Course(lessons, Settings(), variants(bytes([key]) * 32, students))

    return of


def named(of, student, values):
    """Whom the rule names, when these answers are those that are wrong."""
    own = of.variants[student]
    wrong = [
        e.id
        for e in VALUES
        if e.id in values and not e.is_right(values[e.id], e.expected(own), e.given(own))
    ]
    return borrowed_from(of, student, sent(values), [Mark(key, "wrong", 0, 1) for key in wrong])


def right(variant, lessons=LESSONS):
    return {
        e.id: np.asarray(e.answer(**e.given(variant)), dtype=float)
        for e in VALUES
        if e.id[:2] in lessons
    }


@pytest.mark.slow
@pytest.mark.parametrize("lessons", few([LESSONS, ("05",)], 1), ids=" ".join)
def test_in_a_class_of_strangers_hardly_anybody_is_named(course, lessons):
    """Every answer is right for numbers that nobody in the class has: what looks like a copy is an
    accident.
    """
    accused = tried = would_be = 0
    for key in few(range(3), 1):
        of = course(key, 200, lessons)
        for k, student in enumerate(list(of.variants)[:60]):
            values = right(10**6 + 1000 * key + k, lessons)
            tried, accused = tried + 1, accused + (named(of, student, values) is not None)
            fitting = sum(
                _is_right(e, tuple(of.variants.values()), values[e.id])
                for e in VALUES
                if e.id in values
            )
            would_be += max(fitting) >= 2
    assert tried >= 60 and accused <= 3 * CHANCE * tried
    assert would_be > tried / 9, (
        "two fitting exercises alone are an accident often enough for this test to see"
    )


@pytest.mark.slow
@pytest.mark.parametrize("key, size", few([(0, 200), (1, 40), (2, 40), (3, 40)], 2))
def test_who_hands_in_anothers_answers_is_named(course, key, size):
    """In a large class, where more fits by accident, and in some small ones."""
    of, other = course(key, size), f"s{size - 5:03d}"
    assert named(of, "s003", right(of.variants[other])) == other
    half = dict(list(right(of.variants[other]).items())[::2])
    assert named(of, "s003", half) == other


def test_few_values_are_no_evidence_in_a_large_class(course):
    for key in range(4):
        of = course(key, 200, ("02",))
        known = right(of.variants["s150"], ("02",))
        # six values: everybody shares them
        assert named(of, "s003", {"02.6": known["02.6"]}) is None
    assert named(course(1, 200), "s003", {}) is None
    # the same numbers for all
    assert named(Course(LESSONS, Settings(), {"s003": 5, "s004": 5}), "s003", right(9)) is None


@pytest.mark.slow
@pytest.mark.usefixtures("course")
def test_a_tie_names_nobody():
    """Two with the same numbers: either could be the source, and the other would be accused for
    nothing.
    """
    of = Course(LESSONS, Settings(), {"a": 1, "b": 2, "c": 2, "d": 3})
    assert named(of, "a", right(2)) is None and named(of, "a", right(3)) == "d"


def test_chance_is_what_counting_all_sets_gives():
    rare = np.array([0.3, 0.02, 0.11, 0.6])
    for goal in product([0, 1], repeat=4):
        evidence = -np.log(rare) @ goal
        counted = sum(
            np.prod(np.where(s, rare, 1 - rare))
            for s in product([0, 1], repeat=4)
            if -np.log(rare) @ s >= evidence - 1e-9
        )
        assert _tail(rare, evidence) == pytest.approx(counted, abs=1e-14)


def test_every_exercise_has_one_shape():
    """The comparison with a whole class at once needs it."""
    for exercise in VALUES:
        assert (
            len({np.shape(exercise.answer(**exercise.given(variant))) for variant in range(20)})
            == 1
        ), exercise.id
