"""The mark of an explanation: a person gives it. Here is only found out whether there is one, and
what it is called.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from ..intake.notebooks import LARGEST
from ..reports.answered import Answer, read_notebook
from ..results.marks import TO_MARK, Mark

if TYPE_CHECKING:
    from .work import Handed

__all__ = ["OwnWords", "explained", "named"]


class OwnWords:
    """What stands in a student's notebooks, each read once and when it is first asked for; as many
    bytes of them as may be read of one student.
    """

    def __init__(self, notebooks: Sequence[Handed]) -> None:
        self.notebooks = notebooks
        self._raw = {one.name: one.raw for one in notebooks}  # with the pictures still in them
        self._known: dict[str, dict[str, Answer]] = {}
        self._left = LARGEST

    def of(self, handed: Handed, exercise: str) -> Answer | None:
        """The answer to an exercise in one of the notebooks."""
        if handed.name not in self._known:
            raw = self._raw[handed.name]
            fits = len(raw) <= self._left
            self._known[handed.name] = read_notebook(raw) if fits else {}
            self._left -= len(raw) if fits else 0
        return self._known[handed.name].get(exercise)


def named(answer: Any) -> str:
    """A short name of an answer that a person marks, another one when it changes."""
    return "a" + hashlib.sha256(repr(answer).encode()).hexdigest()[:11]


def explained(found: Mark, handed: Handed | None, said: OwnWords) -> tuple[Mark, Handed | None]:
    """(Mark, the notebook it comes from): to be marked where there are words, or a picture in a
    Markdown cell above the check; it names what was answered, so that a mark that the teacher gave
    to another answer does not stand for it.
    """
    for each in [handed] if handed else reversed(said.notebooks):
        answer = said.of(each, found.exercise)
        if answer and (found.status == TO_MARK or answer.pictures):
            words = [answer.code, *(picture.data for picture in answer.pictures)]
            return replace(found, status=TO_MARK, answer=named(words), headline="", next=""), each
    return replace(found, headline="", next="") if found.status == TO_MARK else found, handed
