"""What goes between the grader and the cage: JSON, one value a line. Numbers, text, lists, arrays,
tables and arms; never a pickle.

``encode`` runs inside the cage, on whatever a stranger made; ``decode`` runs outside and trusts
nothing. ``pack`` and ``unpack`` are for the arguments, which come from the grader. Arrays go as
their bytes, in a fifth of the time that their numbers take.
"""

import builtins
import re
from base64 import b64decode, b64encode
from collections import UserList, deque
from typing import Any

import numpy as np
from numpy import array, asarray, float64, frombuffer, generic, matrix, ndarray

__all__ = ["encode", "decode", "pack", "unpack", "error_name", "Opaque", "DECODED"]

DEEPEST = 6  # lists in lists
LONGEST = 100_000  # numbers of an array
TEXT = 400  # characters
DTYPES = {"f2", "f4", "f8", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8", "b1"}
# what decode raises for what is not of this form
DECODED = (ValueError, TypeError, KeyError, AttributeError, OverflowError, RecursionError)
NUMBERS = frozenset({int, float, bool})
PACKED = "f8"  # of the answers only these, which most are
WHOLE = 2**63  # a larger number is sent as a float
# types that are told by name; any other name may be a stranger's
TYPES = frozenset(
    """an answer too large to send|an array too large to send|Arm|DHTable|DataFrame|Decimal|
    Fraction|NoneType|PlacedArm|Rotation|Series|Symbol|builtin_function_or_method|complex|function|
    generator|method|module|module_that_is_not_there|ndarray|
    recarray""".replace("\n    ", "").split("|")
)


class Opaque:
    """An answer that is no number, text, list or table; only the name of its type came out of the
    cage.
    """

    def __repr__(self) -> str:
        return f"a thing of the type {type(self).__name__}"


def encode(value: Any, depth: int = 0) -> Any:
    """A value as something that JSON can hold.

    Examples
    --------
    >>> encode([1, 2.5, ..., np.array([1.0]), np.array([1])])
    [1, 2.5, {'...': 1}, {'packed': ['f8', [1], 'AAAAAAAA8D8=']}, {'array': ['i8', [1], [1]]}]
    """
    try:
        return _encoded(value, depth)
    except Exception:
        return {"other": _type_name(value)}


def _encoded(value, depth):
    kind = type(value)
    if value is None or kind is bool or kind is float:
        return value
    if value is Ellipsis:
        return {"...": 1}
    if kind is int:
        return value if -WHOLE < value < WHOLE else float(value)
    if isinstance(value, str):
        return str.__str__(value)[:TEXT]
    if kind is matrix:  # of which a row is a vector to the judge, as to the check
        return {"matrix": _array(value)}
    if depth < DEEPEST:
        if (entries := _entries(value)) is not None and len(entries) <= LONGEST:
            return [_encoded(entry, depth + 1) for entry in entries]
        if isinstance(value, dict) and dict.__len__(value) <= LONGEST:
            return {
                "dict": [
                    [_encoded(key, depth + 1), _encoded(entry, depth + 1)]
                    for key, entry in dict.items(value)
                ]
            }
    return _table(value) or _array(value)


def _entries(value):
    """The entries of what holds several things in their order and is more than numbers; of anything
    else None. What somebody's own kind of list says of itself does not matter.
    """
    if isinstance(value, list):
        return [*list.__iter__(value)]
    if isinstance(value, tuple):
        return [*tuple.__iter__(value)]
    if isinstance(value, (deque, UserList)):
        return [*value]
    return value.tolist() if isinstance(value, ndarray) and value.ndim and _texts(value) else None


def _texts(numbers):
    """Whether something in an array is no number."""
    if numbers.dtype.kind != "O":
        return numbers.dtype.kind == "U"
    try:
        numbers.astype(float64)
    except (TypeError, ValueError):
        return True
    return False


def _table(value):
    if not type(value).__module__.startswith("dhlab."):
        return None
    from dhlab.arm import Arm
    from dhlab.geometry.procedure.frames import PlacedArm
    from dhlab.table import DHTable

    kind = type(value)
    if kind is DHTable:
        return {"table": [value.convention, _array(value.rows), str(value.joints)]}
    if kind is Arm or kind is PlacedArm:
        parts = [_array(part) for part in (value.base, value.tool, value.sign)]
        coupling = None if value.coupling is None else _array(value.coupling)
        return {"arm": [_table(value.table), *parts, coupling, bool(value.source)]}
    return None


def _array(value):
    """An array, a numpy number, or anything that numpy takes for numbers; otherwise only the type's
    name.
    """
    if isinstance(value, (str, bytes)):
        return {"other": _type_name(value)}
    numbers = array(value) if isinstance(value, (ndarray, generic)) else asarray(value)
    numbers = numbers.view(ndarray)
    if numbers.dtype.kind == "O" or numbers.dtype.str[1:] == "f16":  # longdouble
        numbers = numbers.astype(float64)
    dtype = numbers.dtype.str[1:]
    if dtype not in DTYPES:
        return {"other": _type_name(value) if numbers.dtype.kind != "c" else "complex"}
    if numbers.size > LONGEST:
        return {"other": "an array too large to send"}
    if dtype == PACKED and numbers.size:
        return _packed(numbers.astype(PACKED, copy=False))  # in the order of this machine's bytes
    return {"array": [dtype, list(numbers.shape), numbers.ravel().tolist()]}


def _packed(numbers):
    data = b64encode(numbers.tobytes()).decode()
    return {"packed": [numbers.dtype.str[1:], list(numbers.shape), data]}


def _type_name(value):
    return re.sub(r"\W", "", type(value).__name__)[:40] or "object"


def decode(sent: Any) -> Any:
    """The value of something that came out of the cage.

    Raises
    ------
    ValueError
        It is not what :func:`encode` makes.

    Examples
    --------
    >>> decode({"array": ["f8", [1, 2], [1.0, 2.0]]}), decode(encode(np.array([1.5])))
    (array([[1., 2.]]), array([1.5]))
    """
    if sent is None or isinstance(sent, (bool, float)):
        return sent
    if isinstance(sent, int):
        return sent if -WHOLE < sent < WHOLE else float("inf")
    if isinstance(sent, str):
        return sent[:TEXT]
    if isinstance(sent, list):
        return [decode(entry) for entry in sent]
    if not isinstance(sent, dict) or len(sent) != 1:
        raise ValueError("expected a value of the wire, found something else")
    ((kind, content),) = sent.items()
    if kind not in _DECODERS:
        raise ValueError("expected a kind of the wire, found another")
    return _DECODERS[kind](content)


def pack(value: Any) -> Any:
    """An argument of a call, for the way into the cage.

    Examples
    --------
    >>> pack(np.array([1.0])), pack(0.5)
    ({'packed': ['f8', [1], 'AAAAAAAA8D8=']}, 0.5)
    """
    if type(value) is ndarray and value.dtype.str[1:] in DTYPES:
        return _packed(value)
    return encode(value)


def unpack(sent: Any) -> Any:
    """What :func:`pack` was given.

    Examples
    --------
    >>> unpack(pack(np.eye(2)))
    array([[1., 0.],
           [0., 1.]])
    """
    if type(sent) is dict and "packed" in sent:
        dtype, shape, data = sent["packed"]
        return frombuffer(bytearray(b64decode(data)), dtype).reshape(shape)
    return decode(sent)


def error_name(name: Any) -> str:
    """The name of an error of Python or numpy; "an error" for whatever else is called one.

    Examples
    --------
    >>> error_name("ValueError"), error_name("You get 10 of 10")
    ('ValueError', 'an error')
    """
    kind = getattr(builtins, name, None) if isinstance(name, str) else None
    known = isinstance(kind, type) and issubclass(kind, BaseException)
    return name if known or name == "LinAlgError" else "an error"


def _decode_array(content):
    dtype, shape, data = content
    if dtype not in DTYPES or not isinstance(data, list) or len(data) > LONGEST:
        raise ValueError("expected an array of the wire, found something else")
    if not _is_shape(shape) or not NUMBERS.issuperset(map(type, data)):
        raise ValueError("expected an array of numbers, found something else")
    with np.errstate(all="ignore"):
        try:
            return np.array(data, dtype=dtype).reshape(shape)
        except (OverflowError, TypeError) as error:
            raise ValueError(str(error)) from None


def _decode_packed(content):
    dtype, shape, data = content
    if dtype != PACKED or not _is_shape(shape) or len(data) > 11 * LONGEST:
        raise ValueError("expected an array of the wire, found something else")
    return frombuffer(bytearray(b64decode(data, validate=True)), PACKED).reshape(shape)


def _is_shape(shape):
    short = isinstance(shape, list) and len(shape) <= DEEPEST
    return short and all(type(n) is int and n >= 0 for n in shape)


def _decode_matrix(content):
    return decode(content).view(np.matrix)


def _decode_dict(content):
    return {
        key if isinstance(key := decode(k), (str, int, float, bool)) else str(key): decode(entry)
        for k, entry in content
    }


def _decode_table(content):
    from ...table import DHTable

    convention, rows, joints = content
    make = {"standard": DHTable.standard, "craig": DHTable.craig}.get(convention)
    if make is None:
        raise ValueError("expected a convention, found something else")
    return make(decode(rows), angle="rad", joints=joints)


def _decode_arm(content):
    from ...arm import Arm

    table, base, tool, sign, coupling, loaded = content
    return Arm(
        _decode_table(table["table"]),
        base=decode(base),
        tool=decode(tool),
        sign=decode(sign),
        coupling=None if coupling is None else decode(coupling),
        source="loaded" if loaded is True else "",  # a learner's own words stay inside
    )


def _decode_other(content):
    known = isinstance(content, str) and (content in TYPES or content in vars(builtins))
    return type(content if known else "object", (Opaque,), {})()


_DECODERS = {
    "...": lambda content: Ellipsis,
    "array": _decode_array,
    "packed": _decode_packed,
    "matrix": _decode_matrix,
    "dict": _decode_dict,
    "table": _decode_table,
    "arm": _decode_arm,
    "other": _decode_other,
}
