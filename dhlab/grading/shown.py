"""Texts that strangers chose, as they are shown: nothing in them moves a cursor or turns the
writing.
"""

import hashlib
import unicodedata
from collections.abc import Iterable

__all__ = ["fingerprint", "printable", "readable", "some"]


def fingerprint(name: str) -> str:
    """Six signs that tell a name from others that are shortened, or written otherwise, to the same.

    Examples
    --------
    >>> fingerprint("ada") != fingerprint("Ada")
    True
    """
    return hashlib.sha256(name.encode("utf-8", "replace")).hexdigest()[:6]


def printable(name: str) -> str:
    """A name that a student gave, without what moves a terminal's cursor or turns the writing.

    Examples
    --------
    >>> printable("a\\x1b[2Jb")
    'a\\\\x1b[2Jb'
    """
    return "".join(
        letter if letter.isprintable() else letter.encode("unicode_escape").decode()
        for letter in name
    )


def readable(text: str) -> str:
    """A text without control characters, without letters that nobody sees, and without those that
    turn the direction of writing: what is read is what is there.

    Examples
    --------
    >>> readable("a\\u202eb\\n")
    'a·b\\n'
    """
    return "".join(
        c if c in "\n\t" or not unicodedata.category(c).startswith("C") else "·" for c in text
    )


def some(names: Iterable[str], most: int = 3) -> str:
    """Names in a sentence, the first of them where they are many.

    Examples
    --------
    >>> some(["a", "b", "a", "c", "d", "e"])
    'a, b, c and 2 more'
    """
    told = list(dict.fromkeys(names))
    more = [f"{len(told) - most} more"] if len(told) > most else []
    *first, last = [*told[:most], *more]
    return f"{', '.join(first)} and {last}" if first else last
