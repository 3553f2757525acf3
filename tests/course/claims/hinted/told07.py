"""Lesson 07: from a symptom to its cause."""

import numpy as np

from ..chosen import FLAT, TWICE, Q, article, changed, constant, only_where_the_point_is, same
from ..reasons import DO, NAMES, STORY, always, near
from ..vectors import ARTICLE, walk

NOISE = 0.015  # m, what a tape misreads at most


def degrees(g):
    return np.degrees(g["q"])


def wrong_entries(g):
    return [tuple(e) for e in np.argwhere(~np.isclose(g["rows"], g["right"], atol=1e-6)).tolist()]


def z4_turned_round(g):
    """One number is wrong, the α that ends at z4, by half a turn."""
    return wrong_entries(g) == [(3, 3)] and np.isclose(abs(g["rows"] - g["right"]).max(), 180)


def axis_of(rows, joint):
    """Point and direction of a joint's axis, counted from 1, at Q."""
    T = walk(rows[: joint - 1], Q[: joint - 1])
    return np.concatenate([T[:3, 3], T[:3, 2]])


def row_makes_the_next_axis():
    """Another row i leaves the axes up to joint i in place, and moves that of joint i + 1."""
    for i in range(1, 6):
        rows = np.array(ARTICLE, dtype=float)
        rows[i - 1] += [10, 0.1, 0.1, 20]
        left = [near(axis_of(rows, k), axis_of(ARTICLE, k)) for k in range(1, i + 2)]
        if left != [True] * i + [False]:
            return False
    return True


def tilts_and_leaves(k):
    """Whether number k of row 4 tilts axis 5 and leaves joint 4's arc where it is about its axis:
    seen in frame 3, the angle at which the end stands.
    """
    before, other = np.linalg.inv(walk(ARTICLE[:3], Q[:3])), np.array(ARTICLE, dtype=float)
    other[3, k] += 180
    ends = [before @ walk(rows, Q) for rows in (ARTICLE, other)]
    angles = [np.arctan2(T[1, 3], T[0, 3]) for T in ends]
    return not near(axis_of(other, 5), axis_of(ARTICLE, 5)) and bool(np.isclose(*angles))


def lost_a_sign(g):
    """One number is the right one with the other sign: an α of 90° either way, a d or an a."""
    ((i, k),) = wrong_entries(g)
    right = g["right"][i, k]
    return np.isclose(g["rows"][i, k], -right) and (k in (1, 2) or np.isclose(abs(right), 90))


def arrow_of(rows, entry, q):
    """The arrow along which a length acts: z of the frame before, or x of the row's own."""
    i, k = entry
    frames = [walk(rows[:n], q[:n]) for n in range(i + 2)]
    return frames[i][:3, 2] if k == 1 else frames[i + 1][:3, 0]


def acts_along():
    return all(
        near((article(Q, changed(i, k, 0.2)) - article(Q))[:3, 3],
             0.2 * arrow_of(ARTICLE, (i, k), Q))
        for i in range(6) for k in (1, 2)
    )  # fmt: skip


def accused(g):
    """Of the one wrong length, the residuals lie along its arrow, and are nearly one number, which
    is missing; beside it is the tape's noise.
    """
    ((i, k),) = wrong_entries(g)
    missing, along = (g["right"] - g["rows"])[i, k], []
    for q, p in zip(degrees(g), g["points"]):
        arrow, left = arrow_of(g["rows"], (i, k), q), p - walk(g["rows"], q)[:3, 3]
        along.append(left @ arrow)
        if np.linalg.norm(np.cross(left, arrow)) > NOISE:
            return False
    enough = np.ptp(along) < 2 * NOISE < abs(missing) + 1e-9
    return enough and abs(np.mean(along) - missing) < NOISE / 3


def impostor():
    """Upper arm and forearm lie on one line at q = 0, where only their sum shows."""
    shared = np.array(ARTICLE, dtype=float)
    shared[1:3, 2] += 0.1, -0.1
    flat = [walk(ARTICLE[:k], [0] * k)[:3, 3] for k in (1, 2, 3)]
    return (
        near(np.cross(*np.diff(flat, axis=0)), [0, 0, 0])
        and same(article([0] * 6, shared), article([0] * 6))
        and not same(article(Q, shared), article(Q))
    )


def down_to_noise(g):
    """How far the end is from the measured points, without the two offsets and with them."""
    offsets = np.zeros(6)
    offsets[1:3] = g["right"]
    before, after = (
        np.sqrt(np.mean([
            np.sum((walk(ARTICLE, q + more)[:3, 3] - p) ** 2)
            for q, p in zip(degrees(g), g["points"])
        ]))
        for more in (0 * offsets, offsets)
    )  # fmt: skip
    return before > 0.01 > 0.004 > after


def fixed_ends():
    """A base that is shifted, a hand that is longer: alike at every pose, seen from there."""
    return only_where_the_point_is() and constant("tool") and not constant("base")


SAID = {
    "07.1": {
        "Each cause leaves its own trace": lambda g: len(g["exercise"].items) == 6,
        "What is fixed to the floor": always(fixed_ends),
    },
    "07.4": {
        "A perfect impostor": STORY,
        "At q = 0 upper arm and forearm": always(impostor),
        "A stretched arm shows some lengths": always(impostor),
        "Share that sum out": DO,
    },
    "07.6": {
        "That was it: z4": z4_turned_round,
        "Two days": STORY,
        "Row i makes the axis of joint i + 1": always(row_makes_the_next_axis),
        "Of the four numbers of the guilty row": always(
            lambda: tilts_and_leaves(3) and not tilts_and_leaves(0)
        ),
    },
    "07.8": {
        "A Puma 560, repaired from six circles": lambda g: all(
            near((walk(g["right"], q) @ g["pen"])[:3, 3], p, by=0.01)
            for q, p in zip(np.degrees(g["sweeps"]), g["points"])
        ),
        "Row i makes the axis of joint i + 1": always(row_makes_the_next_axis),
        "A lost sign changes a number by twice": lost_a_sign,
        "So what is 180° off was an α": lost_a_sign,
    },
    "07.2": {
        "One conversion too many": STORY,
        "On a flat arm, where every α": always(
            lambda: same(article(Q, FLAT), article(Q, FLAT * TWICE)),
            lambda: not same(article(Q), article(Q, np.array(ARTICLE) * TWICE)),
        ),
        "A flat arm has α = 0": NAMES,
    },
    "07.3": {
        "One arrow accused itself": accused,
        "d_i acts along z_{i-1}": always(acts_along),
        "The guilty arrow gives nearly": accused,
    },
    "07.7": {"Added to θ, these two": down_to_noise, "The offsets are in radians": NAMES},
}
