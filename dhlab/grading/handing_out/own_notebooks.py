"""The student's copy of a teacher's own items: the questions and the student's numbers; a check
there only notes the answer. Grading does without this module, and without nbformat.
"""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import nbformat

from ..own_items import YOUR_NUMBERS, cell_id, defined, install, literal, name_of

if TYPE_CHECKING:
    from ...course.kinds.exercise import Exercise
    from ..own_items import Items

__all__ = ["notebooks_of", "variant_cell"]


def notebooks_of(items: Items, variant: int) -> dict[str, str]:
    """The student's copy: for each lesson of the items the name and the text of a notebook that
    holds questions and numbers, and nothing by which they are judged.
    """
    install(items)
    found = defined(items)
    lessons: dict[str, list[Exercise]] = {}
    for exercise in found["EXERCISES"]:
        lessons.setdefault(exercise.id.partition(".")[0], []).append(exercise)
    made = {}
    for lesson, asked in lessons.items():
        cells = [
            _text(f"# {lesson} {found['TITLE']}", f"{lesson}-title"),
            # in a cell, since not every program keeps what stands beside the cells
            *([variant_cell(lesson, variant)] if variant else []),
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


def variant_cell(lesson: str, number: int) -> Any:
    """The cell that says whose numbers a notebook draws."""
    return _code(
        f"from dhlab.course import set_variant\nset_variant({number})  # your own numbers: leave"
        " this cell as it is",
        f"{lesson}-variant",
        deletable=False,
        editable=False,
        tags=["variant"],
    )


def _cells(items, exercise, text, variant):
    yield _text(
        "\n\n".join(filter(None, (exercise.shown(variant), text))), f"question-{exercise.id}"
    )
    given = dict(exercise.given(variant))
    if given:
        told = f"{YOUR_NUMBERS}task = {literal(items, exercise, given)}"
        yield _code(told, f"numbers-{exercise.id}", deletable=False, editable=False)
    name = name_of(exercise)
    names = getattr(exercise, "names", None)
    stub = f"{name} = ..." if names is None else f"def {name}({', '.join(names)}):\n    ..."
    yield _code(stub, cell_id(exercise), exercise=exercise.id)
    yield _code(f'check("{exercise.id}", {name})', f"check-{exercise.id}")


def _text(source, name):
    cell = nbformat.v4.new_markdown_cell(source)
    cell["id"] = re.sub(r"\W", "-", name)
    return cell


def _code(source, name, **metadata):
    cell = nbformat.v4.new_code_cell(source, metadata=metadata)
    cell["id"] = re.sub(r"\W", "-", name)
    return cell
