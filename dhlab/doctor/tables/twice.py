"""Two tables of one text that are one: in letters, and again with numbers; or one twice."""

from .completing.alike import stands_for
from .evidence.source import source_of
from .language.letters import unified
from .take_apart import take_apart

__all__ = ["told_once"]

LETTERS = "the text has the table in letters, too"
AGAIN = "the text has the table twice, cell by cell"


def told_once(parts):
    """(a text without one of its two tables, a note) where the one has letters for numbers of the
    other, or where they are the same; None where they are two.
    """
    try:
        one, other = map(take_apart, parts)
    except ValueError:
        return None
    if isinstance(one, list) or isinstance(other, list):
        return None
    source = source_of("\n".join(parts))
    if stands_for(one, other) and one.lines and not _are_given(one, source):
        return "\n".join([_without(parts[0], one), parts[1]]), LETTERS
    letters = stands_for(other, one) and not _are_given(other, source)
    note = LETTERS if letters else AGAIN if _are_one(one, other) else ""
    if not note or not other.lines:
        return None
    return "\n".join([parts[0], _without(parts[1], other)]), note


def _are_given(table, source):
    """Whether the text has numbers for the letters of a table: they may be others than in the
    table with numbers.
    """
    letters = (cell.text for row in table.rows for cell in row if cell.letters)
    given = (source.value(unified(text)) for text in letters)
    return any(value is not None and not value.letters for value in given)


def _without(text, table):
    """A text without the lines of a table."""
    lines = text.split("\n")
    first, last = table.lines
    return "\n".join([*lines[: first - 1], *[""] * (last - first + 1), *lines[last:]])


def _are_one(one, other):
    """Whether two tables say the same, and not of two conventions."""
    books = {one.convention, other.convention} - {None}
    return len(books) < 2 and _cells(one) == _cells(other)


def _cells(table):
    """What each row of a table says of each parameter, and in which units."""
    if table.roles is None:
        return id(table)
    said = [
        {role: (c.value, c.letters, c.unit) for role, c in zip(table.roles, row)}
        for row in table.rows
    ]
    return said, table.units, table.kinds, table.signs
