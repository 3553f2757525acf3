"""Ranges, indices that count from one, and the functions that MATLAB has otherwise than Python."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from ...held.budget import MOST_ITEMS, Unsupported
from ...held.factors import Multiplied
from ...held.operators import whole
from ...held.values import Instance, Native, Unknown, is_number, number_of, plain
from ...library.functions import FUNCTIONS
from ...library.symbols import SYMBOLS
from ...library.toolbox import Link, robot

__all__ = ["ALL", "NAMES", "Span", "from_one", "key_of", "listed", "picked"]

LONGEST = 256


@dataclass(frozen=True)
class Span:
    """``first:step:last``; all of it, where they are None. A last one of 0 or less counts from the
    end.
    """

    first: float | None = None
    last: float | None = None
    step: float = 1

    def numbers(self):
        """Its numbers, as a row."""
        if self.first is None:
            raise Unsupported("no range")
        count = int(np.floor((self.last - self.first) / self.step + 1e-9)) + 1
        if count > LONGEST:
            raise Unsupported("too long a range")
        return np.array([self.first + k * self.step for k in range(max(count, 0))])


ALL = Span()


def listed(value):
    """What a loop goes over: the numbers of a range, the columns of a matrix."""
    if isinstance(value, Span):
        return [int(one) if one == int(one) else float(one) for one in value.numbers()]
    if isinstance(value, np.ndarray) and value.ndim == 2:
        return [one.item() if one.size == 1 else one.reshape(-1, 1) for one in value.T]
    return None


def from_one(key):
    """An index that counts from one as Python has it."""
    if isinstance(key, tuple):
        return tuple(from_one(one) for one in key)
    if isinstance(key, Span):
        if key.first is None:
            return slice(None)
        last = whole(key.last)
        return slice(whole(key.first) - 1, None if last == 0 else last, whole(key.step))
    if is_number(key):
        return whole(key) - 1
    return plain(key).reshape(-1).astype(int) - 1


def key_of(key):
    """An index as the key under which a cell is kept that nobody made before."""
    parts = key if isinstance(key, tuple) else (key,)
    parts = tuple(":" if isinstance(one, Span) else whole(one) for one in parts)
    parts = tuple(one for one in parts if one != ":")
    return parts[-1] if parts else 0


def picked(value, args):
    """``value(args)``, where value is no function."""
    key = tuple(args) if len(args) != 1 else args[0]
    if isinstance(value, dict):
        return _cells_of(value, key) if isinstance(key, Span) else value[key_of(key)]
    if isinstance(value, Unknown):
        return _of_unknown(value, args)
    if isinstance(value, list) and isinstance(key, tuple) and isinstance(value[0], list):
        rows = value[from_one(key[0])]
        return rows[from_one(key[1])] if isinstance(rows, list) else rows
    if isinstance(value, list | tuple):
        at = from_one(key[-1] if isinstance(key, tuple) else key)
        return value[at]
    if not isinstance(value, np.ndarray):
        if is_number(value):
            return value
        raise Unsupported("no index")
    at = from_one(key)
    if not isinstance(key, tuple):
        found = np.asarray(value).T.reshape(-1)[at]
        return found.item() if np.ndim(found) == 0 else found.reshape(1, -1).view(Multiplied)
    at = tuple(one if isinstance(one, slice) else np.atleast_1d(one) for one in at)
    if sum(not isinstance(one, slice) for one in at) > 1 and value.ndim == 2:
        found = np.asarray(value)[np.ix_(*(_places(one, n) for one, n in zip(at, value.shape)))]
    else:
        found = np.asarray(value)[at]
    found = found.reshape(found.shape[:2]) if found.ndim == 3 and found.shape[2] == 1 else found
    return found.item() if found.size == 1 else found.view(Multiplied)


def _cells_of(value, key):
    """The cells of a range, or all of them, in the order of their numbers: ``links{:}``."""
    wanted = sorted(value) if key.first is None else map(int, key.numbers())
    return [value[one] for one in wanted]


def _places(one, n):
    return np.arange(n)[one] if isinstance(one, slice) else one


def _of_unknown(value, args):
    if not args or not all(is_number(one) or isinstance(one, Span) for one in args):
        raise Unsupported("somebody else's function")
    for one in args:
        if isinstance(one, Span):
            if one.first is None:
                continue
            last = whole(one.last)
            n = value.samples.many() if last <= 0 else last
            return [value.item(f"[{k - 1}]") for k in range(whole(one.first), n + 1)]
        if len(args) == 2 and one is args[0] and one == 1:
            continue  # a row of them
        value = value.item(f"[{whole(one) - 1}]")
    return value


def _span(run, args, _):
    ends = [one.samples.many() if isinstance(one, Unknown) else number_of(one) for one in args]
    return Span(ends[0], ends[-1], ends[1] if len(ends) == 3 else 1)


def _matrix(run, args, _):
    """Rows of numbers, of matrices beside each other, or of links."""
    rows = [[part for one in row for part in _parts(one)] for row in args[0]]
    flat = [one for row in rows for one in row]
    if flat and all(isinstance(one, Link | str) for one in flat):
        return flat
    if not flat:
        return {}
    if len(flat) == 1 and isinstance(flat[0], Unknown):
        return flat[0]
    try:
        parts = [[np.atleast_2d(plain(one)) for one in row] for row in rows]
        found = np.vstack([np.hstack(row) for row in parts])
    except ValueError:
        raise Unsupported("no matrix") from None
    return run.budget.checked(found.view(Multiplied))


def _parts(one):
    if isinstance(one, list) and one and all(isinstance(link, Link) for link in one):
        return one  # links{:}
    return [one.numbers() if isinstance(one, Span) else one]


def _cells(run, args, _):
    rows = args[0]
    if len(rows) > 1 and {len(row) for row in rows} - {1} and len({len(row) for row in rows}) == 1:
        return [list(row) for row in rows]
    return [one for row in rows for one in row]


def _size(args):
    given = [one.samples.many() if isinstance(one, Unknown) else whole(one) for one in args
             if not isinstance(one, str)]  # fmt: skip
    given = given * 2 if len(given) == 1 else given or [1, 1]
    if any(one < 0 for one in given) or np.prod([float(one) for one in given]) > MOST_ITEMS:
        raise Unsupported("too large")
    return tuple(given)


def _filled(number):
    def call(run, args, _):
        found = np.full(_size(args), number)
        return found.view(Multiplied)

    return call


def _unit(run, args, _):
    return np.eye(*_size(args)[:2]).view(Multiplied)


def _count(run, args, _):
    value = args[0]
    if isinstance(value, Unknown):
        return value.samples.many()
    if isinstance(value, np.ndarray):
        return max(value.shape)
    return len(value)


def _sizes(run, args, _):
    value = args[0]
    if isinstance(value, Unknown):
        return value.samples.many()
    shape = plain(value).shape
    return shape[whole(args[1]) - 1] if len(args) > 1 else np.array([shape]).view(Multiplied)


def _in_degrees(name):
    act = FUNCTIONS[name].call

    def call(run, args, kwargs):
        return act(run, [FUNCTIONS["deg2rad"].call(run, args, {})], kwargs)

    return call


def _symbol(run, args, kwargs):
    return SYMBOLS["symbols"](run, args[:1], kwargs) if isinstance(args[0], str) else args[0]


def _link(run, args, kwargs, convention="", letter=""):
    """``Link([theta d a alpha sigma offset], 'modified')`` or ``Link('d', 0.1, …)``."""
    words = [one for one in args if isinstance(one, str)]
    if not args:
        raise Unsupported("no link")
    if not isinstance(args[0], str):
        numbers = [float(one) for one in plain(args[0]).reshape(-1)]
        theta, d, a, alpha, sigma, zero = [*numbers, *[0.0] * (6 - len(numbers))][:6]
        letter = "P" if sigma else "R"
        theta, d = (zero, d) if letter == "R" else (theta, zero)
        convention = "craig" if "modified" in words else "standard"
        return Link(convention, letter, (theta, d, a, alpha))
    said: dict = {}
    for name, value in pairwise(args):
        if isinstance(name, str) and is_number(value) and not isinstance(value, Unknown):
            said[name] = float(value)
    slides = letter == "P" or ("theta" in said and "d" not in said) or "prismatic" in words
    zero = said.get("offset", 0.0)
    theta, d = (said.get("theta", 0.0), zero) if slides else (zero, said.get("d", 0.0))
    convention = convention or ("craig" if "modified" in words else "standard")
    row = (theta, d, said.get("a", 0.0), said.get("alpha", 0.0))
    return Link(convention, "P" if slides else "R", row)


def _of_kind(convention, letter):
    return lambda run, args, kwargs: _link(run, args, kwargs, convention, letter)


def _robot(run, args, kwargs):
    given = args[0] if args else []
    given = list(given.values()) if isinstance(given, dict) else given
    given = [given] if isinstance(given, Link) else given
    return robot(run, [given], {})


def _struct(run, args, _):
    """``struct('d', 0.3, 'a', 0)``, as many records as a cell has items: ``struct('d', {1, 2})``;
    without fields, or with empty cells, it is filled later.
    """
    fields = dict(zip(args[::2], args[1::2]))
    if not all(isinstance(name, str) for name in fields):
        raise Unsupported("fields without a name")
    if all(value == {} for value in fields.values()):
        return {}
    many = [value for value in fields.values() if isinstance(value, list)]
    if any(isinstance(value, dict) for value in fields.values()) or len(set(map(len, many))) > 1:
        raise Unsupported("many records")
    if not many:
        return Instance(None, fields, "struct")
    return {
        k + 1: Instance(
            None, {name: v[k] if isinstance(v, list) else v for name, v in fields.items()}, "struct"
        )
        for k in range(len(many[0]))
    }


def _is_case(run, args, _):
    cases = args[1] if isinstance(args[1], list) else [args[1]]
    return any(isinstance(one, str) == isinstance(args[0], str) and one == args[0] for one in cases)


NAMES = {
    "_span": _span, "_matrix": _matrix, "_cells": _cells, "zeros": _filled(0.0),
    "ones": _filled(1.0), "eye": _unit, "cell": lambda *_: {}, "struct": _struct,
    "length": _count, "numel": _count, "size": _sizes, "sym": _symbol, "_is_case": _is_case,
    "double": FUNCTIONS["copy"].call, "Link": _link, "Revolute": _of_kind("standard", "R"),
    "Prismatic": _of_kind("standard", "P"), "RevoluteMDH": _of_kind("craig", "R"),
    "PrismaticMDH": _of_kind("craig", "P"), "SerialLink": _robot, "combine": FUNCTIONS["copy"].call,
    **{f"{name}d": _in_degrees(name) for name in ("sin", "cos", "tan")},
    "atan2d": lambda run, args, _: np.rad2deg(FUNCTIONS["atan2"].call(run, args, {})),
    "mtimes": FUNCTIONS["matmul"].call,
}  # fmt: skip
NAMES = {name: Native(name, call) for name, call in NAMES.items()}
