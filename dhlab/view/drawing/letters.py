"""Texts whose shapes are kept: setting a formula takes longer than all else in a picture, and the
same few letters stand in every one.
"""

from functools import lru_cache
from typing import Any

import numpy as np
from matplotlib.backend_bases import RendererBase
from matplotlib.colors import to_rgba
from matplotlib.font_manager import FontProperties
from matplotlib.path import Path
from matplotlib.patheffects import PathEffectRenderer
from matplotlib.text import Text
from matplotlib.textpath import text_to_path
from matplotlib.transforms import Affine2D, Bbox
from numpy.typing import NDArray

from .style import FONT, halo

__all__ = ["Letters"]

# width, height and depth (3,), page points, by the text, how it is read, and its size
MEASURED: dict[tuple[str, bool, float], NDArray[np.float64]] = {}


class Letters(Text):
    """One line in a halo, as matplotlib draws it; its position is its middle.

    Parameters
    ----------
    content : str
    math : bool
        Whether ``content`` is a formula.
    properties
        Colour, fontsize, zorder and gid.
    """

    def __init__(self, content: str, math: bool, **properties: Any) -> None:
        super().__init__(
            0,
            0,
            f"${content}$" if math else content,
            family=FONT,
            math_fontfamily="dejavusans",
            parse_math=math,
            usetex=False,
            path_effects=halo(),
            **properties,
        )

    def measured(self) -> NDArray[np.float64]:
        """Width, height and what of it is below the line (3,), page points; first asked for where
        the page is laid out, on a canvas of dots.
        """
        key = self.get_text(), self.get_parse_math(), float(self.get_fontsize())
        if key not in MEASURED:
            figure: Any = self.get_figure(root=True)
            extent = super().get_window_extent(figure.canvas.get_renderer())
            depth = self._middle()[1] - extent.y0  # matplotlib's begins at the position
            MEASURED[key] = np.array([extent.width, extent.height, depth]) * 72 / figure.dpi
        return MEASURED[key]

    def get_window_extent(
        self, renderer: RendererBase | None = None, dpi: float | None = None
    ) -> Bbox:
        """The box around it, in dots."""
        figure: Any = self.get_figure(root=True)
        half = self.measured()[:2] * figure.dpi / 72 / 2
        return Bbox([self._middle() - half, self._middle() + half])

    def draw(self, renderer: RendererBase) -> None:
        """Called by matplotlib."""
        dots: Any = renderer.points_to_pixels(1.0)
        width, height, depth = self.measured() * dots
        start = self._middle() + [-width / 2, depth - height / 2]
        shape = Affine2D().scale(float(self.get_fontsize()) * dots / text_to_path.FONT_SCALE)
        color = to_rgba(self.get_color())
        renderer.open_group("text", self.get_gid())
        gc = renderer.new_gc()
        gc.set_foreground(color, isRGBA=True)
        gc.set_linewidth(0.0)
        PathEffectRenderer(self.get_path_effects(), renderer).draw_path(
            gc, _outline(self.get_text(), self.get_parse_math()), shape.translate(*start), color
        )
        gc.restore()
        renderer.close_group("text")

    def _middle(self) -> NDArray[np.float64]:
        return self.get_transform().transform(self.get_position())


@lru_cache(1000)
def _outline(content, math):
    """The shape of a text in the size that matplotlib keeps them in."""
    font = FontProperties(family=FONT, math_fontfamily="dejavusans")
    corners: Any = text_to_path.get_text_path(font, content, ismath=math)
    return Path(*corners)
