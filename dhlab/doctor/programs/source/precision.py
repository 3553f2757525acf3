"""Whether a program computes in single precision: its answers do, or its text says so."""

import ast
import inspect
import linecache
import sys
from functools import lru_cache
from types import ModuleType

import numpy as np

__all__ = ["SINGLE", "says_single", "single_precision"]

# largest deviation of an answer in single precision, absolute and relative: a right chain of six
# links differs by 8 steps of a float32, and by 22 where its angles go through degrees and back
SINGLE = 32 * float(np.finfo(np.float32).eps)
KINDS = (np.float32, np.float16)
NAMES = {"float32", "single", "f4", "f", "float16", "half", "f2", "e"}  # in a text
OF_KINDS = {  # calls that are told by an argument of which kind their numbers are
    "array", "asarray", "astype", "dtype", "empty", "eye", "full", "identity", "ones", "zeros",
}  # fmt: skip
DEEP = 2  # functions that call one another, and are looked at behind the first


def single_precision(f, answers):
    """Whether a program computes with 32 or 16 bits: its answers do, or an array or a number is
    made so in the text of the function, or of one that it calls and that stands where it does.

    Examples
    --------
    >>> single_precision(None, [np.eye(4, dtype=np.float32)]), single_precision(abs, [np.eye(4)])
    (True, False)
    """
    if all(answer.dtype in KINDS for answer in answers):
        return True
    return any(_is_single(node, space) for node, space in _read(f))


def says_single(nodes, space):
    """Whether somewhere within the nodes of a program, whose names are in ``space``, an array or a
    number is made of 32 or 16 bits.

    Examples
    --------
    >>> says_single([ast.parse("np.eye(4, dtype='f4')")], {"np": np})
    True
    """
    return any(_is_single(one, space) for node in nodes for one in ast.walk(node))


def _read(f, deep=DEEP):
    """The nodes of a function's text and of those that it calls, each with the names around it."""
    # what numba compiles wraps the function whose text it is
    f = inspect.unwrap(f) if callable(f) and not hasattr(f, "__globals__") else f
    definition = _definition(f)
    if definition is None:
        return
    space = _around(f, definition)
    used = set()
    for node in ast.walk(definition):
        yield node, space
        used |= {node.id} if isinstance(node, ast.Name) else set()
    for value in map(space.get, used if deep else ()):
        if getattr(value, "__module__", "") == f.__module__ and value is not f:
            for one in vars(value).values() if isinstance(value, type) else [value]:
                yield from _read(one, deep - 1)


def _definition(f):
    """The node that defines a function; None where its text cannot be had."""
    code = getattr(f, "__code__", None)
    if code is None or not hasattr(f, "__globals__"):
        return None
    lines = linecache.getlines(code.co_filename, f.__globals__)
    return _definitions("".join(lines)).get(code.co_firstlineno)


@lru_cache(maxsize=4)
def _definitions(text):
    """The nodes that define the functions of a text, by their first lines; several functions of one
    text are asked about, and one several times.
    """
    try:
        nodes = [*ast.walk(ast.parse(text))]
    except (SyntaxError, ValueError):  # magics of a notebook
        return {}
    return {_first_line(node): node for node in reversed(nodes)}


def _first_line(node):
    """Where a definition begins, with what decorates it; None of anything else."""
    if not isinstance(node, (ast.FunctionDef, ast.Lambda)):
        return None
    return min(one.lineno for one in (node, *getattr(node, "decorator_list", ())))


def _around(f, definition):
    """The names that a function finds: of its cell, of the functions around it, and what it imports
    of numpy by itself.
    """
    code, space = f.__code__, dict(f.__globals__)
    for name, cell in zip(code.co_freevars, f.__closure__ or ()):
        try:
            space[name] = cell.cell_contents
        except ValueError:  # it has no value yet
            continue
    for node in ast.walk(definition):
        for alias in node.names if isinstance(node, (ast.Import, ast.ImportFrom)) else ():
            source = getattr(node, "module", None) or alias.name
            module = sys.modules.get(source)
            whole = isinstance(node, ast.Import)
            space[alias.asname or alias.name] = (
                module if whole else getattr(module, alias.name, None)
            )
    return space


def _is_single(node, space):
    """Whether a node is a kind of number of 32 or 16 bits, or a call that is told one in a text."""
    if isinstance(node, (ast.Name, ast.Attribute)):
        value = _value(node, space)
        return not isinstance(value, str) and _means_single(value)
    if not isinstance(node, ast.Call):
        return False
    told = [word.value for word in node.keywords if word.arg == "dtype"]
    if getattr(node.func, "attr", getattr(node.func, "id", "")) in OF_KINDS:
        told += node.args
    return any(_means_single(_value(one, space)) for one in told)


def _value(node, space):
    """What a literal, a name or the attribute of a module stands for; None of anything else."""
    if isinstance(node, ast.Constant):
        return node.value
    if isinstance(node, ast.Name):
        return space.get(node.id)
    if not isinstance(node, ast.Attribute):
        return None
    home = _value(node.value, space)
    return getattr(home, node.attr, None) if isinstance(home, ModuleType) else None


def _means_single(value):
    """Whether a type, a dtype or the name of one is of 32 or 16 bits."""
    if isinstance(value, str):
        return value.lstrip("<>=") in NAMES
    return any(value is kind for kind in KINDS) or (
        isinstance(value, np.dtype) and value.type in KINDS
    )
