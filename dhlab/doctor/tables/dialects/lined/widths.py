"""How many columns the rows of a table have, and which of them is no number of the four."""

import itertools
from dataclasses import replace

from ...meaning.columns import IMPLIED

__all__ = ["NotFour", "even"]


class NotFour(ValueError):
    """The rows have another number of columns, which nothing names."""


def even(table):
    """The table with four columns (or those its header names), an index column taken off."""
    widths = {len(row) for row in table.rows}
    if len(widths) > 1:
        found = ", ".join(map(str, sorted(widths)))
        raise ValueError(
            f"recognise_table: expected as many cells in every row, found rows of {found} cells;"
            " fill in what is missing"
        )
    width = widths.pop()
    if table.roles is not None and width == len(table.roles):
        return table
    if width == 4 and len(table.rows) > 2 and _counts([row[0] for row in table.rows]):
        note = "the numbers of the links stand before three numbers: theta is not written"
        rows = tuple((*row[1:], IMPLIED) for row in table.rows)
        return replace(table, rows=rows, notes=(*table.notes, note))
    if width == 5 and _counts([row[0] for row in table.rows]):
        labels = tuple(str(int(row[0].value)) for row in table.rows)
        return even(replace(table, rows=tuple(row[1:] for row in table.rows), labels=labels))
    if width == 5 and all(row[4].is_constant and row[4].value in (0, 1) for row in table.rows):
        return replace(
            table,
            rows=tuple(row[:4] for row in table.rows),
            kinds=tuple("P" if row[4].value else "R" for row in table.rows),
        )
    if width != 4:
        raise NotFour(
            f"recognise_table: expected four numbers in a row, found {width}; paste θ, d, a, α in"
            " any order, an index column before them or not"
        )
    return table


def _counts(cells):
    values = [cell.value for cell in cells]
    return (
        all(cell.is_constant for cell in cells)
        and values[0] in (0, 1)
        and all(b - a == 1 for a, b in itertools.pairwise(values))
    )
