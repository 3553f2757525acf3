"""What is wrong with an exercise, before anybody is asked it."""

import re
from collections.abc import Iterator
from difflib import get_close_matches

import numpy as np

from ....doctor import catalogue
from ....doctor.programs.explain import WRONG_VERSIONS
from ...kinds import Exercise, Explain, Function, Lettered, OneOf, Option, Order, Prediction, Value

__all__ = ["exercise_faults"]

FEWEST = 5  # wrong values that a Value names
ID = re.compile(r"(?=..)[a-z0-9]+(-[a-z0-9]+)*")


def exercise_faults(exercise: Exercise) -> Iterator[str]:
    """What is wrong with an exercise, a sentence for each thing."""
    if not isinstance(exercise, Prediction):
        yield from _said(exercise)
    if isinstance(exercise, Lettered):
        yield from _lettered(exercise)
    if isinstance(exercise, OneOf) and exercise.correct not in exercise.options:
        yield (
            f"expected correct= one of {', '.join(exercise.options)}, found {exercise.correct!r};"
            " write the id of the right option"
        )
    if isinstance(exercise, Function) and exercise.family and exercise.family not in WRONG_VERSIONS:
        yield (
            f"expected family= one of {', '.join(WRONG_VERSIONS)}, found {exercise.family!r}; give"
            ' your wrong versions that name in WRONG_VERSIONS, or write family=""'
        )
    try:
        named = _named(exercise)
    except Exception as error:
        yield (
            f"expected draw, answer and mistakes that run, found {type(error).__name__}: {error};"
            " correct them"
        )
        return
    if isinstance(exercise, Value):
        yield from _wrong_values(exercise)
    for mistake in sorted(named - catalogue().keys()):
        near = get_close_matches(mistake, catalogue(), 1)
        yield f"expected the id of a mistake in dhlab/doctor/catalogue.yaml, found {mistake!r}" + (
            f"; did you mean {near[0]!r}?" if near else "; take one that is there"
        )


def _said(exercise):
    """What is wrong with hints and praise."""
    hints = exercise.hints
    if isinstance(hints, str):
        yield (
            f"expected two hints in brackets, found one text, {hints!r}; brackets alone make no"
            ' list: write hints=("where to look", "which way to go")'
        )
    elif len(hints) != 2 or not all(isinstance(hint, str) and hint.strip() for hint in hints):
        yield (
            f"expected two hints, each a text, found {hints!r}; the first says where to look, the"
            " second which way to go"
        )
    if not isinstance(exercise, (OneOf, Explain)) and not exercise.praise.strip():
        yield "expected praise, found none; write praise= with what a right answer shows"


def _wrong_values(exercise):
    """Whether enough wrong answers have a name; one that is the right answer is none."""
    given = exercise.given(0)
    for what, value in (
        ("answer", exercise.answer(**given)),
        *(("mistakes", value) for _, _, value in exercise.mistakes(**given)),
    ):
        try:
            np.asarray(value, dtype=float)
        except (ValueError, TypeError):
            yield f"expected {what}= to give numbers, found {value!r}; a Value is compared as such"
            return
    right = np.asarray(exercise.answer(**given), dtype=float)
    named = [
        mistake
        for mistake, _, value in exercise.mistakes(**given)
        if np.shape(value) != right.shape
        or exercise.differs(np.asarray(value, dtype=float), right).any()
    ]
    if len(named) < FEWEST:
        yield (
            f"expected mistakes= with {FEWEST} wrong values or more, found {len(named)}; think of"
            " what a student confuses, leaves out or turns round"
        )


def _lettered(exercise):
    """What is wrong with the ids and the texts of options."""
    texts = exercise.texts()
    for key, text in texts.items():
        if not ID.fullmatch(key):
            yield (
                "expected an id of two or more small letters, digits and hyphens for each option,"
                f" such as any-order, found {key!r}; its letter is given when it is shown"
            )
        if not text.strip() or "\n" in text:
            yield f"expected one line of text for {key}, found {text!r}; correct it"
    if len(set(texts.values())) < len(texts):
        yield "expected options that differ, found one text twice; say what sets the two apart"
    if len(texts) > len(exercise.alphabet):
        yield (
            f"expected at most {len(exercise.alphabet)} options, one for each letter, found"
            f" {len(texts)}; take some out"
        )
    if not exercise.question.strip():
        yield "expected a question, found none; say what is asked"


def _named(exercise):
    """The ids of the mistakes that an exercise may name."""
    options = exercise.options.values() if isinstance(exercise, OneOf) else ()
    found = {
        *(key[0] if isinstance(key, tuple) else key for key in exercise.words),
        *(option.mistake for option in options if isinstance(option, Option)),
    }
    if isinstance(exercise, Value):
        given = exercise.given(0)
        exercise.answer(**given)
        found |= {mistake for mistake, _, _ in exercise.mistakes(**given)}
    if isinstance(exercise, Function):
        exercise.answer(*exercise.cases(0)[0])
        found |= {mistake for mistake, _, _ in WRONG_VERSIONS.get(exercise.family, ())}
    if isinstance(exercise, Order):
        found |= {known[0] for known in map(exercise.explain, _orders(exercise)) if known}
    return found - {None}


def _orders(exercise):
    rng, items = exercise.rng(0), list(exercise.items)
    drawn = (
        rng.choice(items, exercise.size, replace=exercise.repeats).tolist() for _ in range(300)
    )
    return [order for order in drawn if not exercise.accepts(order)]
