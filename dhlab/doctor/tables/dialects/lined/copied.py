"""A page that was copied with every cell on a line of its own."""

import re

from ...language.roles import ROLES
from .heading import header
from .spaced import is_cell, spaced_cells

__all__ = ["MOST_WORDS", "named_one_a_line", "one_cell_a_line"]

MOST_WORDS = 4  # of a row's label


def one_cell_a_line(grid, lines):
    """The grid of a page that was copied with every cell on a line of its own; None of others."""
    for k, (_, cells) in enumerate(grid):
        if len(cells) < 4 or not header(cells):
            continue
        rest = [(number, line) for number, line in lines if number > int(grid[k][0].split()[1])]
        if len(rest) < 2 * len(cells) or any(
            "|" in line or len(spaced_cells(line, True)) > 1 for _, line in rest
        ):
            return None
        rows = [rest[at : at + len(cells)] for at in range(0, len(rest), len(cells))]
        if len(rows[-1]) < len(cells):
            rows.pop()
        return [grid[k], *((f"line {row[0][0]}", [line for _, line in row]) for row in rows)]
    return None


def named_one_a_line(lines):
    """The same where the cells of the heading stand in lines of their own, too."""
    words = [line for _, line in lines]
    if len(words) < 8 or any("|" in word or len(spaced_cells(word, True)) > 1 for word in words):
        return None
    windows = [(first, width) for first in range(len(words)) for width in (5, 6, 4)]
    heads = {}
    for first, width in windows:
        cells = words[first : first + width]
        long = any(is_cell(cell) or len(re.findall(r"\w+", cell)) > MOST_WORDS for cell in cells)
        if not long and (head := header(cells)):
            known = len(set(ROLES) & set(head[0]))
            heads[first, width] = -known, head[0][1:].count(None), first
    if not heads:
        return None
    first, width = min(heads, key=heads.get)
    rest = range(first, len(words) - width + 1, width)
    return [(f"line {lines[at][0]}", words[at : at + width]) for at in rest]
