"""What is wrong with a cell of a source: pairs of (lines below its first, what is wrong)."""

import ast
import re
from collections.abc import Iterator
from difflib import SequenceMatcher, get_close_matches

from nbformat import NotebookNode

from ...exercises import exercises
from ...kinds import UNDECIDED, Lettered, Prediction
from ..questions import asked_in

__all__ = ["CALL", "cell_faults", "plain_python"]

MARKER = re.compile(r"[ \t]*### (BEGIN|END) SOLUTION[ \t]*")
ALIKE = 0.7  # a comment this near to a marker is meant to be one
OPTION = re.compile(r"""#\s*(?:["'](.)["']|\s\s(\w))\s+\S""")  # of a list in a comment
CALL = re.compile(r"""\b(check|given|hint|predict|reveal)\(\s*["']([^"']+)["']""")


def cell_faults(cell: NotebookNode) -> Iterator[tuple[int, str]]:
    """What is wrong with a cell, and how many lines below its first."""
    yield from _markers(cell)
    if cell.cell_type == "code":
        yield from _numbers(cell)
        yield from _region(cell)
        yield from _python(cell)
        yield from _by_hand(cell)


def _markers(cell):
    """Marks of a solution that are misspelt, alone, or outside a code cell: they would hand it
    out.
    """
    lines = [(at, line) for at, line in enumerate(cell.source.splitlines()) if _like_a_marker(line)]
    if cell.cell_type != "code":
        return [
            (
                at,
                (
                    f"expected {line.strip()} in a code cell, found it in the text; the cell's"
                    " first line must be ```{code-cell} ipython3"
                ),
            )
            for at, line in lines
        ]
    misspelt = [
        (
            at,
            (
                "expected ### BEGIN SOLUTION or ### END SOLUTION alone in its line, found"
                f" {line.strip()!r}; write it exactly so"
            ),
        )
        for at, line in lines
        if not MARKER.fullmatch(line)
    ]
    return misspelt or _alone(
        [(at, found[1]) for at, line in lines if (found := MARKER.fullmatch(line))]
    )


def _like_a_marker(line):
    words = line.partition("#")[2].strip("# \t").lower()
    return any(
        SequenceMatcher(None, words, marker).ratio() > ALIKE
        for marker in ("begin solution", "end solution")
    )


def _alone(markers):
    for here, after in zip(markers, [*markers[1:], (None, None)]):
        if here[1] == "BEGIN" and after[1] != "END":
            yield (
                here[0],
                (
                    "expected ### END SOLUTION below this ### BEGIN SOLUTION, in the same cell,"
                    " found none; add it, or the solution is handed out"
                ),
            )
    for before, here in zip([(None, None), *markers], markers):
        if here[1] == "END" and before[1] != "BEGIN":
            yield (
                here[0],
                (
                    "expected ### BEGIN SOLUTION above this ### END SOLUTION, in the same cell,"
                    " found none; add it, or the solution is handed out"
                ),
            )


def _numbers(cell):
    """Ids that no exercise has."""
    asked = [
        (
            cell.source.count("\n", 0, call.start()),
            f'{call[1]}("{call[2]}")',
            call[2],
            call[1] in ("predict", "reveal"),
        )
        for call in CALL.finditer(cell.source)
    ]
    if "exercise" in cell.metadata:
        asked.insert(
            0,
            (
                0,
                f":exercise: {cell.metadata['exercise']!r} above this line",
                cell.metadata["exercise"],
                False,
            ),
        )
    for at, place, number, prediction in asked:
        known = [
            key
            for key, exercise in exercises().items()
            if isinstance(exercise, Prediction) == prediction
        ]
        if number not in known:
            near = get_close_matches(str(number), known, 1)
            what = "a prediction" if prediction else "an exercise"
            yield (
                at,
                f"expected the id of {what} in quotes, found {place}"
                + (f'; did you mean "{near[0]}"?' if near else "; correct it, or add the exercise"),
            )


def _region(cell):
    if (
        "exercise" in cell.metadata
        and "### BEGIN SOLUTION" not in cell.source
        and not any(_like_a_marker(line) for line in cell.source.splitlines())
    ):
        yield (
            0,
            (
                "expected ### BEGIN SOLUTION and ### END SOLUTION in the cell of exercise"
                f" {cell.metadata['exercise']}, found neither; put what is not handed out between"
                " them"
            ),
        )


def _python(cell):
    try:
        ast.parse(plain_python(cell.source))
    except SyntaxError as error:
        yield (
            (error.lineno or 1) - 1,
            f"expected Python, found a syntax error: {error.msg}; correct the cell",
        )


def plain_python(source: str) -> str:
    """A cell's code with IPython's own commands, such as ``%timeit``, written as Python."""
    from IPython.core.inputtransformer2 import TransformerManager

    return TransformerManager().transform_cell(source)


def _by_hand(cell):
    """Options that are written into the cell, and would be another text than the exercise's."""
    exercise = exercises().get(asked_in(cell) or "")
    if not isinstance(exercise, Lettered):
        return
    letters = {*exercise.letters().values(), UNDECIDED}
    for at, line in enumerate(cell.source.splitlines()):
        option = OPTION.match(line)
        if option and (option[1] or option[2]) in letters:
            yield (
                at,
                f"expected the options of {exercise.id} in its exercise alone, from where the"
                f" lesson takes them, found {line.strip()!r}; take this line out",
            )
