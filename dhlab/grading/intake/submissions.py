"""Finds what was handed in: folders, zips, zips of zips, in any layout; nothing is unpacked onto
the disk, and nothing special is opened.
"""

import io
import lzma
import os
import re
import stat
import zipfile
import zlib
from dataclasses import dataclass, field
from datetime import datetime, timezone
from functools import partial
from pathlib import Path
from typing import NamedTuple
from zoneinfo import ZoneInfo

from .layouts import Names, from_platform, student_of

__all__ = ["Notebook", "Submission", "submissions", "FILE_TIME", "PASSED_OVER"]

LARGEST = 20_000_000  # bytes of a notebook
PASSED_OVER = "passed over"
LARGEST_ZIP = 200_000_000
MOST_FILES = 20_000  # of a zip
MOST_NOTEBOOKS = 12  # of a student
DEEPEST = 2  # a zip of everybody's, and a student's own in it
NOTEBOOK_ENDINGS = (".ipynb", ".json", ".txt", "")
BROKEN = (
    zipfile.BadZipFile,
    zlib.error,
    lzma.LZMAError,
    OSError,
    ValueError,
    NotImplementedError,
    EOFError,
    RuntimeError,
)
# where the time of a submission comes from
FILE_TIME, ZIP, TIMESTAMP = "file time", "zip", "timestamp.txt"
LOOKS_LIKE_ONE = re.compile(rb'"(cells|worksheets)"\s*:')


class Notebook(NamedTuple):
    """One notebook: its name in what was handed in, its bytes when ``read`` is called, when it came
    and how that is known.
    """

    name: str
    read: object
    when: datetime | None
    source: str


@dataclass
class Submission:
    """What one student handed in: notebooks, oldest first; what was refused, in sentences; whose
    numbers they draw, if another's.

    ``loose``: nothing but files of no folder; ``refused``: something was there that is no notebook
    or cannot be read.
    """

    student: str
    notebooks: list = field(default_factory=list)
    notes: list = field(default_factory=list)
    on_roster: bool = True
    loose: bool = True
    refused: bool = False
    numbers_of: str | None = None


def submissions(place, roster=(), lessons=(), zone=timezone.utc):
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
    entries = _stamped(_unwrapped(_entries(place, zone), names), zone)
    owners = [student_of(entry.parts, names, place.stem) for entry in entries]
    namesakes = _namesakes(owners)
    for entry, owner in zip(entries, owners):
        student, known = owner.student, owner.known
        if owner in namesakes:
            student, known = f"{owner.called} {owner.number}", False
        mine = found.setdefault(student, Submission(student, on_roster=known or not roster))
        mine.loose &= len(entry.parts) == 1
        _take(mine, entry)
    for mine in found.values():
        _settle(mine)
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


class _Entry(NamedTuple):
    """A file: where it stands, its bytes when ``read`` is called, when it came, how that is known,
    and what is wrong with it.
    """

    parts: tuple
    read: object
    when: datetime | None
    source: str
    fault: str


def _namesakes(owners):
    """The owners of a name that a platform has given to several of its own numbers at one place:
    they are several people.
    """
    numbers = {}
    for owner in owners:
        if owner.number:
            numbers.setdefault((owner.student, owner.place), set()).add(owner.number)
    several = {student for (student, _), found in numbers.items() if len(found) > 1}
    return {owner for owner in owners if owner.number and owner.student in several}


def _stamped(entries, zone):
    """The files with the time that nbgrader noted beside them, in student/assignment/; such a file
    elsewhere, or in a zip, may be a student's own.
    """
    entries = list(entries)
    written = [
        entry
        for entry in entries
        if len(entry.parts) == 3
        and entry.parts[-1] == TIMESTAMP
        and entry.source == FILE_TIME
        and not entry.fault
        and not from_platform(entry.parts[0])
    ]
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
    name = name.encode("utf-8", "replace").decode("utf-8")
    if fault:
        mine.notes.append(f"{name}: {fault}")
    elif ending == ".ipynb" or ending in NOTEBOOK_ENDINGS and _sniffed(read):
        mine.notebooks.append(Notebook(name, read, entry.when, entry.source))
    else:
        mine.notes.append(f"{name}: no notebook, {PASSED_OVER}")


def _sniffed(read):
    """Whether a file of another name is a notebook after all."""
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
    mine.refused = bool(mine.notes)
    if mine.notebooks:
        mine.notes = [note for note in mine.notes if not note.endswith(PASSED_OVER)]


def _entries(place, zone):
    """Every file in a folder or a zip."""
    if place.is_dir():
        yield from _in_folder(place, zone)
    elif zipfile.is_zipfile(place):
        yield from _in_zip(lambda: place, (), 1, zone)
    else:
        raise ValueError(
            f"{place}: expected a folder or a zip of submissions, found"
            f" {'a file that is neither' if place.exists() else 'no such folder'}; check the name"
        )


def _in_folder(place, zone):
    for folder, folders, files in os.walk(place):
        folders[:] = sorted(name for name in folders if not _boring(name))
        for name in (*folders, *sorted(files)):
            path = os.path.join(folder, name)
            status = os.lstat(path)
            parts = Path(path).relative_to(place).parts
            if stat.S_ISDIR(status.st_mode) or _boring(name):
                continue
            when = datetime.fromtimestamp(status.st_mtime, timezone.utc)
            if not stat.S_ISREG(status.st_mode):
                yield _Entry(
                    parts, None, when, FILE_TIME, "refused: a link, a pipe or a device, not a file"
                )
            elif name.lower().endswith(".zip"):
                yield from _opened(partial(str, path), parts, when, 1, zone)
            elif status.st_size > LARGEST:
                yield _Entry(
                    parts,
                    None,
                    when,
                    FILE_TIME,
                    f"refused: {status.st_size // 1_000_000} MB, at most {LARGEST // 1_000_000} are"
                    " read",
                )
            else:
                yield _Entry(parts, _reader(path), when, FILE_TIME, "")


def _reader(path):
    def read():
        handle = os.open(
            path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
        )
        with os.fdopen(handle, "rb") as file:
            return file.read(LARGEST + 1)[:LARGEST]

    return read


def _opened(source, parts, when, depth, zone):
    """The files of a zip that stands at ``parts``; of a broken one, what is wrong with it."""
    try:
        yield from _in_zip(source, parts, depth, zone)
    except BROKEN as error:
        yield _Entry(
            parts, None, when, FILE_TIME, f"refused: a zip that cannot be read ({str(error)[:100]})"
        )


def _in_zip(source, parts, depth, zone):
    """Members are read into memory when they are needed, each up to the limit; their names never
    name a file here.

    ``source()`` gives the zip anew, as a path or an open file, so that a thousand zips need not
    stay open.
    """
    with zipfile.ZipFile(source()) as archive:
        members = archive.infolist()
    if parts and (
        len(members) > MOST_FILES or sum(member.file_size for member in members) > LARGEST_ZIP
    ):
        # the teacher's own zip may be large
        raise ValueError("too many files in it, or too large when unpacked")
    for number, member in enumerate(members):
        inner = tuple(part for part in re.split(r"[/\\]", member.filename) if part)
        if member.is_dir() or not inner or any(_boring(part) for part in inner if part != ".."):
            continue
        fault, read = _fault(member, inner), _member(source, number)
        own, when = (*parts, *(part for part in inner if part != "..")), _when(member, zone)
        if fault or not inner[-1].lower().endswith(".zip"):
            yield _Entry(own, None if fault else read, when, ZIP, fault)
        elif depth < DEEPEST:
            yield from _opened(lambda read=read: io.BytesIO(read()), own, when, depth + 1, zone)
        else:
            yield _Entry(own, None, when, ZIP, "refused: a zip in a zip in a zip")


def _member(source, number):
    """Reads one member; what cannot be read is empty, and an empty notebook is told to be
    unreadable.
    """

    def read():
        try:
            with (
                zipfile.ZipFile(source()) as archive,
                archive.open(archive.infolist()[number]) as file,
            ):
                return file.read(LARGEST + 1)[:LARGEST]
        except BROKEN:
            return b""

    return read


def _fault(member, inner):
    if ".." in inner or member.filename.startswith(("/", "\\")):
        return "refused: its name leads out of the zip"
    if stat.S_ISLNK(member.external_attr >> 16):
        return "refused: a link"
    if member.flag_bits & 1:
        return "refused: it is encrypted"
    return "refused: too large" if member.file_size > LARGEST else ""


def _when(member, zone):
    """A zip knows the time of day but not the zone."""
    try:
        return datetime(*member.date_time, tzinfo=zone).astimezone(timezone.utc)
    except (ValueError, OverflowError):
        return None


def _boring(name):
    return name.startswith(".") or name in ("__MACOSX", "__pycache__")


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
