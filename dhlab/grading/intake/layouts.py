"""Whose submission is it? The names of files and folders, matched with the roster."""

import re
import unicodedata
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from ..shown import fingerprint
from .platforms import BLACKBOARD, CANVAS, from_platform, without_group, written
from .roster import Student

__all__ = ["Names", "Owner", "named_in", "student_of"]

# no more than three signs before it: a long row of them would take time; they are stripped later
COPY = re.compile(
    r"([ _-]{0,3}(copy|version|final|v)[ ._-]?\d*|[ _-]{0,3}\(\d+\)|-\d+)$", re.IGNORECASE
)
SPACED = re.compile(r"[\s,_]")  # what stands between words
RUN = re.compile(r"[^\W_]+")  # letters and digits
SIGNS = "_.-@+"  # what else an id may have
LONGEST = 100  # bytes of a name that was read off a file
ENDINGS = re.compile(r"(\.(ipynb|json|txt|zip))+$", re.IGNORECASE)


class Owner(NamedTuple):
    """Whose a file seems to be.

    ``student`` is an id, and ``known`` says whether it is on the roster. Where a platform numbers
    people, ``called``, ``number`` and ``place`` are the name and the number that it wrote, and the
    folders around them. ``sure`` is False where the student's id is only part of a longer name,
    which anybody may have chosen. ``within`` is the student whom a name further inside a stranger's
    folder or zip mentions; all names in there are the stranger's own. ``login`` is True where one
    word says it that is the student's name, or what is before the @ of the address: both may be
    anybody's login.
    """

    student: str
    known: bool
    called: str = ""
    number: str = ""
    place: tuple[str, ...] = ()
    sure: bool = True
    within: str = ""
    login: bool = False


class Names:
    """The roster's students by everything a platform may call them: by id; where no id fits, by
    name, which people may choose; where no name fits either, by address.
    """

    def __init__(self, roster: Iterable[Student], lessons: Iterable[str]) -> None:
        self.lessons = tuple(lessons)
        self.ids = {_plain(student.student): student.student for student in roster}
        self.files = {key.casefold() for key in self.ids}  # as some systems compare names of files
        self._cores: dict[str, list[str]] = {}  # ids from their first letter or digit to the last
        for key in self.ids:
            self._cores.setdefault(key.strip(SIGNS), []).append(key)
        self._most_runs = max((len(RUN.findall(key)) for key in self.ids), default=0)
        self._names: dict[str, set[str]] = {}
        self._letters: dict[str, set[str]] = {}  # Canvas writes "Lovelace, Ada" as lovelaceada
        self._mails: dict[str, set[str]] = {}
        self._whose: dict[tuple[str, str], tuple[str | None, bool]] = {}
        for student in roster:
            name = _plain(_words(student.name))
            _add(self._names, name, student)
            if " " in name:
                for words in (name.split(), name.split()[::-1]):
                    _add(self._names, "".join(words), student)
                    _add(self._letters, _letters("".join(words)), student)
            for mail in (student.email, student.email.partition("@")[0]):
                _add(self._mails, _plain(mail), student)

    def by_id(self, called: str) -> str | None:
        """The student of this id; None."""
        return self.ids.get(_plain(called))

    def by_address(self, mail: str) -> str | None:
        """The one student of this address, all of it; None."""
        return _only(self._mails.get(_plain(mail), ())) if "@" in mail else None

    def by_name(self, called: str) -> str | None:
        """The one student of this name; None."""
        return _only(self._so_called(called))

    def find(self, called: str) -> str | None:
        """The one student of this id, of this name where it is no id, or else of this address."""
        plain = _plain(called)
        known = self.ids.get(plain)
        return known or _only(self._so_called(called) or self._mails.get(plain, ()))

    def _so_called(self, called):
        """The students of this name. An accent makes another person: those whose names have the
        same letters count beside only where it is one word, which Canvas may have made of several.
        """
        own = self.exactly(called)
        if own and SPACED.search(called.strip()):
            return own
        return own | self._letters.get(_letters(called), set())

    def exactly(self, called: str) -> set[str]:
        """The students who have this name itself, its words in whatever order or run together."""
        return self._names.get(_plain(called)) or self._names.get(_plain(_words(called)), set())

    def within(self, text: str) -> str | None:
        """The one student whose id stands in a longer name, set off by signs."""
        plain = _plain(text)
        runs = list(RUN.finditer(plain))
        # looked up, since a class has many ids, and each may stand in a name that is made for it
        parts = {
            plain[first.start() : last.end()]
            for k, first in enumerate(runs)
            for last in runs[k : k + self._most_runs]
        }
        known = (key for part in parts & self._cores.keys() for key in self._cores[part])
        found = {key for key in known if _is_set_off(key, plain)}
        longest = max(found, key=len, default="")
        return self.ids[longest] if found and all(key in longest for key in found) else None

    def whose(self, part: str, prefix: str = "") -> tuple[str | None, bool]:
        """(student or None, whether that is sure) of one file or folder, where all beside it begin
        with ``prefix``; each is looked at once.
        """
        key = part, prefix
        if key not in self._whose:
            self._whose[key] = _known(part, self, prefix)
        return self._whose[key]


def _is_set_off(key, plain):
    """Whether a key stands in a text with no letter or digit beside it."""
    start = plain.find(key)
    while start >= 0:
        end = start + len(key)
        if not (plain[max(0, start - 1) : start].isalnum() or plain[end : end + 1].isalnum()):
            return True
        start = plain.find(key, start + 1)
    return False


def _only(found):
    return next(iter(found)) if len(found) == 1 else None


def _add(known, called, student):
    if called:
        known.setdefault(called, set()).add(student.student)


def student_of(
    parts: Sequence[str], names: Names, folder: str, outer: tuple[str, ...] = (), prefix: str = ""
) -> Owner:
    """The Owner of a file.

    Parameters
    ----------
    parts : sequence of str
        The path within what holds several people's files, outermost first: the first part is
        somebody's, and what stands in it is that person's writing.
    names : Names
    folder : str
        What the graded folder is called, for a folder that is one student's.
    outer : tuple of str
        The folders of several people that it stands in.
    prefix : str
        What all names beside the first part begin with, before somebody's id: who has an id only
        in the rest is not that person.

    Returns
    -------
    Owner
    """
    part = parts[0]
    known, sure = names.whose(part, prefix)
    name, number, where = _numbered(part, outer)
    given = bool(prefix) and (len(parts) > 1 or from_platform(part))  # not by its owner
    if known and (sure or not given):
        # an id is one person's, whatever numbers stand beside it
        if _plain(known) in (_plain(name), number):
            name, number, where = "", "", ()
        login = sure and not written(part) and _is_login(part.removeprefix(prefix), known)
        return Owner(known, True, name, number, where, sure, login=login)
    called = _called(part, names, is_file=len(parts) == 1)
    called = unicodedata.normalize("NFC", called or folder)
    safe = _safe(called)
    if safe != called or safe.casefold() in names.files:
        # other signs stood there, which a file's name cannot have: somebody else may be called so
        safe = f"{safe}-{fingerprint(called)}"
    return Owner(safe, False, name, number, where, within=named_in(parts, names))


def _is_login(called, student):
    """Whether what names a student is one word, no whole address, and without the id."""
    return not re.search(r"[\s,@]", called) and _plain(student) not in _plain(called)


def named_in(parts: Sequence[str], names: Names) -> str:
    """The first student of the roster whom a path names; empty where it names none."""
    return next((known for part in parts if (known := names.whose(part)[0])), "")


def _numbered(part, outer):
    """(name, number, place) where a platform wrote a number for the person; else all empty."""
    told = written(part)
    return (_safe(told.name), told.number, outer) if told and told.number else ("", "", ())


def _known(part, names, prefix):
    """(student or None, whether that is sure). Of a name that a platform wrote only what the
    platform put there counts; the rest is the student's own.
    """
    if told := written(part):
        if told.platform == BLACKBOARD:
            return _known_to_blackboard(told.name, names, prefix)
        return _known_to_platform(told, names)
    stem = ENDINGS.sub("", part)
    for called in (stem, _called(part, names, stem != part), stem.removeprefix(prefix)):
        if called and (found := names.find(called)):
            return found, True
    # a folder is called by who made it: "ada-2" may be another person's login
    return names.find(_called(part, names, True)) or names.within(stem), False


def _known_to_blackboard(called, names, prefix):
    """As :func:`_known`, of a name that is the assignment, an underscore, and the person's id."""
    own = called.removeprefix(prefix)
    if own != called and (found := names.find(own)):
        return found, True
    # where the assignment ends is not known, and an id may have underscores: the longest that fits
    ends = (called.split("_", k)[-1] for k in range(1, called.count("_") + 1))
    return next((found for end in ends if (found := names.find(end))), None), False


def _known_to_platform(told, names):
    """As :func:`_known`. A number is the platform's own, and may be somebody's id by chance; a name
    is the person's choice, and may be somebody else's id.
    """
    by_name = names.by_name(told.name)
    numbered = names.ids.get(_plain(told.number)) if told.platform == CANVAS else None
    if numbered:
        return (numbered, True) if by_name in (None, numbered) else (None, False)
    if by_name:
        return by_name, told.platform == CANVAS or by_name in names.exactly(told.name)
    return names.find(told.name) or names.by_name(without_group(told.name)), False


def _called(part, names, is_file):
    """What is left of a name when everything that says lesson, platform and copy is taken away."""
    if told := written(part):
        return told.name
    if not is_file:
        return part
    stem = COPY.sub("", ENDINGS.sub("", part))
    for lesson in [re.escape(one) for one in names.lessons if one.lower() in stem.lower()]:
        ends = rf"(^|[ _.-]{{1,3}}){lesson}([ _.-]{{1,3}}|$)"
        stem = re.sub(ends, " ", stem, flags=re.IGNORECASE).strip()
    return stem.strip(" _.-")


def _plain(text):
    """A name in small letters: folded, a letter that is small already, as the long s, would be
    another one. Only ß has no capital of its own, and is written SS.
    """
    return unicodedata.normalize("NFC", text).lower().replace("ß", "ss").strip()


def _words(name):
    """A name's words in one order, so that "Lovelace, Ada" is "Ada Lovelace". A sign alone is no
    word: Moodle wants two names of everybody, and who has one is "Cher ." there.
    """
    return (
        " ".join(sorted(re.findall(r"[^\s,_]*[^\W_][^\s,_]*", _plain(name))))
        if SPACED.search(name.strip())
        else name
    )


def _letters(text):
    return re.sub(r"[\W_]", "", unicodedata.normalize("NFKD", _plain(text)))


def _safe(called):
    """A name that can name a file on every system."""
    text = unicodedata.normalize("NFC", called.encode("utf-8", "replace").decode("utf-8"))
    text = re.sub(r"[^\w.@+ -]", "_", text).strip(" .")
    if len(text.encode()) > LONGEST:
        cut = text.encode()[:LONGEST].decode("utf-8", "ignore")
        text = f"{cut}-{fingerprint(text)}"
    return text or "unnamed"
