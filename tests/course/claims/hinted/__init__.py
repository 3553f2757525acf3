"""What hints and praises assert, lesson by lesson: ``SAID[exercise]`` holds each of their
sentences, by how it begins, with a predicate ``(given) -> bool`` that computes whether it is so, or
with one of the three reasons why nothing decides it.

``given`` are the numbers of the task, and by "right" the right answer (of a table its rows, degrees
and metres), by "exercise" the exercise. Questions, and requests that begin with a verb, assert
nothing and stand in no table.
"""

import re

import numpy as np

from dhlab.course.kinds import PreTest, Table

from ..advice import ASKS
from ..reasons import DO, NAMES, STORY
from . import told01, told02, told03, told04, told05, told06, told07, told08, told09

__all__ = ["REASONS", "SAID", "assertions", "given_of"]

REASONS = DO, NAMES, STORY
MODULES = told01, told02, told03, told04, told05, told06, told07, told08, told09
SAID = {key: said for module in MODULES for key, said in module.SAID.items()}
SENTENCES = re.compile(r"(?<=[.?!]) (?=[A-Zθαdaxz])")


def assertions(exercise):
    """The sentences of an exercise's praise and hints that are neither question nor request."""
    if isinstance(exercise, PreTest):  # nothing to lose, and a number of a lesson
        return
    for sentence in filter(None, SENTENCES.split(exercise.praise)):
        yield sentence
    for hint in exercise.hints:
        for sentence in SENTENCES.split(hint):
            if not sentence.endswith("?") and not ASKS.fullmatch(sentence):
                yield sentence


def given_of(exercise, variant):
    given = dict(exercise.given(variant)) | {"exercise": exercise, "variant": variant}
    if isinstance(exercise, Table):
        table = exercise.right_arm(variant).table
        given["right"] = table.rows * [180 / np.pi, 1, 1, 180 / np.pi]
    elif hasattr(exercise, "expected"):
        given["right"] = exercise.expected(variant)
    return given
