"""The lessons' sources, ``solutions/NN-name.md`` (``NNb-name.md`` where a lesson has a second
sitting), as notebooks: cell ids from lesson and position,
questions from the exercises.
"""

import re
from collections.abc import Sequence
from copy import deepcopy
from functools import lru_cache
from pathlib import Path

import nbformat
from nbformat import NotebookNode

from ..exercises import exercises
from .questions import with_questions

__all__ = [
    "DISCUSSION",
    "LESSONS",
    "PRACTICE",
    "ROOT",
    "SOLUTIONS",
    "in_practice",
    "lines_of",
    "read_source",
    "sitting_of",
    "sources",
]

ROOT = Path(__file__).parents[3]
SOLUTIONS, LESSONS = ROOT / "solutions", ROOT / "lessons"
DISCUSSION = Path(__file__).parents[1] / "discussion.yaml"
PRACTICE = "## More practice"  # the section's heading, and
TAG = "practice"  # what every cell below it carries
KERNEL = {
    "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
    "language_info": {"name": "python"},
}


def sources(only: Sequence[str] = ()) -> list[Path]:
    """The lessons' sources, in order: all of them, or those named by number: "08" is the lesson
    with all its sittings, "08b" one of them.

    Raises
    ------
    ValueError
        A number without a lesson.
    """
    found = sorted(SOLUTIONS.glob("[0-9][0-9]*-*.md")) if SOLUTIONS.is_dir() else []
    numbers = [sitting_of(path) for path in found]
    for number in only:
        if number not in numbers:
            raise ValueError(
                f"expected the number of a lesson ({', '.join(numbers)}), found {number!r}; write"
                " it with two digits, such as 05"
            )
    return [path for path in found if not only or {sitting_of(path), path.name[:2]} & {*only}]


def sitting_of(path: Path) -> str:
    """What stands before a lesson's name.

    Examples
    --------
    >>> sitting_of(Path("solutions/08b-back-to-the-joints.md"))
    '08b'
    """
    return path.name.partition("-")[0]


def read_source(path: Path) -> NotebookNode:
    """A lesson's source as a notebook: cell ids from lesson and position, nbgrader's metadata on
    exercises and checks, what each exercise asks above its cell, a tag on the section *More
    practice*.

    Raises
    ------
    ValueError
        The head, or what stands between a cell's first line and its code, cannot be read.
    """
    notebook = _parsed(path)
    sitting, about = sitting_of(path), notebook.metadata.get("dhlab", {})
    if not isinstance(about, dict):
        raise ValueError(
            f"{_name(path)}: expected dhlab: in the head with lines such as minutes: 15 under it,"
            f" found {about!r}; indent them by two spaces"
        )
    notebook.metadata = nbformat.from_dict({**KERNEL, "dhlab": {"lesson": sitting[:2], **about}})
    notebook.nbformat, notebook.nbformat_minor = 4, 5
    for position, cell in enumerate(notebook.cells):
        cell["id"] = f"{sitting}-{position:03d}"
        if cell.cell_type == "code":
            cell.execution_count, cell.outputs = None, []
            _add_grading(cell)
    notebook.cells = list(with_questions(notebook.cells))
    _tag_practice(notebook.cells)
    return notebook


def in_practice(cell: NotebookNode) -> bool:
    """Whether a cell stands in the section *More practice*."""
    return TAG in cell.metadata.get("tags", [])


def _tag_practice(cells):
    """Tag the cells from the section's heading to the next one; a section begins with a cell."""
    inside = False
    for cell in cells:
        if cell.cell_type == "markdown" and cell.source.startswith("## "):
            inside = cell.source.startswith(PRACTICE)
        if inside:
            cell.metadata["tags"] = [*cell.metadata.get("tags", []), TAG]


def _parsed(path):
    from jupytext.myst import MystMetadataParsingError
    from yaml import YAMLError

    try:
        return deepcopy(_of_text(path.read_text(encoding="utf-8")))
    except (YAMLError, MystMetadataParsingError) as error:
        mark = getattr(error, "problem_mark", None)
        found = getattr(error, "problem", None) or " ".join(str(error).split())
        raise ValueError(
            f"{_name(path)}{f', line {mark.line + 1}' if mark else ''}: expected YAML in the head"
            f" and in the lines that begin with a colon, found: {found}; look there and in the line"
            " above for a bracket, a quote or an indent"
        ) from None


@lru_cache(100)
def _of_text(text):
    """Kept, since a source is read for the contract and again for each notebook made of it."""
    import jupytext

    return jupytext.reads(text, fmt="md:myst")


def _name(path):
    return f"{path.parent.name}/{path.name}"


def lines_of(path: Path, notebook: NotebookNode) -> dict[str, int]:
    """Where each cell's text begins in its source: {cell id: line number}; of what is made from an
    exercise, the place of the cell before it.
    """
    text, lines, at = path.read_text(encoding="utf-8"), {}, 0
    for cell in notebook.cells:
        found = text.find("\n" + cell.source, at)
        at = found + 1 if found >= 0 else at
        lines[cell.id] = text.count("\n", 0, at) + 1
        at += len(cell.source) if found >= 0 else 0
    return lines


def _add_grading(cell):
    """nbgrader's metadata: an exercise's stub is a solution cell, its check a graded one."""
    number = cell.metadata.get("exercise")
    checked = re.match(r'check\("([^"]+)"', cell.source)
    if number is not None:
        cell.metadata["nbgrader"] = {
            "grade": False,
            "grade_id": f"stub-{number}",
            "locked": False,
            "schema_version": 3,
            "solution": True,
            "task": False,
        }
    elif checked and checked[1] in exercises():
        cell.metadata["nbgrader"] = {
            "grade": True,
            "grade_id": f"check-{checked[1]}",
            "locked": True,
            "points": exercises()[checked[1]].points,
            "schema_version": 3,
            "solution": False,
            "task": False,
        }
