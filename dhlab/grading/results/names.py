"""What the files of a student are called: after the student, and never longer than a file system
takes; and what tells our pages from others.
"""

import hashlib
from urllib.parse import quote

__all__ = ["OURS", "marks_stem", "page_stem"]

OURS = (  # in every page, so that no other is ever overwritten
    '<meta name="generator" content="dhlab">'
)

MOST = 200  # bytes; a temporary file beside it has a longer name


def marks_stem(student: str) -> str:
    """The name of a student's marks, without ending: readable on every system.

    Examples
    --------
    >>> marks_stem("ada"), marks_stem("李"), len(marks_stem(65 * "李"))
    ('ada', '%E6%9D%8E', 117)
    """
    return _short(quote(student, safe=" @+"), student)


def page_stem(student: str) -> str:
    """The name of a student's page, without ending."""
    return _short(student, student)


def _short(name, student):
    """``~`` stands in no id, so that a shortened name is nobody else's."""
    if len(name.encode()) <= MOST:
        return name
    cut = name.encode()[:100].decode("utf-8", "ignore").rstrip(". ")
    return f"{cut}~{hashlib.sha256(student.encode()).hexdigest()[:16]}"
