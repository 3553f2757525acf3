"""What a statement would have changed that was not understood."""

import ast

import numpy as np

from ..held.budget import FAILURES
from ..held.factors import is_known_pose
from ..held.values import LOST, Instance, Unknown
from ..library.toolbox import Link
from .expressions import evaluate

__all__ = ["spoiled"]


def spoiled(run, node, scope):
    """Make unknown whatever a statement, which failed, would have set or changed."""
    run.failed += 1
    for target in _targets(node):
        run.budget.step(10)
        path = f"{LOST}{run.ticket()}"
        if isinstance(target, ast.Name):
            _spoil_products(run, scope.find(target.id))
            scope.put(target.id, Unknown(path, run.samples))
            continue
        try:
            owner = evaluate(run, target.value, scope)
        except FAILURES:
            continue
        if isinstance(owner, Instance):
            _spoil_products(run, owner.attributes.get(target.attr))
            owner.attributes[target.attr] = Unknown(path, run.samples)
        elif isinstance(owner, Link):
            owner.row = None
        elif isinstance(owner, np.ndarray) and isinstance(target.value, ast.Name):  # a part of it
            _spoil_products(run, owner)
            scope.put(target.value.id, Unknown(path, run.samples))


def _spoil_products(run, value):
    """What was multiplied until now is not all of it."""
    items = value if isinstance(value, list) else [value]
    run.factors.spoil(*(one for one in items if is_known_pose(one)))


def _targets(node):
    for one in ast.walk(node):
        if isinstance(one, ast.FunctionDef | ast.ClassDef):
            yield ast.Name(one.name)
        stored = isinstance(getattr(one, "ctx", None), ast.Store)
        if stored and isinstance(one, ast.Name | ast.Attribute | ast.Subscript):
            yield from _root(one)
        if isinstance(one, ast.Call) and isinstance(one.func, ast.Attribute):
            yield from _root(one.func.value)
        if isinstance(one, ast.Expr) and isinstance(one.value, ast.Call):
            for given in one.value.args:
                yield from _root(given)


def _root(node):
    """The name, or the attribute of a name, in which something is changed."""
    while isinstance(node, ast.Subscript | ast.Attribute):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            yield node
            return
        node = node.value
    if isinstance(node, ast.Name) and node.id not in ("self", "np", "math", "sp", "plt"):
        yield node
