"""``Verdict``: what the course says of an answer, as text and in a notebook."""

from dataclasses import dataclass
from html import escape

__all__ = ["Verdict", "RIGHT", "WRONG", "NOT_ATTEMPTED", "RECORDED"]

RIGHT, WRONG, NOT_ATTEMPTED, RECORDED = "right", "wrong", "not attempted", "recorded"
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
            f" {word}</strong>{headline}</div>{rest}</div>"
        )
