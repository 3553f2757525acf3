"""The ground an arm stands on: a light grid with metres on its edges, an upright scale, and the
arm's shadow.
"""

import numpy as np
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from ...printing import number
from .camera import Camera
from .scene import Dot, Label, Scene, Stroke
from .style import FLOOR, QUIET, SHADOW, SIZES

__all__ = ["add_floor", "add_wall", "add_shadow", "add_drops", "floor_height"]

FLOOR_TICKS, WALL_TICKS = 7, 5  # a side view is smaller, and its numbers stand side by side


def floor_height(points: NDArray[np.float64]) -> float:
    """Where the floor lies under points (k, 3): at 0 when they stand on it or a little above, else
    at the lowest.
    """
    low, high = np.min(points, axis=0)[2], np.max(points, axis=0)[2]
    size = np.ptp(points, axis=0).max()
    return 0.0 if low + 0.02 * size >= -1e-9 and low <= max(high - low, 0.5 * size) else low


def add_floor(scene: Scene, camera: Camera, z: float) -> None:
    """Add grid, ticks and the names of the axes, large enough for all that the scene holds so far.

    Parameters
    ----------
    scene : Scene
    camera : Camera
        From the front right, as :func:`dhlab.view.drawing.camera.orbit` has it: ticks stand on the
        edges it sees first.
    z : float
        The floor's height, metres.
    """
    low, high, ticks = _room(scene, (0, 1), FLOOR_TICKS)
    low[2], ticks[2] = z, ticks[2][ticks[2] >= z - 1e-9]
    _add_grid(scene, low, high, ticks, 0, 1)
    _add_scale(scene, camera, 0, low, high, ticks[0], np.array([0, -1.0, 0]))
    _add_scale(
        scene, camera, 1, np.array([high[0], low[1], z]), high, ticks[1], np.array([1.0, 0, 0])
    )
    _add_scale(scene, camera, 2, low, high, ticks[2], -camera.right, camera.up)


def add_wall(scene: Scene, camera: Camera, plane: str) -> None:
    """Add grid, ticks and names of a view that sees the two world axes of ``plane`` ("x-z") in
    their true length.
    """
    i, j = "xyz".index(plane[0]), "xyz".index(plane[2])
    low, high, ticks = _room(scene, (i, j), WALL_TICKS)
    _add_grid(scene, low, high, ticks, i, j)
    _add_scale(scene, camera, i, low, high, ticks[i], -np.eye(3)[j])
    _add_scale(scene, camera, j, low, high, ticks[j], -np.eye(3)[i], np.eye(3)[j])


def _room(scene, padded, count):
    """The corners (3,) of what the scene holds, wider along the padded axes, and the round numbers
    between them.
    """
    points = scene.points()
    low, high = points.min(axis=0), points.max(axis=0)
    size = (high - low).max()
    for k in padded:
        low[k], high[k] = low[k] - 0.07 * size, high[k] + 0.07 * size
    steps = [
        np.diff(MaxNLocator(finer * count, steps=[1, 2, 5, 10]).tick_values(0, size))[0]
        for finer in (1, 2, 4)
    ]
    return low, high, [_ticks(a, b, steps) for a, b in zip(low, high)]


def _ticks(low, high, steps):
    """Multiples of the first step from low to high; of the next where there would be a single
    one.
    """
    for step in steps:
        ticks = np.arange(np.ceil(low / step - 1e-9), np.floor(high / step + 1e-9) + 1) * step
        if len(ticks) > 1:
            break
    return ticks


def _add_grid(scene, low, high, ticks, i, j):
    for k, across in ((i, j), (j, i)):
        for value in [low[k], *ticks[k], high[k]]:
            line = np.array([low, low])
            line[:, k], line[1, across] = value, high[across]
            scene.add(Stroke(line, FLOOR, 0.7, layer="floor", gid="floor"))


def _add_scale(scene, camera, k, corner, high, ticks, out, end=None):
    """The edge along axis k from a corner, numbers on its side ``out``, its name at its middle or
    past its end in direction ``end``.
    """
    edge = np.array([corner, corner])
    edge[1, k] = high[k]
    scene.add(Stroke(edge, QUIET, 0.9, layer="floor", gid=f"{'xyz'[k]}-scale"))
    for tick in ticks:
        point = corner.copy()
        point[k] = tick
        scene.add(
            Label(
                point,
                number(tick).replace("-", "−"),
                out,
                QUIET,
                SIZES["tick"],
                fixed=4.0,
                gid=f"{'xyz'[k]}-tick",
            )
        )
    place, toward, gap = (
        (edge.mean(axis=0), out, _beyond(camera.flat(out), ticks))
        if end is None
        else (edge[1], end, 4.0)
    )
    scene.add(
        Label(
            place,
            f"{'xyz'[k]} (m)",
            toward,
            QUIET,
            SIZES["tick"],
            fixed=gap,
            gid=f"{'xyz'[k]}-unit",
        )
    )


def _beyond(out, ticks):
    """How far from the edge, in page points, a text is clear of the numbers there; ``out`` (2,) is
    the way, on the picture.
    """
    letters = max((len(number(tick)) for tick in ticks), default=0)
    return 6.0 + np.abs(out) / np.linalg.norm(out) @ np.array(
        [0.62 * SIZES["tick"] * letters, 1.2 * SIZES["tick"]]
    )


def add_shadow(scene: Scene, path: NDArray[np.float64], z: float, width: float = 5.0) -> None:
    """Add what a light from straight above would show of a path (k, 3): it tells near from far."""
    flat = np.array(path)
    flat[:, 2] = z
    scene.add(Stroke(flat, SHADOW, width, layer="shadow", gid="shadow"))


def add_drops(scene: Scene, points: NDArray[np.float64], z: float) -> None:
    """Add plumb lines from points (k, 3) to the floor."""
    for point in points:
        foot = np.array([point[0], point[1], z])
        scene.add(
            Stroke(np.array([point, foot]), QUIET, 0.8, (0, (1, 2)), "shadow", gid="drop"),
            Dot(foot, 3.0, QUIET, "shadow"),
        )
