"""What a program holds, as its interpreter sees it: beside numbers, texts, lists and arrays what is
not known, functions, classes and objects.
"""

import zlib
from dataclasses import dataclass, field

import numpy as np

from .budget import Unsupported

__all__ = [
    "LOST",
    "Class", "Function", "Instance", "Method", "Module", "Native", "Samples", "Unknown",
    "is_number", "items_of", "number_of", "plain",
]  # fmt: skip

LOST = "!"  # begins the path of what the program knows and its interpreter does not
LONGEST_PATH = 200
SPREAD = 100_003


@dataclass(frozen=True)
class Shift:
    """What a program adds to something, ``q2: q2 - pi/2``."""

    by: float


@dataclass(eq=False)
class Samples:
    """The numbers that stand in one run for what is not known.

    Parameters
    ----------
    seed : int
        Of the run.
    given : dict of str to float
        What the program says later of something (``subs``): a number, or a Shift.
    length : int
        How many items a list has of which nobody knows; ``asked`` whether it mattered.
    stored : dict
        What the program puts into lists that nobody knows, by (place, path).
    likely : bool
        Whether conditions that hang on what nobody knows go their usual way; ``doubted`` whether
        there are any.
    """

    seed: int
    given: dict = field(default_factory=dict)
    length: int = 6
    asked: bool = False
    drawn: dict = field(default_factory=dict)
    stored: dict = field(default_factory=dict)
    likely: bool = True
    doubted: bool = False

    def holds(self, usual):
        """Whether a condition holds of which nobody knows it; a run in which nothing is ``likely``
        takes the other way.
        """
        self.doubted = True
        return usual == self.likely

    def of(self, path):
        """The number for a path: between 0.1 and 0.9, the same in every run of this seed.

        Examples
        --------
        >>> samples = Samples(1)
        >>> samples.of("q[0]") == samples.of("q[0]") != samples.of("q[1]")
        True
        """
        said = self.given.get(path)
        if said is not None and not isinstance(said, Shift):
            return said
        if path not in self.drawn:
            mixed = zlib.crc32(f"{path} {self.seed}".encode()) * 2_654_435_761
            self.drawn[path] = 0.1 + 0.8 * ((mixed >> 7) % SPREAD) / SPREAD
        return self.drawn[path] + (said.by if said else 0.0)

    def many(self):
        """How many items a list has of which nobody knows."""
        self.asked = True
        return self.length


@dataclass(frozen=True)
class Unknown:
    """Something of which only the way to it is known; it is taken for what it is used as: a number
    where it is calculated with, a list where it is indexed. ``steps`` are the functions that were
    applied to it, or to each of its items.
    """

    path: str
    samples: Samples
    steps: tuple = ()
    place: int = 0  # of a copy, into which something else may be put

    def number(self):
        """The number that stands for it."""
        value = self.samples.of(self.path)
        for step in self.steps:
            value = step(value)
        return value

    def item(self, key):
        """What stands in it under a key, or behind a name."""
        path = f"{self.path}{key}"
        if len(path) > LONGEST_PATH:
            raise Unsupported("too deep")
        value = self.samples.stored.get((self.place, path))
        if value is None:
            return Unknown(path, self.samples, self.steps, self.place)
        for step in self.steps:
            value = value.mapped(step) if isinstance(value, Unknown) else step(number_of(value))
        return value

    def put(self, key, value):
        """Let an item be a value."""
        if self.steps or not is_number(value):
            raise Unsupported("a part of something that is not known")
        if isinstance(value, Unknown):  # it may have the same path
            value = value.number() if value.path != f"{self.path}{key}" or value.steps else None
        self.samples.stored[self.place, f"{self.path}{key}"] = value

    def copied(self, place):
        """A copy of it, which has a place of its own."""
        stored = self.samples.stored
        for (held, path), value in list(stored.items()):
            if held == self.place and path.startswith(self.path):
                stored[place, path] = value
        return Unknown(self.path, self.samples, self.steps, place)

    def items(self, n=None):
        """Its first items, as many as anybody thinks."""
        return [self.item(f"[{k}]") for k in range(self.samples.many() if n is None else n)]

    def mapped(self, step):
        """It, or each of its items, calculated with."""
        if len(self.steps) > 50:
            raise Unsupported("too deep")
        return Unknown(self.path, self.samples, (*self.steps, step), self.place)


@dataclass(eq=False)
class Function:
    """A function of the program: its node, the names around it, and the class it stands in."""

    node: object
    scope: object
    name: str
    owner: object = None
    kind: str = ""  # staticmethod, classmethod, property


@dataclass(eq=False)
class Class:
    """A class of the program, with its attributes and the fields that it declares."""

    name: str
    bases: tuple
    attributes: dict
    fields: list

    def find(self, name):
        """An attribute of the class or its bases; None without one."""
        if name in self.attributes:
            return self.attributes[name]
        for base in self.bases:
            if isinstance(base, Class) and (found := base.find(name)) is not None:
                return found
        return None


@dataclass(eq=False)
class Instance:
    """An object of a class of the program; ``strict`` where all its attributes are known."""

    cls: Class | None
    attributes: dict = field(default_factory=dict)
    path: str = "self"


@dataclass(frozen=True, eq=False)
class Method:
    """A function with the object that it is asked of."""

    function: object
    owner: object


@dataclass(frozen=True, eq=False)
class Native:
    """A function of the list: ``call(run, args, kwargs)``."""

    name: str
    call: object


@dataclass(frozen=True)
class Module:
    """A library whose names are in the list, or are not known."""

    name: str


def is_number(value):
    """Whether a value is a number, or stands for one."""
    return isinstance(value, int | float | np.number | np.bool_ | Unknown)


def number_of(value):
    """The number that a value is or stands for.

    Raises
    ------
    Unsupported
        It is none.
    """
    if isinstance(value, Unknown):
        return value.number()
    if isinstance(value, int | float | np.number | np.bool_):
        return value
    if isinstance(value, np.ndarray) and value.size == 1:
        return float(value.reshape(-1)[0])
    raise Unsupported("no number")


def plain(value):
    """Lists, tuples and arrays of numbers as an array; what is not known stands as its numbers.

    Examples
    --------
    >>> plain([[1, 2], (3, 4)]).shape
    (2, 2)
    """
    if isinstance(value, np.ndarray):
        return value
    try:
        return np.array(_nested(value), dtype=float)
    except (TypeError, ValueError, OverflowError):
        raise Unsupported("no array of numbers") from None


def _nested(value):
    if isinstance(value, list | tuple):
        return [_nested(item) for item in value]
    if isinstance(value, np.ndarray):
        return value.tolist()
    return number_of(value)


def items_of(value):
    """The items of something that a loop goes over."""
    if isinstance(value, Unknown):
        return value.items()
    if isinstance(value, np.ndarray) and value.ndim:
        return [item.item() if np.ndim(item) == 0 else item for item in value]
    if isinstance(value, list | tuple | str):
        return list(value)
    if isinstance(value, dict):
        return list(value)
    if isinstance(value, Instance) and value.cls and value.cls.fields:  # a named tuple
        return [value.attributes[name] for name in value.cls.fields]
    raise Unsupported("nothing to go over")
