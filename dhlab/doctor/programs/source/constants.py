"""Numbers that are written into a program, fitted: the value of one with which the program is
right.
"""

import ast

import numpy as np

from .text import Edit

__all__ = ["fitted_numbers"]

STEP, STEPS = 1e-3, 8  # of the first guess, and how often it is made better
NEAR = 1e-9


def fitted_numbers(text, deviation):
    """Yields one Edit for each decimal number of a text, 0 and 1 apart, that another value makes
    right.

    Parameters
    ----------
    text : Text
    deviation : callable
        Edits to an array, the answer minus the right one; None where there is no answer.
    """
    for block in text.blocks:
        for node in ast.walk(block):
            if (
                isinstance(node, ast.Constant)
                and isinstance(node.value, float)
                and node.value not in (0, 1)
            ):
                edit = _fitted(node.value, text.span(node), deviation)
                if edit is not None:
                    yield edit


def _fitted(value, span, deviation):
    """The Edit to the value at which the deviation is 0, by Gauss and Newton; None."""
    for _ in range(STEPS):
        here, there = (deviation((_edit(x, span),)) for x in (value, value + STEP))
        if here is None or there is None:
            return None
        slope = (there - here) / STEP
        if not (slope**2).sum() > NEAR:
            return None
        value -= float((slope * here).sum() / (slope**2).sum())
        if abs(here).max() < NEAR:
            return _edit(float(np.round(value, 9)), span)
    return None


def _edit(value, span):
    return Edit(*span, repr(value).encode())
