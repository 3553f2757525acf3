"""The arm itself: links as thick lines along the DH path, joints as cylinders and boxes on their
axes.
"""

import itertools

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from .scene import Face, Scene, Stroke
from .style import INK, JOINT, JOINT_CAP, LINK, QUIET
from .triads import coincident

__all__ = ["dh_path", "joint_places", "add_arm", "add_joint", "add_tool"]


def dh_path(convention: str, chain: NDArray[np.float64]) -> NDArray[np.float64]:
    """The way from origin to origin, along d and a, as one path.

    Parameters
    ----------
    convention : "standard" or "craig"
    chain : array (n + 1, 4, 4)
        Frames, the base first.

    Returns
    -------
    array (2 n + 1, 3)
        Origins at the even places; between them the corner, on z_{i-1} (standard) or on x_{i-1}
        (Craig).

    Examples
    --------
    >>> from dhlab.transform import trans
    >>> dh_path("standard", np.array([trans([0, 0, 0]), trans([0.4, 0, 0.1])]))[1]
    array([0. , 0. , 0.1])
    """
    origins = chain[:, :3, 3]
    along = chain[:-1, :3, 2 if convention == "standard" else 0]  # the first of the two moves
    part = np.einsum("ik,ik->i", np.diff(origins, axis=0), along)
    path = np.empty((2 * len(chain) - 1, 3))
    path[::2], path[1::2] = origins, origins[:-1] + part[:, None] * along
    return path


def joint_places(
    convention: str, chain: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Where each joint is drawn, in the middle of its d: centres and axis directions, both (n,
    3).
    """
    path = dh_path(convention, chain)
    if convention == "standard":
        return (path[:-2:2] + path[1::2]) / 2, chain[:-1, :3, 2]
    return (path[1::2] + path[2::2]) / 2, chain[1:, :3, 2]


def add_arm(scene: Scene, arm: Arm, chain: NDArray[np.float64], size: float) -> None:
    """Add links and joints at these frames (n + 1, 4, 4); ``size`` is the arm's spread in
    metres.
    """
    _add_path(scene, dh_path(arm.table.convention, chain), size / 12)
    centres, axes = joint_places(arm.table.convention, chain)
    for group in coincident(centres):
        for rank, k in enumerate(group):
            # joints at one place: ever longer and thinner, so that all are seen
            radius, length = 0.024 * size * 0.78**rank, 0.075 * size * 1.3**rank
            add_joint(
                scene, arm.table.joints[k], centres[k], axes[k], radius, length, f"joint:{k + 1}"
            )


def add_joint(
    scene: Scene,
    letter: str,
    centre: NDArray[np.float64],
    axis: NDArray[np.float64],
    radius: float,
    length: float,
    gid: str,
) -> None:
    """Add one joint: a cylinder for "R", a box for "P"."""
    add = _add_box if letter == "P" else _add_cylinder
    add(scene, centre, axis, radius, length, gid)


def add_tool(scene: Scene, start: NDArray[np.float64], end: NDArray[np.float64]) -> None:
    """Add the line from the last frame to the tool's."""
    scene.add(Stroke(np.array([start, end]), QUIET, 2.2, (0, (2, 1)), "body", gid="tool-line"))


def _add_path(scene, path, longest):
    """Links in short pieces, since a piece is either before or behind a joint."""
    for start, end in itertools.pairwise(path):
        length = np.linalg.norm(end - start)
        if length < 1e-9:
            continue
        stops = np.linspace(0, 1, int(np.ceil(length / longest)) + 1)[:, None]
        points = start + stops * (end - start)
        for piece in itertools.pairwise(points):
            scene.add(Stroke(np.array(piece), LINK, 5.5, casing=1.2, gid="link"))


def _basis(axis):
    """Two unit vectors (3,) that complete ``axis``."""
    side = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    side /= np.linalg.norm(side)
    return side, np.cross(axis, side)


def _add_cylinder(scene, centre, axis, radius, length, gid):
    u, v = _basis(axis)
    angles = np.linspace(0, 2 * np.pi, 36, endpoint=False)[:, None]
    ring = centre + radius * (np.cos(angles) * u + np.sin(angles) * v)
    _add_prism(scene, ring, axis, length, radius, gid)


def _add_box(scene, centre, axis, radius, length, gid):
    u, v = _basis(axis)
    ring = centre + 1.1 * radius * np.array([u + v, v - u, -u - v, u - v])
    _add_prism(scene, ring, axis, length, radius, gid)
    half = axis * length / 2
    for side, start, end in zip((v, -u, -v, u), ring, np.roll(ring, -1, axis=0)):
        corners = np.array([start - half, end - half, end + half, start + half])
        scene.add(Face(corners, JOINT, INK, normal=side, lift=radius))


def _add_prism(scene, ring, axis, length, radius, gid):
    """What is seen of a solid: its outline, and on it the end that faces the viewer."""
    half = axis * length / 2
    scene.add(
        Face(np.vstack([ring - half, ring + half]), JOINT, INK, outline=True, lift=radius, gid=gid)
    )
    for sense in (1, -1):
        scene.add(Face(ring + sense * half, JOINT_CAP, INK, normal=sense * axis, lift=radius))
