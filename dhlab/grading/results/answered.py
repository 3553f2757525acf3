"""What each student wrote for each exercise, kept beside the marks for whoever reads them."""

import json
from collections.abc import Iterable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from ...course.workspace import handed_out
from ...formats import files
from .alike import CHECK
from .marks import Graded
from .names import marks_stem

__all__ = ["keep_answers", "own_code", "read_answers"]

LARGEST = 4_000_000  # bytes of a notebook that is read outside the cage; a lesson has a tenth of it
MOST = 20_000  # characters of one answer that are kept
FOLDER = "answers"


def own_code(notebook: Any) -> dict[str, str]:
    """The student's own code for each exercise: the cells between its check and the one before,
    without those that are still as they were handed out.

    Parameters
    ----------
    notebook : dict
        As in the file; nothing in it is trusted to have the right form.

    Returns
    -------
    dict of str to str

    Examples
    --------
    >>> cells = [{"source": "rule = 'a'"}, {"source": ['check("05.2", ', "rule)"]}]
    >>> own_code({"cells": [{"cell_type": "code", **cell} for cell in cells]})
    {'05.2': "rule = 'a'"}
    """
    found: dict[str, str] = {}
    mine: list[str] = []
    cells = notebook.get("cells") if isinstance(notebook, dict) else None
    for cell in cells if isinstance(cells, list) else []:
        if not isinstance(cell, dict) or cell.get("cell_type") != "code":
            continue
        source = cell.get("source", "")
        source = "".join(map(str, source)) if isinstance(source, list) else str(source)
        checked = CHECK.search(source)
        code = (source[: checked.start()] if checked else source).strip()
        if code and code not in _handed_out_cells():
            mine.append(code)
        if checked:
            if mine:
                found[checked[1]] = "\n\n".join(mine)[:MOST]
            mine = []
    return found


@cache
def _handed_out_cells():
    return frozenset(
        "".join(cell["source"]).strip()
        for path in handed_out().glob("[0-9][0-9]*.ipynb")
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]
        if cell["cell_type"] == "code"
    )


def keep_answers(graded: Graded, notebooks: Iterable[tuple[str, bytes]], out: str | Path) -> None:
    """Write ``answers/<student>.json``: for each mark the code of the notebook that it comes from.
    Where that notebook is not among what is graded now, what was kept before stands.

    Parameters
    ----------
    graded : Graded
    notebooks : iterable of (str, bytes)
        The names of files, as in the marks, and their bytes.
    out : str or path
        The folder of the marks.
    """
    codes = {name: _code(raw) for name, raw in notebooks}
    before = read_answers(graded.student, out)
    kept = {
        mark.exercise: codes.get(mark.file, before).get(mark.exercise, "") for mark in graded.marks
    }
    kept = {exercise: code for exercise, code in kept.items() if code}
    if kept != before:
        path = _path(graded.student, out)
        path.parent.mkdir(exist_ok=True)
        text = json.dumps(kept, ensure_ascii=False, indent=1)
        files.write_bytes(path, text.encode("utf-8", "replace"), overwrite=True)


def _code(raw):
    """The own code in a notebook's bytes; none where it cannot be read."""
    try:
        return own_code(json.loads(raw)) if len(raw) <= LARGEST else {}
    except (ValueError, RecursionError):
        return {}


def _path(student, out):
    return Path(out) / FOLDER / f"{marks_stem(student)}.json"


def read_answers(student: str, out: str | Path) -> Mapping[str, str]:
    """What was kept of a student: code by exercise; nothing where nothing was kept."""
    path = _path(student, out)
    if not path.exists():
        return {}
    try:
        known = json.loads(files.read_text(path, "a student's answers"))
        return {str(key): str(code) for key, code in known.items()}
    except (json.JSONDecodeError, AttributeError):
        raise ValueError(
            f"{path}: expected answers that dhlab grade kept, found something else; delete it and"
            " grade again"
        ) from None
