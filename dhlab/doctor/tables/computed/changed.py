"""Rows that a program changes after it has written them: what it has in the end counts."""

from dataclasses import replace
from itertools import combinations

import numpy as np

from ..language.roles import role_of
from .chains import tables_of

__all__ = ["with_changes"]

UNITS = {np.pi / 180: "deg", 1e-3: "mm", 1e-2: "cm", 0.0254: "in"}
SCALES = (1.0, *UNITS, 180 / np.pi, 1e3, 1e2)  # of a column that a program converts
TURNING = "theta", "offset"  # the joints' values change them
MOST_COMBINED = 70
OTHER_ROWS = ("rows",)
LAST_ROW = (0, 0, 0, 1)  # of a pose


def with_changes(table, text):
    """The table with the last numbers of its rows, where the text is a program that changes them;
    a column that it only converts stays as it is written.

    Parameters
    ----------
    table : Pasted
    text : str

    Raises
    ------
    ValueError
        The program adds rows, or takes some away; it sets numbers to what nobody knows; or it
        holds the rows as they are written, too.
    """
    held = tables_of(text, 1)
    found: dict = {}
    for k, one in enumerate(held):
        changes = () if one.first == one.last else _changes_of(table, k, one, text)
        if changes:
            found.setdefault(changes, one)
    if found and any(one.first == one.last and _places(table, one.first) for one in held):
        found = {changes: one for changes, one in found.items() if not one.is_local}
        _ask(found, "holds the rows as they are written, and changed ones")
    if len(found) > 1:
        _ask(found, "changes the rows in two ways later")
    if OTHER_ROWS in found:
        _ask(found, "changes the number of rows later")
    for changes, one in found.items():
        table = _changed(table, dict(changes), one.name)
    return table


def _ask(found, what):
    """A question, where anything was found."""
    names = ", ".join(one.name for one in found.values() if one.name)
    if found:
        raise ValueError(
            f"recognise_table: the program {what}{_of(names)}; which ones are meant? Paste the rows"
            " as they are in the end"
        )


def _changes_of(table, k, held, text):
    """What a program's k-th table has otherwise than the rows: pairs of (row, column) and number;
    nothing where it is another table.
    """
    if _goes_on(table, held.last):
        return OTHER_ROWS
    places = _places(table, held.first)
    if places is None:
        return ()
    again = tables_of(text, 2)
    last = _in_both(held.last, again[k].last) if k < len(again) else None
    if last is None or _lengths(held.first) != _lengths(last):
        return OTHER_ROWS
    changes: dict = {}
    for column, key in places.items():
        changes |= _changes(table, column, held.first[key], last.get(key))
    return tuple(sorted(changes.items()))


def _lengths(columns):
    return {len(column) for column in columns.values()}


def _goes_on(table, last):
    """Whether a program's table has the rows, in their order, and others."""
    rows = [*zip(*(last or {}).values())]
    if len(rows) <= len(table.rows) or len(rows[0]) != len(table.rows[0]):
        return False
    if rows[-1] == LAST_ROW:
        return False
    left = iter(rows)
    return all(
        any(all(_is([cell], [held]) for cell, held in zip(row, one)) for one in left)
        for row in table.rows
    )


def _in_both(last, again):
    """Last columns, None in the place of a number that is not the same in two runs."""
    if last is None or again is None or list(last) != list(again):
        return None
    return {
        key: [a if a == b else None for a, b in zip(last[key], again[key])]
        if len(last[key]) == len(again[key]) else last[key]
        for key in last
    }  # fmt: skip


def _of(name):
    return f" in {name[:40]}" if name else ""


def _places(table, first):
    """Which column of a program's table each column of the rows is; None where they are another
    table.
    """
    columns = [*zip(*table.rows)]
    needed = {k for k, column in enumerate(columns) if any(_plain(cell) for cell in column)}
    if len(table.rows) < 2 or not needed:
        return None
    keys = list(first)
    if all(isinstance(key, int) for key in keys):
        kept = range(len(columns)) if len(columns) <= len(keys) else sorted(needed)
        ways = [*combinations(keys, len(kept))][:MOST_COMBINED]
        fits = [
            way for way in ways if all(_is(columns[k], first[key]) for k, key in zip(kept, way))
        ]
        return dict(zip(kept, fits[0])) if len(fits) == 1 else None
    roles = [role_of(str(key))[0] for key in keys]
    found = {}
    for k, role in enumerate(table.roles or ()):
        for key, said in zip(keys, roles):
            if said == role and _is(columns[k], first[key]):
                found[k] = key
    return found if needed <= set(found) else None


def _plain(cell):
    """The number of a cell that has no letter; 0 of others."""
    return cell.value if cell.is_constant else 0.0


def _is(column, numbers):
    """Whether a column of cells is one of numbers, in some unit."""
    if len(column) != len(numbers):
        return False
    known = [(cell.value, held) for cell, held in zip(column, numbers)
             if cell.is_constant and held is not None]  # fmt: skip
    return _scale(known) is not None and len(known) == sum(cell.is_constant for cell in column)


def _scale(pairs):
    """How many times as large all second numbers of pairs are; None where they are no one unit."""
    return next((c for c in SCALES if all(_same(c * a, b) for a, b in pairs)), None)


def _same(one, other):
    return abs(one - other) <= 1e-9 * max(1e-3, abs(one))


def _changes(table, k, first, last):
    """What replaces numbers of a column: (row, column) to the number, in the unit of the rows."""
    role = table.roles[k] if table.roles else None
    if last is None or first == last or role in TURNING:
        return {}
    cells = [row[k] for row in table.rows]
    known = [i for i, cell in enumerate(cells) if cell.is_constant and last[i] is not None]
    if len(known) < len(cells) and role in ("a", "alpha"):
        raise ValueError(
            f"recognise_table: the program sets {role} of row"
            f" {next(i for i in range(len(cells)) if i not in known) + 1} later, to what is not"
            " known; which number is meant? Paste the rows as they are in the end"
        )
    counts = {c: sum(bool(cells[i].value) and _same(c * cells[i].value, last[i]) for i in known)
              for c in SCALES}  # fmt: skip
    scale = max(SCALES, key=counts.get)
    if not counts[scale]:
        scale = _scale([(cells[i].value, first[i]) for i in known]) or 1.0
    return {
        (i, k): float(f"{last[i] / scale:.12g}")
        for i in known
        if not _same(scale * cells[i].value, last[i])
    }


def _changed(table, changes, name):
    rows = [list(row) for row in table.rows]
    for (i, k), value in changes.items():
        rows[i][k] = replace(rows[i][k], value=value, text=f"{value:g}")
    said = ", ".join(
        f"{table.rows[i][k].text} of row {i + 1} is {value:g}"
        for (i, k), value in list(changes.items())[:3]
    )
    note = f"the program changes its rows{_of(name)} later: {said}"
    return replace(table, rows=tuple(map(tuple, rows)), notes=(*table.notes, note))
