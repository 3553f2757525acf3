"""The value of a short expression: numbers, pi, units, a few functions and letters. A recursive
descent with limits on length and depth; nothing is ever evaluated by Python.

A value is affine in the letters it holds: ``q2 + pi/2`` is pi/2 plus 1 · q2.
"""

import math
import re
from dataclasses import dataclass, field

__all__ = ["NoExpression", "Value", "evaluate", "key"]

LONGEST, DEEPEST = 200, 24
TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(?:[fFlL](?![\w.]))?"
    r"|(?P<name>[A-Za-z_][A-Za-z_0-9]*(?:(?:\.|::|->)[A-Za-z_]\w*)*)|(?P<deg>°)|(?P<quote>'')"
    r"|(?P<op>\*\*|[-+*/^()\[\],]))"
)
HALF = math.pi / 2
CONSTANTS = {
    **dict.fromkeys(("pi", "m_pi", "kpi", "const_pi"), math.pi),
    **dict.fromkeys(("m_pi_2", "pi_2", "half_pi", "halfpi", "pi_half", "frac_pi_2"), HALF),
    **dict.fromkeys(("m_pi_4", "pi_4", "frac_pi_4"), math.pi / 4),
    "frac_pi_3": math.pi / 3,
    "frac_pi_6": math.pi / 6,
    **dict.fromkeys(("tau", "two_pi"), 2 * math.pi),
    **dict.fromkeys(
        "deg2rad d2r dtr deg_to_rad deg_2_rad degtorad to_rad torad rad_per_deg degree_to_rad"
        " degrees_to_radians deg2radians radians_per_degree".split(),
        math.pi / 180,
    ),
}
UNITS = {
    **dict.fromkeys(("deg", "degs", "degree", "degrees", "grad"), "deg"),
    **dict.fromkeys(("rad", "rads", "radian", "radians"), "rad"),
    **dict.fromkeys(("mm", "millimeter", "millimeters", "millimetre", "millimetres"), "mm"),
    **dict.fromkeys(("cm", "centimeters", "centimetres"), "cm"),
    **dict.fromkeys(("m", "meter", "meters", "metre", "metres"), "m"),
    **dict.fromkeys(("in", "inch", "inches"), "in"),
}
TO_RADIANS = (
    "deg2rad radians rad d2r torad to_rad toradians to_radians degtorad deg_to_rad deg_2_rad dtor"
    " degrees_to_radians radian deg"
).split()
PLAIN = (
    "float float64 float32 double int rational integer s sympify mpf n number sym sp_float"
    " nsimplify"
).split()
FUNCTIONS = {
    "sqrt": math.sqrt,
    "sin": math.sin,
    "cos": math.cos,
    "tan": math.tan,
    "sind": lambda degrees: math.sin(math.radians(degrees)),
    "cosd": lambda degrees: math.cos(math.radians(degrees)),
    "c": math.cos,
    "s": math.sin,
    "abs": abs,
    "fabs": abs,
    "hypot": math.hypot,
}
INVERSE = {
    **dict.fromkeys(("atan", "arctan"), math.atan),
    **dict.fromkeys(("atan2", "arctan2"), math.atan2),
    **dict.fromkeys(("asin", "arcsin"), math.asin),
    **dict.fromkeys(("acos", "arccos"), math.acos),
}


CALLED = {*TO_RADIANS, *PLAIN, *FUNCTIONS, *INVERSE, "degrees", "rad2deg", "r2d"}
# arrays of joint values, as MATLAB indexes them: q(1), jA(1), config(1)
JOINT_VALUES = re.compile(r"q\w{0,3}|th|theta\w{0,3}|ja?|joints?|angles?|conf\w*|phi|jointangles?")


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


def key(name):
    """How a name is looked up: without its owner, underscores and braces.

    Examples
    --------
    >>> key("self.theta_1"), key("d_{1}")
    ('theta1', 'd1')
    """
    return re.sub(r"[_{}\s]", "", re.split(r"\.|::|->", name)[-1])


def evaluate(text, known=None):
    """The Value of an expression.

    Parameters
    ----------
    text : str
        As :func:`~dhlab.doctor.tables.language.letters.unified` gives it.
    known : dict of str to str, float or Value, optional
        What letters stand for, by :func:`key`; what is worked out of it is kept there.

    Raises
    ------
    NoExpression
        It is none, or too long or deep.

    Examples
    --------
    >>> evaluate("q2 - np.pi/2")
    Value(number=-1.5707963267948966, letters={'q2': 1.0}, unit='rad')
    >>> evaluate("L1 + 0.1", {"L1": "3*0.1"}).number
    0.4
    """
    try:
        value = _Parser(_tokens(text), known or {}, 0).whole()
    except (ZeroDivisionError, OverflowError, ValueError, TypeError, RecursionError):
        raise NoExpression(text) from None
    if not math.isfinite(value.number):
        raise NoExpression(text)
    return value


def _tokens(text):
    if len(text) > LONGEST:
        raise NoExpression(text[:20])
    found, at, text = [], 0, text.strip()
    while at < len(text):
        match = TOKEN.match(text, at)
        if not match:
            raise NoExpression(text)
        found.append((match.lastgroup, match.group(match.lastgroup)))
        at = match.end()
    return found


class _Parser:
    def __init__(self, tokens, known, depth, seen=()):
        self.tokens, self.at, self.known, self.depth, self.seen = tokens, 0, known, depth, seen

    def whole(self):
        value = self.sum()
        if self.at < len(self.tokens):
            raise NoExpression
        return value

    def peek(self, ahead=0):
        at = self.at + ahead
        return self.tokens[at] if at < len(self.tokens) else (None, None)

    def take(self):
        self.at += 1
        return self.tokens[self.at - 1]

    def expect(self, mark):
        if self.peek() != ("op", mark):
            raise NoExpression
        self.take()

    def sum(self):
        self.depth += 1
        if self.depth > DEEPEST:
            raise NoExpression
        value = self.product()
        while self.peek() in (("op", "+"), ("op", "-")):
            sign = 1.0 if self.take()[1] == "+" else -1.0
            value = _added(value, self.product().times(sign))
        self.depth -= 1
        return value

    def product(self):
        value = self.power()
        while True:
            kind, mark = self.peek()
            if (kind, mark) == ("op", "*"):
                self.take()
                if self.peek()[1] in (None, "+", "-", ")", ",") and value.letters:
                    continue  # q1* marks the joint variable
                value = _multiplied(value, self.power())
            elif (kind, mark) == ("op", "/"):
                self.take()
                below = self.power()
                if below.letters:
                    raise NoExpression
                value = value.times(1 / below.number)
            elif kind == "deg" or (kind == "name" and self._is_unit(mark)):
                self.take()
                value = _in_unit(value, "deg" if kind == "deg" else UNITS[mark.lower()])
            elif kind == "name" or ((kind, mark) == ("op", "(") and not value.letters):
                value = _multiplied(value, self.power())
            else:
                return value

    def _is_unit(self, name):
        return name.lower() in UNITS and self.peek(1) != ("op", "(")

    def power(self):
        kind, mark = self.peek()
        if (kind, mark) in (("op", "-"), ("op", "+")):
            self.take()
            self.depth += 1
            if self.depth > DEEPEST:
                raise NoExpression
            value = self.power()
            self.depth -= 1
            return value.times(-1.0) if mark == "-" else value
        value = self.atom()
        if self.peek() in (("op", "**"), ("op", "^")):
            self.take()
            if self.peek()[1] in (None, "+", "-", ")") and value.letters:
                return value
            exponent = self.power()
            if value.letters or exponent.letters or abs(exponent.number) > 8:
                raise NoExpression
            result = value.number**exponent.number
            if isinstance(result, complex):
                raise NoExpression
            return Value(float(result), {}, value.unit if exponent.number == 1 else "")
        return value

    def atom(self):
        kind, text = self.take() if self.at < len(self.tokens) else (None, None)
        if kind == "number":
            return Value(float(text))
        if (kind, text) == ("op", "("):
            value = self.sum()
            self.expect(")")
            return value
        if kind == "name":
            return self.named(text)
        raise NoExpression

    def named(self, text):
        name = key(text)
        low = text.split(".")[-1].split("::")[-1].lower()
        if self.peek() == ("op", "(") and not (
            (JOINT_VALUES.fullmatch(low) or low not in CALLED | UNITS.keys()) and self.is_indexed()
        ):
            return self.called(low)
        if self.peek()[1] in ("(", "[") and self.peek(1)[0] == "number":
            bracket, index = self.take()[1], self.take()[1]
            if bracket == "[" and self.peek() == ("op", ",") and self.peek(1)[0] == "number":
                self.take()
                index = f"{index},{self.take()[1]}"
            self.expect(")" if bracket == "(" else "]")
            listed = f"{name}[{int(index) - 1}]" if bracket == "(" and index.isdigit() else ""
            listed = listed or f"{name}[{index}]"  # MATLAB counts from 1
            if listed in self.known and listed not in self.seen:
                return self.looked_up(listed)
            return Value(0.0, {f"{name}[{index}]": 1.0})
        if name in self.known and name not in self.seen and len(self.seen) < 8:
            return self.looked_up(name)
        if low in CONSTANTS:
            return Value(CONSTANTS[low], {}, "rad")
        if low in ("deg", "degree", "degrees"):
            return Value(math.pi / 180, {}, "rad")
        if low in ("rad", "mm", "cm") or low in ("inf", "nan", "none", "true", "false", "null"):
            raise NoExpression
        return Value(0.0, {name: 1.0})

    def is_indexed(self):
        """Whether the number of a joint stands between the brackets that follow."""
        index = self.peek(1)
        joint = index[0] == "number" and index[1].isdigit() and len(index[1]) == 1
        return joint and self.peek(2) == ("op", ")")

    def looked_up(self, name):
        """What a letter stands for; each is worked out once, whoever asks."""
        given = self.known[name]
        if isinstance(given, str):
            inner = _Parser(_tokens(given), self.known, self.depth + 1, (*self.seen, name))
            given = self.known[name] = inner.whole()
        return given if isinstance(given, Value) else Value(float(given))

    def called(self, low):
        self.expect("(")
        arguments = [self.sum()]
        while self.peek() == ("op", ",") and len(arguments) < 3:
            self.take()
            arguments.append(self.sum())
        self.expect(")")
        first = arguments[0]
        if low in TO_RADIANS and len(arguments) == 1:
            return Value(math.radians(first.number), first.letters, "rad")
        if low in ("rational",) and len(arguments) == 2:
            return first.times(1 / arguments[1].number)
        if low in ("degrees", "rad2deg", "r2d") and len(arguments) == 1 and not first.letters:
            return Value(math.degrees(first.number), {}, "deg")
        if low in PLAIN and len(arguments) == 1 and (low != "s" or not first.letters):
            return first
        if any(argument.letters for argument in arguments):
            raise NoExpression
        numbers = [
            math.radians(argument.number) if argument.unit == "deg" else argument.number
            for argument in arguments
        ]
        if low in INVERSE:
            return Value(INVERSE[low](*numbers), {}, "rad")
        if low in FUNCTIONS:
            return Value(float(FUNCTIONS[low](*numbers)))
        raise NoExpression


def _in_unit(value, unit):
    """``90 deg``: the number keeps the unit; ``(0.1 m) deg`` is no expression."""
    if value.unit == unit:
        return value
    if value.unit:
        raise NoExpression
    return Value(value.number, value.letters, unit)


def _added(a, b):
    if {a.unit, b.unit} == {"rad", "deg"}:
        a, b = _radians(a), _radians(b)
    if a.unit and b.unit and a.unit != b.unit:
        raise NoExpression
    letters = dict(a.letters)
    for name, share in b.letters.items():
        letters[name] = letters.get(name, 0.0) + share
    letters = {name: share for name, share in letters.items() if share}
    return Value(a.number + b.number, letters, a.unit or b.unit)


def _radians(value):
    return Value(math.radians(value.number), value.letters, "rad") if value.unit == "deg" else value


def _multiplied(a, b):
    if a.letters and b.letters:
        raise NoExpression
    a, b = (b, a) if b.letters else (a, b)
    if a.unit and b.unit and {a.unit, b.unit} != {"rad"}:
        raise NoExpression
    return a.times(b.number, b.unit)
