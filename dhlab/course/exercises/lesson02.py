"""Lesson 02, the parameter table: what θ, d, a and α are measured about, reading them off a link,
why four are enough.
"""

from ..kinds import Choice, Option, Order, Prediction, Value
from ..kinds.tabled.copied import Copied
from .answers02 import (
    ENTRIES,
    array_in_row,
    draw_first,
    draw_second,
    draw_tube,
    misread,
    read_off,
    tube,
    wrong_tubes,
)
from .axes02 import MEASURED, explain_axes
from .tables02 import draw_poses, draw_printed, makeable, miscopied, misjudged, printed_arm

__all__ = ["EXERCISES"]

EXERCISES = [
    Order(
        id="02.1",
        title="About and along which arrow",
        question=("Where is each of the four measured? Four letters; two are left over."),
        places=("θ", "d", "a", "α"),
        items={
            "along-new-x": "a length along new x",
            "about-old-z": "an angle about old z",
            "along-old-x": "a length along old x",
            "about-new-x": "an angle about new x",
            "along-old-z": "a length along old z",
            "about-new-z": "an angle about new z",
        },
        accepts=lambda order: order == MEASURED,
        explain=explain_axes,
        praise="About old z, along old z, along new x, about new x.",
        hints=(
            "Two of the numbers are angles, two are lengths. Which are which?",
            "The first two belong to the old plate's z, the last two to the new plate's x.",
        ),
    ),
    Prediction(
        id="02.P1",
        title="α alone is changed",
        question="What does the new origin do?",
        options={
            "up-or-down": "it moves up or down",
            "stays": "it stays where it is",
            "swings": "it swings round the old z axis",
        },
        correct="stays",
        outcome=(
            "α turns about x1, and the origin lies on x1: it stays. Only the y1 and z1 arrows tip."
        ),
    ),
    Choice(
        id="02.2",
        title="The number that moves",
        question=(
            "Joint 1 slides along its axis. Which number of row 1 changes while the arm moves?"
        ),
        correct="link-offset",
        hints=(
            (
                "A joint moves about or along its own axis, z of the old plate. Which two numbers"
                " are measured there?"
            ),
            "One of these two is a turn, the other a shift.",
        ),
        options={
            # the letters of these two are their names
            "link-length": Option(
                "the link length a",
                "a is the link's own length, from axis to axis. No joint changes it.",
                "a-d-exchanged",
            ),
            "joint-angle": Option(
                "the joint angle θ",
                "θ is the variable of a joint that turns. This one slides, and θ stays what it is.",
                "prismatic-variable-in-theta",
            ),
            "all-four": Option(
                "all four",
                "A joint has one motion, so one number moves. The other three are the link's"
                " shape.",
                "four-numbers-for-any-pose",
            ),
            "link-offset": Option(
                "the link offset d",
                "A sliding joint moves along old z: d is its variable, and θ, a and α are"
                " constants.",
            ),
        },
    ),
    Value(
        id="02.4",
        title="A link that goes backwards",
        points=2,
        draw=draw_second,
        answer=read_off,
        mistakes=misread,
        misshapen=array_in_row,
        entries=ENTRIES,
        turns=(0, 3),
        units=("deg", "m", "m", "deg"),
        praise="a is negative, and rightly so: the link goes against x1. α has its sign too.",
        hints=(
            "x1 is given: you may not turn it round. Which sign has its product with the origin?",
            "np.arctan2(y, x) keeps both signs; np.arctan and np.arccos lose one.",
        ),
    ),
    Prediction(
        id="02.P3",
        title="One step aside",
        question="Can one row make it?",
        options={
            "by-d": "yes: d = 0.1",
            "by-theta-and-a": "yes: θ = 90°, a = 0.1",
            "no": "no: a row that reaches the place arrives turned",
        },
        correct="no",
        outcome=(
            "θ = 90° and a = 0.1 reach the place, but the plate arrives turned by 90°. Nothing"
            " later in the row can turn it back."
        ),
    ),
    Choice(
        id="02.5",
        title="Why four are enough",
        question="By which rule are four numbers enough?",
        correct="two-conditions",
        hints=(
            "Six numbers for a free plate. How many conditions does the rule for x put on it?",
            "Where must the new x axis lie, seen from the old z axis?",
        ),
        options={
            "any-two-plates": Option(
                "any two plates are joined by four numbers",
                "A free plate has six: three for its place, three for its turn. The step aside"
                " above needs one that no row has.",
                "four-numbers-for-any-pose",
            ),
            "two-conditions": Option(
                "x of the new plate meets the old z, at a right angle: two conditions, and 6 −"
                " 2 = 4",
                "Meeting it takes away one freedom, the right angle another. The two numbers are"
                " hidden in how the frames were placed.",
            ),
            "one-freedom": Option(
                "a joint has only one freedom, so the other numbers are not needed",
                "One number moves, true. But the link's shape between two joints has to be said as"
                " well.",
                "four-numbers-for-any-pose",
            ),
            "pointing-away": Option(
                "x of the new plate must point away from the old z, so two signs are fixed",
                "It may point either way; a and α change their signs with it, and the θ of this row"
                " and of the next one by 180°.",
                "minus-taken-for-error",
            ),
        },
    ),
    Value(
        id="02.8",
        title="The bent upper arm of an xArm6",
        points=2,
        draw=draw_tube,
        answer=tube,
        mistakes=wrong_tubes,
        misshapen=array_in_row,
        entries=ENTRIES,
        turns=(0, 3),
        units=("deg", "m", "m", "deg"),
        praise=(
            "Only the two axes count: 0.2895 m apart, on a line that leans by 79.35°. The bend is"
            " nowhere in the row."
        ),
        hints=(
            "How far apart are the two axes, as endless lines? Pythagoras knows.",
            (
                "x1 points from axis to axis. At q2 = 0 it goes 53.5 forward for 284.5 up:"
                " np.arctan2 gives its angle, and q2 is added."
            ),
        ),
    ),
    Prediction(
        id="02.P2",
        practice=True,
        title="A tape measure between two origins",
        question="What does the tape say?",
        options={
            "a-alone": "0.40 m, that is a",
            "hypotenuse": "0.50 m",
            "sum": "0.70 m, that is d + a",
        },
        correct="hypotenuse",
        outcome=(
            "d and a stand at right angles, so the tape says √(0.3² + 0.4²) = 0.5 m: neither d"
            " nor a."
        ),
    ),
    Value(
        id="02.3",
        practice=True,
        title="Read a row off a link",
        points=2,
        draw=draw_first,
        answer=read_off,
        mistakes=misread,
        misshapen=array_in_row,
        entries=ENTRIES,
        turns=(0, 3),
        units=("deg", "m", "m", "deg"),
        praise="θ off the first column, d and a off the origin, α off the last row.",
        hints=(
            "a is the part of the origin that lies along x1: which product gives it?",
            (
                "α is the angle from z0 to z1: row 3 holds sin α in the y column and cos α in the z"
                " column."
            ),
        ),
    ),
    Value(
        id="02.6",
        practice=True,
        title="Which poses can one row make",
        points=2,
        draw=draw_poses,
        answer=makeable,
        mistakes=misjudged,
        entries=("T_a", "T_b", "T_c", "T_d"),
        praise="Two conditions, and a pose that breaks one of them needs more than a row.",
        hints=(
            "Print both leftovers for each pose. A row leaves none.",
            "A minus sign before d or a is no objection; a leftover that is not 0 is.",
        ),
    ),
    Copied(
        id="02.7",
        practice=True,
        title="A maker's table in your own order",
        points=2,
        draw=draw_printed,
        answer=printed_arm,
        mistakes=miscopied,
        compared="Compare signs and digits with the printed table, number by number.",
        praise="The same numbers, each in its place: θ, d, a, α in degrees and metres.",
        hints=(
            "The printed rows hold θ, a, d, α. Which two change places?",
            "np.rad2deg turns the printed 1.5708 into 90.",
        ),
    ),
]
