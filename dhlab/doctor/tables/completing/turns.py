"""What a link function of the text has built in: a turn that it adds to theta of the rows for which
the program calls it.
"""

import re
from dataclasses import replace

from ..cells import Cell
from ..dialects.called.functions import own_calls
from ..evidence.link_functions import calls_of, link_functions, rows_of_calls

__all__ = ["with_turns"]

# dh[0][2], dh(1,3); and in a loop dh[i + 1][0] + q[i]
OF_ROW = re.compile(r"(\w+)([\[(])(\d+)(?:,|\]\[)\d[\])]")
LOOPED = re.compile(r"\w[\[(][^\])]*[ijkn]\b[^+]*\+.*[\[(][^\])]*[ijkn]\b|\+.*[\[(][^\])]*[ijkn]\b")


def with_turns(table, source):
    """The table with the turns that link functions of the text add to theta.

    Raises
    ------
    ValueError
        A second one computes another matrix, or nothing says for which rows one is called.
    """
    if table.form and not table.form.startswith("calls of"):
        return table  # a toolbox's links
    table = _with_still(table, source)
    made = link_functions(source.code)
    called = {name: found for name, found in made.items() if calls_of(name, source.code)}
    turned = [name for name, found in called.items() if found and found.turn]
    _require_read(called, bool(turned), source.link_matrix is not None)
    zeros, notes = list(table.zeros) or [Cell(0.0)] * len(table.rows), []
    for name in turned:
        rows = _rows_of(name, called, table, source)
        turn = called[name].turn
        for k in rows:
            if zeros[k].value or zeros[k].letters:
                raise ValueError(
                    f"recognise_table: {name} adds {turn:.6g} to theta, and row {k + 1} has a zero"
                    " beside it; do both count? Add them up in the row"
                )
            zeros[k] = Cell(turn, unit="rad", text=f"{turn:.6g}")
        told = ", ".join(f"row {k + 1}" for k in rows)
        notes.append(f"{name} adds {turn:.6g} rad to theta of {told}, as its matrix has it")
    if not notes:
        return table
    return replace(table, zeros=tuple(zeros), notes=(*table.notes, *notes))


def _with_still(table, source):
    """The table without a joint in the row that the program gives to its link function as it is,
    ``link(dh[0][0], dh[0][1], …)``, beside a loop that adds joints' values to all others.
    """
    still, moving = set(), False
    for call, roles in own_calls(source):
        texts = [re.sub(r"\s", "", item.text) for item in call.items]
        named = [OF_ROW.fullmatch(text) for text in texts]
        if all(named) and len({one.groups() for one in named}) == 1:
            still.add(int(named[0][3]) - (named[0][2] == "("))
        moving |= "theta" in roles and bool(LOOPED.search(texts[roles.index("theta")]))
    angle = (table.roles or ("",)).index("theta") if "theta" in (table.roles or ()) else None
    known = any(table.kinds) or angle is None or not moving or len(still) != 1
    if known or not 0 <= (k := still.pop()) < len(table.rows) or table.rows[k][angle].letters:
        return table
    kinds = tuple("fixed" if i == k else "" for i in range(len(table.rows)))
    note = f"row {k + 1} has no joint: the program takes it as it stands, outside of the loop"
    return replace(table, kinds=kinds, notes=(*table.notes, note))


def _require_read(called, turned, known):
    """All matrices are read, where one of them decides, and are for one convention."""
    unread = next((name for name, found in called.items() if found is None), "")
    if unread and (len(called) > 1 or known):
        raise ValueError(
            f"recognise_table: the program calls a link function {unread[:40]}, whose matrix is"
            " none of Denavit and Hartenberg's as far as it can be read, or one of several; for"
            " which links is it, and what does it add? Write the rows as one function takes them"
        )
    if turned and len({found.convention for found in called.values() if found}) > 1:
        raise ValueError(
            "recognise_table: the program calls a link function of the standard convention and one"
            " of Craig's; for which rows is each? Paste the rows of one convention"
        )


def _rows_of(name, called, table, source):
    """The rows, counted from 0, that one link function makes."""
    n = len(table.rows)
    if len(called) == 1:
        return [*range(n)]
    if table.callers:
        return [k for k, caller in enumerate(table.callers) if caller == name]
    rows = rows_of_calls(name, n, source.code)
    if rows is None:
        raise ValueError(
            f"recognise_table: {name[:40]} adds {called[name].turn:.6g} to theta in its matrix; for"
            " which rows is it called? Write the angle into these rows, as theta - 90"
        )
    return rows
