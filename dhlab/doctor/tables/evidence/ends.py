"""The base and the tool that a program sets beside its links: ``robot.tool = transl(0, 0, 1)``."""

import re
from dataclasses import replace

from ..cells import Cell, cell_of
from ..language.brackets import cells_in

__all__ = ["with_ends"]

SET = re.compile(
    r"(?:\.|,\s*['\"]?|^\s*)\b(tool|base)\b['\"]?\s*[=,]\s*(?!=)([A-Za-z][\w.]*)\s*\(\s*\[?([^()\[\]\n]*)"
    r"[\])]*(\s*[*@][^\n;]*)?",
    re.MULTILINE,
)
PRINTED = re.compile(  # as the toolboxes print it
    r"\b(tool|base)\b[\s:|]*t\s*=\s*\(?([^()=;\n]*?)\)?\s*[,;]\s*rpy/\w+\s*=\s*\(?([^()\n|]*)",
    re.IGNORECASE,
)
MATRIX = re.compile(  # tool_transform = np.array([[
    r"\b(\w*(?:tool|tcp|base|flange)\w*)['\"]?\s*(?:=(?!=)|:(?!:))\s*(?:[\w.]+\()?\[\s*\[",
    re.IGNORECASE,
)
VECTOR = re.compile(r"['\"]?\b(tool|base)\b['\"]?\s*[,=]\s*(\[[^\[\]\n]*[1-9][^\[\]\n]*\])")
MODEL = re.compile(r"^[ \t]*(\w+)[ \t]*=[ \t]*(?:\w+\.)*models\.\w[\w.]*\(", re.MULTILINE)
BY_THREE = re.compile(r"(?:SE3(?:\.Trans)?|transl|trans|translation)$", re.IGNORECASE)


def with_ends(table, source):
    """The table of toolbox links with rows for the base and the tool that the program sets.

    A translation along x and z is a row without a joint; of anything else a note says that it is
    not in the rows.
    """
    code = _of_the_arm(source.code)
    found = [
        (end, made, f"{inside}){more.strip()}" if more else inside)
        for end, made, inside, more in SET.findall(code) if table.form
    ]  # fmt: skip
    last = {end: k for k, (end, *_) in enumerate(found)}  # a program may set an end again
    found = [found[k] for k in last.values() if not found[k][1].lower().startswith("eye")]
    for end, t, rpy in PRINTED.findall(source.text):
        found.append((end.lower(), "SE3" if not re.search(r"[1-9]", rpy) else f"rpy {rpy}, t", t))
    for end, numbers in VECTOR.findall(source.code) if table.form else ():
        note = f"the text sets a {end}, {numbers[:30]}, which is not in the rows"
        table = replace(table, notes=(*table.notes, note))
    for name in MATRIX.findall(source.code):
        note = f"the text has a matrix {name[:30]}, which is not in the rows"
        table = replace(table, notes=(*table.notes, note))
    for end, made, inside in found if table.roles is not None else ():
        values = [source.value(cell) for cell in cells_in(inside)]
        plain = len(values) == 3 and all(v is not None and not v.letters for v in values)
        if not BY_THREE.match(made) or not plain or values[1].number:
            note = f"the text sets a {end}, {made}({inside.strip()[:30]}), which is not in the rows"
            table = replace(table, notes=(*table.notes, note))
        elif any(value.number for value in values):
            held = {"a": cell_of(values[0]), "d": cell_of(values[2])}
            table = _with_row(table, tuple(held.get(role, Cell(0.0)) for role in table.roles), end)
    return table


def _of_the_arm(code):
    """The code before the arm's name is given to a model of the toolbox: what is set behind that
    is set for the model.
    """
    models = re.finditer(MODEL, code)
    again = (
        m for m in models if re.search(rf"^\s*{m[1]}\s*=(?!=)", code[: m.start()], re.MULTILINE)
    )
    first = next(again, None)
    return code[: first.start()] if first else code


def _with_row(table, row, end):
    n = len(table.rows)

    def added(column, value, empty):
        column = tuple(column) or (empty,) * n
        return (value, *column) if end == "base" else (*column, value)

    return replace(
        table,
        rows=added(table.rows, row, ()),
        kinds=added(table.kinds, "fixed", ""),
        labels=added(table.labels, end, ""),
        signs=added(table.signs, 1, 1),
        zeros=added(table.zeros, Cell(0.0), Cell(0.0)) if table.zeros else (),
        limits=added(table.limits, None, None),
    )
