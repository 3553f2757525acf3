"""What MATLAB has otherwise than Python, for the interpreter of its programs."""

import ast

import numpy as np

from ...held.factors import Multiplied
from ...held.scopes import MISSING
from ...held.values import Function, Instance, Method, Unknown, plain
from ...interpreting.expressions import evaluate
from .values import ALL, NAMES, Span, from_one, key_of, listed, picked

__all__ = ["Matlab"]


class Matlab:
    """The dialect: indices count from one and stand in round brackets, ``*`` is the product of
    matrices, ``%`` and ``//`` stand for ``.*`` and ``./``.
    """

    counts_from_one = True
    listed = staticmethod(listed)
    picked = staticmethod(picked)
    from_one = staticmethod(from_one)

    def attribute(self, run, value, name):
        """What stands behind a dot, as in Python."""
        return None

    def set_attribute(self, held, name, value):
        """Whether a part of something was set that Python has not."""
        return False

    def name(self, name, scope):
        """What a name is that the program does not define; None of others."""
        if name.startswith("SELF__"):  # obj.link(…): obj is the function's first argument
            method = scope.find(name.removeprefix("SELF__"))
            if not isinstance(method, Function):
                return None
            return method if method.kind == "staticmethod" else Method(method, Instance(None))
        if "__" in name:
            return _field(name, scope)
        return ALL if name == "_all" else NAMES.get(name)

    def is_index(self, held, args):
        """Whether round brackets behind a value are an index."""
        if isinstance(held, Unknown):
            return 0 < len(args) < 3 and all(isinstance(one, int | float | Span) for one in args)
        return isinstance(held, np.ndarray | list | tuple | dict | int | float)

    def key(self, held, key):
        """Where a value is stored."""
        if isinstance(held, dict):
            return key_of(key)
        at = from_one(key)
        flat = isinstance(held, np.ndarray) and held.ndim == 2 and not isinstance(at, tuple)
        if flat and isinstance(at, int):
            return (at % len(held), at // len(held)) if len(held) > 1 else (0, at)
        return at

    def prepare(self, name, target, scope):
        """A name that is set item by item begins as nothing."""
        if scope.find(name) is MISSING:
            scope.put(name, {})

    def prepare_record(self, run, target, scope):
        """A record that is set field by field begins as nothing: ``s(2).d = 0.1``."""
        name = target.value.id
        self.prepare(name, target, scope)
        held, key = scope.find(name), evaluate(run, target.slice, scope)
        if isinstance(held, dict):
            held.setdefault(key_of(key), Instance(None, path=f"{name}({key})"))

    def operands(self, kind, one, other):
        """The operation and its operands as Python has them."""
        one, other = (_matrix(value) for value in (one, other))
        if kind in (ast.Mod, ast.FloorDiv):
            one, other = (np.asarray(v) if isinstance(v, np.ndarray) else v for v in (one, other))
            kind = ast.Mult if kind is ast.Mod else ast.Div
        return kind, one, other


def _field(name, scope):
    """The field of a record that was taken from elsewhere, ``p = L(2)``: ``p.q0`` is ``p__q0``."""
    owner, _, field = name.partition("__")
    held = scope.find(owner)
    return held.attributes.get(field) if isinstance(held, Instance) else None


def _matrix(value):
    """A range or a list as a row; an array as a matrix for which ``*`` is the product."""
    if isinstance(value, Span):
        value = value.numbers().reshape(1, -1)
    elif isinstance(value, list):
        value = plain(value)
    if isinstance(value, np.ndarray):
        return (value.reshape(1, -1) if value.ndim == 1 else value).view(Multiplied)
    return value
