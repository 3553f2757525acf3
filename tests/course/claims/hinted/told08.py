"""Lesson 08: speeds, and from a pose to joint values."""

import numpy as np

import dhlab as dh

from .. import facts
from ..chosen import Q, article, jacobian, turn
from ..reasons import DO, NAMES, STORY, accepted, always, near
from ..vectors import ARTICLE, jacobian_of, walk


def swings():
    """Every column by differences is the axis crossed with the lever from the frame before, above
    the axis itself.
    """
    p = article(Q)[:3, 3]
    before = [walk(ARTICLE[:k], Q[:k]) for k in range(6)]
    return near(jacobian(Q).T, [
        [*np.cross(T[:3, 2], p - T[:3, 3]), *T[:3, 2]] for T in before
    ], by=1e-5)  # fmt: skip


def slides():
    """Of the Stanford arm joint 3 slides: its column is an axis of length 1, and no turn."""
    column = jacobian_of("stanford", np.array([0.4, 0.8, 0.5, 0.3, -0.6, 0.2]))[:, 2]
    arm = dh.load("stanford")
    return (
        arm.table.joints == "RRPRRR"
        and np.isclose(np.linalg.norm(column[:3]), 1, atol=1e-6)
        and near(column[3:], [0, 0, 0])
    )


def of_eight(g):
    """Five of the eight lines make a right order, and three stand in none."""
    used = {key for ids in accepted(g["exercise"]) for key in ids}
    return (len(g["exercise"].items), len(used)) == (8, 5)


def moves_the_hand(g):
    q = np.array(g["q"]) * [np.pi / 180, np.pi / 180, 1, np.pi / 180, np.pi / 180, np.pi / 180]
    J = jacobian_of("stanford", q)
    return J.shape == (6, 6) and near(J @ g["right"], [*g["v"], *g["omega"]], by=1e-3)


def third_column(g):
    return near(g["right"], jacobian_of("article-6r", np.radians(g["q"]))[:, 2], by=1e-3)


def pen(g):
    """The program is right without a tool, and the end is elsewhere with one."""
    e, moved = g["exercise"], 0
    for frames, end, *rest in e.cases(0)[:6]:
        bare = e.handed_out(frames, frames[-1], *rest)
        if not near(bare, e.answer(frames, frames[-1], *rest)):
            return False
        moved += not near(end[:3, 3], frames[-1][:3, 3])
    return moved > 0


def in_base(g):
    """The position part of the program is right, and the turn is another."""
    e = g["exercise"]
    return all(
        near(e.handed_out(*case)[:3], e.answer(*case)[:3])
        and not near(e.handed_out(*case), e.answer(*case))
        for case in e.cases(0)[:6]
    )


def other_wrist():
    """A wrist's turns about z, y and z: half a turn, the other sign, half a turn."""
    one = turn("z", 20) @ turn("y", 50) @ turn("z", -70)
    return near(one, turn("z", 200) @ turn("y", -50) @ turn("z", 110))


def eight(g):
    """Two by two by two answers, no two alike, and each reaches the pose."""
    e = g["exercise"]
    (T,) = e.cases(0)[0]
    found = np.degrees(e.answer(T))
    return len(np.unique(found.round(4), axis=0)) == 8 and all(near(article(q), T) for q in found)


def near_where_it_stands(g):
    """The right q reaches the pose, and no joint turns further than is allowed."""
    turned = np.degrees(g["right"]) - g["q_now"]
    return near(facts.ur5e(g["right"]), g["T"], by=1e-3) and np.abs(turned).max() <= 45


SAID = {
    "08.10": {
        "Frames and end, axis and origin": of_eight,
        "Three of the eight are wrong": of_eight,
    },
    "08.2": {
        "Turning or sliding": always(swings, slides),
        "For joint i, counted from 1": always(swings),
        "A turning joint gives": always(swings, slides),
        "Stack columns": DO,
    },
    "08.11": {
        "The lever runs to the tip": pen,
        "It was right until the pen": pen,
        "p is taken from the last frame": pen,
        "With a tool, the end": pen,
    },
    "08.9": {
        "A sliding joint among turning ones": moves_the_hand,
        "The Jacobian of the Stanford arm first": DO,
        "Joint 3 slides, so its column": always(slides),
        "Six equations, six unknown speeds": moves_the_hand,
    },
    "08.1": {
        "What joint 3 alone does": third_column,
        "Joint 3 turns about z of frame {2}": always(swings),
        "The lever runs from that origin": always(swings),
    },
    "08.4": {
        "Position and turn": NAMES,
        "As it is handed out, the position part": in_base,
        "You look for the turn": always(facts.turn_back_from_goal),
    },
    "08.5": {"Look where you are": of_eight, "Three of the eight lines": of_eight},
    "08.6": {
        "Inverse kinematics for any arm": STORY,
        "A loop over range(steps)": DO,
        "If the shapes do not fit": DO,
    },
    "08.13": {"It reaches the pose": near_where_it_stands, "Your loop asks for nothing": DO},
    "08.8": {"Two shoulders, two elbows": eight, "For the second wrist three": always(other_wrist)},
}
