"""Dots that stand in a learner's program where a part of it is still to be written."""

import ast
import inspect
import textwrap
from typing import Any

__all__ = ["lines_with_dots"]


def lines_with_dots(f: Any) -> list[int]:
    """The lines of a function's file or cell in which dots are left; none where its text cannot be
    had. Dots in square brackets, as in ``T[..., 3]``, choose entries of an array and are no gap.

    Examples
    --------
    >>> def half_written(x):
    ...     return x[..., 0] if len(x) else ...
    >>> lines_with_dots(half_written)
    [2]
    """
    try:
        lines, first = inspect.getsourcelines(f)
        tree = ast.parse(textwrap.dedent("".join(lines)))
    except (OSError, TypeError, SyntaxError):
        return []
    if not isinstance(tree.body[0], ast.FunctionDef):
        return []  # a lambda's text is that of the line it stands in
    chosen = {
        inner
        for node in ast.walk(tree)
        if isinstance(node, ast.Subscript)
        for inner in ast.walk(node.slice)
    }
    dots = {
        node.lineno
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and node.value is Ellipsis and node not in chosen
    }
    return [first - 1 + line for line in sorted(dots)]
