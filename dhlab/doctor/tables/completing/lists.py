"""Zeros and senses of a pasted table's joints that stand beside its rows, in lists of their own."""

import re
from dataclasses import replace

from ..cells import cell_of
from ..dialects.flat import arrays_in
from ..language.roles import role_of
from ..meaning.columns import snapped

__all__ = ["with_lists"]

ANGLES = re.compile(r"(?:thetas?|th|q|joint_?\w*|angles?)")
OF_AN_END = re.compile(
    r"tool|grip|tcp|base|flange|camera|end_?ef|(?<![a-z])ee|hand|tip", re.IGNORECASE
)
SIGN = re.compile(r"sign(?!al)|joint_?dir(?:ection)?s?$")


def with_lists(table, source):
    """The table with the zeros and signs that the text lists beside it, one for each row.

    Raises
    ------
    ValueError
        The rows have zeros of their own, and others.
    """
    n = len(table.rows)
    table = _with_angles(table, source)
    for name, values in arrays_in(source).items():
        signs = SIGN.search(name.lower()) or _are_signs(name, values, source)
        role = "sign" if signs else role_of(name)[0]
        if len(values) != n or "home" in name.lower() or any(v.letters for v, _ in values):
            continue
        if role == "sign" and set(table.signs) <= {1}:
            signs = tuple(-1 if value.number < 0 else 1 for value, _ in values)
            table = replace(table, signs=signs)
        cells = tuple(cell_of(value, text) for value, text in values)
        if role == "offset" and _is_a_point(name, cells, source):
            note = f"{name} is taken for a place at the end of the arm, and for no zeros"
            table = replace(table, notes=(*table.notes, note))
            continue
        if role == "offset" and any(cell.value for cell in cells) and not _held(table, cells, name):
            table = replace(table, zeros=cells, notes=(*table.notes, f"{name} is added to theta"))
    return table


def _with_angles(table, source):
    """The table with a list of joint angles, variables and perhaps numbers among them, in its
    column theta, where it has none: ``theta = [q1, q2 - pi/2, 0, q4]`` beside d, a and alpha.
    """
    free = all(cell.is_constant and not cell.value for row in table.rows for cell in row[:1])
    if not table.roles or table.roles[0] != "theta" or not free or any(table.kinds):
        return table
    found = {}
    for name, values in arrays_in(source).items():
        cells = [cell_of(value, text) for value, text in values]
        moving = [cell.variable in ("theta", "q") for cell in cells]
        plain = all(one or cell.is_constant for one, cell in zip(moving, cells))
        if (
            ANGLES.fullmatch(name.lower())
            and len(cells) == len(table.rows)
            and plain
            and any(moving)
        ):
            found[name] = cells
    if len(found) != 1:
        return table
    name, cells = found.popitem()
    rows = tuple((cell, *row[1:]) for cell, row in zip(cells, table.rows))
    return replace(table, rows=rows, notes=(*table.notes, f"theta is that of the list {name}"))


def _is_a_point(name, cells, source):
    """Whether a list of as many numbers as there are rows is a point that the last matrix is
    multiplied by: ``T @ tip_offset``, or by its name one without a quarter turn.
    """
    word = re.escape(name)
    times = rf"\b[A-Za-z]\w*\s*[@*]\s*{word}\b|\b(?:dot|matmul)\s*\(\s*\w+\s*,\s*{word}\b"
    if len(cells) == 4 and cells[3].value == 1 and re.search(times, source.code):
        return True
    turns = any(cell.value and (cell.value % 90 == 0 or snapped(cell.value)[1]) for cell in cells)
    return bool(OF_AN_END.search(name)) and not turns


def _are_signs(name, values, source):
    """Whether numbers are 1 and -1, and the program multiplies by them."""
    if {value.number for value, _ in values} != {1.0, -1.0}:
        return False
    index = r"(?:[\[(]\w+[\])])?"
    return bool(re.search(rf"\b{name}{index}\s*\.?\*|\*\s*{name}\b", source.code))


def _held(table, cells, name):
    """Whether the rows have these zeros already."""
    roles = table.roles or ()
    if "d" in roles and any(cell.unit in ("mm", "cm", "m") for cell in cells):
        return True  # offsets along z
    own = [k for k, role in enumerate(roles) if role in ("theta", "offset")]
    held = [sum(row[k].value for k in own) for row in table.rows]
    if table.zeros or any(held):
        if all(abs(value - cell.value) < 1e-9 for value, cell in zip(held, cells)):
            return True
        raise ValueError(
            f"recognise_table: the rows have zeros of their own, and {name} stands beside them;"
            " is it added? Leave one of them out, or add them up"
        )
    return False
