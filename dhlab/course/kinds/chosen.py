"""Answers that are chosen: an option, an order, a guess."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np

from ..verdict import NOT_ATTEMPTED, RECORDED, RIGHT, WRONG
from .exercise import Exercise, untouched

__all__ = ["Choice", "Order", "PreTest", "Prediction", "Option", "UNDECIDED"]

UNDECIDED = "?"  # "I don't know yet", in every choice


@dataclass(frozen=True)
class Option:
    """One option of a choice: its text, what is said to who chooses it, and the mistake it stands
    for (None when it is right).
    """

    text: str
    answer: str
    mistake: str | None = None


@dataclass(frozen=True, kw_only=True)
class Choice(Exercise):
    """One option to be chosen by its letter; "?" is "I don't know yet"."""

    options: Mapping
    correct: str
    undecided: str = "Good to say so. Read the paragraph above once more, then choose."

    def compare(self, answer, variant):
        letter = answer.strip().lower() if isinstance(answer, str) else ""
        if letter == UNDECIDED:
            return self.say(WRONG, self.undecided, next=f'hint("{self.id}") gives a first hint.')
        if letter not in self.options:
            return self.wrong(
                headline=f'expected one of {", ".join(self.options)} or "?", found {answer!r}',
                next='Write the letter in quotes, such as "a".',
            )
        option = self.options[letter]
        if letter == self.correct:
            return self.say(RIGHT, option.answer)
        return self.say(
            WRONG, option.answer, mistake=option.mistake
        )  # the option's own words say why


@dataclass(frozen=True, kw_only=True)
class Order(Exercise):
    """Items to be put in order or matched: the answer is a list of letters.

    ``accepts(letters)`` says whether an order is right, since more than one may be;
    ``explain(letters)`` gives (mistake, place) or None; ``repeats``: whether a letter may have
    several places, as in a classification; otherwise ``explain`` is only asked about letters that
    differ.
    """

    items: Mapping
    accepts: Callable
    explain: Callable = lambda letters: None
    length: int = 0
    repeats: bool = False

    def compare(self, answer, variant):
        if isinstance(answer, str):
            answer = answer.replace(",", "").replace(" ", "")
        letters = (
            [str(letter).strip().lower() for letter in answer]
            if np.iterable(answer)
            else [str(answer)]
        )
        length = self.length or len(self.items)
        strange = [letter for letter in letters if letter not in self.items]
        if strange:
            return self.wrong(
                headline=f"expected letters from {', '.join(self.items)}, found {strange[0]!r}"
            )
        if len(letters) != length:
            return self.wrong(
                headline=f"expected {length} letters, found {len(letters)}",
                next="Give one letter for each place.",
            )
        if self.accepts(letters):
            return self.right()
        twice = next((letter for letter in letters if letters.count(letter) > 1), None)
        if twice and not self.repeats:
            return self.wrong(
                headline=f"{twice} stands there twice", next="No letter has two places here."
            )
        known = self.explain(letters)
        return (
            self.wrong(known[0], place=known[1])
            if known
            else self.wrong(headline="not in this order")
        )


@dataclass(frozen=True, kw_only=True)
class PreTest(Exercise):
    """A question of the pre-test, never marked: every answer is noted and sent to the lesson that
    treats it.

    ``options`` as in :class:`Choice`; ``lesson`` is the number of the lesson. Whether the answer
    was right is in the verdict's ``known``, which is kept for the end of the course and not shown.
    """

    points: float = 0
    options: Mapping
    correct: str
    lesson: str
    hints: tuple = (
        'There is nothing to lose here: a guess is welcome, and so is "?".',
        "This is treated later on; the answer's verdict names the lesson.",
    )

    def compare(self, answer, variant):
        letter = answer.strip().lower() if isinstance(answer, str) else ""
        if letter not in self.options and letter != UNDECIDED:
            return self.wrong(
                headline=f'expected one of {", ".join(self.options)} or "?", found {answer!r}',
                next='Write the letter in quotes, such as "a".',
            )
        if letter == UNDECIDED:
            return self.say(
                RECORDED,
                "you do not know yet, and that is what the course is for.",
                next=f"Lesson {self.lesson} answers it.",
                known=False,
            )
        option = self.options[letter]
        return self.say(
            RECORDED,
            option.answer,
            next=f"Lesson {self.lesson} looks into it.",
            mistake=option.mistake,
            known=letter == self.correct,
        )


@dataclass(frozen=True, kw_only=True)
class Prediction(Exercise):
    """A guess made before a cell reveals the answer; never marked. ``options`` are texts by letter,
    ``outcome`` what is then seen.
    """

    points: float = 0
    options: Mapping = field(default_factory=dict)
    correct: str = ""
    outcome: str = ""

    def judge(self, answer, variant=0):
        if untouched(answer):  # the dots stand in the very cell that asks
            return self.say(NOT_ATTEMPTED, next="Replace the dots in this cell and run it again.")
        return super().judge(answer, variant)

    def compare(self, answer, variant):
        letter = answer.strip().lower() if isinstance(answer, str) else ""
        if letter not in self.options and letter != UNDECIDED:
            return self.wrong(
                headline=f'expected one of {", ".join(self.options)} or "?", found {answer!r}',
                next='Write the letter in quotes, such as "a".',
            )
        guess = (
            "you would rather see first"
            if letter == UNDECIDED
            else f"you expect: {self.options[letter]}"
        )
        return self.say(RECORDED, guess, next="Run the next cell and compare.")

    def after(self, letter):
        """What is said once the answer has been seen; ``letter`` is the guess or None."""
        if letter in (None, UNDECIDED):
            return f"What happens: {self.outcome}"
        verdict = (
            "That is what you expected."
            if letter == self.correct
            else f"You expected: {self.options[letter]}."
        )
        return f"{verdict} What happens: {self.outcome}"
