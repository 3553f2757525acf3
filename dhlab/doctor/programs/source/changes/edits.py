"""Every small change of a program that may be what its writer meant, the likeliest first."""

import ast
from dataclasses import replace
from itertools import pairwise

from ..text import Edit
from .expressions import in_place_of
from .formulas import formula_changes
from .missing import missing_changes
from .rotations import rotation_changes
from .scope import in_loop, scope_of, scope_of_text
from .statements import statement_edits
from .tables import known_numbers, table_changes

__all__ = ["changes_of"]


def changes_of(text, arm=None, kinds=None):
    """What may be changed in a Text: one edit, or several that belong together; sorted by rank,
    none twice.

    Parameters
    ----------
    text : Text
    arm : Arm, optional
        The one that the program is for, whose numbers it may have.
    kinds : dict of sets, optional
        What the names of the program hold.

    Returns
    -------
    list of tuples of Edit
    """
    edits = _edits_of(text, kinds or {})
    return sorted(
        [
            *((edit,) for edit in edits),
            *_everywhere(edits, text),
            *_out_of_loops(text),
            *formula_changes(text),
            *rotation_changes(text),
            *table_changes(text),
            *(known_numbers(text, arm) if arm is not None else ()),
            *missing_changes(text),
            *_of_three(text),
        ],
        key=lambda change: change[0].rank,
    )


def _everywhere(edits, text):
    """The same edit at every place where the same stands."""
    same = {}
    for edit in edits:
        if edit.rank < 2 and edit.start < edit.end:
            same.setdefault((text.data[edit.start : edit.end], edit.new), []).append(edit)
    for places in same.values():
        apart = sorted(places, key=lambda edit: edit.start)
        if len(apart) > 1 and all(a.end <= b.start for a, b in pairwise(apart)):
            yield tuple(replace(edit, rank=edit.rank + 1) for edit in apart)


def _of_three(text):
    """``matmul(A, B, C)`` made A B C, at every place: numpy writes A B into the third."""
    edits = []
    for node in ast.walk(text.tree):
        name = getattr(node, "func", None) and text.of(node.func).rpartition(".")[2]
        if name in ("matmul", "dot") and len(node.args) == 3 and not node.keywords:
            product = " @ ".join(f"({text.of(factor)})" for factor in node.args)
            edits.append(text.edit(node, f"({product})", 0))
    if edits:
        yield tuple(edits)


def _out_of_loops(text):
    """A factor that is multiplied in at every turn of a loop, multiplied in once, behind it."""
    for function in text.nodes():
        if isinstance(function, ast.FunctionDef) and isinstance(function.body[-1], ast.Return):
            for loop in function.body:
                if isinstance(loop, (ast.For, ast.While)):
                    yield from _moved_factors(loop, function.body[-1], text)


def _moved_factors(loop, last, text):
    start, end = text.span(last.value)
    for node in ast.walk(loop):
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.MatMult):
            for factor, rest in ((node.right, node.left), (node.left, node.right)):
                if isinstance(factor, (ast.Name, ast.Call)):
                    drop = text.edit(node, text.of(rest))
                    name, value = text.of(factor), text.of(last.value)
                    for joined in (f"{value} @ {name}", f"{name} @ {value}"):
                        yield drop, Edit(start, end, joined.encode(), 1)


def _edits_of(text, kinds):
    """Single Edits."""
    found = {}
    for rank, start, end, new in statement_edits(text):
        found.setdefault((start, end, new), rank)
    scope = scope_of_text(text, kinds)
    for block in text.blocks:
        for node, parent, inside in _walk(block, None, scope):
            for rank, new in in_place_of(node, parent, inside, text):
                found.setdefault((*text.span(node), new), rank)
    edits = [
        Edit(start, end, new.encode(), rank)
        for (start, end, new), rank in found.items()
        if text.data[start:end] != new.encode()
    ]
    return edits


def _walk(node, parent, scope):
    """Every expression below a node with what it stands in and the names around it."""
    if isinstance(node, ast.JoinedStr):  # its parts have no places of their own
        return
    if isinstance(node, (ast.FunctionDef, ast.Lambda)):
        scope = scope_of(node, scope)
    elif isinstance(node, (ast.For, ast.While, ast.ListComp, ast.GeneratorExp)):
        scope = in_loop(node, scope)
    if isinstance(node, (ast.expr, ast.Slice)):
        yield node, parent, scope
    in_index = isinstance(parent, ast.Subscript) and node is parent.slice
    for child in ast.iter_child_nodes(node):
        around = parent if in_index and isinstance(node, (ast.Tuple, ast.UnaryOp)) else node
        yield from _walk(child, around, scope)
