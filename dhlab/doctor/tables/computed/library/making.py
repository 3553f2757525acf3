"""Functions that make arrays: ``array``, ``eye``, ``block``, and the elementary moves."""

import numpy as np

from ..held.budget import MOST_ITEMS, Unsupported
from ..held.factors import Multiplied
from ..held.operators import multiplied, whole
from ..held.values import Unknown, is_number, items_of, number_of, plain

__all__ = ["MAKERS", "as_array"]


def as_array(run, args, kwargs):
    """An array of numbers; what is not known, and lists with texts, stay as they are."""
    value = args[0] if args else kwargs.get("object")
    if isinstance(value, Unknown):
        return value.copied(run.ticket())
    if isinstance(value, np.ndarray):
        return value.copy()
    try:
        return run.budget.checked(plain(value))
    except Unsupported:
        if isinstance(value, list | tuple) and _has_texts(value):
            return list(value)
        raise


def _has_texts(value):
    return any(
        isinstance(one, str | None.__class__)
        or (isinstance(one, list | tuple) and any(isinstance(item, str) for item in one))
        for one in value
    )


def _matrix(run, args, kwargs):
    """A matrix for which ``*`` is the product; SymPy's from numbers of rows, columns and a list."""
    if len(args) >= 3 and not callable(args[2]):
        made = plain(args[2]).reshape(whole(args[0]), whole(args[1]))
    else:
        made = as_array(run, args, kwargs)
    if not isinstance(made, np.ndarray):
        return made
    return (made.reshape(-1, 1) if made.ndim == 1 else made).view(Multiplied)


def _shape(run, args, kwargs):
    given = args[0] if args else kwargs.get("shape", kwargs.get("N"))
    given = list(given) if isinstance(given, list | tuple) else [given]
    if len(args) > 1 and not isinstance(args[0], list | tuple) and isinstance(args[1], int):
        given.append(args[1])  # sympy.zeros(3, 3)
    sizes = [one.samples.many() if isinstance(one, Unknown) else whole(one) for one in given]
    if any(one < 0 for one in sizes) or np.prod([float(one) for one in sizes]) > MOST_ITEMS:
        raise Unsupported("too large an array")
    run.budget.step(int(np.prod(sizes)) // 16)
    return tuple(sizes)


def _filled(number):
    return lambda run, args, kwargs: np.full(_shape(run, args, kwargs), number)


def _full(run, args, kwargs):
    return np.full(_shape(run, args[:1], kwargs), number_of(args[1]), dtype=float)


def _unit(run, args, kwargs):
    return np.eye(_shape(run, args[:1], kwargs)[0])


def _like(number):
    def call(run, args, _):
        return number if is_number(args[0]) else np.full(plain(args[0]).shape, number)

    return call


def _stacked(act):
    def call(run, args, kwargs):
        parts = items_of(args[0])
        axis = kwargs.get("axis", args[1] if len(args) > 1 else None)
        parts = [plain(one) for one in parts]
        try:
            found = act(parts) if axis is None else act(parts, axis=whole(axis))
        except (TypeError, ValueError):
            raise Unsupported("no such array") from None
        return run.budget.checked(found)

    return call


def _block(run, args, _):
    rows = [[plain(one) for one in items_of(row)] for row in items_of(args[0])]
    try:
        return run.budget.checked(np.block(rows))
    except ValueError:
        raise Unsupported("no such array") from None


def _diagonal(run, args, _):
    value = plain(args[0] if len(args) == 1 else list(args))
    if value.size > 16:
        raise Unsupported("too large an array")
    return np.diag(value)


def _linspace(run, args, kwargs):
    raise Unsupported("many values of one joint")


def _arange(run, args, _):
    found = range(*(whole(one) for one in args))
    if len(found) > MOST_ITEMS:
        raise Unsupported("too large an array")
    return np.arange(*(whole(one) for one in args)).astype(float)


def _turn(axis):
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]

    def call(run, args, kwargs):
        angle = number_of(args[0])
        if "deg" in (*args[1:], kwargs.get("unit")):
            angle = np.deg2rad(angle)
        T = np.eye(4)
        T[[i, i, j, j], [i, j, i, j]] = np.cos(angle), -np.sin(angle), np.sin(angle), np.cos(angle)
        return T

    return call


def _moved(run, args, _):
    T = np.eye(4)
    T[:3, 3] = plain(list(args) if len(args) == 3 else args[0]).reshape(3)
    return T


def _summed(run, args, _):
    """``einsum`` of two matrices, where it is their product."""
    if str(args[0]).replace(" ", "") not in ("ij,jk->ik", "ij,jk"):
        raise Unsupported("another sum")
    return multiplied(run, args[1], args[2])


def _axis_moved(run, args, _):
    return np.moveaxis(plain(args[0]), whole(args[1]), whole(args[2]))


def _from_euler(run, args, kwargs):
    """SciPy's Rotation of one angle about one axis."""
    turn = _turn(str(args[0]).lower())
    unit = ["deg"] if len(args) > 2 or "degrees" in kwargs else []
    return turn(run, [args[1], *unit], {})[:3, :3].view(Multiplied)


MAKERS = {
    "array": as_array, "asarray": as_array, "tensor": as_array, "asanyarray": as_array,
    "matrix": _matrix, "mat": _matrix, "asmatrix": _matrix, "Matrix": _matrix,
    "zeros": _filled(0.0), "ones": _filled(1.0), "empty": _filled(0.0), "full": _full,
    "eye": _unit, "identity": _unit, "zeros_like": _like(0.0), "ones_like": _like(1.0),
    "block": _block, "vstack": _stacked(np.vstack), "hstack": _stacked(np.hstack),
    "column_stack": _stacked(np.column_stack), "concatenate": _stacked(np.concatenate),
    "stack": _stacked(np.stack), "diag": _diagonal, "linspace": _linspace, "arange": _arange,
    "r_": as_array, "row_stack": _stacked(np.vstack),
    "from_euler": _from_euler, "einsum": _summed, "moveaxis": _axis_moved, "from_matrix": _matrix,
    "trotx": _turn("x"), "troty": _turn("y"), "trotz": _turn("z"), "transl": _moved,
}  # fmt: skip
