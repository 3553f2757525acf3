"""A program that is not right is called again with its whole notebook: which of the two counts, and
whose words are told. What the calls gave is made up here, without a cage.
"""

import pytest

from dhlab.course.exercises import exercises
from dhlab.doctor.programs.running.calling import Called, CallFault
from dhlab.grading.judging.asking import Asked
from dhlab.grading.judging.programs import program
from dhlab.grading.settings import Settings

RIGHT = exercises()["05.6"].answer


def asked_of(program=RIGHT, fault=None, **more):
    """What is known of a program that was called, or of one that stopped with a fault."""
    cases = exercises()["05.6"].cases(7)
    if fault:
        return Asked(Called(fault=CallFault(fault)), **more)
    return Asked(Called(tuple(program(*case) for case in cases), program(*cases[0])), **more)


def wrong(theta, d, a, alpha):
    return RIGHT(theta, d, a, alpha) + theta


@pytest.mark.parametrize(
    "seen, whole, status, words",
    [
        (asked_of(), None, "right", ""),
        (Asked(stopped="timed out"), None, "timed out", "too long"),
        (Asked(stopped="no time"), None, "timed out", "was not called"),
        (asked_of(fault="of the part"), asked_of(), "right", ""),
        (asked_of(wrong), asked_of(), "right", ""),
        (asked_of(fault="of the part"), asked_of(fault="of all"), "wrong", "of all"),
        (asked_of(fault="of the part"), Asked(stopped="timed out"), "wrong", "of the part"),
        (asked_of(fault="x", closed=("forward",)), asked_of(fault="y"), "not allowed", "forward"),
        (asked_of(fault="x", closed=("forward",)), asked_of(wrong), "wrong", ""),
        (asked_of(fault="x", closed=("forward",)), asked_of(), "right", ""),
    ],
)
def test_what_the_whole_notebook_gives_counts_where_it_is_no_worse(seen, whole, status, words):
    calls = [seen, whole]
    found = program(
        exercises()["05.6"], lambda whole=False: (calls[whole], 7), Settings(partial=0.5), 1
    )
    assert found.status == status and words in found.headline
    assert bool(found.note) == (status == "right" and whole is not None)
