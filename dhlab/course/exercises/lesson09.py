"""Lesson 09, your own arm: axes to a table, a check against data, the doctor; and the post-test,
which mirrors the pre-test of lesson 00.
"""

from dataclasses import replace

import numpy as np

from ...arm import Arm
from ...doctor.programs.cases import SPECIAL, general_chain
from ...doctor.programs.wrong.links import standard
from ...doctor.programs.wrong.products import product
from ...geometry.frames import assign_frames
from ...robots import load
from ...table import DHTable
from ...transform import from_xyz_rpy
from ..kinds import Choice, Function, Option, Order, Prediction, Said, Table, Value

__all__ = ["EXERCISES", "AR4", "PIPER"]

# joint axes at the zero pose, (point in m, direction), and the flange's pose there
AR4 = (
    [
        ([0, 0, 0.16977], [0, 0, -1]),
        ([0.0642, 0, 0.16977], [0, 1, 0]),
        ([0.0642, -0.007, 0.47477], [0, 1, 0]),
        ([0.28683, -0.007, 0.47477], [1, 0, 0]),
        ([0.28683, -0.007, 0.47477], [0, 1, 0]),
        ([0.32783, -0.007, 0.47477], [1, 0, 0]),
    ],
    from_xyz_rpy([0.32783, -0.007, 0.47477], [0, np.pi / 2, 0]),
)
ALONG = np.array(
    [np.cos(np.deg2rad(5)), 0, np.sin(np.deg2rad(5))]
)  # the Piper's forearm at its zero pose: 5° up
WRIST = np.array([-0.03452, 0, 0.20536])
PIPER = (
    [
        ([0, 0, 0.123], [0, 0, 1]),
        ([0, 0, 0.123], [0, 1, 0]),
        ([-0.2824, 0, 0.16162], [0, 1, 0]),
        (WRIST, ALONG),
        (WRIST, [0, 1, 0]),
        (WRIST, ALONG),
    ],
    from_xyz_rpy(WRIST + 0.091 * ALONG, [0, np.deg2rad(85), 0]),
)
MAKERS = [
    [0, 0.16977, 0, 0],
    [-90, 0, 0.0642, -90],
    [0, -0.007, 0.305, 0],
    [0, 0.22263, 0, -90],
    [0, 0, 0, 90],
    [180, 0.041, 0, -90],
]


def _wrong_axes(axes, end):
    """Arms from axes with one slip each."""
    yield from _wrong_lines(axes, end)
    last = end.copy()
    last[:3, 3] = axes[-1][0]
    yield (
        "tool-missing",
        "the end was put where the last axis was given",
        assign_frames(axes, end=last),
    )
    untilted = np.eye(4)
    untilted[:3, 3] = end[:3, 3]
    yield (
        "tool-missing",
        "the end's directions are those of the base",
        assign_frames(axes, end=untilted),
    )
    metres = end.copy()
    metres[:3, 3] *= 1000
    thousand = [(np.multiply(point, 1000), z) for point, z in axes]
    yield "length-unit", "points and end", assign_frames(thousand, end=metres)
    yield "length-unit", "the points of the axes", assign_frames(thousand, end=end)
    yield "length-unit", "the end", assign_frames(axes, end=metres)


def _wrong_lines(axes, end):
    for k, (point, z) in enumerate(axes):
        yield (
            "joint-reversed",
            f"the direction of joint {k + 1}",
            assign_frames(_with(axes, k, (point, np.negative(z))), end=end),
        )
        for other in ([1, 0, 0], [0, 1, 0], [0, 0, 1]):
            yield (
                "z-across-joint-axis",
                f"the direction of joint {k + 1}",
                assign_frames(_with(axes, k, (point, other)), end=end),
            )
        if k:
            yield (
                "length-value",
                f"the point on axis {k + 1} is that of axis {k}",
                assign_frames(_with(axes, k, (axes[k - 1][0], z)), end=end),
            )
        for i, name in enumerate("xyz"):
            mirrored = np.array(point, dtype=float)
            mirrored[i] *= -1
            yield (
                "length-sign",
                f"the point on axis {k + 1}, {name}",
                assign_frames(_with(axes, k, (mirrored, z)), end=end),
            )


def _with(axes, k, axis):
    return [*axes[:k], axis, *axes[k + 1 :]]


def _wrong_piper():
    axes, end = PIPER
    yield from _wrong_axes(axes, end)
    for mistake, place, rpy in (
        ("angle-unit", "the end's angles were left in degrees", [0, 85, 0]),
        ("rotation-transposed", "the end's pitch has the other sign", [0, -np.deg2rad(85), 0]),
        (
            "roll-yaw-exchanged",
            "the end's angle was taken about another axis",
            [np.deg2rad(85), 0, 0],
        ),
        (
            "roll-yaw-exchanged",
            "the end's angle was taken about another axis",
            [0, 0, np.deg2rad(85)],
        ),
    ):
        yield mistake, place, assign_frames(axes, end=from_xyz_rpy(end[:3, 3], rpy))

    thousand = [(np.multiply(point, 1000), z) for point, z in axes]
    for points, place in (
        (thousand, "the points and the flange are in millimetres"),
        (axes, "the flange is in millimetres"),
    ):
        wrong = assign_frames(points, end=from_xyz_rpy(1000 * end[:3, 3], [0, 85, 0]))
        yield (
            "length-unit",
            Said(
                f"both units: {place}, its angles in degrees",
                next="dh.assign_frames takes metres, transform.from_xyz_rpy metres and radians.",
            ),
            wrong,
        )
    yield (
        "length-unit",
        Said(
            "both units: the points are in millimetres, the flange's angles in degrees",
            next="dh.assign_frames takes metres, transform.from_xyz_rpy radians.",
        ),
        assign_frames(thousand, end=from_xyz_rpy(end[:3, 3], [0, 85, 0])),
    )


def _unrepaired():
    typed = [*MAKERS[:5], [*MAKERS[5][:3], 180]]
    yield (
        "alpha-value",
        Said(
            "nothing is changed yet",
            next="Ask dh.diagnose about typed first: which number does it name?",
        ),
        Arm(DHTable.craig(typed, angle="deg"), sign=load("ar4").sign),
    )


def _half_moved():
    """What half a conversion of the KR6 looks like, put into the standard matrix."""
    given, right = load("kr6_r700"), load("kr6_r700").to("standard")
    rows, moved, still = (
        given.table.rows,
        right.table.rows,
        "θ and d belong to the joint, a and α together to the link behind it.",
    )
    down = np.column_stack([rows[:, :2], np.vstack([np.zeros(2), rows[:-1, 2:]])])
    kept = np.vstack([moved[:-1], rows[-1]])
    next_row = "In Craig's table row 2 leads from axis 1 to axis 2. Which standard row does that?"
    known = [
        ("craig-rows-in-standard-matrix", "these are still Craig's rows", rows),
        (
            "a-alpha-from-previous-row",
            "a and α moved down, and to the standard convention they move up",
            down,
        ),
        (
            "conversion-incomplete",
            "a moved, α did not",
            np.column_stack([rows[:, :2], moved[:, 2], rows[:, 3]]),
        ),
        (
            "conversion-incomplete",
            "α moved, a did not",
            np.column_stack([rows[:, :3], moved[:, 3]]),
        ),
        (
            "conversion-incomplete",
            "the last row still holds a pair, and behind the last joint there is no link",
            kept,
        ),
    ]
    for mistake, headline, wrong in known:
        yield mistake, Said(headline, why=still, next=next_row), _in(right, wrong)
    yield (
        "angle-unit",
        Said(
            "the angles are in radians",
            next="This answer takes degrees, as the task says: np.rad2deg for θ and α.",
        ),
        _in(right, moved * [np.pi / 180, 1, 1, np.pi / 180]),
    )


def _in(arm, rows):
    return replace(arm, table=DHTable("standard", *rows.T, arm.table.joints))


def _explain_work(letters):
    if letters.index("d") > letters.index("b"):
        return "wrong-frame-compared", "axes were drawn before it was agreed from where"
    if letters.index("c") < letters.index("b"):
        return "z-across-joint-axis", "frames were placed before the axes were known"
    if letters.index("e") < letters.index("a"):
        return "convention-guessed", "the doctor has nothing to compare with yet"
    return "only-zero-pose-checked", "the measured poses come in at the wrong place"


def _draw_flange(rng):
    q = rng.uniform(0.3, 1.2, 7) * rng.choice([-1, 1], 7)
    return {"T": load("iiwa7").forward(q).round(3)}


def _misread_arrow(T):
    yield (
        "rotation-transposed",
        "this is the third row: the base's z arrow, seen from the hand",
        T[2, :3],
    )
    yield "rotation-block-misread", "this is the hand's x arrow", T[:3, 0]
    yield "rotation-block-misread", "this is the hand's y arrow", T[:3, 1]
    yield "rotation-block-misread", "this is the hand's place", T[:3, 3]
    yield "pose-inverted", "", np.linalg.inv(T)[:3, 3]
    yield "mirror", "the arrow points the other way", -T[:3, 2]


def _draw_rows(rng):
    theta, alpha = rng.permutation([-75, -50, 25, 40]), rng.permutation([15, 35, 55, 80])
    d, a = rng.permutation([0.11, 0.17, 0.23, 0.31]), rng.permutation([0.12, 0.19, 0.26, 0.38])
    return {
        "table": DHTable.craig(np.column_stack([theta, d, a, alpha]).tolist(), angle="deg"),
        "joint": int(rng.integers(2, 4)),
    }


def _between(table, joint):
    """Angle (deg) and distance (m) between the axes of a joint and the next, from a Craig table:
    the next row has them.
    """
    return [np.rad2deg(table.alpha[joint]), table.a[joint]]


def _misread_rows(table, joint):
    alpha, a = _between(table, joint)
    here, there = (
        table.rows[joint - 1] * [180 / np.pi, 1, 1, 180 / np.pi],
        table.rows[joint] * [180 / np.pi, 1, 1, 180 / np.pi],
    )
    yield (
        "standard-rows-in-craig-matrix",
        "in Craig's convention these stand in the row of the later joint",
        [here[3], here[2]],
    )
    yield "columns-misread", "the angle is asked first, then the distance", [a, alpha]
    yield "a-d-exchanged", "the distance", [alpha, there[1]]
    yield "theta-alpha-exchanged", "the angle", [there[0], a]
    yield "angle-unit", "degrees were asked", [np.deg2rad(alpha), a]
    yield "length-unit", "metres were asked", [alpha, 1000 * a]
    yield "standard-rows-in-craig-matrix", "theta and d of the earlier joint", [here[0], here[1]]


def _reversed_product(rows, q):
    T = np.eye(4)
    for (theta, d, a, alpha), value in zip(rows, q):
        T = standard(theta + value, d, a, alpha) @ T
    return T


EXERCISES = [
    Order(
        id="09.1",
        title="The order of the work",
        items={
            "a": "compare with poses at general q",
            "b": "draw the joint axes, with the sense of positive motion",
            "c": "place frames, read off the table",
            "d": "agree on base, zero pose and end point",
            "e": "ask the doctor about what is left",
        },
        accepts=lambda letters: letters == ["d", "b", "c", "a", "e"],
        explain=_explain_work,
        praise="That is the way through this lesson, and through every arm.",
        hints=(
            "What must be known before the first axis can be written as numbers?",
            "A doctor needs a patient and findings: a table, and poses that it misses.",
        ),
    ),
    Prediction(
        id="09.P1",
        title="Your rows and the maker's",
        options={
            "a": "the same numbers, row for row",
            "b": "other numbers in places, and the same arm",
            "c": "another arm",
        },
        correct="b",
        outcome=(
            "three x arrows point the other way, so two lengths and some angles have other signs."
            " Every pose agrees."
        ),
    ),
    Table(
        id="09.2",
        title="Two axes of an AR4",
        points=2,
        answer=assign_frames(AR4[0], end=AR4[1]),
        mistakes=lambda: _wrong_axes(*AR4),
        praise="Six lines and an end: the arm is known.",
        hints=(
            "Joint 5 nods the hand: about which line? Joint 6 spins it: about which?",
            (
                "The lines of joints 4, 5 and 6 meet in the wrist's centre; the fifth lies across"
                " the forearm, the sixth along the tool."
            ),
        ),
    ),
    Prediction(
        id="09.P2",
        title="A table and a URDF of one arm",
        options={
            "a": "less than a millimetre",
            "b": "about a centimetre",
            "c": "more than a metre",
        },
        correct="c",
        outcome=(
            "the ROS file counts from a base that is turned by 180° about z. Each is right in its"
            " own base: name the base, and nothing is left."
        ),
    ),
    Table(
        id="09.3",
        title="The smallest fix: a table from the maker's program",
        points=2,
        answer=Arm(DHTable.craig(MAKERS, angle="deg"), sign=load("ar4").sign),
        mistakes=_unrepaired,
        praise=(
            "One number of 24. The maker's own program had it wrong in one place, and right in"
            " another."
        ),
        hints=(
            "Read the poses, call dh.diagnose as before, and read its first two lines.",
            (
                "It names a row and a number of that row. Is the convention's row 6 what you think"
                " it is?"
            ),
        ),
    ),
    Table(
        id="09.4",
        title="A Piper from its sheet",
        points=3,
        answer=assign_frames(PIPER[0], end=PIPER[1]),
        mistakes=_wrong_piper,
        praise="From a sheet of paper to an arm, on your own.",
        hints=(
            "Two units must be changed on the way in. Which?",
            (
                "dh.assign_frames takes pairs (point, direction) in metres, and end as a pose:"
                " transform.from_xyz_rpy makes one, in radians."
            ),
        ),
    ),
    Value(
        id="09.5",
        title="A column of a pose",
        mirrors="00.2",
        draw=_draw_flange,
        answer=lambda T: T[:3, 2],
        mistakes=_misread_arrow,
        tolerance=2e-3,
        entries=("x0", "y0", "z0"),
        praise="The third column: the hand's z arrow, written in the base.",
        hints=(
            "Three columns are arrows, one is a place. In which order?",
            "Written in the base means: read downwards.",
        ),
    ),
    Value(
        id="09.6",
        title="What a row says of two axes",
        mirrors="00.3",
        draw=_draw_rows,
        answer=_between,
        mistakes=_misread_rows,
        entries=("angle", "distance"),
        turns=(0,),
        tolerance=1e-4,
        praise=(
            "α is the angle, a the distance; in Craig's table they stand in the later joint's row."
        ),
        hints=(
            "Two of the four numbers speak of two axes, two of a single one. Which are which?",
            "The heading says a(i-1) and alpha(i-1). In which row is i - 1 your joint?",
        ),
    ),
    Table(
        id="09.7",
        title="Two tables of one arm",
        mirrors="00.4",
        points=2,
        answer=load("kr6_r700").to("standard"),
        mistakes=_half_moved,
        praise="θ and d stay, a and α move up one row.",
        hints=(
            (
                "Which of the columns belong to the joint itself, and which to the way from one"
                " joint to another?"
            ),
            (
                "In Craig's table, row 2 holds what leads from axis 1 to axis 2. In which row does"
                " the standard convention keep it?"
            ),
        ),
    ),
    Function(
        id="09.8",
        title="The order of a product",
        mirrors="00.5",
        draw=general_chain,
        special=SPECIAL["forward_kinematics"],
        answer=product,
        names=("rows", "q"),
        family="forward_kinematics",
        handed_out=_reversed_product,
        praise="Two letters changed places.",
        hints=(
            "For an arm of one joint this program is right. What happens at the second?",
            "Where must a matrix stand that is written in the frame reached so far?",
        ),
    ),
    Choice(
        id="09.9",
        title="What agreeing positions prove",
        mirrors="00.6",
        points=2,
        correct="b",
        hints=(
            "Which numbers of a table turn the hand without moving the measured point?",
            "The point lies on the axis of joint 7. What can turn about that axis unseen?",
        ),
        options={
            "a": Option(
                "nothing: twelve general poses are plenty",
                "They are plenty for what they see. A turn of the hand about the measured point is"
                " nothing they see.",
                "only-position-checked",
            ),
            "b": Option(
                "the last row's angles: they turn the hand and leave the point where it is",
                "Position and rotation, at general values: both, or the end is half known.",
            ),
            "c": Option(
                "the lengths of the middle rows",
                "Each of these moves the point, and twelve general poses would show it.",
                "length-value",
            ),
            "d": Option(
                "the sense of one of the first joints",
                "A joint that counts backwards carries the point elsewhere in all twelve.",
                "joint-reversed",
            ),
        },
    ),
]
