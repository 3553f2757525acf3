"""The program of one arm: what is left of ``one.py`` when every number of the table is known.

The walk is run once on symbols in place of the joint angles. A sum or a product of symbols is
noted down as text; what is multiplied by 0 or added to 0 vanishes, what is multiplied by 1 stays as
it is, and what is constant is worked out at once. What was noted is a straight line of Python with
neither loops nor zeros; cos and sin are all that it calls, beside what writes the result down. An
arm that turns on a column of 0.3 m and lifts a link of 0.5 m:

>>> import dhlab as dh
>>> from dhlab.fast import one
>>> from dhlab.fast.chain import chain_of
>>> arm = dh.Arm(dh.DHTable.standard([[0, 0.3, 0, 90], [0, 0, 0.5, 0]], angle="deg"))
>>> print(*source(one.forward, chain_of(arm), (4, 4)).splitlines()[:14], sep="\\n")
def kinematics(q):
    [q1, q2] = q
    v0 = cos(q1)
    v1 = sin(q1)
    v2 = cos(q2)
    v3 = sin(q2)
    v4 = v0*v2
    v5 = v1*v2
    v6 = v0*v3
    v7 = v1*v3
    v8 = 0.5*v4
    v9 = 0.5*v5
    v10 = 0.5*v3 + 0.3
    result = empty((4, 4))
"""

import math
from collections.abc import Callable
from struct import Struct
from typing import Any

import numpy as np

from .chain import LARGEST_SUM, Chain

__all__ = ["straight"]

SUM, PRODUCT, ATOM = range(3)  # what an expression is, and so how tightly it holds together


def straight(kinematics: Callable, chain: Chain, shape: tuple[int, ...]) -> Callable:
    """The straight-line form of ``one.forward``, ``one.frames`` or ``one.jacobian`` for one chain.

    Parameters
    ----------
    kinematics : function
    chain : Chain
    shape : tuple
        Of the result.

    Returns
    -------
    function
        From a list of n floats to an array; None where parallel joints are turned so often that the
        plain product is more exact.
    """
    pack = Struct(f"{math.prod(shape)}d").pack_into
    scope: dict[str, Any] = {"cos": math.cos, "sin": math.sin, "empty": np.empty, "pack": pack}
    exec(source(kinematics, chain, shape), scope)  # it holds numbers and the names above only
    return scope["kinematics"]


def source(kinematics: Callable, chain: Chain, shape: tuple[int, ...]) -> str:
    """The text of that function; the parameters are those of :func:`straight`."""
    program, names = Program(), [f"q{i}" for i in range(1, len(chain) + 1)]
    symbols = [Symbol(program, name) for name in names]
    results = ", ".join(_written(number) for number in kinematics(chain, symbols, program))
    lines = [
        f"[{', '.join(names)}] = q",
        *program.lines,
        f"result = empty({shape})",
        f"pack(result, 0, {results})",  # straight into its memory, without a list
        "return result",
    ]
    return "def kinematics(q):\n    " + "\n    ".join(lines)


def _written(number):
    """A result as text; a zero loses its sign, since -0.0 prints badly."""
    if not isinstance(number, Symbol):
        return repr(number + 0.0)
    return f"0.0 - {number.bracketed(PRODUCT)}" if number.negative else f"{number} + 0.0"


class Program:
    """The lines so far; takes the place of ``one.Floats``."""

    def __init__(self):
        self.lines, self.named = [], {}

    def cos(self, angle):
        """The cosine of a symbol as a symbol, of a float as a float."""
        return self._call("cos", angle)

    def sin(self, angle):
        """The sine, likewise."""
        return self._call("sin", angle)

    def _call(self, name, angle):
        if isinstance(angle, Symbol):
            return Symbol(self, f"{name}({angle})")
        return getattr(math, name)(angle)

    def added(self, angle, theta):
        """The sum of the angles of a run, and a line that gives up where its rounding would be
        seen.
        """
        total = self.keep(angle + theta)
        if isinstance(total, Symbol):
            self.lines.append(f"if not {-LARGEST_SUM} < {total.text} < {LARGEST_SUM}: return None")
        return total

    def keep(self, value):
        """A name for an expression, so that it is worked out once."""
        if not isinstance(value, Symbol) or value.text.isidentifier():
            return value
        if value.text not in self.named:
            self.named[value.text] = f"v{len(self.lines)}"
            self.lines.append(f"{self.named[value.text]} = {value.text}")
        return Symbol(self, self.named[value.text], value.negative)

    def keep_all(self, values):
        """Names for several."""
        return tuple(map(self.keep, values))


class Symbol:
    """An expression that is not known yet, and its sign."""

    def __init__(self, program, text, negative=False, kind=ATOM):
        self.program, self.text, self.negative, self.kind = program, text, negative, kind

    def __str__(self):
        return f"-{self.bracketed(ATOM)}" if self.negative else self.text

    def bracketed(self, kind):
        """The text without its sign, in brackets where it holds together less tightly."""
        return self.text if self.kind >= kind else f"({self.text})"

    def __neg__(self):
        return Symbol(self.program, self.text, not self.negative, self.kind)

    def __mul__(self, other):
        if not isinstance(other, Symbol):
            return _scaled(self, other)
        text = f"{self.bracketed(PRODUCT)}*{other.bracketed(ATOM)}"
        return Symbol(self.program, text, self.negative != other.negative, PRODUCT)

    def __add__(self, other):
        if not isinstance(other, Symbol):
            return self if other == 0 else self + _constant(self.program, other)
        if self.negative and not other.negative:
            return other + self
        sign = "-" if self.negative != other.negative else "+"
        text = f"{self.text} {sign} {other.bracketed(PRODUCT)}"
        return Symbol(self.program, text, self.negative and other.negative, SUM)

    def __sub__(self, other):
        return self + -other

    def __rsub__(self, other):
        return -self + other

    __radd__, __rmul__ = __add__, __mul__


def _constant(program, number):
    return Symbol(program, repr(abs(number)), number < 0)


def _scaled(symbol, factor):
    if factor == 0:
        return 0.0
    if abs(factor) == 1:
        return -symbol if factor < 0 else symbol
    return _constant(symbol.program, factor) * symbol
