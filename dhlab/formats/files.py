"""Reading text and writing it so that nothing is ever half written or lost."""

import codecs
import contextlib
import os
import re
import tempfile
from pathlib import Path

__all__ = ["read_text", "write_text", "write_bytes"]

LARGEST = 10_000_000  # bytes; tables, pose files and logs are far smaller


# what a file says of itself, in an XML declaration or in a comment (coding: latin-1); in what else
# stands there, a name for one, these words are anybody's
DECLARED = re.compile(
    rb"^\s*(?:<\?xml\b[^>]*?encoding=[\"']|(?:[#%;!]|//|/\*|--|-\*-|<!--).*?coding[:=]\s*[\"']?)([-\w.]+)",
    re.MULTILINE,
)
ENCODINGS = {"utf-8", "ascii", "iso8859-1", "iso8859-15", "cp1252", "utf-16"}


def read_text(path: str | Path, what: str, largest: int = LARGEST) -> str:
    """The text of a file: UTF-8, or what its first lines declare (Latin-1, Windows-1252).

    Parameters
    ----------
    path : str or path
    what : str
        What the file should be, for the error: "a table file".
    largest : int
        Bytes; a larger file is refused.

    Raises
    ------
    ValueError
        One sentence when the file is missing, a folder, unreadable, too large or not UTF-8.

    Examples
    --------
    >>> read_text("no-such.yaml", "a table file")
    Traceback (most recent call last):
    ...
    ValueError: no-such.yaml: expected a table file, found no such file; check the name and the
    folder
    """
    path = Path(path)
    try:
        if path.is_dir():
            raise ValueError(f"{path}: expected {what}, found a folder; name a file in it")
        if path.exists() and not path.is_file():
            raise ValueError(
                f"{path}: expected {what}, found something that is no plain file; name a file"
            )
        with open(path, "rb") as file:
            raw = file.read(largest + 1)
    except FileNotFoundError:
        raise ValueError(
            f"{path}: expected {what}, found no such file; check the name and the folder"
        ) from None
    except OSError as error:
        raise ValueError(
            f"{path}: expected {what}, found that it cannot be read ({error.strerror}); check its"
            " permissions"
        ) from None
    if len(raw) > largest:
        raise ValueError(
            f"{path}: expected {what}, found more than {largest // 1_000_000} MB; is it the right"
            " file?"
        )
    try:
        return raw.decode(_declared(raw))
    except UnicodeDecodeError:
        raise ValueError(
            f"{path}: expected {what} in UTF-8, found other bytes; save it as plain text, encoding"
            " UTF-8"
        ) from None


def _declared(raw):
    """The encoding that a file names for itself, where it is one for texts; UTF-8 otherwise."""
    named = DECLARED.search(b"\n".join(raw[:400].splitlines()[:2]))
    with contextlib.suppress(LookupError):
        name = codecs.lookup(named[1].decode()).name if named else ""
        if name in ENCODINGS - {"utf-8"}:
            return name
    return "utf-8-sig"


def write_text(
    path: str | Path, text: str, *, overwrite: bool = False, private: bool = False
) -> None:
    """Write a text as UTF-8; see :func:`write_bytes`."""
    write_bytes(path, text.encode("utf-8"), overwrite=overwrite, private=private)


def write_bytes(
    path: str | Path, data: bytes, *, overwrite: bool = False, private: bool = False
) -> None:
    """Write a whole file or nothing: a temporary file beside it is renamed into place; ``private``:
    for its owner's eyes only.

    Raises
    ------
    ValueError
        The file exists and ``overwrite`` is false, or the folder cannot be written.
    """
    path = Path(path)
    temporary = None
    try:
        handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        os.chmod(
            temporary,
            (
                0o600
                if private
                else path.stat().st_mode & 0o777
                if path.exists()
                else 0o666 & ~_umask()
            ),
        )
        _into_place(temporary, path, overwrite)
    except FileExistsError:
        raise ValueError(
            f"{path}: expected a new file, found one that exists; choose another name, or move that"
            " file away"
        ) from None
    except OSError as error:
        raise ValueError(
            f"{path}: expected to write here, found that it cannot be done ({error.strerror});"
            " choose another folder"
        ) from None
    finally:
        if temporary and os.path.exists(temporary):
            os.unlink(temporary)


def _into_place(temporary, path, overwrite):
    if overwrite:
        os.replace(temporary, path)
        return
    try:
        os.link(temporary, path)  # fails when path exists, in one step
    except FileExistsError:
        raise
    except OSError:  # a file system without hard links
        if path.exists():
            raise FileExistsError(path) from None
        os.replace(temporary, path)


def _umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask
