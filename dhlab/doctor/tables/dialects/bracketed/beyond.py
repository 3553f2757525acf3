"""What stands in rows between brackets beside their four numbers: names, joint types, sigma, an
offset, limits.
"""

import itertools
import re

from ...evidence.orders import every_column_in
from ...language.expressions import Value
from ...language.roles import role_of
from ...language.words import KINDS

__all__ = ["fitting", "without_words"]

TYPES = ("R", "P", "REVOLUTE", "PRISMATIC")
VARIABLE = re.compile(r"(?:q|th|theta|d)_?\d*\*?|[-+.\d].*|.*\bpi\b.*")


def fitting(grid, order, source):
    """(roles of all columns, None where nothing says them; the rows without what is left out; notes
    of that), where four of the columns have an order.
    """
    width, words = len(grid[0][1]), _words_in(grid)
    if named := every_column_in(source, width) if width > 4 else None:
        return named, grid, ()
    if not order:
        return None, grid, ()
    if words and width - len(words) == 4:
        left_over = iter(order)
        return tuple(words.get(k) or next(left_over) for k in range(width)), grid, ()
    if width > 6:  # limits and the like stand behind
        return _wide(grid, order, words, source)
    if width > 4:
        return _with_more(order, [row for _, row in grid], source), grid, ()
    return order if width == 4 else None, grid, ()


def without_words(grid):
    """Rows of four numbers, and the names and joint types that stand among these: of columns that
    nothing names, words in quotation marks are none, unless they are joints' variables.
    """
    words, columns = _words_in(grid), list(zip(*(cells for _, cells in grid)))
    said = {
        {"label": "labels", "type": "kinds"}[word]: [str(cell).strip("'\" ") for cell in columns[k]]
        for k, word in words.items()
    }
    variables = all(VARIABLE.fullmatch(word) for word in said.get("labels", ("q1",)))
    if len(columns) - len(words) != 4 or len(said) < len(words) or ("labels" in said and variables):
        return grid, {}
    if "kinds" in said:
        said["kinds"] = [KINDS[word.lower()] for word in said["kinds"]]
    rows = [
        (where, [cell for k, cell in enumerate(cells) if k not in words]) for where, cells in grid
    ]
    return rows, {name: tuple(values) for name, values in said.items()}


def _words_in(grid):
    """{column: "label" or "type"} of the columns that hold words in quotation marks."""
    found = {}
    for k, column in enumerate(zip(*(cells for _, cells in grid))):
        if all(str(cell)[:1] in "'\"" for cell in column):
            named = {str(cell).strip("'\" ").lower() for cell in column} <= set(KINDS)
            found[k] = "type" if named else "label"
    return found


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


def _wide(grid, order, words, source):
    """(order, rows, notes) of wide rows without the columns that nothing names, but for types."""
    fits = _with_named(order, source)
    kept = [k for k, word in words.items() if word == "type" and k >= len(fits)][:1]
    rows = [(where, [*row[: len(fits)], *(row[k] for k in kept)]) for where, row in grid]
    if kept:
        left = f"the other columns behind {fits[-1]} than the joints' types were left out"
        return (*fits, "type"), rows, (left,)
    return fits, rows, (f"the columns behind {fits[-1]} were left out",)


def _with_named(order, source):
    """The order with sigma, offset and type behind it, where a comment names them there."""
    for _, text in source.comments:
        roles = [role_of(word)[0] for word in re.findall(r"[A-Za-z]\w*", text)]
        for at in range(len(roles) - 4):
            if tuple(roles[at : at + 4]) == tuple(order):
                more = itertools.takewhile(
                    ("sigma", "offset", "type").__contains__, roles[at + 4 :]
                )
                return (*order, *more)
    return order
