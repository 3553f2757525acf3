"""Numbers that are written into a program, fitted: the value of one with which the program is
right.

An answer depends on a length in a straight line, and on an angle by its cosine and sine; so three
tries tell the value.
"""

import ast
import re

import numpy as np

from .text import Edit

__all__ = ["fitted_numbers", "numbers_of", "rows_in_words"]

NEAR = 1e-9
QUARTERS = (np.pi / 2, 90.0)  # in radians and in degrees
NUMBER = re.compile(rb"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?![\w.])")
LEAST = 4  # numbers of a table that is written as a text
TURN = 7.0  # no angle in radians is larger
TABLE = (ast.List, ast.Tuple, ast.Dict, ast.keyword)


def fitted_numbers(text, deviation, of_an_arm=True):
    """Yields one Edit for each number of a text that another value makes right: decimal numbers,
    and whatever stands in a list.

    Parameters
    ----------
    text : Text
    deviation : callable
        Edits to an array, the answer minus the right one; None where there is no answer.
    of_an_arm : bool
        Whether the program may hold an arm's numbers; else a 0 or a 1 is what it has to be.
    """
    here, seen = _flat(deviation(())), set()
    for node, value in numbers_of(text) if here is not None else ():
        span = text.span(node)
        if span in seen or (value in (0, 1) and not of_an_arm):
            continue
        seen.add(span)
        edit = _fitted(value, span, here, deviation)
        if edit is not None:
            yield edit


def numbers_of(text):
    """Yields (node, value) of the numbers that are written into a text: decimal ones, and whatever
    stands in a list.
    """
    for parent in text.nodes():
        for node in ast.iter_child_nodes(parent):
            value = _value(node)
            if value is not None and (
                isinstance(parent, TABLE)
                or (isinstance(value, float) and value not in (0, 1))
                or (isinstance(parent, ast.Call) and text.of(parent.func) in text.defined)
            ):
                yield node, float(value)
        for row in rows_in_words(parent, text):
            yield from ((node, float(node.value)) for node in row)


def rows_in_words(node, text):
    """The numbers of a table that is written as one text in quotes, row by row, each as a node with
    its place; empty where it is none.

    Parameters
    ----------
    node : ast node
    text : Text
    """
    if not isinstance(node, ast.Constant) or not isinstance(node.value, str):
        return []
    rows = []
    for number, line in enumerate(text.of(node).encode().splitlines(), node.lineno):
        begin = 0 if number > node.lineno else node.col_offset
        rows.append([_node_of(found, number, begin) for found in NUMBER.finditer(line)])
    rows = [row for row in rows if row]
    return rows if sum(map(len, rows)) >= LEAST and len({*map(len, rows)}) == 1 else []


def _node_of(found, line, begin):
    place = {"lineno": line, "end_lineno": line}
    first, last = found.start() + begin, found.end() + begin
    return ast.Constant(float(found[0]), col_offset=first, end_col_offset=last, **place)


def _value(node):
    """The number that a node is, with its sign; None."""
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        value = _value(node.operand)
        return None if value is None else -value
    is_number = isinstance(node, ast.Constant) and type(node.value) in (int, float)
    return node.value if is_number else None


def _fitted(value, span, here, deviation):
    """The Edit to the value at which the deviation, ``here`` as it stands, is 0; None."""

    def off(x):
        return _flat(deviation((_edit(x, span),)))

    further = off(value + 1)
    if further is None or abs(further - here).max() < NEAR:
        return None
    for x in (*_straight(value, here, further), *_around(value, here, off)):
        found = off(x)
        if found is not None and abs(found).max() < 1e3 * NEAR:
            return _edit(float(np.round(x, 9)) + 0.0, span)
    return None


def _flat(deviation):
    there = deviation is not None and np.isfinite(deviation).all()
    return deviation.ravel() if there else None


def _straight(value, here, further):
    """Yields where the deviation ends if it is a straight line to zero."""
    slope = further - here
    step = float(slope @ here / (slope @ slope))
    if abs(here - step * slope).max() < 1e3 * NEAR:
        yield value - step


def _around(value, here, off):
    """Yields where an angle makes the deviation zero, by a quarter and half a turn further."""
    for quarter in QUARTERS if abs(value) < TURN else QUARTERS[1:]:
        first, second = off(value + quarter), off(value + 2 * quarter)
        if first is None or second is None:
            continue
        middle, cosine = (here + second) / 2, (here - second) / 2
        A = np.stack([cosine, first - middle], axis=1)
        (c, s), *_ = np.linalg.lstsq(A, -middle, rcond=None)
        if abs(c * c + s * s - 1) < 1e-6 and abs(A @ (c, s) + middle).max() < 1e-6:
            yield value + float(np.arctan2(s, c)) * quarter / (np.pi / 2)


def _edit(value, span):
    return Edit(*span, repr(value).encode())
