"""What each student wrote for each exercise, kept beside the marks for whoever reads them."""

import ast
import json
import re
import warnings
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from ...course.exercises import exercises
from ...course.kinds import Explain
from ...course.workspace import handed_out
from ...formats import files
from ..intake.notebooks import LARGEST, parsed
from ..own_items import YOUR_NUMBERS
from ..results.marks import Graded
from ..results.names import marks_stem
from .cells import written

__all__ = ["Answer", "Picture", "keep_answers", "own_answers", "read_answers", "read_notebook"]

MOST = 20_000  # characters of one answer that are kept
MOST_PICTURES = 3  # of one answer
KINDS = ("image/png", "image/jpeg", "image/gif", "image/webp")
FOLDER = "answers"
# the cell of one's own numbers, and what it is made of in a lesson of the teacher's own
VARIANT = re.compile(
    r"from dhlab\.course import set_variant\nset_variant\(\d+\)[ \t]*(?:#[^\n]*)?\s*\Z"
)
NUMBERS = ast.Dict | ast.List | ast.Constant | ast.UnaryOp | ast.USub | ast.expr_context
BASE64 = re.compile(r"[A-Za-z0-9+/=\s]+\Z")


class Picture(NamedTuple):
    """A picture that was put into a Markdown cell: its kind, such as "image/png", and its bytes
    in base64.
    """

    kind: str
    data: str


class Answer(NamedTuple):
    """What a student wrote for one exercise, and the pictures above its check."""

    code: str = ""
    pictures: tuple[Picture, ...] = ()


def own_answers(notebook: Any) -> dict[str, Answer]:
    """The student's own answer to each exercise: the code between its check and the one before,
    without cells that are still as they were handed out, and the pictures between them; what stands
    below the last check is the last one's.

    Parameters
    ----------
    notebook : dict
        As in the file; nothing in it is trusted to have the right form.

    Returns
    -------
    dict of str to Answer

    Examples
    --------
    >>> cells = [{"source": "rule = 'a'"}, {"source": ['check("05.2", ', "rule)"]}]
    >>> own_answers({"cells": [{"cell_type": "code", **cell} for cell in cells]})
    {'05.2': Answer(code="rule = 'a'", pictures=())}
    """
    return {
        exercise: answer
        for exercise, parts in written(notebook).items()
        if (answer := _answer(parts)) != Answer()
    }


def _answer(parts):
    """The Answer in what stands above an exercise's checks."""
    mine = [(code or "").strip() for _, code in parts]
    pictures = [picture for cell, code in parts if code is None for picture in _pictures(cell)]
    own = (code for code in mine if code and code not in _handed_out_cells())
    code = "\n\n".join(code for code in own if not _is_given(code))[:MOST]
    return Answer(code, tuple(pictures[:MOST_PICTURES]))


def _is_given(code):
    """Whether a cell is that of one's own numbers, and nothing else."""
    if not code.startswith(YOUR_NUMBERS):
        return bool(VARIANT.match(code))
    if len(code) > MOST or code.count("\n") > YOUR_NUMBERS.count("\n"):
        return False  # what we write is short, and one line
    try:
        with warnings.catch_warnings(action="ignore"):
            (task,) = ast.parse(code).body
    except (ValueError, SyntaxError, RecursionError, MemoryError):
        return False
    return isinstance(task, ast.Assign) and all(map(_is_number, ast.walk(task.value)))


def _is_number(node):
    match node:
        case ast.Call(ast.Attribute(ast.Name("np"), "array")) | ast.Attribute(ast.Name("np")):
            return True
        case ast.Name("np"):
            return True
    return isinstance(node, NUMBERS)


def _pictures(cell):
    """The pictures of a Markdown cell."""
    attached = cell.get("attachments")
    for by_kind in attached.values() if isinstance(attached, dict) else ():
        for kind, data in by_kind.items() if isinstance(by_kind, dict) else ():
            if kind in KINDS and isinstance(data, str) and BASE64.match(data):
                yield Picture(kind, "".join(data.split()))


@cache
def _handed_out_cells():
    return frozenset(
        "".join(cell["source"]).strip()
        for path in handed_out().glob("[0-9][0-9]*.ipynb")
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]
        if cell["cell_type"] == "code"
    )


def keep_answers(
    graded: Graded, codes: Mapping[tuple[str, str], Mapping[str, Answer]], out: str | Path
) -> None:
    """Write ``answers/<student>.json``: for each mark the answer in the notebook it comes from.
    Where that notebook is not among what is graded now, what was kept before stands.

    Parameters
    ----------
    graded : Graded
    codes : mapping
        For the name of each file and when it came, as in the marks, what :func:`own_answers` finds
        in it: next week's file may have the same name.
    out : str or path
        The folder of the marks.
    """
    before = read_answers(graded.student, out)
    kept = {
        mark.exercise: codes.get((mark.file, mark.handed_in), before).get(mark.exercise)
        for mark in graded.marks
    }
    found = {key: _slim(key, answer) for key, answer in kept.items() if answer}
    if found != before:
        path = _path(graded.student, out)
        path.parent.mkdir(exist_ok=True)
        told = {key: [own.code, own.pictures] for key, own in found.items()}
        text = json.dumps(told, ensure_ascii=False, indent=1)
        files.write_bytes(path, text.encode("utf-8", "replace"), overwrite=True)


def _slim(key, answer):
    """Pictures are kept where they are the answer."""
    explains = isinstance(exercises().get(key), Explain)
    return answer if explains else answer._replace(pictures=())


def read_notebook(raw: bytes) -> dict[str, Answer]:
    """The own answers in a notebook's bytes; none where it cannot be read or is too large."""
    try:
        return own_answers(parsed(raw))
    except ValueError:
        return {}


def _path(student, out):
    return Path(out) / FOLDER / f"{marks_stem(student)}.json"


def read_answers(student: str, out: str | Path) -> Mapping[str, Answer]:
    """What was kept of a student, by exercise; nothing where nothing was kept."""
    path = _path(student, out)
    if not path.exists():
        return {}
    text = files.read_text(path, "a student's answers", 10 * LARGEST)
    try:
        known = json.loads(text)
        return {
            key: Answer(code, tuple(Picture(*picture) for picture in pictures))
            for key, (code, pictures) in known.items()
        }
    except (ValueError, AttributeError, TypeError):
        raise ValueError(
            f"{path}: expected answers that dhlab grade kept, found something else; delete it and"
            " grade again"
        ) from None
