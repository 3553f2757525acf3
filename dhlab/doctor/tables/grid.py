"""The grid of a pasted table: which line is its header, what each column is, the rows' cells."""

import itertools
import math
import re
from dataclasses import dataclass, replace

import numpy as np

from .cells import Cell, plain, read_cell

__all__ = ["Pasted", "from_grid", "from_keys"]

ROLES = {
    "theta": ("theta", "th", "q", "joint angle", "angle", "theta offset"),
    "d": ("d", "link offset", "joint offset"),
    "a": ("a", "r", "link length", "length"),
    "alpha": ("alpha", "al", "alfa", "twist", "link twist"),
    "offset": ("offset",),
    "type": ("type", "jointtype", "joint type"),
    "sigma": ("sigma",),
    "label": (
        "i",
        "j",
        "n",
        "no",
        "#",
        "",
        "link",
        "joint",
        "row",
        "name",
        "frame",
        "axis",
        "linki",
    ),
}
ROLE_OF = {word: role for role, words in ROLES.items() for word in words}
UNIT = re.compile(r"[\[(_ ]\s*(deg|degrees|°|rad|radians|mm|cm|m)\s*[\])]?$")
UNIT_OF = {"degrees": "deg", "°": "deg", "radians": "rad"}
PREVIOUS = re.compile(r"_?\(?i[-_]?1\)?$")


@dataclass(frozen=True)
class Pasted:
    """Rows of Cells with what the text around them says.

    ``roles`` are the columns' names in order, None without a header; ``units`` by role;
    ``convention`` as far as it is said; ``labels`` and ``kinds`` ("R", "P", "fixed" or "") one per
    row.
    """

    rows: tuple
    roles: tuple | None
    units: dict
    convention: str | None
    labels: tuple
    kinds: tuple


def _role(cell):
    """(role, unit or "", whether it is the previous row's) of a header cell; role None when it is
    none.
    """
    text = plain(str(cell)).strip("*` ")
    unit = UNIT.search(text)
    text = text[: unit.start()] if unit else text
    text = text.strip(" _,")
    previous = bool(PREVIOUS.search(text)) and text not in ROLE_OF
    bare = (
        PREVIOUS.sub("", text)
        if previous
        else (
            re.sub(r"(?<=[a-z])[_ ]?\(?i\)?$", "", text)
            if text not in ROLE_OF and text != "i"
            else text
        )
    )
    return (
        ROLE_OF.get(bare.strip(" _")),
        UNIT_OF.get(unit.group(1), unit.group(1)) if unit else "",
        previous,
    )


def _header(cells):
    """(roles, units, convention) when a line is a header."""
    found = [_role(cell) for cell in cells]
    roles = tuple(role for role, _, _ in found)
    if len({"theta", "d", "a", "alpha"} & set(roles)) < 3 or any(
        isinstance(cell, (int, float)) for cell in cells
    ):
        return None
    previous = any(was and role in ("a", "alpha") for role, _, was in found)
    return roles, {role: unit for role, unit, _ in found if unit}, "craig" if previous else None


def from_grid(grid, said):
    """The Pasted table in (where, cells) of each line; ``said`` is the convention or None."""
    roles, units, rows, labels, kinds = None, {}, [], [], []
    for where, cells in grid:
        head = _header(cells) if not rows else None
        if head:
            roles, units = head[:2]
            said = said or head[2]
            continue
        if not rows and roles is None and _is_title(cells):
            continue
        row, label, kind = _row(cells, roles, where)
        rows.append(row), labels.append(label), kinds.append(kind)
    if not rows:
        raise ValueError(
            "recognise_table: expected at least one row of four numbers, found none; paste the"
            " table with its rows, one per line"
        )
    kept = roles and tuple(
        role for role in roles if role in ("theta", "d", "a", "alpha", "offset", "sigma")
    )
    return _even(Pasted(tuple(rows), kept, units, said, tuple(labels), tuple(kinds)))


def _is_title(cells):
    """A line above the table: at most half of its words could be cells."""
    return 2 * sum(
        isinstance(cell, (int, float, np.number)) or _try(cell) is not None for cell in cells
    ) <= len(cells)


def _try(cell):
    try:
        return read_cell(str(cell))
    except ValueError:
        return None


def _row(cells, roles, where):
    """(Cells, label, kind) of one line."""
    label, kind, kept = "", "", []
    if roles is not None and "label" not in roles and len(cells) == len(roles) + 1:
        label, cells = (
            plain(str(cells[0])),
            cells[1:],
        )  # the header has no word above the row numbers
    if roles is not None and len(cells) != len(roles):
        raise ValueError(
            f"recognise_table: {where}: expected {len(roles)} cells as in the header, found"
            f" {len(cells)}; fill in what is missing"
        )
    for k, cell in enumerate(cells):
        role = roles[k] if roles else None
        word = plain(cell) if isinstance(cell, str) else ""
        if role == "label":
            label = word or str(cell)
        elif role == "type" or word in (
            "r",
            "p",
            "revolute",
            "prismatic",
            "fixed",
            "rotational",
            "linear",
            "rev",
            "pris",
        ):
            kind = "fixed" if word == "fixed" else "P" if word[:1] in ("p", "l") else "R"
        elif roles is None and k == 0 and isinstance(cell, str) and _try(cell) is None:
            label = word
        elif role is not None or roles is None:
            kept.append(_cell(cell, where, k))
    return tuple(kept), label, kind


def _cell(cell, where, k):
    if isinstance(cell, (int, float, np.number)) and not isinstance(cell, bool):
        if not math.isfinite(cell):
            raise ValueError(
                f"recognise_table: {where}, cell {k + 1}: expected a finite number, found {cell};"
                " look at where it was computed"
            )
        return Cell(float(cell))
    if isinstance(cell, str) and plain(cell) in ("-", "", "nan"):
        raise ValueError(
            f"recognise_table: {where}, cell {k + 1}: expected a number, found an empty cell; write"
            " 0 where 0 is meant"
        )
    try:
        return read_cell(str(cell))
    except ValueError as error:
        raise ValueError(f"recognise_table: {where}, cell {k + 1}: {error}") from None


def _even(table):
    """The table with four columns (or those its header names), an index column taken off."""
    widths = {len(row) for row in table.rows}
    if len(widths) > 1:
        found = ", ".join(map(str, sorted(widths)))
        raise ValueError(
            f"recognise_table: expected as many cells in every row, found rows of {found} cells;"
            " fill in what is missing"
        )
    width = widths.pop()
    if table.roles is not None:
        return table
    if width == 5 and _counts([row[0] for row in table.rows]):
        labels = tuple(str(int(row[0].value)) for row in table.rows)
        return replace(table, rows=tuple(row[1:] for row in table.rows), labels=labels)
    if width == 5 and all(row[4].is_constant and row[4].value in (0, 1) for row in table.rows):
        return replace(
            table,
            rows=tuple(row[:4] for row in table.rows),
            kinds=tuple("P" if row[4].value else "R" for row in table.rows),
        )
    if width != 4:
        raise ValueError(
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


def from_keys(keyed, said):
    """Rows written as name=value, as in the Robotics Toolbox's RevoluteDH(d=0.1, a=0,
    alpha=pi/2).
    """
    rows, kinds = [], []
    for where, found, line in keyed:
        if re.search(r"mdh\b", line, re.IGNORECASE):
            said = "craig"
        elif re.search(r"(revolute|prismatic)dh\b", line, re.IGNORECASE):
            said = said or "standard"
        cells = {
            name: _cell(text.strip(" '\""), where, k)
            for k, (name, text) in enumerate(found.items())
        }
        rows.append(
            tuple(cells.get(name, Cell(0.0)) for name in ("theta", "d", "a", "alpha", "offset"))
        )
        kinds.append("P" if "prismatic" in line.lower() else "R")
    return Pasted(
        tuple(rows),
        ("theta", "d", "a", "alpha", "offset"),
        {},
        said,
        ("",) * len(rows),
        tuple(kinds),
    )
