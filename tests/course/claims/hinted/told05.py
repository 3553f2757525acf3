"""Lesson 05: the link matrix from four moves."""

from itertools import product

import numpy as np

from .. import facts
from ..chosen import GENERAL, OPTIONS, hidden, orders_that_give, turn
from ..facts import STANDARD, link
from ..reasons import accepted, always, in_order, near
from ..vectors import one_row

theta, d, a, alpha = GENERAL
T = link(GENERAL, STANDARD)
OUT = np.array([np.cos(theta), np.sin(theta), 0])  # the x arrow, turned
BESIDE = np.array([-np.sin(theta), np.cos(theta), 0])  # the y arrow, turned


def about_x():
    """x stays, and y goes by cos α along y and sin α along z."""
    R = turn("x", 30)
    return near(R[:, 0], [1, 0, 0]) and near(R[:, 1], [0, np.cos(np.pi / 6), 0.5])


def columns():
    tilted = np.cos(alpha) * BESIDE + [0, 0, np.sin(alpha)]
    return (
        near(T[:3, 0], OUT)
        and near(T[:3, 1], tilted)
        and near(T[:3, 2], np.cross(OUT, tilted))
        and near(T[:3, 3], a * OUT + [0, 0, d])
    )


def one_sign(g):
    """One entry of the copied matrix has the other sign, and no other differs."""
    e = g["exercise"]
    copied, right = e.handed_out(*GENERAL), e.answer(*GENERAL)
    off = ~np.isclose(copied, right)
    return off.sum() == 1 and near(copied[off], -right[off])


def hides(g):
    e = g["exercise"]
    quarters = [(0.4, d, a, 0.0), *((sign * np.pi / 2, d, a, alpha) for sign in (1, -1))]
    return all(hidden(row) and near(e.handed_out(*row), e.answer(*row)) for row in quarters)


SAID = {
    "05.1": {
        "x stays; y goes towards z": always(about_x),
        "The second column says where y goes": always(about_x),
    },
    "05.2": {
        "A turn about an axis leaves": always(
            lambda: all(near(turn(k, 40)[:, i], np.eye(3)[i]) for i, k in enumerate("xyz"))
        ),
    },
    "05.3": {
        "Five of the 24 orders": lambda g: (
            orders_that_give(GENERAL) == 5 and len(accepted(g["exercise"])) == 4
        ),
        "Two of the moves belong to z": always(
            lambda: sorted(move[1] for move in STANDARD) == ["x", "x", "z", "z"]
        ),
        "Tx(a) must come after Rz(θ)": in_order(("rz", "tx"), ("rz", "rx"), ("tz", "rx")),
    },
    "05.4": {
        "It is Rz, Tz, Tx and Rx": always(
            lambda: near(np.linalg.multi_dot([link(GENERAL, (move,)) for move in STANDARD]), T)
        ),
        "Each new move is made in the current frame": always(facts.right_factor_in_new_frame),
    },
    "05.6": {
        "The same matrix as the four moves make": always(columns),
        "First column: the x arrow": always(columns),
        "Last column: a times that arrow": always(columns),
        "The second column is the turned y arrow": always(columns),
    },
    "05.7": {
        "One sign was wrong": one_sign,
        "It hides whenever α is 0": hides,
        "The third column must be at right angles": always(
            lambda: np.isclose(T[:3, 2] @ T[:3, 0], 0)
        ),
    },
    "05.9": {
        "For a sliding joint d moves": lambda g: near(g["right"], one_row(-90, g["q3"], 0.05, 90)),
    },
    "05.5": {
        "The link swings with θ": always(
            OPTIONS["05.8", "positions"],
            lambda: near(one_row(30, 0.3, 0.4, 9)[:3, 3] - one_row(30, 0.1, 0.4, 9)[:3, 3],
                         [0, 0, 0.2]),
        ),
        "a is walked along the new x arrow": lambda g: near(
            g["right"], one_row(*(g[name] for name in ("theta", "d", "a", "alpha")))[:3, 3],
            by=1e-3,
        ),
    },
    "05.8": {
        "A sign can only show": always(
            lambda: all(
                hidden((t, d, a, al)) == np.isclose(np.cos(t) * np.sin(al), 0)
                for t, al in product((0.4, np.pi / 2, -2.0), (0.0, 0.9, np.pi))
            )
        ),
    },
}  # fmt: skip
