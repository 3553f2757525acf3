"""SymPy's symbols, as what is not known, and what a program says of them later."""

import re

from ..held.budget import Unsupported
from ..held.values import Native, Unknown, is_number, items_of, number_of

__all__ = ["SYMBOLS"]

RANGE = re.compile(r"(\w*?)(\d*):(\d+)$")
MOST = 40


def _names(text):
    found = []
    for word in re.split(r"[\s,]+", text.strip()):
        ranged = RANGE.match(word)
        if ranged:
            first, last = int(ranged[2] or 0), int(ranged[3])
            if last - first > MOST:
                raise Unsupported("too many symbols")
            found += [f"{ranged[1]}{k}" for k in range(first, last)]
        elif word:
            found.append(word)
    return found


def _symbols(run, args, kwargs):
    if not args or not isinstance(args[0], str):
        raise Unsupported("no names")
    names = _names(args[0])
    found = tuple(Unknown(name, run.samples) for name in names)
    alone = len(found) == 1 and ":" not in args[0] and "," not in args[0]
    return found[0] if alone else found


def _of_time(run, args, kwargs):
    """``Function("theta")`` and ``dynamicsymbols``: names of what changes with time."""
    found = _symbols(run, args, kwargs)
    return Native("of time", lambda *_: found)


def _lambdified(run, args, kwargs):
    """The function of an expression: the expression, at the numbers that stand in it."""
    return Native("lambdified", lambda *_: args[1])


def substituted(run, value, args):
    """A value of which a program says what its letters are: the next run knows it. Where it says of
    one joint that it stays as it is, ``q1: q1``, the numbers of others are no pose.
    """
    pairs = [args] if len(args) == 2 else items_of_pairs(args[0] if args else {})
    pairs = [pair for pair in pairs if isinstance(pair[0], Unknown) and is_number(pair[1])]
    run.stays |= any(pair[0] == pair[1] for pair in pairs)
    for letter, number in pairs:
        if not isinstance(number, Unknown) or (number.path == letter.path and number.steps):
            run.told[letter.path] = float(number_of(number))
    return value


def items_of_pairs(given):
    """The pairs of a dictionary, or of a list of them."""
    if isinstance(given, dict):
        return list(given.items())
    return [tuple(items_of(one))[:2] for one in items_of(given)]


SYMBOLS = {
    "symbols": _symbols, "Symbol": _symbols, "var": _symbols, "Function": _of_time,
    "dynamicsymbols": _symbols, "lambdify": _lambdified,
    "Rational": lambda run, args, _: number_of(args[0]) / number_of(args[1]),
    "subs": lambda run, args, _: substituted(run, args[0], args[1:]),
    "input": lambda run, args, _: run.unknown("input"),
}  # fmt: skip
