"""Handing out: a folder of lessons for each student, each with the student's own numbers; or one
folder for all.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING

import nbformat

from ...course.building.questions import question_of
from ...course.exercises import exercises
from ...course.progress import MARKER
from ...course.workspace import handed_out
from ...formats.files import read_text, write_text
from ..own_items import own_checks
from .own_notebooks import notebooks_of, variant_cell
from .variants import new_key, read_key, variants, write_key

if TYPE_CHECKING:
    from ..intake.roster import Student
    from ..own_items import Items

__all__ = ["release", "key_of", "with_variant", "make_folder"]

KEY_NAME = "teacher.key"
PAGES = ("glossary.md", "LICENSE.md")


def release(
    out: str | Path,
    roster: Sequence[Student] = (),
    key: bytes | None = None,
    lessons: Sequence[str] = (),
    new_key_at: str | Path | None = None,
    items: Items | None = None,
) -> tuple[int, int]:
    """Write the lessons into ``out``: into a folder per student, or into ``out`` itself when there
    is no roster.

    Nothing that exists is overwritten: a second run adds the students who have joined since.

    Parameters
    ----------
    out : str or path
        Made when it does not exist.
    roster : sequence of Student
    key : bytes or None
        The teacher's key; without one everybody has the same numbers.
    lessons : sequence of str
        Such as ``["05", "06"]``; all when empty.
    new_key_at : str or path or None
        Where the key is to be written, when it is new: once nothing stands against handing out, and
        before anything is handed out.
    items : Items, optional
        A teacher's own, of which students get questions and numbers.

    Returns
    -------
    written, kept : int
        How many files were written, and how many were there already.

    Raises
    ------
    ValueError
        There is no such lesson, a folder cannot be made, or what is there was handed out with
        another key.
    """
    out = Path(out)
    files = _files(lessons)
    numbers = variants(key, [student.student for student in roster]) or {"": 0}
    wanted = [
        (
            out / student / name,
            text if number == 0 or not name.endswith(".ipynb") else with_variant(text, number),
            number,
        )
        for student, number in numbers.items()
        for name, text in files.items()
    ]
    if items:
        wanted += [
            (out / student / name, text, number)
            for student, number in numbers.items()
            for name, text in notebooks_of(items, number).items()
            if not lessons or name[:2] in lessons
        ]
    missing = [(path, text) for path, text, number in wanted if not _there(path, number)]
    if new_key_at and key:
        write_key(new_key_at, key)
    for folder in dict.fromkeys(path.parent for path, _ in missing):
        make_folder(folder)
    for path, text in missing:
        write_text(path, text)
    return len(missing), len(wanted) - len(missing)


def key_of(path: str | Path, out: str | Path) -> tuple[bytes, bool]:
    """The teacher's key: read where there is one, drawn where there is none (and written by
    :func:`release`); refused inside what is handed out.

    Returns
    -------
    key : bytes
    new : bool
        Whether it was drawn now.
    """
    path, out = Path(path), Path(out)
    if path.resolve().is_relative_to(out.resolve()):
        raise ValueError(
            f"{path}: expected the key outside the folder that is handed out, found it inside"
            f" {out}; give another place with --key"
        )
    if path.exists():
        return read_key(path), False
    return new_key(), True


def with_variant(text: str, number: int) -> str:
    """A lesson whose first code cell says whose numbers it draws, and whose options stand in the
    order of that number.

    Parameters
    ----------
    text : str
        The notebook's file.
    number : int

    Returns
    -------
    str
    """
    notebook = nbformat.reads(text, as_version=4)
    first = next(i for i, cell in enumerate(notebook.cells) if cell.cell_type == "code")
    cell = variant_cell(notebook.metadata.dhlab.lesson, number)
    for question in notebook.cells:
        asked = question_of(question)
        if asked:
            question.source = exercises()[asked].shown(number)
    notebook.cells.insert(first, cell)
    notebook.metadata.dhlab["variant"] = number
    return nbformat.writes(notebook) + "\n"


def _files(lessons):
    """Name and text of what is handed out."""
    folder = handed_out()
    found = {
        path.name: path.read_text(encoding="utf-8")
        for path in sorted(folder.glob("[0-9][0-9]*-*.ipynb"))
    }
    unknown = sorted(set(lessons) - {name[:2] for name in found} - set(own_checks()))
    if unknown:
        raise ValueError(
            f"release: expected lessons from {', '.join(sorted({name[:2] for name in found}))},"
            f" found {', '.join(unknown)}; write two digits, such as 05"
        )
    chosen = {name: text for name, text in found.items() if not lessons or name[:2] in lessons}
    chosen |= {
        name: (folder / name).read_text(encoding="utf-8")
        for name in PAGES
        if (folder / name).exists()
    }
    # so that dhlab lab lays no second copy beside these
    given = {name: sha256(text.encode()).hexdigest() for name, text in chosen.items()}
    return chosen | {f"{MARKER}/lessons.json": json.dumps(given, indent=1) + "\n"}


def _there(path, number):
    """Whether a file is there already; one with other numbers is an error, and nothing has been
    written yet.
    """
    if not path.exists():
        return False
    if path.suffix == ".ipynb":
        try:
            found = (
                nbformat.reads(read_text(path, "a lesson"), as_version=4)
                .metadata.get("dhlab", {})
                .get("variant", 0)
            )
        except (ValueError, AttributeError, KeyError):
            found = None
        if found != number:
            raise ValueError(
                f"{path}: expected a new file or the lesson of this roster and key, found another;"
                " nothing was written: choose another --out, or give its --key"
            )
    return True


def make_folder(folder: str | Path) -> None:
    """Make a folder and those above it; ValueError in one sentence when that cannot be done."""
    try:
        Path(folder).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ValueError(
            f"{folder}: expected to make a folder here, found that it cannot be done"
            f" ({error.strerror}); choose another --out"
        ) from None
