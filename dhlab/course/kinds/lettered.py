"""What all exercises have whose options are chosen by letters."""

import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from string import ascii_lowercase
from typing import Any, ClassVar

import numpy as np

from .exercise import SHUFFLED, UNDECIDED, Exercise

__all__ = ["UNDECIDED", "Lettered", "Option"]

I_DONT_KNOW = "I don't know yet"
AROUND = " ().\"'“”"  # what may stand around a letter


@dataclass(frozen=True)
class Option:
    """One option of a choice: its text, what is said to who chooses it, and the mistake it stands
    for (None when it is right).
    """

    text: str
    answer: str
    mistake: str | None = None


@dataclass(frozen=True, kw_only=True)
class Lettered(Exercise):
    """An exercise whose options are chosen by letters.

    An option is known by an id of its own, such as "any-order"; its letter is given when it is
    shown. ``question`` is what is asked above the options, and ``alphabet`` holds the letters, in
    the order in which they are given; another than a, b, c … has a meaning, as s and c for the
    conventions, and stays with its options. Texts are Markdown of one line: code stands in
    backticks. ``same_order``: the options stand in the order of their definition for everybody.
    """

    question: str
    alphabet: str = ascii_lowercase
    undecided: str = "Good to say so. Read the paragraph above once more, then choose."
    entry: ClassVar[str] = "place"
    same_order: ClassVar[bool] = False

    def texts(self) -> Mapping[str, str]:
        """The text of each option by its id, in the order of their definition."""
        raise NotImplementedError

    def letters(self, variant: int = 0) -> dict[str, str]:
        """The letter of each option by its id, in the order in which the options are shown.

        Examples
        --------
        >>> from dhlab.course.exercises import exercises
        >>> exercises()["02.2"].letters()["link-offset"]
        'd'
        >>> exercises()["02.2"].letters(2**32 + 2)["link-offset"]
        'b'
        """
        ids = list(self.texts())
        if variant >= SHUFFLED and self.alphabet == ascii_lowercase and not self.same_order:
            # a generator of its own: the order says nothing of the task's numbers
            rng = np.random.default_rng([zlib.crc32(f"{self.id} order".encode()), variant])
            ids = [ids[k] for k in rng.permutation(len(ids))]
        return dict(zip(ids, self.alphabet))

    def id_of(self, answer: Any, variant: int = 0) -> str | None:
        """The id of the option that an answer names by its letter or its id; "?" of "?"; None of
        anything else.
        """
        if isinstance(answer, (list, tuple)) and len(answer) == 1:
            answer = answer[0]
        word = answer.strip(AROUND).lower() if isinstance(answer, str) else ""
        if word == UNDECIDED or word in self.texts():
            return word
        return {letter: key for key, letter in self.letters(variant).items()}.get(word)

    def shown(self, variant: int = 0) -> str:
        return "\n\n".join(
            [super().shown(variant), *self._asked(), "\n".join(self._listed(variant))]
        )

    def _asked(self):
        return [self.question]

    def _listed(self, variant):
        """The options as lines of a Markdown list, with what is to be typed; "?" last."""
        texts = self.texts()
        lines = [(letter, texts[key]) for key, letter in self.letters(variant).items()]
        return [f'- `"{letter}"` {text}' for letter, text in [*lines, (UNDECIDED, I_DONT_KNOW)]]

    def read_back(self, chosen: tuple[str, ...], variant: int = 0) -> tuple[str, str]:
        """The letters and the texts of the options that were chosen, given by their ids.

        Examples
        --------
        >>> from dhlab.course.exercises import exercises
        >>> exercises()["02.2"].read_back(("link-offset",))
        ('d', 'the link offset d')
        """
        letters = self.letters(variant) | {UNDECIDED: UNDECIDED}
        texts = {**self.texts(), UNDECIDED: I_DONT_KNOW}
        known = [key for key in chosen if key in texts]
        return ", ".join(letters[key] for key in known), "; ".join(texts[key] for key in known)
