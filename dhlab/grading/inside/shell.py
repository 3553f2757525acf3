"""Runs one cell the way Jupyter would, without Jupyter: magics, top-level await, and libraries that
this machine does not have.
"""

import __future__

import ast
import builtins
import importlib
import sys
from collections.abc import Collection, Iterable
from types import FunctionType
from typing import Any, ClassVar

import numpy as np

from .reading.cells import BODY_RUNS, parsed

__all__ = ["Absent", "run_cell", "run_statement"]

MISSING = "module_that_is_not_there"  # its type, to who is told of an answer
FLAGS = ast.PyCF_ALLOW_TOP_LEVEL_AWAIT
LINE_RUNS = ("time", "prun")
FILE_WRITTEN = ("writefile", "file")
VALUE, LAST = "_value_of_cell", "_last_value"  # names that no notebook has
# what the library works out for a reader, and what could do more than that in its arguments
SHOWN = ("diagnose", "diagnose_axes", "diagnose_function", "equivalent", "compare")
ACTING = (ast.Call, ast.NamedExpr, ast.Await, ast.Yield, ast.YieldFrom)


class Absent:
    """Stands for a library that is not here, and for everything that is asked of it. Around a
    function or a class it gives back that, as ``njit`` does; around numbers or things that are gone
    through it goes through them, as ``prange`` and ``tqdm`` do. The packages of which something
    was asked are noted in ``used``.
    """

    used: ClassVar[set[str]] = set()

    def __init__(self, package="", name="", given=()):
        self._package, self._name, self._given = package, name, given

    def __getattr__(self, name):
        if name.startswith("__") and name.endswith("__"):
            raise AttributeError(name)
        Absent.used.add(self._package)
        return Absent(self._package, name)

    def __call__(self, *args, **kwargs):
        Absent.used.add(self._package)
        match args:
            case [FunctionType() as own] if self._name == "vectorize":
                return np.vectorize(own)
            case [(FunctionType() | type()) as own]:
                return own
        return Absent(self._package, self._name, args)

    def __iter__(self):
        match self._given:
            case [int(), *_]:
                return iter(range(*self._given))
            case [Iterable() as first, *_]:
                return iter(first)
        return iter(())

    def __getitem__(self, key):
        return self

    def __setitem__(self, key, value):
        """A setting of it: nobody asks."""

    def __enter__(self):
        return self

    def __exit__(self, *error):
        return False


Absent.__name__ = MISSING


class Shell:
    """What ``get_ipython()`` gives: magics do nothing, but for those that time or capture Python,
    which is run, and those that write a file and run it.
    """

    def __init__(self, name, space):
        self.name, self.space = name, space

    def run_line_magic(self, magic, line, **options):
        """A line such as ``%matplotlib inline``."""
        if magic in LINE_RUNS:
            run_cell(line, self.name, self.space)
        elif magic == "run" and line:
            with open(line.split()[0], encoding="utf-8") as file:
                run_cell(file.read(), self.name, self.space)

    def run_cell_magic(self, magic, line, cell):
        """A cell that begins with ``%%``."""
        if magic in BODY_RUNS:
            run_cell(cell, self.name, self.space)
        elif magic in FILE_WRITTEN and line:
            *options, file_name = line.split()
            with open(
                file_name.strip("\"'"), "a" if "-a" in options else "w", encoding="utf-8"
            ) as file:
                file.write(cell)
            importlib.invalidate_caches()

    def getoutput(self, command, **options):
        """``x = !command``: nothing comes back."""
        return []

    def __getattr__(self, name):
        return Absent()


def run_cell(source: str, name: str, space: dict[str, Any], showing: Collection[str] = ()) -> None:
    """Run the source of a cell in a namespace; raises what it raises. Of the functions ``showing``
    no answer is wanted.
    """
    nodes = parsed(source, name)
    for number, statement in enumerate(nodes, 1):
        if _only_shows(statement, space, showing):
            continue
        if number == len(nodes) and isinstance(statement, ast.Expr) and source.rstrip()[-1] != ";":
            _run_last(statement, name, space)
        else:
            run_statement(statement, name, space)


def _run_last(statement, name, space):
    """Run the expression at the end of a cell, which Jupyter shows: its value is ``_`` in the cells
    below, unless the notebook has bound a ``_`` of its own.
    """
    node = ast.copy_location(ast.Assign([ast.Name(VALUE, ast.Store())], statement.value), statement)
    run_statement(ast.fix_missing_locations(node), name, space)
    value = space.pop(VALUE, None)
    if value is not None and space.get("_") is space.get(LAST):
        space["_"] = space[LAST] = value


def _only_shows(statement, space, showing=()):
    """Whether a statement does nothing but show what the library, or a function ``showing``, finds,
    as ``print(dh.diagnose(table, q, poses))`` does: nobody looks, and it may take long.
    """
    node = statement.value if isinstance(statement, ast.Expr) else None
    match node:
        case ast.Call(ast.Name("print"), [printed], []) if "print" not in space:
            node = printed
    match node:
        case ast.Call(ast.Attribute(ast.Name("dh"), called)) if called in SHOWN:
            return space.get("dh") is sys.modules.get("dhlab") and not _acts_within(node)
        case ast.Call(ast.Name(called)) if called in showing:
            return not _acts_within(node)
    return False


def _acts_within(call):
    return any(isinstance(one, ACTING) for one in ast.walk(call) if one is not call)


def run_statement(statement: ast.stmt, name: str, space: dict[str, Any]) -> None:
    """Run one statement of a cell in a namespace; raises what it raises."""
    space["get_ipython"] = lambda: Shell(name, space)
    space.setdefault("display", lambda *values, **options: None)
    later = space.get("annotations") is __future__.annotations  # imported by any cell before
    flags = FLAGS | (__future__.annotations.compiler_flag if later else 0)
    code = compile(ast.Module([statement], []), name, "exec", flags=flags)
    try:
        if code.co_flags & 0x80:  # CO_COROUTINE: it awaits something
            import asyncio  # large, and hardly anybody awaits

            asyncio.run(eval(code, space))
        else:
            exec(code, space)
    except ImportError:
        if not isinstance(statement, (ast.Import, ast.ImportFrom)):
            raise
        _import_what_is_there(statement, space)


def _import_what_is_there(statement, space):
    """Each name of an import by itself; what is not here is stood in for."""
    for alias in statement.names:
        own = alias.asname or alias.name.split(".")[0]
        try:
            if isinstance(statement, ast.Import):
                module = builtins.__import__(alias.name, space)
                space[own] = module if not alias.asname else __import__("sys").modules[alias.name]
            else:
                exec(
                    compile(
                        ast.Module(
                            [
                                ast.ImportFrom(
                                    statement.module,
                                    [alias],
                                    statement.level,
                                    lineno=1,
                                    col_offset=0,
                                )
                            ],
                            [],
                        ),
                        "<import>",
                        "exec",
                    ),
                    space,
                )
        except ImportError:
            package = getattr(statement, "module", None) or alias.name
            space[own] = Absent(package.partition(".")[0], alias.name)
