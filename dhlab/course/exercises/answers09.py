"""What lesson 09 draws, what is right, and what the wrong answers are told:
axes of three arms, half a conversion, the post-test.
"""

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...doctor.programs.wrong.links import standard
from ...geometry.frames import assign_frames
from ...robots import load
from ...table import DHTable
from ...transform import from_xyz_rpy
from ..kinds import Known, Mistakes, Said

__all__ = [
    "AR4",
    "MAKERS",
    "PIPER",
    "between",
    "draw_flange",
    "draw_rows",
    "explain_work",
    "half_moved",
    "misread_arrow",
    "misread_rows",
    "reversed_product",
    "unrepaired",
    "wrong_axes",
    "wrong_piper",
]

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
PIPER: Any = (
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
MAKERS: list[list[float]] = [
    [0, 0.16977, 0, 0],
    [-90, 0, 0.0642, -90],
    [0, -0.007, 0.305, 0],
    [0, 0.22263, 0, -90],
    [0, 0, 0, 90],
    [180, 0.041, 0, -90],
]


MILLIMETRES = {
    "all": "in other units: the points and the end in millimetres; metres are asked",
    "points": "in other units: the points of the axes in millimetres; metres are asked",
    "end": "in other units: the end in millimetres; metres are asked",
}


def wrong_axes(axes: list, end: NDArray) -> Mistakes:
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
    yield "length-unit", MILLIMETRES["all"], assign_frames(thousand, end=metres)
    yield "length-unit", MILLIMETRES["points"], assign_frames(thousand, end=end)
    yield "length-unit", MILLIMETRES["end"], assign_frames(axes, end=metres)


def _wrong_lines(axes, end):
    for k, (point, z) in enumerate(axes):
        yield (
            "joint-reversed",
            Said(
                f"the direction of joint {k + 1} is reversed",
                next="Which way does the sheet's arrow point? A joint turns by the right hand.",
            ),
            assign_frames(_with(axes, k, (point, np.negative(z))), end=end),
        )
        for other in ([1, 0, 0], [0, 1, 0], [0, 0, 1]):
            yield (
                "z-across-joint-axis",
                Said(
                    f"the direction of joint {k + 1} is another one",
                    next="About which line does this joint turn, seen in the sheet?",
                ),
                assign_frames(_with(axes, k, (point, other)), end=end),
            )
        if k:
            yield (
                "length-value",
                Said(f"axis {k + 1} goes through the point that axis {k} was given"),
                assign_frames(_with(axes, k, (axes[k - 1][0], z)), end=end),
            )
        for i, name in enumerate("xyz"):
            mirrored = np.array(point, dtype=float)
            mirrored[i] *= -1
            yield (
                "length-sign",
                Said(f"the {name} of the point on axis {k + 1} has the other sign"),
                assign_frames(_with(axes, k, (mirrored, z)), end=end),
            )


def _with(axes, k, axis):
    return [*axes[:k], axis, *axes[k + 1 :]]


def wrong_piper() -> Mistakes:
    axes, end = PIPER
    yield from wrong_axes(axes, end)
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
            [0.0, 0.0, np.deg2rad(85)],
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


def unrepaired() -> Mistakes:
    typed = [*MAKERS[:5], [*MAKERS[5][:3], 180]]
    yield (
        "alpha-value",
        Said(
            "nothing is changed yet",
            next="Ask dh.diagnose about typed first: which number does it name?",
        ),
        Arm(DHTable.craig(typed, angle="deg"), sign=load("ar4").sign),
    )


def half_moved() -> Mistakes:
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


def _in(arm, rows):
    theta, d, a, alpha = rows.T
    return replace(arm, table=DHTable("standard", theta, d, a, alpha, arm.table.joints))


def explain_work(steps: list[str]) -> Known | None:
    if steps.index("agree") > steps.index("axes"):
        return "wrong-frame-compared", "axes were drawn before it was agreed from where"
    if steps.index("frames") < steps.index("axes"):
        return "z-across-joint-axis", "frames were placed before the axes were known"
    if steps.index("doctor") < steps.index("compare"):
        return "convention-guessed", "the doctor has nothing to compare with yet"
    return "only-zero-pose-checked", "the measured poses come in at the wrong place"


def draw_flange(rng: np.random.Generator) -> dict[str, Any]:
    q = rng.uniform(0.3, 1.2, 7) * rng.choice([-1, 1], 7)
    return {"T": load("iiwa7").forward(q).round(3)}


def misread_arrow(T: NDArray) -> Mistakes:
    yield (
        "rotation-transposed",
        "this is the third row: the base's z arrow, seen from the hand",
        T[2, :3],
    )
    yield "rotation-block-misread", "this is the hand's x arrow", T[:3, 0]
    yield "rotation-block-misread", "this is the hand's y arrow", T[:3, 1]
    yield "rotation-block-misread", "this is the hand's place", T[:3, 3]
    yield "pose-inverted", "this is the base's place, seen from the hand", np.linalg.inv(T)[:3, 3]
    yield "mirror", "this is the hand's z arrow turned round", -T[:3, 2]


def draw_rows(rng: np.random.Generator) -> dict[str, Any]:
    theta, alpha = rng.permutation([-75, -50, 25, 40]), rng.permutation([15, 35, 55, 80])
    d, a = rng.permutation([0.11, 0.17, 0.23, 0.31]), rng.permutation([0.12, 0.19, 0.26, 0.38])
    return {
        "table": DHTable.craig(np.column_stack([theta, d, a, alpha]).tolist(), angle="deg"),
        "joint": int(rng.integers(2, 4)),
    }


def between(table: DHTable, joint: int) -> list[float]:
    """Angle (deg) and distance (m) between the axes of a joint and the next, from a Craig table:
    the next row has them.
    """
    return [np.rad2deg(table.alpha[joint]), table.a[joint]]


def misread_rows(table: DHTable, joint: int) -> Mistakes:
    alpha, a = between(table, joint)
    here, there = (
        table.rows[joint - 1] * [180 / np.pi, 1, 1, 180 / np.pi],
        table.rows[joint] * [180 / np.pi, 1, 1, 180 / np.pi],
    )
    yield (
        "standard-rows-in-craig-matrix",
        "these are a and α of the earlier joint's row; in Craig's table the later joint's has them",
        [here[3], here[2]],
    )
    yield "columns-misread", "angle and distance have changed places", [a, alpha]
    yield (
        "a-d-exchanged",
        "the angle is right; the distance is d, and a is asked",
        [alpha, there[1]],
    )
    yield (
        "theta-alpha-exchanged",
        "the distance is right; the angle is θ, and α is asked",
        [there[0], a],
    )
    yield (
        "standard-rows-in-craig-matrix",
        "these are θ and d of the earlier joint's row",
        [here[0], here[1]],
    )


def reversed_product(rows: NDArray, q: NDArray) -> NDArray:
    T = np.eye(4)
    for (theta, d, a, alpha), value in zip(rows, q):
        T = standard(theta + value, d, a, alpha) @ T
    return T
