"""Rows between brackets, in any language: a matrix, a list of lists, initialisers, a list of
dictionaries, a stream of numbers.
"""

import itertools
import re
from dataclasses import replace

from ..beside import labelled, with_types
from ..cells import cell_of
from ..evidence.makers import made_by
from ..evidence.orders import every_column_in, order_of_three
from ..language.brackets import cells_in, groups
from ..language.expressions import Value
from ..language.roles import ROLES, role_of
from ..language.words import KINDS
from ..meaning.columns import IMPLIED
from .filled import TABLE, filled
from .grid import from_grid
from .keyed import in_groups

__all__ = ["read"]

NO_TABLE = re.compile(r"screw|twist|[sb]_?list|jacob|inerti|axes|limit|^m(?:_|$)|home|pose")
WIDE, WIDEST = 8, 24  # columns; beyond WIDE only where the text names the first four
TYPES = ("R", "P", "REVOLUTE", "PRISMATIC")
LAST_ROW = ["0", "0", "0", "1"]


def read(source, nominal=None):
    """The Pasted table of the largest group of rows; None when there is none."""
    return in_groups(source) or _numbers(source)


def _numbers(source):
    found = groups(source.code)
    matrices = [(group, rows) for group in found if _is_table(rows := _matrix(group), source)]
    most = WIDEST if source.order else WIDE
    matrices = [one for one in matrices if len(one[1][0][1]) <= most]
    matrices = [one for one in matrices if len(one[1][0][1]) > 3] or matrices
    _require_one(matrices)
    upright = "dq" in source.code.lower() and len(matrices[0][1]) in (4, 5) if matrices else False
    if matrices and len(matrices[0][1][0][1]) == 3 and not upright:
        return _of_three(matrices, source)
    grids = [_likeliest(matrices), *filled(found, source)]
    grid = max((grid for grid in grids if _is_read(grid, source)), key=_size, default=None)
    if not grid or _size(grid) < 4:
        return None
    order, convention, form = made_by(source)
    why, units = f"as {form} has them" if form else "", {}
    if order is None:
        found = source.order
        if found:
            order, units, why, _ = found
    width = len(grid[0][1])
    if len(grid) in (4, 5) and width not in (4, 5) and "dq" in form.lower() + source.code.lower():
        grid = [
            (f"column {k}", list(column))
            for k, column in enumerate(zip(*(row for _, row in grid[:4])), 1)
        ]
        width = 4
    fits, left = order if order and width in (4,) else None, ()
    named = every_column_in(source, width) if width > 4 else None
    if named:
        fits, order = named, ()
    words = _words_in(grid)
    if order and words and width - len(words) == 4:
        left_over = iter(order)
        fits = tuple(words.get(k) or next(left_over) for k in range(width))
    elif order and width > 6:  # limits and the like stand behind
        fits = _with_named(order, source)
        grid = [(where, row[: len(fits)]) for where, row in grid]
        left = (f"the columns behind {fits[-1]} were left out",)
    elif order and width > 4:
        fits = _with_more(order, [row for _, row in grid], source)
    table = from_grid(grid, source, fits, why, units, form)
    table = replace(table, notes=(*table.notes, *left))
    table = labelled(with_types(table, source), grid, source)
    if convention:
        table = replace(table, convention=convention, because=f"as {form} has it")
    return _without_theta(table, source) if form.startswith("SerialLink") else table


def _words_in(grid):
    """{column: "label" or "type"} of the columns that hold words in quotation marks."""
    found = {}
    for k, column in enumerate(zip(*(cells for _, cells in grid))):
        if all(str(cell)[:1] in "'\"" for cell in column):
            named = {str(cell).strip("'\" ").lower() for cell in column} <= set(KINDS)
            found[k] = "type" if named else "label"
    return found


def _target(group):
    """What a group is assigned to, itself or in a call: ``dh = np.array([…])``."""
    outer = group.outer.target if group.outer is not None else ""
    return (group.target or outer).lower()


def _likeliest(matrices):
    """The rows that are named a table, else those of four or five numbers, else the largest."""

    def likely(one):
        name, rows = _target(one[0]), one[1]
        named = bool(re.search(r"dh|denavit", name)) - bool(NO_TABLE.search(name))
        return named, len(rows[0][1]) in (4, 5), _size(rows)

    return max(matrices, key=likely, default=(None, []))[1]


def _of_three(matrices, source):
    """The Pasted table of rows without theta, where something says that they are rows."""
    said, named = order_of_three(source), []
    for group, rows in matrices:
        if TABLE.search(_target(group)) or (said and not source.order):
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


def _require_one(matrices):
    """Two tables by their names, dh_left and dh_right, are two arms: nobody can say which."""
    tables: dict = {}
    for group, rows in matrices:
        if len(rows) > 1 and re.search(r"dh|table|param", _target(group)):
            tables.setdefault(str([cells for _, cells in rows]), (_target(group), len(rows[0][1])))
    widths = [width for _, width in tables.values()]
    if len(tables) > 1 and len(set(widths)) == 1:
        names = ", ".join(name for name, _ in tables.values())
        raise ValueError(
            f"recognise_table: expected one table, found two or more: {names[:60]}; paste one of"
            " them"
        )


def _with_more(order, rows, source):
    """The order where an index or a name stands before the four, or sigma and an offset after."""
    more = ("sigma", "offset")
    words, last = ({str(row[k]).strip("'\" ").upper() for row in rows} for k in (4, -1))
    if last <= {*TYPES} and len(rows[0]) == 6 and _is_labelled(rows):
        return ("label", *order, "type")
    if words <= {*TYPES}:
        more = ("type", "offset")
    elif any(source.value(row[4]) not in (Value(0.0), Value(1.0)) for row in rows):
        more = ("offset", "sigma")
    if any(re.search(r"al(?:ph|f)a\W+(?:theta_?)?offset", text) for _, text in source.comments):
        more = ("offset", "sigma")
    if (
        "offset" in more[:1]
        and not _is_labelled(rows)
        and not re.search(r"off|zero|home|init|sigma", source.text.lower())
    ):
        raise ValueError(
            "recognise_table: expected four numbers in a row, found a fifth column that nothing"
            " names; what is it? Name all columns in a comment above the rows"
        )
    first, width = [str(row[0]).strip("'\" ") for row in rows], len(rows[0])
    if all(word.upper() in TYPES for word in first):
        return ("type", *order, *more[: width - 5])
    if _is_labelled(rows):
        return ("label", *order, *more[: width - 5])
    return (*order, *more[: width - 4])


def _is_labelled(rows):
    """Whether a name or the number of the link stands before the numbers of each row."""
    first = [str(row[0]).strip("'\" ") for row in rows]
    named = not any(re.match(r"[-+.]?\d|[-+]", word) for word in first)
    return named or first == [str(k) for k in range(1, len(rows) + 1)]


def _with_named(order, source):
    """The order with sigma and offset behind it, where a comment names them there."""
    for _, text in source.comments:
        roles = [role_of(word)[0] for word in re.findall(r"[A-Za-z]\w*", text)]
        for at in range(len(roles) - 4):
            if tuple(roles[at : at + 4]) == tuple(order):
                more = itertools.takewhile(("sigma", "offset").__contains__, roles[at + 4 :])
                return (*order, *more)
    return order


def _matrix(group):
    """[(where, cells)] of the rows in a group."""
    rows, items = [], [item for item in group.items if item.text not in ("None", "null", "nil")]
    inner = [
        item.groups[-1]
        for item in items
        if item.groups
        and item.text.rstrip().endswith(item.groups[-1].text)
        and re.fullmatch(r"[\w.:]*\s*", item.text[: -len(item.groups[-1].text)] or "")
    ]
    alone = len(items) == 1 and len(items[0].groups) > 1
    if alone and not "".join(_between(items[0])).strip():
        inner = items = items[0].groups  # Lisp: no mark between the rows
    if len(inner) >= 1 and len(inner) == len(items):
        rows = [(f"line {part.line}", [item.text for item in part.items]) for part in inner]
        rows = [(where, cells_in(cells[0]) if len(cells) == 1 else cells) for where, cells in rows]
    elif all(part.mark == "(" for part in inner):
        line: list = []
        for item in group.items:
            line.append(item)
            if item.after != ",":
                rows.append(line)
                line = []
        rows = [
            (
                f"line {row[0].line}",
                cells_in(row[0].text) if len(row) == 1 else [item.text for item in row],
            )
            for row in [*rows, *([line] if line else [])]
        ]
    rows = _without_maker(rows)
    if not rows or len({len(cells) for _, cells in rows}) > 1 or not 3 <= len(rows[0][1]) <= WIDEST:
        return []
    if len(rows) == 1 and (
        (group.outer is not None and group.outer.mark != "(" and len(group.outer.items) > 1)
        or group.mark == "("
        or (not inner and group.mark != "[")
        or len(rows[0][1]) > 5
    ):
        return []
    return rows


def _between(item):
    """What of an item stands between its groups."""
    rest = item.text
    for part in item.groups:
        before, _, rest = rest.partition(part.text)
        yield before
    yield rest


def _without_maker(rows):
    """The rows without one name that stands before the numbers of each: ``Link 0 0.3 0 90``."""
    first = {cells[0] for _, cells in rows if cells}
    if len(rows) > 1 and len(first) == 1 and re.fullmatch(r"[A-Z]\w+", str(*first)):
        return [(where, cells[1:]) for where, cells in rows]
    return rows


def _is_read(rows, source):
    """Whether all cells are numbers, but for names in quotation marks."""
    cells = (cell for _, row in rows for cell in row if str(cell)[:1] not in "'\"")
    return all(source.value(cell) is not None for cell in cells)


def _is_table(rows, source):
    """Whether rows are no matrix of formulas, no pose, nor the last row of one."""
    read = _is_read(rows, source) and bool(
        re.search(r"\d", " ".join(str(cell) for _, row in rows for cell in row))
    )
    last = len(rows) in (1, 4) and [str(cell).strip() for cell in rows[-1][1]] == LAST_ROW
    return read and bool(rows) and not last


def _size(grid):
    return sum(len(cells) for _, cells in grid or ())
