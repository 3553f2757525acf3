"""Lesson 02, the parameter table: what θ, d, a and α are measured about, reading them off a link,
why four are enough.
"""

import numpy as np

from ...arm import Arm
from ...robots import load
from ...table import DHTable
from ...transform import rot_y, trans
from ..kinds import Choice, Option, Order, Prediction, Said, Value
from .drawn_table import DrawnTable
from .shaped_value import ShapedValue, as_numbers, is_array_of

__all__ = ["EXERCISES"]

ENTRIES = ("θ", "d", "a", "α")
UP, FORWARD = 0.2845, 0.0535  # the xArm6's upper arm, metres; UFACTORY's kinematic parameters


def link(theta, d, a, alpha):
    """The pose that one standard row makes; degrees and metres."""
    return Arm(DHTable.standard([[theta, d, a, alpha]], angle="deg")).forward([0.0])


def degrees(y, x):
    """The angle of the point (x, y), in degrees."""
    return float(np.rad2deg(np.arctan2(y, x)))


def read_off(T_01):
    """θ, d, a, α of a pose that one row makes; degrees and metres."""
    x, p = T_01[:3, 0], T_01[:3, 3]
    return [degrees(x[1], x[0]), p[2], x @ p, degrees(T_01[2, 1], T_01[2, 2])]


def _lengths(rng):
    """Two different lengths, metres."""
    d, a = rng.choice(np.arange(10, 46, 5), 2, replace=False) / 100
    return float(d), float(a)


def _draw_first(rng):
    d, a = _lengths(rng)
    return {
        "T_01": link(float(rng.choice([20, 30, 35, 40])), d, a, float(rng.choice([50, 55, 60, 70])))
    }


def _draw_second(rng):
    d, a = _lengths(rng)
    return {
        "T_01": link(
            float(rng.choice([110, 125, 140, 155])), d, -a, -float(rng.choice([20, 35, 50, 65]))
        )
    }


FALSE_TURN = Said(
    "α has the wrong sign",
    why=(
        "α goes from z0 to z1, counted about x1 as the fingers of the right hand curl. np.arccos"
        " forgets the sign."
    ),
    next="sin α has a sign too: in which entry of row 3 does it stand?",
)


def _misread(T_01):
    """What comes out when one of the four is taken otherwise."""
    theta, d, a, alpha = read_off(T_01)
    x, z, p = T_01[:3, 0], T_01[:3, 2], T_01[:3, 3]
    yield "angle-unit", "θ and α, in radians", [np.deg2rad(theta), d, a, np.deg2rad(alpha)]
    yield "angle-unit", "θ, in radians", [np.deg2rad(theta), d, a, alpha]
    yield "angle-unit", "α, in radians", [theta, d, a, np.deg2rad(alpha)]
    yield "a-d-exchanged", "", [theta, a, d, alpha]
    yield "theta-alpha-exchanged", "", [alpha, d, a, theta]
    yield (
        "length-along-the-part",
        "a: this is the distance of the two origins",
        [theta, d, np.linalg.norm(p), alpha],
    )
    yield (
        "measured-in-other-frame",
        "a: this is the step along x0, not along x1",
        [theta, d, p[0], alpha],
    )
    yield (
        "measured-in-other-frame",
        "α: this is the angle about x0, not about x1",
        [theta, d, a, degrees(-z[1], z[2])],
    )
    yield (
        "rotation-transposed",
        Said(
            "θ was read off the first row",
            next="x1 is the first column: its first two numbers, from top to bottom.",
        ),
        [degrees(T_01[0, 1], T_01[0, 0]), d, a, alpha],
    )
    yield (
        "atan-for-atan2",
        "θ: the two arguments have changed places",
        [degrees(x[0], x[1]), d, a, alpha],
    )
    yield (
        "atan-for-atan2",
        "α: the two arguments have changed places",
        [theta, d, a, degrees(T_01[2, 2], T_01[2, 1])],
    )
    if theta > 90:
        yield "atan-for-atan2", "θ: the quotient forgets both signs", [theta - 180, d, a, alpha]
    yield "alpha-sign", FALSE_TURN, [theta, d, a, -alpha]
    if a < 0:
        yield "lengths-made-positive", "a", [theta, d, -a, alpha]
        yield (
            "lengths-made-positive",
            "a: x1 was turned round to make it positive, but x1 is given",
            [theta - 180, d, -a, -alpha],
        )
        yield "lengths-made-positive", "a and α", [theta, d, -a, -alpha]


def _array_in_row(answer, T_01=None, q2=None):
    """A row of which an entry is an array."""
    entries = (
        [as_numbers(entry) for entry in answer]
        if isinstance(answer, (list, tuple)) and len(answer) == len(ENTRIES)
        else []
    )
    arrays = [k for k, entry in enumerate(entries) if entry.ndim and entry.size]
    if not arrays or len(arrays) == len(ENTRIES):
        return None
    name, entry = ENTRIES[arrays[0]], entries[arrays[0]]
    if T_01 is not None and is_array_of(entry, T_01[:3, 0] * T_01[:3, 3]):
        return "elementwise-product", Said(
            f"{name} is an array of three numbers: * in place of @",
            next="@ multiplies entry by entry and adds up: that is one number.",
        )
    return None, Said(
        f"{name} is an array, where one number belongs",
        next="Print it: which @ or which index is missing?",
    )


def _draw_poses(rng):
    """Four poses in the order of the seed: two that a row makes, one shifted along y1, one with a
    leaning x1.
    """
    (d1, a1), (d2, a2) = _lengths(rng), _lengths(rng)
    row = link(float(rng.choice([25, 40, 65])), d1, a1, float(rng.choice([30, 55, 70])))
    back = link(-float(rng.choice([20, 50, 75])), -d2, -a2, float(rng.choice([35, 60, 80])))
    aside = link(30.0, d2, a1, 40.0) @ trans([0, 0.08, 0])
    leaning = link(50.0, d1, a2, 35.0) @ rot_y(np.deg2rad(25))
    poses = [row, back, aside, leaning]
    return {f"T_{letter}": poses[k] for letter, k in zip("abcd", rng.permutation(4))}


def leftovers(T):
    """What no row can make: how far x leans towards the old z, and how far its line passes by it
    (m).
    """
    return T[2, 0], np.cross([0, 0, 1], T[:3, 0]) @ T[:3, 3]


def _makeable(**poses):
    return [float(max(map(abs, leftovers(T))) < 1e-9) for T in poses.values()]


def _misjudged(**poses):
    """All fifteen wrong answers, each with its first reason."""
    right, names = np.array(_makeable(**poses)), list(poses)
    yield (
        "four-numbers-for-any-pose",
        Said(
            "1 and 0 look exchanged",
            next="1 is for a pose that one row makes, and whose leftovers are both 0.",
        ),
        1 - right,
    )
    for code in range(16):
        given = np.array([code >> k & 1 for k in range(4)], dtype=float)
        if (given == right).all() or (given == 1 - right).all():
            continue
        k = int(np.argmax(given != right))
        yield *_reason(names[k], poses[names[k]], given[k]), given


def _reason(name, T, given):
    """Why the answer for one pose is wrong, as (mistake, place)."""
    look = f'Print leftovers(poses["{name}"])'
    if given:
        lean, _ = leftovers(T)
        if abs(lean) > 1e-9:
            return "x-not-across-z", Said(
                f"{name} cannot be made by one row: its x1 leans towards z0",
                next=f"{look}: both numbers must be 0.",
            )
        return "origin-off-common-normal", Said(
            f"{name} cannot be made by one row: its x1 passes z0 by",
            next=f"{look}: both numbers must be 0.",
        )
    if read_off(T)[2] < 0:
        return "minus-taken-for-error", Said(
            f"{name} can be made by one row",
            next=f"{look}. A minus sign in the pose is no objection.",
        )
    return "measured-in-other-frame", Said(
        f"{name} can be made by one row", next=f"{look}: is anything left over?"
    )


def _draw_printed(rng):
    """A UR arm's table as its maker prints it: θ (rad), a (m), d (m), α (rad)."""
    name = str(rng.choice(["ur3e", "ur10e", "ur5_cb", "ur10_cb"]))
    return {"arm": name, "rows": load(name).table.rows[:, [0, 2, 1, 3]].tolist()}


def _in_our_order(rows):
    return [[np.rad2deg(theta), d, a, np.rad2deg(alpha)] for theta, a, d, alpha in rows]


def _printed_arm(arm, rows):
    return Arm(DHTable.standard(_in_our_order(rows), angle="deg"))


def _miscopied(arm, rows):
    right = np.array(_in_our_order(rows))
    yield (
        "columns-misread",
        Said(
            "these are the rows as printed: θ, a, d, α, the angles in radians",
            next="Two columns change places, and the angles are wanted in degrees.",
        ),
        rows,
    )
    yield (
        "a-d-exchanged",
        Said("the columns stand as printed: θ, a, d, α", next="Which two change places?"),
        right[:, [0, 2, 1, 3]],
    )
    yield "angle-unit", "α, in radians", np.column_stack([right[:, :3], np.deg2rad(right[:, 3])])
    yield "angle-unit", "θ and α", np.rad2deg(right) * [1, 0, 0, 1] + right * [0, 1, 1, 0]
    for order in ([0, 3, 2, 1], [3, 1, 2, 0]):
        yield (
            "columns-misread",
            Said(
                "the columns stand in another order than θ, d, a, α",
                next="Print one row beside the maker's: where did each number go?",
            ),
            right[:, order],
        )
    yield (
        "lengths-made-positive",
        Said(
            "the minus signs are gone",
            why="d and a are coordinates along an arrow; α has its direction too.",
            next="Copy every number with its sign.",
        ),
        np.abs(right),
    )
    yield (
        "lengths-made-positive",
        Said(
            "the minus signs of d and a are gone",
            why="d and a are coordinates along an arrow: against it they are negative.",
            next="Copy every number with its sign.",
        ),
        np.column_stack([right[:, 0], np.abs(right[:, 1:3]), right[:, 3]]),
    )


def _draw_tube(rng):
    return {"q2": float(rng.integers(12, 60) * rng.choice([-1, 1]))}


def _tube(q2):
    return [q2 + degrees(UP, FORWARD), 0.0, float(np.hypot(UP, FORWARD)), 0.0]


SKETCH = (
    "Take the sketch at q2 = 0: at which angle to x0 does the straight line from axis 2 to axis"
    " 3 go?"
)


def _wrong_tubes(q2):
    offset, a = degrees(UP, FORWARD), float(np.hypot(UP, FORWARD))
    yield (
        "length-along-the-part",
        "a: this is the way along the tube",
        [q2 + offset, 0, UP + FORWARD, 0],
    )
    yield "length-along-the-part", "a: this is one piece of the tube", [q2 + offset, 0, UP, 0]
    yield "length-along-the-part", "a: this is one piece of the tube", [q2 + offset, 0, FORWARD, 0]
    yield "length-along-the-part", "θ and a follow the first piece of the tube", [q2 + 90, 0, UP, 0]
    yield (
        "a-d-exchanged",
        "the step of 53.5 mm does not run along the joint's axis",
        [q2 + 90, FORWARD, UP, 0],
    )
    yield (
        "a-d-exchanged",
        "the step of 53.5 mm does not run along the joint's axis",
        [q2 + offset, FORWARD, UP, 0],
    )
    yield "a-d-exchanged", "", [q2 + offset, a, 0, 0]
    yield (
        "offset-missing",
        Said("θ is q2 alone, but x1 leans by a constant angle, whatever q2 is", next=SKETCH),
        [q2, 0, a, 0],
    )
    yield (
        "joint-values-unused",
        Said(
            "θ is right at q2 = 0 only",
            next="q2 turns the whole tube: it is added to the angle at q2 = 0.",
        ),
        [offset, 0, a, 0],
    )
    yield (
        "offset-sign",
        Said(
            "the angle of x1 at q2 = 0 has the wrong sign in θ",
            next="Both are counted from x0 towards y0: is the tube above x0 or below it?",
        ),
        [q2 - offset, 0, a, 0],
    )
    yield (
        "offset-subtracted",
        Said(
            "q2 has the wrong sign in θ",
            next="Turn the tube by a small positive q2: does the angle from x0 grow?",
        ),
        [offset - q2, 0, a, 0],
    )
    yield "atan-for-atan2", "θ: the two arguments have changed places", [q2 + 90 - offset, 0, a, 0]
    yield "angle-unit", "θ", [np.deg2rad(q2 + offset), 0, a, 0]
    yield "angle-unit", "θ: radians were added to degrees", [q2 + np.deg2rad(offset), 0, a, 0]
    yield "length-unit", "a", [q2 + offset, 0, 1000 * a, 0]
    yield (
        "alpha-sign",
        "α: the two axes are parallel and point the same way",
        [q2 + offset, 0, a, 180],
    )
    yield (
        "measured-in-other-frame",
        "α: the tube is bent, the two axes are not",
        [q2 + offset, 0, a, offset],
    )


def _explain_axes(letters):
    of_plate = {"e": "θ", "f": "a"}  # the two that are left over, with the number that they imitate
    if any(letters[ENTRIES.index(name)] == letter for letter, name in of_plate.items()):
        places = ", ".join(
            name for letter, name in of_plate.items() if letters[ENTRIES.index(name)] == letter
        )
        return "measured-in-other-frame", Said(
            "the right kind of number, on the wrong plate",
            place=places,
            next="θ and d share one arrow, a and α another. Which plate's?",
        )
    kinds = [letter in "ade" for letter in letters]
    if kinds != [True, False, False, True]:
        places = ", ".join(
            name
            for name, angle, wanted in zip(ENTRIES, kinds, (True, False, False, True))
            if angle != wanted
        )
        return "columns-misread", Said(
            "an angle stands for a length, or a length for an angle",
            place=places,
            next="Greek letters are angles, Latin ones are lengths.",
        )
    if letters == ["d", "b", "c", "a"]:
        return "theta-alpha-exchanged", Said(
            "θ and α have changed places", next="Which of the two turns about old z?"
        )
    if letters == ["a", "c", "b", "d"]:
        return "a-d-exchanged", Said(
            "d and a have changed places", next="Which of the two goes along old z?"
        )
    places = ", ".join(
        name for name, letter, wanted in zip(ENTRIES, letters, "abcd") if letter != wanted
    )
    return "columns-misread", Said(
        "the right kinds of numbers, along or about the wrong arrows",
        place=places,
        next="Read the four lines below the picture once more.",
    )


EXERCISES = [
    Order(
        id="02.1",
        title="Which number is measured where",
        length=4,
        items={
            "a": "an angle about z of the old plate",
            "b": "a length along z of the old plate",
            "c": "a length along x of the new plate",
            "d": "an angle about x of the new plate",
            "e": "an angle about z of the new plate",
            "f": "a length along x of the old plate",
        },
        accepts=lambda letters: letters == ["a", "b", "c", "d"],
        explain=_explain_axes,
        praise="About old z, along old z, along new x, about new x.",
        hints=(
            "Two of the numbers are angles, two are lengths. Which are which?",
            "The first two belong to the old plate's z, the last two to the new plate's x.",
        ),
    ),
    Prediction(
        id="02.P1",
        title="α alone is changed",
        options={
            "a": "the new origin moves up or down",
            "b": "the new origin stays where it is",
            "c": "the new origin swings round the old z axis",
        },
        correct="b",
        outcome=(
            "α turns about x1, and the origin lies on x1: it stays. Only the y1 and z1 arrows tip."
        ),
    ),
    Choice(
        id="02.2",
        title="The number that moves",
        correct="b",
        hints=(
            (
                "A joint moves about or along its own axis, z of the old plate. Which two numbers"
                " are measured there?"
            ),
            "One of these two is a turn, the other a shift.",
        ),
        options={
            "a": Option(
                "the joint angle θ",
                "θ is the variable of a joint that turns. This one slides, and θ stays what it is.",
                "prismatic-variable-in-theta",
            ),
            "b": Option(
                "the link offset d",
                "A sliding joint moves along old z: d is its variable, and θ, a and α are"
                " constants.",
            ),
            "c": Option(
                "the link length a",
                "a is the link's own length, from axis to axis. No joint changes it.",
                "a-d-exchanged",
            ),
            "d": Option(
                "all four",
                "A joint has one motion, so one number moves. The other three are the link's"
                " shape.",
                "four-numbers-for-any-pose",
            ),
        },
    ),
    ShapedValue(
        id="02.3",
        title="Read a row off a link",
        points=2,
        draw=_draw_first,
        answer=read_off,
        mistakes=_misread,
        misshapen=_array_in_row,
        entries=ENTRIES,
        turns=(0, 3),
        praise="Two numbers off the first column and the origin, two about the new x.",
        hints=(
            "a is the part of the origin that lies along x1: which product gives it?",
            (
                "α is the angle from z0 to z1: row 3 holds sin α in the y column and cos α in the z"
                " column."
            ),
        ),
    ),
    Prediction(
        id="02.P2",
        title="A tape measure between two origins",
        options={"a": "0.40 m, that is a", "b": "0.50 m", "c": "0.70 m, that is d + a"},
        correct="b",
        outcome=(
            "d and a stand at right angles, so the tape says √(0.3² + 0.4²) = 0.5 m: neither d"
            " nor a."
        ),
    ),
    ShapedValue(
        id="02.4",
        title="A link that goes backwards",
        points=2,
        draw=_draw_second,
        answer=read_off,
        mistakes=_misread,
        misshapen=_array_in_row,
        entries=ENTRIES,
        turns=(0, 3),
        praise="a is negative, and rightly so: the link goes against x1. α has its sign too.",
        hints=(
            "x1 is given: you may not turn it round. Which sign has its product with the origin?",
            "np.arctan2(y, x) keeps both signs; np.arctan and np.arccos lose one.",
        ),
    ),
    Prediction(
        id="02.P3",
        title="One step aside",
        options={
            "a": "yes: d = 0.1",
            "b": "yes: θ = 90°, a = 0.1",
            "c": "no: a row that reaches the place arrives turned",
        },
        correct="c",
        outcome=(
            "θ = 90° and a = 0.1 reach the place, but the plate arrives turned by 90°. Nothing"
            " later in the row can turn it back."
        ),
    ),
    Choice(
        id="02.5",
        title="Why four are enough",
        correct="b",
        hints=(
            "Six numbers for a free plate. How many conditions does the rule for x put on it?",
            "Where must the new x axis lie, seen from the old z axis?",
        ),
        options={
            "a": Option(
                "any two plates are joined by four numbers",
                "A free plate has six: three for its place, three for its turn. The step aside"
                " above needs one that no row has.",
                "four-numbers-for-any-pose",
            ),
            "b": Option(
                "x of the new plate meets the old z, at a right angle: two conditions, and 6 −"
                " 2 = 4",
                "Meeting it takes away one freedom, the right angle another. The two numbers are"
                " hidden in how the frames were placed.",
            ),
            "c": Option(
                "a joint has only one freedom, so the other numbers are not needed",
                "One number moves, true. But the link's shape between two joints has to be said as"
                " well.",
                "four-numbers-for-any-pose",
            ),
            "d": Option(
                "x of the new plate must point away from the old z, so two signs are fixed",
                "It may point either way, and a changes its sign with it.",
                "minus-taken-for-error",
            ),
        },
    ),
    Value(
        id="02.6",
        title="Which poses can one row make",
        points=2,
        draw=_draw_poses,
        answer=_makeable,
        mistakes=_misjudged,
        entries=("T_a", "T_b", "T_c", "T_d"),
        praise="Two conditions, and a pose that breaks one of them needs more than a row.",
        hints=(
            "Print both leftovers for each pose. A row leaves none.",
            "A minus sign before d or a is no objection; a leftover that is not 0 is.",
        ),
    ),
    DrawnTable(
        id="02.7",
        title="Somebody else's columns",
        points=2,
        draw=_draw_printed,
        arm=_printed_arm,
        slips=_miscopied,
        praise="The same numbers, each in its place: θ, d, a, α in degrees and metres.",
        hints=(
            "The printed rows hold θ, a, d, α. Which two change places?",
            "np.rad2deg turns the printed 1.5708 into 90.",
        ),
    ),
    ShapedValue(
        id="02.8",
        title="The bent upper arm of an xArm6",
        points=2,
        draw=_draw_tube,
        answer=_tube,
        mistakes=_wrong_tubes,
        misshapen=_array_in_row,
        entries=ENTRIES,
        turns=(0, 3),
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
]
