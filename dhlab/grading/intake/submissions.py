"""What was handed in, by student, in any layout of folders and zips."""

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime, tzinfo
from functools import cached_property
from itertools import count
from pathlib import Path
from zoneinfo import ZoneInfo

from ..shown import printable
from .files import FILE_TIME, LARGEST, TIMESTAMP, Read, files_in
from .layouts import Names, from_platform, student_of
from .notebooks import Look, look
from .roster import Student

__all__ = ["Notebook", "Submission", "submissions", "PASSED_OVER"]

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
    or cannot be read.
    """

    student: str
    notebooks: list[Notebook] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    on_roster: bool = True
    loose: bool = True
    refused: bool = False
    numbers_of: str | None = None
    looked_into: int = 0


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

    def whose(parts):
        owner = student_of(parts, names, place.stem)
        return owner.student if owner.known else "/".join(parts)

    entries = _stamped(_unwrapped(files_in(place, zone, whose), names), zone)
    owners = [student_of(entry.parts, names, place.stem) for entry in entries]
    namesakes = _namesakes(owners)
    claimed = {owner.student for owner in owners if owner.known and owner.sure}
    doubts: dict[str, list[str]] = {}
    for entry, owner in zip(entries, owners):
        student, known = owner.student, owner.known
        if owner in namesakes:
            student, known = f"{owner.called} {owner.number}", False
        elif not owner.sure and student in claimed:
            # somebody else's file may be called so: it takes nothing away from who is sure
            student, known = f"{printable(entry.parts[0])[:80]}, perhaps {student}", False
            doubts.setdefault(owner.student, []).append(student)
        mine = found.setdefault(student, Submission(student, on_roster=known or not roster))
        mine.loose &= len(entry.parts) == 1
        _take(mine, entry)
    for mine in found.values():
        _settle(mine)
    for student, others in doubts.items():
        found[student].notes.append(
            f"{' and '.join(dict.fromkeys(others))}: has this id in its name and is held apart; if"
            " it is this student's, give it the id alone as its name"
        )
    for student in {owner.student for owner in namesakes if owner.known}:
        others = sorted(
            {f"{other.called} {other.number}" for other in namesakes if other.student == student}
        )
        found[student].notes.append(
            f"several people of this name handed in ({', '.join(others)}): give the right file the"
            " student's id as its name"
        )
    return {
        student: mine
        for student, mine in found.items()
        if mine.notebooks or mine.notes or student in {s.student for s in roster}
    }


def _namesakes(owners):
    """The owners of a name that a platform has given to several of its own numbers at one place:
    they are several people.
    """
    numbers: dict[tuple[str, tuple[str, ...]], set[str]] = {}
    for owner in owners:
        if owner.number:
            numbers.setdefault((owner.student, owner.place), set()).add(owner.number)
    several = {student for (student, _), found in numbers.items() if len(found) > 1}
    return {owner for owner in owners if owner.number and owner.student in several}


def _stamped(entries, zone):
    """The files with the time that nbgrader noted beside them, in student/assignment/, for
    everybody; such a file elsewhere, in a zip, or that few have, may be a student's own.
    """
    entries = list(entries)
    in_folders = [
        entry
        for entry in entries
        if len(entry.parts) > 1
        and entry.source == FILE_TIME
        and not any(part.lower().endswith(".zip") for part in entry.parts)
        and not entry.fault
        and not from_platform(entry.parts[0])
    ]
    written = [
        entry for entry in in_folders if len(entry.parts) == 3 and entry.parts[-1] == TIMESTAMP
    ]
    having, students = ({entry.parts[0] for entry in some} for some in (written, in_folders))
    if 2 * len(having) < len(students):
        return entries
    noted = {entry.parts[:-1]: when for entry in written if (when := _noted(entry.read(), zone))}
    return [
        (
            entry._replace(when=noted[entry.parts[:-1]], source=TIMESTAMP)
            if entry.parts[:-1] in noted
            else entry
        )
        for entry in entries
        if not (entry.parts[-1] == TIMESTAMP and entry.parts[:-1] in noted)
    ]


def _noted(raw, zone):
    """The moment in an nbgrader timestamp.txt, such as ``2026-11-17 10:03:12.345 UTC``; None when
    it cannot be read.
    """
    day, _, rest = raw.decode("utf-8", "replace").strip().partition(" ")
    clock, _, name = rest.partition(" ")
    try:
        moment = datetime.fromisoformat(f"{day} {clock}".strip())
        return moment if moment.tzinfo else moment.replace(tzinfo=ZoneInfo(name) if name else zone)
    except (ValueError, KeyError, OSError):
        return None


def _take(mine, entry):
    """Add a file to a student's submission, or say why not."""
    name, read, fault = "/".join(entry.parts), entry.read, entry.fault
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


def _unwrapped(entries, names):
    """Without the one folder that everything stands in, where it is nobody's and holds folders or
    files of several.
    """
    entries = list(entries)
    while (
        entries
        and all(len(entry.parts) > 2 for entry in entries)
        and len({entry.parts[0] for entry in entries}) == 1
        and len({entry.parts[1] for entry in entries}) > 1
    ):
        outer = entries[0].parts[0]
        if outer.lower().endswith(".zip") or student_of((outer,), names, "").known:
            break
        entries = [entry._replace(parts=entry.parts[1:]) for entry in entries]
    return entries
