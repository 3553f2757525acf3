"""What may be meant by a number or a word that is written into a program: another index, π in full,
another power of ten, a name, another word of the text.
"""

import ast

import numpy as np

__all__ = ["of_constant"]

EXACT = [np.pi * k for k in (0.25, 0.5, 1, 1.5, 2)] + [180 / np.pi, np.pi / 180]
ROUNDED, ROUGH = 6e-3, 0.05  # of a number: 1.57 for π/2, 3 for π
DEGREES = (30, 45, 60, 90, 120, 135, 150, 180, 270)
DEG = "(3.141592653589793 / 180)"
TENS = (0.001, 0.01, 0.1, 10, 100, 1000)  # between units of length
SHORT = 12  # letters of a word that means something
KINDS = {"R": "P", "P": "R", "r": "p", "p": "r"}  # of joints, letter by letter


def of_constant(node, parent, scope, text):
    """Yields a rank and what may stand in place of a constant.

    Parameters
    ----------
    node, parent : ast nodes
    scope : Scope
    text : Text
    """
    if isinstance(node.value, bool):
        yield 1, str(not node.value)
    elif isinstance(node.value, str):
        yield from _of_word(node.value, parent, scope)
    elif isinstance(node.value, (int, float)):
        in_index = isinstance(parent, (ast.Subscript, ast.Slice))
        yield from (_of_index if in_index else _of_number)(node, parent, scope)


def _of_word(value, parent, scope):
    if value == "F":
        yield 0, "'C'"
    if isinstance(parent, ast.Expr) or len(value) > SHORT or not value.isidentifier():
        return
    yield from ((1, repr(word)) for word in scope.words if word != value)
    for k, letter in enumerate(value if set(value) <= KINDS.keys() and len(value) > 1 else ""):
        yield 1, repr(value[:k] + KINDS[letter] + value[k + 1 :])


def _of_index(node, parent, scope):
    value = node.value
    alone = isinstance(parent, ast.Subscript) and node is parent.slice
    yield from ((0 if alone and name in scope.around else 2, name) for name in scope.counters)
    near = dict.fromkeys((0, 1, 2, 3, -1, value - 1, value + 1, value - 4, value + 4))
    yield from ((1, str(k)) for k in near if k != value)


def _of_number(node, parent, scope):
    value = node.value
    yield from ((0, name) for name in scope.unused)
    if isinstance(parent, ast.Call):
        yield from ((2, name) for name in (*scope.names, *scope.constants))
    yield from _in_full(value)
    if value in TENS:
        yield from ((0, repr(other)) for other in TENS if other != value)
    if isinstance(value, int):
        if value >= 2:
            yield from ((0, f"len({name})") for name in scope.parameters)
        yield from ((1, str(value + step)) for step in (-1, 1))
    if value in DEGREES:
        yield 1, f"({value!r} * {DEG})"
    if value not in (0, 1):
        yield 2, "1"
        yield 2, repr(value / 2)
        yield 2, repr(2 * value)
    yield 2, "0" if value else "1"
    if value:
        lone = value == 1 and isinstance(parent, (ast.Assign, ast.Tuple))
        yield 0 if lone else 1, f"-{value!r}"


def _in_full(value):
    """Parts of π and what turns degrees into radians, where a number is near one of them."""
    for exact in EXACT:
        off = abs(abs(value) - exact) / exact
        if 0 < off <= ROUGH:
            rounded = off <= ROUNDED and not float(value).is_integer()
            yield 0 if rounded else 1, repr(float(np.copysign(exact, value)))
