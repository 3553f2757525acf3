"""Enumerations and records of a language with braces, in Python's grammar."""

from ..brackets import split
from .declarations import closing, parameters
from .tokens import expression

__all__ = ["enumeration", "fields", "record"]


def enumeration(tokens, at):
    """(Lines that number the names of an enumeration, the place behind it)."""
    start = next(k for k in range(at, len(tokens)) if tokens[k][1] in ("{", ";"))
    end = closing(tokens, start)
    parts = [one for one in split(tokens[start + 1 : end], ",") if one]
    lines = [
        f"{part[0][1]} = {expression(part[2:]) if len(part) > 2 else k}"
        for k, part in enumerate(parts)
    ]
    return lines, end + 1


def record(tokens, at):
    """(Lines of a class of which only the fields are said, the place behind it): ``record
    Joint(double A, double D)``, whose round bracket stands at this place.
    """
    end = closing(tokens, at)
    lines = [f"class {tokens[at - 1][1]}:"]
    for name in parameters(tokens[at + 1 : end]):
        field, _, usual = name.partition("=")
        lines.append(f"    {field}: float{f' = {usual}' if usual else ''}")
    return lines, end + 1


def fields(tokens, at):
    """The lines that tell of the fields of a struct."""
    start = next(k for k in range(at, len(tokens)) if tokens[k][1] in ("{", ";", "(", "="))
    if tokens[start][1] != "{":
        return []
    names = []
    for part in split(tokens[start + 1 : closing(tokens, start)], ";"):
        if part and not any(text in ("(", "{") for _, text in part):
            ends = [one for one in split(split(part, "=")[0], ",") if one]
            names += [one[-1][1] for one in ends if one[-1][0] == "name"]
    return [f"_struct({names!r})"]
