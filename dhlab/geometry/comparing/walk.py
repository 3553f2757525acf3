"""An arm's links as numbers that stay small where axes are nearly parallel, and that mean the same
for two arms: which pairs of axes are taken as parallel is decided for both at once.

Where two neighbouring axes are nearly parallel, the common normal runs away; there the link goes
through the plane across the first axis (Hayati & Mirmirani, "Improving the absolute positioning
accuracy of robot manipulators", J. Robotic Systems 2, 1985): d = 0, and a fifth number, beta, turns
about y.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..canonical import JointAxes
from ..lines import across, angle_about, common_normal, nearest_on, tilt, unit
from ..procedure.normals import NEARLY

__all__ = ["Link", "Walk", "Cases", "cases_of", "walk", "link_of", "links_of"]

ACROSS = 0.2  # cosine of the angle between axes; below it they stand across
COAXIAL = 1e-3  # × reach; parallel axes nearer than this do not say which way x points
CLEAR = 0.9  # a direction with a larger part along z does not say which way x points


@dataclass(frozen=True)
class Link:
    """The numbers of joint k and of the link behind it: ``theta``, ``alpha``, ``beta`` in radians,
    ``d``, ``a`` in metres; ``beta`` is 0 where the axes are not nearly parallel. ``near`` says that
    they are: then ``d`` is 0. Of the last joint ``a``, ``alpha`` and ``beta`` are 0.
    """

    theta: float
    d: float
    a: float
    alpha: float
    beta: float
    near: bool


@dataclass(frozen=True)
class Cases:
    """What must be decided alike for arms that are compared: which links join nearly parallel axes
    (n - 1), which of these one line, and which axis of the base and of the end says where x is."""

    parallel: tuple[bool, ...]
    coaxial: tuple[bool, ...]
    base: int
    end: int


@dataclass(frozen=True)
class Walk:
    """Along the chain: where each axis is reached (``into``, (n, 3)) and left (``out``, (n, 3)),
    and the directions x_0 … x_n ((n + 1, 3)); metres."""

    into: NDArray[np.float64]
    out: NDArray[np.float64]
    x: NDArray[np.float64]


def cases_of(*arms: JointAxes) -> Cases:
    """What to take for parallel in all of these arms; they have the same letters. A link that is
    nearly parallel in one and stands across in another is told without beta.
    """
    n = len(arms[0].letters)
    parallel = tuple(
        any(tilt(A.z[k], A.z[k + 1]) < NEARLY for A in arms)
        and all(abs(A.z[k] @ A.z[k + 1]) > ACROSS for A in arms)
        for k in range(n - 1)
    )
    coaxial = tuple(
        parallel[k] and any(_between(A, k, parallel) < COAXIAL * max(A.reach, 1e-3) for A in arms)
        for k in range(n - 1)
    )
    return Cases(
        parallel,
        coaxial,
        _clear([(np.eye(3), A.z[0]) for A in arms]),
        _clear([(A.end[:3, :3], A.z[-1]) for A in arms]),
    )


def _between(A, k, parallel):
    """How far parallel axes k and k + 1 are apart; 0 where one of them slides and has no place."""
    there = A.p[k + 1]
    if A.letters[k + 1] == "P":
        if not _is_put_behind(A.letters, k + 1, parallel):
            return 0.0
        there = A.p[k + 2]
    return 0.0 if A.letters[k] == "P" else np.linalg.norm(across(there - A.p[k], A.z[k]))


def _is_put_behind(letters, k, parallel):
    """Whether sliding axis k goes onto the next, which turns and is parallel to it."""
    return k + 1 < len(letters) and letters[k + 1] == "R" and parallel[k]


def _clear(pairs: Sequence[tuple[NDArray[np.float64], NDArray[np.float64]]]) -> int:
    """The first column that is not along z in any of the pairs (matrix, z)."""
    along = np.max([abs(R.T @ z) for R, z in pairs], axis=0)
    return int(np.argmax(along < CLEAR)) if (along < CLEAR).any() else int(np.argmin(along))


def walk(A: JointAxes, cases: Cases) -> Walk:
    """The chain of an arm, from the point of its first axis nearest to the base's origin to the
    point of its last axis nearest to the end."""
    n, p, z = len(A.letters), A.p.copy(), A.z
    into, out, x = np.zeros((n, 3)), np.zeros((n, 3)), np.zeros((n + 1, 3))
    _locate(A, p, 0, np.zeros(3), cases)
    into[0] = nearest_on(p[0], z[0], np.zeros(3))
    x[0] = unit(across(np.eye(3)[cases.base], z[0]))
    for k in range(n - 1):
        _locate(A, p, k + 1, into[k], cases)
        if not cases.parallel[k] and tilt(z[k], z[k + 1]) >= NEARLY:
            N = common_normal(p[k], z[k], p[k + 1], z[k + 1])
            out[k], into[k + 1] = p[k] + N.out * z[k], p[k + 1] + N.into * z[k + 1]
            x[k + 1] = N.x
            continue
        # a sliding joint takes the whole way along itself, so that its zero is its own
        out[k] = nearest_on(p[k], z[k], _left(A, p, cases, k)) if A.letters[k] == "P" else into[k]
        reached = (out[k] - p[k + 1]) @ z[k] / (z[k + 1] @ z[k])
        into[k + 1] = p[k + 1] + reached * z[k + 1]
        gap = across(into[k + 1] - out[k], z[k])
        one_line = cases.coaxial[k] or np.linalg.norm(gap) < COAXIAL * max(A.reach, 1e-3)
        x[k + 1] = unit(across(x[k] if one_line else gap, z[k]))
    out[-1] = nearest_on(p[-1], z[-1], A.end[:3, 3]) if A.letters[-1] == "R" else into[-1]
    x[-1] = unit(across(A.end[:3, cases.end], z[-1]))
    return Walk(into, out, x)


def _left(A, p, cases, k):
    """About where the chain leaves axis k, seen from what follows it."""
    if k == len(A.letters) - 1:
        return nearest_on(p[k], A.z[k], A.end[:3, 3])
    if cases.parallel[k]:
        return _left(A, p, cases, k + 1)
    return p[k] + common_normal(p[k], A.z[k], p[k + 1], A.z[k + 1]).out * A.z[k]


def _locate(A, p, k, here, cases):
    """A place for axis k where that slides, and only its direction counts: on the turning axis
    behind it when that is parallel, else where the chain already is."""
    if A.letters[k] != "P":
        return
    p[k] = p[k + 1] if _is_put_behind(A.letters, k, cases.parallel) else here


def links_of(
    A: JointAxes, way: Walk, cases: Cases, senses: NDArray[np.float64], flips: NDArray[np.float64]
) -> list[Link]:
    """The numbers of every joint, with z_k times ``senses`` (n,) and x_1 … x_{n-1} times ``flips``
    (n - 1,), each +1 or -1."""
    signs = [1.0, *flips, 1.0]
    return [
        link_of(A, way, cases, k, senses[k : k + 2], signs[k : k + 2])
        for k in range(len(A.letters))
    ]


def link_of(
    A: JointAxes,
    way: Walk,
    cases: Cases,
    k: int,
    senses: Sequence[float] | NDArray[np.float64],
    flips: Sequence[float],
) -> Link:
    """The numbers of joint k, with z_k and z_{k+1} times ``senses``, the x on either side of it
    times ``flips``; the last has no next axis."""
    z, x_before, x = senses[0] * A.z[k], flips[0] * way.x[k], flips[1] * way.x[k + 1]
    d = float((way.out[k] - way.into[k]) @ z)
    theta = float(angle_about(z, across(x_before, z), across(x, z)))
    if k == len(A.letters) - 1:
        return Link(theta, d, 0.0, 0.0, 0.0, False)
    z_next = senses[1] * A.z[k + 1]
    a = float((way.into[k + 1] - way.out[k]) @ x)
    alpha = float(np.arctan2(-z_next @ np.cross(z, x), z_next @ z))
    beta = float(np.arcsin(np.clip(z_next @ x, -1, 1))) if cases.parallel[k] else 0.0
    return Link(theta, d, a, alpha, beta, cases.parallel[k])
