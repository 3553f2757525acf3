"""From a scene to matplotlib artists: projected, sorted by depth, arrow heads and labels in points
of the page.
"""

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.lines import Line2D
from matplotlib.patches import Polygon
from numpy.typing import ArrayLike, NDArray
from scipy.spatial import ConvexHull

from .camera import Camera
from .scene import LAYERS, Dot, Face, Scene

__all__ = ["Panel", "paint"]


@dataclass
class Panel:
    """One view on the page: its axes are in metres, ``scale`` page points each, and show ``lower``
    (2,) at the lower left.
    """

    axes: Axes
    camera: Camera
    scale: float
    lower: NDArray[np.float64]
    size: np.ndarray  # (2,) page points

    def to_page(self, flat: ArrayLike) -> NDArray[np.float64]:
        """Metres on the picture (..., 2) in page points from the panel's corner."""
        return (np.asarray(flat) - self.lower) * self.scale

    def from_page(self, points: ArrayLike) -> NDArray[np.float64]:
        """The way back."""
        return np.asarray(points) / self.scale + self.lower


def paint(scene: Scene, panel: Panel) -> None:
    """Draw all items of a scene, the labels excepted; as artists, since ``add_line`` and
    ``add_patch`` work out limits that stand already, which takes longer than all else here.
    """
    depths = panel.camera.depth(scene.points())
    low, span = depths.min(), np.ptp(depths) or 1.0
    for item in scene.items:
        middle = item.point if isinstance(item, Dot) else np.mean(item.points, axis=0)
        nearness = (panel.camera.depth(middle) + getattr(item, "lift", 0.0) - low) / span
        draw = _dot if isinstance(item, Dot) else _face if isinstance(item, Face) else _stroke
        draw(item, panel, LAYERS[item.layer] + 0.05 + 0.9 * np.clip(nearness, 0, 1))


def _dot(dot, panel, zorder):
    x, y = panel.camera.flat(dot.point)
    panel.axes.add_artist(
        Line2D(
            [x],
            [y],
            marker="o",
            markersize=dot.size,
            markerfacecolor=dot.color,
            markeredgecolor="white",
            markeredgewidth=0.6,
            linestyle="none",
            zorder=zorder,
            gid=dot.gid,
        )
    )


def _face(face, panel, zorder):
    if face.normal is not None and panel.camera.depth(face.normal) < 1e-6:
        return
    flat = panel.camera.flat(face.points)
    if face.outline:
        flat = flat[ConvexHull(flat).vertices]
    panel.axes.add_artist(
        Polygon(
            flat,
            closed=True,
            facecolor=face.fill,
            edgecolor=face.edge,
            linewidth=0.7,
            alpha=face.alpha,
            joinstyle="round",
            zorder=zorder,
            gid=face.gid,
        )
    )


def _stroke(stroke, panel, zorder):
    flat = panel.camera.flat(stroke.points)
    if stroke.casing:
        panel.axes.add_artist(
            Line2D(
                *flat.T,
                color="white",
                linewidth=stroke.width + 2 * stroke.casing,
                solid_capstyle="butt",
                zorder=zorder - 1e-3,
            )
        )
    shaft = _arrow_head(stroke, flat, panel, zorder) if stroke.head else flat
    panel.axes.add_artist(
        Line2D(
            *shaft.T,
            color=stroke.color,
            linewidth=stroke.width,
            linestyle=stroke.dash,
            solid_capstyle="butt" if stroke.head else "round",
            dash_capstyle="butt",
            solid_joinstyle="round",
            zorder=zorder,
            gid=stroke.gid,
        )
    )


def _arrow_head(stroke, flat, panel, zorder):
    """Draw the head; return the line without the part the head covers."""
    steps = np.linalg.norm(np.diff(flat, axis=0), axis=1)
    along = np.concatenate([[0], np.cumsum(steps)])
    if along[-1] * panel.scale < 0.5:  # seen end on
        return flat
    length = min(stroke.head / panel.scale, 0.7 * along[-1])
    cut = along[-1] - length
    foot = np.array([np.interp(cut, along, flat[:, k]) for k in range(2)])
    half = _side(flat[-1] - foot) * 0.38 * length
    panel.axes.add_artist(
        Polygon(
            [flat[-1], foot + half, foot - half],
            closed=True,
            facecolor=stroke.color,
            edgecolor="none",
            zorder=zorder + 1e-4,
        )
    )
    return np.vstack([flat[along < cut], foot + 0.15 * (flat[-1] - foot)])


def _side(vector):
    """The unit vector to the left of a (2,) one."""
    return np.array([-vector[1], vector[0]]) / np.linalg.norm(vector)
