"""Lines whose cells stand between spaces: where each ends, and rows below names of columns wherever
they stand in the line.
"""

import re

from ...cells import cell_or_none
from ...evidence.orders import names_in_a_row
from ...language.brackets import cells_in

__all__ = ["bare_row", "is_cell", "require_whole_row", "spaced_cells", "under_names", "with_fifth"]

PHRASE = re.compile(  # the gap in link length, joint angle
    r"(?i)(?<=\blink)\s+(?=(?:length|offset|twist|angle|distance)\b)"
    r"|(?<=\bjoint)\s+(?=(?:angle|offset|distance)\b)|(?<=\btwist)\s+(?=angle\b)"
)
# 0.1091 -0.3923 are two numbers, however narrow the gap
SIGNED = re.compile(
    r"(?<![\w.+*/-])([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?) (?=[-+][\d.])", re.IGNORECASE
)
INDEXED = re.compile(r"(?<!\w)(alpha|theta|[adrq]) (?=[ijkn](?:-1)?(?:\s|$))", re.IGNORECASE)
# a row behind its name, without brackets: 1: q1, 0.2, 0, 90 and link1 = 0 200 0 90
BARE_ROW = re.compile(
    r"\s*[-*]?\s*((?:(?:link|joint|axis|row|achse|[jl])[ _]?)?\d+)(?:\s*[:=)]|\.(?=\s))\s*(\S.*)",
    re.I,
)
LABEL = re.compile(r"^\s*(?:[A-Za-z][A-Za-z_]*\s*\d*|\d+)\s*[.:)]?\s+")  # Joint 1:


def spaced_cells(line, wide):
    """Cells separated by spaces; "q2 - 90", "pi / 2", "90 deg" and "i - 1" are one cell each."""
    line = _joined(line)
    if wide:
        line = SIGNED.sub(r"\1  ", line) if "  " in line.strip() else line
        return [cell for cell in re.split(r"\s{2,}", line.strip()) if cell]
    return cells_in(line.replace(",", " ") if not re.search(r"\d,\d", line) else line)


def _joined(line):
    """A line in which numbers and their units, and the words of one name, have no gap between
    them.
    """
    line = re.sub(r"(?<=[ij])\s*-\s*(?=1\b)", "-", line)
    if not re.search(r"\d", line.replace("-1", "")):
        line = INDEXED.sub(r"\1_", PHRASE.sub("_", line))
    if counted := re.match(r"\s*(\d+)\s", line):  # 2 0 0.3 0 theta 2
        line = re.sub(rf"\b(theta|q|d) (?={counted[1]}(?:\s|$))", r"\1", line)
    line = re.sub(r"(?<=[\d.])\s+(deg|degrees|°|mm|cm|rad|m)(?![\w/*^])", r"\1", line)
    line = re.sub(r"\s+(?=[\[(]\s*(deg|rad|mm|cm|m|°|in)\w*\s*[\])])", "", line)
    return line


def is_cell(cell):
    """Whether a cell is a number, a dash, or a letter with its index."""
    if cell.strip("*` ") == "-":
        return True
    found = cell_or_none(cell)
    if found is None:
        return False
    return found.is_constant or any(re.search(r"[\d\]]", name) for name, _ in found.letters)


def bare_row(line):
    """The name and the numbers of a row without brackets; None of another line."""
    found = BARE_ROW.fullmatch(line)
    cells = cells_in(found[2].replace(",", " ")) if found else []
    return found if len(cells) == 4 and all(map(is_cell, cells)) else None


def with_fifth(order, grid):
    """The order of the columns with the labels before it, or sigma behind it, of rows of five.

    Examples
    --------
    >>> with_fifth(("theta", "d", "a", "alpha"), [("line 1", ["0", "1", "0", "0", "0"])])[-1]
    'sigma'
    """
    if len(grid[0][1]) == len(order):
        return order
    first = [cell_or_none(str(cells[0])) for _, cells in grid]
    labels = any(cell is None or cell.letters for cell in first)
    counted = [cell.value for cell in first if cell] in (
        [*range(1, len(grid) + 1)],
        [*range(len(grid))],
    )
    kinds = {str(cells[-1]).strip() for _, cells in grid} <= {"0", "1"}
    return (
        (*order, "sigma")
        if kinds and not labels and (not counted or len(grid) == 1)
        else ("label", *order)
    )


def require_whole_row(grid, last):
    """The text does not end with the beginning of one more row."""
    (where, cells), (below, rest) = grid[last], grid[-1]
    follows = last == len(grid) - 2 and int(below.split()[1]) == int(where.split()[1]) + 1
    if follows and 0 < len(rest) < len(cells) and all(map(is_cell, (rest[0], *rest[1:-1]))):
        raise ValueError(
            f"recognise_table: {below}: expected as many cells as in the rows before, {len(cells)},"
            f" found {' '.join(rest)[:40]!r} at the end of the text; what else stands in this row?"
            " Paste it to its end"
        )


def under_names(texts):
    """(grid, roles, units) of rows below a line in which four names of columns follow each other,
    whatever stands before and behind them; None without them.
    """
    for k, line in enumerate(texts):
        named = names_in_a_row(line)
        behind = line[named[2] :] if named else ""
        if not named or re.search(r"off|sign|type|sigma|joint", behind, re.IGNORECASE):
            continue
        rows = []
        for at, below in enumerate(_with_fractions(texts[k + 1 :]), k + 2):
            cells = cells_in(_joined(LABEL.sub("", below)))
            if len(cells) >= 4 and all(map(is_cell, cells[:4])):
                rows.append((f"line {at}", cells))
            elif rows and below.strip():
                break
        if len(rows) > 1:
            first = int(_are_counted(rows))
            return [(at, cells[first : first + 4]) for at, cells in rows], named[0], named[1]
    return None


def _are_counted(rows):
    """Whether the rows have their numbers before the four cells, 1,q1,0.2,0,90."""
    first = [cells[0] for _, cells in rows if len(cells) > 4]
    return first in ([*map(str, range(n, n + len(rows)))] for n in (0, 1))


def _with_fractions(texts):
    """Lines of a page on which a fraction takes two lines of its own behind its row: joined."""
    text = re.sub(
        r"\n[ \t]*(-?[ \t]*\d*pi)[ \t]*\n[ \t]*(\d)[ \t]*(?=\n|$)", r" \1/\2", "\n".join(texts)
    )
    return re.sub(r"(?<=-)[ \t]+(?=pi/\d$)", "", text, flags=re.MULTILINE).split("\n")
