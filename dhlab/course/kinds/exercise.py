"""``Exercise``: what every kind of exercise has."""

import zlib
from dataclasses import dataclass

import numpy as np

from ...doctor import catalogue
from ..verdict import NOT_ATTEMPTED, RIGHT, WRONG, Verdict

__all__ = ["Exercise", "untouched"]


@dataclass(frozen=True, kw_only=True)
class Exercise:
    """What every exercise has: an id such as "05.2", a title, points, two hints, and what is said when it is right.

    ``mirrors`` is the id of the pre-test question that a question of the post-test asks again.
    """

    id: str
    title: str
    points: float = 1
    hints: tuple = ()
    praise: str = ""
    mirrors: str = ""

    def rng(self, variant):
        """The generator of this exercise's numbers: the same for the same variant, everywhere."""
        return np.random.default_rng([zlib.crc32(self.id.encode()), variant])

    def given(self, variant):
        """The numbers of the task, by name; none for most kinds."""
        return {}

    def judge(self, answer, variant=0):
        """The Verdict on an answer; never raises because of the answer."""
        if untouched(answer):
            return self.say(NOT_ATTEMPTED, next="Fill in the cell above, run it, then run this one again.")
        return self.compare(answer, variant)

    def compare(self, answer, variant):
        """The Verdict on an answer that was attempted."""
        raise NotImplementedError

    def say(self, status, headline="", **words):
        """A Verdict of this exercise."""
        return Verdict(self.id, status, headline, points=self.points if status == RIGHT else 0, of=self.points, **words)

    def right(self):
        """The Verdict on a right answer."""
        return self.say(RIGHT, self.praise)

    def wrong(self, mistake_id=None, headline="", place="", next=""):
        """The Verdict on a wrong answer, in the catalogue's words when the mistake is known."""
        if mistake_id is None:
            return self.say(WRONG, headline, place=place, next=next or f'hint("{self.id}") gives a first hint.')
        mistake = catalogue()[mistake_id]
        return self.say(WRONG, headline or f"{mistake.title}. {mistake.see}", place=place, why=mistake.why, next=next or mistake.next, mistake=mistake_id)


def untouched(answer):
    if answer is None or answer is Ellipsis:
        return True
    return isinstance(answer, (list, tuple)) and len(answer) > 0 and all(untouched(entry) for entry in answer)
