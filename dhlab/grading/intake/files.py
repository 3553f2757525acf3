"""Every file in a folder or a zip, zips in zips included; nothing is unpacked onto the disk, and
nothing special is opened.
"""

import io
import os
import re
import stat
import zipfile
from collections import Counter
from collections.abc import Callable, Iterator
from datetime import UTC, datetime, tzinfo
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

__all__ = ["BROKEN", "Entry", "FILE_TIME", "Read", "TIMESTAMP", "files_in", "only_zip"]

Read = Callable[[], bytes]

LARGEST = 80_000_000  # bytes of a notebook; its pictures are thrown away before it runs
LARGEST_ZIP = 200_000_000
MOST_FILES = 500  # of all zips of a student
MOST_ZIPS = 5  # in a student's zip
DEEPEST = 2  # a zip of everybody's, and a student's own in it
LISTING = 1_000_000  # bytes of the list of members in a student's zip
LONGEST = 255  # letters of a name, as on a disk; a zip may have others
FOLDERS = 40  # in folders
# whatever Python raises at a zip that a stranger made: it costs nobody else anything
BROKEN = Exception
LATEST = 7_258_118_400  # seconds, the year 2200: a file may claim times that no calendar has
TOO_DEEP = "refused: too many folders in folders"
CLOSED = "refused: a folder that cannot be looked into; are its permissions right?"
# where the time of a submission comes from
FILE_TIME, ZIP, TIMESTAMP = "file time", "zip", "timestamp.txt"


class Entry(NamedTuple):
    """A file: where it stands, its bytes when ``read`` is called, when it came, how that is known,
    what is wrong with it, how many bytes it has; and the folders of several people around it, which
    are no part of where it stands.
    """

    parts: tuple[str, ...]
    read: Read
    when: datetime | None
    source: str
    fault: str
    size: int = 0
    outer: tuple[str, ...] = ()


class _Room:
    """How much of each student's zips is looked at, whatever number of zips it comes in."""

    def __init__(self, whose: Callable[[tuple[str, ...]], str]) -> None:
        self.whose = whose
        self.files: Counter[str] = Counter()
        self.bytes: Counter[str] = Counter()

    def take(self, parts, members):
        """Count the members of a student's zip; ValueError when there are too many."""
        whose = self.whose(parts)
        self.files[whose] += len(members)
        self.bytes[whose] += sum(member.file_size for member in members)
        if self.files[whose] > MOST_FILES or self.bytes[whose] > LARGEST_ZIP:
            raise ValueError("too many files in it, or too large when unpacked")


def files_in(
    place: Path, zone: tzinfo, whose: Callable[[tuple[str, ...]], str] = "/".join
) -> Iterator[Entry]:
    """Every file in a folder or a zip.

    ``whose`` names the owner of a zip that stands at some place: all zips of one owner together
    have one budget of files and bytes.
    """
    room = _Room(whose)
    if place.is_dir():
        yield from _in_folder(place, zone, room)
    elif zipfile.is_zipfile(place):
        yield from _in_zip(lambda: place, (), 1, zone, None, room)
    else:
        raise ValueError(
            f"{place}: expected a folder or a zip of submissions, found"
            f" {'a file that is neither' if place.exists() else 'no such folder'}; check the name"
        )


def only_zip(place: Path) -> Path | None:
    """The zip that is all there is in a folder; None."""
    try:
        inside = [path for path in place.iterdir() if not _boring(path.name)]
        alone = len(inside) == 1 and inside[0].is_file() and not inside[0].is_symlink()
    except OSError:
        return None
    return inside[0] if alone and zipfile.is_zipfile(inside[0]) else None


def _in_folder(place, zone, room):
    closed: list[OSError] = []
    for folder, folders, files in os.walk(place, onerror=closed.append):
        folders[:] = sorted(name for name in folders if not _boring(name))
        for name in (*folders, *sorted(files)):
            path = os.path.join(folder, name)
            parts = Path(path).relative_to(place).parts
            try:
                status = os.lstat(path)
            except FileNotFoundError:  # it went away meanwhile
                continue
            except OSError:  # its name is longer than any may be
                status = None
            if status is None or len(parts) > FOLDERS:
                folders[:] = []
                yield Entry((*parts[:2], name), _nothing, None, FILE_TIME, TOO_DEEP)
                break
            if stat.S_ISDIR(status.st_mode) or _boring(name):
                continue
            when = datetime.fromtimestamp(min(max(status.st_mtime, 0), LATEST), UTC)
            if not stat.S_ISREG(status.st_mode):
                refused = "refused: a link, a pipe or a device, not a file"
                yield Entry(parts, _nothing, when, FILE_TIME, refused)
            elif name.lower().endswith(".zip"):
                opened = partial(_no_link, str(place), parts)
                yield from _opened(opened, parts, (when, FILE_TIME), 1, zone, room)
            elif status.st_size > LARGEST:
                size, most = status.st_size // 1_000_000, LARGEST // 1_000_000
                refused = f"refused: {size} MB, at most {most} are read"
                yield Entry(parts, _nothing, when, FILE_TIME, refused)
            else:
                yield Entry(parts, _reader(place, parts), when, FILE_TIME, "", status.st_size)
    for error in closed:
        parts = Path(error.filename).relative_to(place).parts
        if parts and not isinstance(error, FileNotFoundError):
            yield Entry(parts, _nothing, None, FILE_TIME, CLOSED)


def _nothing():
    """What is read of a file that is refused."""
    return b""


def _reader(place, parts):
    def read():
        try:
            with _no_link(str(place), parts) as file:
                return file.read(LARGEST + 1)[:LARGEST]
        except OSError:
            return b""

    return read


def _no_link(place, parts):
    """A file below a folder, opened to be read: no link leads there, also where a folder has become
    one since it was looked at.
    """
    link = getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    if os.open not in os.supports_dir_fd:
        return io.FileIO(os.open(os.path.join(place, *parts), os.O_RDONLY | link))
    *folders, name = parts
    steps = [*((folder, link | os.O_DIRECTORY) for folder in folders), (name, link)]
    here = os.open(place, os.O_RDONLY | os.O_DIRECTORY)
    for part, rest in steps:
        folder = here
        try:
            here = os.open(part, os.O_RDONLY | rest, dir_fd=folder)
        finally:
            os.close(folder)
    return io.FileIO(here)


def _opened(source, parts, when, depth, zone, room):
    """The files of a zip that stands at ``parts``; of a broken one, what is wrong with it."""
    try:
        yield from _in_zip(source, parts, depth, zone, when, room)
    except BROKEN as error:
        refused = f"refused: a zip that cannot be read ({str(error)[:100]})"
        yield Entry(parts, _nothing, when[0], when[1], refused)


def _in_zip(source, parts, depth, zone, came, room):
    """Members are read into memory when they are needed, each up to the limit; their names never
    name a file here.

    ``source()`` gives the zip anew, as a path or an open file, so that a thousand zips need not
    stay open. ``came``: when a student's own zip came, and how that is known; the dates in it are
    the student's.
    """
    members = _archive(source, LISTING if parts else None).infolist()
    if parts:  # the teacher's own zip may be large
        room.take(parts, members)
    zips = 0
    for number, member in enumerate(members):
        inner = tuple(part for part in re.split(r"[/\\]", member.filename) if part)
        if member.is_dir() or not inner or any(_boring(part) for part in inner if part != ".."):
            continue
        fault, read = _fault(member, inner), _member(source, number)
        own = (*parts, *(part[:LONGEST] for part in inner[-FOLDERS:] if part != ".."))
        when = came or (_when(member, zone), ZIP)
        if fault or not inner[-1].lower().endswith(".zip"):
            yield Entry(own, _nothing if fault else read, when[0], when[1], fault, member.file_size)
        elif depth < DEEPEST and (not parts or (zips := zips + 1) <= MOST_ZIPS):
            unpacked = partial(_unpacked, read)
            yield from _opened(unpacked, own, when, depth + 1, zone, room)
        else:
            refused = "refused: a zip in a zip in a zip, or too many of them"
            yield Entry(own, _nothing, when[0], when[1], refused)


def _unpacked(read):
    return io.BytesIO(read())


def _member(source, number):
    """Reads one member; what cannot be read is empty, and an empty notebook is told to be
    unreadable.
    """

    def read():
        try:
            archive = _archive(source)
            with archive.open(archive.infolist()[number]) as file:
                return file.read(LARGEST + 1)[:LARGEST]
        except BROKEN:
            return b""

    return read


class _Short(io.BufferedReader):
    """A file of which no more than ``most`` bytes are read at once, where that is a number."""

    most: int | None = None

    def read(self, size: int | None = -1, /) -> bytes:
        if self.most is not None and (size or 0) > self.most:
            raise ValueError("too many files in it, or too large when unpacked")
        return super().read(size)


# the zips that were read from last stay open: members are asked for one after the other
_open: dict[Any, tuple[zipfile.ZipFile, _Short]] = {}
AT_ONCE = 3


def _archive(source, listing=None):
    """The zip; its list of members is read at once, and no longer than ``listing`` bytes."""
    if source not in _open:
        while len(_open) >= AT_ONCE:
            for one in _open.pop(next(iter(_open))):
                one.close()
        place = source()
        file = _Short(io.FileIO(place) if isinstance(place, (str, Path)) else place)
        file.most = listing
        try:
            _open[source] = zipfile.ZipFile(file), file
        except BROKEN:
            file.close()
            raise
        file.most = None
    return _open[source][0]


def _fault(member, inner):
    if ".." in inner or member.filename.startswith(("/", "\\")):
        return "refused: its name leads out of the zip"
    if len(inner) > FOLDERS or max(map(len, inner)) > LONGEST:
        return "refused: a name, or folders in folders, that no disk holds"
    if stat.S_ISLNK(member.external_attr >> 16):
        return "refused: a link"
    if member.flag_bits & 1:
        return "refused: it is encrypted"
    return "refused: too large" if member.file_size > LARGEST else ""


def _when(member, zone):
    """A zip knows the time of day but not the zone."""
    try:
        year, month, day, hour, minute, second = member.date_time
        moment = datetime(year, month, day, hour, minute, second, tzinfo=zone)
        return moment.astimezone(UTC)
    except (ValueError, OverflowError):
        return None


def _boring(name):
    return name.startswith(".") or name in ("__MACOSX", "__pycache__")
