"""Lesson 02: what the four numbers of a row say."""

import numpy as np

from .. import facts
from ..chosen import turn
from ..reasons import NAMES, accepted, accepts, always, near
from ..vectors import one_row

MOVES = accepts("about-old-z", "along-old-z", "along-new-x", "about-new-x")
FORWARD, UP = 0.0535, 0.2845  # m, the bent upper arm


def read(T):
    """θ, d, a, α of a link's matrix: degrees and metres."""
    theta, alpha = np.arctan2(T[1, 0], T[0, 0]), np.arctan2(T[2, 1], T[2, 2])
    return [np.degrees(theta), T[2, 3], T[:3, 3] @ T[:3, 0], np.degrees(alpha)]


def left_over(T):
    """How far x leans to the old z, and how far its line passes by it."""
    return abs(T[2, 0]) + abs(np.cross([0, 0, 1], T[:3, 0]) @ T[:3, 3])


def poses(g):
    return [g[f"T_{letter}"] for letter in "abcd"]


def by_leftovers(g):
    """Who leaves something over is made by no row, of whatever numbers; who does not, by one."""
    made = [near(one_row(*read(T)), T) for T in poses(g)]
    return made == [left_over(T) < 1e-9 for T in poses(g)] == (g["right"] > 0.5).tolist()


def in_our_order(g):
    theta, a, d, alpha = np.transpose(g["rows"])
    return near(g["right"], np.column_stack([np.degrees(theta), d, a, np.degrees(alpha)]))


def straight(g):
    """The row of the straight line between the two axes."""
    told = np.degrees(np.arctan2(UP, FORWARD)), np.hypot(FORWARD, UP)
    whole = (told[0] + g["q2"] - g["right"][0]) / 360
    return (
        (round(told[0], 2), round(told[1], 4)) == (79.35, 0.2895)
        and np.isclose(whole, round(whole), atol=1e-4)
        and np.isclose(g["right"][2], told[1], atol=1e-4)
    )


SAID = {
    "02.1": {
        "About old z, along old z": MOVES,
        "Two of the numbers are angles": lambda g: all(
            sum("angle" in g["exercise"].items[key] for key in ids) == 2
            for ids in accepted(g["exercise"])
        ),
        "The first two belong": MOVES,
    },
    "02.2": {
        "A joint moves about or along its own axis": always(
            lambda: near(one_row(70, 0.3, 0.2, 50)[:3, 3] - one_row(70, 0.1, 0.2, 50)[:3, 3],
                         [0, 0, 0.2]),
            lambda: near(one_row(70, 0, 0.2, 50)[:3, :3],
                         turn("z", 40) @ one_row(30, 0, 0.2, 50)[:3, :3]),
        ),
    },
    "02.4": {
        "a is negative": lambda g: g["right"][2] < 0 and near(read(g["T_01"]), g["right"], by=0.1),
        "α has its sign too": lambda g: g["right"][3] < 0,
        "x1 is given": NAMES,
        "np.arctan2(y, x) keeps both signs": always(facts.no_quadrant),
    },
    "02.5": {"Six numbers for a free plate": NAMES},
    "02.8": {
        "Only the two axes count": straight,
        "The bend is nowhere in the row": straight,
        "Pythagoras knows": straight,
        "x1 points from axis to axis": NAMES,
        "At q2 = 0 it goes 53.5 forward": straight,
    },
    "02.3": {
        "θ off the first column": lambda g: near(read(g["T_01"]), g["right"], by=0.02),
        "α is the angle from z0 to z1": lambda g: near(
            g["T_01"][2, 1:3], [np.sin(a := np.radians(g["right"][3])), np.cos(a)], by=1e-3
        ),
    },
    "02.6": {
        "Two conditions": by_leftovers,
        "A row leaves none": always(lambda: left_over(one_row(20, -0.1, 0.3, 60)) < 1e-12),
        "A minus sign before d or a": lambda g: (
            by_leftovers(g)
            and any(min(read(T)[1:3]) < 0 for T in poses(g) if left_over(T) < 1e-9)
        ),
    },
    "02.7": {
        "The same numbers": in_our_order,
        "The printed rows hold": in_our_order,
        "np.rad2deg turns": always(lambda: round(np.rad2deg(1.5708)) == 90),
    },
}  # fmt: skip
