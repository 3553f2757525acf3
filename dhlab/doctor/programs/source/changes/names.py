"""What may be meant by a name, an attribute or a function that is handed on."""

import ast

__all__ = ["SISTERS", "is_method", "name_called", "of_attribute", "of_name"]

SISTERS = {
    "cos": "sin", "sin": "cos", "multiply": "matmul", "mul": "matmul", "add": "matmul",
    "inner": "matmul", "hstack": "vstack", "asarray": "array", "cosh": "cos", "sinh": "sin",
    "tan": "sin",
}  # fmt: skip


MODULES = "np", "math", "numpy", "sp"  # as they are called


def name_called(call):
    """The name of the function or the method that is called; "" where it has none."""
    return getattr(call.func, "attr", getattr(call.func, "id", ""))


def is_method(call):
    """Whether an object's method is called, and no function of a module."""
    function = call.func
    return isinstance(function, ast.Attribute) and not (
        isinstance(function.value, ast.Name) and function.value.id in MODULES
    )


def of_name(node, parent, scope, text):
    """Yields a rank and what may stand in place of a name.

    Parameters
    ----------
    node, parent : ast nodes
    scope : Scope
    text : Text
    """
    if not isinstance(node.ctx, ast.Load) or _is_called(node, parent):
        return
    if isinstance(parent, ast.Subscript) and node is parent.slice:
        yield 0, f"{node.id} - 1"
        yield 0, f"{node.id} + 1"
    if isinstance(parent, ast.For) and node is parent.iter:
        yield 1, f"{node.id}[::-1]"
    if isinstance(parent, ast.BinOp) and isinstance(parent.op, ast.MatMult):
        yield 1, f"{node.id}.T"
    if (sister := SISTERS.get(node.id)) and node.id in text.space:
        yield 0, sister if sister in text.space else "(lambda A, B: A @ B)"
    both = node.id in scope.constants
    if both and isinstance(parent, ast.Call):
        yield 1, "0"
    for other in (*scope.names, *scope.constants):
        if other != node.id and scope.are_alike(node.id, other):
            yield 1 if both and other in scope.constants else 2, other


def of_attribute(node, parent, scope, text):
    """Yields a rank and what may stand in place of an attribute, as for :func:`of_name`."""
    if not isinstance(node.ctx, ast.Load) or _is_called(node, parent):
        return
    base = text.of(node.value)
    if node.attr == "T":
        yield 0, base
        yield 0, f"{text.of(node)}.swapaxes(-2, -1)"  # of matrices one behind the other
    if node.attr in SISTERS and base in text.space:
        yield 0, f"{base}.{SISTERS[node.attr]}"
    beside = scope.beside.get(base, ())
    for other in dict.fromkeys((*beside, *scope.attributes)):
        if other != node.attr and node.attr in (beside if other in beside else scope.attributes):
            yield 1 if other in beside else 2, f"{base}.{other}"


def _is_called(node, parent):
    return isinstance(parent, ast.Call) and node is parent.func
