"""``Verdict``: what the course says of an answer, as text and in a notebook."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from html import escape
from typing import Any

__all__ = ["Verdict", "RIGHT", "WRONG", "NOT_ATTEMPTED", "RECORDED", "TOLD_ALL"]

RIGHT, WRONG, NOT_ATTEMPTED, RECORDED = "right", "wrong", "not attempted", "recorded"
TOLD_ALL = 3  # the wrong answer from which on a sparing verdict tells everything
MARKS = {
    RIGHT: ("✓", "Right"),
    WRONG: ("✗", "Not yet"),
    NOT_ATTEMPTED: ("○", "Not attempted yet"),
    RECORDED: ("•", "Noted"),
}
COLOURS = {RIGHT: "#1a7f37", WRONG: "#b35900", NOT_ATTEMPTED: "#6e7781", RECORDED: "#0b62c4"}


@dataclass(frozen=True)
class Verdict:
    """What is said of one answer.

    Parameters
    ----------
    exercise : str
        The exercise's id, such as "05.2".
    status : "right", "wrong", "not attempted" or "recorded"
    headline : str
        Kind of mistake, or what is good.
    place : str
        Where: a row, a column, a call.
    why, next : str
        The reason and the next step.
    mistake : str or None
        The id in the catalogue, when the mistake was recognised.
    points, of : float
        Earned, and possible.
    known : bool or None
        Of a pre-test: whether the answer was right, which is not shown.
    chosen : tuple of str
        Of an answer in letters: the ids of the options chosen, or "?".
    sparing : bool
        Whether the mistake is what the exercise asks for, so that it is told bit by bit
        (:meth:`at_try`).
    drawn : function or None
        Makes the picture of a wrong answer, or None; called when a notebook shows the verdict.

    Examples
    --------
    >>> print(Verdict("06.6", WRONG, "alpha has the wrong sign", "row 2", next="Thumb along x."))
    ✗ 06.6  Not yet: alpha has the wrong sign
      Where: row 2
      Next:  Thumb along x.
    """

    exercise: str
    status: str
    headline: str = ""
    place: str = ""
    why: str = ""
    next: str = ""
    mistake: str | None = None
    points: float = 0
    of: float = 0
    known: bool | None = None
    chosen: tuple[str, ...] = ()
    sparing: bool = False
    drawn: Callable[[], Any] | None = field(default=None, compare=False, repr=False)

    def at_try(self, count: int) -> "Verdict":
        """What is told at a learner's first, second or later wrong answer: the kind of mistake,
        then also its place, then all. Of a verdict that is not sparing, all.

        Examples
        --------
        >>> said = Verdict("05.7", WRONG, "one entry is wrong", "row 2: its sign", sparing=True)
        >>> print(said.at_try(2))
        ✗ 05.7  Not yet: one entry is wrong
          Where: row 2
          Next:  hint("05.7") gives a first hint; another try is told more.
        """
        if not self.sparing or self.status != WRONG or count >= TOLD_ALL:
            return self
        return replace(
            self,
            headline=self.kind,
            place="" if count < 2 else self.places,
            why="",
            next=f'hint("{self.exercise}") gives a first hint; another try is told more.',
        )

    @property
    def kind(self) -> str:
        """The kind of mistake: the headline up to its first stop or colon."""
        return self.headline.split(". ")[0].split(": ")[0]

    @property
    def places(self) -> str:
        """The place without what is wrong there: each of its parts up to the colon."""
        return "; ".join(part.split(":")[0] for part in self.place.split("; "))

    @property
    def lines(self) -> list[tuple[str, str]]:
        """(label, text) pairs under the headline."""
        return [
            (label, text)
            for label, text in (("Where", self.place), ("Why", self.why), ("Next", self.next))
            if text
        ]

    def __str__(self) -> str:
        mark, word = MARKS[self.status]
        headline = f": {self.headline}" if self.headline else ""
        rest = [f"  {label + ':':6} {text}" for label, text in self.lines]
        return "\n".join([f"{mark} {self.exercise}  {word}{headline}", *rest])

    __repr__ = __str__

    def _repr_html_(self):
        mark, word = MARKS[self.status]
        headline = f": {escape(self.headline)}" if self.headline else ""
        rest = "".join(f"<div><em>{label}:</em> {escape(text)}</div>" for label, text in self.lines)
        return (
            f'<div role="status" style="border-left:4px solid {COLOURS[self.status]};padding:.3em'
            f' .8em;margin:.2em 0"><div><strong>{mark} {escape(self.exercise)}'
            f" {word}</strong>{headline}</div>{rest}{self._picture()}</div>"
        )

    def _picture(self):
        picture = self.drawn and self.drawn()
        return picture._repr_mimebundle_()["text/html"] if picture else ""
