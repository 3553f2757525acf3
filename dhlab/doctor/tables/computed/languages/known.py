"""A text as a program, in whatever language it is written."""

from .clike.dialect import Braces
from .clike.translating import as_python as from_braces
from .clike.translating import is_clike
from .matlab.dialect import Matlab
from .matlab.translating import as_python as from_matlab
from .matlab.translating import is_matlab
from .python import statements_of

__all__ = ["statements_in"]


def statements_in(text):
    """(The statements of a program, the dialect that they are in); none of another text, and no
    dialect of Python.

    Examples
    --------
    >>> statements, dialect = statements_in("T = eye(4);  % start")
    >>> len(statements), type(dialect).__name__
    (1, 'Matlab')
    """
    if is_matlab(text):
        return statements_of(from_matlab(text), True), Matlab()
    if is_clike(text):
        return statements_of(from_braces(text), True), Braces()
    return statements_of(text), None
