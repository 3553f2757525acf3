"""How large a picture is when it is open: a few hundred bytes of a file may be gigabytes then."""

import base64
import re
from collections.abc import Sequence

from ..reports.answered import Picture

__all__ = ["openable", "points_of"]

MOST = 100_000_000  # points of four bytes each; a telephone's picture has 12 to 50 million
# a frame of a JPEG: its mark, length and depth; then height and width
FRAME = re.compile(rb"\xff[\xc0-\xc3\xc5-\xc7\xc9-\xcb\xcd-\xcf]..[\x08\x0c](....)", re.DOTALL)


def openable(pictures: Sequence[Picture]) -> list[Picture]:
    """Those that a page may show: what a browser takes for another format, or cannot hold, is left
    out.
    """
    return [one for one in pictures if 0 < points_of(_bytes(one)) <= MOST]


def _bytes(picture):
    try:
        return base64.b64decode(picture.data)
    except ValueError:  # letters of base64 that are none of it together
        return b""


def points_of(data: bytes) -> int:
    """Width times height, as the file itself says, whatever it is called; 0 where it does not say.

    Examples
    --------
    >>> points_of(b"GIF89a" + bytes([100, 0, 50, 0])), points_of(b"<svg>")
    (5000, 0)
    """
    if data.startswith(b"\x89PNG\r\n\x1a\n"):
        return _big(data[16:20]) * _big(data[20:24])
    if data.startswith((b"GIF87a", b"GIF89a")):
        return _little(data[6:8]) * _little(data[8:10])
    if data.startswith(b"\xff\xd8"):
        # every frame that may be one: also a small picture within the picture
        found = [_big(size[:2]) * _big(size[2:]) for size in FRAME.findall(data)]
        return max(found, default=0)
    if data[:4] == b"RIFF" and data[8:12] == b"WEBP":
        return _of_webp(data)
    return 0


def _of_webp(data):
    kind = data[12:16]
    if kind == b"VP8X":
        return (_little(data[24:27]) + 1) * (_little(data[27:30]) + 1)
    if kind == b"VP8L":
        both = _little(data[21:25])
        return ((both & 0x3FFF) + 1) * ((both >> 14 & 0x3FFF) + 1)
    return (_little(data[26:28]) & 0x3FFF) * (_little(data[28:30]) & 0x3FFF)


def _big(some):
    return int.from_bytes(some, "big")


def _little(some):
    return int.from_bytes(some, "little")
