"""Lesson 03: the two conventions."""

from itertools import permutations

import numpy as np

from .. import facts
from ..chosen import GENERAL
from ..reasons import DO, NAMES, STORY, accepted, accepts, always, in_order, near
from ..vectors import one_row, walk

CASES = accepts("craig", "standard", "craig", "craig", "standard", "standard")
DOWN_TO_Z = in_order(("rx", "rz"), ("tx", "rz"))


def craig_orders():
    right = facts.link(GENERAL, facts.CRAIG)
    return sum(np.allclose(facts.link(GENERAL, o), right) for o in permutations(facts.CRAIG))


def moved(step):
    """θ and d are the given ones, the pairs those of the row before (1) or behind (-1)."""

    def holds(g):
        rows, right = np.array(g.get("rows", g.get("standard"))), g["right"]
        pairs = np.roll(rows[:, 2:], step, axis=0)
        empty = 0 if step > 0 else -1
        pairs[empty] = 0
        return near(right[:, :2], rows[:, :2]) and near(right[:, 2:], pairs)

    return holds


def last_is_the_tools(g):
    a, alpha = np.array(g["rows"])[-1, 2:]
    arm = g["exercise"].right_arm(g["variant"])
    return moved(1)(g) and near(arm.tool, one_row(0, 0, a, alpha))


def stayed(g):
    """In the table to be repaired a stands where it stood, and α one row further down."""
    rows, half = np.array(g["standard"]), np.array(g["converted"])
    return near(half[:, 2], rows[:, 2]) and near(half[1:, 3], rows[:-1, 3])


def settled(g):
    """The check pose fits one reading of the rows, and not the other; all in degrees."""
    ends = [walk(g["rows"], g["q_check"], c)[:3, 3] for c in ("standard", "craig")]
    return sum(near(end, g["p_check"], by=1e-3) for end in ends) == 1


def craigs(g):
    row = (0.4, 0.3, 0.5, 0.9)
    return near(g["exercise"].answer(*row), facts.link(row, facts.CRAIG)) and (
        set(facts.CRAIG[:2]) == {"Rx", "Tx"} and set(facts.CRAIG) == set(facts.STANDARD)
    )


SAID = {
    "03.1": {
        "Far end for the standard convention": CASES,
        "Link i runs from": NAMES,
        "Craig's z carries": CASES,
        "With the far end": CASES,
    },
    "03.2": {
        "Five of the 24 orders": lambda g: (
            craig_orders() == 5 == len(accepted(g["exercise"]))
        ),
        "From near end to near end": accepts("rx", "tx", "rz", "tz"),
        "Both x moves come before": DOWN_TO_Z,
    },
    "03.7": {
        "θ and d stayed": last_is_the_tools,
        "θ and d belong to the joint": moved(1),
        "Row 1 has no link before it": moved(1),
        "Row 2 holds the pair of link 1": moved(1),
    },
    "03.9": {
        "Column a had stayed behind": stayed,
        "A half-converted table looks": STORY,
        "α has moved down one row": stayed,
        "Its partner has not": stayed,
    },
    "03.10": {
        "One check pose settled": settled,
        "Both the rows and q are in degrees": settled,
        "The two arms are the two readings": settled,
        "See which of them meets p_check": DO,
    },
    "03.3": {
        "The same four moves": craigs,
        "Link first": craigs,
        "Then the joint": craigs,
    },
    "03.5": {
        "All six": lambda g: g["exercise"].size == 6,
        "A habit of tables": STORY,
        "Mostly nothing": STORY,
        "Craig's row 1 holds the link before": always(facts.only_standard_ends_with_a_link),
    },
    "03.6": {
        "One of five was the convention": lambda g: [
            (len(ids), ids.count("convention")) for ids in accepted(g["exercise"])
        ] == [(5, 1)],
        "Ask what differs": DO,
        "Let dh.equivalent speak": DO,
    },
    "03.8": {
        "The pairs moved up": moved(-1),
        "Row i of the standard table": moved(-1),
    },
}  # fmt: skip
