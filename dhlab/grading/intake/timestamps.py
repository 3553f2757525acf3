"""When a notebook came: as nbgrader noted it in a ``timestamp.txt``, and in words."""

from collections.abc import Sequence
from datetime import datetime, tzinfo
from zoneinfo import ZoneInfo

from .files import FILE_TIME, TIMESTAMP, Entry
from .layouts import Names
from .platforms import from_platform

__all__ = ["handed_in", "stamped"]


def stamped(entries: Sequence[Entry], zone: tzinfo, names: Names) -> list[Entry]:
    """The files, with the time that nbgrader noted in place of their own.

    nbgrader writes ``student/assignment/timestamp.txt`` for everybody, and its time is that of all
    that stands in or below this folder, since a student may set the time of a file. Elsewhere, in
    a zip, or where fewer than half of the class have one, such a file may be a student's own, and
    is passed over.

    Parameters
    ----------
    entries : sequence of Entry
    zone : tzinfo
        Of a time that names none.
    names : Names

    Returns
    -------
    list of Entry
        Without the files from which a time was taken.
    """
    in_folders = [entry for entry in entries if _in_a_folder(entry)]
    notes = [entry for entry in in_folders if _is_note(entry)]
    folders = {entry.parts[0] for entry in in_folders}
    of_class = {folder for folder in folders if names.whose(folder)[0]} or folders
    if 2 * len({entry.parts[0] for entry in notes} & of_class) < len(of_class):
        return list(entries)
    noted = {_folder(note): when for note in notes if (when := _moment(note.read(), zone))}
    return [
        entry._replace(when=noted[_folder(entry)], source=TIMESTAMP)
        if _folder(entry) in noted
        else entry
        for entry in entries
        if not (_is_note(entry) and _folder(entry) in noted)
    ]


def _in_a_folder(entry):
    """Whether a file stands in a plain folder, none of a zip or of a learning platform."""
    return (
        len(entry.parts) > 1
        and entry.source == FILE_TIME
        and not any(part.lower().endswith(".zip") for part in (*entry.outer, *entry.parts))
        and not entry.fault
        and not from_platform(entry.parts[0])
    )


def _is_note(entry):
    return len(entry.parts) == 3 and entry.parts[-1] == TIMESTAMP


def _folder(entry):
    """The folder ``student/assignment`` that a file stands in or below."""
    return (*entry.outer, *entry.parts[:2])


def _moment(raw, zone):
    """The moment in a file such as ``2026-11-17 10:03:12.345 UTC``; None when it cannot be read."""
    day, _, rest = raw.decode("utf-8", "replace").strip().partition(" ")
    clock, _, name = rest.partition(" ")
    try:
        moment = datetime.fromisoformat(f"{day} {clock}".strip())
        return moment if moment.tzinfo else moment.replace(tzinfo=ZoneInfo(name) if name else zone)
    except (ValueError, KeyError, OSError):
        return None


def handed_in(when: datetime | None, source: str, zone: tzinfo) -> str:
    """When a file came, in words: in the course's time zone, and how it is known; empty when it is
    not.
    """
    return f"{when.astimezone(zone):%Y-%m-%d %H:%M}, {source}" if when else ""
