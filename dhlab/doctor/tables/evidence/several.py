"""Several arms in one text: rows that stand in several functions, classes or lists, and names that
are given two values.
"""

import re

from ..language.assigned import ASSIGNED, joint_values
from ..language.expressions import key
from ..language.vocabulary import CONSTANTS

__all__ = ["apart", "in_parts", "require_one_value"]

# where something of its own begins: a function, a class, a case
HEAD = re.compile(
    r"^\s*(?:(?:async\s+)?def|class|function|func|fn|struct|case|namespace)\b"
    r"|^\s*(?:el)?(?:se\s*)?if\b[^\n]*(?:==|strcmp|isequal)|^\s*(?:else|otherwise)\b"
    r"|^\s*[A-Za-z_][\w:<>&*, ]*\([^;=]*\)\s*(?:const\s*)?\{?\s*$"
)
FEWEST = 2  # rows that are an arm's


def apart(numbered, code):
    """The rows, as (line, row), by the function, class or branch in which they stand: {its head:
    rows}, of those that hold two rows or more.

    Examples
    --------
    >>> list(apart([(2, "a"), (3, "b"), (5, "c"), (6, "d")], "def one():\\n\\n\\ndef two():\\n\\n"))
    ['def one():', 'def two():']
    """
    lines, parts = code.split("\n"), {}
    for line, row in numbered:
        heads = (k for k in range(min(line, len(lines)), 0, -1) if HEAD.match(lines[k - 1]))
        parts.setdefault(next(heads, 0), []).append(row)
    return {
        lines[head - 1].strip()[:30] if head else "the lines above": rows
        for head, rows in parts.items()
        if len(rows) >= FEWEST
    }


def in_parts(parts, numbers, what="rows"):
    """The rows of the first of several parts that hold the same numbers; None of fewer than two.

    Parameters
    ----------
    parts : dict of str to list
    numbers : callable
        The numbers of a row, to be compared.
    what : str

    Raises
    ------
    ValueError
        The parts are different arms.
    """
    if len(parts) < 2:
        return None
    first, *others = parts.values()
    if all([*map(numbers, rows)] == [*map(numbers, first)] for rows in others):
        return first
    names = ", ".join(repr(name) for name in list(parts)[:6])
    raise ValueError(
        f"recognise_table: expected one arm, found {what} of {len(parts)}, in {names[:160]}; which"
        " one is meant? Paste that one alone"
    )


def require_one_value(table, source):
    """No letter of the rows is given two values.

    Raises
    ------
    ValueError
        One is, with its lines.
    """
    words = {key(word) for row in table.rows for cell in row for word in _words(cell.text)}
    said: dict = {}
    for match in ASSIGNED.finditer(source.code):
        name, value = key(match[1]), source.value(match[2])
        again = re.search(rf"\b{re.escape(match[1])}\b", match[2])
        if name not in words or again or value is None or value.letters or name in CONSTANTS:
            continue
        if not joint_values({match[1]: match[2]}):
            line = source.code.count("\n", 0, match.start(1)) + 1
            said.setdefault(name, {}).setdefault(round(value.number, 9), (match, line))
    for values in said.values():
        if len(values) > 1:
            (one, at), (other, later) = list(values.values())[:2]
            raise ValueError(
                f"recognise_table: expected one value of {one[1]}, found {one[2].strip()[:20]} in"
                f" line {at} and {other[2].strip()[:20]} in line {later}; which one counts? Leave"
                " the other out"
            )


def _words(text):
    return re.findall(r"[A-Za-z_][\w.]*", text)
