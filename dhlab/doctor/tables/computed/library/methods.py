"""What can be asked of lists, dictionaries, texts, arrays and objects."""

import numpy as np

from ..held.budget import Unsupported
from ..held.factors import Multiplied
from ..held.operators import multiplied, whole
from ..held.values import (
    Class,
    Function,
    Instance,
    Method,
    Module,
    Native,
    Unknown,
    items_of,
    plain,
)  # fmt: skip
from .functions import CONSTANTS, FUNCTIONS, LIBRARIES
from .symbols import substituted

__all__ = ["attribute", "from_library"]

SAME = {
    "copy", "evalf", "simplify", "doit", "astype", "round", "n", "expand", "as_mutable", "float",
    "as_immutable", "numpy", "cpu", "detach", "double", "view", "__copy__", "clone", "trigsimp",
    "as_explicit", "rewrite", "as_matrix", "as_dcm",
}  # fmt: skip
NO_MATTER = {"sort", "setflags"}


def from_library(name, module=""):
    """What a name is in the list of functions; None where it is not in it."""
    if name == "Rotation":
        return Module("scipy")
    if name in FUNCTIONS:
        return FUNCTIONS[name]
    if name in CONSTANTS and (module or name in ("pi", "PI")):
        return CONSTANTS[name]
    return None


def attribute(run, value, name):
    """What stands behind a dot."""
    if isinstance(value, Unknown):
        return _of_unknown(run, value, name)
    if isinstance(value, Native) and value.name in LIBRARIES:  # copy.deepcopy, without its import
        value = Module(value.name)
    if isinstance(value, Module):
        found = from_library(name, value.name) if value.name in LIBRARIES else None
        if found is None and value.name in LIBRARIES and name in LIBRARIES:
            return Module(name)
        return Unknown(f"{value.name}.{name}", run.samples) if found is None else found
    if isinstance(value, Instance):
        return _of_instance(run, value, name)
    if isinstance(value, Class):
        found = value.find(name)
        if found is None:
            raise Unsupported("no such attribute")
        return Method(found, value) if getattr(found, "kind", "") == "classmethod" else found
    act = _method(run, value, name)
    if act is not None:
        return Native(name, act)
    return _property(value, name)


def _of_unknown(run, value, name):
    if name in ("shape", "size"):
        return (value.samples.many(),) if name == "shape" else value.samples.many()
    if name in SAME or name in ("flatten", "ravel", "tolist", "reshape", "T", "squeeze"):
        return value if name == "T" else Native(name, lambda *_: value.copied(run.ticket()))
    if name == "subs":
        return Native(name, lambda run, args, _: substituted(run, value, args))
    return value.item(f".{name}")


def _of_instance(run, value, name):
    if name in value.attributes:
        return value.attributes[name]
    if name == "__class__":
        return value.cls
    found = value.cls.find(name) if value.cls else None
    if found is None:
        return Unknown(f"{value.path}.{name}", run.samples)
    if isinstance(found, Function):
        if found.kind == "property":
            return run.call(Method(found, value), [], {})
        return found if found.kind == "staticmethod" else Method(found, value)
    return found


def _property(value, name):
    if isinstance(value, np.ndarray | list | tuple):
        array = value
        if name == "T":
            return plain(array).T
        if name == "shape":
            return tuple(plain(array).shape)
        if name == "size":
            return int(plain(array).size)
        if name == "ndim":
            return int(plain(array).ndim)
        if name == "rows":
            return int(plain(array).shape[0])
        if name == "cols":
            return int(plain(array).shape[1])
    raise Unsupported("no such attribute")


def _method(run, value, name):
    """The function behind the name of a method; None without one."""
    kind = (
        "list" if isinstance(value, list) else "dict" if isinstance(value, dict)
        else "array" if isinstance(value, np.ndarray) else "text" if isinstance(value, str)
        else "number"
    )  # fmt: skip
    if name in SAME and not (name == "n" and kind != "array"):
        return lambda run, args, _: FUNCTIONS["copy"].call(run, [value], {})
    if name == "subs":
        return lambda run, args, _: substituted(run, value, args)
    act = METHODS[kind].get(name)
    return None if act is None else lambda run, args, kwargs: act(run, value, args, kwargs)


def _append(run, value, args, _):
    run.budget.checked(value)
    value.append(args[0])


def _extend(run, value, args, _):
    value.extend(items_of(args[0]))
    run.budget.checked(value)


def _insert(run, value, args, _):
    value.insert(whole(args[0]), args[1])
    run.budget.checked(value)


def _pop(run, value, args, _):
    try:
        return value.pop(*(whole(one) for one in args))
    except IndexError:
        raise Unsupported("nothing to take") from None


def _pop_key(run, value, args, _):
    return value.pop(args[0], *args[1:2])


def _reverse(run, value, args, _):
    value.reverse()


def _got(run, value, args, _):
    return value.get(args[0], args[1] if len(args) > 1 else None)


def _update(run, value, args, kwargs):
    value.update(args[0] if args and isinstance(args[0], dict) else {}, **kwargs)


def _set_default(run, value, args, _):
    return value.setdefault(args[0], args[1] if len(args) > 1 else None)


def _dot(run, value, args, _):
    return multiplied(run, value, args[0])


def _reshape(run, value, args, _):
    shape = args[0] if len(args) == 1 and isinstance(args[0], list | tuple) else args
    try:
        return value.reshape(tuple(whole(one) for one in shape))
    except ValueError:
        raise Unsupported("no such shape") from None


def _inverse(run, value, args, _):
    return FUNCTIONS["inv"].call(run, [value], {})


def _row_joined(act):
    def call(run, value, args, _):
        other = plain(args[0])
        try:
            return act([value, other.reshape(-1, 1) if other.ndim == 1 else other]).view(Multiplied)
        except ValueError:
            raise Unsupported("no such array") from None

    return call


def _joined(run, value, args, _):
    return value


def _split(run, value, args, _):
    return run.budget.checked(value.split(*args[:1]))


METHODS: dict = {
    "list": {
        "append": _append, "extend": _extend, "insert": _insert, "pop": _pop, "reverse": _reverse,
        "clear": lambda run, value, args, _: value.clear(),
        "tolist": lambda run, value, args, _: value,
        "size": lambda run, value, args, _: len(value),
        "index": lambda run, value, args, _: value.index(args[0]),
    },
    "dict": {
        "get": _got, "items": lambda run, value, args, _: list(value.items()), "update": _update,
        "keys": lambda run, value, args, _: list(value), "pop": _pop_key,
        "values": lambda run, value, args, _: list(value.values()), "setdefault": _set_default,
    },
    "array": {
        "dot": _dot, "tolist": lambda run, value, args, _: value.tolist(), "reshape": _reshape,
        "flatten": lambda run, value, args, _: np.asarray(value).reshape(-1).copy(),
        "ravel": lambda run, value, args, _: np.asarray(value).reshape(-1),
        "squeeze": lambda run, value, args, _: np.asarray(value).squeeze(),
        "transpose": lambda run, value, args, _: value.T if not args else _no_such(),
        "inv": _inverse, "inverse": _inverse,
        "head": lambda run, value, args, _: np.asarray(value).reshape(-1)[: whole(args[0])],
        "col": lambda run, value, args, _: value[:, whole(args[0])],
 "multiply": _dot, "row_join": _row_joined(np.hstack),
        "col_join": _row_joined(np.vstack), "item": lambda run, value, args, _: value.item(),
        "applyfunc": lambda run, value, args, _: value, "__matmul__": _dot,
        "sum": lambda run, value, args, _: float(value.sum()) if not args else _no_such(),
        "fill": lambda run, value, args, _: value.fill(args[0]),
    },
    "text": {
        "format": _joined, "join": _joined, "strip": lambda run, value, args, _: value.strip(),
        "lower": lambda run, value, args, _: value.lower(), "split": _split,
        "upper": lambda run, value, args, _: value.upper(),
        "startswith": lambda run, value, args, _: value.startswith(args[0]),
        "endswith": lambda run, value, args, _: value.endswith(args[0]),
    },
    "number": {},
}  # fmt: skip


def _no_such():
    raise Unsupported("not known")
