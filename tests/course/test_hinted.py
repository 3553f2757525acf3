"""What hints and praises assert is computed, or said to be beyond that and why: a sentence that
nobody has looked at fails.
"""

import pytest
from claims.hinted import REASONS, SAID, assertions, given_of

from dhlab.course.exercises import exercises

E = exercises()
DECIDED = [(key, said) for key, of in SAID.items() for said, by in of.items() if callable(by)]


def test_every_sentence_was_looked_at():
    for key, exercise in E.items():
        known, sentences = SAID.get(key, {}), list(assertions(exercise))
        left = [s for s in sentences if sum(s.startswith(said) for said in known) != 1]
        assert not left, f"{key}: give it a predicate in claims/hinted, or a reason why not"
        gone = [said for said in known if not any(s.startswith(said) for s in sentences)]
        assert not gone, f"{key}: no hint and no praise begins like this"


def test_what_nothing_decides_has_a_reason():
    assert {by for of in SAID.values() for by in of.values() if not callable(by)} <= set(REASONS)


@pytest.mark.parametrize("key, said", DECIDED)
def test_what_is_said_is_so(key, said):
    for variant in range(3):
        assert SAID[key][said](given_of(E[key], variant)), variant
