"""What a statement of a program does."""

import ast

import numpy as np

from ..held.budget import FAILURES, Raised, Unsupported
from ..held.operators import binary, truth, whole
from ..held.scopes import MISSING, Scope
from ..held.values import Class, Function, Instance, Module, Unknown, is_number, items_of, plain
from .expressions import assign, evaluate
from .unknowns import spoiled

__all__ = ["body"]

MOST_TURNS = 128
LEADING_OUT = (ast.Break, ast.Continue, ast.Return, ast.Raise)
LIBRARY_WORDS = {
    "np", "numpy", "math", "pi", "sp", "sympy", "radians", "deg2rad", "array", "torch", "float",
    "zeros", "PI", "asarray", "_matrix", "_new", "list", "d2r", "deg",
}  # fmt: skip


def body(run, statements, scope, within=False):
    """Carry out statements; one that is not understood leaves what it would have changed unknown.

    ``within`` says that they stand in a loop or a branch: where one may lead out of it and fails,
    the whole does.

    Returns
    -------
    tuple or None
        ("return", value), ("break",) or ("continue",), where that ends them.
    """
    for node in statements:
        run.budget.step()
        mark = run.marked()
        try:
            with run.budget:
                ended = carry_out(run, node, scope)
        except FAILURES:
            if within and any(isinstance(one, LEADING_OUT) for one in ast.walk(node)):
                raise
            run.back_to(mark)
            spoiled(run, node, scope)
            if isinstance(node, ast.Return):
                return ("return", run.unknown("result"))
            continue
        if ended:
            return ended
    return None


def carry_out(run, node, scope):
    """Carry out one statement."""
    act = STATEMENTS.get(type(node))
    if act is None:
        raise Unsupported(type(node).__name__)
    return act(run, node, scope)


def _assign(run, node, scope):
    value = evaluate(run, node.value, scope)
    for target in node.targets:
        assign(run, target, _posed_values(run, target, node.value, value), scope)


def _posed_values(run, target, node, value):
    """What a target holds, joints' values in one pose taken for not known."""
    names = isinstance(target, ast.Tuple | ast.List) and isinstance(node, ast.Tuple | ast.List)
    if names and len(target.elts) == len(node.elts) == len(value):
        parts = zip(target.elts, node.elts, value)
        return [_posed_values(run, *part) for part in parts]
    _posed_fields(run, node, value)
    return _posed(run, getattr(target, "id", getattr(target, "attr", "")), node, value)


def _posed_fields(run, node, value):
    """Let the joints' values of one pose that a record holds, ``{q1: 0.5, reach: 0.3}``, be not
    known.
    """
    made = isinstance(node, ast.Call) and getattr(node.func, "id", "") == "_record"
    shown = node.args[0] if made else node
    held = value.attributes if made and isinstance(value, Instance) else value
    if not run.posing or not isinstance(shown, ast.Dict) or not isinstance(held, dict):
        return
    for key, part in zip(shown.keys, shown.values):
        name = getattr(key, "value", None)
        if isinstance(name, str) and name[-1:].isdigit() and is_number(held.get(name)):
            held[name] = _posed(run, name, part, held[name])


def _posed(run, name, node, value):
    """A joint's value in one pose, where only the pose is held: not known."""
    if not run.posing or not name or not run.is_joint(name):
        return value
    if {one.id for one in ast.walk(node) if isinstance(one, ast.Name)} - LIBRARY_WORDS:
        return value
    if not is_number(value):
        try:
            shape = plain(value).shape
            if len(shape) != 1 and shape[0] != 1:
                return value
        except Unsupported:
            return value
    run.posed[name] = value
    return Unknown(name, run.samples)


def _declared(run, node, scope):
    if node.value is not None:
        value = evaluate(run, node.value, scope)
        assign(run, node.target, _posed_values(run, node.target, node.value, value), scope)


def _changed(run, node, scope):
    target = node.target
    old = evaluate(run, _loaded(target), scope)
    value = evaluate(run, node.value, scope)
    kind = type(node.op)
    if isinstance(old, list) and kind is ast.Add:
        old.extend(items_of(value))
    elif _in_place(target, old, value):
        old[...] = plain(binary(run, kind, old, value))
    else:
        assign(run, target, binary(run, kind, old, value), scope)


def _in_place(target, old, value):
    """Whether an array is changed where it is; a part that indices pick is another array."""
    known = isinstance(value, int | float | np.ndarray)
    picked = isinstance(target, ast.Subscript)
    return isinstance(old, np.ndarray) and known and bool(old.ndim) and not picked


def _loaded(target):
    made = type(target)(**{name: getattr(target, name) for name in target._fields})
    made.ctx = ast.Load()
    return made


def _expression(run, node, scope):
    if not isinstance(node.value, ast.Constant):
        evaluate(run, node.value, scope)


def _if(run, node, scope):
    if _is_main(node.test):
        return body(run, node.body, scope)
    held = truth(evaluate(run, node.test, scope))
    return body(run, node.body if held else node.orelse, scope, within=True)


def _is_main(test):
    return (
        isinstance(test, ast.Compare)
        and isinstance(test.left, ast.Name)
        and test.left.id == "__name__"
    )


def _for(run, node, scope):
    for item in run.over(evaluate(run, node.iter, scope)):
        run.budget.step()
        assign(run, node.target, item, scope)
        ended = body(run, node.body, scope, within=True)
        if ended and ended[0] == "return":
            return ended
        if ended and ended[0] == "break":
            return None
    return body(run, node.orelse, scope, within=True)


def _while(run, node, scope):
    forever = isinstance(node.test, ast.Constant)
    breaks = any(isinstance(one, ast.Break) for one in ast.walk(node))
    for turn in range(MOST_TURNS):
        if not truth(evaluate(run, node.test, scope)) or (forever and turn and not breaks):
            return None
        ended = body(run, node.body, scope, within=True)
        if ended and ended[0] == "return":
            return ended
        if ended and ended[0] == "break":
            return None
    raise Unsupported("too long a loop")


def _return(run, node, scope):
    return ("return", None if node.value is None else evaluate(run, node.value, scope))


def _define(run, node, scope):
    words = [ast.unparse(one) for one in node.decorator_list]
    kind = next((word for word in words if word in ("staticmethod", "classmethod", "property")), "")
    made = Function(node, scope, node.name, scope.owner if scope.me is None else None, kind)
    made.defaults = [None if one is None else evaluate(run, one, scope) for one in (
        *node.args.defaults, *node.args.kw_defaults
    )]  # fmt: skip
    scope.put(node.name, made)


def _class(run, node, scope):
    bases = tuple(evaluate(run, base, scope) for base in node.bases)
    own = Scope(outer=scope)
    cls = Class(node.name, bases, own.names, [])
    own.owner = cls
    for part in node.body:
        if isinstance(part, ast.AnnAssign) and isinstance(part.target, ast.Name):
            cls.fields.append(part.target.id)
    scope.put(node.name, cls)  # what was pasted with too deep an indent makes one within it
    body(run, node.body, own)
    for name, value in own.names.items():
        if isinstance(value, Function):
            value.owner = cls
            value.scope = scope
            own.names[name] = value
    scope.put(node.name, cls)


def _try(run, node, scope):
    try:
        ended = body(run, node.body, scope)
    except Raised:
        ended = body(run, node.handlers[0].body, scope) if node.handlers else None
    return ended or body(run, node.finalbody, scope)


def _with(run, node, scope):
    for item in node.items:
        value = evaluate(run, item.context_expr, scope)
        if item.optional_vars is not None:
            assign(run, item.optional_vars, value, scope)
    return body(run, node.body, scope)


def _import(run, node, scope):
    for one in node.names:
        root = one.name.split(".")
        scope.put(one.asname or root[0], Module(root[-1] if one.asname else root[0]))


def _from(run, node, scope):
    for one in node.names:
        if one.name != "*":
            found = run.imported(node.module or "", one.name)
            if scope.find(one.asname or one.name) is MISSING or found is not None:
                value = Unknown(one.name, run.samples) if found is None else found
                scope.put(one.asname or one.name, value)


def _global(run, node, scope):
    for name in node.names:
        scope.declare(name, isinstance(node, ast.Global))


def _raise(run, node, scope):
    raise Raised


def _assert(run, node, scope):
    return None


def _delete(run, node, scope):
    for target in node.targets:
        if isinstance(target, ast.Name):
            continue
        held = evaluate(run, getattr(target, "value", target), scope)
        if not isinstance(target, ast.Subscript) or not isinstance(held, list | dict):
            raise Unsupported("del")
        key = evaluate(run, target.slice, scope)
        del held[whole(key) if isinstance(held, list) else key]


def _pass(run, node, scope):
    return None


STATEMENTS = {
    ast.Assign: _assign, ast.AnnAssign: _declared, ast.AugAssign: _changed,
    ast.Expr: _expression, ast.If: _if, ast.For: _for, ast.While: _while, ast.Return: _return,
    ast.FunctionDef: _define, ast.AsyncFunctionDef: _define, ast.ClassDef: _class,
    ast.Try: _try, ast.With: _with, ast.Import: _import, ast.ImportFrom: _from,
    ast.Global: _global, ast.Nonlocal: _global, ast.Raise: _raise, ast.Assert: _assert,
    ast.Delete: _delete, ast.Pass: _pass,
    ast.Break: lambda *_: ("break",), ast.Continue: lambda *_: ("continue",),
}  # fmt: skip
