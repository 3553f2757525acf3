"""The marks of a notebook without the grader: its cells run here, its answers judged one by one.
Only for notebooks that the tests wrote.
"""

import contextlib
import io
import warnings

import numpy as np

from dhlab.course.exercises import exercises
from dhlab.grading.results.marks import Graded, Mark


def marks_of(notebook, variant=0):
    """The marks of a notebook, in the order of its lesson; an answer is judged where its check
    stands.
    """
    lesson = notebook.metadata["dhlab"]["lesson"]
    verdicts = {}
    space = {
        "hint": print,
        "given": lambda key: exercises()[key].given(variant),
        "check": lambda key, answer: verdicts.__setitem__(
            key, exercises()[key].judge(answer, variant)
        ),
    }
    with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings(), np.printoptions():
        warnings.simplefilter("ignore")
        for cell in notebook.cells:
            if cell.cell_type == "code":
                _run(cell.source, space)
    scored = [
        exercise
        for key, exercise in exercises().items()
        if key.startswith(lesson) and exercise.points
    ]
    return tuple(_mark(verdicts.get(exercise.id) or exercise.judge(None)) for exercise in scored)


def _run(source, space):
    source = "\n".join(
        line
        for line in source.splitlines()
        if "dhlab.course import" not in line and "view." not in line and "set_variant" not in line
    )
    with contextlib.suppress(Exception):
        exec(compile(source, "<cell>", "exec"), space)


def _mark(verdict):
    return Mark(
        verdict.exercise,
        verdict.status,
        verdict.points,
        verdict.of,
        verdict.mistake,
        verdict.headline,
        verdict.place,
        verdict.why,
        verdict.next,
    )


def graded(student, notebook, variant=0, **more):
    """The Graded of a notebook."""
    return Graded(
        student,
        f"{student}/notebook.ipynb",
        "graded",
        marks_of(notebook, variant),
        variant,
        cage="none, in a test",
        **more,
    )
