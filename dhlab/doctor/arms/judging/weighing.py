"""What an explanation costs: what it leaves unexplained, and what it supposes.

All in nats (units of 0.7 bits), so that explanations with many fitted numbers and with none can be
compared: a number that is fitted costs as much as a measured number tells (the logarithm of how
much finer it is known than guessed), so six numbers fitted to six measured ones explain nothing.
MacKay, *Information Theory, Inference, and Learning Algorithms*, chapter 28.
"""

from dataclasses import dataclass

import numpy as np

from ....rotations import rotation_vectors
from ...mistakes.registry import preference
from ...mistakes.remade import A, D
from ..given import distinct

__all__ = [
    "Weighed",
    "as_it_is",
    "as_measured",
    "largest",
    "level_left",
    "number_costs",
    "squares",
    "weigh",
]

DISCRETE = 5.0  # one of some hundred mistakes without a number to guess
PLACE = 3.2  # one of some twenty numbers of a table
GUESS = 2.0  # a fitted number that one would have guessed: 0, -90°, its negative
SAME = 1e-9  # of a turn, or of the reach: what was not moved
LEAST = 3.0  # of any other fitted number
DATA = 2.0  # measurements are blamed after the arm


@dataclass(frozen=True)
class Weighed:
    """An explanation and its cost; ``level`` (m, rad) is the noise that it leaves."""

    explanation: object
    cost: float
    level: tuple


def squares(arm, data):
    """((sum of squares, how many numbers) of positions, the same of rotations), m² and rad²."""
    return _counted(data.squares(arm.forward(data.q)), data)


def _counted(left, data):
    of_turns = 0 if data.R is None else data.p.size
    return (left[0], data.p.size), (left[1], of_turns)


def largest(arm, data):
    """The largest residual in mm and in degrees, NaN where no rotation was measured."""
    T = arm.forward(data.q)
    millimetres = 1e3 * float(np.linalg.norm(T[:, :3, 3] - data.p, axis=1).max())
    if data.R is None:
        return millimetres, float("nan")
    turn = np.linalg.norm(rotation_vectors(np.swapaxes(T[:, :3, :3], -1, -2) @ data.R), axis=1)
    return millimetres, float(np.rad2deg(turn.max()))


def level_left(arm, data, fitted=0):
    """The noise (m, rad) that an arm leaves; as stated, where it is."""
    return data.noise if data.stated else _level(squares(arm, data), data, fitted)


def _level(left, data, fitted):
    share = data.count / max(data.count - fitted, 1)
    return tuple(
        max(float(np.sqrt(total * share / count)), least) if count else least
        for (total, count), least in zip(left, data.floor)
    )


def _misfit_cost(left, data):
    """Half of χ² of the squares that are left; where no noise is stated, that of the noise which
    suits them best, paid for by how much larger than the digits' it is.
    """
    known = data.noise if data.stated else data.floor
    cost = 0.0
    for (total, count), sigma in zip(left, known):
        if count:
            ratio = total / count / sigma**2
            plain = ratio / 2
            cost += count * (plain if data.stated or ratio < 1 else (1 + np.log(ratio)) / 2)
    return cost


def number_costs(level, data):
    """What one fitted length, and one fitted angle, cost at a level of noise."""
    angle = level[1] if data.R is not None else level[0] / data.reach
    return max(np.log(data.reach / level[0]), LEAST), max(np.log(1 / angle), LEAST)


def _ends_cost(e, level, data):
    """A base or a tool that was fitted: nothing for what was not moved, little where it was turned
    as one would have guessed.
    """
    length, angle = number_costs(level, data)
    cost = 0.0
    for end in e.ends:
        was, found = getattr(e.chain[0], end), getattr(e.fit.arm, end)
        moved = np.linalg.inv(was) @ found if end == "tool" else found @ np.linalg.inv(was)
        cost += DISCRETE + length * int((np.abs(moved[:3, 3]) > SAME * data.reach).sum())
        if data.R is not None or end == "base":
            cost += _turn_cost(moved[:3, :3], angle)
    return cost


def _turn_cost(R, angle):
    if np.abs(R - np.eye(3)).max() < SAME:
        return 0.0
    if np.abs(R - np.round(R)).max() < SAME:
        return GUESS
    return angle * (1 if np.abs(R[2, 2] - 1) < SAME else 3)


def weigh(e, data):
    """The :class:`Weighed` of an Explanation."""
    mended = data if e.changed is None else e.changed
    left = _counted(e.fit.left, mended) if e.fit.left else squares(e.fit.arm, mended)
    level = mended.noise if mended.stated else _level(left, mended, e.fit.fitted)
    cost = _misfit_cost(left, mended) + _ends_cost(e, level, data)
    length, angle = number_costs(level, data)
    free = sorted((length if c in (D, A) else angle for _, c in e.entries), reverse=True)
    odd = min(e.odd, len(free))
    cost += sum(free[:odd]) + GUESS * (len(free) - odd) + PLACE * min(len(free), 2)
    whole = e.changes - (e.data_fault is not None) - len(e.ends) - min(len(e.entries), e.changes)
    cost += DISCRETE * max(whole, 0)
    if e.data_fault is not None:
        cost += DISCRETE + DATA + 0.1 * preference(e.data_fault[0])
    return Weighed(e, float(cost), level)


def as_it_is(arm, data):
    """What the table costs without any change."""
    return _misfit_cost(squares(arm, data), data)


def as_measured(data):
    """What it costs to explain nothing and write down every measured number instead; lines that
    repeat each other count once.
    """
    known = data.noise if data.stated else data.floor
    length, angle = number_costs(known, data)
    kinds = 3 * distinct(data.q)
    ends = data.base_free + data.tool_free
    if data.R is None:
        return length * (kinds - 6 * data.base_free - 3 * data.tool_free)
    return (length + angle) * (kinds - 3 * ends)
