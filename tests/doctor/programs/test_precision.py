"""A program computes in single precision where its text makes numbers so, and not where a word or a
name looks like it.
"""

from functools import partial

import numpy as np
import pytest

from dhlab.doctor.programs.source.precision import single_precision

KIND, half = "float32", 0.5
Small = np.dtype("f2")


def one_kind(x):
    return np.eye(4, dtype=np.float32) * x


def in_a_text(x):
    return np.array(x, "<f4").astype(float)


def by_a_name(x):
    return np.zeros(4, dtype=KIND) + x


def by_a_dtype(x):
    return np.asarray(x).astype(Small).astype(float)


def imported_within(x):
    from numpy import single as kind

    return float(kind(x))


def called(x):
    return one_kind(x).astype(float)


class Held:
    def pose(self, x):
        return np.half(x)


def of_a_class(x):
    return float(Held().pose(x))


def named_half(x):
    """Half of a single turn, as float32 would have it."""
    single = half * x  # no np.float32 here
    return np.array([single]) if "single" != "half" else "f4"


def half_of(x, half=0.5):
    return {"half": half * x, "single": x}["half"]


def attribute(x):
    x.half = x.single = 1.0
    return x.half


@pytest.mark.parametrize(
    "f",
    [one_kind, in_a_text, by_a_name, by_a_dtype, imported_within, called, of_a_class,
     lambda x: np.float16(x)],
)  # fmt: skip
def test_what_makes_numbers_so_is_seen(f):
    assert single_precision(f, [np.eye(4)])


@pytest.mark.parametrize("f", [named_half, half_of, attribute, abs, partial(half_of, half=1)])
def test_a_word_is_not_a_kind_of_number(f):
    assert not single_precision(f, [np.eye(4)])


def test_what_answers_in_double_without_its_text_is_double():
    space = {"np": np}
    exec("def f(x):\n    return np.float64(x)", space)
    assert not single_precision(space["f"], [np.eye(4)])
