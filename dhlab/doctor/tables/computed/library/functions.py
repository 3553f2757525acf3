"""What programs of strangers may call: a closed list of functions of Python, numpy, SymPy."""

import ast
import math

import numpy as np

from ..held.budget import Unsupported
from ..held.factors import Multiplied, is_pose
from ..held.operators import binary, compared, multiplied, power, truth, whole
from ..held.values import Class, Instance, Native, Unknown, is_number, items_of, number_of, plain
from .making import MAKERS, as_array
from .symbols import SYMBOLS
from .toolbox import LINKS

__all__ = ["CONSTANTS", "FUNCTIONS", "LIBRARIES"]

LIBRARIES = {
    "np", "numpy", "math", "Math", "sp", "sympy", "sym", "cmath", "functools", "itertools", "copy",
    "jnp", "jax", "torch", "linalg", "ca", "casadi", "cs", "anp", "autograd", "cp", "mpmath", "smp",
    "sy", "rtb", "roboticstoolbox", "scipy",
}  # fmt: skip
CONSTANTS = {
    "pi": math.pi,
    "PI": math.pi,
    "tau": 2 * math.pi,
    "e": math.e,
    "inf": 1e14,
    "newaxis": None,
}
MOST_RANGE = 256

ELEMENTWISE = {
    **{name: getattr(np, name) for name in (
        "sin", "cos", "tan", "arcsin", "arccos", "arctan", "sqrt", "exp", "log", "abs", "fabs",
        "deg2rad", "rad2deg", "radians", "degrees", "sign", "negative", "floor", "ceil", "square",
    )},
    "asin": np.arcsin, "acos": np.arccos, "atan": np.arctan, "rad": np.radians, "Abs": np.abs,
    "absolute": np.abs,
}  # fmt: skip
SAME = (  # what shows a value otherwise, and does not change it
    "float", "round", "around", "round_", "simplify", "N", "nsimplify", "trigsimp", "expand",
    "float64", "float32", "copy", "deepcopy", "real", "sympify", "S", "Float", "squeeze",
    "ascontiguousarray", "Integer", "factor", "cancel", "together", "nan_to_num", "radsimp",
    "frozenset", "set", "ImmutableMatrix", "iter", "powsimp", "evalf", "vpa", "str", "repr",
)  # fmt: skip


def _elementwise(act):
    def call(run, args, _):
        value = args[0]
        if isinstance(value, Unknown):
            return value.mapped(act)
        with np.errstate(all="ignore"):
            found = act(float(value) if is_number(value) else plain(value))
        return run.budget.checked(float(found) if np.ndim(found) == 0 else found)

    return call


def _same(run, args, _):
    if args and isinstance(args[0], Unknown):
        return args[0].copied(run.ticket())
    return _copied(args[0]) if args else 0.0


def _copied(value, depth=0):
    if depth > 6:
        raise Unsupported("too deep")
    if isinstance(value, np.ndarray):
        return value.copy()
    if isinstance(value, list):
        return [_copied(item, depth + 1) for item in value]
    if isinstance(value, dict):
        return {key: _copied(item, depth + 1) for key, item in value.items()}
    return value


def _arctan2(run, args, _):
    y, x = (number_of(one) for one in args[:2])
    return math.atan2(y, x)


def _length(run, args, _):
    value = args[0]
    if isinstance(value, Unknown):
        return value.samples.many()
    if isinstance(value, Instance):
        raise Unsupported("no length")
    return len(items_of(value))


def _range(run, args, kwargs):
    ends = [one.samples.many() if isinstance(one, Unknown) else whole(one) for one in args]
    found = range(*ends)
    if len(found) > MOST_RANGE:
        raise Unsupported("too long a loop")
    return list(found)


def _zip(run, args, _):
    known = [len(items_of(one)) for one in args if not isinstance(one, Unknown)]
    return [
        tuple(row)
        for row in zip(
            *(
                one.items(min(known) if known else None)
                if isinstance(one, Unknown)
                else items_of(one)
                for one in args
            )
        )
    ]


def _enumerate(run, args, kwargs):
    start = whole(args[1] if len(args) > 1 else kwargs.get("start", 0))
    return [(k, item) for k, item in enumerate(items_of(args[0]), start)]


def _map(run, args, _):
    return [run.call(args[0], list(row), {}) for row in _zip(run, args[1:], {})]


def _reduce(run, args, _):
    items = items_of(args[1])
    items = [args[2], *items] if len(args) > 2 else items
    result = items[0]
    for item in items[1:]:
        result = run.call(args[0], [result, item], {})
    return result


def _accumulate(run, args, _):
    items = items_of(args[0])
    found = items[:1]
    for item in items[1:]:
        found.append(
            run.call(args[1], [found[-1], item], {})
            if len(args) > 1
            else binary(run, ast.Add, found[-1], item)
        )
    return found


def _sum(run, args, kwargs):
    if isinstance(args[0], np.ndarray):
        return (
            float(args[0].sum()) if not kwargs else args[0].sum(axis=whole(kwargs.get("axis", 0)))
        )
    result = args[1] if len(args) > 1 else kwargs.get("start", 0)
    for item in items_of(args[0]):
        result = binary(run, ast.Add, result, item)
    return result


def _chosen(kind):
    def call(run, args, _):
        items = items_of(args[0]) if len(args) == 1 else args
        found = items[0]
        for item in items[1:]:
            found = item if truth(compared(kind, item, found)) else found
        return found

    return call


def _product(run, args, _):
    return multiplied(run, args[0], args[1])


def _dot(run, args, _):
    if all(is_number(one) for one in args[:2]):
        return binary(run, ast.Mult, *args[:2])
    return multiplied(run, args[0], args[1])


def _all_products(run, args, _):
    items = items_of(args[0])
    result = items[0]
    for item in items[1:]:
        result = multiplied(run, result, item)
    return result


def _inverse(run, args, _):
    value = plain(args[0])
    if value.ndim != 2 or value.shape[0] != value.shape[1] or len(value) > 8:
        raise Unsupported("no inverse")
    try:
        return np.linalg.inv(value)
    except np.linalg.LinAlgError:
        raise Unsupported("no inverse") from None


def _norm(run, args, _):
    return float(np.linalg.norm(plain(args[0])))


def _listed(run, args, _):
    return [] if not args else list(items_of(args[0]))


def _tuple(run, args, _):
    return tuple(items_of(args[0])) if args else ()


def _dict(run, args, kwargs):
    found = dict(args[0]) if args and isinstance(args[0], dict) else {}
    if args and not isinstance(args[0], dict):
        found = dict(items_of(args[0]))
    return {**found, **kwargs}


def _integer(run, args, _):
    if args and isinstance(args[0], Unknown):
        return args[0]
    try:
        return int(number_of(args[0]))
    except (OverflowError, ValueError):
        raise Unsupported("no number") from None


def _is_a(run, args, _):
    kinds = args[1] if isinstance(args[1], tuple) else (args[1],)
    names = {getattr(kind, "name", "") for kind in kinds}
    value = args[0]
    if isinstance(value, Unknown):
        return bool(names & {"list", "tuple", "ndarray"})
    found = {
        bool: "bool", int: "int", float: "float", str: "str", list: "list", tuple: "tuple",
        dict: "dict",
    }.get(type(value), "ndarray")  # fmt: skip
    return found in names


def _clip(run, args, _):
    """An angle within its limits, or brought back between -π and π, is the same angle."""
    return args[0]


def _set(run, args, _):
    if not isinstance(args[0], Instance) or not isinstance(args[1], str):
        raise Unsupported("no attribute")
    args[0].attributes[args[1]] = args[2]


def _get(run, args, _):
    if not isinstance(args[1], str):
        raise Unsupported("no attribute")
    return run.attribute(args[0], args[1])


def _same_pose(run, args, _):
    one, other = args[:2]
    return is_pose(one) and is_pose(other) and bool(np.allclose(plain(one), plain(other)))


def _append(run, args, _):
    if isinstance(args[0], list):
        return [*args[0], args[1]]
    return np.append(plain(args[0]), plain(args[1]))


def _named_tuple(run, args, _):
    """A class with the fields that ``namedtuple`` lists."""
    names = args[1].replace(",", " ").split() if isinstance(args[1], str) else items_of(args[1])
    return Class(args[0], (), {}, list(names))


def _matrix_power(run, args, _):
    raise Unsupported("no power of matrices")


FUNCTIONS = {
    **{name: _elementwise(act) for name, act in ELEMENTWISE.items()},
    **dict.fromkeys(SAME, _same),
    **MAKERS, **SYMBOLS, **LINKS,
    "atan2": _arctan2, "arctan2": _arctan2, "len": _length, "range": _range, "zip": _zip,
    "enumerate": _enumerate, "map": _map, "reduce": _reduce, "accumulate": _accumulate, "sum": _sum,
    "max": _chosen(ast.Gt), "min": _chosen(ast.Lt), "dot": _dot, "matmul": _product,
    "mtimes": _product, "mul": _dot, "multiply_matrices": _product,
    "multi_dot": _all_products, "inv": _inverse, "pinv": _inverse, "norm": _norm,
    "list": _listed, "tuple": _tuple, "dict": _dict, "int": _integer, "isinstance": _is_a,
    "clip": _clip, "setattr": _set, "getattr": _get, "unwrap": _clip, "append": _append,
    "pow": lambda run, args, _: power(*args[:2]), "allclose": _same_pose,
    "reversed": lambda run, args, _: items_of(args[0])[::-1],
    "bool": lambda run, args, _: truth(args[0]) if args else False,
    "any": lambda run, args, _: any(truth(one) for one in items_of(args[0])),
    "all": lambda run, args, _: all(truth(one) for one in items_of(args[0])),
    "transpose": lambda run, args, _: plain(args[0]).T,
    "matrix_power": _matrix_power, "namedtuple": _named_tuple,
    "print": lambda run, args, _: None, "set_printoptions": lambda run, args, _: None,
    "display": lambda run, args, _: None, "pprint": lambda run, args, _: None,
    "init_printing": lambda run, args, _: None, "callable": lambda run, args, _: False,
    "cross": lambda run, args, _: np.cross(plain(args[0]), plain(args[1])),
    "ndarray": as_array, "hypot": lambda run, args, _: math.hypot(*map(number_of, args)),
    "Multiplied": lambda run, args, _: plain(args[0]).view(Multiplied),
}  # fmt: skip
FUNCTIONS = {name: Native(name, call) for name, call in FUNCTIONS.items()}
