"""What an expression of a program comes to."""

import ast

import numpy as np

from ..held.budget import Unsupported
from ..held.operators import binary, compared, indexed, truth, unary
from ..held.scopes import MISSING, Scope
from ..held.values import Function, Module, Unknown, items_of
from ..library.functions import LIBRARIES
from ..library.methods import from_library

__all__ = ["YIELDED", "arguments", "assign", "evaluate"]

YIELDED = "yield"  # no name of a program
OF_TEXT = "eval", "sympify", "S", "parse_expr", "str2sym", "str2num"


def evaluate(run, node, scope):
    """The value of an expression.

    Raises
    ------
    Unsupported
        It has something in it that is not in the list.
    """
    run.budget.step()
    act = EXPRESSIONS.get(type(node))
    if act is None:
        raise Unsupported(type(node).__name__)
    with run.budget:
        return act(run, node, scope)


def _constant(run, node, scope):
    if isinstance(node.value, complex | bytes):
        raise Unsupported("another kind of number")
    return run.budget.checked(node.value)


def _name(run, node, scope):
    found = scope.find(node.id)
    if found is not MISSING:
        return found
    found = run.dialect.name(node.id, scope) if run.dialect else None
    found = from_library(node.id) if found is None else found
    if found is not None:
        return found
    return Module(node.id) if node.id in LIBRARIES else Unknown(node.id, run.samples)


def _list(run, node, scope):
    found = []
    for item in node.elts:
        if isinstance(item, ast.Starred):
            found += items_of(evaluate(run, item.value, scope))
        else:
            found.append(evaluate(run, item, scope))
    run.factors.made(found, node)
    return run.budget.checked(found)


def _tuple(run, node, scope):
    return tuple(_list(run, node, scope))


def _dict(run, node, scope):
    found = {}
    for key, value in zip(node.keys, node.values):
        if key is None:
            more = evaluate(run, value, scope)
            more = getattr(more, "attributes", more)  # of a record
            found.update(more if isinstance(more, dict) else {})
            continue
        name = evaluate(run, key, scope)
        if not isinstance(name, str | int | float | tuple | Unknown):
            raise Unsupported("another key")
        found[name] = evaluate(run, value, scope)
    return run.budget.checked(found)


def _binary(run, node, scope):
    one, other = evaluate(run, node.left, scope), evaluate(run, node.right, scope)
    return binary(run, type(node.op), one, other)


def _unary(run, node, scope):
    return unary(run, type(node.op), evaluate(run, node.operand, scope))


def _either(run, node, scope):
    for part in node.values:
        value = evaluate(run, part, scope)
        if truth(value) != isinstance(node.op, ast.And):
            return value
    return value


def _compare(run, node, scope):
    left = evaluate(run, node.left, scope)
    for kind, part in zip(node.ops, node.comparators):
        right = evaluate(run, part, scope)
        held = compared(type(kind), left, right)
        if isinstance(held, np.ndarray) and held.size != 1 and len(node.ops) == 1:
            return held
        if not truth(held):
            return False
        left = right
    return True


def _choice(run, node, scope):
    return evaluate(
        run, node.body if truth(evaluate(run, node.test, scope)) else node.orelse, scope
    )


def _subscript(run, node, scope):
    held, key = evaluate(run, node.value, scope), evaluate(run, node.slice, scope)
    if getattr(run.dialect, "counts_from_one", False):
        return run.dialect.picked(held, key if isinstance(key, tuple) else (key,))
    return indexed(held, key)


def _slice(run, node, scope):
    parts = (node.lower, node.upper, node.step)
    return slice(*(None if one is None else evaluate(run, one, scope) for one in parts))


def _attribute(run, node, scope):
    return run.attribute(evaluate(run, node.value, scope), node.attr)


def _call(run, node, scope):
    function = evaluate(run, node.func, scope)
    args, kwargs = arguments(run, node, scope)
    if getattr(function, "name", "") == "super" or (
        isinstance(function, Unknown) and function.path == "super"
    ):
        return run.above(scope)
    called = function.path if isinstance(function, Unknown) else getattr(function, "name", "")
    if called in OF_TEXT and args and (isinstance(args[0], str) or called == "eval"):
        return _of_text(run, args[0], scope)
    found = run.call(function, args, kwargs)
    run.factors.made(found, node)
    return found


def _of_text(run, text, scope):
    """What an expression in quotes comes to: a row's ``'q2 - pi/2'``, which a program evaluates."""
    if not isinstance(text, str):
        raise Unsupported("a text that is not known")
    try:
        return evaluate(run, ast.parse(text.strip(), mode="eval").body, scope)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        raise Unsupported("no expression") from None


def arguments(run, node, scope):
    """(positional, by name) of a call."""
    args, kwargs = [], {}
    for item in node.args:
        if isinstance(item, ast.Starred):
            args += items_of(evaluate(run, item.value, scope))
        else:
            args.append(evaluate(run, item, scope))
    for word in node.keywords:
        value = evaluate(run, word.value, scope)
        if word.arg is not None:
            kwargs[word.arg] = value
        elif isinstance(value, dict) and all(isinstance(key, str) for key in value):
            kwargs.update(value)
    run.budget.checked(args)
    return args, kwargs


def _lambda(run, node, scope):
    return Function(node, scope, "lambda")


def _comprehended(run, node, scope):
    found = []

    def over(k, inner):
        if k == len(node.generators):
            if isinstance(node, ast.DictComp):
                key, value = (evaluate(run, part, inner) for part in (node.key, node.value))
                found.append((key, value))
            else:
                found.append(evaluate(run, node.elt, inner))
            return run.budget.checked(found)
        part = node.generators[k]
        for item in run.over(evaluate(run, part.iter, inner)):
            run.budget.step()
            assign(run, part.target, item, inner)
            if all(truth(evaluate(run, test, inner)) for test in part.ifs):
                over(k + 1, inner)
        return None

    over(0, Scope(outer=scope, owner=scope.owner, me=scope.me))
    return dict(found) if isinstance(node, ast.DictComp) else found


def _text(run, node, scope):
    return "text"


def _named(run, node, scope):
    value = evaluate(run, node.value, scope)
    scope.put(node.target.id, value)
    return value


def _yielded(run, node, scope):
    """What a generator gives: its function comes to the list of all of it."""
    held = scope.names.setdefault(YIELDED, [])
    value = None if node.value is None else evaluate(run, node.value, scope)
    if isinstance(node, ast.YieldFrom):
        held += items_of(value)
    else:
        held.append(value)
    run.budget.checked(held)


def assign(run, target, value, scope):
    """Let a target, ``x``, ``x[i]``, ``x.y`` or ``x, y``, hold a value."""
    if isinstance(target, ast.Name):
        value = run.held(target.id, value)
        scope.put(target.id, value)
        run.watched.watch(scope, target.id, value)
    elif isinstance(target, ast.Tuple | ast.List):
        _unpack(run, target.elts, value, scope)
    elif isinstance(target, ast.Subscript):
        if run.dialect and isinstance(target.value, ast.Name):
            run.dialect.prepare(target.value.id, target, scope)
        run.store(evaluate(run, target.value, scope), evaluate(run, target.slice, scope), value)
    elif isinstance(target, ast.Attribute):
        if run.dialect and isinstance(target.value, ast.Subscript):
            run.dialect.prepare_record(run, target.value, scope)
        owner, value = evaluate(run, target.value, scope), run.held(target.attr, value)
        run.set_attribute(owner, target.attr, value)
        run.watched.watch(owner, target.attr, value)
    else:
        raise Unsupported("another target")


def _unpack(run, targets, value, scope):
    starred = [k for k, one in enumerate(targets) if isinstance(one, ast.Starred)]
    exact = None if starred else len(targets)
    if isinstance(value, np.ndarray) and value.shape == (1, len(targets)):
        value = value[0]  # MATLAB: [a, b] = row{1, :}
    items = value.items(exact) if isinstance(value, Unknown) else items_of(value)
    if not starred and len(items) != len(targets):
        raise Unsupported("another number of values")
    if starred:
        at, after = starred[0], len(targets) - starred[0] - 1
        middle = items[at : len(items) - after]
        items = [*items[:at], middle, *items[len(items) - after :]]
    for one, item in zip(targets, items):
        assign(run, one.value if isinstance(one, ast.Starred) else one, item, scope)


EXPRESSIONS = {
    ast.Constant: _constant, ast.Name: _name, ast.List: _list, ast.Tuple: _tuple, ast.Set: _list,
    ast.Dict: _dict, ast.BinOp: _binary, ast.UnaryOp: _unary, ast.BoolOp: _either,
    ast.Compare: _compare, ast.IfExp: _choice, ast.Subscript: _subscript, ast.Slice: _slice,
    ast.Attribute: _attribute, ast.Call: _call, ast.Lambda: _lambda,
    ast.ListComp: _comprehended, ast.GeneratorExp: _comprehended, ast.DictComp: _comprehended,
    ast.SetComp: _comprehended, ast.JoinedStr: _text, ast.NamedExpr: _named,
    ast.Yield: _yielded, ast.YieldFrom: _yielded,
}  # fmt: skip
