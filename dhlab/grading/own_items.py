"""A teacher's own items: exercises whose definition never leaves the teacher. Grading needs what is
here; the student's copy is made in ``handing_out/own_notebooks.py``.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..course.session import OWN_ITEM
from ..formats import files

if TYPE_CHECKING:
    from ..course.kinds.exercise import Exercise

__all__ = [
    "YOUR_NUMBERS",
    "Items",
    "cell_id",
    "defined",
    "install",
    "literal",
    "name_of",
    "own_checks",
    "read_items",
]

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

    for exercise in defined(items)["EXERCISES"]:
        exercises()[exercise.id] = exercise
    _installed[items.name] = items


@cache
def defined(items: Items) -> dict[str, Any]:
    """What the file of the items defines: ``EXERCISES``, ``TEXTS`` and ``TITLE``; ValueError in one
    sentence, with its line, where it does not.
    """
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
        literal(items, exercise, dict(exercise.given(0)))
    for key in found["TEXTS"]:
        if key not in ids:
            raise ValueError(f"{items.name}: TEXTS: expected ids of EXERCISES, found {key!r}")


def own_checks() -> dict[str, dict[str, Any]]:
    """The checks of the installed items, by lesson, as of the lessons that are handed out."""
    found: dict[str, dict[str, Any]] = {}
    for items in _installed.values():
        for exercise in defined(items)["EXERCISES"]:
            lesson = found.setdefault(exercise.id.partition(".")[0], {})
            lesson[exercise.id] = [name_of(exercise), cell_id(exercise)]
    return found


def name_of(exercise: Exercise) -> str:
    """What an answer is called in the student's copy."""
    kind = "answer" if getattr(exercise, "names", None) is None else "program"
    return f"{kind}_{exercise.id.partition('.')[2]}"


def cell_id(exercise: Exercise) -> str:
    """The id of the cell in which it is answered."""
    return f"answer-{exercise.id.replace('.', '-')}"


def literal(items: Items, exercise: Exercise, value: Any) -> str:
    """A task's numbers as Python; ValueError where there is more than numbers and texts."""
    if isinstance(value, dict):
        parts = [f"{key!r}: {literal(items, exercise, entry)}" for key, entry in value.items()]
        return "{" + ", ".join(parts) + "}"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(literal(items, exercise, entry) for entry in value) + "]"
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
