"""What may stand in place of a product, a sum or another expression of two operands."""

import ast
from itertools import permutations

from .names import name_called

__all__ = ["in_other_orders", "is_product", "moved_addends", "of_two", "one_moved", "whole"]

PI = {"pi", "PI", "np", "numpy", "math"}  # what a number may be made of
WHOLE = (ast.Name, ast.Constant, ast.Call, ast.Subscript, ast.Attribute, ast.List, ast.Tuple)


def whole(node, text):
    """The text of a node, in brackets where it needs them."""
    return text.of(node) if isinstance(node, WHOLE) else f"({text.of(node)})"


def is_product(node):
    return len(_factors(node)) > 1


def _factors(node):
    """The factors of a matrix product, written with @, with .dot or with dot and matmul; how two of
    them are joined.
    """
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.MatMult):
        return [*_factors(node.left), *_factors(node.right)]
    if isinstance(node, ast.Call) and not node.keywords:
        name = name_called(node)
        if name == "dot" and len(node.args) == 1:
            return [*_factors(node.func.value), *_factors(node.args[0])]
        if name in ("dot", "matmul") and len(node.args) == 2:
            return [*_factors(node.args[0]), *_factors(node.args[1])]
    return [node]


def in_other_orders(node, text):
    factors = _factors(node)
    if not 2 <= len(factors) <= 4:
        return
    shown = [whole(factor, text) for factor in factors]
    for order in permutations(shown):
        if list(order) != shown:
            yield 0 if list(order) == shown[::-1] else 1, _joined(node, order, text)


def one_moved(parts):
    """Yields lists in which one of the parts stands somewhere else.

    Examples
    --------
    >>> ["".join(other) for other in one_moved("abc")]
    ['bac', 'bca', 'acb', 'cab']
    """
    for i in range(len(parts)):
        rest = [*parts[:i], *parts[i + 1 :]]
        for k in range(len(parts)):
            if k != i and k != i - 1:  # that one is the same as its neighbour moved on
                yield [*rest[:k], parts[i], *rest[k:]]


def _joined(node, order, text):
    if isinstance(node, ast.BinOp):
        return " @ ".join(order)
    if len(node.args) == 1:
        return order[0] + "".join(f".dot({factor})" for factor in order[1:])
    made = order[0]
    for factor in order[1:]:
        made = f"{text.of(node.func)}({made}, {factor})"
    return made


def of_two(node, parent, scope, text):
    left, right = whole(node.left, text), whole(node.right, text)
    op = type(node.op)
    if not any(isinstance(p, ast.Name) and p.id not in PI for p in ast.walk(node)):
        yield 1, "0"
    if op is ast.MatMult:
        if not is_product(parent):
            yield from in_other_orders(node, text)
        yield 1, f"{left} @ {right}.T"
        yield 1, f"{left}.T @ {right}"
    elif op is ast.Mult:
        yield from _of_product(node, left, right, text)
    elif op is ast.Add:
        yield 0, f"{left} - {right}"
        yield 1, f"{left} @ {right}"
        yield 2, f"{left} * {right}"
        if isinstance(parent, (ast.List, ast.Tuple, ast.Call)):
            yield 0, f"{left}, {right}"
    elif op is ast.Sub:
        yield 0, f"{left} + {right}"
        yield 0, f"{right} - {left}"
        if isinstance(parent, (ast.List, ast.Tuple, ast.Call)):
            yield 0, f"{left}, -{right}"  # a comma is missing
    elif op is ast.Div:
        yield 1, f"{left} * {right}"
    elif op is ast.FloorDiv:
        yield 0, f"{left} / {right}"
    if op in (ast.Mult, ast.Div) and isinstance(node.left, ast.BinOp):
        yield 0, whole(node.left.left, text)
    yield 1, left
    yield 1, f"-{right}" if op is ast.Sub else right


def _of_product(node, left, right, text):
    if isinstance(node.left, ast.List) and not isinstance(node.left.elts[0], ast.Constant):
        yield 0, f"[{text.of(node.left.elts[0])} for _ in range({right})]"
    yield 0, f"{left} @ {right}"
    yield 1, f"{left} + {right}"
    yield 2, f"{left} / {right}"
    yield 2, f"{left} - {right}"


def moved_addends(nodes, text):
    """Lists of texts in which what is added to one of them is added to another one; also the only
    one that is no number.
    """
    parts = [text.of(node) for node in nodes]
    alone = [i for i, node in enumerate(nodes) if isinstance(node, (ast.Name, ast.Subscript))]
    numbers = [i for i, node in enumerate(nodes) if isinstance(node, ast.Constant)]
    for k in numbers if len(alone) == 1 and len(numbers) > 1 else ():
        moved = {alone[0]: "0", k: f"{parts[k]} + {parts[alone[0]]}"}
        yield [moved.get(i, part) for i, part in enumerate(parts)]
    for i, node in enumerate(nodes):
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
            for kept, moved in ((node.left, node.right), (node.right, node.left)):
                for k in range(len(parts)):
                    if k != i:
                        other = list(parts)
                        other[i] = text.of(kept)
                        other[k] = f"{parts[k]} + {text.of(moved)}"
                        yield other
