"""Brackets among the tokens of a program, (kind, text) each, which all the languages share."""

__all__ = ["CLOSED", "deeper", "split"]

CLOSED = {"(": ")", "[": "]", "{": "}"}


def deeper(token):
    """1 for a bracket that opens, -1 for one that closes, 0 for anything else."""
    kind, text = token
    return (kind == "op") * ((text in CLOSED) - (text in CLOSED.values()))


def split(tokens, *marks):
    """The tokens, cut at marks that stand in no bracket.

    Examples
    --------
    >>> split([("name", "a"), ("op", ","), ("name", "b")], ",")
    [[('name', 'a')], [('name', 'b')]]
    """
    parts: list = [[]]
    depth = 0
    for token in tokens:
        depth += deeper(token)
        if token[0] == "op" and token[1] in marks and depth <= 0:
            parts.append([])
        else:
            parts[-1].append(token)
    return parts
