"""What a name of a notebook depends on: the statements that make it, found by reading them.

A statement is taken when it binds, or changes in place, a name that is wanted, by whatever other
name; the names that it reads are wanted then too, until nothing is added. Where reading cannot tell
(``exec``, ``globals``, ``from x import *``) it is taken.
"""

import ast
import symtable
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cache

from .cells import parsed, plain

__all__ = ["UNREADABLE", "Statement", "statement", "statements", "needed"]

UNREADABLE = frozenset(
    "exec eval compile globals locals vars setattr delattr __import__ get_ipython".split()
)
DEFINING = (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Lambda)
# calls that show something and change nothing
SHOWING = frozenset("print display check predict reveal hint given progress view help len".split())
# methods that change what they are called on, also where somebody takes their answer
CHANGING = frozenset(
    "append extend insert pop popitem setdefault update add remove discard clear sort".split()
)


@dataclass(frozen=True)
class Statement:
    """One statement of a cell: the names that it reads, those that it binds or changes, and those
    that it ``assigns`` whatever happens; those that ``act`` in it, so that it is taken when one of
    them is wanted: what a call reads, a decorator, what a class inherits from; that of whose object
    it binds a part or another name (``alias``); whether it is taken ``always``, makes functions or
    classes (``defines``), is a function that changes nothing when it is called (``harmless``), or
    ``imports``. All is found when it is read, which the warm parent does once.
    """

    cell: int
    node: ast.stmt
    reads: frozenset[str]
    writes: frozenset[str]
    assigns: frozenset[str] = frozenset()
    act: frozenset[str] = frozenset()
    alias: str = ""
    always: bool = False
    defines: bool = False
    harmless: bool = False
    imports: bool = False


def statements(cell: int, source: str) -> list[Statement] | None:
    """The Statements of a cell; None where it is no Python. A cell is read once, whatever number
    it has.

    Examples
    --------
    >>> [sorted(one.writes) for one in statements(3, "x = 1; y = x")]
    [['x'], ['y']]
    """
    try:
        nodes = parsed(source, f"<cell {cell + 1}>")
        text = source if plain(source) == source else ""
        found = _read(text, tuple(nodes))
        return [replace(one, cell=cell) for one in found] if cell else found
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return None


@cache
def _read(source, nodes):
    """The Statements of nodes; ``source`` is the text that these were parsed from, if it is kept:
    to cut a statement out of it is quicker than to write it anew.
    """
    lines = source.encode().splitlines(keepends=True)
    return [statement(0, node, _cut(lines, node) if lines else "") for node in nodes]


def _cut(lines, node):
    """The text of a statement; empty where it begins with a decorator, which its place leaves
    out.
    """
    if getattr(node, "decorator_list", ()):
        return ""
    first, *more = lines[node.lineno - 1 : node.end_lineno]
    begin, end = node.col_offset, node.end_col_offset  # counted in bytes
    if not more:
        return first[begin:end].decode()
    return b"".join([first[begin:], *more[:-1], more[-1][:end]]).decode()


def statement(cell: int, node: ast.stmt, text: str = "") -> Statement:
    """A Statement, read; ``text`` is what it was parsed from, where that is known.

    Examples
    --------
    >>> one = statement(0, ast.parse("def f(x): return g(x) + k").body[0])
    >>> sorted(one.reads), sorted(one.writes)
    (['g', 'k'], ['f'])
    """
    reads, binds = _names(text or ast.unparse(node))
    within = _within(node)
    changed = _changed(within)
    writes = binds | (changed & reads)
    star = isinstance(node, ast.ImportFrom) and node.names[0].name == "*"
    return Statement(
        cell,
        node,
        frozenset(reads),
        frozenset(writes),
        frozenset(_assigned(node)),
        act=_acting(node, within, reads),
        alias=(_root(node.value) or "") if isinstance(node, ast.Assign) else "",
        always=star or _of_the_future(node) or bool(reads & UNREADABLE),
        defines=any(isinstance(inner, DEFINING) for inner in within),
        harmless=isinstance(node, ast.FunctionDef) and not changed and binds == {node.name},
        imports=isinstance(node, (ast.Import, ast.ImportFrom)),
    )


def _acting(node, within, reads):
    """The names by which a statement may change something that it does not bind: those of a call
    whose answer nobody takes, wherever it stands; a class may be noted where it inherits, a
    function by its decorator.
    """
    alone = [inner for inner in within if isinstance(inner, (ast.Expr, ast.Assign))]
    found = {name for inner in alone if (call := _for_itself(inner)) for name in _names_in(call)}
    if _for_itself(node):
        found = reads  # also what only its text tells
    by = [*getattr(node, "decorator_list", ()), *getattr(node, "bases", ())]
    called = [one.func if isinstance(one, ast.Call) else one for one in by]
    return frozenset(
        _with_whole(within, set(found)) & reads | set(filter(None, map(_root, called)))
    )


def _for_itself(node):
    """What is worked out by a statement for nothing but what it does, as ``f(x)``, ``[f(x) for x in
    y]`` or ``_ = f(x)`` are; None.
    """
    match node:
        case ast.Expr(value) | ast.Assign([ast.Name("_")], value):
            if _root(getattr(value, "func", None)) in SHOWING:
                return None
            return value if any(isinstance(one, ast.Call) for one in _within(value)) else None
    return None


def _of_the_future(node):
    """What changes how all that follows is read."""
    return isinstance(node, ast.ImportFrom) and node.module == "__future__"


def _assigned(node):
    return {
        inner.id
        for target in (node.targets if isinstance(node, ast.Assign) else ())
        for inner in _within(target)
        if isinstance(inner, ast.Name) and isinstance(inner.ctx, ast.Store)
    }


def needed(statements: Sequence[Statement], wanted: Iterable[str]) -> list[Statement]:
    """Those of the statements that make the wanted names, in their order."""
    names, taken = set(wanted), set()
    modules = {"np", "dh"}.union(*(one.writes for one in statements if one.imports))
    more = True
    while more:
        more = False
        for number, one in enumerate(statements):
            shared = one.alias in names and one.alias not in modules
            if number not in taken and (
                one.always or one.writes & names or (one.act - modules) & names or shared
            ):
                taken.add(number)
                # who calls a function that changes something matters too, and who changes a part
                defined = isinstance(one.node, (ast.FunctionDef, ast.ClassDef))
                names |= one.reads | (one.writes if defined or shared else frozenset())
                more = True
    return [statements[number] for number in sorted(taken)]


def _call(node):
    """The call that a statement is, or None."""
    return node.value if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call) else None


def _names(text):
    """(read, bound) at the level of the notebook; what a function does with names of its own is
    its own affair.
    """
    top = symtable.symtable(text, "<cell>", "exec")
    reads, binds, scopes = set(), set(), [top]
    while scopes:
        scope = scopes.pop()
        scopes += scope.get_children()
        for symbol in scope.get_symbols():
            if scope is top or symbol.is_global():
                reads |= {symbol.get_name()} if symbol.is_referenced() else set()
                bound = symbol.is_assigned() or symbol.is_imported()
                binds |= {symbol.get_name()} if bound else set()
    return reads, binds


def _changed(within):
    """The names whose objects are changed: ``x[0] = 1``, ``x.y = 1``, ``x.append(1)``, ``f(y,
    out=x)``, and x where ``for row in x`` does so with a row.
    """
    found = set()
    for inner in within:
        if isinstance(inner, (ast.Subscript, ast.Attribute)) and not isinstance(
            inner.ctx, ast.Load
        ):
            found.add(_root(inner))
        elif (call := _call(inner)) and isinstance(call.func, ast.Attribute):
            found.add(_root(call.func))
        elif isinstance(inner, ast.Call) and getattr(inner.func, "attr", "") in CHANGING:
            found.add(_root(inner.func))
        elif isinstance(inner, ast.keyword) and inner.arg == "out":  # numpy's: where it goes
            found |= _names_in(inner.value)
    return _with_whole(within, found)


def _with_whole(within, found):
    """Names, with x where ``for row in x`` is about a row among them."""
    for loop in within:
        if isinstance(loop, ast.For) and _names_in(loop.target) & found:
            found |= _names_in(loop.iter)
    return found


def _names_in(node):
    return {inner.id for inner in _within(node) if isinstance(inner, ast.Name)}


def _within(node):
    """A node and all below it, in the order of ``ast.walk`` and in a third of its time."""
    found = [node]
    for one in found:  # it grows meanwhile
        for value in one.__dict__.values():
            if type(value) is list:
                found += [inner for inner in value if isinstance(inner, ast.AST)]
            elif isinstance(value, ast.AST) and not isinstance(value, ast.expr_context):
                found.append(value)
    return found


def _root(node):
    while isinstance(node, (ast.Subscript, ast.Attribute, ast.Starred)):
        node = node.value
    return node.id if isinstance(node, ast.Name) else None
