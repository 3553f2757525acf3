"""The roster: who is in the class, from a CSV file with a column ``student`` and, where known,
``name``, ``email``, ``language`` and ``section``.
"""

import csv
import difflib
import io
import re
import unicodedata
from dataclasses import dataclass
from pathlib import Path

from ...formats.files import read_text

__all__ = ["Student", "read_roster"]

CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f]+")  # what a terminal obeys; names are printed there
SEPARATOR = re.compile(r"\ufeff?sep=([;,\t])[;,]*\r?", re.IGNORECASE)
COLUMNS = ("student", "name", "email", "language", "section")
CANVAS = frozenset(("sis user id", "sis login id"))  # columns of its gradebook alone
ID = re.compile(r"\w[\w.@+-]{0,99}(?<!\.)\Z")  # an id names files and folders, on every system
# what names no file on Windows
RESERVED = re.compile(r"(con|prn|aux|nul|com\d|lpt\d)(\..*)?\Z", re.IGNORECASE)
LANGUAGE = re.compile(r"[a-z]{2,3}(_[A-Z][A-Za-z]{1,3})?\Z")


@dataclass(frozen=True)
class Student:
    """One line of the roster: the id, what a person is called, written to and read by, and the
    section of the class.
    """

    student: str
    name: str = ""
    email: str = ""
    language: str = "en"
    section: str = ""


def read_roster(path: str | Path) -> tuple[Student, ...]:
    """The students of a CSV file, in its order.

    Commas or semicolons separate the cells (spreadsheets write either); other columns than the five
    known ones are passed over, but for one whose name is so like a known one that it must be a
    typing mistake.

    Parameters
    ----------
    path : str or path

    Returns
    -------
    tuple of Student

    Raises
    ------
    ValueError
        No column ``student``, no students, an id that stands twice or cannot name a file, a line
        with more cells than columns.

    Examples
    --------
    >>> read_roster("no-such.csv")
    Traceback (most recent call last):
    ...
    ValueError: no-such.csv: expected a roster, found no such file; check the name and the folder
    """
    text = read_text(path, "a roster")
    first = text.partition("\n")[0]
    if told := SEPARATOR.fullmatch(first):  # a line of Excel's own
        text, delimiter = text[len(first) :], told[1]
    else:
        delimiter = ";" if first.count(";") > first.count(",") else ","
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter)
    try:
        rows = [(reader.line_num, row) for row in reader if any(cell.strip() for cell in row)]
    except csv.Error as error:
        raise ValueError(
            f"{path}: line {reader.line_num}: expected a roster in CSV, found what cannot be read"
            f" ({error}); export it again as CSV"
        ) from None
    head = rows[0][1] if rows else []
    columns = _columns(path, head)
    students = tuple(
        _student(f"{path}: line {line}", row, columns, len(head)) for line, row in rows[1:]
    )
    if not students:
        raise ValueError(
            f"{path}: expected one line per student under the line of column names, found none"
        )
    _check_twice(path, students, [line for line, _ in rows[1:]])
    return students


def _columns(path, head):
    names = [cell.strip().lower() for cell in head]
    if not CANVAS.isdisjoint(names):
        raise ValueError(
            f'{path}: expected ids in the column "student", found Canvas\'s gradebook, where it'
            ' holds names; call it "name", call the column of ids ("SIS Login ID", or "ID")'
            ' "student", and take out the line "Points Possible"'
        )
    if names.count("student") != 1:
        found = ", ".join(names) or "nothing"
        raise ValueError(
            f'{path}: expected a first line of column names with one column "student", found'
            f' {found}; name the column of ids "student"'
        )
    for name in COLUMNS:
        if names.count(name) > 1:
            raise ValueError(
                f'{path}: line 1: expected every column once, found "{name}" {names.count(name)}'
                " times; keep one of them, and call the other something else"
            )
    for name in names:
        near = (
            []
            if name in COLUMNS
            else difflib.get_close_matches(name, set(COLUMNS) - set(names), 1, 0.75)
        )
        if near:
            raise ValueError(
                f'{path}: line 1: unknown column "{name}"; did you mean "{near[0]}"? Otherwise call'
                " it something else"
            )
    return {name: names.index(name) for name in COLUMNS if name in names}


def _student(where, row, columns, width):
    if any(cell.strip() for cell in row[width:]):
        raise ValueError(
            f"{where}: expected {width} cells as in the first line, found {len(row)}; a name with a"
            " comma in it stands in quotes"
        )
    cells = {
        name: CONTROL.sub(" ", unicodedata.normalize("NFC", row[i].strip()))
        for name, i in columns.items()
        if i < len(row)
    }
    student = cells.get("student", "")
    if not ID.match(student):
        raise ValueError(
            f"{where}: expected an id of letters, digits and . _ - @ + (it names files), found"
            f" {student!r}"
        )
    if RESERVED.match(student):
        raise ValueError(
            f"{where}: expected an id that can name a file, found {student!r}, which no file on"
            " Windows may be called; give another id"
        )
    language = cells.pop("language", "").replace("-", "_") or "en"
    if not LANGUAGE.match(language):
        raise ValueError(f"{where}: expected a language such as en or zh_CN, found {language!r}")
    return Student(**cells, language="zh_CN" if language == "zh" else language)


def _check_twice(path, students, lines):
    seen: dict[str, tuple[str, int]] = {}
    for student, line in zip(students, lines):
        other, before = seen.setdefault(student.student.casefold(), (student.student, line))
        if before != line:
            alike = (
                "take one out"
                if other == student.student
                else "small and capital letters name the same file on some systems"
            )
            raise ValueError(
                f"{path}: lines {before} and {line}: expected every id once, found {other!r} and"
                f" {student.student!r}; {alike}"
            )
