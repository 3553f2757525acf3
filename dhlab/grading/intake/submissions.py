"""What was handed in, by student, in any layout of folders and zips."""

import os
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime, tzinfo
from functools import cached_property
from itertools import count
from pathlib import Path

from ..shown import fingerprint, printable, some
from .files import LARGEST, Entry, Read
from .layouts import Names, Owner, student_of
from .namesakes import namesakes_of
from .notebooks import Look, look
from .roster import Student
from .timestamps import stamped
from .wrapping import entries_in, prefixes

__all__ = ["PASSED_OVER", "Notebook", "Submission", "submissions", "voters"]

PASSED_OVER = "passed over"
MOST_NOTEBOOKS = 12  # of a student
MOST_LOOKED_INTO = 20  # files of another name, of a student, that may be notebooks
MOST_NOTES = 20  # of a student
LONGEST_NAME = 400  # letters of a file's name, folders and all, that are shown
NOTEBOOK_ENDINGS = (".ipynb", ".json", ".txt", "")
LOOKS_LIKE_ONE = re.compile(rb'"(cells|worksheets)"\s*:')


@dataclass(frozen=True)
class Notebook:
    """One notebook: its name in what was handed in, its bytes when ``read`` is called, when it came
    and how that is known; how many bytes it has.
    """

    name: str
    read: Read
    when: datetime | None
    source: str
    size: int = 0

    @cached_property
    def look(self) -> Look:
        """What it says of itself; it is read once for that."""
        return look(self.read())


@dataclass
class Submission:
    """What one student handed in: notebooks, oldest first; what was refused, in sentences; whose
    numbers they draw, if another's.

    ``loose``: nothing but files of no folder; ``refused``: something was there that is no notebook
    or cannot be read; ``names``: the students of whom a stranger's folder or zip speaks inside.
    """

    student: str
    notebooks: list[Notebook] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    on_roster: bool = True
    loose: bool = True
    refused: bool = False
    numbers_of: str | None = None
    looked_into: int = 0
    names: dict[str, None] = field(default_factory=dict)


def submissions(
    place: str | Path,
    roster: Sequence[Student] = (),
    lessons: Sequence[str] = (),
    zone: tzinfo = UTC,
) -> dict[str, Submission]:
    """Everything that was handed in, by student.

    Parameters
    ----------
    place : str or path
        A folder, or a zip.
    roster : sequence of Student
        Students without a submission are there too, with no notebooks.
    lessons : sequence of str
        The names of the lessons' files, without ending; they are no part of a student's name.
    zone : tzinfo
        Of the times in a zip, which does not name it.

    Returns
    -------
    dict of str to Submission
        Students of the roster first, in its order.

    Raises
    ------
    ValueError
        There is no such folder, or no such zip.
    """
    place = Path(place)
    names = Names(roster, lessons)
    found = {student.student: Submission(student.student) for student in roster}
    expected = set(found)
    owned = _owned(stamped(entries_in(place, zone, names), zone, names), names, place.stem)
    namesakes = namesakes_of(owner for _, owner in owned)
    sure: dict[str, set[tuple[str, ...]]] = {}
    for entry, owner in owned:
        if owner.known and owner.sure:
            sure.setdefault(owner.student, set()).add(entry.outer)
    doubts: dict[str, list[str]] = {}
    for entry, owner in owned:
        apart = f"{owner.called} {owner.number}" if owner in namesakes else ""
        if not apart and _in_doubt(entry, owner, sure.get(owner.student, set())):
            apart = f"{_short(_outermost(entry))}, perhaps {owner.student}"
            doubts.setdefault(owner.student, []).append(apart)
        on_roster = (owner.known and not apart) or not roster
        student = apart or owner.student
        mine = found.setdefault(student, Submission(student, on_roster=on_roster))
        mine.loose &= len(entry.parts) == 1
        mine.names |= {owner.within: None} if owner.within else {}
        _take(mine, entry)
    for mine in found.values():
        _settle(mine)
    _tell_doubts(found, doubts)
    _tell_namesakes(found, namesakes)
    _tell_within(found)
    return {
        student: mine
        for student, mine in found.items()
        if mine.notebooks or mine.notes or student in expected
    }


def _owned(entries: Sequence[Entry], names: Names, folder: str) -> list[tuple[Entry, Owner]]:
    """Each file with its owner, which is not sure by a word that may be another's login where
    something else is surely the student's.
    """
    begin = prefixes(entries, names)
    owned = [
        (entry, student_of(entry.parts, names, folder, entry.outer, begin.get(entry.outer, "")))
        for entry in entries
    ]
    surely = {owner.student for _, owner in owned if owner.sure and not owner.login}
    return [
        (entry, owner._replace(sure=owner.sure and not (owner.login and owner.student in surely)))
        for entry, owner in owned
    ]


def _in_doubt(entry, owner, sure):
    """Whether somebody else may have called a file like this student, where ``sure`` are the
    folders in which the student's own things stand: the file takes nothing away from these.
    """
    further_in = any(entry.outer[:k] in sure for k in range(len(entry.outer)))
    return further_in or bool(sure and not owner.sure)


def _outermost(entry):
    return (*entry.outer, entry.parts[0])[0]


def _short(name):
    """A name as it is shown, no longer than 80 signs; two that are long are not one."""
    told = printable(name)
    if len(told) <= 80:
        return told
    return f"{told[:73]}-{fingerprint(name)}"


def _tell_doubts(found, doubts):
    """Note at each student which files with the student's id are held apart."""
    for student, others in doubts.items():
        found[student].notes.append(
            f"{some(others)}: may be this student's by its name and is held apart; if it is,"
            " move it to what is surely theirs, or give it the id alone as its name"
        )


def _tell_namesakes(found, namesakes):
    """Note at each student that several people of this name handed in."""
    for student in {owner.student for owner in namesakes if owner.known}:
        others = sorted(
            {f"{other.called} {other.number}" for other in namesakes if other.student == student}
        )
        found[student].notes.append(
            f"several people of this name handed in ({', '.join(others)}): give the right file the"
            " student's id as its name"
        )


def _tell_within(found):
    """Note at each student who handed in nothing whose folder or zip has files in that name."""
    named_by: dict[str, list[str]] = {}
    for other, mine in found.items():
        for student in mine.names:
            named_by.setdefault(student, []).append(other)
    for student, others in named_by.items():
        if not found[student].notebooks:
            found[student].notes.append(
                f"{some(others)}: has files in this student's name and is held apart, since it is"
                " another's; if they are this student's, move them out of it"
            )


def voters(found: Mapping[str, Submission]) -> dict[str, Submission]:
    """Those who decide what is true of the class, such as which lessons it was handed and whether
    the key is right: the students of the roster who handed in notebooks; where there are none,
    everybody who did.
    """
    handed_in = {student: mine for student, mine in found.items() if mine.notebooks}
    known = {student: mine for student, mine in handed_in.items() if mine.on_roster}
    return known or handed_in


def _take(mine, entry):
    """Add a file to a student's submission, or say why not."""
    name, read, fault = "/".join((*entry.outer, *entry.parts)), entry.read, entry.fault
    ending = os.path.splitext(name)[1].lower()
    name = _shown(name)
    if fault:
        mine.notes.append(f"{name}: {fault}")
    elif ending == ".ipynb" or (ending in NOTEBOOK_ENDINGS and _sniffed(mine, read)):
        taken = {one.name for one in mine.notebooks}
        # signs that are not shown make one name of two
        others = (f"{name} [{k}]" for k in count(2))
        name = name if name not in taken else next(one for one in others if one not in taken)
        mine.notebooks.append(Notebook(name, read, entry.when, entry.source, entry.size))
    else:
        mine.notes.append(f"{name}: no notebook, {PASSED_OVER}")


def _shown(name):
    """What a file is called in notes and marks: no longer than one reads."""
    told = printable(name.encode("utf-8", "replace").decode("utf-8"))
    half = LONGEST_NAME // 2
    return told if len(told) <= LONGEST_NAME else f"{told[:half]} … {told[-half:]}"


def _sniffed(mine, read):
    """Whether a file of another name is a notebook after all; a student's first ones are looked
    into.
    """
    mine.looked_into += 1
    if mine.looked_into > MOST_LOOKED_INTO:
        return False
    raw = read()
    return bool(LOOKS_LIKE_ONE.search(raw)) and raw.lstrip(b"\xef\xbb\xbf \t\r\n")[:1] == b"{"


def _settle(mine):
    """Oldest first; no more than anyone needs; what was passed over is only told when there is
    nothing else.
    """
    mine.notebooks.sort(
        key=lambda notebook: (
            notebook.when is not None,
            notebook.when and notebook.when.timestamp(),
            notebook.name,
        )
    )
    if len(mine.notebooks) > MOST_NOTEBOOKS:
        mine.notes.append(
            f"{len(mine.notebooks)} notebooks, of which the last {MOST_NOTEBOOKS} were taken"
        )
        mine.notebooks = mine.notebooks[-MOST_NOTEBOOKS:]
    while len(mine.notebooks) > 1 and sum(one.size for one in mine.notebooks) > LARGEST:
        mine.notes.append(
            f"{mine.notebooks.pop(0).name}: left out, all notebooks together are larger than"
            f" {LARGEST // 1_000_000} MB"
        )
    mine.refused = bool(mine.notes)
    if mine.notebooks:
        mine.notes = [note for note in mine.notes if not note.endswith(PASSED_OVER)]
    if len(mine.notes) > MOST_NOTES:
        more = len(mine.notes) - MOST_NOTES
        mine.notes[MOST_NOTES:] = [f"and {more} more files that were {PASSED_OVER}"]
