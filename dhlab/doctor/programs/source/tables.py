"""Tables that are written into a program: two of their numbers exchanged, between neighbouring rows
or within one.
"""

import ast
from itertools import combinations, pairwise

from .text import Edit

__all__ = ["table_changes"]

COLUMN = 4  # numbers at most in a row; a longer list is a column
ROWS = 2  # at least, for a list to be a table


def table_changes(text):
    """Yields tuples of Edit that belong together.

    Parameters
    ----------
    text : Text
    """
    for block in text.blocks:
        for node in ast.walk(block):
            if isinstance(node, (ast.List, ast.Tuple)):
                yield from _moved(node, text)
                rows = [cells for cells in map(_cells, node.elts) if cells]
                if len(rows) >= ROWS and len({tuple(row) for row in rows}) == 1:
                    yield from _exchanged(rows, text)


def _cells(row):
    """The entries of a row by name or place, empty where it is no row."""
    if isinstance(row, ast.Dict):
        return {getattr(k, "value", None): v for k, v in zip(row.keys, row.values)}
    if isinstance(row, (ast.List, ast.Tuple)):
        return dict(enumerate(row.elts))
    if isinstance(row, ast.Call):
        named = {keyword.arg: keyword.value for keyword in row.keywords}
        return dict(enumerate(row.args)) | named
    return {}


def _exchanged(rows, text):
    for one, next_one in pairwise(rows):
        for name in one:
            yield from _swap(one[name], next_one[name], text)
    for row in rows:
        for first, second in combinations(row.values(), 2):
            yield from _swap(first, second, text)


def _moved(node, text):
    """Two numbers of a column that is written as a list of its own."""
    numbers = node.elts if len(node.elts) > COLUMN and all(map(_is_number, node.elts)) else ()
    for first, second in combinations(numbers, 2):
        yield from _swap(first, second, text)


def _is_number(node):
    if isinstance(node, ast.BinOp):
        return _is_number(node.left) or _is_number(node.right)
    if isinstance(node, ast.UnaryOp):
        return _is_number(node.operand)
    return isinstance(node, (ast.Constant, ast.Attribute))


def _swap(first, second, text):
    a, b = text.of(first), text.of(second)
    if a != b:
        yield (Edit(*text.span(first), b.encode(), 1), Edit(*text.span(second), a.encode(), 1))
