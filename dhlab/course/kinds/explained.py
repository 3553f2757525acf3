"""An answer in one's own words or as a picture, which a person marks."""

from dataclasses import dataclass
from typing import Any

from ..verdict import NOT_ATTEMPTED, RECORDED, Verdict
from .exercise import Exercise, untouched

__all__ = ["Explain"]


@dataclass(frozen=True, kw_only=True)
class Explain(Exercise):
    """A question that is answered in words, or with a picture that is put into a Markdown cell
    above the check; the teacher marks it in ``dhlab review``.

    ``question`` is what is asked; ``rubric`` holds (what earns points, how many), which together
    are the exercise's points. It is shown to the student too.

    Examples
    --------
    >>> asked = Explain(id="10.3", title="Why", points=2, question="Why does it hold?",
    ...     rubric=(("names the seal", 1), ("names the pressure", 1)))
    >>> print(asked.judge("Because air presses on it."))
    • 10.3  Noted: kept for your teacher
      Next:  A person marks it; change it as often as you like before you hand in.
    """

    question: str
    rubric: tuple[tuple[str, float], ...]
    hints: tuple = (
        "Which of the lines under the question can you answer first?",
        "Write one sentence for each line under the question.",
    )

    def __post_init__(self) -> None:
        if sum(points for _, points in self.rubric) != self.points:
            raise ValueError(
                f"{self.id}: expected a rubric whose points are {self.points:g} in all, found"
                f" {sum(points for _, points in self.rubric):g}; change one of them"
            )

    def shown(self, variant: int = 0) -> str:
        lines = "\n".join(f"- {text} ({points:g})" for text, points in self.rubric)
        return f"{super().shown(variant)}\n\n{self.question}\n\nYour teacher marks:\n\n{lines}"

    def judge(self, answer: Any, variant: int = 0) -> Verdict:
        """Kept, whatever it says; an empty text, dots or "?" are no answer yet."""
        if untouched(answer) or (isinstance(answer, str) and answer.strip() in ("", "?", "...")):
            return self.say(
                NOT_ATTEMPTED,
                next='Write your answer between quotes; for a picture write "see the picture".',
            )
        return self.compare(answer, variant)

    def compare(self, answer: Any, variant: int) -> Verdict:
        return self.say(
            RECORDED,
            "kept for your teacher",
            next="A person marks it; change it as often as you like before you hand in.",
        )
