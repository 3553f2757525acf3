"""What a frame on a board looks at: the line that it stands on and the other line that its x must
meet; what must be placed before it, and what is open then.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..geometry.lines import nearest_on, tilt
from ..geometry.procedure.normals import ROUNDING
from .geometry import LENGTH, Geometry, geometry
from .rule_origin import judge_origin

if TYPE_CHECKING:
    from .board import Placement

__all__ = ["comes_first", "on_next_line", "open_for"]


def comes_first(board: Placement, i: int, part: str = "") -> str:
    """The step that must come before this one of frame i, or "": z before the origin before x, and
    the other line before both.
    """
    if i not in board.z and (part or _line(board, i) is None):
        return f"z{i}"
    j = _other(board, i)
    if j is not None and _line(board, j) is None and not (j in board.z and j in board.o):
        return f"o{j}" if j in board.z else f"z{j}"
    return f"o{i}" if part == "x" and i not in board.o else ""


def open_for(board: Placement, i: int, o: NDArray[np.float64] | None = None) -> Geometry:
    """What is open for frame i, whose origin ``o`` is once it is placed."""
    j, line = _other(board, i), _line(board, i)
    other = None if j is None else _line(board, j) or (board.o[j], board.z[j])
    z = board.z[i] if line is None else line[1]
    anchor = None if j is None else board.o.get(j)
    return geometry(i, (f"z{i}", f"z{j}"), board.reach, z, line, other, anchor=anchor, o=o)


def on_next_line(board: Placement, i: int, o: NDArray[np.float64]) -> NDArray[np.float64]:
    """The origin of a sliding joint, moved onto the line of the next z where the two are so near
    that one line is meant.
    """
    j = i + 1 if board.standard else i - 1
    line = _line(board, j) if _line(board, i) is None and 0 <= j <= len(board) else None
    if line is None or tilt(line[1], board.z[i]) > ROUNDING:
        return o
    p, z = line
    on = nearest_on(p, z, o)
    reached = judge_origin(open_for(board, i), on)[1]
    gap = np.zeros(3) if reached is None else reached - on
    if abs(z @ gap) > ROUNDING * board.reach:
        # one row reaches another point of the line, a little further along it
        on = on + z * (gap @ gap) / (z @ gap)
    return on if reached is not None and np.linalg.norm(on - o) <= LENGTH * board.reach else o


def _line(board, i):
    """The line of z_i, or None while only its direction is settled."""
    k = board.joint(i)
    if k and board.axes[k - 1].letter == "R":
        return board.axes[k - 1].p, board.z.get(i, board.axes[k - 1].z)
    point = board.points.get(i)
    return None if point is None else (point, board.z[i])


def _other(board, i):
    """The frame whose z line x_i must meet, or None at the free end of the chain."""
    j = i - 1 if board.standard else i + 1
    return j if 0 <= j <= len(board) else None
