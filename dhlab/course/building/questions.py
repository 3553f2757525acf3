"""What an exercise asks, shown above the cell in which it is answered."""

import re
from collections.abc import Iterator

import nbformat
from nbformat import NotebookNode

from ..exercises import exercises
from ..kinds import Exercise

__all__ = ["asked_in", "question_cell", "question_of", "with_questions"]

PREDICTED = re.compile(r"""^predict\(\s*["']([^"']+)["']""", re.MULTILINE)


def asked_in(cell: NotebookNode) -> str | None:
    """The id of the exercise or the prediction that a cell of code is to answer."""
    predicted = PREDICTED.search(cell.source)
    number = predicted[1] if predicted else cell.metadata.get("exercise")
    return number if isinstance(number, str) else None


def question_of(cell: NotebookNode) -> str | None:
    """The id of the exercise that a Markdown cell was made from; None of any other cell."""
    return cell.metadata.get("dhlab", {}).get("question")


def question_cell(exercise: Exercise, variant: int = 0) -> NotebookNode:
    """An exercise's title and points, its question and its options as a Markdown cell.

    Its metadata say which exercise it shows, so that something else can take its place.

    Examples
    --------
    >>> print(question_cell(exercises()["02.2"]).source)
    **02.2 The number that moves** · 1 point
    <BLANKLINE>
    Joint 1 slides along its axis. Which number of row 1 changes while the arm moves?
    <BLANKLINE>
    - `"a"` the link length a
    - `"b"` the joint angle θ
    - `"c"` all four
    - `"d"` the link offset d
    - `"?"` I don't know yet
    """
    cell = nbformat.v4.new_markdown_cell(
        exercise.shown(variant), metadata={"dhlab": {"question": exercise.id}}
    )
    cell["id"] = f"question-{exercise.id.replace('.', '-')}"
    return cell


def with_questions(cells: list[NotebookNode]) -> Iterator[NotebookNode]:
    """The cells of a lesson, with a question's cell above each that is to be answered."""
    for cell in cells:
        asked = asked_in(cell) if cell.cell_type == "code" else None
        exercise = exercises().get(asked) if asked else None
        if exercise is not None:
            yield question_cell(exercise)
        yield cell
