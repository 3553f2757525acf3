"""Answers that are chosen: an option, an order, a guess."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np

from ..verdict import NOT_ATTEMPTED, RECORDED, RIGHT, Verdict
from .exercise import untouched
from .lettered import UNDECIDED, Lettered, Option

__all__ = ["Choice", "OneOf", "Order", "PreTest", "Prediction"]


@dataclass(frozen=True, kw_only=True)
class OneOf(Lettered):
    """A question with one answer: ``options`` by id, of which ``correct`` is one."""

    options: Mapping[str, Option]
    correct: str

    def texts(self) -> Mapping[str, str]:
        return {key: option.text for key, option in self.options.items()}

    def compare(self, answer: Any, variant: int) -> Verdict:
        chosen = self.id_of(answer, variant)
        if chosen is None:
            letters = ", ".join(self.letters(variant).values())
            return self.wrong(
                headline=f'expected one of {letters} or "?", found {answer!r}',
                next='Write the letter in quotes, such as "a".',
            )
        return self.judged(chosen)

    def judged(self, chosen: str) -> Verdict:
        """The Verdict on an option, given by its id."""
        raise NotImplementedError


@dataclass(frozen=True, kw_only=True)
class Choice(OneOf):
    """One option to be chosen by its letter; "?" is "I don't know yet"."""

    def judged(self, chosen: str) -> Verdict:
        option = self.options[chosen]
        if chosen == self.correct:
            return self.say(RIGHT, option.answer, chosen=(chosen,))
        # the option's own words say why
        said = self.wrong(headline=option.answer, chosen=(chosen,))
        return replace(said, mistake=option.mistake)


@dataclass(frozen=True, kw_only=True)
class PreTest(OneOf):
    """A question of the pre-test, never marked: every answer is noted and sent to the lesson that
    treats it.

    ``lesson`` is the number of the lesson. Whether the answer was right is in the verdict's
    ``known``, which is kept for the end of the course and not shown.
    """

    points: float = 0
    same_order: ClassVar[bool] = True
    lesson: str
    hints: tuple = (
        'There is nothing to lose here: a guess is welcome, and so is "?".',
        "This is treated later on; the answer's verdict names the lesson.",
    )

    def say_undecided(self) -> Verdict:
        return self.say(
            RECORDED,
            "you do not know yet, and that is what the course is for.",
            next=f"Lesson {self.lesson} answers it.",
            known=False,
            chosen=(UNDECIDED,),
        )

    def judged(self, chosen: str) -> Verdict:
        option = self.options[chosen]
        return self.say(
            RECORDED,
            option.answer,
            next=f"Lesson {self.lesson} looks into it.",
            mistake=option.mistake,
            known=chosen == self.correct,
            chosen=(chosen,),
        )


@dataclass(frozen=True, kw_only=True)
class Prediction(OneOf):
    """A guess made before a cell reveals the answer; never marked. ``options`` are texts by id,
    ``outcome`` what is then seen.
    """

    points: float = 0
    same_order: ClassVar[bool] = True
    options: Mapping[str, str]  # type: ignore[assignment]  # a guess has no verdict to tell
    outcome: str

    @property
    def worth(self) -> str:
        return "a guess, never marked"

    def texts(self) -> Mapping[str, str]:
        return self.options

    def judge(self, answer: Any, variant: int = 0) -> Verdict:
        if untouched(answer):  # the dots stand in the very cell that asks
            return self.say(NOT_ATTEMPTED, next="Replace the dots in this cell and run it again.")
        return super().judge(answer, variant)

    def say_undecided(self) -> Verdict:
        return self._noted("you would rather see first", UNDECIDED)

    def judged(self, chosen: str) -> Verdict:
        return self._noted(f"you expect: {self.options[chosen]}", chosen)

    def _noted(self, guess, chosen):
        return self.say(RECORDED, guess, next="Run the next cell and compare.", chosen=(chosen,))

    def after(self, guess: str | None) -> str:
        """What is said once the answer has been seen; ``guess`` is the id that was chosen, "?" or
        None.
        """
        if guess in (None, UNDECIDED):
            return f"What happens: {self.outcome}"
        verdict = (
            "That is what you expected."
            if guess == self.correct
            else f"You expected: {self.options[guess]}."
        )
        return f"{verdict} What happens: {self.outcome}"


@dataclass(frozen=True, kw_only=True)
class Order(Lettered):
    """Items to be put in order or matched: the answer is a list of letters.

    ``items`` are texts by id. ``accepts(ids)`` says whether an order is right, since more than one
    may be; ``explain(ids)`` gives (mistake, place) or None; ``repeats``: whether an item may have
    several places, as in a classification; otherwise ``explain`` is only asked about items that
    differ. ``places`` are the sentences, one for each place of the answer, that are listed under
    the question; ``length`` is how many places there are, as many as items where it is left out.
    """

    items: Mapping[str, str]
    accepts: Callable[[list[str]], bool]
    explain: Callable[[list[str]], tuple | None] = lambda ids: None
    places: tuple[str, ...] = ()
    length: int = 0
    repeats: bool = False

    @property
    def size(self) -> int:
        """How many places the answer has."""
        return self.length or len(self.places) or len(self.items)

    def texts(self) -> Mapping[str, str]:
        return self.items

    def _asked(self):
        places = [f"{k}. {place}" for k, place in enumerate(self.places, 1)]
        return [self.question, "\n".join(places)] if places else [self.question]

    def compare(self, answer: Any, variant: int) -> Verdict:
        if isinstance(answer, (set, frozenset)):
            return self.wrong(
                headline="expected letters in their order, found a set, which has no order",
                next="Put square brackets in place of the curly ones.",
            )
        words = _words(answer)
        ids = [self.id_of(word, variant) for word in words]
        if None in ids:
            letters = ", ".join(self.letters(variant).values())
            return self.wrong(
                headline=f"expected letters from {letters}, found {words[ids.index(None)]!r}",
                next="Give the letter that stands before each text, in quotes.",
            )
        if len(ids) != self.size:
            return self.wrong(
                headline=f"expected {self.size} letters, found {len(ids)}",
                next="Give one letter for each place.",
            )
        return self._judged(ids, variant)

    def _judged(self, ids, variant):
        """The Verdict on as many items as there are places."""
        chosen = tuple(ids)
        if self.accepts(ids):
            return self.say(RIGHT, self.praise, chosen=chosen)
        twice = next((key for key in ids if ids.count(key) > 1), None)
        if twice and not self.repeats:
            return self.wrong(
                headline=f"{self.letters(variant)[twice]} stands there twice",
                next="No letter has two places here.",
                chosen=chosen,
            )
        mistake, said = self.explain(ids) or (None, "not in this order")
        return replace(self.told(mistake, said), chosen=chosen)


def _words(answer):
    """The letters or ids of an answer: of a text its letters, of a list its entries."""
    if isinstance(answer, str):
        answer = answer.replace(",", "").replace(" ", "")
    entries = answer if np.iterable(answer) else [answer]
    # str() of a member of an Enum of texts is its name, not the text
    texts = (entry if isinstance(entry, str) else str(entry) for entry in entries)
    return [text.strip().lower() for text in texts]
