"""A student's notebooks, run in this process's cages: large ones without their outputs, and again
without a cell that ends the program.
"""

import json
from dataclasses import replace
from multiprocessing import util
from typing import TYPE_CHECKING, Any

from ..cage.cage import Cage
from ..cage.sight import OPEN
from ..cage.stage import library
from ..inside.reading.notebook import FAULTS
from ..inside.wire import error_name
from ..results.marks import TIMED_OUT, UNREADABLE
from .judge import Answers
from .questions import Course, handed_out_cells, named_modules, request

if TYPE_CHECKING:
    from .work import Task

__all__ = ["cage_of", "close", "run_all"]

LARGE = 1_000_000  # bytes of a notebook with pictures; a lesson as handed out has a tenth
TOGETHER = 2  # times the seconds of a notebook: all those of one student
AGAIN = 3  # how often a notebook is run again without the cell that ended it
_cages: dict[tuple[Any, ...], Cage] = {}


def cage_of(course: Course, room: str) -> Cage:
    """This process's cage for a course, built when it is first needed."""
    key = (course.settings.cage, course.settings.limits, course.lessons, room)
    if key not in _cages:
        if _cages and next(iter(_cages))[:3] != key[:3]:
            close()
        warm = [*(library() if room == OPEN else ()), *named_modules(course.lessons)]
        cells = handed_out_cells(course.lessons)
        _cages[key] = Cage(course.settings.cage, course.settings.limits, warm, room, cells)
    return _cages[key]


def close() -> None:
    """Close this process's cage."""
    for cage in _cages.values():
        cage.close()
    _cages.clear()


# at the end of this process; unlike atexit in workers too
util.Finalize(None, close, exitpriority=1)


def run_all(
    cage: Cage, task: "Task", course: Course, variant: int
) -> tuple[Answers, list[str], str | None, dict[str, tuple[bytes, list[int]]]]:
    """Run every notebook; (answers, notes, what kept the whole from being graded: a status or
    None, of each notebook what its programs are called from: its code, and the cells that were not
    run).
    """
    answers, runs, called = Answers(), [], {}
    notes: list[str] = []
    seconds = course.settings.limits.seconds
    left = TOGETHER * seconds
    for number, (handed, large) in enumerate(_slim(cage, task.notebooks)):
        notes += large
        most = min(seconds, left / (len(task.notebooks) - number))
        run, why, called[handed.name], used = _run(cage, handed, course, variant, answers, most)
        left -= used
        runs.append(run)
        notes += [f"{handed.name}: {note}" for note in why]
    if any(run.ended == "timed out" for run in runs):
        return answers, notes, TIMED_OUT, called
    unread = all(
        run.cell is None and (run.ended != "done" or "unreadable" in run.lines[-1]) for run in runs
    )
    return answers, notes, UNREADABLE if unread else None, called


def _slim(cage, notebooks):
    """(notebook, notes): large ones without their outputs; these are taken out in the cage, where
    it costs nobody else anything. What is still large then is no notebook, and is cut off.
    """
    for handed in notebooks:
        if len(handed.raw) <= LARGE:
            yield handed, []
            continue
        run = cage.run({"slim": 1, "cell_seconds": 10}, handed.raw, 20)
        raw = _code(run)
        told = [] if raw else [f"{handed.name}: large, and not for its outputs: not run"]
        yield replace(handed, raw=raw or handed.raw[:LARGE]), told


def _code(run):
    """The notebook without what is not code, as it was told before any of it ran; empty where it
    was not told.
    """
    slim = run.lines[0].get("slim") if run.lines else None
    return json.dumps(slim).encode() if slim else b""


def _run(cage, handed, course, variant, answers, most):
    """Run one notebook for so many seconds at most; a cell that ends the program costs itself, and
    the rest is run again without it.
    """
    skip: set[int] = set()
    notes, left, raw = [], most, handed.raw
    while True:
        run = cage.run(request(course, variant, skip), raw, left)
        if not run.lines and run.ended == "crashed":  # the cage had died: nothing has run
            run = cage.run(request(course, variant, skip), raw, left)
        raw = _code(run) or raw
        left -= run.seconds
        late = any(line.get("ended") == "timed out" for line in run.lines)
        if late and cage.learnt and left > 0:
            continue  # it may have loaded for too long what those after it have loaded for them
        answers.add(run, handed)
        broken = [
            line["unreadable"] for line in run.lines if isinstance(line.get("unreadable"), str)
        ]
        if broken:
            # what comes out may be made up: only our own sentences are repeated
            notes.append(broken[0] if broken[0] in FAULTS else error_name(broken[0]))
        if (
            run.ended == "done"
            or not _is_cell(run)
            or run.cell in skip
            or len(skip) == AGAIN
            or left <= 0
        ):
            if run.ended != "done":
                notes.append(f"stopped: {run.ended}")
            return run, notes, (raw, sorted(skip)), most - left
        skip.add(run.cell)
        notes.append(f"cell {run.cell + 1} ended the program ({run.ended}); run again without it")


def _is_cell(run):
    """Whether it ended in a cell that there is: which one is what it says of itself."""
    slim = run.lines[0].get("slim") if run.lines else None
    return run.cell is not None and slim is not None and 0 <= run.cell < len(slim["cells"])
