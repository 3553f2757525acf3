"""Functions within an expression of a language with braces: they are written before it."""

from ...interpreting.calling import INLINE
from ..brackets import deeper, split
from .declarations import closing, closing_or_none
from .tokens import NoProgram, expression

__all__ = ["before", "fields_taken", "taken_apart"]


def before(writer, tokens):
    """Tokens in which functions without a name, ``(q) => {…}`` and ``function (q) {…}``, are names
    of functions that are written now.
    """
    while (found := _found(tokens)) is not None:
        start, given, body, end = found
        named = tokens[start - 1 : start] == [("op", "=")] and end == len(tokens)
        name = tokens[start - 2][1] if named else f"{INLINE}{writer.inlined}"
        parts = [_plain(part) for part in split(given, ",") if part]
        names = [part[0][1] if len(part) == 1 else f"_given{k}" for k, part in enumerate(parts)]
        taken = [pair for pair in zip(parts, names) if len(pair[0]) > 1]
        writer.inline(name, names, taken, body)
        tokens = [*tokens[:start], ("name", name), *tokens[end:]]
    return tokens


def fields_taken(pattern, value):
    """The assignments of ``const {a, d} = row`` and ``const [a, d] = row``."""
    names = [part[0][1] for part in split(pattern[1:-1], ",") if part]
    if pattern[0][1] == "{":
        return [f"{name} = {value}.{name}" for name in names]
    return [f"{name} = {value}[{k}]" for k, name in enumerate(names)]


def taken_apart(tokens):
    """The lines of what takes a value apart, ``{a, d} = row``; nothing of all else."""
    end = closing_or_none(tokens, 0) or len(tokens)
    if tokens[end + 1 : end + 2] != [("op", "=")] or tokens[0][1] not in ("{", "["):
        return []
    value = f"_taken = {expression(tokens[end + 2 :])}"
    return [value, *fields_taken(tokens[: end + 1], "_taken")]


def _found(tokens):
    """(start, tokens of the parameters, tokens of the body, end) of the first function without a
    name, which those within it are written in; None without one.
    """
    for at, (kind, text) in enumerate(tokens):
        if text == "=>" and kind == "op":
            start = at - 1
            if tokens[start][1] == ")":
                start = _opening(tokens, start)
                given = tokens[start + 1 : at - 1]
            else:
                given = tokens[start:at]
            return start, given, *_body(tokens, at + 1)
        if text == "function" and tokens[at + 1 : at + 2] == [("op", "(")]:
            close = closing(tokens, at + 1)
            return at, tokens[at + 2 : close], *_body(tokens, close + 1)
    return None


def _opening(tokens, at):
    """The place of the bracket that one closes."""
    depth = 0
    for k in range(at, -1, -1):
        depth -= deeper(tokens[k])
        if depth == 0:
            return k
    raise NoProgram


def _body(tokens, at):
    """(A block in its braces, or the tokens of an expression, the place behind it)."""
    if tokens[at] == ("op", "{"):
        end = closing(tokens, at) + 1
        return tokens[at:end], end
    depth = 0
    for end in range(at, len(tokens)):
        depth += deeper(tokens[end])
        if depth < 0 or (depth == 0 and tokens[end] in (("op", ","), ("op", ";"))):
            return tokens[at:end], end
    return tokens[at:], len(tokens)


def _plain(part):
    """A parameter: its name alone, or the pattern that takes it apart."""
    if part[0] in (("op", "{"), ("op", "[")):
        return part[: closing(part, 0) + 1]
    names = [one for one in split(part, "=", ":")[0] if one[0] == "name"]
    if not names:
        raise NoProgram
    return names[-1:]
