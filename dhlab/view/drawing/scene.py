"""What is to be drawn, in metres and in space, before anyone has decided where it is looked at from
or how large it becomes.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from .style import INK, SIZES

__all__ = ["Scene", "Stroke", "Face", "Dot", "Label", "LAYERS"]

# later ones lie on top; within one, the nearer
LAYERS = {"floor": 0, "shadow": 1, "body": 2, "aid": 3, "frame": 4, "mark": 5}


@dataclass
class Stroke:
    """A line through ``points`` (k, 3); ``width`` and ``head`` (an arrow's, 0 for none) in points
    of the page.
    """

    points: NDArray[np.float64]
    color: str = INK
    width: float = 1.0
    dash: object = "-"
    layer: str = "body"
    head: float = 0.0
    casing: float = 0.0  # white on either side, which keeps crossing lines apart
    gid: str | None = None


@dataclass
class Face:
    """A filled polygon (k, 3); with ``outline`` what is seen of a solid with these corners."""

    points: NDArray[np.float64]
    fill: str
    edge: str = "none"
    layer: str = "body"
    alpha: float = 1.0
    outline: bool = False
    normal: NDArray[np.float64] | None = (
        None  # (3,) outward; a face that looks away from the viewer is not drawn
    )
    lift: float = 0.0  # metres toward the viewer, for the order of drawing only
    gid: str | None = None


@dataclass
class Dot:
    """A point (3,) as a small disc; ``size`` in points of the page."""

    point: NDArray[np.float64]
    size: float = 4.0
    color: str = INK
    layer: str = "frame"
    gid: str | None = None


@dataclass
class Label:
    """A text that wants to stand near ``anchor`` (3,), off in the direction ``toward`` (3,); where
    exactly is found out later.
    """

    anchor: NDArray[np.float64]
    text: str
    toward: NDArray[np.float64] | None = None
    color: str = INK
    size: float = SIZES["name"]
    math: bool = False
    far: bool = False  # may stand further off, joined by a thin line
    fixed: float | None = None  # exactly this many points off, whatever is there
    # (3,) where the arrow begins whose tip is the anchor; the label may stand beside it
    root: NDArray[np.float64] | None = None
    gid: str | None = None


@dataclass
class Scene:
    """Things to draw, in the order they were added."""

    items: list[Stroke | Face | Dot] = field(default_factory=list)
    labels: list[Label] = field(default_factory=list)

    def add(self, *items: Stroke | Face | Dot | Label) -> None:
        """Add strokes, faces, dots and labels."""
        for item in items:
            if isinstance(item, Label):
                self.labels.append(item)
            else:
                self.items.append(item)

    def points(self) -> NDArray[np.float64]:
        """Every point (k, 3) that must be inside the picture."""
        points = [
            np.atleast_2d(item.point if isinstance(item, Dot) else item.points)
            for item in self.items
        ]
        return np.vstack(points + [np.atleast_2d(label.anchor) for label in self.labels])

    def named(self) -> dict[str, NDArray[np.float64]]:
        """The points (k, 3) of the items that have a name."""
        return {
            item.gid: np.atleast_2d(item.point if isinstance(item, Dot) else item.points)
            for item in self.items
            if item.gid
        }
