"""Whose submission is which folder of Gradescope's export: its own list beside the folders says it,
and the folders are only numbered.
"""

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
    """The files, those of a numbered folder under the id of whom the list beside it names; of a
    group under each one's.

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
        folder, *rest = entry.parts
        owned = [
            # by a name alone it is only perhaps this student's: so is an id in a longer name
            entry._replace(
                parts=(student, *entry.parts) if sure else (f"{folder} {student}", *rest)
            )
            for student, sure in known.get((*entry.outer, folder), [])
        ]
        found += owned or [entry]
    return found


def _submitters(raw, names):
    """(id of a student of the roster, whether that is sure) by folder."""
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
    """One submission's submitters, as :func:`_person` gives them; a block that cannot be read names
    nobody.
    """
    try:
        listed = plainyaml.parse(text, LIST).plain() if len(text) < LARGEST else None
    except ValueError:
        return []
    people = [one for one in listed or [] if isinstance(one, dict)]
    return list(dict.fromkeys(filter(None, (_person(one, names) for one in people))))


def _person(told, names):
    """(id, whether that is sure), or None. A number goes before an address, and that before a name,
    which may be anybody's choice and is not sure.
    """
    sid, mail, name = (str(told.get(f":{key}") or "") for key in ("sid", "email", "name"))
    sure = (sid and names.find(sid)) or (mail and names.find(mail))
    found = sure or (name and names.by_name(name))
    return (found, bool(sure)) if found else None
