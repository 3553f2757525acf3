"""What languages with braces have otherwise than Python, for the interpreter of their programs."""

import ast
import math
import re

import numpy as np

from ......rotations import from_rotation_vectors
from ...held.budget import Unsupported
from ...held.factors import Multiplied, is_pose
from ...held.operators import indexed, whole
from ...held.values import Instance, Module, Native, Unknown, items_of, number_of, plain
from ...library.functions import FUNCTIONS
from .objects import asked, place_of

__all__ = ["Braces"]

LARGEST = 16
VECTOR = re.compile(r"(?:^|[._])(?:q|th|theta|joint|angle)s?(?:_\w*|\[\d+\])?$", re.IGNORECASE)
SPACES = ("THREE", "THREE.MathUtils", "Matrix4x4", "UnityEngine", "Eigen")  # of names


class Braces:
    """The dialect: a matrix may be indexed in round brackets, ``*`` is the product of matrices."""

    def __init__(self):
        self.structs: list = []

    def attribute(self, run, value, name):
        """What stands behind a dot; None where it does as in Python."""
        if isinstance(value, Module) or (isinstance(value, Unknown) and value.path in SPACES):
            if value == Unknown("Matrix4x4", run.samples) and name == "identity":
                return np.eye(4).view(Multiplied)
            return NAMES.get(name)
        if value is run.me and name not in value.attributes:  # its class is not kept
            return run.scope.names.get(name)
        return asked(run, value, name, self.structs)

    def set_attribute(self, held, name, value):
        """Whether a place of a matrix, m.m03, was set."""
        place = place_of(name)
        if isinstance(held, np.ndarray) and held.shape == (4, 4) and place:
            held[place] = number_of(value)
            return True
        return False

    def listed(self, value):
        """What a loop goes over, as in Python."""
        return None

    def from_one(self, key):
        """An index, which counts from zero."""
        return key

    def name(self, name, scope):
        """What a name is that the program does not define; None of others."""
        return Module("math") if name in ("Math", "Mathf", "MathF") else NAMES.get(name)

    def is_index(self, held, args):
        """Whether round brackets behind a value are an index."""
        numbers = 0 < len(args) < 3 and all(type(one) is int for one in args)
        if isinstance(held, Unknown):  # q(0), and no readAngle(0)
            return numbers and bool(VECTOR.search(held.path))
        return numbers and isinstance(held, np.ndarray | list)

    def picked(self, held, args):
        """``value(i, j)``."""
        return indexed(held, tuple(args) if len(args) > 1 else args[0])

    def key(self, held, key):
        """Where a value is stored."""
        if isinstance(held, np.ndarray) and held.ndim == 2 and isinstance(key, int):
            return (key, 0) if held.shape[1] == 1 else key
        return key

    def prepare(self, name, target, scope):
        """A matrix that is set place by place begins as zeros."""
        held = scope.find(name)
        if isinstance(held, dict) and not held and isinstance(target.slice, ast.Tuple):
            scope.put(name, np.zeros((4, 4)).view(Multiplied))

    def prepare_record(self, run, target, scope):
        """A record of a list is there before its fields are set."""

    def operands(self, kind, one, other):
        """The operation and its operands as Python has them; ``*`` of two matrices that are lists
        is the program's own operator.
        """
        if kind is ast.Mult and isinstance(one, list) and is_pose(one) and is_pose(other):
            return kind, plain(one).view(Multiplied), plain(other).view(Multiplied)
        return kind, one, other


def _filled(run, args, _):
    """The matrix, or the column, that ``T << 1, 0, …`` fills."""
    try:
        numbers = plain(args[0]).reshape(-1)
    except Unsupported:
        parts = [plain(one).reshape(-1) for one in args[0]]
        numbers = np.concatenate(parts)
    side = math.isqrt(numbers.size)
    square = side in (3, 4) and side * side == numbers.size
    return numbers.reshape(side, side).view(Multiplied) if square else numbers


def _new(run, args, _):
    """An array of zeros, as lists; something empty without sizes."""
    if not args:
        return {}
    sizes = [run.samples.length if isinstance(one, Unknown) else whole(one) for one in args]
    if any(not 0 <= one <= LARGEST for one in sizes):
        raise Unsupported("too large an array")
    made = np.zeros(sizes).tolist()
    run.budget.step(int(np.prod(sizes)) // 16)
    return made


def _product(run, args, _):
    return FUNCTIONS["dot"].call(run, args, {})


def _identity(run, args, _):
    return np.eye(4).view(Multiplied)


def _into(run, args, _):
    """Fill the matrix that a function was given to fill."""
    held, value = args
    if not isinstance(held, np.ndarray) or held.shape != (4, 4):
        raise Unsupported("no matrix")
    held[...] = plain(value).reshape(4, 4)


def _zero(run, args, _):
    return np.zeros((4, 4)).view(Multiplied)


def _pushed(run, args, _):
    held = items_of(args[0]) if not isinstance(args[0], dict) else []
    return [*held, *args[1:]]


def _struct(run, args, _):
    if tuple(args[0]) not in run.dialect.structs:
        run.dialect.structs.append(tuple(args[0]))


def _placed(run, args, _):
    """A list of which each item says its place."""
    found: list = [0] * (1 + max(whole(place) for place, _ in args[0]))
    for place, value in args[0]:
        found[whole(place)] = value
    return run.budget.checked(found)


def _copied(run, args, _):
    """``memcpy``: a list is filled with what stands in another."""
    if not isinstance(args[0], list):
        raise Unsupported("no array")
    args[0][:] = FUNCTIONS["copy"].call(run, args[1:2], {})


def _turned(run, args, _):
    """Eigen's AngleAxis: an angle about an axis."""
    T = np.eye(4)
    T[:3, :3] = from_rotation_vectors(number_of(args[0]) * plain(args[1]).reshape(3))
    return T.view(Multiplied)


def _moved(run, args, _):
    return FUNCTIONS["transl"].call(run, args, {}).view(Multiplied)


def _given(run, args, _):
    return args[0]


def _vector(run, args, _):
    return [number_of(one) for one in args]


def _record(run, args, _):
    return Instance(None, dict(args[0]), "record")


NAMES: dict = {
    "_record": _record, "_struct": _struct, "Vector4": _vector, "Matrix4": _identity,
    "_filled": _filled, "_into": _into, "_new": _new, "multiply": _product, "Identity": _identity,
    "_placed": _placed, "memcpy": _copied, "Vector3d": _vector, "Vector3f": _vector,
    **{f"AngleAxis{kind}": _turned for kind in "df"},
    **{f"Translation3{kind}": _moved for kind in "df"},
    **{f"{name}3{kind}": _given for name in ("Affine", "Isometry") for kind in "df"},
    **{f"Unit{axis}": lambda *_, k=k: np.eye(3)[k] for k, axis in enumerate("XYZ")},
    "setIdentity": _identity, "Zero": _zero, "_pushed": _pushed, "matmul": _product,
    **{f"{name}f": FUNCTIONS[name].call for name in ("sin", "cos", "tan", "sqrt", "fabs")},
    **{name: FUNCTIONS[name.lower()].call for name in ("Cos", "Sin", "Tan", "Sqrt")},
    "toRadians": FUNCTIONS["radians"].call, "degToRad": FUNCTIONS["radians"].call,
}  # fmt: skip
NAMES = {
    **{name: Native(name, call) for name, call in NAMES.items()},
    "Deg2Rad": math.pi / 180, "Rad2Deg": 180 / math.pi,
    "M_PI_2": math.pi / 2, "M_PI_4": math.pi / 4, "M_PIf": math.pi,
}  # fmt: skip
