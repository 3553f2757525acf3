"""What is said of slips that learners made in programs, and what must not be said of them: each
sentence fits the answer that it is said of.
"""

import numpy as np
import pytest

from dhlab.course.exercises import exercises
from dhlab.course.kinds import Function
from dhlab.doctor.programs.source.foretold import foretold_pairs

E = exercises()
PROGRAMS = [key for key, e in E.items() if isinstance(e, Function)]


@pytest.mark.parametrize("key", PROGRAMS)
def test_two_changes_are_foretold_of_answers_of_any_shape(key):
    """A Jacobian has no determinant, a vector no blocks: of two terms of a sum, each mended by one
    change, the pair is foretold all the same.
    """
    rng = np.random.default_rng(1)
    right, one, other, idle = rng.normal(size=(4, 3, *E[key].shape))
    answers = np.array([right + one, right + other, right + one + other + idle])
    assert [0, 1] in foretold_pairs(right + one + other, answers, right).tolist()


def slide_of_the_joint_before(frames, T_end, sliding):
    cols = []
    for i in range(len(sliding)):
        z, o = frames[i][:3, 2], frames[i][:3, 3]
        if i > 0 and sliding[i - 1]:
            cols.append(np.hstack([z, 0 * z]))
        else:
            cols.append(np.hstack([np.cross(z, T_end[:3, 3] - o), z]))
    return np.array(cols).T


def test_a_jacobian_that_is_not_square_is_judged():
    for variant in range(3):
        assert E["08.2"].judge(slide_of_the_joint_before, variant).status == "wrong"
