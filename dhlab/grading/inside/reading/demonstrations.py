"""Which cells of a lesson need not run when it is graded: those as they were handed out that only
show something, and make nothing that an answer uses.
"""

import builtins
from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from hashlib import sha256

from .notebook import Cell
from .slices import UNREADABLE, statements

__all__ = ["print_of", "showing", "skippable"]

BUILTINS = frozenset(dir(builtins))
LAST_VALUE = "_"  # what the cell above showed, whichever that is


def print_of(source: str) -> str:
    """A fingerprint of a cell's source, to know it again."""
    return sha256(source.strip().encode("utf-8", "replace")).hexdigest()[:16]


def skippable(
    cells: Sequence[Cell],
    untouched: Collection[str],
    used: Iterable[str],
    answered: Mapping[int, Collection[str]] = {},
) -> set[int]:
    """The numbers of the cells that need not run.

    Parameters
    ----------
    cells : sequence of Cell
    untouched : collection of str
        The fingerprints of the cells as they were handed out.
    used : iterable of str
        Names that are read at the end, whatever the cells say.
    answered : mapping of int to collection of str
        Names that are read once a cell of this number has run.
    """
    read = [statements(0, cell.source) for cell in cells]
    modules = {name for found in read for one in found or () if one.imports for name in one.writes}
    settled = {n for n, cell in enumerate(cells) if print_of(cell.source) in untouched}
    own = (one for n, found in enumerate(read) if n not in settled for one in found or ())
    if any(one.reads & {*UNREADABLE, LAST_VALUE} for one in own):
        return set()  # nobody sees what an answer uses
    run = {
        number
        for number, (cell, found) in enumerate(zip(cells, read))
        if found is None or cell.ids or number not in settled or any(one.always for one in found)
    }
    names = set(used), {number: set(answered.get(number, ())) for number in run}
    while more := _makers(read, run, modules, names, settled):
        run |= more
    return set(range(len(cells))) - run


def showing(cells: Sequence[Cell], untouched: Collection[str]) -> frozenset[str]:
    """The lesson's own functions that only show something: each as it was handed out, bound there
    alone, and made of nothing but Python's own functions and modules. A call whose answer nobody
    takes need not be made.
    """
    read = [statements(0, cell.source) or () for cell in cells]
    known = BUILTINS | _modules(read)
    bound = Counter(name for found in read for one in found for name in one.writes)
    return frozenset(
        name
        for cell, found in zip(cells, read)
        for one in found
        if one.harmless and not one.always and print_of(cell.source) in untouched
        for name in one.writes
        if bound[name] == 1 and one.reads <= known
    )


def _modules(read):
    return {name for found in read for one in found or () if one.imports for name in one.writes}


def _makers(read, run, modules, names, settled):
    """The cells beside those that run which make what one of these reads. What a cell as it was
    handed out (``settled``) binds anew no cell before it makes.
    """
    used, answered = names
    late: set[str] = set()
    for number in run:
        for one in read[number] or ():
            if one.defines:
                late |= one.reads  # read when it is called, which may be later
    needed, found = late | used, set()
    for number in reversed(range(len(read))):
        if number not in run:
            if not _written(read[number], modules) & needed:
                continue
            found.add(number)
        needed |= answered.get(number, set())
        if number in settled:
            needed -= _bound(read[number] or ()) - late
        needed |= _from_before(read[number] or ())
    return found


def _from_before(statements):
    """The names that a cell reads and has not bound itself by then."""
    found: set[str] = set()
    for number, one in enumerate(statements):
        found |= one.reads - _bound(statements[:number])
    return found


def _bound(statements):
    """The names that a cell binds whatever happens, unless it stops."""
    return {name for one in statements for name in one.assigns}


def _written(statements, modules):
    """What a cell binds or changes; a call of a module's function changes no module."""
    return {name for one in statements for name in one.writes if name not in modules or one.imports}
