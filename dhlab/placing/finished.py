"""Frames that are all placed, as an arm: the table, and what base and tool take up."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..geometry.lines import angle_about
from ..geometry.procedure.frames import PlacedArm
from ..geometry.procedure.normals import no_dust, tidy
from ..table import DHTable
from ..transform import inverse

if TYPE_CHECKING:
    from .board import Placement

__all__ = ["pose", "placed_arm"]


def pose(
    x: NDArray[np.float64], z: NDArray[np.float64], o: NDArray[np.float64]
) -> NDArray[np.float64]:
    """The frame with these axes x and z (3,) at o (3,)."""
    T = np.eye(4)
    T[:3, 0], T[:3, 1], T[:3, 2], T[:3, 3] = x, np.cross(z, x), z, o
    return T


def _clean(T, reach):
    """A pose without the dust of rounding, as assign_frames leaves frame 0."""
    dust = 4 * np.finfo(float).eps * max(1.0, reach)
    return np.where(abs(T - np.round(T)) < dust, np.round(T), T) + 0.0


def placed_arm(board: Placement) -> PlacedArm:
    """The arm of a board on which every frame is placed."""
    n, frames = len(board), board.frames
    theta, d, a, alpha = np.array([_row(board, k) for k in range(1, n + 1)]).T
    letters = "".join(axis.letter for axis in board.axes[:n])
    of_joint = range(n) if board.standard else range(1, n + 1)
    signs = [np.sign(board.z[i] @ axis.z) for i, axis in zip(of_joint, board.axes)]
    return PlacedArm(
        DHTable(board.convention, theta, d, a, alpha, letters),
        base=_clean(frames[0], board.reach),
        tool=_clean(inverse(frames[n]) @ board.end, board.reach),
        sign=np.array(signs),
        steps=board.steps,
    )


def _row(board, k):
    """theta_k, d_k and this row's a and alpha; in the two conventions a row's moves are made about
    other axes, that is all.
    """
    z, x, o = board.z, board.x, board.o
    along_z, along_x = (z[k - 1], x[k]) if board.standard else (z[k], x[k - 1])
    way = o[k] - o[k - 1]
    return (
        tidy(angle_about(along_z, x[k - 1], x[k])),
        no_dust(way @ along_z, board.reach),
        no_dust(way @ along_x, board.reach),
        tidy(angle_about(along_x, z[k - 1], z[k])),
    )
