"""Test values: joint values spread over the limits, and what the plain product of link matrices
gives for them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm

__all__ = ["Samples", "samples"]

SPREAD = 5  # poses beside q = 0
GOLDEN = (math.sqrt(5) - 1) / 2  # its multiples, modulo 1, are spread evenly
WITHOUT_LIMITS = {"R": (-math.pi, math.pi), "P": (-1.0, 1.0)}


@dataclass(frozen=True)
class Samples:
    """``q`` (m, n), ``T`` (m, 4, 4) and ``J`` (m, 6, n); ``T_length`` and ``J_length`` are the size
    of an arm's positions and velocities, which their errors are measured by.
    """

    q: NDArray
    T: NDArray
    J: NDArray
    T_length: float
    J_length: float


def samples(arm: Arm) -> Samples:
    """The samples of an arm, the same in every run; the first is q = 0.

    Parameters
    ----------
    arm : Arm

    Raises
    ------
    ValueError
        Its lengths are so large that a pose overflows.

    Examples
    --------
    >>> import dhlab as dh
    >>> samples(dh.load("ur5e")).q.shape
    (6, 6)
    """
    q = _joint_values(arm)
    with np.errstate(over="ignore", invalid="ignore"):
        T, J = arm.forward(q), arm.jacobian(q)
    if not (np.isfinite(T).all() and np.isfinite(J).all()):
        raise ValueError(
            "generate: expected an arm whose poses are finite numbers, found one whose lengths"
            " overflow; they are in metres"
        )
    slides, table = arm.table.prismatic, arm.table
    ways = [table.d, table.a, arm.base[:3, 3], arm.tool[:3, 3], abs(q[:, slides]).max(axis=0)]
    reach = float(sum(abs(way).sum() for way in ways))
    speed = reach + float(slides.any())
    T[:, :3] = np.dstack([_rounded(T[:, :3, :3], 1.0), _rounded(T[:, :3, 3:], reach)])
    J = np.hstack([_rounded(J[:, :3], speed), _rounded(J[:, 3:], 1.0)])
    return Samples(q, T, J, reach, speed)


def _rounded(values, size):
    """To 14 decimals of the power of ten above ``size``, so that noise of 1e-17 is 0."""
    return values.round(min(14 - math.ceil(math.log10(size)), 300)) + 0.0 if size else values


def _joint_values(arm):
    n = len(arm)
    letters, limits = arm.table.joints, arm.limits or [None] * n
    low, high = np.array(
        [pair or WITHOUT_LIMITS[x] for x, pair in zip(letters, limits, strict=True)]
    ).T
    share = (np.arange(1, SPREAD * n + 1) * GOLDEN % 1).reshape(SPREAD, n)
    spread = low + (high - low) * share
    short = [[float(f"{value:.4g}") for value in row] for row in spread]
    return np.array([[0.0] * n, *short])
