"""One cell of a pasted table: a number, π/2, 90°, a joint variable with an offset. Parsed with a
small grammar, never evaluated.

A cell is a sum of terms; a term is a product or quotient of numbers, π and at most one joint
variable; ° marks degrees.
"""

import math
import re
from dataclasses import dataclass

__all__ = ["Cell", "read_cell", "plain"]

LONGEST = 40
TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)|(?P<pi>pi)|(?P<deg>°|degrees|deg)|(?P<unit>mm|cm|m|rad)(?![a-z0-9])"
    r"|(?P<name>(?:theta|th|q|t|d|var|variable)_?\d*(?![a-z]))|(?P<op>[-+*/()]))"
)
SAME = str.maketrans(
    {
        "−": "-",
        "–": "-",
        "—": "-",
        "₋": "-",
        "×": "*",
        "·": "*",
        "∗": "*",
        "⁎": "*",
        "│": "|",
        "┃": "|",
        "π": "pi",
        "θ": "theta",
        "ϑ": "theta",
        "Θ": "theta",
        "α": "alpha",
        "⍺": "alpha",
        "ⱼ": "_i",
        "ᵢ": "_i",
        "º": "°",
        "˚": "°",
        "\u00a0": " ",
        "\u2009": " ",
        "{": "",
        "}": "",
        "$": "",
        "\\": "",
        **{chr(0x2080 + k): str(k) for k in range(10)},
    }
)
LENGTH_UNITS = {"mm": 1e-3, "cm": 1e-2, "m": 1.0}


@dataclass(frozen=True)
class Cell:
    """What a cell says: ``value`` (the constant part), the joint variable in it ("theta", "d", "q"
    or "") and how it counts, the unit it names.
    """

    value: float
    variable: str = ""
    sign: int = 1
    unit: str = ""

    @property
    def is_constant(self):
        """Whether no joint variable stands in it."""
        return not self.variable


def plain(text):
    """Greek letters, minus signs, subscripts and TeX marks written in plain letters, in lower case.

    Examples
    --------
    >>> plain("−π/2"), plain("θ₁"), plain("$\\\\theta_1$")
    ('-pi/2', 'theta1', 'theta_1')
    """
    return text.translate(SAME).lower().strip()


def read_cell(text):
    """The Cell in a text.

    Raises
    ------
    ValueError
        Expected what, found what.

    Examples
    --------
    >>> read_cell("-π/2").value, read_cell("90°").unit
    (-1.5707963267948966, 'deg')
    >>> read_cell("θ2* - 90").value, read_cell("-q3").sign
    (-90.0, -1)
    """
    if len(text) > LONGEST:
        raise ValueError(
            f"expected a number or a joint variable, found a text of {len(text)} characters; a cell"
            " holds one value"
        )
    try:
        return _Parser(_tokens(plain(text))).cell()
    except (_NoCell, ZeroDivisionError, OverflowError):
        known = "a number, a multiple of pi, or a joint variable such as q2 - 90"
        raise ValueError(f"expected {known}, found {text!r}; write it as one of these") from None


class _NoCell(Exception):
    """The text is not in the grammar."""


def _tokens(text):
    found, at = [], 0
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match or match.end() == at:
            if not text[at:].strip():
                break
            raise _NoCell
        found.append((match.lastgroup, match.group(match.lastgroup)))
        at = match.end()
    return found


class _Parser:
    """Recursive descent over at most 40 characters."""

    def __init__(self, tokens):
        self.tokens, self.at = tokens, 0
        self.units, self.names = set(), []

    def cell(self):
        constant, variable = self.sum()
        if self.at < len(self.tokens) or len(self.units) > 1 or len(self.names) > 1:
            raise _NoCell
        if abs(variable) not in (0, 1) or not math.isfinite(constant):
            raise _NoCell
        unit = next(iter(self.units), "")
        name = self.names[0] if self.names and variable else ""
        return Cell(
            constant,
            "theta" if name[:1] == "t" else "q" if name[:1] in ("q", "v") else name[:1],
            int(variable) or 1,
            unit,
        )

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else (None, None)

    def take(self):
        self.at += 1
        return self.tokens[self.at - 1]

    def sum(self):
        """(constant, coefficient of the variable)."""
        constant, variable = self.product()
        while self.peek() in (("op", "+"), ("op", "-")):
            sign = 1 if self.take()[1] == "+" else -1
            more = self.product()
            constant, variable = constant + sign * more[0], variable + sign * more[1]
        return constant, variable

    def product(self):
        constant, variable = self.factor()
        while True:
            kind, text = self.peek()
            if (kind, text) in (("op", "*"), ("op", "/")):
                self.take()
                if (
                    text == "*"
                    and variable
                    and self.peek() in ((None, None), ("op", "+"), ("op", "-"), ("op", ")"))
                ):
                    continue  # q1* marks the joint variable
                other = self.factor()
                if other[1] and (text == "/" or variable):
                    raise _NoCell
                if text == "/":
                    constant, variable = constant / other[0], variable / other[0]
                else:
                    constant, variable = (
                        constant * other[0],
                        variable * other[0] + constant * other[1],
                    )
            elif kind == "pi":  # 2pi
                self.take()
                self.units.add("rad")
                constant *= math.pi
            else:
                return constant, variable

    def factor(self):
        kind, text = self.peek()
        if (kind, text) in (("op", "-"), ("op", "+")):
            self.take()
            constant, variable = self.factor()
            return (-constant, -variable) if text == "-" else (constant, variable)
        if kind is None:
            raise _NoCell
        self.take()
        if (kind, text) == ("op", "("):
            inside = self.sum()
            if self.peek() != ("op", ")"):
                raise _NoCell
            self.take()
            return inside
        return self.atom(kind, text)

    def atom(self, kind, text):
        if kind == "name":
            self.names.append(text)
            return 0.0, 1
        if kind not in ("number", "pi"):
            raise _NoCell
        value = math.pi if kind == "pi" else float(text)
        if kind == "pi":
            self.units.add("rad")
        if self.peek()[0] in ("deg", "unit"):
            self.units.add("deg" if self.peek()[0] == "deg" else self.peek()[1])
            self.take()
        return value, 0
