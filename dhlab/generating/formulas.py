"""The end pose and the Jacobian of an arm as operations.

Rotations are multiplied from the base outwards. A point is carried from the tool inwards, which
takes four multiplications a run instead of nine; from where on the other way is shorter is tried
out and counted.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from ..arm import Arm
from .operations import Number, Operations
from .runs import joint_variables, runs_of, turned

__all__ = ["Formulas", "forward_formulas", "jacobian_formulas"]

ORIGIN = (0.0, 0.0, 0.0)
IDENTITY = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))  # a rotation is its three columns


@dataclass(frozen=True)
class Formulas:
    """``rows`` of a matrix, each entry a Value of ``program`` or a plain number."""

    program: Operations
    rows: tuple[Sequence[Number], ...]

    @property
    def entries(self) -> list[Number]:
        """All entries, row by row."""
        return [entry for row in self.rows for entry in row]

    @property
    def count(self) -> dict[str, int]:
        """Multiplications, additions, sines and cosines, by name."""
        return self.program.count(self.entries)


def forward_formulas(arm: Arm) -> Formulas:
    """The end pose, tool included, with the fewest multiplications and additions of the groupings
    tried.

    Parameters
    ----------
    arm : Arm

    Returns
    -------
    Formulas
        4 rows of 4.

    Examples
    --------
    >>> import dhlab as dh
    >>> forward_formulas(dh.load("ur5e")).count
    {'multiplications': 39, 'additions': 22, 'sines and cosines': 12}
    """
    program = Operations()
    runs = runs_of(arm, program)
    rotations = _rotations(runs)
    ways = [
        tuple(zip(*rotations[-1], _end_point(runs, rotations, cut), strict=True))
        for cut in range(len(runs), -1, -1)
    ]
    found = [Formulas(program, (*rows, (0.0, 0.0, 0.0, 1.0))) for rows in ways]
    return min(found, key=lambda f: f.count["multiplications"] + f.count["additions"])


def _rotations(runs):
    """The rotation of every run's frame in the world, then of the end."""
    found = [IDENTITY]
    for run in runs:
        x, y, z = found[-1]
        c, s = run.cos_sin()
        turn = (_mixed((x, y), (c, s)), _mixed((x, y), (-s, c)), z)
        found.append(tuple(_mixed(turn, column) for column in run.tilt.T.tolist()))
    return found


def _end_point(runs, rotations, cut):
    """The end point: through the runs before ``cut`` it is carried inwards, from there on each
    run's way is turned into the world and added.
    """
    end = ORIGIN
    for run in reversed(runs[:cut]):
        end = _levers(run, end)[0]
    for run, rotation in zip(runs[cut:], rotations[cut:-1], strict=True):
        end = _plus(end, _mixed(rotation, _levers(run, ORIGIN)[0]))
    return end


def _levers(run, beyond):
    """From the frame's origin, and from behind each shift, to a point ``beyond`` (in the next run's
    frame), all in this run's frame.
    """
    tilted = _mixed(run.tilt.T.tolist(), beyond)
    levers = [turned(run.cos_sin(), _plus(run.behind, tilted))]
    for shift in reversed(run.shifts):
        levers.append(_plus(shift, levers[-1]))
    return levers[::-1]


def jacobian_formulas(arm: Arm) -> Formulas:
    """The geometric Jacobian at the end point: a joint's lever is taken in the frame of its run,
    where its axis is z, and only the product of the two is turned into the world.

    Parameters
    ----------
    arm : Arm

    Returns
    -------
    Formulas
        6 rows (v, then ω) of n.

    Examples
    --------
    >>> import dhlab as dh
    >>> jacobian_formulas(dh.load("ur5e")).count
    {'multiplications': 34, 'additions': 15, 'sines and cosines': 10}
    """
    program = Operations()
    runs = runs_of(arm, program)
    columns, end = {}, ORIGIN
    for run, rotation in reversed(list(zip(runs, _rotations(runs)[:-1], strict=True))):
        levers = _levers(run, end)
        for i, up, k in run.joints:
            columns[i] = _column(rotation, up, levers[k], arm.table.prismatic[i])
        end = levers[0]
    per_joint = [columns[i] for i in range(len(arm))]
    matrix, _ = joint_variables(arm)
    per_q = [_mixed(per_joint, weights) for weights in matrix.T.tolist()]
    return Formulas(program, tuple(zip(*per_q, strict=True)))


def _column(rotation, up, lever, slides):
    """Siciliano et al., Robotics, eq. 3.30: z x lever over z, or z over 0 for a prismatic joint."""
    axis = tuple(up * entry for entry in rotation[2])
    if slides:
        return (*axis, *ORIGIN)
    x, y, _ = lever
    return (*_mixed(rotation[:2], (-up * y, up * x)), *axis)


def _plus(v, w):
    return tuple(a + b for a, b in zip(v, w, strict=True))


def _mixed(columns, weights):
    """The sum of columns, each times its weight."""
    total = (0.0,) * len(columns[0])
    for column, weight in zip(columns, weights, strict=True):
        total = _plus(total, tuple(weight * entry for entry in column))
    return total
