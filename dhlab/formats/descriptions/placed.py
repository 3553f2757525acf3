"""Joint axes out of a robot description made an arm, where rounded angles keep axes from being
parallel.
"""

from __future__ import annotations

import warnings
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.spatial.transform import Rotation

from ...printing import number

if TYPE_CHECKING:
    from ...geometry.procedure.frames import PlacedArm

__all__ = ["placed_arm"]

CHEAP = 1e-4  # m; so much at the end may a table cost that people can read
RUNAWAY = 10.0  # × the size of the arm; a longer d is no length of the arm
LARGEST = 0.05  # rad; what is tilted more is not meant to be parallel
SAMPLES = 200


def placed_arm(
    path: str | Path, axes: list[Any], end: Any, parallel: float | None, **given: Any
) -> PlacedArm:
    """:func:`dhlab.assign_frames`, with axes that are all but parallel taken as parallel where that
    costs next to nothing; warns of it with the file's name, three calls up.
    """
    from ...geometry.procedure.frames import NearlyParallelWarning, assign_frames

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", NearlyParallelWarning)
        exact = assign_frames(axes, end=end, parallel=parallel or None, **given)
        said = exact.warnings
        far = float(np.abs(exact.table.d).max())
        if parallel is None and far > RUNAWAY * _size(axes, end):
            readable = _readable(axes, end, given)
            if readable is not None:
                angle, (cost, turn), arm = readable
                costs = f"costs up to {cost * 1e3:.2g} mm and {np.rad2deg(turn):.2g}° at the end"
                if cost <= CHEAP:
                    exact, said = arm, (_taken(angle, costs, far),)
                else:
                    said = (
                        *said,
                        f"taken as parallel (--parallel {_small(angle)}) they give a table without"
                        f" such lengths, which {costs}; --hayati prints numbers that are exact and"
                        " small.",
                    )
    for sentence in said:
        warnings.warn(f"{path}: {sentence}", NearlyParallelWarning, stacklevel=3)
    return exact


def _taken(angle, costs, far):
    return (
        f"axes within {_small(angle)} rad of parallel were taken as parallel, which {costs}; the"
        f" exact table (--parallel 0) has lengths of {number(far, 1)} m."
    )


def _size(axes, end):
    """About how large the arm is: how far the axes pass from the end."""
    points = [p for p, _, letter in axes if letter == "R"] or [np.zeros(3)]
    return max(1e-3, *(float(np.linalg.norm(p - end[:3, 3])) for p in points))


def _readable(axes, end, given):
    """The smallest tolerance that brings the lengths down, what it costs (m, rad), and the arm."""
    from ...geometry.lines import tilt, unit
    from ...geometry.procedure.frames import assign_frames

    z = [unit(np.asarray(direction, float)) for _, direction, _ in axes]
    tilts = sorted({t for a, b in pairwise(z) if 0 < (t := tilt(a, b)) < LARGEST})
    exact = assign_frames(axes, end=end, **given)
    for t in tilts:
        angle = 1.01 * t
        arm = assign_frames(axes, end=end, parallel=angle, **given)
        if np.abs(arm.table.d).max() <= RUNAWAY * _size(axes, end):
            return angle, _cost(exact, arm), arm
    return None


def _cost(exact, arm):
    """How far the ends are apart and turned against one another at most (m, rad)."""
    q = np.random.default_rng(0).uniform(-np.pi, np.pi, (SAMPLES, len(arm)))
    q = np.where(arm.table.prismatic, 0.1 * q, q)
    T, U = exact.forward(q), arm.forward(q)
    turn = Rotation.from_matrix(np.swapaxes(T[:, :3, :3], 1, 2) @ U[:, :3, :3]).magnitude()
    return float(np.linalg.norm((T - U)[:, :3, 3], axis=1).max()), float(turn.max())


def _small(angle):
    """The next larger number of one digit."""
    step = 10.0 ** np.floor(np.log10(angle))
    return f"{np.ceil(angle / step) * step:.1g}"
