"""The mark of an explanation: a person gives it. Here is only found out whether there is one."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from ..reports.answered import read_notebook
from ..results.marks import TO_MARK, Mark

if TYPE_CHECKING:
    from .work import Handed

__all__ = ["explained"]


def explained(
    found: Mark, handed: Handed | None, notebooks: Sequence[Handed]
) -> tuple[Mark, Handed | None]:
    """(Mark, the notebook it comes from): to be marked where there are words, or a picture in a
    Markdown cell above the check; it names what was answered, so that a mark that the teacher gave
    to another answer does not stand for it.
    """
    for each in [handed] if handed else reversed(notebooks):
        answer = read_notebook(each.raw).get(found.exercise)
        if answer and (found.status == TO_MARK or answer.pictures):
            said = [answer.code, *(picture.data for picture in answer.pictures)]
            name = "a" + hashlib.sha256(repr(said).encode()).hexdigest()[:11]
            return replace(found, status=TO_MARK, answer=name, headline="", next=""), each
    return replace(found, headline="", next="") if found.status == TO_MARK else found, handed
