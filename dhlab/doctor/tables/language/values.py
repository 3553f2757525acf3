"""What an expression is worth: a number, the letters in it with their factors, a unit."""

import math
from dataclasses import dataclass, field

__all__ = ["TO_METRES", "NoExpression", "Value", "added", "in_radians", "in_unit", "multiplied"]

TO_METRES = {"mm": 1e-3, "cm": 1e-2, "m": 1.0, "in": 0.0254}


class NoExpression(Exception):
    """The text is not in the grammar."""


@dataclass(frozen=True)
class Value:
    """``number`` plus the letters, each with its factor; ``unit`` is the one that the text names,
    "rad" also where pi stands in it.
    """

    number: float
    letters: dict = field(default_factory=dict)
    unit: str = ""

    def times(self, factor, unit=""):
        """This, factor times."""
        letters = {name: factor * share for name, share in self.letters.items() if factor * share}
        return Value(factor * self.number, letters, self.unit or unit)


def in_unit(value, unit):
    """``90 deg``: the number keeps the unit; ``(0.1 m) deg`` is no expression."""
    if value.unit == unit:
        return value
    if value.unit:
        raise NoExpression
    return Value(value.number, value.letters, unit)


def added(a, b):
    if {a.unit, b.unit} == {"rad", "deg"}:
        a, b = in_radians(a), in_radians(b)
    if a.unit and b.unit and a.unit != b.unit:
        raise NoExpression
    letters = dict(a.letters)
    for name, share in b.letters.items():
        letters[name] = letters.get(name, 0.0) + share
    letters = {name: share for name, share in letters.items() if share}
    return Value(a.number + b.number, letters, a.unit or b.unit)


def in_radians(value):
    return Value(math.radians(value.number), value.letters, "rad") if value.unit == "deg" else value


def multiplied(a, b):
    if a.letters and b.letters:
        raise NoExpression
    a, b = (b, a) if b.letters else (a, b)
    if a.unit and b.unit and {a.unit, b.unit} != {"rad"}:
        raise NoExpression
    return a.times(b.number, b.unit)
