"""``Picture``: a figure with the words and the table that say the same to someone who cannot see
it.
"""

import base64
import io
import os
from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import Any

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from PIL import Image

from ..formats import files
from ..printing import grid_html, grid_text
from .drawing.page import NARROW_PIXELS, Page

__all__ = ["Picture"]

# dates and version numbers left out: the same picture is the same bytes
FORMATS = {
    ".png": {},
    ".svg": {"Date": None, "Creator": None},
    ".pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}

# On a dark page a picture's light and dark change places and its hues stay, which leaves no colour
# less contrast than it has on white. What the page calls itself counts first: JupyterLab's theme,
# a site's, VS Code's; then what the reader's system prefers.
_TURNED = ".dhlab-picture img{filter:invert(.91) hue-rotate(180deg)}"
IN_THE_DARK = (
    '<style>@media screen{:is([data-jp-theme-light="false"],[data-theme="dark"],.vscode-dark) '
    f"{_TURNED}@media (prefers-color-scheme:dark){{"
    ':root:not([data-theme="light"]) body:not([data-theme="light"],[data-jp-theme-light],'
    f".vscode-light) {_TURNED}}}}}</style>"
)


class Picture:
    """What the functions of :mod:`dhlab.view` return; a notebook shows it, with the table to unfold
    below.

    Attributes
    ----------
    figure : matplotlib.figure.Figure
        Not known to pyplot, so that no notebook shows it a second time.
    alt : str
        What is to be seen, in a few sentences.
    table : str
        The numbers behind it, as plain text; ``table_html`` is the same for a page.
    cells : dict
        The same as texts: "caption", "headings" and "rows".
    points : dict of arrays (k, 3)
        What was drawn, by name, in metres before it was projected: ``"x-axis:1"``, ``"joint:2"``,
        ...

    Examples
    --------
    >>> import dhlab as dh
    >>> from dhlab import view
    >>> picture = view.arm(dh.load("article-6r"), side=False)
    >>> print(picture.alt)
    The article's 6R arm, as its table has it: an arm with 6 revolute joints, drawn at q = 0°, 0°,
    0°, 0°, 0°, 0°.
    Its end is at x = 0.75, y = -0.2, z = 0.1 m, its x axis along +x and its z axis along -y. Frames
    {4} and {5} share one origin.
    """

    def __init__(
        self,
        figure: Figure,
        alt: str,
        headings: Sequence[str],
        rows: Sequence[Sequence[str]],
        caption: str,
        points: dict[str, NDArray[np.float64]] | None = None,
    ) -> None:
        self.figure, self.alt, self.points = figure, alt, points or {}
        self.cells = {"caption": caption, "headings": [*headings], "rows": [[*row] for row in rows]}
        self.table = f"{caption}\n{grid_text(headings, rows)}"
        self.table_html = grid_html([escape(heading) for heading in headings], rows, caption)

    def save(self, path: str | Path, overwrite: bool = False) -> None:
        """Write the picture as ``.png``, ``.svg`` or ``.pdf``: the whole file or nothing.

        Parameters
        ----------
        path : str or path
        overwrite : bool
            Replace an existing file; it is kept, with an error, otherwise.

        Raises
        ------
        ValueError
            Another ending, a file that exists, a folder that cannot be written.

        Examples
        --------
        >>> from dhlab import view
        >>> import numpy as np
        >>> view.frames(np.eye(4)).save("frame.bmp")
        Traceback (most recent call last):
        ...
        ValueError: frame.bmp: expected a name that ends in .png, .svg or .pdf, found '.bmp'; choose
        one of these
        """
        path = Path(path)
        suffix = path.suffix.lower()
        if suffix not in FORMATS:
            raise ValueError(
                f"{path}: expected a name that ends in .png, .svg or .pdf, found {suffix!r}; choose"
                " one of these"
            )
        files.write_bytes(path, _bytes(self.figure, suffix), overwrite=overwrite)

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> dict[str, str]:
        data = base64.b64encode(_bytes(self.figure, ".png")).decode("ascii")
        # the file has more dots than that, for fine screens
        width = round(self.figure.get_figwidth() * 100)
        image = (
            f'<img alt="{escape(self.alt)}" src="data:image/png;base64,{data}" width="{width}"'
            ' style="max-width:100%">'
        )
        if narrow := self._narrow():
            image = f"<picture>{narrow}{image}</picture>"
        details = f"<details><summary>{self.summary}</summary>{self.table_html}</details>"
        return {
            "text/html": f'<figure class="dhlab-picture">{image}{details}{IN_THE_DARK}</figure>',
            "text/plain": f"{self.alt}\n{self.table}",
        }

    def _narrow(self):
        """The same for narrow screens, where somebody asked for it (the site does) and the page can
        be drawn anew; it doubles what a notebook weighs.
        """
        if not (os.environ.get("DHLAB_NARROW_PICTURES") and isinstance(self.figure, Page)):
            return ""
        figure = self.figure.narrow()
        height = round(NARROW_PIXELS * figure.get_figheight() / figure.get_figwidth())
        data = base64.b64encode(_bytes(figure, ".png")).decode("ascii")
        return (
            f'<source media="(max-width: 36em)" srcset="data:image/png;base64,{data}"'
            f' width="{NARROW_PIXELS}" height="{height}">'
        )

    summary = "The frames as a table"

    def __repr__(self) -> str:
        return f"<Picture: {self.alt}>"


def _bytes(figure, suffix):
    if suffix == ".png":
        return _png(figure)
    return _saved(figure, suffix[1:], metadata=FORMATS[suffix])


def _saved(figure, kind, **more):
    buffer = io.BytesIO()
    with matplotlib.rc_context(
        {"svg.hashsalt": "dhlab", "svg.fonttype": "path", "savefig.bbox": None}
    ):
        figure.savefig(buffer, format=kind, dpi=figure.dpi, facecolor="white", **more)
    return buffer.getvalue()


def _png(figure):
    """With a palette of 128 colours: a fourth of the bytes, and these pictures have some thirty
    colours and their blends.
    """
    dots, small = _saved(figure, "rgba"), io.BytesIO()
    image = Image.frombuffer("RGBA", figure.canvas.get_width_height(), dots).convert("RGB")
    # level 9 takes three times as long for 2 % less
    image.quantize(128, dither=Image.Dither.NONE).save(small, format="PNG", compress_level=8)
    return small.getvalue()
