"""Columns that a MATLAB program turns round, or joins to its rows: ``rows = fliplr(rows)`` and
``rows = [rows, [0 0 1]']``.
"""

import re

from .brackets import cells_in

__all__ = ["with_columns"]

STATEMENT = re.compile(
    r"^[ \t]*(?P<name>\w+)[ \t]*=[ \t]*(?:fliplr\([ \t]*(?P=name)[ \t]*\)"
    r"|\[[ \t]*(?P=name)[ \t,]+\[(?P<column>[^\[\]\n]+)\](?P<turned>'?)[ \t]*\])[ \t]*;?[ \t]*$",
    re.MULTILINE,
)
ROWS = r"^[ \t]*{0}[ \t]*=[ \t]*\[((?:[^\[\]]|\[[^\[\]]*\])*)\]"
IN_BRACKETS, PLAIN = re.compile(r"(?<=\[)[^\[\]\n]+(?=\])"), re.compile(r"[^;\n\[\]]*\w[^;\n\[\]]*")


def with_columns(code):
    """The code with the rows as they are after such statements, and without these.

    Examples
    --------
    >>> with_columns("T = [0 1; 2 3];\\nT = fliplr(T);\\nT = [T, [4 5]'];")
    'T = [1 0 4; 3 2 5];\\n\\n'
    """
    while found := STATEMENT.search(code):
        made = re.search(ROWS.format(found["name"]), code[: found.start()], re.MULTILINE)
        rows = _changed(made[1], found) if made else None
        if rows is None:
            return code
        head = code[: made.start(1)] + rows + code[made.end(1) : found.start()]
        code = head + code[found.end() :]
    return code


def _changed(inside, statement):
    """The rows in the brackets after one statement; None where it does not fit them."""
    pattern = IN_BRACKETS if "[" in inside else PLAIN
    rows = [cells_in(row) for row in pattern.findall(inside)]
    if not rows or len({len(row) for row in rows}) > 1:
        return None
    if statement["column"]:
        upright = bool(statement["turned"]) != (";" in statement["column"])
        column = [cell for part in statement["column"].split(";") for cell in cells_in(part)]
        if len(column) != len(rows) or not upright:
            return None
        rows = [[*row, cell] for row, cell in zip(rows, column)]
    else:
        rows = [row[::-1] for row in rows]
    left = iter(rows)
    return pattern.sub(lambda row: _as_before(row[0], next(left)), inside)


def _as_before(text, cells):
    """The cells with the space before the text."""
    return text[: len(text) - len(text.lstrip())] + " ".join(cells)
