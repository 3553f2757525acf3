"""A text as a program, in whatever language it is written."""

import ast
import re
from textwrap import dedent

from ..held.budget import FAILURES
from .clike.dialect import Braces
from .clike.translating import as_python as from_braces
from .clike.translating import is_clike
from .matlab.dialect import Matlab
from .matlab.translating import as_python as from_matlab
from .matlab.translating import is_matlab
from .python import parsed, statements_of

OPEN_END = r"[-+*/=,.@(]$"  # of a line that goes on

__all__ = ["statements_in"]


def statements_in(text):
    """(The statements of a program, the dialect that they are in, whether they are all of it); none
    of another text, and no dialect of Python.

    Examples
    --------
    >>> statements, dialect, whole = statements_in("T = eye(4);  % start")
    >>> len(statements), type(dialect).__name__, whole
    (1, 'Matlab', True)
    """
    try:
        if is_matlab(text):
            return _functions_first(from_matlab(text)), Matlab(), _is_closed(text)
        if is_clike(text):
            return _functions_first(from_braces(text)), Braces(), _is_closed(text)
        return statements_of(text), None, _is_closed(text) and parsed(dedent(text)) is not None
    except FAILURES:  # brackets in brackets in brackets
        return [], None, False


def _functions_first(text):
    """The statements of a translated program: its functions are known before they stand there."""
    found = statements_of(text, True)
    return sorted(found, key=lambda node: not isinstance(node, ast.FunctionDef))


def _is_closed(text):
    """Whether a text ends with a line and closes its brackets."""
    last = text.rstrip().rsplit("\n", 1)[-1].strip()
    pairs = ("()", "[]", "{}")
    return all(text.count(a) == text.count(b) for a, b in pairs) and not re.search(OPEN_END, last)
