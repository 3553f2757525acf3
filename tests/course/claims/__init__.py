"""What every sentence of the exercises asserts, and whether it is true of an answer.

A claim is a pair: a pattern that matches the sentence (headline, and place after " @ "), whose
named groups are its named places, and a predicate ``(answer, given, found) -> bool`` that decides,
by formulas of its own, whether the sentence is true of the answer. ``answer`` is an array where the
exercise asks for numbers, else as it was handed in.
"""

import re
from itertools import product

import numpy as np

from . import general, orders, tables, vectors
from .general import GENERAL

CLAIMS = {**vectors.CLAIMS, **tables.CLAIMS, **orders.CLAIMS}

__all__ = ["CLAIMS", "judged", "sentence"]


def sentence(verdict):
    """The assertion of a verdict: its headline, and its place."""
    return verdict.headline + (f" @ {verdict.place}" if verdict.place else "")


def in_latin(said):
    """As the catalogue and the doctor write it, whose words the course writes in Greek."""
    return said.replace("θ", "theta").replace("α", "alpha")


def judged(exercise, verdict, answer, variant):
    """Whether what is said of an answer is true of it; None where no predicate knows."""
    given = dict(exercise.given(variant)) | {"exercise": exercise, "variant": variant}
    return holds_of(sentence(verdict), answer, given)


def holds_of(said, answer, given):
    """Whether one sentence is true of an answer; None where no predicate knows."""
    twofold = re.fullmatch(r"two slips: (.+?); and ((?:in other units: )?.+)", said)
    if twofold:
        halves = _halves(said.removeprefix("two slips: "))
        if said.endswith(", once that is put right"):
            return _one_after_the_other(answer, given, *halves)
        return _both(answer, given, *halves)
    for pattern, holds in [*CLAIMS.get(given["exercise"].id, ()), *GENERAL]:
        found = re.fullmatch(pattern, said) or re.fullmatch(pattern, in_latin(said))
        if found:
            return bool(holds(answer, given, found.groupdict()))
    return None


def _halves(said):
    """The last "; and " of a sentence divides it; in that of units there are others."""
    if "; and in other units: " in said:
        one, _, other = said.partition("; and in other units: ")
        return one, f"in other units: {other}"
    one, _, other = said.rpartition("; and ")
    return one, other


def _one_after_the_other(answer, given, one, other):
    """With the first slip of a table taken back, the second is all that is wrong."""
    mended = tables.put_right(one, np.array(answer, dtype=float))
    return holds_of(other.removesuffix(", once that is put right"), mended, given)


def _both(answer, given, one, other):
    """With one slip taken back, or its numbers put right, the other is all that is wrong."""
    array, right = np.asarray(answer, dtype=float), general.right_of(given)
    if other.startswith("in other units"):
        return any(holds_of(one, fixed, given) for fixed in general.other_readings(array, given))
    undone = {"every number has the other sign": np.negative, **general.UNDONE}.get(other)
    if undone is not None and holds_of(one, undone(array), given):
        return True
    return any(
        holds_of(one, np.where(mask, array, right), given)
        and holds_of(other, np.where(mask, right, array), given)
        for mask in map(np.array, product((True, False), repeat=array.size))
    ) if array.ndim == 1 else False  # fmt: skip
