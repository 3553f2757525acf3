"""Where one looks from. The projection is orthographic: parallel axes stay parallel and equal
lengths equal, which kinematics needs.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Camera", "orbit", "best_orbit", "clearest_side", "PLANES", "widest_plane"]


@dataclass(frozen=True)
class Camera:
    """``right`` and ``up`` of the picture and the direction ``toward`` the viewer, unit vectors
    (3,) in the world.
    """

    right: NDArray[np.float64]
    up: NDArray[np.float64]
    toward: NDArray[np.float64]

    def flat(self, points: ArrayLike) -> NDArray[np.float64]:
        """Points (..., 3) on the picture: (..., 2), in metres; one scale for all directions."""
        return np.asarray(points, dtype=float) @ np.column_stack([self.right, self.up])

    def depth(self, points: ArrayLike) -> NDArray[np.float64]:
        """How near (..., 3) points are to the viewer; larger is nearer."""
        return np.asarray(points, dtype=float) @ self.toward


def orbit(elevation: float = 24.0, azimuth: float = -58.0) -> Camera:
    """A camera at these angles, degrees, as mplot3d counts them: x to the right, y away, z up."""
    e, a = np.deg2rad([elevation, azimuth])
    toward = np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])
    right = np.array([-np.sin(a), np.cos(a), 0.0])
    return Camera(right, np.cross(toward, right), toward)


def best_orbit(directions: NDArray[np.float64]) -> Camera:
    """The camera near the usual one from which these directions (k, 3) are long on the picture and
    far from each other.
    """
    directions = np.unique(np.round(directions, 6), axis=0)
    cameras = [orbit(e, a) for a in range(-60, 91, 10) for e in (24, 34, 16)]
    cameras += [orbit(e, a) for a in range(-70, -151, -10) for e in (24, 34, 16)]
    return max(cameras, key=lambda camera: _clarity(camera.flat(directions)))


def _clarity(tips):
    """The smallest gap between any two arrow tips, the arrows' common root included; what exceeds
    0.45 is clear enough.
    """
    tips = np.vstack([np.zeros(2), tips])
    gaps = np.linalg.norm(tips[:, None] - tips[None], axis=-1)
    return min(0.45, gaps[np.triu_indices(len(tips), 1)].min())


def clearest_side(
    camera: Camera,
    line: NDArray[np.float64],
    sides: NDArray[np.float64],
    obstacles: NDArray[np.float64],
) -> NDArray[np.float64]:
    """The shift out of ``sides`` (k, 3) that takes a line (m, 3) furthest from the obstacles (j, 3)
    on the picture; far shifts count less.
    """
    reach = np.linalg.norm(sides, axis=-1).max()
    obstacles = camera.flat(obstacles)

    def room(side):
        moved = camera.flat(line + side)
        gaps = np.linalg.norm(moved[:, None] - obstacles[None], axis=-1).min(axis=1)
        return np.minimum(gaps, reach).mean() + gaps.min() - 0.35 * np.linalg.norm(side)

    return max(sides, key=room)


PLANES = {
    "x-z": Camera(*np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]])),
    "y-z": Camera(*np.array([[0.0, 1, 0], [0, 0, 1], [1, 0, 0]])),
    "x-y": Camera(*np.array([[1.0, 0, 0], [0, 1, 0], [0, 0, 1]])),
}


def widest_plane(points: NDArray[np.float64]) -> str:
    """The name of the plane of two world axes over which points (k, 3) spread most; x-z when in
    doubt.

    Examples
    --------
    >>> widest_plane([[0, 0, 0], [0.1, 0.5, 0.4]])
    'y-z'
    """
    spread = np.ptp(np.asarray(points, dtype=float), axis=0)
    areas = {
        name: np.prod(camera.flat(spread) + 0.1 * spread.max()) for name, camera in PLANES.items()
    }
    best = max(areas.values())
    return next(name for name, area in areas.items() if area >= best * (1 - 1e-6))
