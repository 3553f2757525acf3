"""Reads a notebook of any age into its cells of code, and finds where each exercise is answered."""

import json
import re
from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any

__all__ = ["FAULTS", "Cell", "Cells", "cells_of", "decoded", "listed", "opened", "read", "slim"]

CHECK = re.compile(r"""\bcheck\(\s*["']([0-9A-Za-z.]+)["']""")
# what is said of a file that is no notebook
FAULTS = EMPTY, NO_JSON, NO_CELLS = (
    "the file is empty",
    "this is no notebook: its JSON cannot be read",
    "this is no notebook: it has no cells",
)
GRADE_ID = re.compile(r"(?:stub|check)-(.+)")


@dataclass
class Cell:
    """A cell of code: its source, the exercises it has to do with, those that it checks, and those
    that are answered once it has run.
    """

    source: str
    ids: list[str]
    checked: list[str] = field(default_factory=list)
    answers: list[str] = field(default_factory=list)


@dataclass
class Cells:
    """A notebook's code; which lesson it is; the handed-out checks' expressions, and the exercises
    for which no place was found.
    """

    code: list[Cell]
    lesson: str | None
    expressions: dict[str, str]
    unplaced: list[str]

    def last_for(self, only: Iterable[str]) -> int | None:
        """The number of the last cell that has to do with these exercises; None when it is not
        known.
        """
        if not only:
            return None
        found = [number for number, cell in enumerate(self.code) if set(cell.ids) & set(only)]
        return found[-1] if found and not set(only) & set(self.unplaced) else None


def read(raw: bytes, checks: Mapping[str, Any]) -> Cells:
    """The Cells of a file.

    Parameters
    ----------
    raw : bytes
    checks : dict
        For each lesson, for each exercise: ``[expression, id of the stub's cell]``, as handed out.

    Raises
    ------
    ValueError
        It is no notebook.
    """
    return cells_of(opened(raw), checks)


def cells_of(notebook: dict[str, Any], checks: Mapping[str, Any]) -> Cells:
    """The same of a notebook whose JSON is read."""
    found = [cell for cell in listed(notebook) if isinstance(cell, dict)]
    code = [_cell(cell) for cell in found if cell.get("cell_type") == "code"]
    names = [_text(cell.get("id")) for cell in found if cell.get("cell_type") == "code"]
    lesson = _lesson(notebook, code, names, checks)
    wanted = checks.get(lesson, {})
    unplaced = [key for key, (_, stub) in wanted.items() if not _place(key, stub, code, names)]
    expressions = {key: expression for key, (expression, _) in wanted.items()}
    return Cells(code, lesson, expressions, unplaced)


def slim(notebook: dict[str, Any]) -> dict[str, Any]:
    """A notebook with its code alone, for who has many pictures in it; ValueError when it is no
    notebook.

    Examples
    --------
    >>> cells = [{"cell_type": "code", "source": "x", "id": "a", "outputs": [1]}, {"source": "y"}]
    >>> slim({"cells": cells})["cells"]
    [{'cell_type': 'code', 'source': 'x', 'metadata': {}, 'id': 'a'}]
    """
    return {
        "metadata": {"dhlab": _dict(_dict(notebook.get("metadata")).get("dhlab"))},
        "cells": [
            {
                "cell_type": "code",
                "source": _source(cell),
                "metadata": {
                    name: _dict(cell.get("metadata")).get(name)
                    for name in ("exercise", "nbgrader")
                    if name in _dict(cell.get("metadata"))
                },
                "id": _text(cell.get("id")),
            }
            for cell in listed(notebook)
            if isinstance(cell, dict) and cell.get("cell_type") == "code"
        ],
    }


def decoded(raw: bytes) -> str:
    """The text of a file, in whatever of three ways it was written."""
    try:
        return raw.decode("utf-16" if raw[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig")
    except UnicodeDecodeError:
        return raw.decode("latin-1")


def opened(raw: bytes) -> dict[str, Any]:
    """The JSON of a notebook; ValueError when it is none."""
    text = decoded(raw)
    if not text.strip():
        raise ValueError(EMPTY)
    try:
        notebook = json.loads(text)
    except (json.JSONDecodeError, RecursionError):
        raise ValueError(NO_JSON) from None
    if not isinstance(notebook, dict):
        raise ValueError(NO_CELLS)
    return notebook


def listed(notebook: dict[str, Any]) -> list[Any]:
    """The cells; in version 3 and before they stood in worksheets."""
    if isinstance(notebook.get("cells"), list):
        return notebook["cells"]
    sheets = notebook.get("worksheets")
    if not isinstance(sheets, list):
        raise ValueError(NO_CELLS)
    return [
        cell
        for sheet in sheets
        if isinstance(sheet, dict) and isinstance(sheet.get("cells"), list)
        for cell in sheet["cells"]
    ]


def _source(cell):
    source = cell.get("source", cell.get("input", ""))
    return (
        "".join(part for part in source if isinstance(part, str))
        if isinstance(source, list)
        else _text(source)
    )


def _text(value):
    return value if isinstance(value, str) else ""


def _dict(value):
    return value if isinstance(value, dict) else {}


def _cell(cell):
    source = _source(cell)
    checked = CHECK.findall(source)
    return Cell(source, _ids(cell, checked), checked)


def _ids(cell, checked):
    """The exercises a cell has to do with: by its metadata, and by the checks in it."""
    metadata = _dict(cell.get("metadata"))
    nbgrader = _dict(metadata.get("nbgrader"))
    graded = GRADE_ID.fullmatch(_text(nbgrader.get("grade_id")))
    named = [_text(metadata.get("exercise")), graded[1] if graded else "", *checked]
    return list(dict.fromkeys(name[:20] for name in named if name))


def _lesson(notebook, code, names, checks):
    """Which lesson this is: the one most of whose exercises it has; then what its metadata says;
    then whose cells it has.
    """
    of = {key: lesson for lesson, exercises in checks.items() for key in exercises}
    seen = Counter(of[key] for cell in code for key in cell.ids if key in of)
    if seen:
        return seen.most_common(1)[0][0]
    said = _text(_dict(_dict(notebook.get("metadata")).get("dhlab")).get("lesson"))
    if said in checks:
        return said
    stubs = Counter(
        lesson
        for lesson, exercises in checks.items()
        for _, stub in exercises.values()
        if stub in names
    )
    return stubs.most_common(1)[0][0] if stubs else None


def _place(key, stub, code, names):
    """Note, for an exercise, after which cell its answer is there: its check, or its stub where
    there is no check.
    """
    checking = [cell for cell in code if key in cell.checked]
    for cell in checking:
        cell.answers.append(key)
    if checking:
        return True
    own = [number for number, cell in enumerate(code) if key in cell.ids] or [
        number for number, name in enumerate(names) if name == stub
    ]
    if own:
        code[own[-1]].answers.append(key)
    return bool(own)
