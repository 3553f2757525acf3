"""Tables that are written into a program: two of their numbers exchanged, between neighbouring rows
or within one; a number that the arm has in place of one that it has not.
"""

import ast
from itertools import combinations, pairwise

import numpy as np

from ..constants import numbers_of, rows_in_words

__all__ = ["known_numbers", "table_changes"]

COLUMN = 4  # numbers at most in a row; a longer list is a column
ROWS = 2  # at least, for a list to be a table
SCALES = (1, 1000), (1, 180 / np.pi)  # of lengths and of angles, as they may be written
PLAIN = (0, 1, 2, 180, 360, 1000, np.pi)  # numbers that no table need have


def table_changes(text):
    """Yields tuples of Edit that belong together.

    Parameters
    ----------
    text : Text
    """
    for node in text.nodes():
        if isinstance(node, (ast.List, ast.Tuple, ast.Dict)):
            parts = node.values if isinstance(node, ast.Dict) else node.elts
            yield from () if isinstance(node, ast.Dict) else _moved(node, text)
            rows = [cells for cells in map(_cells, parts) if cells]
            if len(rows) >= ROWS and len({tuple(row) for row in rows}) == 1:
                yield from _exchanged(rows, text)
        yield from _in_words(rows_in_words(node, text), text)


def _in_words(rows, text):
    """Numbers of a table that is written as a text: the other sign, and two exchanged."""
    for node in (node for row in rows for node in row if node.value):
        shown = text.of(node)
        new = shown[1:] if shown.startswith("-") else f"-{shown.removeprefix('+')}"
        yield (text.edit(node, new, 1),)
    yield from _exchanged([dict(enumerate(row)) for row in rows], text)


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
        yield (text.edit(first, b, 1), text.edit(second, a, 1))


def known_numbers(text, arm):
    """Yields tuples of one Edit: a number of the arm in place of one that the arm has not, and one
    that stands nowhere in the text in place of a zero in a table, or as one more term of a sum; a
    zero offset added to a joint value.

    Parameters
    ----------
    text : Text
    arm : Arm
    """
    numbers = list(numbers_of(text))
    written = np.abs([value for _, value in numbers])
    ends = np.concatenate([arm.base[:3, 3], arm.tool[:3, 3]])
    theta, d, a, alpha = arm.table.rows.T
    own = [
        scale * x
        for kind, scales in zip(
            (np.concatenate([d, a, ends]), np.concatenate([theta, alpha])), SCALES
        )
        for scale, x in _as_written(np.unique(np.abs(kind[kind != 0])), scales, written)
    ]
    missing = [x for x in own if not np.isclose(written, x, rtol=1e-4).any()]
    for node, value in numbers:
        if value and np.isclose(np.abs(value), [*own, *PLAIN], rtol=1e-4).any():
            continue
        for x in own if value else missing:
            new = repr(float(f"{np.copysign(x, value):.12g}"))
            yield (text.edit(node, new, 1),)
    if text.entry is not None:
        yield from _added(text, missing, np.unique(theta[theta != 0]))


def _added(text, missing, offsets):
    """What is missing added to the sums of the text, and zero offsets to its joint values."""
    for node in text.nodes():
        if isinstance(node, ast.Assign) and _is_sum(node.value):
            for x in missing:
                new = f"{float(x)!r} + {text.of(node.value)}"
                yield (text.edit(node.value, new, 2),)
        if isinstance(node, (ast.Assign, ast.Return)) and node.value is not None:
            for places in _joint_values(node.value, text):
                for x in offsets:
                    size = f"{'-' if x < 0 else '+'} {abs(float(x))!r}"
                    new = f"({text.of(places[0])} {size})"
                    yield tuple(text.edit(place, new) for place in places)


def _joint_values(value, text):
    """The places of each joint value in an expression: ``q[1]``, or a name unpacked from q."""
    entry = text.entry
    given = {argument.arg for argument in entry.args.args}
    alone = {
        part.id
        for node in ast.walk(entry)
        if isinstance(node, ast.Assign) and getattr(node.value, "id", "") in given
        for target in node.targets
        for part in getattr(target, "elts", ())
        if isinstance(part, ast.Name)
    }
    if len(given) > 1:
        alone |= given
    places = {}
    for node in ast.walk(value):
        indexed = isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant)
        if (indexed and getattr(node.value, "id", "") in given) or (
            isinstance(node, ast.Name) and node.id in alone
        ):
            places.setdefault(text.of(node), []).append(node)
    return places.values()


def _is_sum(node):
    return isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub))


def _as_written(values, scales, written):
    """Each of the values with the scale in which most of them are written; none if none is."""
    hits = [
        np.isclose(written[:, None], scale * values, rtol=1e-4).any(axis=0).sum()
        for scale in scales
    ]
    return [(scales[int(np.argmax(hits))], x) for x in values if max(hits)]
