"""What is told of an option, and what is seen after a guess, is true: computed where it states what
can be computed. A sentence that nobody has looked at fails.
"""

import pytest
from claims import chosen, further

from dhlab.course.exercises import exercises
from dhlab.course.kinds import Choice, Prediction

OPTIONS = {**chosen.OPTIONS, **further.OPTIONS}
OUTCOMES = {**chosen.OUTCOMES, **further.OUTCOMES}
ASKED = {
    (key, option) for key, e in exercises().items() if isinstance(e, Choice) for option in e.options
}
GUESSED = {key for key, e in exercises().items() if isinstance(e, Prediction)}


@pytest.mark.parametrize("key, option", sorted(OPTIONS))
def test_what_is_told_of_an_option_is_true(key, option):
    assert OPTIONS[key, option]()


@pytest.mark.parametrize("key", sorted(OUTCOMES))
def test_what_is_seen_after_a_guess_is_so(key):
    assert OUTCOMES[key]()


def test_every_option_and_outcome_was_looked_at():
    told = {*OPTIONS, *OUTCOMES}
    left = (ASKED | GUESSED) - told - further.UNDECIDED.keys()
    assert not left, "give it a predicate in claims/chosen.py, or a reason in claims/further.py"
    assert told | further.UNDECIDED.keys() <= ASKED | GUESSED
    assert not told & further.UNDECIDED.keys()
