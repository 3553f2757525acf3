"""Of which kind the joint of each row of a pasted table is, and how its variable counts; letters
that stand for nothing are asked about.
"""

import math
import re
from dataclasses import replace

from ..cells import Cell

__all__ = [
    "MOVES",
    "by_number",
    "joints_of",
    "named_alone",
    "require_one_column",
    "require_values",
    "rows_of_d",
]

# what turns a joint's value in degrees, or a stroke in mm or cm, into the unit of the table
FACTORS = {"R": (1.0, math.pi / 180), "P": (1.0, 0.001, 0.01, 0.1, 10.0, 1000.0)}
MOVES = {"theta": ("theta", "q", "?"), "d": ("d", "q", "theta", "?")}


def joints_of(table, columns, still):
    """("R", "P" or "" of each row, the sign of each); ``still`` says it of rows that have no
    variable, as (row number from 0, letter).

    Raises
    ------
    ValueError
        Letters stand for numbers that the text does not give, or a joint variable where none can
        be.
    """
    n, silent = len(table.rows), dict(still)
    kinds = table.kinds or ("",) * n
    turning = any(not cell.is_constant for cell in columns["theta"])
    letters, signs, unknown = [], [], {}
    for i in range(n):
        theta, d = columns["theta"][i], columns["d"][i]
        said = kinds[i] or by_number(columns, i)
        slides = said == "P" or (
            not said
            and theta.is_constant
            and (
                named_alone(columns, i)
                if d.is_constant
                else d.variable in MOVES["d"]
                and (turning or d.variable in MOVES["theta"][:2] or "*" in d.text)
            )
        )
        letter = silent.get(i, "P" if slides else "R")
        cell = d if letter == "P" else theta
        letters.append(letter)
        signs.append((table.signs[i] if table.signs else 1) * (cell.sign if letter else 1))
        _require_one(cell, i, letter)
        for role in ("theta", "d", "a", "alpha", "offset"):
            held = columns[role][i] if columns.get(role) else None
            if held is not None and held is not cell and not held.is_constant:
                unknown.setdefault(held.letters[0][0], (i + 1, role))
    if unknown:
        names = ("theta", "d", "a", "alpha")
        require_one_column(list(zip(*(columns[role] for role in names))), names)
        raise ValueError(_ask(unknown))
    return letters, signs


def require_one_column(rows, names=None):
    """Angles that are variables stand in one column.

    Parameters
    ----------
    rows : list of tuple of Cell
    names : tuple of str, optional
        What the columns are called; left out, they are counted.

    Raises
    ------
    ValueError
        All rows but one have theirs in the same column.
    """
    at = [[k for k, cell in enumerate(row) if cell.variable in ("theta", "q")] for row in rows]
    places = [ks[0] for ks in at if len(ks) == 1]
    usual = max(places, key=places.count, default=None)
    odd = [i for i, ks in enumerate(at) if len(ks) == 1 and ks[0] != usual]
    if len(odd) != 1 or len(places) < 3 or not rows[odd[0]][usual].is_constant:
        return
    if names and names[at[odd[0]][0]] == "d":
        return  # a joint that slides
    of = [names[k] if names else f"number {k + 1}" for k in (usual, at[odd[0]][0])]
    raise ValueError(
        f"recognise_table: row {odd[0] + 1}: expected the joint variable in column {of[0]}, as in"
        f" the other rows, found {rows[odd[0]][at[odd[0]][0]].text!r} in column {of[1]}; about"
        " which axis does this joint turn? Write its variable into the column of theta, or give the"
        " joint axes as an axis sheet"
    )


def require_values(table):
    """Every letter that is no joint's variable has a value.

    Raises
    ------
    ValueError
        Some have none.
    """
    unknown: dict = {}
    for i, row in enumerate(table.rows, 1):
        for k, cell in enumerate(row, 1):
            if not cell.is_constant and cell.variable not in ("theta", "q", "?"):
                unknown.setdefault(cell.letters[0][0], (i, k))
    if unknown:
        raise ValueError(_ask(unknown))


def named_alone(columns, i):
    """Whether the d of a row is the one length of the table that has a name and no number, beside
    angles that are variables: it may be where a sliding joint stands, or a constant.
    """
    others = [
        cell for role in ("d", "a") for k, cell in enumerate(columns[role]) if (role, k) != ("d", i)
    ]
    turning = any(not cell.is_constant for cell in columns["theta"])
    named = re.fullmatch(r"d_?\d+", columns["d"][i].text.strip())
    return bool(named and turning) and not any(re.search(r"[A-Za-z]", one.text) for one in others)


def rows_of_d(table, columns):
    """The columns d that are meant where the header counts d from the link before and theta from
    this one, as (whose they are, Cells): of its "own" row, or of the row "above".

    Raises
    ------
    ValueError
        Letters stand in d, of which none says its row; or the first row has more than a length.
    """
    lengths = columns["d"]
    letters = [(i, cell.letters[0][0]) for i, cell in enumerate(lengths, 1) if cell.letters]
    own = letters and all(re.search(rf"(?<!\d){i}$", name) for i, name in letters)
    if not table.behind or own or len(lengths) < 2:
        return [("own", lengths)]
    first, second = lengths[:2]
    moved = (
        any(columns[role][0].value for role in ("a", "alpha")) and table.convention != "standard"
    )
    if letters or (first.value and (moved or (second.value and first.unit != second.unit))):
        raise ValueError(
            "recognise_table: the header counts d from the link before, i-1, and theta from this"
            " one; does each d belong to its own row or to the row above? Write d(i), each in the"
            " row of its joint"
        )
    # d(0) lies along the axis of joint 1, as d(1) does
    both = replace(first if first.value else second, value=first.value + second.value)
    return [("own", lengths), ("above", [both, *lengths[2:], Cell(0.0)])]


def by_number(columns, i):
    """ "P" or "R" as a column sigma has it, "" without one."""
    if "sigma" not in columns:
        return ""
    return "P" if columns["sigma"][i].value else "R"


def _require_one(cell, i, letter):
    if not cell.letters or not letter:
        return
    if len(cell.letters) > 1:
        names = " and ".join(name for name, _ in cell.letters)
        raise ValueError(
            f"recognise_table: row {i + 1}: expected one joint variable, found {names} in"
            f" {cell.text!r}; are the joints coupled? Give the value of the letter that is"
            " constant"
        )
    factor = abs(cell.letters[0][1])
    if not any(math.isclose(factor, one, rel_tol=1e-3) for one in FACTORS[letter]):
        raise ValueError(
            f"recognise_table: row {i + 1}: expected the joint variable once, found {cell.text!r};"
            " write it as q, or -q"
        )


def _ask(unknown):
    """The question about letters that have no value."""
    names = ", ".join(list(unknown)[:12])
    row, role = next(iter(unknown.values()))
    first = next(iter(unknown))
    have = "have" if len(unknown) > 1 else "has"
    return (
        f"recognise_table: {names} {have} no value in this text (the first in row {row}, column"
        f" {role}); what is it? Give it beside the table, as {first} = 0.1, or with values={{"
        f"{first!r}: 0.1}}"
    )
