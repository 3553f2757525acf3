"""A chain as runs: neighbouring joints on parallel axes turn together, by the sum of their angles,
and a rotation is multiplied out once for all of them.

With ``p_k`` the way through run k and ``S_k`` the constant rotation behind it, the arm is
``Π trans(p_k) Rz(angle_k) S_k``.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from .operations import Number, Operations, tidy

__all__ = ["Run", "Vector", "joint_variables", "runs_of", "turned"]

Vector = tuple[Number, Number, Number]
QUARTER = math.pi / 2
NEAR = 1e-15  # times the angle: what adding offsets in floating point leaves


def joint_variables(arm: Arm) -> tuple[NDArray, NDArray]:
    """What turns the controller's q into joint variables: ``matrix @ q + offset`` is theta_i, or
    d_i of a prismatic joint. The one place that knows of signs, offsets and coupled joints.

    Parameters
    ----------
    arm : Arm

    Returns
    -------
    matrix (n, n), offset (n,) : arrays

    Examples
    --------
    >>> import dhlab as dh
    >>> joint_variables(dh.load("ar4"))[0].diagonal()
    array([-1.,  1.,  1.,  1.,  1.,  1.])
    """
    table = arm.table
    matrix = np.diag(arm.sign) if arm.coupling is None else arm.coupling * arm.sign
    return matrix, np.where(table.prismatic, table.d, table.theta)


class Run:
    """Joints on parallel axes, seen from a frame whose z lies along them.

    ``joints`` holds ``(i, up, k)``: joint i (from 0), the sense of its axis along z (1 or -1), and
    the first of the ``shifts`` that it moves. ``shifts`` are vectors in the run's frame, one after
    the other. Behind them come the turn (:meth:`cos_sin`), then the constants ``behind`` (a vector)
    and ``tilt`` (3, 3).
    """

    def __init__(self, program: Operations, n: int):
        self.program, self.up = program, 1.0
        self.shifts: list[Vector] = []
        self.joints: list[tuple[int, float, int]] = []
        self.coefficients, self.constant = np.zeros(n), 0.0
        self.behind: Vector = (0.0, 0.0, 0.0)
        self.tilt = np.eye(3)

    def move(self, i: int, turn: tuple[NDArray, float], slide: tuple[NDArray, float]) -> None:
        """A joint: its turn about z and slide along z, each ``(coefficients of q, constant)``."""
        self.shifts.append(turned(self.cos_sin(), self.behind))
        self.joints.append((i, self.up, len(self.shifts)))
        self.coefficients = self.coefficients + self.up * turn[0]
        self.constant += self.up * turn[1]
        self.shifts.append((0.0, 0.0, self.up * _linear(self.program, *slide)))

    def fix(self, C: NDArray) -> bool:
        """A constant pose (4, 4) behind the last joint; False where it tilts z, so that the run
        ends.
        """
        flipped = np.diag([1.0, self.up, self.up])
        self.behind = tuple((flipped @ C[:3, 3]).tolist())
        R = np.array([[tidy(entry) for entry in row] for row in C[:3, :3]])
        if R[2, :2].any() or R[:2, 2].any():
            self.tilt = flipped @ R
            return False
        yaw = self.up * math.atan2(R[1, 0], R[0, 0])  # adds to the angle, so the shift turns back
        self.behind = turned((tidy(math.cos(yaw)), -tidy(math.sin(yaw))), self.behind)
        self.constant += yaw
        self.up *= float(R[2, 2])
        self.tilt = np.diag([1.0, self.up, self.up])
        return True

    def cos_sin(self) -> tuple[Number, Number]:
        """Cosine and sine of the angle so far; quarter turns in the constant swap them, exactly."""
        quarters, rest = round(self.constant / QUARTER), 0.0
        if abs(self.constant - quarters * QUARTER) > NEAR * max(1.0, abs(self.constant)):
            quarters, rest = 0, self.constant
        angle = _linear(self.program, self.coefficients, rest)
        c, s = self.program.cos(angle), self.program.sin(angle)
        return ((c, s), (-s, c), (-c, -s), (s, -c))[quarters % 4]


def _linear(program, coefficients, constant):
    """``coefficients · q + constant`` with the constant last, so that sums of q can be shared."""
    total = 0.0
    for i in np.flatnonzero(coefficients):
        total = total + float(coefficients[i]) * program.variable(int(i))
    return total + float(constant)


def turned(cos_sin: Sequence[Number], v: Vector) -> Vector:
    """A vector turned about z."""
    (c, s), (x, y, z) = cos_sin, v
    return x * c - y * s, x * s + y * c, z


def runs_of(arm: Arm, program: Operations) -> list[Run]:
    """The runs of an arm from base to tool, in the operations of ``program``; the first has no
    joints where the base tilts z.
    """
    n, constants = len(arm), _constants(arm)
    runs = [Run(program, n)]
    goes_on = runs[-1].fix(constants[0])
    for i, (turn, slide) in enumerate(_motions(arm)):
        if not goes_on:
            runs.append(Run(program, n))
        runs[-1].move(i, turn, slide)
        goes_on = runs[-1].fix(constants[i + 1])
    return runs


def _motions(arm):
    """Every joint's turn and slide, each (coefficients of q, constant)."""
    matrix, offset = joint_variables(arm)
    still = np.zeros(len(arm))
    for i, slides in enumerate(arm.table.prismatic):
        moving = matrix[i], offset[i]
        if slides:
            yield (still, arm.table.theta[i]), moving
        else:
            yield moving, (still, arm.table.d[i])


def _constants(arm):
    """The n + 1 constant poses before, between and behind the joints."""
    table = arm.table
    bends = [_bend(a, alpha) for a, alpha in zip(table.a, table.alpha, strict=True)]
    if table.convention == "craig":  # a Craig row bends before it turns
        return [arm.base @ bends[0], *bends[1:], arm.tool]
    return [arm.base, *bends[:-1], bends[-1] @ arm.tool]


def _bend(a, alpha):
    """``Tx(a) Rx(alpha)``, which is ``Rx(alpha) Tx(a)``."""
    c, s = tidy(math.cos(alpha)), tidy(math.sin(alpha))
    return np.array([[1, 0, 0, a], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]], dtype=float)
