"""What a notebook says of itself, from its bytes alone: which lessons it is of, and whose numbers
it draws. Nothing of it is run.
"""

import json
import re
from hashlib import sha256
from typing import Any, NamedTuple

from ..inside.reading.notebook import decoded

__all__ = ["Look", "look", "lessons_of", "numbers_of", "parsed"]

CHECKED = re.compile(rb"""check\(\s*\\?["']([0-9A-Za-z]{1,9})\.""")
LESSON = re.compile(rb'"lesson"\s*:\s*"([0-9A-Za-z]{1,9})"')
# two, since what begins with known letters is looked for ten times as fast as one of several
NOTED = re.compile(rb'"variant"\s*:\s*([0-9]{1,10})\b')
SET = re.compile(rb"set_variant\(\s*([0-9]{1,10})\s*\)")
MOST = 50  # different lessons or numbers; who names more says nothing with it
LARGEST = 16_000_000  # bytes that are parsed outside the cage; photos are large
PARTS = 500_000  # of what is parsed there: each costs some hundred bytes of memory


class Look(NamedTuple):
    """What is known of a notebook once it was read: its lessons, whose numbers it draws, and a
    fingerprint of its bytes.
    """

    lessons: frozenset[str]
    numbers: frozenset[int]
    print: str


def look(raw: bytes) -> Look:
    """All of it, in one reading of the bytes."""
    return Look(lessons_of(raw), numbers_of(raw), sha256(raw).hexdigest())


def lessons_of(raw: bytes) -> frozenset[str]:
    """The lessons a notebook is of, by its checks and by what was written into it when it was
    handed out; empty when it does not say.

    Parameters
    ----------
    raw : bytes

    Returns
    -------
    frozenset of str

    Examples
    --------
    >>> sorted(lessons_of(b'{"cells": [{"source": "check(\\\\"05.1\\\\", rot_x)"}]}'))
    ['05']
    """
    raw = _plain(raw)
    return frozenset(name.decode() for name in _found(CHECKED, raw) | _found(LESSON, raw))


def numbers_of(raw: bytes) -> frozenset[int]:
    """Whose numbers a notebook draws: the variants that its cells set and that were noted in it
    when it was handed out; empty for those of all.

    Examples
    --------
    >>> numbers_of(b'{"source": "set_variant(17)  # your own numbers"}'), numbers_of(b"{}")
    (frozenset({17}), frozenset())
    """
    raw = _plain(raw)
    return frozenset(map(int, _found(NOTED, raw) | _found(SET, raw))) - {0}


def _found(pattern, raw):
    found: set[bytes] = set()
    for match in pattern.finditer(raw):
        found.add(match[1])
        if len(found) == MOST:
            break
    return found


def _plain(raw):
    if raw[:2] not in (b"\xff\xfe", b"\xfe\xff"):
        return raw
    return raw.decode("utf-16", "replace").encode("utf-8", "replace")


def parsed(raw: bytes) -> Any:
    """The JSON of a notebook, read outside the cage: only what costs little memory and time.

    Raises
    ------
    ValueError
        It is no JSON, is too large or has too many parts, or is nested too deeply.
    """
    # counted in texts too, where few stand
    if len(raw) > LARGEST or sum(map(raw.count, (b",", b"[", b"{"))) > PARTS:
        raise ValueError("expected a notebook of common size, found a larger one")
    try:
        return json.loads(decoded(raw))
    except RecursionError:
        raise ValueError("expected a notebook, found brackets in brackets") from None
