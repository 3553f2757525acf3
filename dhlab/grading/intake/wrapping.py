"""Which folders hold the work of several people: a download of the whole class, a folder for each
lesson. Within any other one all is the writing of the one person whom the platform made it for.
"""

import re
import unicodedata
from collections.abc import Iterable, Sequence
from datetime import tzinfo
from pathlib import Path

from .files import BROKEN, Entry, files_in, only_zip
from .gradescope import with_submitters
from .layouts import Names, named_in
from .platforms import from_platform

__all__ = ["entries_in", "prefixes"]

# what teachers call a folder of several people's work, a number or a letter after it
TEACHERS = re.compile(
    r"""
    ( late | resubmissions? | submissions | submitted | hand(ed)?[ _-]?in
    | class | section | lessons? | weeks? | units? | labs?
    | assignments? | homeworks? | hw | exercises? | problem[ _-]?set | ps | sheets?
    | abgaben? | übung(en)? | aufgaben? | blatt | woche | lektion
    | devoirs? | leçon | semaine
    | tareas? | semana
    | 作业 | 迟交
    ) [ _-]? (\d{1,2} | [a-z])?
    """,
    re.IGNORECASE | re.VERBOSE,
)


def entries_in(place: Path, zone: tzinfo, names: Names) -> list[Entry]:
    """Every file of a folder or a zip: ``parts`` begins with its owner's folder, zip or file, and
    ``outer`` are the folders of several people around that.

    A zip that is all there is in a folder, and that names several of the class, is taken for a
    platform's download, and read as if the zip had been given in place of the folder.

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
    """Which of the things that stand side by side hold several people's work.

    ``below`` maps each thing to the paths in it: a file has the empty path alone.
    """
    holders = {part for part, paths in below.items() if any(paths) and not from_platform(part)}
    teachers = {part for part in holders if _is_teachers(part, names)}
    beside = {
        part
        for part, paths in below.items()
        if part not in teachers and (any(paths) or _is_notebook(part))
    }
    if any(names.whose(part)[0] for part in beside):
        return teachers  # where one person's own things stand, the others are one person's too
    if not teachers and len(beside) == 1 and beside <= holders:
        (alone,) = beside
        if _is_wrapper(alone, below[alone], names):
            return beside
    several = {part for part in beside & holders if len(_named(below[part], names)) > 1}
    if 2 * len(several) < sum(any(below[part]) for part in beside):
        return teachers  # nor are a few what most are not
    if several != beside:  # a zip among other things may be one person's, who chose its name
        several = {part for part in several if not _is_zip(part)}
    # "Practical 2" beside "Practical 1", whoever is in it so far
    alike = set(map(_without_number, several))
    more = {part for part in beside & holders if _without_number(part) in alike}
    return teachers | several | more


def _without_number(part):
    return re.sub(r"\d+", "#", part)


def _is_zip(part):
    return part.lower().endswith(".zip")


def _is_notebook(part):
    return part.lower().endswith(".ipynb")


def _is_teachers(part, names):
    """Whether a folder has a name that teachers give, which is nobody's id or name."""
    named = TEACHERS.fullmatch(unicodedata.normalize("NFC", part)) or part in names.lessons
    return bool(named) and not _is_zip(part) and not names.whose(part)[1]


def _is_wrapper(part, paths, names):
    """Whether the one folder that there is stands around those of several people: two things in it
    name somebody of the class, or it holds nothing but folders that name nobody.
    """
    inside = {path[0]: len(path) > 1 for path in sorted(paths, key=len) if path}
    naming = sum(bool(names.whose(one)[0]) for one in inside)
    loose = any(_is_notebook(one) and not is_folder for one, is_folder in inside.items())
    unnamed = not naming and not loose and sum(inside.values()) > 1
    return not _is_zip(part) and (naming > 1 or unnamed)


def prefixes(entries: Iterable[Entry], names: Names) -> dict[tuple[str, ...], str]:
    """What all names in a folder begin with, such as that of the assignment in ``hw-5-ada``, by the
    folders around them; only where what is left of one of them is somebody of the class.
    """
    beside: dict[tuple[str, ...], set[str]] = {}
    for entry in entries:
        if len(entry.parts) > 1 or _is_notebook(entry.parts[0]):
            beside.setdefault(entry.outer, set()).add(entry.parts[0])
    shared = {outer: _shared(parts) for outer, parts in beside.items() if len(parts) > 1}
    return {
        outer: begin
        for outer, begin in shared.items()
        if any(names.whose(part, begin)[1] > names.whose(part)[1] for part in beside[outer])
    }


def _shared(parts):
    """What names begin with alike, up to the end of a word."""
    begin = re.match(r".*[-_ ]", min(parts)[: _alike(parts)])
    return begin[0] if begin else ""


def _alike(sequences):
    """How many entries all begin with alike: as many as the first and the last when sorted."""
    first, last = min(sequences), max(sequences)
    pairs = enumerate(zip(first, last))
    return next((k for k, (one, other) in pairs if one != other), min(len(first), len(last)))
