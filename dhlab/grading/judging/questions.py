"""What is asked of a submission: the numbers of its tasks and the handed-out checks; what one of
its programs is called with. No answer is among it.
"""

import __future__

import ast
import hmac
import inspect
import json
import marshal
import re
from base64 import b64encode
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from ...course.exercises import exercises
from ...course.kinds import Function, Prediction, PreTest
from ...course.kinds.exercise import Exercise
from ...course.workspace import handed_out
from ..inside.reading.demonstrations import print_of
from ..inside.wire import encode
from ..own_items import own_checks
from ..settings import Settings

__all__ = [
    "Course",
    "call_request",
    "handed_out_cells",
    "handed_out_checks",
    "named_modules",
    "request",
    "scored",
    "seed",
]

IMPORT = re.compile(r"^\s*(?:import|from)\s+([A-Za-z_][\w.]*)", re.MULTILINE)


@dataclass(frozen=True)
class Course:
    """What every worker of the grader knows: lessons, settings, variants, and the one exercise that
    is asked for, if it is one.

    Parameters
    ----------
    lessons : tuple of str
    settings : Settings
    variants : mapping of str to int
        Of the whole class, to see whose numbers an answer fits.
    only : str
        An exercise's id; all when empty.
    """

    lessons: tuple[str, ...]
    settings: Settings
    variants: dict[str, int]
    only: str = ""

    @property
    def exercises(self) -> list[Exercise]:
        """The exercises that are marked, in the order of the course."""
        return [exercise for exercise in scored(self.lessons) if self.only in ("", exercise.id)]


def scored(lessons: Collection[str]) -> list[Exercise]:
    """The exercises of some lessons that earn points; guesses and pre-tests do not.

    Examples
    --------
    >>> [exercise.id for exercise in scored(("05",))][:3]
    ['05.1', '05.3', '05.4']
    """
    return [
        e
        for key, e in exercises().items()
        if key.split(".")[0] in lessons and not isinstance(e, (Prediction, PreTest))
    ]


def handed_out_checks() -> dict[str, dict[str, Any]]:
    """For each sitting of a lesson that is handed out ("08", "08b"), for each exercise: the
    expression its check is given, and the id of the cell before it.

    Examples
    --------
    >>> expression, cell = handed_out_checks()["05"]["05.1"]
    >>> expression
    'rot_x'
    """
    return {**_course_checks(), **own_checks()}


@cache
def _course_checks():
    lessons: dict[str, dict[str, Any]] = {}
    for path in sorted(handed_out().glob("[0-9][0-9]*.ipynb")):
        code = [
            cell
            for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]
            if cell["cell_type"] == "code"
        ]
        found = lessons.setdefault(path.name.partition("-")[0], {})
        for before, cell in zip([{}, *code], code):
            for key, expression in _checks("".join(cell["source"])):
                found[key] = [expression, before.get("id", "")]
    return lessons


def handed_out_cells(lessons: Collection[str]) -> list[str]:
    """The cells of code of some lessons, as they were handed out."""
    return [
        "".join(cell["source"])
        for path in sorted(handed_out().glob("[0-9][0-9]*.ipynb"))
        if path.name[:2] in lessons
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]
        if cell["cell_type"] == "code"
    ]


@cache
def _prints(lessons):
    """The fingerprints of these cells."""
    return sorted({print_of(source) for source in handed_out_cells(lessons)})


def _checks(source):
    """(exercise, expression) of each check in a cell."""
    if "check(" not in source:
        return
    for node in ast.walk(ast.parse(source)):
        if (
            isinstance(node, ast.Call)
            and getattr(node.func, "id", "") == "check"
            and len(node.args) == 2
            and isinstance(node.args[0], ast.Constant)
        ):
            yield node.args[0].value, ast.unparse(node.args[1])


def named_modules(lessons: Collection[str]) -> list[str]:
    """What the lessons' own cells import, besides dhlab."""
    text = "\n".join(handed_out_cells(lessons))
    return sorted({name for name in IMPORT.findall(text) if name.partition(".")[0] != "dhlab"})


def seed(key: bytes | None, number: str, student: str, exercise: str) -> int:
    """What the inputs of graded calls are drawn from: known to nobody before it is graded, and the
    same whenever it is graded again.

    Parameters
    ----------
    key : bytes or None
        The teacher's key, where there is one.
    number : str
        The number that is recorded with the student's marks.
    student, exercise : str

    Returns
    -------
    int

    Examples
    --------
    >>> seed(None, "00", "ada", "05.4") == seed(None, "00", "ada", "05.4")
    True
    >>> seed(None, "00", "ada", "05.4") == seed(None, "01", "ada", "05.4")
    False
    """
    text = json.dumps([number, student, exercise]).encode()
    return int.from_bytes(hmac.new(key or b"no key", text, "sha256").digest()[:16])


def request(course: Course, variant: int, skip: Iterable[int] = ()) -> dict[str, Any]:
    """What the cage is told of a student's tasks.

    Parameters
    ----------
    course : Course
    variant : int
    skip : sequence of int
        Cells that are not run: an earlier run did not survive them.

    Returns
    -------
    dict
        Ready for JSON.
    """
    lessons = {
        key: checks for key, checks in handed_out_checks().items() if key[:2] in course.lessons
    }
    mine = [
        exercise for key, exercise in exercises().items() if key.split(".")[0] in course.lessons
    ]
    return {
        "checks": lessons,
        "given": {e.id: encode(e.given(variant)) for e in mine},
        "functions": [e.id for e in mine if isinstance(e, Function)],
        "only": [course.only] if course.only else [],
        "skip": sorted(skip),
        "untouched": _prints(course.lessons),
        "cell_seconds": course.settings.limits.cell_seconds,
    }


def call_request(
    asked: Mapping[str, Any],
    exercise: Function,
    cell: int,
    skip: Iterable[int] = (),
    whole: bool = False,
) -> dict[str, Any]:
    """What the cage is told of one program before it is called.

    The arguments are not among it: they arrive call by call.

    Parameters
    ----------
    asked : dict
        What it is told of the student's tasks, by :func:`request`.
    exercise : Function
    cell : int
        That of its check.
    skip : sequence of int
        As for :func:`request`.
    whole : bool
        With all that its notebook holds, not only what reading tells that it depends on.

    Returns
    -------
    dict
        Ready for JSON.
    """
    return {name: asked[name] for name in ("checks", "given", "untouched", "cell_seconds")} | {
        "skip": sorted(skip),
        "call": exercise.id,
        "names": list(exercise.names),
        "cell": cell,
        "whole": whole,
        "transform": "" if exercise.library else _moves(exercise.family),
    }


@cache
def _moves(family):
    """``dhlab.transform``, compiled, for a task that may use the moves; nothing for one that asks
    for a move.
    """
    from ... import transform

    # neither what it says nor its types: each program's process makes the module anew
    without = __future__.annotations.compiler_flag
    code = compile(inspect.getsource(transform), "<transform>", "exec", without, True, 2)
    return "" if family in transform.__all__ else b64encode(marshal.dumps(code)).decode()
