"""In which sense each axis of one arm answers to that of another: the choice of z and x along the
whole chain for which their links differ least.
"""

import numpy as np
from numpy.typing import NDArray

from ..canonical import JointAxes
from .walk import Cases, Link, Walk, link_of, links_of, walk

__all__ = ["matched", "wrapped"]

# a joint that counts the other way, or a zero by half a turn, weighs as much as a millimetre on an
# arm of a metre: lengths and angles decide, and where they leave the choice, the fewest changes
CHANGED = 1e-3


def matched(
    A: JointAxes, B: JointAxes, cases: Cases
) -> tuple[list[Link], list[Link], NDArray[np.float64], Walk, Walk]:
    """The links of two arms with the same letters, told alike.

    Returns
    -------
    in_a, in_b : lists of Link
    senses : array (n,)
        -1 where b counts the other way than a.
    way_a, way_b : Walk
    """
    n, reach = len(A.letters), max(A.reach, B.reach, 1e-3)
    way_a, way_b = walk(A, cases), walk(B, cases)
    in_a = links_of(A, way_a, cases, np.ones(n), np.ones(n - 1))
    # Viterbi: a link depends on the senses of its two axes and on the x on either side of its joint
    best: dict[tuple[float, float], tuple[float, list[float], list[float]]] = {
        (s, 1.0): (_base_cost(A, B, s) + CHANGED * (s < 0), [s], []) for s in (1.0, -1.0)
    }
    for k in range(n - 1):
        following: dict[tuple[float, float], tuple[float, list[float], list[float]]] = {}
        for (s, f), (cost, senses, flips) in best.items():
            for s_next in (1.0, -1.0):
                for f_next in (1.0, -1.0):
                    link = link_of(B, way_b, cases, k, (s, s_next), (f, f_next))
                    total = cost + _cost(in_a[k], link, A.letters[k], reach)
                    total += CHANGED * (s_next < 0)
                    if (s_next, f_next) not in following or total < following[s_next, f_next][0]:
                        following[s_next, f_next] = total, senses + [s_next], flips + [f_next]
        best = following
    for (s, f), (cost, senses, flips) in list(best.items()):
        last = link_of(B, way_b, cases, n - 1, (s, s), (f, 1.0))
        best[s, f] = cost + _cost(in_a[-1], last, A.letters[-1], reach), senses, flips
    _, senses, flips = min(best.values(), key=lambda found: found[0])
    chosen = np.array(senses)
    return in_a, links_of(B, way_b, cases, chosen, np.array(flips)), chosen, way_a, way_b


def _base_cost(A, B, sense):
    """How far the first axes point apart, in their base frames (rad)."""
    return float(np.arccos(np.clip(A.z[0] @ B.z[0] * sense, -1, 1)))


def _cost(in_a, in_b, letter, reach):
    gap = abs(in_a.a - in_b.a) / reach + abs(wrapped(in_b.alpha - in_a.alpha))
    gap += abs(in_b.beta - in_a.beta)
    turn, shift = abs(wrapped(in_b.theta - in_a.theta)), abs(in_b.d - in_a.d) / reach
    return gap + (turn + CHANGED * shift if letter == "P" else shift + CHANGED * turn / np.pi)


def wrapped(angle: float) -> float:
    """An angle within -180° and 180°, in rad; half a turn is +180°."""
    turned = float((angle + np.pi) % (2 * np.pi) - np.pi)
    return turned + 2 * np.pi if turned < -np.pi + 1e-12 else turned
