"""The text of a notebook's cell, read and changed: what a name is set to there, what is called, and
the dots of an answer, in whose place a choice is written.
"""

import ast
from typing import Any

__all__ = ["calls", "set_to", "tree_of", "written"]

DIGITS = 6  # of a length in metres or a direction; hands are told to be nearer than 2 mm and 0.6°


def written(text: str, name: str, chosen: Any) -> str | None:
    """The text of a cell with a choice in place of the dots that ``name`` is set to; None where no
    dots stand there.

    Examples
    --------
    >>> written("# replace the dots\\nwhy = ...", "why", "c")
    '# replace the dots\\nwhy = "c"'
    >>> written('why = "a"', "why", "c") is None
    True
    >>> written("rows = [*first, [..., [0, 1], ...]]", "rows", [[1, 2, 3], [[1, 0], 5, ...]])
    'rows = [*first, [[1, 0], [0, 1], ...]]'
    """
    try:
        value = set_to(ast.parse(text), name)
    except SyntaxError:
        return None
    edits = [] if value is None else list(_edits(value, chosen))
    if not edits:
        return None
    data = text.encode()
    starts = [0]
    for line in data.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    for node, new in sorted(edits, key=lambda edit: (-edit[0].lineno, -edit[0].col_offset)):
        begin = starts[node.lineno - 1] + node.col_offset
        end = starts[node.end_lineno - 1] + node.end_col_offset
        data = data[:begin] + new.encode() + data[end:]
    return data.decode()


def _edits(node, chosen):
    """(node, new text) for all dots of a node that a choice has something for."""
    if chosen is Ellipsis:
        return
    dots = isinstance(node, ast.Constant) and node.value is Ellipsis
    entries = node.elts if isinstance(node, ast.List) else []
    if dots or (entries and isinstance(chosen, str) and all(map(_is_dots, entries))):
        yield node, _literal(chosen)
    elif entries and isinstance(chosen, list):
        own = [entry for entry in entries if not isinstance(entry, ast.Starred)]
        for entry, part in zip(reversed(own), reversed(chosen)):  # what is starred stands in front
            yield from _edits(entry, part)


def _is_dots(node):
    return isinstance(node, ast.Constant) and node.value is Ellipsis


def _literal(value):
    if value is Ellipsis:
        return "..."
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, list):
        return f"[{', '.join(map(_literal, value))}]"
    return f"{round(float(value), DIGITS) + 0.0:.{DIGITS}g}"


def set_to(tree: ast.Module, name: str) -> ast.expr | None:
    """The value that a name is set to at the top of a cell, where that happens once."""
    found = [
        statement.value
        for statement in tree.body
        if isinstance(statement, ast.Assign)
        and [getattr(target, "id", "") for target in statement.targets] == [name]
    ]
    return found[0] if len(found) == 1 else None


def calls(tree: ast.Module, function: str) -> list[ast.Call]:
    """The calls of a function by its plain name."""
    return [
        node
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == function
    ]


def tree_of(text: str) -> ast.Module:
    """The syntax tree of a cell; an empty one where it is no Python."""
    try:
        return ast.parse(text)
    except SyntaxError:
        return ast.Module([], [])
