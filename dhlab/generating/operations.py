"""Arithmetic that is written down instead of done. Every operation is kept once, so a common
subexpression is one operation from the start; what is known is folded on the way.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

__all__ = ["Number", "Operations", "Value", "tidy"]

# a number this near to a decimal of 12 digits is that decimal: cos(pi/2) is 0, not 6.1e-17
NEAR = 1e-15
DIGITS = 12
COUNTED = {
    "times": "multiplications",
    "scale": "multiplications",
    "plus": "additions",
    "minus": "additions",
    "shift": "additions",
    "cos": "sines and cosines",
    "sin": "sines and cosines",
}


def tidy(number: float) -> float:
    """A sine, a cosine or an entry of a rotation without the error of its last bit: 0, 1 and 0.5
    are exact.

    Examples
    --------
    >>> tidy(math.cos(math.pi / 2)), tidy(math.cos(math.pi / 3)), tidy(math.sin(1e-9))
    (0.0, 0.5, 1e-09)
    """
    plain = round(float(number), DIGITS) + 0.0
    return plain if abs(plain - number) < NEAR else float(number)


class Value:
    """A result in :class:`Operations`, or its negative: a sign is free, and hides no common
    subexpression. Plain numbers mix with it.
    """

    __slots__ = ("negative", "node", "operations")

    def __init__(self, operations: Operations, node: int, negative: bool = False):
        self.operations, self.node, self.negative = operations, node, negative

    def __neg__(self) -> Value:
        return Value(self.operations, self.node, not self.negative)

    def __add__(self, other: Number) -> Number:
        if isinstance(other, Value):
            return self.operations.sum(self, other)
        return self.operations.shifted(self, float(other))

    __radd__ = __add__

    def __sub__(self, other: Number) -> Number:
        return self + -other

    def __rsub__(self, other: Number) -> Number:
        return -self + other

    def __mul__(self, other: Number) -> Number:
        if isinstance(other, Value):
            return self.operations.product(self, other)
        return self.operations.scaled(float(other), self)

    __rmul__ = __mul__


Number = Value | float  # what formulas are made of


class Operations:
    """Operations in an order in which they can be carried out.

    ``nodes`` holds one tuple each; a and b are places in ``nodes``: ``("q", i)``, ``("cos", a)``,
    ``("sin", a)``, ``("times", a, b)``, ``("plus", a, b)``, ``("minus", a, b)``, and with a number
    ``("scale", a, number)``, ``("shift", a, number)``.

    Examples
    --------
    >>> program = Operations()
    >>> q1, q2 = program.variable(0), program.variable(1)
    >>> x = 0.4 * program.cos(q1 - q2) + 0.0 * q2
    >>> y = program.cos(q2 - q1) * 0.4
    >>> program.nodes
    [('q', 0), ('q', 1), ('minus', 0, 1), ('cos', 2), ('scale', 3, 0.4)]
    """

    def __init__(self) -> None:
        self.nodes: list[tuple] = []
        self._known: dict[tuple, int] = {}

    def _value(self, *node, negative=False):
        if node not in self._known:
            self._known[node] = len(self.nodes)
            self.nodes.append(node)
        return Value(self, self._known[node], negative)

    def variable(self, i: int) -> Value:
        """What the controller counts for joint i, from 0."""
        return self._value("q", i)

    def cos(self, angle: Number) -> Number:
        """The cosine of a Value or a number."""
        return self._value("cos", angle.node) if isinstance(angle, Value) else tidy(math.cos(angle))

    def sin(self, angle: Number) -> Number:
        """The sine of a Value or a number."""
        if isinstance(angle, Value):
            return self._value("sin", angle.node, negative=angle.negative)
        return tidy(math.sin(angle))

    def product(self, a: Value, b: Value) -> Value:
        """Two Values multiplied."""
        first, second = sorted((a.node, b.node))
        return self._value("times", first, second, negative=a.negative != b.negative)

    def scaled(self, number: float, a: Value) -> Number:
        """A number times a Value; 0.5 · (0.2 · x) is 0.1 · x."""
        if number == 0:
            return 0.0
        node, negative, number = a.node, a.negative != (number < 0), abs(number)
        if self.nodes[node][0] == "scale":
            _, node, inner = self.nodes[node]
            number *= inner
        if number == 1:
            return Value(self, node, negative)
        return self._value("scale", node, number, negative=negative)

    def sum(self, a: Value, b: Value) -> Number:
        """Two Values added; the operands in the order of their places, whichever came first."""
        if a.node == b.node:
            return 0.0 if a.negative != b.negative else self.scaled(2.0, a)
        a, b = (a, b) if a.node < b.node else (b, a)
        kind = "plus" if a.negative == b.negative else "minus"
        return self._value(kind, a.node, b.node, negative=a.negative)

    def shifted(self, a: Value, number: float) -> Value:
        """A number added to a Value; (x + 0.1) + 0.2 is x + 0.3."""
        node, number = a.node, -number if a.negative else number
        if self.nodes[node][0] == "shift":
            _, node, inner = self.nodes[node]
            number += inner
        if number == 0:
            return Value(self, node, a.negative)
        return self._value("shift", node, number, negative=a.negative)

    def operands(self, node: int) -> list[int]:
        """The places that an operation reads."""
        kind, *rest = self.nodes[node]
        if kind == "q":
            return []
        return rest[:1] if kind in ("scale", "shift") else rest

    def needed(self, results: Iterable[Number]) -> list[int]:
        """The places of all operations behind some results (Values or numbers), in order."""
        todo = [result.node for result in results if isinstance(result, Value)]
        found = set()
        while todo:
            node = todo.pop()
            if node not in found:
                found.add(node)
                todo += self.operands(node)
        return sorted(found)

    def count(self, results: Iterable[Number]) -> dict[str, int]:
        """How many multiplications, additions, sines and cosines some results take.

        Examples
        --------
        >>> program = Operations()
        >>> program.count([0.4 * program.cos(program.variable(0)), 1.0])
        {'multiplications': 1, 'additions': 0, 'sines and cosines': 1}
        """
        kinds = [self.nodes[node][0] for node in self.needed(results)]
        return {
            name: sum(COUNTED.get(kind) == name for kind in kinds)
            for name in ("multiplications", "additions", "sines and cosines")
        }
