"""Which lines of a text are the table, and where their cells end."""

import re
from dataclasses import replace
from itertools import pairwise

from ...cells import cell_or_none, read_cell
from ...evidence.orders import order_of_names
from ...evidence.poses import holds_joint_values
from ...language.brackets import cells_in
from ...language.roles import ROLES, role_of
from .copied import MOST_WORDS, named_one_a_line, one_cell_a_line
from .grid import NoRows, from_grid
from .heading import header, units_of
from .spaced import bare_row, is_cell, require_whole_row, spaced_cells, under_names, with_fifth
from .splitting import splitter

__all__ = ["TwoTables", "read"]

RULE = re.compile(r"[-|:+=\s().;_*#~]*")  # a line that only separates
# a row with its name before it: Joint 1: (0, 0.1, 0, 90), J2 = [0, 0, 0.4, 0]
ROW = re.compile(
    r"\s*[-*]?\s*([A-Za-z][\w ]{0,20}?)\s*[:=-]?\s*"
    r"[(\[{]((?:[^()\[\]{}]|\([^()\[\]{}]*\))*)[)\]}]\s*[,;]?\s*"
)
TOLD = re.compile(  # - d1 (link 0): 296.5 mm
    r"\s*[-*•]?\s*[adlhr]_?\d+\s*(?:\([^()]*\)\s*)?[:=]\s*[-+]?[\d.]+\s*(?:mm|cm|m)?[.,;]?\s*", re.I
)
LIST = re.compile(r"\s*(\w+)\s*=[^=\[{(]*[\[{(]")
MOST_LINES = 60


class TwoTables(ValueError):
    """Two tables with a heading each; ``last`` is the last line of the first, ``parts`` the text up
    to it and from there.
    """

    def __init__(self, said, last):
        super().__init__(said)
        self.last, self.parts = last, ()


def read(source, nominal=None):
    """The Pasted table in the lines of a text.

    Raises
    ------
    ValueError
        One sentence with the line: expected, found, what to do.
    """
    code = source.code
    if re.search(r"\d", re.sub(r"[a-z]\w*", "", code)) is None:
        code = source.text
    try:
        return _from_lines(_broken(code).split("\n"), source)
    except ValueError as error:
        if isinstance(error, TwoTables):
            lines = source.text.split("\n")
            error.parts = ("\n".join(lines[: error.last]), "\n".join(lines[error.last :]))
        table = _in_comments(source)
        if table is not None:
            return table
        below = under_names(source.lines) if isinstance(error, NoRows) else None
        if below is None:
            raise error
        grid, roles, units = below
        return from_grid(grid, source, roles, "as the line above them says", units)


def _in_comments(source):
    """The Pasted table that stands in the comments of a program, with its heading; None without
    one.
    """
    lines = [""] * (source.text.count("\n") + 1)
    for k, comment in source.comments:
        if k <= len(lines):
            lines[k - 1] = comment
    if not any(
        header(spaced_cells(line, False)) or header(line.split("|")) for line in lines if line
    ):
        return None
    try:
        table = _from_lines(lines, source)
    except ValueError:
        return None
    return replace(table, notes=(*table.notes, "the table was read from the comments"))


def _from_lines(texts, source):
    lines = [
        (k, _listed(_without_brackets(line)))
        for k, line in enumerate(texts, 1)
        if line.strip()
        and not RULE.fullmatch(line)
        and (not _assignment(line) or bare_row(line))
        and not ((named := LIST.match(line)) and _is_column(named[1], source))
    ]
    split, mark = splitter([line for _, line in lines])
    grid = [(f"line {k}", split(line)) for k, line in lines if mark is None or mark in line]
    grid = _with_heading(_upright(grid), source, split)
    whole = _is_whole(grid)
    grid = (not whole and one_cell_a_line(grid, lines)) or (
        named_one_a_line(lines) or _table_only(grid)
    )
    if len(grid) > MOST_LINES:
        raise ValueError(
            f"recognise_table: expected at most {MOST_LINES} lines, found {len(grid)}; paste the"
            " rows only"
        )
    order = None if any(header(cells) for _, cells in grid) else source.order
    grid = _by_fours(grid) if order else grid
    widths = {len(cells) for _, cells in grid}
    if order and widths in ({4}, {5}):
        return from_grid(grid, source, with_fifth(order[0], grid), order[2], order[1])
    return from_grid(grid, source)


def _is_whole(grid):
    """Whether two rows of numbers, as wide as the heading, follow each other."""
    widths = [len(cells) for _, cells in grid if header(cells)]
    full = [
        len(cells) in widths and all(cell_or_none(str(cell)) for cell in cells) for _, cells in grid
    ]
    return any(a and b for a, b in pairwise(full))


def _by_fours(grid):
    """A line of all numbers, one row behind the other, with a line for each row."""
    cells = grid[0][1] if len(grid) == 1 else []
    if len(cells) < 8 or len(cells) % 4 or not all(map(is_cell, cells)):
        return grid
    return [(grid[0][0], cells[k : k + 4]) for k in range(0, len(cells), 4)]


def _listed(line):
    """``Joint 1: (θ1, 0.1, 0, 90°)`` with its cells at commas; a sentence that names the columns in
    brackets is no row.
    """
    found = ROW.fullmatch(line)
    if found and len(cells_in(found[2])) >= 4:
        return f"{found[1].strip()}, {', '.join(cells_in(found[2]))}"
    if bare := bare_row(line):
        return f"{bare[1].strip()}, {', '.join(cells_in(bare[2].replace(',', ' ')))}"
    told = re.search(r"\w\s+\(([^()]*,[^()]*)\)", line)
    return "" if told and order_of_names(told[1]) else line


def _upright(grid):
    """A table that lies on its side, a parameter in each line, stood up; others as they are."""
    named = {}
    for _, cells in grid:
        role = role_of(cells[0])[0] if cells and isinstance(cells[0], str) else None
        if role in (*ROLES, "r", "offset") and len(cells) > 2 and _holds_numbers(cells[1:]):
            named.setdefault(role, cells)
    n = {len(cells) for cells in named.values()}
    if not {"alpha", "d"} <= set(named) or len(named) < 3 or len(n) > 1:
        return grid
    return [
        ("line 1" if k == 0 else f"column {k}", list(c)) for k, c in enumerate(zip(*named.values()))
    ]


def _holds_numbers(cells):
    """Whether more of the cells can be read than not: ``alpha | twist | about x_i`` explains."""
    read = sum(cell_or_none(str(cell)) is not None for cell in cells)
    return 2 * read > len(cells)


def _with_heading(grid, source, split):
    """The grid with the heading that stands in a comment, where it has none itself."""
    if any(header(cells) for _, cells in grid):
        return grid
    widths = {len(cells) for _, cells in grid if _is_row(cells, 0)}
    for line, comment in source.comments:
        cells = split(comment.strip())
        if header(cells) and widths & {len(cells), len(cells) + 1}:
            return [(f"line {line}", cells), *(row for row in grid if int(row[0][5:]) > line)]
    return grid


def _broken(text):
    """A matrix on one line is broken where its rows end."""
    lines = [line for line in text.split("\n") if line.strip()]
    if len(lines) == 1 and lines[0].count(";") >= 1 and not re.search(r";\s*[\w.]+\s*;", text):
        return re.sub(r";|\]\s*,?\s*\[", "\n", text)
    return re.sub(r"\]\s*,\s*\[", "]\n[", text)


def _without_brackets(line):
    line = re.sub(
        r"^[\w\s().]*=\s*\[|^[\w\s().]*=\s*\w*\(\s*\[|[\[\]](?![\w°])(?<![\w°].)|^\s*\[", " ", line
    )
    line = re.sub(r"^\s*(%|#|//|[-*](?=\s+\w+\s*\|))\s*", "", line)
    return line.strip().rstrip(";,").strip()


def _is_column(name, source):
    """Whether a list of this name holds joints' values, or a column, and is no row."""
    return holds_joint_values(name, source) or role_of(name)[0] in (*ROLES, "offset")


def _assignment(line):
    """Whether the line says what one letter is."""
    return bool(TOLD.fullmatch(line)) or (
        bool(re.match(r"\s*(?:where\b.*|[A-Za-z_]\w*\s*)=\s*[^\[{|\t]*$", line)) and "|" not in line
    )


def _table_only(grid):
    """The lines of the table: its heading and its rows, without the prose around them.

    Raises
    ------
    ValueError
        Two tables, or a line within the table that is none of its rows.
    """
    heads = [k for k, (_, cells) in enumerate(grid) if header(cells)]
    width = len(grid[heads[0]][1]) if heads else 0
    rows = [
        k
        for k, (_, cells) in enumerate(grid)
        if k not in heads
        and (not heads or k > heads[0])
        and _is_row(cells, width)
        and not units_of(cells)
    ]
    for k in range(1, len(grid)):  # a row's label may be long where the row stands below others
        before, here = (int(grid[j][0].split()[1]) for j in (k - 1, k))
        long = width and len(grid[k][1]) == width and _is_row(["", *grid[k][1][1:]], width)
        if k - 1 in rows and k not in rows and long and here == before + 1:
            rows = sorted([*rows, k])
    rows = _without_what_follows(rows, grid, width) if len(heads) < 2 else rows
    if len(heads) > 1 and any(k > heads[1] for k in rows) and any(k < heads[1] for k in rows):
        raise TwoTables(
            f"recognise_table: expected one table, found two, at {grid[heads[0]][0]} and"
            f" {grid[heads[1]][0]}; paste one of them",
            int(grid[max(k for k in rows if k < heads[1])][0].split()[1]),
        )
    if len(rows) > 1 and rows[-1] > rows[-2] + 1 and _is_last_of_matrix(grid[rows[-1]][1]):
        rows.pop()
    if not rows:
        return [grid[k] for k in heads]
    require_whole_row(grid, rows[-1])
    kept = [grid[k] for k in range(heads[0] + 1, rows[0]) if units_of(grid[k][1])] if heads else []
    for k in range(rows[0], rows[-1] + 1):
        if k in rows:
            kept.append(grid[k])
        elif sum(map(is_cell, grid[k][1])) >= 2:
            raise ValueError(
                f"recognise_table: {grid[k][0]}: expected a row like the others, found"
                f" {' '.join(grid[k][1])[:60]!r}; mend it or leave it out"
            )
    return [grid[heads[0]], *kept] if heads else kept


def _without_what_follows(rows, grid, width):
    """The rows up to where two lines or more stand between, and more than between the rows before,
    or where rows of another width begin: something else begins there, unless the numbers go on.
    """
    at = [int(grid[k][0].split()[1]) for k in rows]
    first = [str(grid[k][1][0]).strip() for k in rows]
    widest = 2
    for n in range(1, len(rows)):
        gap = at[n] - at[n - 1]
        goes_on = first[n].isdigit() and first[n - 1].isdigit()
        goes_on = goes_on and int(first[n]) == int(first[n - 1]) + 1
        other = width and gap > 1 and len(grid[rows[n]][1]) < width == len(grid[rows[n - 1]][1])
        if n > 1 and (gap > widest or other) and not goes_on:
            return rows[:n]
        widest = max(widest, gap)
    return rows


def _is_last_of_matrix(cells):
    """Whether this is the row 0 0 0 1 of a link matrix that stands below the table."""
    if not all(is_cell(cell) and cell.strip("*` ") != "-" for cell in cells):
        return False
    return [read_cell(cell).value for cell in cells] == [0, 0, 0, 1]


def _is_row(cells, width):
    if cells and len(str(cells[0]).split()) > MOST_WORDS:
        return False  # a sentence with numbers in it
    good = sum(map(is_cell, cells))
    if width:
        return (len(cells) in (width, width + 1) and good >= 2) or good >= max(3, len(cells) - 1)
    return good >= 3 and 2 * good >= len(cells)
