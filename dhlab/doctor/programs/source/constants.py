"""Numbers that are written into a program, fitted: the value of one with which the program is
right.

An answer depends on a length in a straight line, and on an angle by its cosine and sine; so three
tries tell the value.
"""

import ast

import numpy as np

from .text import Edit

__all__ = ["fitted_numbers", "numbers_of"]

NEAR = 1e-9
QUARTERS = (np.pi / 2, 90.0)  # in radians and in degrees
TABLE = (ast.List, ast.Tuple, ast.Dict, ast.keyword)


def fitted_numbers(text, deviation):
    """Yields one Edit for each number of a text that another value makes right: decimal numbers,
    and whatever stands in a list.

    Parameters
    ----------
    text : Text
    deviation : callable
        Edits to an array, the answer minus the right one; None where there is no answer.
    """
    seen = set()
    for node, value in numbers_of(text):
        span = text.span(node)
        if span not in seen:
            seen.add(span)
            edit = _fitted(value, span, deviation)
            if edit is not None:
                yield edit


def numbers_of(text):
    """Yields (node, value) of the numbers that are written into a text: decimal ones, and whatever
    stands in a list.
    """
    for block in text.blocks:
        for parent in ast.walk(block):
            for node in ast.iter_child_nodes(parent):
                value = _value(node)
                if value is not None and (
                    isinstance(parent, TABLE) or (isinstance(value, float) and value not in (0, 1))
                ):
                    yield node, float(value)


def _value(node):
    """The number that a node is, with its sign; None."""
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        value = _value(node.operand)
        return None if value is None else -value
    is_number = isinstance(node, ast.Constant) and type(node.value) in (int, float)
    return node.value if is_number else None


def _fitted(value, span, deviation):
    """The Edit to the value at which the deviation is 0; None."""

    def off(x):
        answer = deviation((_edit(x, span),))
        return answer.ravel() if answer is not None and np.isfinite(answer).all() else None

    here, further = off(value), off(value + 1)
    if here is None or further is None or abs(further - here).max() < NEAR:
        return None
    for x in (_straight(value, here, further), *_around(value, here, off)):
        found = None if x is None else off(x)
        if found is not None and abs(found).max() < 1e3 * NEAR:
            return _edit(float(np.round(x, 9)) + 0.0, span)
    return None


def _straight(value, here, further):
    slope = further - here
    return value - float(slope @ here / (slope @ slope))


def _around(value, here, off):
    """Yields where an angle makes the deviation least, by a quarter and half a turn further."""
    for quarter in QUARTERS:
        first, second = off(value + quarter), off(value + 2 * quarter)
        if first is None or second is None:
            continue
        middle, cosine = (here + second) / 2, (here - second) / 2
        sine = first - middle
        (c, s), *_ = np.linalg.lstsq(np.stack([cosine, sine], axis=1), -middle, rcond=None)
        if abs(c * c + s * s - 1) < 1e-6:
            yield value + float(np.arctan2(s, c)) * quarter / (np.pi / 2)


def _edit(value, span):
    return Edit(*span, repr(value).encode())
