"""``Exercise``: what every kind of exercise has."""

import zlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np

from ...doctor import catalogue
from ..verdict import NOT_ATTEMPTED, RIGHT, WRONG, Verdict

__all__ = ["Exercise", "Known", "Mistakes", "Said", "no_draw", "untouched"]


@dataclass(frozen=True)
class Said:
    """What an exercise says of a mistake, where the catalogue's words, written for programs and
    tables in general, would mislead.

    ``headline`` and ``next`` stand in place of the catalogue's; ``why`` too, and is left out when
    empty.
    """

    headline: str
    next: str = ""
    why: str = ""
    place: str = ""


# what is known of a wrong answer: its mistake's id in the catalogue, and the place or other words
Known: TypeAlias = tuple[str | None, str | Said]
# wrong answers that are known: mistake, place or other words, and the answer itself
Mistakes: TypeAlias = Iterator[tuple[str | None, str | Said, Any]]


@dataclass(frozen=True, kw_only=True)
class Exercise:
    """What every exercise has: an id such as "05.2", a title, points, two hints, and what is said
    when it is right.

    ``words`` holds a :class:`Said` for the mistakes that have other words here than in the
    catalogue, by id, or by (id, place) for one place of them; a single wrong answer has its own
    where a Said stands in the place of its place. ``mirrors`` is the id of the pre-test question
    that a question of the post-test asks again.
    """

    id: str
    title: str
    points: float = 1
    hints: tuple = ()
    praise: str = ""
    words: Mapping = field(default_factory=dict)
    mirrors: str = ""

    @property
    def worth(self) -> str:
        """What a right answer earns, in words."""
        if not self.points:
            return "not marked"
        return f"{self.points:g} point{'' if self.points == 1 else 's'}"

    def shown(self, variant: int = 0) -> str:
        """What a lesson shows above the cell in which the exercise is answered, as Markdown.

        Examples
        --------
        >>> from dhlab.course.exercises import exercises
        >>> exercises()["06.2"].shown()
        '**06.2 Forward kinematics** · 3 points'
        """
        return f"**{self.id} {self.title}** · {self.worth}"

    def rng(self, variant: int) -> np.random.Generator:
        """The generator of this exercise's numbers: the same for the same variant, everywhere."""
        return np.random.default_rng([zlib.crc32(self.id.encode()), variant])

    def given(self, variant: int) -> Mapping[str, Any]:
        """The numbers of the task, by name; none for most kinds."""
        return {}

    def judge(self, answer: Any, variant: int = 0) -> Verdict:
        """The Verdict on an answer; never raises because of the answer."""
        if untouched(answer):
            return self.say(
                NOT_ATTEMPTED, next="Fill in the cell above, run it, then run this one again."
            )
        return self.compare(answer, variant)

    def compare(self, answer: Any, variant: int) -> Verdict:
        """The Verdict on an answer that was attempted."""
        raise NotImplementedError

    def say(self, status: str, headline: str = "", **words: Any) -> Verdict:
        """A Verdict of this exercise."""
        return Verdict(
            self.id,
            status,
            headline,
            points=self.points if status == RIGHT else 0,
            of=self.points,
            **words,
        )

    def right(self) -> Verdict:
        """The Verdict on a right answer."""
        return self.say(RIGHT, self.praise)

    def wrong(
        self,
        mistake_id: str | None = None,
        headline: str = "",
        place: str | Said = "",
        next: str = "",
        chosen: tuple[str, ...] = (),
    ) -> Verdict:
        """The Verdict on a wrong answer: in the words of this exercise or of the catalogue when the
        mistake is known.
        """
        hint = f'hint("{self.id}") gives a first hint.'
        said = place if isinstance(place, Said) else self.words.get((mistake_id, place))
        shown = ""
        if said is None and not isinstance(place, Said):
            said, shown = self.words.get(mistake_id), place
        if said and not headline:
            return self.say(
                WRONG,
                said.headline,
                place=said.place or shown,
                why=said.why,
                next=said.next or hint,
                mistake=mistake_id,
                chosen=chosen,
            )
        if mistake_id is None:
            return self.say(WRONG, headline, place=place, next=next or hint, chosen=chosen)
        mistake = catalogue()[mistake_id]
        return self.say(
            WRONG,
            headline or f"{mistake.title}. {mistake.see}",
            place=place,
            why=mistake.why,
            next=next or mistake.next,
            mistake=mistake_id,
            chosen=chosen,
        )


def no_draw(rng: np.random.Generator) -> dict[str, Any]:
    """The numbers of a task that is the same for everybody: none."""
    return {}


def untouched(answer: Any) -> bool:
    """Whether an answer is still what was handed out: nothing, or dots and nothing else."""
    if answer is None or answer is Ellipsis:
        return True
    return (
        isinstance(answer, (list, tuple))
        and len(answer) > 0
        and all(untouched(entry) for entry in answer)
    )
