"""The page: views side by side, each as large as fits, the page as large as they need; a figure
that pyplot never hears of.
"""

import textwrap
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

from .camera import Camera
from .labels import place_labels
from .paint import Panel, paint
from .scene import Scene
from .style import FONT, INK, QUIET, SIZES

__all__ = ["NARROW", "NARROW_PIXELS", "Page", "View", "compose", "heading"]

EDGE, GAP = 8.0, 12.0  # page points
DPI = 150
LETTER = 0.6  # how wide the letters of this type are, of their size; roughly
NARROW_PIXELS = 336  # what a telephone of 390 has for a picture


@dataclass(frozen=True)
class Room:
    """What a page may take, page points: views side by side, and one above the other (tall)."""

    width: float
    height: float
    tall: float
    least: float
    narrow: bool = False


WIDE = Room(560.0, 420.0, 500.0, 340.0)
NARROW = Room(
    274.0, 300.0, 480.0, 274.0, narrow=True
)  # the letters as large, hence less of all else


class Page(Figure):
    """A figure that can be had for a narrow screen as well: drawn anew, its letters as large."""

    narrow: Callable[[], "Page"]


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


def compose(views: list[View], title: str = "") -> Page:
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
    Page
        A matplotlib figure with one axes per view, each of equal scale in both directions;
        ``narrow()`` draws it for a narrow screen.
    """
    page = _drawn(views, title, WIDE)
    page.narrow = partial(_drawn, views, title, NARROW)
    return page


def _drawn(views, title, room):
    lines = heading(title, room.width if room.narrow else None)
    scales, corners, area = _arrange(views, room)
    head = 8.0 + 17.0 * len(lines)
    page = np.array(
        [max(area[0], _title_width(lines), room.least), area[1] + head]
    ) + 2 * EDGE * np.array([1, 0.5])
    figure = Page(figsize=(page[0] / 72, page[1] / 72), dpi=DPI, facecolor="white")
    FigureCanvasAgg(figure)
    for k, (line, kind) in enumerate(lines):
        figure.text(
            0.5,
            1 - (8 + 17 * k) / page[1],
            line,
            ha="center",
            va="top",
            family=FONT,
            fontsize=SIZES[kind],
            color=INK if kind == "title" else QUIET,
            parse_math=False,
            usetex=False,
        )
    shift = np.array([(page[0] - area[0]) / 2, EDGE])
    for view, scale, corner in zip(views, scales, corners):
        _draw(figure, view, scale, corner + shift, page)
    return figure


def _arrange(views, room):
    """Scales, lower left corners and the whole area (2,) of the views, page points."""
    if len(views) == 1:
        scale = views[0].scale((room.width, room.height))
        return [scale], [np.zeros(2)], views[0].size(scale)
    below = _below(views[0], views[1], room)
    if room.narrow:
        return below
    beside = _beside(views[0], views[1], room)
    return below if below[0][0] > 1.3 * beside[0][0] else beside


def _beside(large, small, room):
    scales = [
        large.scale((0.63 * room.width - GAP, room.height)),
        small.scale((0.37 * room.width, room.height)),
    ]
    (w1, h1), (w2, h2) = large.size(scales[0]), small.size(scales[1])
    height = max(h1, h2)
    return (
        scales,
        [np.array([0, (height - h1) / 2]), np.array([w1 + GAP, (height - h2) / 2])],
        np.array([w1 + GAP + w2, height]),
    )


def _below(large, small, room):
    scales = [
        large.scale((room.width, 0.64 * room.tall)),
        small.scale((0.8 * room.width, 0.36 * room.tall - GAP)),
    ]
    (w1, h1), (w2, h2) = large.size(scales[0]), small.size(scales[1])
    width = max(w1, w2)
    return (
        scales,
        [np.array([(width - w1) / 2, h2 + GAP]), np.array([(width - w2) / 2, 0])],
        np.array([width, h1 + GAP + h2]),
    )


def heading(title: str, width: float | None = None) -> list[tuple[str, str]]:
    """The lines of a title and what they are, "title" or "note"; none wider than ``width`` page
    points.
    """
    kinds = ["title", *["note"] * len(title.splitlines())]
    return [
        (part, kind)
        for line, kind in zip(title.splitlines(), kinds)
        for part in (textwrap.wrap(line, int(width / (LETTER * SIZES[kind]))) if width else [line])
    ]


def _title_width(lines):
    return max((LETTER * SIZES[kind] * len(line) for line, kind in lines), default=0)


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
