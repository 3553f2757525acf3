"""Whose submission is it? Names of files and folders as learning platforms write them, matched with
the roster.
"""

import hashlib
import re
import unicodedata
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from .roster import Student

__all__ = ["student_of", "from_platform", "Names", "Owner"]

MOODLE = re.compile(r"(?P<name>.+?)_(?P<number>\d+)_assignsubmission_(file|onlinetext)")
CANVAS = re.compile(
    r"(?P<name>[^_]+)_(?P<late>LATE_)?(?P<user>\d+)_(?P<number>\d+)_(?P<file>.+)", re.IGNORECASE
)
COPY = re.compile(r"([ _-]*(copy|version|final|v)[ ._-]?\d*|[ _-]*\(\d+\)|-\d+)$", re.IGNORECASE)
LONGEST = 100  # bytes of a name that was read off a file
ENDINGS = re.compile(r"(\.(ipynb|json|txt|zip))+$", re.IGNORECASE)


class Owner(NamedTuple):
    """Whose a file seems to be: the student, whether the roster knows the student, and where a
    learning platform's name told, the name, its number and the place. ``sure`` is False where an id
    only stands somewhere in a longer name, which anybody may have given to a file.
    """

    student: str
    known: bool
    called: str = ""
    number: str = ""
    place: tuple[str, ...] = ()
    sure: bool = True


class Names:
    """The roster's students by everything a platform may call them. An id is one person's; a name
    may be chosen, and takes no id's place; an address takes neither's.
    """

    def __init__(self, roster: Iterable[Student], lessons: Iterable[str]) -> None:
        self.lessons = [re.escape(name) for name in lessons]
        self.ids = {_plain(student.student): student.student for student in roster}
        self._names: dict[str, set[str]] = {}
        self._letters: dict[str, set[str]] = {}  # Canvas writes "Lovelace, Ada" as lovelaceada
        self._mails: dict[str, set[str]] = {}
        self._whose: dict[str, tuple[str | None, bool]] = {}
        for student in roster:
            name = _plain(_words(student.name))
            _add(self._names, name, student)
            if " " in name:
                for words in (name, " ".join(reversed(name.split()))):
                    _add(self._letters, _letters(words), student)
            for mail in (student.email, student.email.partition("@")[0]):
                _add(self._mails, _plain(mail), student)

    def by_name(self, called: str) -> str | None:
        """The one student of this name; None."""
        return _only(self._so_called(called))

    def find(self, called: str) -> str | None:
        """The one student of this id, of this name where it is no id, or else of this address."""
        plain = _plain(called)
        known = self.ids.get(plain)
        return known or _only(self._so_called(called) or self._mails.get(plain, ()))

    def _so_called(self, called):
        return {
            *self._names.get(_plain(called), ()),
            *self._names.get(_plain(_words(called)), ()),
            *self._letters.get(_letters(called), ()),
        }

    def within(self, text: str) -> str | None:
        """The one student whose id stands in a longer name, set off by signs."""
        plain = _plain(text)
        spaced = plain.replace("_", " ")
        found = {
            student
            for key, student in self.ids.items()
            if key in plain  # patterns are slow, and a class has many ids
            and (
                re.search(rf"(?<![\w]){re.escape(key)}(?![\w])", spaced)
                or re.search(rf"(?:^|[_ .-]){re.escape(key)}(?:[_ .-]|$)", plain)
            )
        }
        longest = {
            student
            for student in found
            if not any(student != other and _plain(student) in _plain(other) for other in found)
        }
        return longest.pop() if len(longest) == 1 else None

    def whose(self, part: str) -> tuple[str | None, bool]:
        """(student or None, whether that is sure) of one file or folder; each is looked at once."""
        if part not in self._whose:
            self._whose[part] = _known(part, self)
        return self._whose[part]


def _only(found):
    return next(iter(found)) if len(found) == 1 else None


def _add(known, called, student):
    if called:
        known.setdefault(called, set()).add(student.student)


def student_of(parts: Sequence[str], names: Names, folder: str) -> Owner:
    """The Owner of a file.

    Parameters
    ----------
    parts : sequence of str
        The path within what is graded, outermost first.
    names : Names
    folder : str
        What the graded folder is called, for a folder that is one student's.

    Returns
    -------
    Owner
    """
    strange = False  # within what a platform calls by a name that nobody has, names are its owner's
    for place, part in enumerate(parts):
        known, sure = names.whose(part)
        if known:
            numbered = _numbered(part, parts[:place])
            # an id is one person's, whatever numbers stand beside it
            by_id = _plain(known) in map(_plain, numbered[:2])
            name, number, where = numbered if numbered and not by_id else ("", "", ())
            return Owner(known, True, name, number, where, sure and not strange)
        strange = strange or from_platform(part)
    called = _called(parts[0], names, is_file=len(parts) == 1)
    called = unicodedata.normalize("NFC", called or folder)
    safe = _safe(called)
    if safe != called or _plain(safe) in names.ids:
        # other signs stood there, which a file's name cannot have: somebody else may be called so
        safe = f"{safe}-{hashlib.sha256(called.encode('utf-8', 'replace')).hexdigest()[:6]}"
    return Owner(safe, False, *_numbered(parts[0], ()))


def from_platform(part: str) -> bool:
    """Whether a name is one that Moodle or Canvas writes.

    Examples
    --------
    >>> from_platform("Ada Lovelace_771_assignsubmission_file_"), from_platform("ada")
    (True, False)
    """
    return bool(MOODLE.match(part) or CANVAS.match(part))


def _numbered(part, place):
    """(name, number, place) as a learning platform wrote them; nothing where it did not."""
    if moodle := MOODLE.match(part):
        return _safe(moodle["name"]), moodle["number"], place
    if canvas := CANVAS.match(part):
        return _safe(canvas["name"]), canvas["user"], place
    return ()


def _known(part, names):
    """(student or None, whether that is sure). Of a name that a platform wrote only what the
    platform put there counts; the rest is the student's own.
    """
    stem = ENDINGS.sub("", part)
    canvas = CANVAS.match(part)
    written = MOODLE.match(part) or canvas
    if written:
        # a number is the platform's; a name is its owner's choice, and may be another's id
        if written is canvas and (found := names.ids.get(_plain(written["user"]))):
            return found, True
        called = written["name"]
        if found := names.by_name(called):
            return found, True
        return names.find(called), False
    for called in (stem, _called(part, names, True)):
        if called and (found := names.find(called)):
            return found, True
    return names.within(stem), False


def _called(part, names, is_file):
    """What is left of a name when everything that says lesson, platform and copy is taken away."""
    platform = MOODLE.match(part) or CANVAS.match(part)
    if platform:
        return platform["name"]
    if not is_file:
        return part
    stem = COPY.sub("", ENDINGS.sub("", part))
    for lesson in names.lessons:
        stem = re.sub(rf"(^|[ _.-]+){lesson}([ _.-]+|$)", " ", stem, flags=re.IGNORECASE).strip()
    return stem.strip(" _.-")


def _plain(text):
    return unicodedata.normalize("NFC", text).casefold().strip()


def _words(name):
    """A name's words in one order, so that "Lovelace, Ada" is "Ada Lovelace"."""
    return (
        " ".join(sorted(re.findall(r"[^\s,_]+", _plain(name))))
        if re.search(r"[\s,_]", name.strip())
        else name
    )


def _letters(text):
    return re.sub(r"[\W\d_]", "", unicodedata.normalize("NFKD", _plain(text)))


def _safe(called):
    """A name that can name a file on every system."""
    text = unicodedata.normalize("NFC", called.encode("utf-8", "replace").decode("utf-8"))
    text = re.sub(r"[^\w.@+ -]", "_", text).strip(" .")
    if len(text.encode()) > LONGEST:
        cut = text.encode()[:LONGEST].decode("utf-8", "ignore")
        text = f"{cut}-{hashlib.sha256(text.encode()).hexdigest()[:6]}"
    return text or "unnamed"
