"""Which cells of a lesson need not run when it is graded: those as they were handed out that only
show something, and make nothing that an answer uses.
"""

import ast
from collections.abc import Collection, Iterable, Sequence
from hashlib import sha256

from .cells import parsed
from .notebook import Cell
from .slices import Statement, statement

__all__ = ["print_of", "skippable"]

DEFINING = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Lambda)


def print_of(source: str) -> str:
    """A fingerprint of a cell's source, to know it again."""
    return sha256(source.strip().encode("utf-8", "replace")).hexdigest()[:16]


def skippable(cells: Sequence[Cell], untouched: Collection[str], used: Iterable[str]) -> set[int]:
    """The numbers of the cells that need not run.

    Parameters
    ----------
    cells : sequence of Cell
    untouched : collection of str
        The fingerprints of the cells as they were handed out.
    used : iterable of str
        Names that are read whatever the cells say.
    """
    read = [_read(number, cell.source) for number, cell in enumerate(cells)]
    modules = {
        name
        for found in read
        for one in found or ()
        if isinstance(one.node, (ast.Import, ast.ImportFrom))
        for name in one.writes
    }
    run = {
        number
        for number, (cell, found) in enumerate(zip(cells, read))
        if found is None
        or cell.ids
        or print_of(cell.source) not in untouched
        or any(one.always for one in found)
    }
    while more := _makers(read, run, modules, set(used)):
        run |= more
    return set(range(len(cells))) - run


def _makers(read, run, modules, late):
    """The cells beside those that run which make what one of these reads."""
    for number in run:
        for one in read[number] or ():
            if any(isinstance(inner, DEFINING) for inner in ast.walk(one.node)):
                late |= one.reads  # read when it is called, which may be later
    needed, found = set(late), set()
    for number in reversed(range(len(read))):
        if number in run:
            needed |= _from_before(read[number] or ())
        elif _written(read[number], modules) & needed:
            found.add(number)
    return found


def _from_before(statements):
    """The names that a cell reads and has not bound itself by then."""
    found: set[str] = set()
    own: set[str] = set()
    for one in statements:
        found |= one.reads - own
        if isinstance(one.node, ast.Assign):
            own |= {target.id for target in one.node.targets if isinstance(target, ast.Name)}
    return found


def _written(statements, modules):
    """What a cell binds or changes; a call of a module's function changes no module."""
    return {
        name
        for one in statements
        for name in one.writes
        if name not in modules or isinstance(one.node, (ast.Import, ast.ImportFrom))
    }


def _read(number: int, source: str) -> list[Statement] | None:
    try:
        return [statement(number, node) for node in parsed(source, f"<cell {number + 1}>")]
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None
