"""A calibrated table made readable: nearly parallel axes parallel, angles and lengths rounded; and
what that costs at the end.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from ..arm import Arm
from ..table import DHTable
from .canonical import joint_axes
from .conversion import as_arm, require_uncoupled
from .procedure.frames import NearlyParallelWarning, assign_frames

__all__ = ["Tidied", "tidied"]

PARALLEL = 0.02  # rad; what a calibration tilts is a tenth of it
ROUND_ANGLE = np.deg2rad(1.0)  # an angle this near to a multiple of 90° becomes it
SMALL = 1e-3  # m; a shorter length becomes 0
STEP_ANGLE, STEP_LENGTH = np.deg2rad(0.1), 1e-4  # what the other numbers are rounded to
RUNAWAY = 10.0  # × the size of the arm
SAMPLES = 200


@dataclass(frozen=True)
class Tidied:
    """``arm`` with a table that people can read; ``shift`` (m) and ``turn`` (rad), by how much its
    end is off at most, over random configurations."""

    arm: Arm
    shift: float
    turn: float


def tidied(arm: Arm | DHTable) -> Tidied:
    """A calibrated table made readable; the arm is another one afterwards, by what is told.

    Axes within 1.1° of parallel become parallel, which takes lengths of kilometres out of the
    table; angles within 1° of a multiple of 90° become it, other angles are rounded to 0.1°;
    lengths below 1 mm become 0, others are rounded to 0.1 mm. Base and tool stay.

    Parameters
    ----------
    arm : Arm or DHTable

    Returns
    -------
    Tidied

    Raises
    ------
    ValueError
        No arm, or coupled joints.

    Examples
    --------
    >>> import dhlab as dh
    >>> rows = dh.load("article-6r").table.rows + 4e-4
    >>> found = tidied(dh.DHTable.standard(rows, angle="rad"))
    >>> print(found.arm.table)
    standard DH, 6 joints (lengths in m, angles in deg)
     i  theta  d       a       alpha
     1  q1     0.1004  0       90
     2  q2     0       0.4004  0
     3  q3     0       0.3504  0
     4  q4     0.1012  0       90
     5  q5     0       0       -90
     6  q6     0.1004  0       0
    >>> found.shift < 0.005
    True
    """
    given = as_arm(arm, "tidied")
    require_uncoupled(given, "tidied")
    new = _replaced(given) if _nearly_parallel(given) else given
    table = new.table
    tidy = DHTable(
        table.convention,
        _angles(table.theta),
        _lengths(table.d),
        _lengths(table.a),
        _angles(table.alpha),
        table.joints,
    )
    made = Arm(
        tidy,
        base=new.base,
        tool=new.tool,
        limits=given.limits,
        sign=new.sign,
        name=given.name,
        source=given.source,
    )
    return Tidied(made, *_cost(given, made))


def _nearly_parallel(arm):
    """Whether two neighbouring axes are nearly, but not quite, parallel."""
    z = joint_axes(arm).z
    sines = np.linalg.norm(np.cross(z[:-1], z[1:]), axis=1)
    return bool(((sines > 1e-9) & (sines < PARALLEL)).any())


def _replaced(arm):
    """The arm with its frames placed anew, nearly parallel axes taken as parallel, z and x as they
    were where both stand alike.
    """
    A = joint_axes(arm)
    axes = [(p, z, letter) for p, z, letter in zip(A.p, A.z, A.letters)]
    before = arm.frames(np.zeros(len(arm)))[:, :3, 0]
    z_signs = {k: -1 for k, sign in enumerate(arm.sign, 1) if sign < 0}
    convention = arm.table.convention

    def placed(x_signs):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", NearlyParallelWarning)
            return assign_frames(
                axes,
                end=A.end,
                convention=convention,
                x_signs=x_signs,
                z_signs=z_signs,
                parallel=PARALLEL,
            )

    first = placed(None)
    now = first.frames(np.zeros(len(arm)))[:, :3, 0]
    turned = {i: -1 for i in range(len(arm) + 1) if before[i] @ now[i] < -0.7}
    return placed(turned) if turned else first


def _angles(values):
    quarter = np.pi / 2
    near = np.round(values / quarter) * quarter
    rest = np.deg2rad(np.round(np.rad2deg(values) / 0.1) * 0.1)
    return np.where(abs(values - near) < ROUND_ANGLE, near, np.round(rest, 12))


def _lengths(values):
    return np.where(abs(values) < SMALL, 0.0, np.round(values / STEP_LENGTH) * STEP_LENGTH)


def _cost(a, b):
    q = np.random.default_rng(0).uniform(-np.pi, np.pi, (SAMPLES, len(a)))
    q = np.where(a.table.prismatic, 0.1 * q, q)
    T, U = a.forward(q), b.forward(q)
    turn = Rotation.from_matrix(np.swapaxes(T[:, :3, :3], 1, 2) @ U[:, :3, :3]).magnitude()
    return float(np.linalg.norm((T - U)[:, :3, 3], axis=1).max()), float(turn.max())
