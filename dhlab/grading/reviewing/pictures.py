"""Which pictures a page may show: a file of a few hundred bytes may be gigabytes when it opens."""

import base64
import io
import warnings
from collections.abc import Sequence

from PIL import Image

from ..reports.answered import Picture

__all__ = ["openable"]

MOST = 100_000_000  # points of four bytes each; a telephone's picture has 12 to 50 million
FORMATS = "PNG", "JPEG", "GIF", "WEBP"


def openable(pictures: Sequence[Picture]) -> list[Picture]:
    """Those that are pictures, whatever they are called, and not too large to be opened."""
    return [one for one in pictures if 0 < _points(one) <= MOST]


def _points(picture):
    """Width times height, as the head of the file says; 0 where it says nothing."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # that it is large
            with Image.open(io.BytesIO(base64.b64decode(picture.data)), formats=FORMATS) as opened:
                return opened.width * opened.height
    except Exception:  # whatever a stranger's file makes of a reader
        return 0
