"""What a link function of the text has built in: a turn that it adds to theta of the rows for which
the program calls it.
"""

from dataclasses import replace

from ..cells import Cell
from ..evidence.second import calls_of, link_functions, rows_of_calls

__all__ = ["with_second"]


def with_second(table, source):
    """The table with the turns that link functions of the text add to theta.

    Raises
    ------
    ValueError
        A second one computes another matrix, or nothing says for which rows one is called.
    """
    if table.form and not table.form.startswith("calls of"):
        return table  # a toolbox's links
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
