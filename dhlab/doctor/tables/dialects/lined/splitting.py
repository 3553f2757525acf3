"""Where the cells of a table in lines end: at pipes, tabs, semicolons, commas or spaces."""

import re
from itertools import groupby

from .heading import header
from .spaced import spaced_cells

__all__ = ["splitter"]

MARKS = ("|", "\t", ";", ",")
# at spaces, wide ones or any
WIDE, NARROW = ((lambda line, wide=wide: spaced_cells(line, wide), None) for wide in (True, False))
FEWEST_BELOW = 2  # rows that are split as their heading is


def splitter(lines):
    """(how the cells of these lines are separated, the mark); a comma is a decimal one where
    something else separates.
    """
    tables = [line for line in lines if re.search(r"\d", line)] or lines
    ways = [
        (_split_at(mark), mark)
        for mark in MARKS
        if sum(line.count(mark) >= (2 if mark in "|\t" else 3) for line in tables)
        > (0 if mark in "|\t" else len(tables) / 2)
    ]
    if ways and (_names(ways[0], lines) or not (headed := _headed(lines))):
        return ways[0]
    if ways:
        return headed
    wide, narrow = (_alike(map(split, lines)) for split, _ in (WIDE, NARROW))
    return WIDE if wide >= max(narrow, 1) else NARROW


def _split_at(mark):
    """How a line is split at a mark."""
    if mark == ",":
        return lambda line: [cell.strip() for cell in re.split(r",(?![^(]*\))", line)]
    return lambda line: _trimmed(line.split(mark), mark)


def _names(way, lines):
    """Whether a line split in this way is a heading."""
    split, mark = way
    return any(header(split(line)) for line in lines if mark is None or mark in line)


def _headed(lines):
    """The way in which the heading of the table, and most of the lines below it, are split; None
    without one. A table of constants in the same text may have another mark.
    """
    for split, mark in (*((_split_at(mark), mark) for mark in MARKS), WIDE, NARROW):
        for k, line in enumerate(lines):
            cells = split(line) if mark is None or mark in line else []
            below = [split(one) for one in lines[k + 1 : k + 1 + FEWEST_BELOW]]
            if header(cells) and below and all(len(one) == len(cells) for one in below):
                return split, mark
    return None


def _alike(rows):
    """How many rows of one width, four or more, follow each other."""
    runs = ((width, len(list(run))) for width, run in groupby(map(len, rows)))
    return max((length for width, length in runs if width >= 4), default=0)


def _trimmed(cells, mark):
    cells = [cell.strip() for cell in cells]
    if mark == "|":
        cells = cells[1:] if cells and not cells[0] else cells
        cells = cells[:-1] if cells and not re.search(r"[^\W_]|[-/?…]", cells[-1]) else cells
    return cells
