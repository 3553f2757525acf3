"""The catalogue of mistakes: each one's id and its words, read from ``catalogue.yaml``."""

from dataclasses import dataclass
from functools import cache
from pathlib import Path

from ..formats import plainyaml

__all__ = ["Mistake", "catalogue"]

WORDS = ("title", "see", "why", "next", "lesson")
LISTS = ("refs", "also")


@dataclass(frozen=True)
class Mistake:
    """One kind of mistake: its id; a title; what is seen; why it happens; what to look at next; the
    lesson that treats it.

    ``refs`` are threads and pages where people met it; ``also`` are other ids under which
    :func:`catalogue` finds it.

    Examples
    --------
    >>> mistake = catalogue()["alpha-sign"]
    >>> mistake.id, mistake == catalogue()[mistake.id]
    ('alpha-sign', True)
    """

    id: str
    title: str
    see: str
    why: str
    next: str
    lesson: str
    refs: tuple = ()
    also: tuple = ()


@cache
def catalogue():
    """Every known mistake, by its id and by its other ids; an entry stands under its own id when
    ``key == mistake.id``.

    Returns
    -------
    dict of str to Mistake

    Examples
    --------
    >>> catalogue()["pose-inverted"].title
    'The inverse pose'
    >>> catalogue()["state-kept-between-calls"].id
    'state-between-calls'
    """
    item = plainyaml.read(Path(__file__).with_name("catalogue.yaml"), "the catalogue")
    entries = {}
    for key, entry in item.value.items():
        mistake = _mistake(key, entry)
        for name in (key, *mistake.also):
            if name in entries:
                raise ValueError(
                    f"{entry.where}: the catalogue: expected every id once, found {name!r} twice"
                )
            entries[name] = mistake
    return entries


def _mistake(key, entry):
    given = plainyaml.fields(entry, key, required=set(WORDS), allowed={*WORDS, *LISTS})
    words = {word: plainyaml.text(given[word], word) for word in WORDS}
    lists = {
        name: tuple(plainyaml.text(line, name) for line in plainyaml.entries(given[name], name))
        for name in LISTS
        if name in given
    }
    return Mistake(key, **words, **lists)
