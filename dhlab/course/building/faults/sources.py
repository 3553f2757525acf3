"""What keeps a source from becoming a lesson, a sentence for each thing: where, what is expected,
what was found, what to do.
"""

import re
import traceback
from collections.abc import Iterable, Sequence
from pathlib import Path

from ...exercises import exercises, sittings
from ...kinds import Prediction
from ..questions import asked_in
from ..reading import PRACTICE, in_practice, lines_of, read_source, sitting_of
from .cells import cell_faults
from .exercises import exercise_faults

__all__ = ["refuse", "refuse_sources"]

EXERCISES = Path(__file__).parents[2] / "exercises"
CHECKED = re.compile(r'check\("([^"]+)"')  # at the beginning of a cell


def refuse_sources(paths: Iterable[Path]) -> None:
    """Refuse sources that cannot become lessons, before anything is run or written.

    Raises
    ------
    ValueError
        A sentence for each thing that is wrong.
    """
    refuse([fault for path in paths for fault in _faults(path)])


def refuse(faults: Sequence[str]) -> None:
    """Raise ValueError with these sentences, where there are any."""
    if faults:
        raise ValueError("\n".join(faults))


def _faults(path):
    refuse(_broken_exercises())
    notebook, number = read_source(path), sitting_of(path)
    lines, name = lines_of(path, notebook), f"{path.parent.name}/{path.name}"
    for cell in notebook.cells:
        yield from (
            f"{name}, line {lines[cell.id] + at}: {words}" for at, words in cell_faults(cell)
        )
        yield from (f"{name}, line {lines[cell.id]}: {words}" for words in _misplaced(cell))
    yield from (f"{name}: {words}" for words in _missing(notebook, number))
    for exercise in _of(number):
        yield from (
            f"{_where(number, exercise.id)}: {words}" for words in exercise_faults(exercise)
        )


def _where(number, key):
    """File, line and id of an exercise; no line where its id is not written out there."""
    file = EXERCISES / f"lesson{number}.py"
    lines = file.read_text("utf-8").splitlines() if file.is_file() else []
    at = [k for k, line in enumerate(lines, 1) if f'id="{key}"' in line]
    return f"dhlab/course/exercises/{file.name}{f', line {at[0]}' if at else ''}, {key}"


def _of(number, predictions=True):
    return [
        exercises()[key]
        for key in sittings().get(number, ())
        if predictions or not isinstance(exercises()[key], Prediction)
    ]


def _broken_exercises():
    """A module of exercises that Python cannot read."""
    try:
        exercises()
    except Exception as error:
        places = [(error.filename or "", error.lineno)] if isinstance(error, SyntaxError) else []
        places += [
            (frame.filename, frame.lineno)
            for frame in reversed(traceback.extract_tb(error.__traceback__))
            if Path(frame.filename).parent.name == "exercises"
            and Path(frame.filename).name != "__init__.py"
        ]
        if not places:
            raise
        file, line = places[0]
        return [
            f"dhlab/course/exercises/{Path(file).name}, line {line}: expected Python that can be"
            f" imported, found {type(error).__name__}: {error}; correct it"
        ]
    return []


def _misplaced(cell):
    """An exercise on the wrong side of *More practice*, or that section within another cell."""
    if cell.cell_type == "markdown":
        if f"\n{PRACTICE}" in cell.source:
            yield f"expected {PRACTICE} at the beginning of a cell; write +++ in the line above it"
        return
    checked = CHECKED.match(cell.source)
    exercise = exercises().get(checked[1] if checked else asked_in(cell) or "")
    if exercise is not None and exercise.practice != in_practice(cell):
        where, mend = (
            (f"below {PRACTICE}, found it elsewhere", "take practice=True from")
            if exercise.practice
            else (f"elsewhere, found it below {PRACTICE}", "write practice=True in")
        )
        yield f"expected {exercise.id} {where}; move its cell, or {mend} the exercise"


def _missing(notebook, number):
    """Exercises without a cell of their own, or a check."""
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    stubs = [cell.metadata.get("exercise") for cell in code]
    checks = [match[1] for match in (CHECKED.match(cell.source) for cell in code) if match]
    for key in (exercise.id for exercise in _of(number, predictions=False)):
        for what, there in (
            (f'one cell with :exercise: "{key}" above its code', stubs.count(key)),
            (f'one cell that begins with check("{key}", ...)', checks.count(key)),
        ):
            if there != 1:
                yield (
                    f"expected {what}, found {there or 'none'}; every exercise has its cell, and"
                    " its check below it"
                )
