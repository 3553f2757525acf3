"""The value of a short expression: numbers, pi, units, a few functions and letters. A recursive
descent with limits on length and depth; nothing is ever evaluated by Python.

A value is affine in the letters it holds: ``q2 + pi/2`` is pi/2 plus 1 · q2.
"""

import math
import re

from .values import NoExpression, Value, added, in_unit, multiplied
from .vocabulary import (
    CALLED,
    CONSTANTS,
    FUNCTIONS,
    INVERSE,
    JOINT_VALUES,
    PLAIN,
    TO_RADIANS,
    UNITS,
)

__all__ = ["NoExpression", "Value", "evaluate", "key"]

LONGEST, DEEPEST = 200, 24
TOKEN = re.compile(
    r"\s*(?:(?P<number>(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)(?:[fFlL](?![\w.]))?"
    r"|(?P<name>[A-Za-z_][A-Za-z_0-9]*(?:(?:\.|::|->)[A-Za-z_]\w*)*)|(?P<deg>°)|(?P<quote>'')"
    r"|(?P<op>\*\*|[-+*/^()\[\],]))"
)


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
            value = added(value, self.product().times(sign))
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
                value = multiplied(value, self.power())
            elif (kind, mark) == ("op", "/"):
                self.take()
                below = self.power()
                if below.letters:
                    raise NoExpression
                value = value.times(1 / below.number)
            elif kind == "deg" or (kind == "name" and self._is_unit(mark)):
                self.take()
                value = in_unit(value, "deg" if kind == "deg" else UNITS[mark.lower()])
            elif kind == "name" or ((kind, mark) == ("op", "(") and not value.letters):
                value = multiplied(value, self.power())
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
