"""Each student's own numbers: a variant is drawn from the teacher's key and the student's id; the
key stays with the teacher.
"""

import hmac
import secrets
import unicodedata
from collections.abc import Iterable
from pathlib import Path

from ...course.kinds.exercise import SHUFFLED
from ...formats.files import read_text, write_text

__all__ = ["variant", "variants", "new_key", "write_key", "make_key", "read_key"]

KEY_BYTES = 32
HIGHEST = 2**31 - 1  # 0 is left for "the same for all"


def variant(key: bytes, student: str) -> int:
    """The number that draws a student's exercises.

    HMAC-SHA256 (RFC 2104) of the id under the key: from a student's own number nobody can tell
    another's.

    Parameters
    ----------
    key : bytes
        The teacher's key.
    student : str
        The student's id, as in the roster.

    Returns
    -------
    int
        From 2³² + 1 to 2³² + 2³¹ - 1. Smaller ones, given by hand, change the task's numbers alone:
        that the options change their places is for lessons that show them so, which
        :func:`dhlab.grading.handing_out.release.release` writes.

    Examples
    --------
    >>> variant(b"k" * 32, "ada") == variant(b"k" * 32, "ada")
    True
    >>> variant(b"k" * 32, "ada") == variant(b"k" * 32, "bo")
    False
    """
    digest = hmac.digest(key, unicodedata.normalize("NFC", student).encode(), "sha256")
    return int.from_bytes(digest[:8], "big") % HIGHEST + 1 + SHUFFLED


def variants(key: bytes | None, students: Iterable[str]) -> dict[str, int]:
    """The variants of many students, by id; 0 for each of them when there is no key.

    Parameters
    ----------
    key : bytes or None
    students : iterable of str

    Examples
    --------
    >>> variants(None, ["ada", "bo"])
    {'ada': 0, 'bo': 0}
    """
    return {student: variant(key, student) if key else 0 for student in students}


def new_key() -> bytes:
    """A key that nobody has had before."""
    return secrets.token_bytes(KEY_BYTES)


def write_key(path: str | Path, key: bytes) -> None:
    """Write a key into a new file that only its owner may read; an existing file is never
    touched.
    """
    write_text(path, key.hex() + "\n", private=True)


def make_key(path: str | Path) -> bytes:
    """Draw a new key into a file; see :func:`write_key`.

    Raises
    ------
    ValueError
        The file exists, or cannot be written.
    """
    key = new_key()
    write_key(path, key)
    return key


def read_key(path: str | Path) -> bytes:
    """The key in a file that :func:`make_key` wrote.

    Raises
    ------
    ValueError
        There is no such file, or it holds no key.
    """
    text = read_text(path, "the teacher's key").strip()
    try:
        key = bytes.fromhex(text)
    except ValueError:
        key = b""
    if len(key) != KEY_BYTES:
        raise ValueError(
            f"{Path(path)}: expected the teacher's key, {2 * KEY_BYTES} hexadecimal digits, found"
            f" {len(text)} other characters; give the file that dhlab release wrote, since another"
            " key gives other numbers"
        )
    return key
