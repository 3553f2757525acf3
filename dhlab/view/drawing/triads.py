"""Frames as three lettered arrows; frames that share an origin or an axis share the label."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from .scene import Dot, Label, Scene, Stroke
from .style import AXES, INK, SIZES, axis_name

__all__ = ["add_triads", "coincident", "NEAR"]

NEAR = 1e-6  # metres; closer origins are one point to every eye
PARALLEL = 1 - 1e-6


def coincident(points: NDArray[np.float64]) -> list[list[int]]:
    """Indices of points (k, 3) in groups that share a place, in order.

    Examples
    --------
    >>> coincident([[0, 0, 0], [1, 0, 0], [0, 0, 0]])
    [[0, 2], [1]]
    """
    groups: list[list[int]] = []
    for k, point in enumerate(np.asarray(points, dtype=float)):
        for group in groups:
            if np.linalg.norm(points[group[0]] - point) < NEAR:
                group.append(k)
                break
        else:
            groups.append([k])
    return groups


def add_triads(
    scene: Scene,
    poses: NDArray[np.float64],
    names: Sequence[str],
    length: float,
    *,
    titles: Sequence[str] | None = None,
    subscripts: bool = True,
) -> None:
    """Add one triad per pose to a scene.

    Parameters
    ----------
    scene : Scene
    poses : array (k, 4, 4)
    names : list of str
        Subscripts of the axes' letters.
    length : float
        Metres; the later of two frames at one origin is a little larger, so that both are seen.
    titles : list of str, optional
        What stands at the origins; "{name}" when left out.
    subscripts : bool
        Write x, y, z alone when false.
    """
    titles = titles or [f"{{{name}}}" for name in names]
    for group in coincident(poses[:, :3, 3]):
        lengths = {k: length * (1 + 0.3 * rank) for rank, k in enumerate(group)}
        for k in reversed(group):  # the longer ones below
            _add_axes(scene, poses[k], names[k], lengths[k])
        for letters, tip, axis, color in _axis_labels(poses, names, group, lengths, subscripts):
            scene.add(
                Label(
                    tip,
                    letters,
                    axis,
                    color,
                    SIZES["axis"],
                    math=True,
                    root=poses[group[0], :3, 3],
                    gid="axis-label",
                )
            )
        origin = poses[group[0], :3, 3]
        away = -poses[group, :3, :3].sum(axis=(0, 2))
        scene.add(
            Dot(origin, 5.0, layer="mark"),
            Label(
                origin, ", ".join(titles[k] for k in group), away, INK, far=True, gid="frame-label"
            ),
        )


def _add_axes(scene, pose, name, length):
    for style, axis in zip(AXES, pose[:3, :3].T):
        ends = np.array([pose[:3, 3], pose[:3, 3] + length * axis])
        scene.add(
            Stroke(
                ends,
                style.color,
                style.width,
                style.dash,
                "frame",
                head=4.5 + 1.5 * style.width,
                casing=0.6,
                gid=f"{style.letter}-axis:{name}",
            )
        )


def _axis_labels(poses, names, group, lengths, subscripts):
    """Axes of one group that lie on each other get one label, at the longest: (letters, tip, axis,
    colour), in ink where the colours differ.
    """
    entries = [(k, style, axis) for k in group for style, axis in zip(AXES, poses[k, :3, :3].T)]
    while entries:
        _, _, first = entries[0]
        together = [entry for entry in entries if entry[2] @ first > PARALLEL]
        entries = [entry for entry in entries if entry[2] @ first <= PARALLEL]
        letters = dict.fromkeys(
            axis_name(style.letter, names[k]) if subscripts else style.letter
            for k, style, _ in together
        )
        tip = poses[group[0], :3, 3] + max(lengths[k] for k, _, _ in together) * first
        colors = {style.color for _, style, _ in together}
        # x on another frame's z is neither's colour
        yield (",\\,".join(letters), tip, first, colors.pop() if len(colors) == 1 else INK)
