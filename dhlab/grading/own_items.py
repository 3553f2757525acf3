"""A teacher's own items: exercises whose definition never leaves the teacher. The student's copy
holds the questions and the student's numbers; a check there only notes the answer.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import nbformat
import numpy as np

from ..course.session import OWN_ITEM
from ..formats import files

if TYPE_CHECKING:
    from ..course.kinds.exercise import Exercise

__all__ = ["YOUR_NUMBERS", "Items", "install", "notebooks_of", "own_checks", "read_items"]

YOUR_NUMBERS = "# your own numbers: leave this cell as it is\n"
_installed: dict[str, Items] = {}


@dataclass(frozen=True)
class Items:
    """The file of a teacher's own items: its name, and its text, which goes to the teacher's own
    workers and nowhere else.
    """

    name: str
    text: str


def read_items(path: str | Path) -> Items:
    """The Items in a Python file, installed.

    Parameters
    ----------
    path : str or path
        ``EXERCISES`` lists exercises of ``dhlab.course.kinds`` with ids from 90.1 to 99.9;
        ``TEXTS`` may hold what is asked, by id, and ``TITLE`` the heading.

    Raises
    ------
    ValueError
        One sentence: what is wrong, and in which line.
    """
    items = Items(Path(path).name, files.read_text(path, "a teacher's own items"))
    install(items)
    return items


def install(items: Items) -> None:
    """Make the items known to this process, where they are not yet."""
    if _installed.get(items.name) == items:
        return
    from ..course.exercises import exercises

    for exercise in _defined(items)["EXERCISES"]:
        exercises()[exercise.id] = exercise
    _installed[items.name] = items


@cache
def _defined(items: Items) -> dict[str, Any]:
    found: dict[str, Any] = {"__name__": "own_items", "TEXTS": {}, "TITLE": "Questions of our own"}
    try:
        exec(compile(items.text, items.name, "exec"), found)
    except Exception as error:
        raise ValueError(
            f"{items.name}: line {_line(error, items.name)}: expected Python that defines"
            f" exercises, found {type(error).__name__}: {error}"
        ) from None
    _check(items, found)
    return found


def _line(error, name):
    """Where in the file an error came from."""
    at, trace = getattr(error, "lineno", None), error.__traceback__
    while trace is not None:
        if trace.tb_frame.f_code.co_filename == name:
            at = trace.tb_lineno
        trace = trace.tb_next
    return at or 1


def _check(items, found):
    """ValueError where the items cannot be handed out or graded."""
    from ..course.kinds.exercise import Exercise

    listed = found.get("EXERCISES")
    if not isinstance(listed, list) or not all(isinstance(one, Exercise) for one in listed):
        raise ValueError(f"{items.name}: expected EXERCISES = [...], a list of exercises")
    ids = [one.id for one in listed]
    for exercise in listed:
        if not OWN_ITEM.fullmatch(exercise.id) or ids.count(exercise.id) > 1:
            raise ValueError(
                f"{items.name}: expected ids from 90.1 on, each once, found {exercise.id!r};"
                " the course's own lessons stand below 90"
            )
        _literal(items, exercise, dict(exercise.given(0)))
    for key in found["TEXTS"]:
        if key not in ids:
            raise ValueError(f"{items.name}: TEXTS: expected ids of EXERCISES, found {key!r}")


def own_checks() -> dict[str, dict[str, Any]]:
    """The checks of the installed items, by lesson, as of the lessons that are handed out."""
    found: dict[str, dict[str, Any]] = {}
    for items in _installed.values():
        for exercise in _defined(items)["EXERCISES"]:
            lesson = found.setdefault(exercise.id.partition(".")[0], {})
            lesson[exercise.id] = [_name(exercise), _cell_id(exercise)]
    return found


def notebooks_of(items: Items, variant: int) -> dict[str, str]:
    """The student's copy: for each lesson of the items the name and the text of a notebook that
    holds questions and numbers, and nothing by which they are judged.
    """
    install(items)
    found = _defined(items)
    lessons: dict[str, list[Exercise]] = {}
    for exercise in found["EXERCISES"]:
        lessons.setdefault(exercise.id.partition(".")[0], []).append(exercise)
    made = {}
    for lesson, asked in lessons.items():
        cells = [
            _text(f"# {lesson} {found['TITLE']}", f"{lesson}-title"),
            _code("import numpy as np\nimport dhlab as dh\nfrom dhlab.course import check", lesson),
        ]
        for exercise in asked:
            cells += _cells(items, exercise, found["TEXTS"].get(exercise.id, ""), variant)
        notebook = nbformat.v4.new_notebook(cells=cells)
        notebook.metadata["dhlab"] = {"lesson": lesson, "variant": variant}
        notebook.metadata["kernelspec"] = {
            "display_name": "Python 3",
            "language": "python",
            "name": "python3",
        }
        made[f"{lesson}-own.ipynb"] = nbformat.writes(notebook) + "\n"
    return made


def _cells(items, exercise, text, variant):
    yield _text(
        "\n\n".join(filter(None, (exercise.shown(variant), text))), f"question-{exercise.id}"
    )
    given = dict(exercise.given(variant))
    if given:
        told = f"{YOUR_NUMBERS}task = {_literal(items, exercise, given)}"
        yield _code(told, f"numbers-{exercise.id}", deletable=False, editable=False)
    name = _name(exercise)
    names = getattr(exercise, "names", None)
    stub = f"{name} = ..." if names is None else f"def {name}({', '.join(names)}):\n    ..."
    yield _code(stub, _cell_id(exercise), exercise=exercise.id)
    yield _code(f'check("{exercise.id}", {name})', f"check-{exercise.id}")


def _name(exercise):
    kind = "answer" if getattr(exercise, "names", None) is None else "program"
    return f"{kind}_{exercise.id.partition('.')[2]}"


def _cell_id(exercise):
    return f"answer-{exercise.id.replace('.', '-')}"


def _text(source, name):
    cell = nbformat.v4.new_markdown_cell(source)
    cell["id"] = re.sub(r"\W", "-", name)
    return cell


def _code(source, name, **metadata):
    cell = nbformat.v4.new_code_cell(source, metadata=metadata)
    cell["id"] = re.sub(r"\W", "-", name)
    return cell


def _literal(items, exercise, value):
    """A task's numbers as Python."""
    if isinstance(value, dict):
        parts = [f"{key!r}: {_literal(items, exercise, entry)}" for key, entry in value.items()]
        return "{" + ", ".join(parts) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_literal(items, exercise, entry) for entry in value) + "]"
    if isinstance(value, np.ndarray) and value.dtype.kind in "biuf":
        return f"np.array({value.tolist()!r})"
    if isinstance(value, np.generic):
        value = value.item()
    if value is None or isinstance(value, (bool, int, float, str)):
        return repr(value)
    raise ValueError(
        f"{items.name}: {exercise.id}: expected draw to give numbers, texts, lists and arrays,"
        f" found {type(value).__name__}; the student's copy shows them as Python"
    )
