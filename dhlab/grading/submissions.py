"""Finds what was handed in: folders, zips, zips of zips, in any layout; nothing is unpacked onto the disk, and nothing special is opened."""

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

from .layouts import Names, student_of

__all__ = ["Submission", "submissions"]

LARGEST = 20_000_000  # bytes of a notebook
LARGEST_ZIP = 200_000_000
MOST_FILES = 20_000  # of a zip
MOST_NOTEBOOKS = 12  # of a student
DEEPEST = 2  # a zip of everybody's, and a student's own in it
NOTEBOOK_ENDINGS = (".ipynb", ".json", ".txt", "")
BROKEN = (zipfile.BadZipFile, zlib.error, lzma.LZMAError, OSError, ValueError, NotImplementedError, EOFError, RuntimeError)
LOOKS_LIKE_ONE = re.compile(rb'"(cells|worksheets)"\s*:')


@dataclass
class Submission:
    """What one student handed in: notebooks as (name, bytes when called, when), oldest first; and what was refused, in sentences."""

    student: str
    notebooks: list = field(default_factory=list)
    notes: list = field(default_factory=list)
    on_roster: bool = True


def submissions(place, roster=(), lessons=()):
    """Everything that was handed in, by student.

    Parameters
    ----------
    place : str or path
        A folder, or a zip.
    roster : sequence of Student
        Students without a submission are there too, with no notebooks.
    lessons : sequence of str
        The names of the lessons' files, without ending; they are no part of a student's name.

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
    for parts, read, when, fault in _unwrapped(_entries(place), names):
        student, known = student_of(parts, names, place.stem)
        mine = found.setdefault(student, Submission(student, on_roster=known or not roster))
        _take(mine, "/".join(parts), read, when, fault)
    for mine in found.values():
        _settle(mine)
    return {student: mine for student, mine in found.items() if mine.notebooks or mine.notes or student in {s.student for s in roster}}


def _take(mine, name, read, when, fault):
    """Add a file to a student's submission, or say why not."""
    ending = os.path.splitext(name)[1].lower()
    name = name.encode("utf-8", "replace").decode("utf-8")
    if fault:
        mine.notes.append(f"{name}: {fault}")
    elif ending == ".ipynb" or ending in NOTEBOOK_ENDINGS and _sniffed(read):
        mine.notebooks.append((name, read, when))
    else:
        mine.notes.append(f"{name}: no notebook, passed over")


def _sniffed(read):
    """Whether a file of another name is a notebook after all."""
    raw = read()
    return bool(LOOKS_LIKE_ONE.search(raw)) and raw.lstrip(b"\xef\xbb\xbf \t\r\n")[:1] == b"{"


def _settle(mine):
    """Oldest first; no more than anyone needs; what was passed over is only told when there is nothing else."""
    mine.notebooks.sort(key=lambda notebook: (notebook[2] is not None, notebook[2] and notebook[2].timestamp(), notebook[0]))
    if len(mine.notebooks) > MOST_NOTEBOOKS:
        mine.notes.append(f"{len(mine.notebooks)} notebooks, of which the last {MOST_NOTEBOOKS} were taken")
        mine.notebooks = mine.notebooks[-MOST_NOTEBOOKS:]
    if mine.notebooks:
        mine.notes = [note for note in mine.notes if not note.endswith("passed over")]


def _entries(place):
    """(parts, read, when, fault) of every file in a folder or a zip."""
    if place.is_dir():
        yield from _in_folder(place)
    elif zipfile.is_zipfile(place):
        yield from _in_zip(lambda: place, (), 1)
    else:
        raise ValueError(f"{place}: expected a folder or a zip of submissions, found {'a file that is neither' if place.exists() else 'no such folder'}; check the name")


def _in_folder(place):
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
                yield parts, None, when, "refused: a link, a pipe or a device, not a file"
            elif name.lower().endswith(".zip"):
                yield from _opened(partial(str, path), parts, when, 1)
            elif status.st_size > LARGEST:
                yield parts, None, when, f"refused: {status.st_size // 1_000_000} MB, at most {LARGEST // 1_000_000} are read"
            else:
                yield parts, _reader(path), when, ""


def _reader(path):
    def read():
        handle = os.open(path, os.O_RDONLY | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0))
        with os.fdopen(handle, "rb") as file:
            return file.read(LARGEST + 1)[:LARGEST]
    return read


def _opened(source, parts, when, depth):
    """The files of a zip that stands at ``parts``; of a broken one, what is wrong with it."""
    try:
        yield from _in_zip(source, parts, depth)
    except BROKEN as error:
        yield parts, None, when, f"refused: a zip that cannot be read ({str(error)[:100]})"


def _in_zip(source, parts, depth):
    """Members are read into memory when they are needed, each up to the limit; their names never name a file here.

    ``source()`` gives the zip anew, as a path or an open file, so that a thousand zips need not stay open.
    """
    with zipfile.ZipFile(source()) as archive:
        members = archive.infolist()
    if parts and (len(members) > MOST_FILES or sum(member.file_size for member in members) > LARGEST_ZIP):  # the teacher's own zip may be large
        raise ValueError("too many files in it, or too large when unpacked")
    for number, member in enumerate(members):
        inner = tuple(part for part in re.split(r"[/\\]", member.filename) if part)
        if member.is_dir() or not inner or any(_boring(part) for part in inner if part != ".."):
            continue
        fault, read = _fault(member, inner), _member(source, number)
        own, when = (*parts, *(part for part in inner if part != "..")), _when(member)
        if fault or not inner[-1].lower().endswith(".zip"):
            yield own, None if fault else read, when, fault
        elif depth < DEEPEST:
            yield from _opened(lambda read=read: io.BytesIO(read()), own, when, depth + 1)
        else:
            yield own, None, when, "refused: a zip in a zip in a zip"


def _member(source, number):
    """Reads one member; what cannot be read is empty, and an empty notebook is told to be unreadable."""
    def read():
        try:
            with zipfile.ZipFile(source()) as archive, archive.open(archive.infolist()[number]) as file:
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


def _when(member):
    """A zip knows the time of day but not the zone; taken as this machine's."""
    try:
        return datetime(*member.date_time).astimezone(timezone.utc)
    except (ValueError, OverflowError):
        return None


def _boring(name):
    return name.startswith(".") or name in ("__MACOSX", "__pycache__")


def _unwrapped(entries, names):
    """Without the one folder that everything stands in, where it is nobody's and holds folders or files of several."""
    entries = list(entries)
    while entries and all(len(parts) > 2 for parts, *_ in entries) and len({parts[0] for parts, *_ in entries}) == 1 and len({parts[1] for parts, *_ in entries}) > 1:
        outer = entries[0][0][0]
        if outer.lower().endswith(".zip") or student_of((outer,), names, "")[1]:
            break
        entries = [(parts[1:], *rest) for parts, *rest in entries]
    return entries
