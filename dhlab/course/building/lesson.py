"""A lesson's source with what the contract counts: cells, words, minutes, calls."""

import ast
import re
from copy import copy
from pathlib import Path

from nbformat import NotebookNode

from ..exercises import exercises, sittings
from ..kinds import Prediction
from .faults.cells import plain_python
from .questions import question_of
from .reading import in_practice, read_source, sitting_of

__all__ = ["Lesson", "library_calls", "words"]

WORDS_A_MINUTE = 110  # technical prose by who reads it in a second language
CODE_MINUTES = 0.6  # to read and run a cell that is no exercise, and to look at what it shows
CHECK_MINUTES = 0.2  # to run a check; to mend the answer belongs to the exercise


class Lesson:
    """A lesson's source with what the contract counts."""

    def __init__(self, path: Path):
        self.path, self.number = path, sitting_of(path)
        self.notebook = read_source(path)
        # what is asked belongs to the minutes of the answer, and is not the lesson's prose
        self.cells = [cell for cell in self.notebook.cells if not question_of(cell)]
        self.questions = {
            question_of(cell): cell.source for cell in self.notebook.cells if question_of(cell)
        }
        self.about = self.notebook.metadata["dhlab"]
        self.exercises = {
            key: exercises()[key]
            for key in sittings().get(self.number, ())
            if not isinstance(exercises()[key], Prediction)
        }

    @property
    def core(self) -> "Lesson":
        """The lesson without its section *More practice*: what its stated minutes are for."""
        core = copy(self)
        core.cells = [cell for cell in self.cells if not in_practice(cell)]
        return core

    @property
    def sittings(self) -> "list[Lesson]":
        """The lesson's sittings, one file each: "04" and "04b" are one lesson."""
        return [Lesson(path) for path in sorted(self.path.parent.glob(f"{self.number[:2]}*-*.md"))]

    @property
    def markdown(self) -> list[NotebookNode]:
        """The cells of text."""
        return [cell for cell in self.cells if cell.cell_type == "markdown"]

    @property
    def code(self) -> list[NotebookNode]:
        """The cells of code."""
        return [cell for cell in self.cells if cell.cell_type == "code"]

    @property
    def prose(self) -> str:
        """All text but the questions."""
        return "\n".join(cell.source for cell in self.markdown)

    @property
    def calls(self) -> list[tuple[str, str]]:
        """Every ``check``, ``predict`` and ``reveal`` with its id, in order."""
        return [
            call
            for cell in self.code
            for call in re.findall(r'\b(check|predict|reveal)\("([^"]+)"', cell.source)
        ]

    def called(self, name: str) -> list[str]:
        """The ids given to ``check``, ``predict`` or ``reveal``, in order."""
        return [number for function, number in self.calls if function == name]

    def tagged(self, tag: str) -> list[NotebookNode]:
        """The cells that carry a tag."""
        return [cell for cell in self.cells if tag in cell.metadata.get("tags", [])]

    def minutes(self, cell: NotebookNode) -> float:
        """How long a cell takes a learner."""
        if cell.cell_type == "markdown":
            return words(cell.source) / WORDS_A_MINUTE
        checks = cell.source.startswith("check(")
        return cell.metadata.get("minutes", CHECK_MINUTES if checks else CODE_MINUTES)

    @property
    def total(self) -> float:
        """Minutes of all its cells."""
        return sum(self.minutes(cell) for cell in self.cells)


def words(text: str) -> int:
    """Words of prose: links, markup, formulas and tables counted as a reader meets them."""
    text = re.sub(r"\$\$.*?\$\$", " formula ", text, flags=re.DOTALL)
    text = re.sub(r"\]\([^)]*\)", " ", text)
    return len(re.findall(r"[^\W_][\w'’.-]*", text))


def library_calls(source: str) -> set[str]:
    """The dhlab calls of a cell: ``dh.load``, ``view.frames``, ``check`` …"""
    calls = [
        node.func
        for node in ast.walk(ast.parse(plain_python(source)))
        if isinstance(node, ast.Call)
    ]
    of_modules = {
        f"{f.value.id}.{f.attr}"
        for f in calls
        if isinstance(f, ast.Attribute)
        and isinstance(f.value, ast.Name)
        and f.value.id in ("dh", "view", "transform")
    }
    return of_modules | {
        f.id
        for f in calls
        if isinstance(f, ast.Name) and f.id in ("check", "given", "predict", "reveal", "progress")
    }
