"""Lesson 09: an arm of one's own, and the post-test."""

import numpy as np

from dhlab.course.exercises.answers09 import unrepaired

from .. import facts
from ..chosen import OPTIONS, Q, article
from ..facts import how
from ..reasons import DO, NAMES, STORY, always, is_pose, near
from ..tables import lines
from ..vectors import ARTICLE, walk

COUNTS = 4096


def wrist_of_ar4(g):
    """Of the right arm the lines of joints 4, 5 and 6 meet as far behind the flange as is given; 5
    is across the forearm, 6 along the tool.
    """
    arm, end = g["exercise"].right_arm(g["variant"]), g["end"]
    found = lines(arm, np.zeros(6))
    centre = end[:3, 3] - g["hand"] * end[:3, 2]
    return (
        len(found) == 6
        and all(near(np.cross(centre, line[:3]), line[3:]) for line in found[3:])
        and np.isclose(found[4][:3] @ found[3][:3], 0)
        and near(np.abs(found[5][:3]), np.abs(end[:3, 2]))
    )


def between(g):
    """Angle and distance of two axes, from their lines at q = 0."""
    table, k = g["table"], g["joint"]
    rows = table.rows * [180 / np.pi, 1, 1, 180 / np.pi]
    axes = []
    for n in (k, k + 1):  # the axis of joint n is z of its frame
        T = walk(rows[:n], [0] * n, "craig")
        axes.append((T[:3, 3], T[:3, 2]))
    (p, u), (s, v) = axes
    across = np.cross(u, v)
    told = np.degrees(np.arctan2(np.linalg.norm(across), u @ v)), abs((s - p) @ across)
    return (
        how(*axes) == "skew"
        and near(np.abs(g["right"]), [told[0], told[1] / np.linalg.norm(across)], by=1e-4)
        and near(g["right"], rows[k, [3, 2]], by=1e-6)
    )


def moved_up(g):
    rows = g["table"].rows * [180 / np.pi, 1, 1, 180 / np.pi]
    return near(g["right"][:, :2], rows[:, :2]) and near(g["right"][:, 2:], [*rows[1:, 2:], [0, 0]])


def right_for_one(g):
    """The program is right of one joint, and not of two."""
    e, rows, q = g["exercise"], np.array(ARTICLE) * [np.pi / 180, 1, 1, np.pi / 180], np.radians(Q)
    one, two = ((rows[:n], q[:n]) for n in (1, 2))
    return near(e.handed_out(*one), e.answer(*one)) and not near(e.handed_out(*two), e.answer(*two))


def one_of_24(g):
    typed = next(unrepaired())[2].table.rows * [180 / np.pi, 1, 1, 180 / np.pi]
    return typed.size == 24 and (~np.isclose(typed, g["right"])).sum() == 1


def at_the_stop(g):
    sign, offset = g["right"]
    degrees = sign * g["at_stop"] * 360 / COUNTS + offset
    return sign == -1 and np.isclose((degrees - g["stop"] + 180) % 360, 180)


SAID = {
    "09.1": {"That is the way through": STORY, "A doctor needs a patient": NAMES},
    "09.2": {
        "Six lines and an end": wrist_of_ar4,
        "The lines of joints 4, 5 and 6": wrist_of_ar4,
        "The right thumb along the line": DO,
    },
    "09.5": {
        "The third column": lambda g: near(g["right"], g["T"][:3, 2]),
        "Three columns are arrows": lambda g: is_pose(g["T"]),
        "Written in the base means": always(facts.arrows_are_columns),
    },
    "09.6": {
        "α is the angle, a the distance": between,
        "Two of the four numbers speak": between,
        "The heading says": lambda g: all(
            name in str(g["table"]) for name in ("a(i-1)", "alpha(i-1)")
        ),
    },
    "09.7": {"θ and d stay, a and α move up": moved_up, "In Craig's table, row 2": moved_up},
    "09.8": {
        "The base's matrix stands on the left": always(
            facts.right_factor_in_new_frame,
            lambda: near(walk(ARTICLE[:3], Q[:3]) @ walk(ARTICLE[3:], Q[3:]), article(Q)),
        ),
        "For an arm of one joint": right_for_one,
    },
    "09.9": {"The point lies on the axis": always(OPTIONS["09.9", "last-angles"])},
    "09.3": {
        "One number of 24": one_of_24,
        "The maker's own program had it": STORY,
        "It names the α of a link": NAMES,
        "A Craig row begins with": always(facts.z_of_craig),
    },
    "09.10": {
        "Two numbers from one reading": STORY,
        "The cell below asks": NAMES,
        "At the stop you know both": at_the_stop,
        "The encoder counts down": at_the_stop,
        "The offset is what makes": at_the_stop,
    },
    "09.4": {
        "From a sheet of paper": STORY,
        "Two units must be changed": NAMES,
        "dh.assign_frames takes pairs": DO,
    },
}
