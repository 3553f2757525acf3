"""Reads one cell as Jupyter would: its statements, with magics turned into calls."""

import ast
import linecache
import re
from functools import cache

__all__ = ["BODY_RUNS", "parsed", "plain"]

BODY_RUNS = ("time", "timeit", "capture", "prun")  # cell magics whose cell is Python to be run
COMMENT = re.compile("#[^'\"]*$")  # up to the end of a line, whatever stands in quotes before


def parsed(source: str, name: str) -> list[ast.stmt]:
    """The statements of a cell; SyntaxError where it is no Python."""
    source = plain(source)
    linecache.cache[name] = len(source), None, source.splitlines(keepends=True), name
    return list(_nodes(source))


@cache  # what the warm parent has read of the lessons is read already in every copy of it
def _nodes(source):
    return tuple(one for node in ast.parse(source, "<cell>").body for one in _unpacked(node))


def _unpacked(node):
    """The statements below a cell magic that runs them, such as ``%%time``, in which other magics
    may stand; else the node.
    """
    match node:
        case ast.Expr(
            ast.Call(
                ast.Attribute(ast.Call(ast.Name("get_ipython")), "run_cell_magic"),
                [ast.Constant(magic), _, ast.Constant(str(body))],
            )
        ) if magic in BODY_RUNS:
            inner = ast.parse(plain(body), "<cell>").body
            return [one for node in inner for one in _unpacked(node)]
    return [node]


@cache
def plain(source: str) -> str:
    """The source with magics turned into calls, as IPython does it; itself where it has none.

    Examples
    --------
    >>> plain("x = 1  # why 1?"), plain("%matplotlib inline").strip()
    ('x = 1  # why 1?', "get_ipython().run_line_magic('matplotlib', 'inline')")
    """
    if not any(map(_may_hold_a_magic, source.splitlines())):
        return source
    from .magics import without_magics  # large: only where there is one

    return without_magics(source)


def _may_hold_a_magic(line):
    """Whether a line may be more than Python. A comment may ask something, and often does."""
    line = line.strip()
    return (
        line.startswith(("%", "!", "?"))
        or (line.endswith("?") and not COMMENT.search(line))
        or any(sign in line for sign in ("= %", "=%", "= !", "=!"))
    )
