"""What a notebook says of itself, from its bytes alone: which lessons it is of, and whose numbers
it draws. Nothing of it is run.
"""

import re

__all__ = ["lessons_of", "numbers_of"]

CHECKED = re.compile(r"""check\(\s*\\?["']([0-9A-Za-z]+)\.""")
LESSON = re.compile(r'"lesson"\s*:\s*"([0-9A-Za-z]+)"')
NUMBER = re.compile(r'"variant"\s*:\s*([0-9]{1,10})\b|set_variant\(\s*([0-9]{1,10})\s*\)')


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
    text = _text(raw)
    return frozenset(CHECKED.findall(text)) | frozenset(LESSON.findall(text))


def numbers_of(raw: bytes) -> frozenset[int]:
    """Whose numbers a notebook draws: the variants that its cells set and that were noted in it
    when it was handed out; empty for those of all.

    Examples
    --------
    >>> numbers_of(b'{"source": "set_variant(17)  # your own numbers"}'), numbers_of(b"{}")
    (frozenset({17}), frozenset())
    """
    return frozenset(int(noted or given) for noted, given in NUMBER.findall(_text(raw))) - {0}


def _text(raw):
    return raw.decode("utf-16" if raw[:2] in (b"\xff\xfe", b"\xfe\xff") else "latin-1", "replace")
