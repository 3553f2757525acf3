"""Wrong answers as pictures: what a learner placed, wrote as a table, a row or a pose, beside the
joint axes it was meant for; the first thing that does not fit is marked, and the right one is not
drawn.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....arm import Arm
from ....geometry.equivalence import equivalent
from ....geometry.lines import nearest_on, tilt
from ....placing.board import Placement
from ....placing.words import ANGLE, Judgement, vector
from ....table import DHTable

__all__ = ["drawn_frames", "drawn_pose", "drawn_row", "drawn_table"]

SAME = 1e-6  # rad, m


def drawn_frames(task: Placement, wrong: Judgement, given: Any) -> Any:
    """A board with what was right on it, and the first step that was not, ``given``; a Picture, or
    None where that is no arrow and no point.
    """
    from ....view.pictures.tried import tried

    letter, i, value = wrong.step[0], int(wrong.step[1:]), vector(given)
    if value is None or (letter != "o" and not np.linalg.norm(value) > 0):
        return None
    frames: dict[str, dict[str, NDArray[np.float64]]] = {}
    for part, placed in (("z", task.z), ("o", task.o), ("x", task.x)):
        for k, v in placed.items():
            frames.setdefault(str(k), {})[part] = v
    frames.setdefault(str(i), {})[letter] = (
        value if letter == "o" else value / np.linalg.norm(value)
    )
    for k in map(int, frames):
        joint = task.joint(k)
        frames[str(k)]["at"] = task.axes[joint - 1].p if joint else task.end[:3, 3] * (k > 0)
    lines = [(axis.p, axis.z, axis.letter) for axis in task.axes[: len(task)]]
    return tried(lines, dict(sorted(frames.items(), key=lambda item: int(item[0]))), wrong.step)


def drawn_table(arm: Arm, right: Arm) -> Any:
    """The frames of a table at q = 0, up to the first joint whose axis is not where the right arm
    has it; a Picture, or None.
    """
    from ....view.explorer.placing import axes_of
    from ....view.pictures.tried import tried

    if arm.coupling is not None or right.coupling is not None:
        return None
    lines, chain = axes_of(right)[0], arm.frames(np.zeros(len(arm)))
    title = "Your table's frames at q = 0, beside the joint axes"
    joint = equivalent(right, arm).joint
    if not joint:  # every axis is where it must be, only the end is not
        end = arm.forward(np.zeros(len(arm)))
        mark = _apart(end, right.forward(np.zeros(len(arm)))) + "the end"
        return tried(lines, {"the end": _parts(end)}, mark, title=title)
    i = joint - (arm.table.convention == "standard")
    frames = {str(k): _parts(T) for k, T in enumerate(chain[: i + 1])}
    return tried(lines, frames, f"{_misses(lines[joint - 1], chain[i])}{i}", title=title)


def drawn_row(row: NDArray[np.float64], right: NDArray[np.float64]) -> Any:
    """The frame {1} of a row (4,) of degrees and metres, standard, beside the two axes that the
    right row lies between; a Picture, or None where the two make the same frame.
    """
    from ....view.pictures.tried import tried

    mine, asked = (
        Arm(DHTable.standard(one[None], angle="deg")).forward([0.0]) for one in (row, right)
    )
    p, z = asked[:3, 3], asked[:3, 2]
    if tilt(mine[:3, 2], z) > ANGLE:
        mark = "z1"
    elif np.linalg.norm(mine[:3, 3] - nearest_on(p, z, mine[:3, 3])) > SAME:
        mark = "o1"
    elif np.allclose(mine, asked, atol=SAME):
        return None
    else:
        mark = f"{_apart(mine, asked)}1"
    # the housing of the second axis stands away from the right origin, which is not shown
    aside = p + 0.5 * (abs(right[1]) + abs(right[2])) * z
    lines = [(np.zeros(3), np.array([0, 0, 1.0]), "R"), (aside, z, "R")]
    frames = {"0": _parts(np.eye(4)), "1": _parts(mine)}
    return tried(lines, frames, mark, title="Your row's frame {1}, beside the two axes")


def _apart(end, right):
    """The first of an end's origin, z and x that is not the right one's."""
    if np.linalg.norm(end[:3, 3] - right[:3, 3]) > SAME:
        return "o"
    return "z" if np.linalg.norm(end[:3, 2] - right[:3, 2]) > SAME else "x"


def _misses(line, T):
    """What of a frame does not fit an axis: its z, or where it stands."""
    p, z, letter = line
    beside = letter == "R" and np.linalg.norm(T[:3, 3] - nearest_on(p, z, T[:3, 3])) > SAME
    return "o" if tilt(T[:3, 2], z) <= ANGLE and beside else "z"


def drawn_pose(pose: NDArray[np.float64], off: NDArray[np.bool_]) -> Any:
    """A pose (4, 4) beside the base's frame; ``off`` says which entries do not fit. A Picture, or
    None where three of its columns are no arrows that could be drawn.
    """
    from ....view.pictures.tried import tried

    columns = np.flatnonzero(off[:3].any(axis=0))
    lengths = np.linalg.norm(pose[:3, :3], axis=0)
    if not len(columns) or not np.isfinite(pose).all() or np.any(abs(lengths - 1) > 0.5):
        return None
    frames = {"0": _parts(np.eye(4)), "your pose": _parts(pose)}
    frames["your pose"]["y"] = pose[:3, 1]
    return tried([], frames, f"{'xyzo'[columns[0]]}your pose", title="Your pose, beside frame {0}")


def _parts(T: Sequence[Any] | NDArray[np.float64]) -> dict[str, NDArray[np.float64]]:
    T = np.asarray(T, dtype=float)
    return {"x": T[:3, 0], "z": T[:3, 2], "o": T[:3, 3]}
