"""What is said of a wrong program is true of the program: asked of it by predicates of its own."""

import numpy as np
import pytest
from claims import programs
from draws import few

from dhlab.course.exercises import exercises
from dhlab.doctor.programs.explain import WRONG_VERSIONS


@pytest.mark.slow
@pytest.mark.parametrize("key", ["03.3", "05.4", "06.2"])
def test_what_is_said_of_a_program_is_true(key):
    exercise = exercises()[key]
    wrong = few([f for *_, f in WRONG_VERSIONS[exercise.family]], 70)
    named = 0
    with np.errstate(all="ignore"):
        for f in wrong:
            verdict = exercise.judge(f, 1)
            assert verdict.status == "wrong"
            true = programs.judged(verdict, f, exercise.family)
            assert true is not None or verdict.mistake is None, f"no predicate: {verdict}"
            assert true is not False, f"not true: {verdict}"
            named += bool(true)
    assert named > 0.9 * len(wrong)
