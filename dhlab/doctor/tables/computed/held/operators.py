"""What ``+``, ``@``, ``<`` and indices do with the values of a program."""

import ast
import operator
import re

import numpy as np

from .budget import Unsupported
from .factors import Multiplied, is_pose
from .values import Instance, Module, Unknown, is_number, items_of, number_of, plain

__all__ = ["binary", "compared", "indexed", "power", "truth", "unary"]

OPERATORS = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.BitAnd: operator.and_,
    ast.BitOr: operator.or_,
}
COMPARED = {
    ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt, ast.GtE: operator.ge,
    ast.Eq: operator.eq, ast.NotEq: operator.ne,
}  # fmt: skip
MOST_REPEATED = 512
HIGHEST = 64
BEGINNING = re.compile(r"(?:T|H|M|tf|[a-z_]*(?:base|world|total|result)[a-z_]*)$", re.IGNORECASE)


def binary(run, kind, one, other):
    """The value of an operation."""
    if kind is ast.MatMult:
        return multiplied(run, one, other)
    if run.dialect:
        kind, one, other = run.dialect.operands(kind, one, other)
    if isinstance(one, Unknown) or isinstance(other, Unknown):
        return _with_unknown(run, kind, one, other)
    if kind is ast.Pow:
        return power(one, other)
    act = OPERATORS.get(kind)
    if act is None:
        raise Unsupported("another operator")
    if isinstance(one, str | list | tuple) and not isinstance(other, np.ndarray):
        return _of_lists(run, kind, one, other)
    if isinstance(other, str | list | tuple) and not isinstance(one, np.ndarray):
        return _of_lists(run, kind, other, one)
    if isinstance(one, Multiplied) or isinstance(other, Multiplied):
        if kind is ast.Mult and np.ndim(one) == np.ndim(other) == 2:
            return multiplied(run, one, other)
    elif is_number(one) and is_number(other):
        return _calculated(run, act, one, other)
    return _calculated(run, act, plain(one), plain(other))


def _calculated(run, act, *values):
    try:
        return run.budget.checked(act(*values))
    except (ArithmeticError, TypeError, ValueError):
        raise Unsupported("no such operation") from None


def _of_lists(run, kind, held, other):
    if kind is ast.Add and type(held) is type(other):
        return run.budget.checked(held + other)
    if kind is ast.Mult and isinstance(other, int) and len(held) * other <= MOST_REPEATED:
        return held * other
    if kind is ast.Mod and isinstance(held, str):
        return held
    raise Unsupported("no such operation")


def power(one, other):
    """A power with a small exponent."""
    one, other = (
        value if isinstance(value, np.ndarray) else number_of(value) for value in (one, other)
    )
    if np.max(np.abs(other), initial=0) > HIGHEST or np.max(np.abs(one), initial=0) > 1e6:
        raise Unsupported("too large")
    try:
        return np.power(np.asarray(one, dtype=float), other)[()]
    except (ArithmeticError, TypeError, ValueError):
        raise Unsupported("no such operation") from None


def _with_unknown(run, kind, one, other):
    """What is calculated with something unknown: again that, or numbers for its items."""
    run.factors.spoil(one, other)
    if is_pose(one) or is_pose(other):
        return run.unknown("product")
    act = power if kind is ast.Pow else OPERATORS.get(kind)
    if act is None or isinstance(one, str) or isinstance(other, str):
        return run.unknown("text")
    if isinstance(one, Unknown) and isinstance(other, Unknown):
        return _calculated(run, act, one.number(), other.number())
    held, free = (other, one) if isinstance(one, Unknown) else (one, other)
    if isinstance(held, list | tuple | np.ndarray) and np.ndim(plain(held)):
        values = plain(held)
        flat = (
            values.ndim == 2 and 1 in values.shape
        )  # a column beside a column, a row beside a row
        items = plain(free.items(values.size if flat else len(values)))
        items = items.reshape(values.shape) if flat else items
        pair = (items, values) if held is other else (values, items)
        return _calculated(run, act, *pair)
    if not is_number(held):
        raise Unsupported("no such operation")
    if held is other:
        return free.mapped(lambda value: act(value, held))
    return free.mapped(lambda value: act(held, value))


def _begins(value):
    """Whether a value is the matrix before all links, which the text does not show: T, base."""
    return isinstance(value, Unknown) and not value.steps and bool(BEGINNING.match(value.path))


def multiplied(run, one, other):
    """A product of matrices."""
    if _begins(one) and not isinstance(other, Unknown) and is_pose(other):
        return other
    if isinstance(one, Unknown) or isinstance(other, Unknown):
        run.factors.spoil(one, other)
        return run.unknown("product")
    a, b = plain(one), plain(other)
    run.budget.step(2)
    if a.shape == b.shape == (4, 4):
        result = run.factors.product(a, b)
    else:
        try:
            result = np.asarray(a) @ np.asarray(b)
        except ValueError:
            raise Unsupported("no product") from None
    kept = isinstance(one, Multiplied) or isinstance(other, Multiplied)
    return run.budget.checked(result.view(Multiplied) if kept and result.ndim == 2 else result)


def unary(run, kind, value):
    """The value of ``-x``, ``+x`` and ``not x``."""
    if kind is ast.Not:
        return not truth(value)
    if kind not in (ast.USub, ast.UAdd):
        raise Unsupported("another operator")
    act = operator.neg if kind is ast.USub else operator.pos
    if isinstance(value, Unknown):
        return value.mapped(act)
    return _calculated(run, act, value if is_number(value) else plain(value))


def truth(value):
    """Whether a value counts as true."""
    if isinstance(value, Unknown):
        return value.samples.holds(True)
    if isinstance(value, np.ndarray):
        if value.size != 1:
            raise Unsupported("no truth")
        return bool(value.reshape(-1)[0])
    return bool(value)


def compared(kind, one, other):
    """Whether a comparison holds; of what is not known, of the numbers that stand for it."""
    if kind in (ast.Is, ast.IsNot):
        return (one is other) == (kind is ast.Is)
    if kind in (ast.In, ast.NotIn):
        for value in (one, other):
            if isinstance(value, Unknown):
                return value.samples.holds(False) == (kind is ast.In)
        if not isinstance(other, list | tuple | dict | str) or isinstance(one, np.ndarray):
            raise Unsupported("not in a list")
        try:
            return (one in other) == (kind is ast.In)
        except (TypeError, ValueError):
            raise Unsupported("not in a list") from None
    act = COMPARED[kind]
    unknown = next((value for value in (one, other) if isinstance(value, Unknown)), None)
    if unknown is not None and kind in (ast.Eq, ast.NotEq):
        return unknown.samples.holds(False) == (kind is ast.Eq)
    if any(isinstance(value, str) or value is None for value in (one, other)):
        if kind not in (ast.Eq, ast.NotEq):
            raise Unsupported("no comparison")
        same = type(one) is type(other) and one == other
        return same == (kind is ast.Eq)
    if isinstance(one, list | tuple | dict) and isinstance(other, type(one)):
        one, other = plain(list(one)), plain(list(other))
        return bool(one.shape == other.shape and act(one, other).all())
    values = [v.number() if isinstance(v, Unknown) else v for v in (one, other)]
    if not all(is_number(v) or isinstance(v, np.ndarray) for v in values):
        raise Unsupported("no comparison")
    try:
        return act(*values)
    except ValueError:
        raise Unsupported("no comparison") from None


def indexed(value, key):
    """What stands in a list, an array or a dictionary."""
    if isinstance(value, Unknown):
        return _in_unknown(value, key)
    if isinstance(value, Module):
        raise Unsupported("no item")
    try:
        if isinstance(value, dict):
            return value[key]
        if isinstance(value, np.ndarray):
            found = value[whole(key)]
            return found.item() if np.ndim(found) == 0 else found
        if isinstance(value, Instance):
            return items_of(value)[whole(key)]
        if isinstance(value, list) and isinstance(key, tuple):  # C#: m[i, j]
            for one in key:
                value = value[whole(one)]
            return value
        if isinstance(value, list | tuple | str):
            return value[whole(key)]
    except (IndexError, KeyError, TypeError, ValueError):
        raise Unsupported("no such item") from None
    raise Unsupported("no items")


def whole(key):
    """An index as numpy takes it."""
    if isinstance(key, tuple):
        return tuple(whole(one) for one in key)
    if isinstance(key, slice):
        parts = (key.start, key.stop, key.step)
        return slice(*(None if one is None else whole(one) for one in parts))
    if key is None or key is Ellipsis or isinstance(key, bool):
        return key
    if isinstance(key, list | np.ndarray):
        found = plain(key)
        return found if found.dtype.kind == "b" else found.astype(int)
    if isinstance(key, Unknown):
        raise Unsupported("which one is not known")
    number = number_of(key)
    if number != int(number):
        raise Unsupported("no index")
    return int(number)


def _in_unknown(value, key):
    if isinstance(key, slice):
        start, stop = whole(key.start or 0), key.stop
        count = value.samples.many() if stop is None or whole(stop) < 0 else whole(stop)
        count += 0 if stop is None or whole(stop) >= 0 else whole(stop)
        return [value.item(f"[{k}]") for k in range(start, count, whole(key.step or 1))]
    if isinstance(key, tuple):
        if any(one == slice(None) for one in key if isinstance(one, slice)):
            return value  # the whole of q[:, 0]
        for one in key:
            value = _in_unknown(value, one)
        return value
    if isinstance(key, str):
        return value.item(f"[{key!r}]")
    if isinstance(key, list | np.ndarray):
        return [_in_unknown(value, one) for one in plain(key).astype(int).tolist()]
    index = whole(key)
    if index < 0:
        index += value.samples.many()
    return value.item(f"[{index}]")
