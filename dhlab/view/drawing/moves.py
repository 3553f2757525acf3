"""The four moves of one row of a table as things to draw: theta and alpha are arcs, d and a are
measured lengths.
"""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ... import transform
from ...printing import number
from ...table import DHTable
from .camera import Camera, clearest_side
from .scene import Face, Label, Scene, Stroke
from .style import AXES, INK, QUIET, SIZES

__all__ = ["Move", "moves_of", "add_move", "add_link_and_axes"]

NOTHING = 1e-9  # radians or metres; a smaller parameter is 0 and not drawn
MATRICES = {
    "theta": transform.rot_z,
    "d": transform.trans_z,
    "a": transform.trans_x,
    "alpha": transform.rot_x,
}
ORDERS = {"standard": ("theta", "d", "a", "alpha"), "craig": ("alpha", "a", "theta", "d")}


@dataclass(frozen=True)
class Move:
    """One parameter: ``start`` and ``end`` are the frames (4, 4) before and after it, ``row`` its
    index, ``axis`` the index it turns about.
    """

    kind: str
    value: float
    start: NDArray[np.float64]
    end: NDArray[np.float64]
    row: int
    axis: int

    @property
    def is_turn(self) -> bool:
        return self.kind in ("theta", "alpha")

    @property
    def is_nothing(self) -> bool:
        return abs(self.value) < NOTHING

    @property
    def letter(self) -> str:
        """The axis about or along which it is measured."""
        return "z" if self.kind in ("theta", "d") else "x"

    @property
    def direction(self) -> NDArray[np.float64]:
        """That axis (3,); the move leaves it where it is."""
        return self.start[:3, 2 if self.letter == "z" else 0]

    @property
    def amount(self) -> str:
        """The value as a person writes it."""
        return (
            f"{number(np.rad2deg(self.value), 4)}°"
            if self.is_turn
            else f"{number(self.value, 4)} m"
        )


def moves_of(table: DHTable, i: int, q: float) -> list[Move]:
    """The four moves of row i (1-based) in the order of its convention, from frame {i-1} at the
    world's origin.
    """
    values = dict(zip(("theta", "d", "a", "alpha"), table.rows[i - 1]))
    values["d" if table.joints[i - 1] == "P" else "theta"] += q
    moves, pose = [], np.eye(4)
    for kind in ORDERS[table.convention]:
        after = pose @ MATRICES[kind](values[kind])
        later = kind in ORDERS[table.convention][2:]
        own = i - 1 if table.convention == "craig" and kind in ("a", "alpha") else i
        moves.append(Move(kind, values[kind], pose, after, own, i if later else i - 1))
        pose = after
    return moves


def add_move(scene: Scene, move: Move, length: float, camera: Camera) -> None:
    """Draw one move; ``length`` is a triad's. A length is put where there is room among what the
    scene holds so far.
    """
    color = AXES["xyz".index(move.letter)].color
    symbol = {"theta": r"\theta", "alpha": r"\alpha"}.get(move.kind, move.kind)
    unit = "°" if move.is_turn else r"\ \mathrm{m}"
    text = rf"{symbol}_{{{move.row}}} = {move.amount.rstrip('°m ')}{unit}"
    anchor, toward = (
        _add_arc(scene, move, length, color)
        if move.is_turn
        else _add_length(scene, move, length, color, camera)
    )
    scene.add(
        Label(anchor, text, toward, color, SIZES["value"], math=True, gid=f"{move.kind}-label")
    )


def _add_arc(scene, move, length, color):
    """The arc from the old direction of the other axis to the new one, with the two rays it lies
    between.
    """
    k = 0 if move.kind == "theta" else 2  # theta turns x, alpha turns z
    origin, old = move.start[:3, 3], move.start[:3, k]
    side = np.cross(move.direction, old)
    radius = 0.62 * length
    angles = np.linspace(0, move.value, max(24, int(abs(move.value) * 40)))[:, None]
    arc = origin + radius * (np.cos(angles) * old + np.sin(angles) * side)
    for end in (old, move.end[:3, k]):
        scene.add(
            Stroke(np.array([origin, origin + 1.05 * length * end]), QUIET, 0.9, (0, (3, 2)), "aid")
        )
    scene.add(
        Face(np.vstack([origin, arc]), color, layer="shadow", alpha=0.13),
        Stroke(arc, color, 1.5, layer="mark", head=8.0, casing=0.5, gid=f"{move.kind}-arc"),
    )
    middle = arc[len(arc) // 2]
    return middle, middle - origin


def _add_length(scene, move, length, color, camera):
    """A measured length beside the link, as on a drawing: two thin lines out, an arrow between
    them; a close to the link, which is no x axis.
    """
    ends = np.array([move.start[:3, 3], move.end[:3, 3]])
    across = [move.start[:3, k] for k in range(3) if k != "xyz".index(move.letter)]
    sides = [
        reach * length * sense * axis
        for axis in across
        for sense in (1, -1)
        for reach in ((0.12, 0.18) if move.kind == "a" else (0.3, 0.45, 0.6))
    ]
    line = ends[0] + np.linspace(0.1, 0.9, 15)[:, None] * (ends[1] - ends[0])
    shift = clearest_side(camera, line, np.array(sides), _samples(scene))
    for end in ends:
        scene.add(Stroke(np.array([end, end + 1.15 * shift]), QUIET, 0.8, layer="aid"))
    scene.add(
        Stroke(
            ends + shift, color, 1.5, layer="mark", head=8.0, casing=0.5, gid=f"{move.kind}-length"
        )
    )
    if move.kind == "a" and np.linalg.norm(camera.flat(ends[1] - ends[0])) > 1.2 * length:
        scene.add(
            Label(
                ends.mean(axis=0), "common normal", -shift, QUIET, SIZES["tick"], gid="normal-label"
            )
        )
    return (ends + shift).mean(axis=0), shift


def _samples(scene):
    """Points (k, 3) along all lines of a scene."""
    lines = [item.points for item in scene.items if isinstance(item, Stroke)]
    steps = np.linspace(0, 1, 20)[:, None]
    return np.vstack(
        [
            start + steps * (end - start)
            for points in lines
            for start, end in itertools.pairwise(points)
        ]
    )


def add_link_and_axes(scene: Scene, moves: Sequence[Move], length: float) -> None:
    """The bent link from {i-1} to {i}, and the lines on which the two z axes lie."""
    path = [move.start[:3, 3] for move in moves] + [moves[-1].end[:3, 3]]
    for start, end in itertools.pairwise(path):
        if np.linalg.norm(end - start) > NOTHING:
            scene.add(Stroke(np.array([start, end]), "#c3c9cf", 6.0, gid="link"))
    for pose in (moves[0].start, moves[-1].end):
        ends = pose[:3, 3] + np.outer([-0.5 * length, 1.5 * length], pose[:3, 2])
        scene.add(Stroke(ends, INK, 0.7, (0, (9, 2, 2, 2)), "shadow", gid="joint-axis"))
