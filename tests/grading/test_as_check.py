"""What check says of a program the grader says too, where how it comes to its answers counts."""

import inspect
import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.insert(0, str(Path(__file__).parent))
import corpus

from dhlab import transform
from dhlab.course.exercises import exercises
from dhlab.grading.grade import grade
from dhlab.grading.settings import Settings


def typed(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array(
        [
            [ct, -st * ca, st * sa, a * ct],
            [st, ct * ca, -ct * sa, a * st],
            [0, sa, ca, d],
            [0, 0, 0, 1],
        ]
    )


def multiplied(theta, d, a, alpha):
    T = transform.rot_z(theta) @ transform.trans_z(d)
    return T @ transform.trans_x(a) @ transform.rot_x(alpha)


def of_two_parts(theta, d, a, alpha):
    """A helper of constants beside one of the row makes no product."""
    return typed(theta, d, a, alpha) @ scaled(1)


def scaled(factor):
    return factor * np.eye(4)


def single(theta, d, a, alpha):
    return typed(*map(np.float32, (theta, d, a, alpha))).astype(np.float32)


def single_within(theta, d, a, alpha):
    return np.eye(4) @ typed(*map(np.float32, (theta, d, a, alpha)))


def off_in_single(theta, d, a, alpha):
    return (typed(theta, d, a, alpha) + 1e-5).astype(np.float32)


def rounded_in_single(theta, d, a, alpha):
    return typed(theta, d, a, alpha).round(5).astype(np.float32)


def off(theta, d, a, alpha):
    return typed(theta, d, a, alpha) + 1e-8


PROGRAMS = {
    multiplied: {"05.4"},
    of_two_parts: {"05.4", "05.6"},
    single: {"05.4", "05.6"},
    single_within: {"05.4", "05.6"},
    off_in_single: set(),
    rounded_in_single: set(),
    off: set(),
}
ASKED = {"05.4": "dh_transform", "05.6": "dh_closed"}


@pytest.mark.parametrize("program", PROGRAMS, ids=lambda program: program.__name__)
def test_check_takes_it_where_it_is_what_is_asked(program):
    right = {key for key in ASKED if exercises()[key].judge(program).status == "right"}
    assert right == PROGRAMS[program]


@pytest.mark.cage
def test_so_does_the_grader(tmp_path):
    helpers = "\n".join(map(inspect.getsource, (typed, scaled)))
    for program in PROGRAMS:
        notebook = (
            corpus.first(helpers),
            *(
                corpus.answer(key, f"{inspect.getsource(program)}{name} = {program.__name__}")
                for key, name in ASKED.items()
            ),
        )
        corpus.put(
            tmp_path / "class" / program.__name__,
            lambda *given, made=notebook: [make(*given) for make in made],
            {},
        )
    results, _ = grade(tmp_path / "class", tmp_path / "out", settings=Settings())
    assert {one.student: ASKED.keys() - corpus.lost(one) for one in results} == {
        program.__name__: right for program, right in PROGRAMS.items()
    }
