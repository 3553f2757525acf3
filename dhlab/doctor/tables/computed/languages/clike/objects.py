"""What languages with braces ask of their matrices and records: three.js, Unity, structs."""

import re

import numpy as np

from ...held.budget import Unsupported
from ...held.factors import Multiplied
from ...held.operators import multiplied, whole
from ...held.values import Native, Unknown, items_of, plain

__all__ = ["asked", "place_of"]

PLACE = re.compile(r"[mM]_?(\d)(\d)$")


def asked(run, value, name, structs):
    """What stands behind the dot of a matrix or a list; None where Python knows it, or nobody.

    Parameters
    ----------
    structs : list of tuple of str
        The fields of the program's records, of which a list may be one.
    """
    over = EACH.get(name) if isinstance(value, list | Unknown) else None
    if over:
        return Native(name, lambda run, args, _: over(run, items_of(value), *args))
    if isinstance(value, list):
        if name in ("length", "Length", "Count"):
            return len(value)
        fields = next((one for one in structs if name in one and len(value) <= len(one)), None)
        at = fields.index(name) if fields else len(value)
        return value[at] if at < len(value) else None
    if isinstance(value, Unknown):
        many = name in ("length", "Length", "Count")
        return value.samples.many() if many else _declared(run, value, name, structs)
    if not isinstance(value, np.ndarray) or value.shape != (4, 4):
        return None
    if place := place_of(name):
        return float(value[place])
    act = MATRIX.get(name)
    return None if act is None else Native(name, lambda run, args, _: act(run, value, args))


def _declared(run, value, name, structs):
    """The number that a record's field has from its declaration, where a function is given the
    record; None of joints' values, and of what is put into it.
    """
    held = run.scope.names.get(name)
    changed = (value.place, f"{value.path}.{name}") in value.samples.stored
    if changed or run.is_joint(name) or sum(name in fields for fields in structs) != 1:
        return None
    return held if type(held) in (int, float) else None


def place_of(name):
    """The row and the column of a field of a matrix; None of another name.

    Examples
    --------
    >>> place_of("m03"), place_of("mass")
    ((0, 3), None)
    """
    found = PLACE.match(name)
    return (int(found[1]), int(found[2])) if found and max(found[1], found[2]) < "4" else None


def _called(run, function, *args):
    """The value of a function that takes as many of these arguments as it has parameters."""
    node = getattr(function, "node", None)
    return run.call(function, list(args[: len(node.args.args)] if node else args[:1]), {})


def _mapped(run, items, function):
    return [_called(run, function, item, k) for k, item in enumerate(items)]


def _folded(run, items, function, *start):
    value, *items = [*start, *items]
    for k, item in enumerate(items, 1 - len(start)):
        value = _called(run, function, value, item, k)
    return value


def _numbered(run, items):
    return [[k, item] for k, item in enumerate(items)]


def _beside(run, items, other):
    return [list(pair) for pair in zip(items, items_of(other))]


def _into(value, found):
    value[...] = found
    return value


def _set(run, value, args):
    if len(args) != 16:
        raise Unsupported("no matrix")
    return _into(value, plain(args).reshape(4, 4))


def _row(run, value, args):
    numbers = plain(args[1]).reshape(-1)
    if numbers.size != 4:
        raise Unsupported("no row")
    value[whole(args[0])] = numbers


def _column(run, value, args):
    numbers = plain(args[1]).reshape(-1)
    if numbers.size != 4:
        raise Unsupported("no column")
    value[:, whole(args[0])] = numbers


def _times(run, value, args):
    return _into(value, multiplied(run, value, args[0]))


def _before(run, value, args):
    return _into(value, multiplied(run, args[0], value))


def _of_two(run, value, args):
    return _into(value, multiplied(run, args[0], args[1]))


def _identity(run, value, args):
    return _into(value, np.eye(4))


def _turn(run, value, args):
    return value[:3, :3].copy()


def _part(run, value, args):
    return run.unknown("part")


def _copy(run, value, args):
    return value.copy().view(Multiplied)


EACH = {
    "entries": _numbered,
    "map": _mapped,
    "Select": _mapped,
    "forEach": _mapped,
    "reduce": _folded,
    "Zip": _beside,
}
MATRIX = {
    "set": _set, "SetRow": _row, "SetColumn": _column, "multiply": _times, "premultiply": _before,
    "multiplyMatrices": _of_two, "identity": _identity, "clone": _copy,
    "toRotationMatrix": _turn, "matrix": _copy,
    **dict.fromkeys(("GetColumn", "GetRow", "GetPosition", "MultiplyPoint", "MultiplyPoint3x4",
                     "MultiplyVector", "ToString", "toString", "eulerAngles"), _part),
}  # fmt: skip
