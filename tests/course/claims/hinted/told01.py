"""Lessons 00 and 01: what a column of a pose says, and products of poses."""

import numpy as np

from .. import facts
from ..reasons import DO, STORY, accepts, always, is_pose, near

IN_ORDER = accepts("t-01", "t-12", "t-2f", "t-ft")


def turned_then_shifted(g):
    return near(g["right"], g["T_01"][:3, :3] @ g["p_12"] + g["T_01"][:3, 3])


SAID = {
    "00.1": {
        "That is all the mathematics": STORY,
        "Each number of the result": lambda g: near(g["right"], [row @ g["v"] for row in g["R"]]),
        "numpy writes the matrix product": always(facts.star_is_by_entries),
    },
    "01.1": {
        "The first column is": lambda g: near(g["right"], g["T_01"][:3, 0]),
        "A pose T_01 has four columns": lambda g: is_pose(g["T_01"]),
    },
    "01.2": {
        "Three arrows as columns": lambda g: (
            is_pose(g["right"]) and near(g["right"][:3, 3], [g["x"], g["y"], g["z"]])
        ),
        "You know x and z": lambda g: near(
            g["right"][:3, 1], np.cross(g["right"][:3, 2], g["right"][:3, 0])
        ),
        "x points along y0": lambda g: near(g["right"][:3, 0], [0, 1, 0]),
        "Stand in the base": DO,
    },
    "01.4": {
        "One product turns": always(facts.right_factor_in_new_frame, facts.last_row_carries),
        "Inner subscripts meet": always(facts.right_factor_in_new_frame),
        "numpy's matrix product is @": always(
            facts.star_is_by_entries, facts.right_factor_in_new_frame
        ),
    },
    "01.5": {
        "Each inner pair meets": IN_ORDER,
        "The product must begin with 0": IN_ORDER,
        "Neighbours must meet": IN_ORDER,
    },
    "01.7": {"Base to flange": lambda g: near(g["right"], (g["T_0F"] @ g["T_FT"])[:3, 3], by=1e-3)},
    "01.3": {"Turn first": turned_then_shifted, "The shift p_12": turned_then_shifted},
}
