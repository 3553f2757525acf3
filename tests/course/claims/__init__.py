"""What every sentence of the exercises asserts, and whether it is true of an answer.

A claim is a pair: a pattern that matches the sentence (headline, and place after " @ "), whose
named groups are its named places, and a predicate ``(answer, given, found) -> bool`` that decides,
by formulas of its own, whether the sentence is true of the answer. ``answer`` is an array where the
exercise asks for numbers, else as it was handed in.
"""

import re

from . import orders, tables, vectors
from .general import GENERAL

CLAIMS = {**vectors.CLAIMS, **tables.CLAIMS, **orders.CLAIMS}

__all__ = ["CLAIMS", "judged", "sentence"]


def sentence(verdict):
    """The assertion of a verdict: its headline, and its place."""
    return verdict.headline + (f" @ {verdict.place}" if verdict.place else "")


def judged(exercise, verdict, answer, variant):
    """Whether what is said of an answer is true of it; None where no predicate knows."""
    said = sentence(verdict)
    for pattern, holds in [*CLAIMS.get(exercise.id, ()), *GENERAL]:
        found = re.fullmatch(pattern, said)
        if found:
            given = dict(exercise.given(variant)) | {"exercise": exercise, "variant": variant}
            return bool(holds(answer, given, found.groupdict()))
    return None
