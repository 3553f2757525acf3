"""The catalogue of mistakes: each one's id and its words, read from ``catalogue.yaml``."""

from dataclasses import dataclass
from functools import cache
from pathlib import Path

from .. import plainyaml

__all__ = ["Mistake", "catalogue"]

WORDS = ("title", "see", "why", "next", "lesson")


@dataclass(frozen=True)
class Mistake:
    """One kind of mistake: its id; a title; what is seen; why it happens; what to look at next; the lesson that treats it."""

    id: str
    title: str
    see: str
    why: str
    next: str
    lesson: str


@cache
def catalogue():
    """Every known mistake.

    Returns
    -------
    dict of str to Mistake

    Examples
    --------
    >>> catalogue()["pose-inverted"].title
    'The inverse pose'
    """
    item = plainyaml.read(Path(__file__).with_name("catalogue.yaml"), "the catalogue")
    entries = {}
    for key, entry in item.value.items():
        given = plainyaml.fields(entry, key, required=set(WORDS), allowed=set(WORDS))
        entries[key] = Mistake(key, **{word: plainyaml.text(given[word], word) for word in WORDS})
    return entries
