"""Tables as text: rows in lines, cells between pipes, tabs, commas, semicolons or spaces, with or
without headings, labels and joint types; also rows of numbers.
"""

import math
import re

import numpy as np

from ...cells import FOOTNOTE, Cell, cell_or_none, plain, read_cell
from ...language.roles import ROLES, unit_in
from ...language.words import KINDS, RANGE, ROOM, SIGNS, STILL, TOTAL, TURNED
from ...meaning.beside import DASH, require_no_fifth, slid, with_theta
from ...meaning.columns import IMPLIED
from ...meaning.indexed import with_index
from ...meaning.joint_types import kinds_by_number, kinds_by_star
from ...meaning.twofold import say_one_thing
from ...meaning.unnamed import explained
from ...pasted import Pasted
from .heading import header, units_of
from .widths import even

__all__ = ["NoRows", "from_grid"]

KEPT = (*ROLES, "offset", "sigma", "r")
EMPTY = ("-", "--", "---", "/", "n/a", "n.a.", "none")  # a dash, or what stands for one
JOINT = re.compile(r"joint|gelenk|articula|关节|關節|関節", re.IGNORECASE)
OWN_D = re.compile(r"(?<!\w)d_?[({]?i[)}]?(?!\w|\s?-\s?1)")  # d(i), where the heading has d(i-1)


class NoRows(ValueError):
    """No line of the text is a row."""


def from_grid(grid, source=None, roles=None, why="", units=None, form=""):
    """The Pasted table in (where, cells) of each line.

    Parameters
    ----------
    grid : list of (str, list)
        Where a line stands, and its cells.
    source : Source, optional
        What the text around it says.
    roles, why, units : optional
        The order of the columns where something else than a heading says it.
    """
    said, because, rows, heads, names, notes = None, "", [], units or {}, [], ()
    first = ""
    lines: list = []
    empty: list = []
    taken = behind = False
    for where, cells in grid:
        lines += [int(word) for word in where.split() if "line" in where and word.isdigit()]
        head = header(cells) if not rows else None
        if head:
            roles, heads, said, behind = head
            if roles[:2] == ("label", "label") and all(
                len(row) < len(roles) for place, row in grid if place != where
            ):  # two words for one column
                roles, cells = roles[1:], cells[1:]
            roles, notes = _with_directions(roles, grid)
            below = [other for place, other in grid if place != where and not units_of(other)]
            named, (roles, beside) = roles, explained(roles, cells, below)
            notes, taken = (*notes, *beside), roles != named
            roles = _once(roles, cells, below)
            empty = _left_empty(roles, below)
            if behind and source and OWN_D.search(source.text):
                notes, behind = (
                    (*notes, "d is that of its own row, as the text defines d(i)"),
                    False,
                )
            names = [plain(str(cell)).strip("_ij$* ") for cell in cells]
            why, first = "as the header says", str(cells[0]).strip(" *`")
            because = "by the index i-1 in the header" if said == "craig" else ""
            continue
        below = units_of(cells) if roles and not rows else None
        if below:
            named = zip(reversed(roles), reversed(below))  # empty first cells may be lost
            heads = {**{role: unit for role, unit in named if unit and role}, **heads}
            continue
        if (not rows and _is_title(cells)) or (rows and TOTAL.fullmatch(plain(str(cells[0])))):
            continue
        cells = ["-" if k in empty and not str(c).strip() else c for k, c in enumerate(cells)]
        rows.append(_row(_counted(cells, roles, first), roles, where, source))
        require_no_fifth(names, cells, where)
    if not rows:
        raise NoRows(
            "recognise_table: expected at least one row of four numbers, found none; paste the"
            " table with its rows, one per line"
        )
    cells, labels, kinds, signs = zip(*rows)
    kinds, numbered = kinds_by_number(kinds, source.text if source else "")
    notes = (*notes, *numbered)
    kept = roles and tuple(role for role in roles if role in KEPT)
    kinds, starred = kinds_by_star(kinds, cells, kept or ())
    notes = (*notes, *starred)
    if any(cell is DASH for row in cells for cell in row):
        notes = (
            *notes,
            "a dash, n/a or an empty cell of a length is taken for 0"
            if empty
            else "a dash, or n/a, is taken for 0",
        )
    if any(cell is IMPLIED for row in cells for cell in row):
        notes = (*notes, "an empty cell of theta, or a range, is taken for the joint's variable")
    if any(FOOTNOTE.search(cell.text) for row in cells for cell in row):
        notes = (*notes, "marks of footnotes were left out: look what the footnotes say")
    if kept:
        cells = tuple(slid(row, kept) for row in cells) if taken else cells
        unknown = _has_numbers(roles, [row for _, row in grid if len(row) == len(roles)])
        cells, kept, beside = (cells, kept, ()) if unknown else with_theta(cells, kept)
        notes = (*notes, *beside)
    table = Pasted(
        cells, kept or None, why, heads, said if said != "i" else None, because,
        labels, kinds, signs, form=form, notes=notes,
        lines=(min(lines), max(lines)) if lines else (), behind=behind,
    )  # fmt: skip
    table = even(table)
    craig = source is not None and source.convention == "craig"
    return with_index(table) if said == "i" and not craig else table


def _has_numbers(roles, rows):
    """Whether a column of which nobody knows what it is holds numbers."""
    unknown = [k for k, role in enumerate(roles) if role is None]
    cells = [[_try(row[k]) for row in rows] for k in unknown]
    return any(2 * sum(cell is not None for cell in column) > len(column) for column in cells)


def _left_empty(roles, rows):
    """The columns of lengths in which an empty cell is 0: numbers stand in others, and no 0."""
    found = []
    for k, role in enumerate(roles):
        column = [
            _try(str(row[k])) for row in rows if len(row) == len(roles) and str(row[k]).strip()
        ]
        numbers = [cell for cell in column if cell is not None]
        zeros = any(cell.is_constant and not cell.value for cell in numbers)
        if role in ("d", "a", "r") and numbers and len(numbers) == len(column) and not zeros:
            found.append(k)
    return found


def _once(roles, heading, rows):
    """The roles, without a second column of one name that says the same in another unit.

    Raises
    ------
    ValueError
        It says something else: nobody can say which is meant.
    """
    for role in (*ROLES, "offset"):
        at = [k for k, one in enumerate(roles) if one == role]
        if len(at) < 2:
            continue
        names = [str(heading[k]).strip() for k in at]
        cells = [[_try(str(row[k])) for row in rows if len(row) == len(roles)] for k in at]
        if say_one_thing(cells, [unit_in(plain(name)) for name in names]):
            roles = tuple("room" if k in at[1:] else one for k, one in enumerate(roles))
        elif role in ROLES:
            raise ValueError(
                f"recognise_table: expected one column {role}, found {' and '.join(names)[:60]};"
                " which one is it? Leave the other out"
            )
    return roles


def _with_directions(roles, grid):
    """The roles and notes where a column of directions stands: whether they are senses of joints,
    or where the axes point in the room, which the angles of the table say already.
    """
    named = next((role for role in roles if role in ("direction", "sign")), "")
    if not named:
        return roles, ()
    k = roles.index(named) - len(roles)  # from the end: labels may hold spaces
    words = [plain(str(cells[k])) for _, cells in grid if len(cells) >= len(roles)]
    room = [word for word in words if ROOM.fullmatch(word)]
    if any("z" not in word for word in room):
        note = "where the axes point in the room was left out: the angles of the rows say it"
        return tuple("room" if role == named else role for role in roles), (note,)
    if any(SIGNS.get(word) == -1 for word in words):
        note = "the column of directions is taken for the sense in which each joint counts"
        return roles, (note,)
    return roles, ()


def _counted(cells, roles, first):
    """The cells with ``joint 6`` for the 6 below the heading Joint, where a remark follows it."""
    number = re.fullmatch(r"\d", str(cells[0]).strip(" *`"))
    joints = roles and roles[0] == "label" and roles.count("label") > 1 and JOINT.match(first)
    return [f"joint {number[0]}", *cells[1:]] if joints and number else cells


def _is_title(cells):
    """A line above the table: at most half of its words could be cells."""
    return 2 * sum(
        isinstance(cell, (int, float, np.number)) or _try(cell) is not None for cell in cells
    ) <= len(cells)


def _try(cell):
    return cell_or_none(str(cell))


def _row(cells, roles, where, source):
    """(Cells, label, kind, sign) of one line."""
    label, kind, sign, kept = "", "", 1, []
    if roles is not None and len(cells) == len(roles) + 1 and _is_remark(cells[-1]):
        cells = cells[:-1]
    if roles is not None and len(cells) == len(roles) + 1 and "label" not in roles:
        label, cells = plain(str(cells[0])), cells[1:]
        label = "" if label.isdigit() else label  # the index of a printed data frame
    if roles is not None and roles[0] == "label" and len(cells) > len(roles):
        spare = len(cells) - len(roles)
        cells = [" ".join(map(str, cells[: spare + 1])), *cells[spare + 1 :]]
    if roles is not None and len(cells) == len(roles) - 1 and roles[-1] not in KEPT:
        cells = [*cells, ""]  # an empty last cell is often lost
    if roles is not None and len(cells) != len(roles):
        raise ValueError(
            f"recognise_table: {where}: expected as many cells as the header has, {len(roles)},"
            f" found {len(cells)}; fill in what is missing"
        )
    for k, cell in enumerate(cells):
        role = roles[k] if roles is not None else None
        word = plain(cell).strip("*`'\" ") if isinstance(cell, str) else ""
        if role == "label":
            numbered = re.fullmatch(r"(?:j|q|joint)[ _]?\d", label)
            label = f"{label} {word}" if numbered and word else word or str(cell)
            told = re.search(r"\((r|p)\*?\)$", label)  # 3 (P)
            kind = kind or (told[1].upper() if told else "")
        elif role == "type" or (
            role is None
            and word in KINDS
            and (k == 0 or len(word) > 1 or (word in "rp" and k == len(cells) - 1))
        ):
            kind = KINDS.get(
                word.split(" ")[0], KINDS.get(word[:1], word if word.isdigit() else "")
            )
        elif role in ("sign", "direction"):
            sign = _sign(word, where, SIGNS)
        elif role == "turned":
            sign = _sign(word, where, {**TURNED, **SIGNS, "1": -1})
        elif role == "theta" and word in STILL:
            kept.append(Cell(0.0, text=word))
            kind = "fixed"
        elif role == "theta" and isinstance(cell, str) and (not word or _is_range(word)):
            kept.append(IMPLIED)
        elif role in KEPT:
            kept.append(_cell(cell, where, k, source))
        elif roles is None:
            if k in (0, len(cells) - 1) and isinstance(cell, str) and _try(cell) is None:
                label = word
            else:
                kept.append(_cell(cell, where, k, source))
    return tuple(kept), label, kind, sign


def _is_range(word):
    """Whether a cell holds the range of a joint's values, perhaps with a word behind it."""
    return bool(RANGE.fullmatch(re.sub(r"(?<=\S)\s*\([^()\d]*\)$", "", word)))


def _is_remark(cell):
    """Words behind the last column."""
    return (
        isinstance(cell, str) and _try(cell) is None and len(re.findall(r"[^\W\d_]{2,}", cell)) > 1
    )


def _sign(word, where, known):
    if word not in known:
        raise ValueError(
            f"recognise_table: {where}: expected + or - in the column of directions, found"
            f" {word[:30]!r}; write which way the joint counts"
        )
    return known[word]


def _cell(cell, where, k, source):
    if isinstance(cell, (int, float, np.number)) and not isinstance(cell, bool):
        if not math.isfinite(cell):
            raise ValueError(
                f"recognise_table: {where}, cell {k + 1}: expected a finite number, found {cell};"
                " look at where it was computed"
            )
        return Cell(float(cell))
    if isinstance(cell, str) and plain(cell).strip("*` ").lower() in EMPTY:
        return DASH
    if isinstance(cell, str) and plain(cell) in ("", "nan", "?"):
        raise ValueError(
            f"recognise_table: {where}, cell {k + 1}: expected a number, found"
            f" {cell.strip()[:20] or 'an empty cell'}; which number stands there? Write 0 where 0"
            " is meant"
        )
    try:
        return read_cell(str(cell), source.known if source else None, loosely=True)
    except ValueError as error:
        raise ValueError(f"recognise_table: {where}, cell {k + 1}: {error}") from None
