"""Changes that bring in what is missing or take out what is too much: a rotation before a vector,
every rounding, the call of another function with its own arguments, neighbours of a long list.
"""

import ast
from itertools import pairwise

from .operators import whole
from .text import Edit

__all__ = ["missing_changes"]

ROUNDING = {"round", "around", "rint", "floor", "trunc", "round_", "fix"}
LONG = 4  # entries; shorter lists are tried in every order elsewhere


def missing_changes(text):
    """Yields tuples of Edit that belong together.

    Parameters
    ----------
    text : Text
    """
    roundings = []
    for block in text.blocks:
        for node in ast.walk(block):
            if isinstance(node, ast.FunctionDef):
                yield from _turned_vectors(node, text)
                yield from _other_calls(node, text)
            if isinstance(node, (ast.List, ast.Tuple)) and len(node.elts) > LONG:
                yield from _neighbours(node, text)
            if isinstance(node, ast.Call) and _name(node) in ROUNDING:
                roundings.append(node)
    if len(roundings) > 1 and all(map(_rounded, roundings)):
        yield tuple(_edit(node, f"({text.of(_rounded(node))})", text, 0) for node in roundings)


def _edit(node, new, text, rank):
    return Edit(*text.span(node), new.encode(), rank)


def _name(call):
    return getattr(call.func, "attr", getattr(call.func, "id", ""))


def _rounded(call):
    """What a call rounds: its first argument, or what it is a method of."""
    if call.args and not _is_method(call):
        return call.args[0]
    return call.func.value if isinstance(call.func, ast.Attribute) else None


def _is_method(call):
    function = call.func
    return isinstance(function, ast.Attribute) and not (
        isinstance(function.value, ast.Name) and function.value.id in ("np", "numpy", "math")
    )


def _turned_vectors(function, text):
    """A matrix before what is added: ``p + R @ v`` for ``p + v``."""
    matrices = dict.fromkeys(
        factor.id
        for node in ast.walk(function)
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.MatMult)
        for factor in (node.left, node.right)
        if isinstance(factor, ast.Name)
    )
    matrices |= dict.fromkeys(
        node.func.value.id
        for node in ast.walk(function)
        if isinstance(node, ast.Call) and _name(node) == "dot" and _is_method(node)
        if isinstance(node.func.value, ast.Name)
    )
    for node in ast.walk(function):
        for part in _added(node):
            if isinstance(part, (ast.Name, ast.Call, ast.Subscript)):
                others = (name for name in matrices if name != text.of(part))
                yield from ((_edit(part, f"{m} @ {whole(part, text)}", text, 1),) for m in others)


def _added(node):
    if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub)):
        yield from (node.left, node.right)
    if isinstance(node, ast.AugAssign) and isinstance(node.op, (ast.Add, ast.Sub)):
        yield node.value


def _other_calls(function, text):
    """One call of the text's own functions for another that stands in the same function."""
    calls = [
        node
        for node in ast.walk(function)
        if isinstance(node, ast.Call)
        and _name(node) in text.defined
        and not any(isinstance(part, ast.Call) for part in ast.walk(node) if part is not node)
    ]
    shown = dict.fromkeys(map(text.of, calls))
    for node in calls:
        for other in shown:
            if other != text.of(node):
                yield (_edit(node, other, text, 1),)


def _neighbours(node, text):
    """Two neighbours exchanged."""
    for first, second in pairwise(node.elts):
        a, b = text.of(first), text.of(second)
        if a != b:
            yield _edit(first, b, text, 1), _edit(second, a, text, 1)
