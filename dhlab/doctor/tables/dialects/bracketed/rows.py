"""Rows between brackets, in any language: a matrix, a list of lists, initialisers, a list of
dictionaries, a stream of numbers.
"""

import re
from dataclasses import replace

from ...cells import cell_of, cell_or_none
from ...evidence.makers import made_by
from ...evidence.orders import order_of_three
from ...evidence.poses import holds_joint_values
from ...language.brackets import groups
from ...language.roles import ROLES
from ...meaning.beside import labelled, with_types
from ...meaning.columns import IMPLIED
from ..keyed import in_groups
from ..lined.grid import from_grid
from .beyond import fitting, without_words
from .filled import TABLE, filled
from .matrix import (
    WIDEST,
    heading_in,
    instances,
    joined,
    laid_down,
    require_one,
    rows_in,
    target_of,
)

__all__ = ["read"]

NO_TABLE = re.compile(r"screw|twist|[sb]_?list|jacob|inerti|axes|limit|^m(?:_|$)|home|pose")
WIDE = 8  # columns; more only where the text names the first four
LAST_ROW = [0, 0, 0, 1]  # of a pose


def read(source, nominal=None):
    """The Pasted table of the largest group of rows; None when there is none."""
    return in_groups(source) or _numbers(source)


def _numbers(source):
    found = groups(source.code)
    matrices, lying = _matrices(found, source)
    upright = "dq" in source.code.lower() and len(matrices[0][1]) in (4, 5) if matrices else False
    if matrices and len(matrices[0][1][0][1]) == 3 and not (upright or lying):
        return _of_three(matrices, source)
    grids = [_likeliest(matrices), *filled(found, source)]
    grid = max((grid for grid in grids if _is_read(grid, source)), key=_size, default=None)
    if not grid or _size(grid) < 4:
        return None
    order, convention, form = made_by(source)
    why, units = f"as {form} has them" if form else "", {}
    if order is None:
        said = source.order
        if said:
            order, units, why, _ = said
    width = len(grid[0][1])
    name = next((target_of(group) for group, rows in matrices if rows is grid), "")
    sideways = laid_down(grid, name, source)
    if sideways or (
        len(grid) in (4, 5) and width not in (4, 5) and "dq" in form.lower() + source.code.lower()
    ):
        order, why = sideways or (order, why)
        grid = [
            (f"column {k}", list(column))
            for k, column in enumerate(zip(*(row for _, row in grid[:4])), 1)
        ]
        width = 4
    heads = heading_in(found, width) if order is None else None
    beside = {}
    if order is None and not heads:
        grid, beside = without_words(grid)
    fits, grid, left = fitting(grid, order, source)
    table = from_grid([heads, *grid] if heads else grid, source, fits, why, units, form)
    table = replace(table, notes=(*table.notes, *left))
    table = labelled(with_types(replace(table, **beside), source), grid, source)
    if convention:
        table = replace(table, convention=convention, because=f"as {form} has it")
    return _without_theta(table, source) if form.startswith("SerialLink") else table


def _matrices(found, source):
    """(the groups that may be the table, each with its rows; those of them that lie on a side)."""
    matrices = [
        (group, rows)
        for group in found
        if _is_table(rows := rows_in(group), source) and not _is_vector(group, rows, source)
    ]
    most = WIDEST if source.order else WIDE
    matrices = [one for one in matrices if len(one[1][0][1]) <= most]
    lying = [one for one in matrices if laid_down(one[1], target_of(one[0]), source)]
    whole = [one for one in matrices if len(one[1][0][1]) > 3 and one not in lying]
    lying = [] if whole else lying
    matrices = instances(joined(lying or whole or matrices, found))
    require_one(matrices)
    return matrices, lying


def _likeliest(matrices):
    """The rows that are named a table, else those of four or five numbers, else the largest."""

    def likely(one):
        name, rows = target_of(one[0]), one[1]
        named = bool(re.search(r"dh|denavit", name)) - bool(NO_TABLE.search(name))
        return named, len(rows[0][1]) in (4, 5), _size(rows)

    return max(matrices, key=likely, default=(None, []))[1]


def _of_three(matrices, source):
    """The Pasted table of rows without theta, where something says that they are rows."""
    said, named = order_of_three(source), []
    for group, rows in matrices:
        if TABLE.search(target_of(group)) or (said and not source.order):
            named.append(rows)
    rows = max(named, key=len, default=None)
    if rows is None or len(rows) < 2:
        return None
    roles, why = said or ((), "")
    left = next((role for role in ROLES if role not in roles), "theta") if said else "theta"
    turning = [(where, [*cells, IMPLIED.text if left == "theta" else "0"]) for where, cells in rows]
    table = from_grid(turning, source, (*roles, left) if said else None, why)
    note = {"theta": "each row is taken for a joint that turns, with its zero at theta = 0"}.get(
        left, "it is 0, as the text says"
    )
    table = labelled(table, rows, source)
    return replace(table, notes=(*table.notes, f"no column {left}: {note}"))


def _without_theta(table, source):
    """As the toolbox reads the rows: of a turning joint q takes the place of theta."""
    if table is None or "theta" not in table.roles:
        return table
    k, rows, notes = table.roles.index("theta"), [], []
    for i, row in enumerate(table.rows):
        cell = row[k]
        if cell.is_constant and cell.value:
            notes.append(
                f"theta = {cell.text} of row {i + 1} is left out, as the toolbox does: the joint's"
                " value takes its place; a zero offset is written offset"
            )
            row = (*row[:k], cell_of(source.value("0")), *row[k + 1 :])
        rows.append(row)
    return replace(table, rows=tuple(rows), notes=(*table.notes, *notes))


def _is_read(rows, source):
    """Whether all cells are numbers, but for names in quotation marks."""
    cells = (cell for _, row in rows for cell in row if str(cell)[:1] not in "'\"")
    return all(source.value(cell) is not None for cell in cells)


def _is_table(rows, source):
    """Whether rows are no matrix of formulas, no pose, nor the last row of one."""
    read = _is_read(rows, source) and bool(
        re.search(r"\d", " ".join(str(cell) for _, row in rows for cell in row))
    )
    last = len(rows) in (1, 2, 4) and _values(rows[-1][1]) == LAST_ROW
    return read and bool(rows) and not last and not _is_unit(rows)


def _values(cells):
    """The numbers of plain cells, None in the place of any other."""
    found = (cell_or_none(str(cell)) for cell in cells)
    return [cell.value if cell is not None and cell.is_constant else None for cell in found]


def _is_vector(group, rows, source):
    """Whether four numbers are no row: an argument among others, or a part of an expression."""
    if len(rows) > 1 or TABLE.search(target_of(group)):
        return False
    if holds_joint_values(group.target, source):
        return True
    if group.outer is not None and group.outer.mark == "(" and len(group.outer.items) > 1:
        return True
    alone = source.lines[group.line - 1].strip(" ;,") == group.text
    return not target_of(group) and group.outer is None and "\n" not in group.text and not alone


def _is_unit(rows):
    """Whether a matrix is the unit one, or the rows of it that take a part of another."""
    cells = [_values(row) for _, row in rows]
    ones = all(row.count(1) == 1 and row.count(0) == len(row) - 1 for row in cells)
    return ones and [row.index(1) for row in cells] == list(range(len(rows))) and len(rows) > 2


def _size(grid):
    return sum(len(cells) for _, cells in grid or ())
