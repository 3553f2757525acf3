"""One exercise as its author wants to see it: what is asked, the numbers, and what is said of the
right answer and of each wrong one that it knows; without a notebook.
"""

import contextlib
import inspect
import re
import sys
import textwrap
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from .building.faults.exercises import exercise_faults
from .kinds import Exercise, Function, Lettered, Table, Value
from .kinds.chosen import OneOf

__all__ = ["preview"]


def preview(exercise: Exercise, variant: int = 0) -> str:
    """All that can be seen of an exercise, as text.

    Parameters
    ----------
    exercise : Exercise
    variant : int
        Whose numbers.

    Examples
    --------
    >>> from dhlab.course.exercises import exercises
    >>> print(preview(exercises()["05.2"])[:44])
    **05.2 Moves that commute** · 1 point
    <BLANKLINE>
    Which
    """
    parts = [exercise.shown(variant)]
    parts += [f"numbers   {key} = {_short(value)}" for key, value in _given(exercise, variant)]
    hints = exercise.hints if isinstance(exercise.hints, tuple) else ()
    parts += [f"hint {k}    {hint}" for k, hint in enumerate(hints, 1)]
    where = _where(exercise)
    parts += [f"mend      {where}{fault}" for fault in exercise_faults(exercise)]
    with contextlib.suppress(Exception):  # what does not run is told among what to mend
        for what, answer in _answers(exercise, variant):
            verdict = exercise.judge(answer, variant)
            parts.append(f"{what}\n{textwrap.indent(str(verdict), '  ')}")
    return "\n\n".join(parts)


def _given(exercise, variant):
    if isinstance(exercise, Function):
        return list(zip(exercise.names, exercise.cases(variant)[0]))
    return list(exercise.given(variant).items())


def _answers(exercise: Exercise, variant: int) -> Iterator[tuple[str, Any]]:
    """(what it is, the answer) of everything that the exercise says something of."""
    if isinstance(exercise, Function):
        yield "right     its own answer", exercise.answer
    elif isinstance(exercise, (Value, Table)):
        given = exercise.given(variant)
        right = exercise.answer(**given)
        yield f"right     {_short(right)}", right
        for mistake, _, value in exercise.mistakes(**given):
            yield f"wrong     {_short(value)}  {mistake or ''}", value
    elif isinstance(exercise, OneOf):
        letters = exercise.letters(variant)
        for key, text in exercise.texts().items():
            what = "right" if key == exercise.correct else "wrong"
            yield f'{what}     "{letters[key]}" {text}', letters[key]
    if isinstance(exercise, Lettered):
        yield 'either    "?"', "?"


def _short(value):
    if isinstance(value, np.ndarray) or (isinstance(value, (list, tuple)) and len(value) > 3):
        value = np.array2string(np.asarray(value), precision=6, suppress_small=True)
    return textwrap.indent(str(value), " " * 12).lstrip()


def _where(exercise):
    """The file and line in which an exercise is defined; empty when that is not found."""
    for name, module in list(sys.modules.items()):
        listed = getattr(module, "EXERCISES", None)
        if name.startswith("dhlab.course.exercises.") and listed and exercise in listed:
            file = Path(inspect.getfile(module))
            lines = file.read_text(encoding="utf-8").splitlines()
            found = (
                k for k, line in enumerate(lines, 1) if re.search(rf'id="{exercise.id}"', line)
            )
            return f"{file.name}, line {next(found, 1)}: "
    return ""
