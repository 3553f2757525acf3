"""Changes that bring in what is missing or take out what is too much: a rotation before a vector,
a factor of a product, a term of a sum, every rounding, the call of another function with its own
arguments, neighbours of a long list.
"""

import ast
from itertools import pairwise

from .names import is_method, name_called
from .operators import whole

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
    for node in text.nodes():
        if isinstance(node, ast.FunctionDef):
            yield from _turned_vectors(node, text)
            yield from _factors_and_terms(node, text)
            yield from _by_kind(node, text)
            yield from _other_calls(node, text)
        if isinstance(node, (ast.List, ast.Tuple)) and len(node.elts) > LONG:
            yield from _neighbours(node, text)
        if isinstance(node, ast.Call) and name_called(node) in ROUNDING:
            roundings.append(node)
    if len(roundings) > 1 and all(map(_rounded, roundings)):
        yield tuple(text.edit(node, f"({text.of(_rounded(node))})", 0) for node in roundings)


def _rounded(call):
    """What a call rounds: its first argument, or what it is a method of."""
    if call.args and not is_method(call):
        return call.args[0]
    return call.func.value if isinstance(call.func, ast.Attribute) else None


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
        if isinstance(node, ast.Call) and name_called(node) == "dot" and is_method(node)
        if isinstance(node.func.value, ast.Name)
    )
    for node in ast.walk(function):
        for part in _added(node):
            if isinstance(part, (ast.Name, ast.Call, ast.Subscript)):
                others = (name for name in matrices if name != text.of(part))
                yield from ((text.edit(part, f"{m} @ {whole(part, text)}", 1),) for m in others)


def _factors_and_terms(function, text):
    """A name that was made in the function and is not in a statement, as one more factor of its
    product, or as one more term of its sum.
    """
    made = dict.fromkeys(
        node.id
        for node in ast.walk(function)
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    )
    for statement in ast.walk(function):
        value = getattr(statement, "value", None)
        if not isinstance(statement, (ast.Assign, ast.AugAssign, ast.Return)) or value is None:
            continue
        there = {node.id for node in ast.walk(statement) if isinstance(node, ast.Name)}
        others = [name for name in made if name not in there]
        for node in ast.walk(value):
            if isinstance(node, ast.BinOp) and isinstance(node.op, ast.MatMult):
                left, right = whole(node.left, text), whole(node.right, text)
                for name in others:
                    yield (text.edit(node, f"({left} @ {name} @ {right})"),)
                    yield (text.edit(node, f"({left} @ {right} @ {name})"),)
        if isinstance(value, ast.BinOp) and isinstance(value.op, (ast.Add, ast.Sub)):
            yield from ((text.edit(value, f"{name} + {text.of(value)}", 2),) for name in others)


def _by_kind(function, text):
    """What is added in one place depending on the kind of joint, dependent on it elsewhere too."""
    choices = [node for node in ast.walk(function) if isinstance(node, (ast.IfExp, ast.If))]
    asked = dict.fromkeys(text.of(node.test) for node in choices)
    for node in ast.walk(function) if len(asked) < LONG else ():
        if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub)):
            added = text.of(node.right)
            for test in asked if isinstance(node.right, (ast.Name, ast.Subscript)) else ():
                yield (text.edit(node.right, f"(0.0 if {test} else {added})"),)
                yield (text.edit(node.right, f"({added} if {test} else 0.0)"),)


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
        and name_called(node) in text.defined
        and not any(isinstance(part, ast.Call) for part in ast.walk(node) if part is not node)
    ]
    shown = dict.fromkeys(map(text.of, calls))
    for node in calls:
        for other in shown:
            if other != text.of(node):
                yield (text.edit(node, other),)


def _neighbours(node, text):
    """Two neighbours exchanged."""
    for first, second in pairwise(node.elts):
        a, b = text.of(first), text.of(second)
        if a != b:
            yield text.edit(first, b, 1), text.edit(second, a, 1)
