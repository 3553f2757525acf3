"""The page: views side by side, each as large as fits, the page as large as they need; a figure
that pyplot never hears of.
"""

from dataclasses import dataclass

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

from .camera import Camera
from .labels import place_labels
from .paint import Panel, paint
from .scene import Scene
from .style import FONT, INK, QUIET, SIZES

__all__ = ["View", "compose"]

# page points: views side by side, and one above the other
WIDTH, HEIGHT, TALL = 560.0, 420.0, 500.0
LEAST_WIDTH, EDGE, GAP = 340.0, 8.0, 12.0
DPI = 150


@dataclass
class View:
    """One scene and where it is seen from."""

    scene: Scene
    camera: Camera
    title: str = ""
    # page points kept free left, below, right, above: room for labels
    frame: tuple[float, float, float, float] = (38.0, 14.0, 28.0, 20.0)

    def margins(self) -> NDArray[np.float64]:
        """The room for labels, and above for the title."""
        return np.array(self.frame) + [0, 0, 0, 16.0 if self.title else 0.0]

    def box(self) -> NDArray[np.float64]:
        """The corners (2, 2) of the scene on the picture, metres."""
        flat = self.camera.flat(self.scene.points())
        low, high = flat.min(axis=0), flat.max(axis=0)
        least = 0.25 * (high - low).max() or 1.0
        slack = np.clip(least - (high - low), 0, None) / 2
        return np.array([low - slack, high + slack])

    def scale(self, room: ArrayLike) -> float:
        """Page points per metre at which the scene and its labels fill a room (2,) of the page."""
        left, bottom, right, top = self.margins()
        return np.min(
            (np.asarray(room) - [left + right, bottom + top]) / np.diff(self.box(), axis=0)[0]
        )

    def size(self, scale: float) -> NDArray[np.float64]:
        """Width and height (2,) on the page at a scale, labels included."""
        left, bottom, right, top = self.margins()
        return np.diff(self.box(), axis=0)[0] * scale + [left + right, bottom + top]


def compose(views: list[View], title: str = "") -> Figure:
    """Put one view on a page, or a large and a small one.

    Parameters
    ----------
    views : list of View
        The second stands beside the first, or below it where that lets the first be much larger
        (flat, wide arms).
    title : str
        May have several lines.

    Returns
    -------
    matplotlib.figure.Figure
        With one axes per view, each of equal scale in both directions.
    """
    scales, corners, area = _arrange(views)
    head = 8.0 + 17.0 * len(title.splitlines())
    page = np.array(
        [max(area[0], _title_width(title), LEAST_WIDTH), area[1] + head]
    ) + 2 * EDGE * np.array([1, 0.5])
    figure = Figure(figsize=(page[0] / 72, page[1] / 72), dpi=DPI, facecolor="white")
    FigureCanvasAgg(figure)
    for k, line in enumerate(title.splitlines()):
        figure.text(
            0.5,
            1 - (8 + 17 * k) / page[1],
            line,
            ha="center",
            va="top",
            family=FONT,
            fontsize=SIZES["note" if k else "title"],
            color=QUIET if k else INK,
            parse_math=False,
            usetex=False,
        )
    shift = np.array([(page[0] - area[0]) / 2, EDGE])
    for view, scale, corner in zip(views, scales, corners):
        _draw(figure, view, scale, corner + shift, page)
    return figure


def _arrange(views):
    """Scales, lower left corners and the whole area (2,) of the views, page points."""
    if len(views) == 1:
        scale = views[0].scale((WIDTH, HEIGHT))
        return [scale], [np.zeros(2)], views[0].size(scale)
    beside, below = _beside(*views), _below(*views)
    return below if below[0][0] > 1.3 * beside[0][0] else beside


def _beside(large, small):
    scales = [large.scale((0.63 * WIDTH - GAP, HEIGHT)), small.scale((0.37 * WIDTH, HEIGHT))]
    (w1, h1), (w2, h2) = large.size(scales[0]), small.size(scales[1])
    height = max(h1, h2)
    return (
        scales,
        [np.array([0, (height - h1) / 2]), np.array([w1 + GAP, (height - h2) / 2])],
        np.array([w1 + GAP + w2, height]),
    )


def _below(large, small):
    scales = [large.scale((WIDTH, 0.64 * TALL)), small.scale((0.8 * WIDTH, 0.36 * TALL - GAP))]
    (w1, h1), (w2, h2) = large.size(scales[0]), small.size(scales[1])
    width = max(w1, w2)
    return (
        scales,
        [np.array([(width - w1) / 2, h2 + GAP]), np.array([(width - w2) / 2, 0])],
        np.array([width, h1 + GAP + h2]),
    )


def _title_width(title):
    """Roughly: the letters of this type are about 0.6 of its size wide."""
    return max(
        (
            0.6 * SIZES["note" if k else "title"] * len(line)
            for k, line in enumerate(title.splitlines())
        ),
        default=0,
    )


def _draw(figure, view, scale, lower, page):
    """One view: its axes cover all of its room, margins included, so that labels can use them."""
    size = view.size(scale)
    axes = figure.add_axes([*(lower / page), *(size / page)])
    corner = view.box()[0] - view.margins()[:2] / scale
    axes.set(
        xlim=(corner[0], corner[0] + size[0] / scale),
        ylim=(corner[1], corner[1] + size[1] / scale),
        aspect="equal",
    )
    axes.axis("off")
    panel = Panel(axes, view.camera, scale, corner, size)
    paint(view.scene, panel)
    place_labels(view.scene, panel)
    if view.title:
        axes.text(
            0.5,
            1.0,
            view.title,
            transform=axes.transAxes,
            ha="center",
            va="top",
            family=FONT,
            fontsize=SIZES["note"],
            color=QUIET,
            parse_math=False,
            usetex=False,
        )
