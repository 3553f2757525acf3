"""Which folders hold the work of several people: a download of the whole class, a folder for each
lesson. Within any other one all is the writing of the one person whom the platform made it for.
"""

import re
from collections.abc import Iterable, Sequence
from datetime import tzinfo
from pathlib import Path

from .files import BROKEN, Entry, files_in, only_zip
from .layouts import Names, from_platform, named_in
from .metadata import with_submitters

__all__ = ["entries_in", "prefixes"]

# what a teacher calls a folder; a platform's has more in its name, which its owner may have chosen
TEACHERS = re.compile(
    r"(late|resubmissions?|submissions|submitted|hand(ed)?[ _-]?in|class|section|lessons?|weeks?"
    r"|units?|assignments?|homeworks?|hw|exercises?|problem[ _-]?set|ps|sheets?|labs?|abgaben?"
    r"|übung(en)?|blatt|aufgaben?|woche|lektion|devoirs?|leçon|semaine|tareas?|semana|作业|迟交)"
    r"[ _-]?(\d{1,2}|[a-z])?",
    re.IGNORECASE,
)


def entries_in(place: Path, zone: tzinfo, names: Names) -> list[Entry]:
    """Every file of a folder or a zip, with ``parts`` from its owner's folder or file on.

    One zip that stands alone in a folder, and holds files of several of the class, is a platform's
    whole download, and is read as if it had been given itself.

    Parameters
    ----------
    place : path
    zone : tzinfo
        Of the times in a zip.
    names : Names

    Returns
    -------
    list of Entry
    """

    def whose(parts):
        """Where a zip counts: a student's own all together, each of a stranger's by itself."""
        known = [names.whose(part) for part in parts]
        k = next((k for k, (student, sure) in enumerate(known) if student and sure), None)
        return "/".join(parts if k is None else (*parts[:k], str(known[k][0])))

    entries = _of_download(place, zone, names, whose)
    entries = list(files_in(place, zone, whose)) if entries is None else entries
    several = _of_several([entry.parts for entry in entries], names)
    split = [_depth(entry.parts, several) for entry in entries]
    # what all stand in is not told
    around = [entry.parts[:k] for entry, k in zip(entries, split) if len(entry.parts) > 1]
    shared = _alike(around) if around else 0
    placed = (
        entry._replace(parts=entry.parts[k:], outer=entry.parts[min(shared, k) : k])
        for entry, k in zip(entries, split)
    )
    return with_submitters(placed, names)


def _of_download(place, zone, names, whose):
    """The files of the one zip in a folder, where it is a whole class's; None."""
    path = only_zip(place)
    if path is None or names.whose(path.name)[0] or from_platform(path.name):
        return None
    try:
        entries = list(files_in(path, zone, whose))
    except BROKEN:
        return None
    return entries if len(_named([entry.parts for entry in entries], names)) > 1 else None


def _depth(parts, several):
    """How many folders of several people are around a file."""
    k = 0
    while k + 1 < len(parts) and parts[: k + 1] in several:
        k += 1
    return k


def _named(paths, names):
    """The students whom paths name."""
    return {named_in(path, names) for path in paths} - {""}


def _of_several(paths: Sequence[tuple[str, ...]], names: Names) -> set[tuple[str, ...]]:
    """The places of folders, and zips, that hold the work of several people."""
    found: set[tuple[str, ...]] = set()
    todo: list[tuple[tuple[str, ...], Sequence[tuple[str, ...]]]] = [((), paths)]
    while todo:
        place, here = todo.pop()
        below: dict[str, list[tuple[str, ...]]] = {}
        for path in here:
            below.setdefault(path[0], []).append(path[1:])
        for part in _at_one_level(below, names):
            found.add((*place, part))
            todo.append(((*place, part), [path for path in below[part] if path]))
    return found


def _at_one_level(below, names):
    """Which of the things that stand side by side hold several people's work; ``below``: for each
    the paths in it.
    """
    inside = [part for part, paths in below.items() if any(paths) and not from_platform(part)]
    called = {
        part
        for part in inside
        if not _is_zip(part) and _is_teachers(part, names) and not names.whose(part)[1]
    }
    nobodys = [part for part in inside if not names.whose(part)[0]]
    beside = [
        part
        for part, paths in below.items()
        if part not in called and (any(paths) or part.lower().endswith(".ipynb"))
    ]
    folders = [part for part in beside if any(below[part])]
    several = {part for part in folders if part in nobodys and len(_named(below[part], names)) > 1}
    # beside somebody's own thing, or among many of nobody's, a thing is one person's as well
    if any(names.whose(part)[0] for part in beside) or 2 * len(several) < len(folders):
        several = set()
    elif len(several) < len(beside):  # a zip is called by its owner
        several = {part for part in several if not _is_zip(part)}
    # "Practical 2" beside "Practical 1", whoever is in it so far
    likewise = set(map(_without_number, several))
    several |= {part for part in folders if part in nobodys and _without_number(part) in likewise}
    alone = len(beside) == 1 and beside[0] in nobodys and not called
    if alone and _is_only_around(beside[0], below[beside[0]], names):
        several = {beside[0]}
    return called | several


def _without_number(part):
    return re.sub(r"\d+", "#", part)


def _is_zip(part):
    return part.lower().endswith(".zip")


def _is_teachers(part, names):
    lessons = names.lessons
    return bool(TEACHERS.fullmatch(part)) or any(re.fullmatch(one, part) for one in lessons)


def _is_only_around(part, paths, names):
    """Whether a folder that stands alone is around folders of several: two of which name somebody
    of the class, or two of nobody's.
    """
    naming = {path[0] for path in paths if path and names.whose(path[0])[0]}
    folders = {path[0] for path in paths if len(path) > 1}
    loose = any(len(path) == 1 and path[0].lower().endswith(".ipynb") for path in paths)
    return not _is_zip(part) and (
        len(naming) > 1 or (not naming and not loose and len(folders) > 1)
    )


def prefixes(entries: Iterable[Entry], names: Names) -> dict[tuple[str, ...], str]:
    """What the names that stand side by side begin with, as that of an assignment, where somebody
    of the class is called by what is left: by the folders around them.
    """
    beside: dict[tuple[str, ...], set[str]] = {}
    for entry in entries:
        if len(entry.parts) > 1 or entry.parts[0].lower().endswith(".ipynb"):
            beside.setdefault(entry.outer, set()).add(entry.parts[0])
    shared = {outer: _shared(parts) for outer, parts in beside.items() if len(parts) > 1}
    return {
        outer: begin
        for outer, begin in shared.items()
        if any(names.whose(part, begin)[1] > names.whose(part)[1] for part in beside[outer])
    }


def _shared(parts):
    """As far as a sign that ends a word."""
    begin = re.match(r".*[-_ ]", min(parts)[: _alike(parts)])
    return begin[0] if begin else ""


def _alike(sequences):
    """How far all begin alike: as far as the first and the last in their order."""
    first, last = min(sequences), max(sequences)
    pairs = enumerate(zip(first, last))
    return next((k for k, (one, other) in pairs if one != other), min(len(first), len(last)))
