"""Lesson 06: the whole arm."""

import numpy as np

import dhlab as dh

from .. import facts
from ..chosen import Q, article
from ..reasons import DO, NAMES, STORY, always, near
from ..vectors import ARTICLE, one_row, walk

ROWS = np.array(ARTICLE) * [np.pi / 180, 1, 1, np.pi / 180]
FOUR = ("article-6r", "ur5e", "ar4", "piper")
WALKS = [  # what is walked at q = 0, in the order of the chain
    ([0, 0, 0.1], "shoulder-height"), ([0.4, 0, 0], "upper-arm"), ([0.35, 0, 0], "forearm"),
    ([0, -0.1, 0], "sideways"), ([0, -0.1, 0], "wrist-to-tool"),
]  # fmt: skip


def steps():
    """From the base up, out, out, sideways, and out along the tool's z to its point."""
    ends = [walk(ARTICLE[:k], [0] * k)[:3, 3] for k in range(1, 7)]
    ways = np.diff([[0, 0, 0], *ends], axis=0)
    ways = [way for way in ways if np.linalg.norm(way) > 1e-9]
    tool = article([0] * 6)[:3, 2]
    return near(ways, [way for way, _ in WALKS]) and near(ways[-1], 0.1 * tool)


def upright():
    """With q2 = 90° and q3 = −90° the upper arm points up and the forearm is level."""
    q = [0, 90, -90, 0, 0, 0]
    shoulder, elbow, wrist = (walk(ARTICLE[:k], q[:k])[:3, 3] for k in (1, 2, 3))
    return near(elbow - shoulder, [0, 0, 0.4]) and near(wrist - elbow, [0.35, 0, 0])


def offsets_in_theta(g):
    e = g["exercise"]
    other = e.right_arm(g["variant"]).flip_x(2)
    theta = g["right"][:, 0]
    return (
        near(theta, [0, 90, -90, 0, 0, 0])
        and upright()
        and not near(other.table.rows, e.right_arm(g["variant"]).table.rows)
        and e.judge(other, g["variant"]).status == "right"
    )


def one_index(g):
    """The program is right where all q are equal, as at 0, and at no others."""
    broken, right = g["exercise"].handed_out, g["exercise"].answer
    q = np.radians(Q)
    return (
        near(broken(ROWS, 0 * q), right(ROWS, 0 * q))
        and near(broken(ROWS, 0 * q + 0.7), right(ROWS, 0 * q + 0.7))
        and not near(broken(ROWS, q), right(ROWS, q))
    )


def irb120(g):
    table = dh.load("irb120").table
    rows = np.column_stack([np.degrees(table.theta), table.d, table.a, np.degrees(table.alpha)])
    return np.count_nonzero(rows[:, 0]) == 2 and near(g["right"], walk(rows, g["q"]))


def standard(name):
    return dh.load(name).to("standard").table


def one_length_more():
    """Of a4, a5 and d5 the UR5e has one that is not 0, and the other three arms none."""
    wrist = {name: [(t := standard(name)).a[3], t.a[4], t.d[4]] for name in FOUR}
    return [name for name in FOUR if np.abs(wrist[name]).max() > 1e-9] == ["ur5e"]


def two_rows_decide():
    """Axes 2, 3 and 4 are parallel where α2 and α3 are 0, and not otherwise."""

    def parallel(rows):
        z = [walk(rows[:k], Q[:k])[:3, 2] for k in (1, 2, 3)]
        return near(*z)

    rows = np.array(ARTICLE, dtype=float)
    tilted = [rows + np.outer(np.eye(6)[k], [0, 0, 0, 30]) for k in (1, 2)]
    return parallel(rows) and not any(map(parallel, tilted))


SAID = {
    "06.1": {
        "d runs along a joint axis": always(facts.last_column_of_standard, steps),
        "d is measured along z": always(facts.last_column_of_standard),
        "Walk along the chain": lambda g: (
            steps() and sorted(g["exercise"].items) == sorted(name for _, name in WALKS)
        ),
    },
    "06.2": {
        "One loop, one product": STORY,
        "A row's θ is its offset plus its q": lambda g: near(
            g["exercise"].answer(ROWS, np.radians(Q)), article(Q)
        ),
        "Each new link is seen from": always(facts.right_factor_in_new_frame),
    },
    "06.3": {
        "Position (0.75, -0.2, 0.1)": lambda g: (
            near(g["right"][:3, 3], [0.75, -0.2, 0.1])
            and near(g["right"][:3, 2], [0, -1, 0])
            and near(g["right"], article([0] * 6))
        ),
        "`rows` is converted already": NAMES,
    },
    "06.5": {
        "α = 0 means that the next z axis": always(
            lambda: near(one_row(35, 0.1, 0.3, 0)[:3, 2], [0, 0, 1])
        )
    },
    "06.6": {
        "Offsets go into the θ column": offsets_in_theta,
        "Those are the offsets": offsets_in_theta,
    },
    "06.7": {
        "One index": one_index,
        "At q = 0 nobody would": one_index,
        "The program is right when all q are equal": one_index,
    },
    "06.10": {"An ABB IRB 120, with two offsets": irb120, "Both angle columns and q": irb120},
    "06.9": {
        "Parallel axes come from α": always(two_rows_decide, one_length_more),
        "The UR5e has a length": always(one_length_more),
        "Two rows decide the first question": always(two_rows_decide),
        "For the second look at a4, a5 and d5": DO,
    },
}
