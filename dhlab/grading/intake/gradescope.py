"""Gradescope's export: its folders are only numbered, and a list beside them says whose each is."""

import re
from collections.abc import Iterable

from ...formats import plainyaml
from .files import Entry
from .layouts import Names

__all__ = ["with_submitters"]

LIST = "submission_metadata.yml"
BEGIN = re.compile(r"(submission_\d+):\s*$")
KEY = re.compile(r"  :(\w+):")  # of a submission; what a student's program printed stands deeper
LARGEST = 100_000  # letters about the submitters of one submission


def with_submitters(entries: Iterable[Entry], names: Names) -> list[Entry]:
    """The files, with the id of its owner before each that stands in a numbered folder which the
    list beside it knows; what a group handed in is there once for each member.

    Parameters
    ----------
    entries : iterable of Entry
        With ``parts`` from the numbered folder on.
    names : Names

    Returns
    -------
    list of Entry
    """
    entries = list(entries)
    known = {
        (*entry.outer, folder): students
        for entry in entries
        if entry.parts == (LIST,)
        for folder, students in _submitters(entry.read(), names).items()
    }
    found = []
    for entry in entries:
        submitters = known.get((*entry.outer, entry.parts[0]), [])
        found += [_of(entry, *submitter) for submitter in submitters] or [entry]
    return found


def _of(entry, student, sure):
    """A file as that of a student. Where that is not sure, the id is only a part of the folder's
    name, and is doubted like every id in a longer name.
    """
    folder, *rest = entry.parts
    return entry._replace(parts=(student, *entry.parts) if sure else (f"{folder} {student}", *rest))


def _submitters(raw, names):
    """For each folder that the list names, its submitters as :func:`_person` gives them."""
    blocks: dict[str, list[str]] = {}
    block, key = None, ""
    for line in raw.decode("utf-8", "replace").split("\n"):
        if begin := BEGIN.match(line):
            block, key = blocks.setdefault(begin[1], []), ""
        elif other := KEY.match(line):
            key = other[1]
        elif block is not None and key == "submitters":
            block.append(line)
    found = {folder: _of_block("\n".join(lines), names) for folder, lines in blocks.items()}
    return {folder: students for folder, students in found.items() if students}


def _of_block(text, names):
    """The submitters in the YAML of one submission, as :func:`_person` gives them; none when it
    cannot be read.
    """
    try:
        listed = plainyaml.parse(text, LIST).plain() if len(text) < LARGEST else None
    except ValueError:
        return []
    people = [one for one in listed or [] if isinstance(one, dict)]
    return list(dict.fromkeys(filter(None, (_person(one, names) for one in people))))


def _person(told, names):
    """(id of one submitter, whether that is sure); None when not on the roster. The student's
    number is looked for first, then the address. A name is looked for last and is never sure, since
    anybody may choose it; what stands in the place of the number may be chosen too, and is no name.
    """
    sid, mail, name = (str(told.get(f":{key}") or "") for key in ("sid", "email", "name"))
    sure = names.by_id(sid) or names.by_id(mail) or names.by_address(mail)
    found = sure or (name and names.by_name(name))
    return (found, bool(sure)) if found else None
