"""``Exercise``: what every kind of exercise has."""

import re
import zlib
from collections.abc import Iterator, KeysView, Mapping, ValuesView
from dataclasses import dataclass, field, replace
from itertools import islice
from typing import Any, ClassVar, TypeAlias

import numpy as np

from ...doctor import catalogue
from ..verdict import NOT_ATTEMPTED, RIGHT, WRONG, Verdict

__all__ = ["SHUFFLED", "Exercise", "Known", "Mistakes", "Said", "listed", "no_draw", "untouched"]

GREEK = {"theta": "θ", "alpha": "α"}
LETTERS = re.compile(r"(?<![\w.])(theta|alpha)(?![a-z])")
ONCE = Iterator, KeysView, ValuesView  # have no entries by number: they are walked through
MOST = 1000  # entries that are taken of an answer that may have no end
UNDECIDED = "?"  # "I don't know yet", an answer to every exercise
# variants from here on, which only a released lesson has, show options in an order of their own
SHUFFLED = 2**32


@dataclass(frozen=True)
class Said:
    """What an exercise says of a mistake, where the catalogue's words, written for programs and
    tables in general, would mislead.

    ``headline`` and ``next`` stand in place of the catalogue's; ``why`` too, and is left out when
    empty. A sentence is written for its place and true by itself: none is put together from parts.
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
    that a question of the post-test asks again. ``sparing``: what is to be found is the exercise,
    so :func:`dhlab.course.check` tells the kind of mistake first, the place at the second wrong
    answer and everything at the third. ``undecided`` is said of "?". ``practice``: it stands in its
    lesson's section *More practice*, which a lesson is done without. ``in_lesson`` are
    programs, or tables in degrees and metres, that the lesson itself shows and that are wrong here:
    handing one back is no work, and earns no share of the points.
    """

    id: str
    title: str
    points: float = 1
    hints: tuple = ()
    praise: str = ""
    words: Mapping = field(default_factory=dict)
    mirrors: str = ""
    sparing: bool = False
    practice: bool = False
    in_lesson: tuple = ()
    undecided: str = "Good to say so. Read the paragraph above once more, then try."
    entry: ClassVar[str] = "number"  # what an entry of the answer is called
    greek: ClassVar[bool] = False  # whether theta2 is told as θ2: no program is spoken of

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
        """The generator of this exercise's numbers: the same for the same variant, everywhere; how
        options are ordered is not among them.
        """
        return np.random.default_rng([zlib.crc32(self.id.encode()), variant % SHUFFLED])

    def given(self, variant: int) -> Mapping[str, Any]:
        """The numbers of the task, by name; none for most kinds."""
        return {}

    def judge(self, answer: Any, variant: int = 0) -> Verdict:
        """The Verdict on an answer; never raises because of the answer."""
        answer = listed(answer)
        if untouched(answer):
            return self.say(
                NOT_ATTEMPTED, next="Fill in the cell above, run it, then run this one again."
            )
        if undecided(answer):
            known = self.so_far(answer, variant)
            verdict = self.say_undecided()
            said = f"{verdict.headline} {known[:1].upper()}{known[1:]}."
            return replace(verdict, headline=said) if known else verdict
        gaps = self.gaps(answer)
        if gaps:
            return self.say(
                NOT_ATTEMPTED,
                self.so_far(answer, variant),
                place="; ".join(gaps),
                next="Put an answer in place of every ...",
            )
        return self.compare(answer, variant)

    def so_far(self, answer: Any, variant: int) -> str:
        """What is said of the part of an answer that is filled in; "" for most kinds."""
        return ""

    def gaps(self, answer: Any) -> list[str]:
        """Where dots are left in an answer that is filled in only in part, in words."""
        return [
            f"{'row' if _entries(entry) else self.entry} {k}"
            for k, entry in enumerate(_entries(answer), 1)
            if _has_dots(entry)
        ]

    def say_undecided(self) -> Verdict:
        """The Verdict on "?"."""
        return self.say(
            WRONG,
            self.undecided,
            next=f'hint("{self.id}") gives a first hint.',
            chosen=(UNDECIDED,),
        )

    def compare(self, answer: Any, variant: int) -> Verdict:
        """The Verdict on an answer that was attempted."""
        raise NotImplementedError

    def drawn(self, answer: Any, variant: int = 0) -> Any:
        """A Picture of a wrong answer with the first thing that does not fit marked, never of the
        right one; None where there is nothing to draw.
        """
        return None

    def say(self, status: str, headline: str = "", **words: Any) -> Verdict:
        """A Verdict of this exercise."""
        if self.greek:
            headline = _in_greek(headline)
            said = words.keys() & {"place", "why", "next"}
            words |= {part: _in_greek(words[part]) for part in said}
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
        """The Verdict on a wrong answer: in the words of this exercise or, when the mistake is
        known, of the catalogue, whose words are about arms, tables and programs.
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

    def told(self, mistake_id: str | None, said: str | Said) -> Verdict:
        """The Verdict on one of this exercise's own wrong answers, in one sentence written for it.

        A text is that sentence; where it is empty the mistake's title is. The catalogue's other
        words are not said: what they tell of an arm or of a program is not true of a number.
        """
        if isinstance(said, str):
            of_place, of_all = self.words.get((mistake_id, said)), self.words.get(mistake_id)
            if of_place or of_all:
                return self.wrong(mistake_id, place=said)
            said = Said(said or catalogue()[mistake_id].title)
        return self.wrong(mistake_id, place=said)

    def slowly(self, verdict: Verdict) -> Verdict:
        """The verdict, told bit by bit where the mistake is what the exercise asks for."""
        return replace(verdict, sparing=self.sparing)


def _in_greek(text):
    """A text with θ2 and α_i in place of theta2 and alpha_i, as the lessons write them."""
    return LETTERS.sub(lambda found: GREEK[found[0]], text)


def no_draw(rng: np.random.Generator) -> dict[str, Any]:
    """The numbers of a task that is the same for everybody: none."""
    return {}


def listed(answer: Any) -> Any:
    """An answer that can only be walked through (zip, map, a generator, the values of a dict) as a
    list; any other as it is.

    Examples
    --------
    >>> listed(map(abs, [-1, 2]))
    [1, 2]
    """
    return list(islice(answer, MOST)) if isinstance(answer, ONCE) else answer


def untouched(answer: Any) -> bool:
    """Whether an answer is still what was handed out: nothing, or dots and nothing else."""
    if answer is None or answer is Ellipsis:
        return True
    entries = _entries(answer)
    return len(entries) > 0 and all(untouched(entry) for entry in entries)


def undecided(answer: Any) -> bool:
    """Whether an answer, or an entry of it, is "?"."""
    if isinstance(answer, str):
        return UNDECIDED in answer
    return any(undecided(entry) for entry in _entries(answer))


def _has_dots(answer):
    return answer is Ellipsis or any(_has_dots(entry) for entry in _entries(answer))


def _entries(answer):
    """The entries of a list, a tuple or an array of objects; of anything else, none."""
    if isinstance(answer, np.ndarray) and answer.dtype.kind in "OU" and answer.ndim:
        return answer.tolist()
    return answer if isinstance(answer, (list, tuple)) else []
