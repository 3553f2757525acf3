"""Lesson 04: frames placed on axes, and a table read off them."""

import numpy as np

from .. import facts
from ..chosen import constant
from ..facts import AXES, how
from ..reasons import DO, NAMES, STORY, accepts, always, lie, near, on
from ..vectors import one_row

OLD_Z = accepts("axis-1", "axis-2", "axis-3")
MEETING = [0.75, -0.1, 0.1]  # of axes 4, 5 and 6 of the article's arm


def wrist_meets(g):
    return all(on(axis, MEETING) for axis in g["axes"][3:])


def right(g, frames):
    return g["exercise"].judge(frames, g["variant"]).status == "right"


def foot(g):
    """The point of axis 2 that is nearest to axis 1, and the arrow from there to it."""
    (p, u), (s, v) = ([np.array(x, dtype=float) for x in axis] for axis in g["axes"])
    across = np.cross(u, v)
    along = np.linalg.lstsq(np.column_stack([u, -v, across]), s - p, rcond=None)[0]
    return s + along[1] * v, across * along[2]


def at_the_foot(g):
    point, way = foot(g)
    end, z = np.array(g["end"]), g["axes"][1][1]
    frames = [[[0, 0, 1], [0, 0, 0], way], [z, point, way], [end[:3, 2], end[:3, 3], end[:3, 0]]]
    return right(g, frames)


def off_their_axis(g):
    """Of somebody's frames, those whose origin is on no axis of theirs, from 0."""
    return [k for k, (axis, f) in enumerate(zip(g["axes"], g["frames"])) if not on(axis, f[1])]


def three_odd_and_allowed(g):
    """One origin off its axis; z2 and x2 turned round and o2 slid, and right with that one put."""
    frames = [list(f) for f in g["frames"]]
    odd = near(frames[2][0], -np.array(g["axes"][2][1])) and near(frames[2][2], [-1, 0, 0])
    slid = not near(frames[2][1], g["axes"][2][0])
    frames[1][1] = g["axes"][1][0]
    return off_their_axis(g) == [1] and odd and slid and right(g, frames)


def one_too_far(g):
    frames = [list(f) for f in g["frames"]]
    frames[4][1] = MEETING
    return not right(g, g["frames"]) and right(g, frames)


def condition_of_x(T):
    """The line of the new x meets the old z at right angles, a behind the new origin."""
    back = T[:3, 3] - 0.3 * T[:3, 0]
    return near(back[:2], [0, 0]) and np.isclose(T[2, 0], 0)


def six(g):
    return len(g["axes"]) == 6


SAID = {
    "04.1": {
        "z0 is joint 1's": OLD_Z,
        "z is never the metal": OLD_Z,
        "In the standard convention the first row's turn": OLD_Z,
    },
    "04.2": {
        "The foot of the common normal": at_the_foot,
        "All points of axis 2 have": lambda g: near(np.array(g["axes"][1][1])[1:], [0, 0]),
        "Only x is open": lambda g: (
            g["axes"][0][0][0] == 0 and near(g["axes"][0][1], [0, 0, 1])
        ),
    },
    "04.3": {
        "A row goes along z_{i-1} by d": always(facts.last_column_of_standard),
        "The origin must lie on z_i": always(
            lambda: condition_of_x(one_row(20, 0.2, 0.3, 40))
        ),
    },
    "04.4": {
        "Every choice keeps its rule": STORY,
        "All z first": DO,
        "Axes that meet": lie("meet", "parallel"),
        "Parallel: origin anywhere on z": lie("meet", "parallel"),
    },
    "04.7": {
        "One point": three_odd_and_allowed,
        "The reversed z2, the reversed x2": three_odd_and_allowed,
        "Four things look odd": three_odd_and_allowed,
    },
    "04.10": {
        "A sliding joint, axes on one line": lambda g: (
            g["axes"][2][2:] == ("P",) and how(g["axes"][2], g["axes"][3]) == "line"
            and not on(g["axes"][3], np.array(g["end"])[:3, 3] + [0, 0, 1])
        ),
        "Of the sliding joint only the direction": NAMES,
        "z2 and z3 on one line": lambda g: how(g["axes"][2], g["axes"][3]) == "line",
    },
    "04.11": {
        "Two that meet at the foot": always(
            lambda: [facts.lies(k) for k in range(1, 6)]
            == ["meet", "parallel", "parallel", "meet", "meet"]
        ),
        "Parallel: the same direction": NAMES,
        "Axis 5 is vertical": always(lambda: near(np.abs(AXES[4][0]), [0, 0, 1])),
    },
    "04.12": {
        "Half the arm stands": lambda g: len(g["axes"]) == 3,
        "Frames 0 and 1 are placed": NAMES,
        "z2 lies on the axis of joint 3": lambda g: near(
            np.array(g["end"])[:3, 3], [0.75, 0, 0.1]
        ),
        "Axes 2 and 3 are parallel": lie("meet", "parallel"),
    },
    "04.13": {
        "Seven frames on six bare axes": six,
        "z4 is on the axis of joint 5": NAMES,
        "Axes 4, 5 and 6 meet": wrist_meets,
        "There o4 and o5 stand": wrist_meets,
    },
    "04.14": {
        "The wrist's axes meet": wrist_meets,
        "All else was allowed": one_too_far,
        "In the wrist two axes meet": wrist_meets,
    },
    "04.5": {
        "θ and d about and along the old z": always(facts.new_z_after_tipping,
                                                    facts.last_column_of_standard),
        "Row by row: turn about z_{i-1}": always(facts.last_column_of_standard),
        "If not, it is negative": always(facts.left_hands_count_backwards),
    },
    "04.8": {
        "α2 goes from z1 to z2": always(facts.z_hangs_on_five),
    },
    "04.6": {"Between parallel axes the origin": always(facts.sum_of_d_counts)},
    "04.9": {
        "The difference is constant in the tool's": always(
            lambda: constant("tool") and not constant("base")
        ),
    },
    "04.15": {
        "Six bare axes, seven frames": six,
        "All z first": DO,
        "Then pair by pair": lie("meet", "parallel", "skew", "meet", "meet"),
        "Where they are skew": DO,
    },
}  # fmt: skip
