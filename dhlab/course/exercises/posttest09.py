"""What lesson 09 draws and says of the order of the work and of the post-test."""

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...doctor.programs.wrong.links import standard
from ...robots import load
from ...table import DHTable
from ..kinds import Known, Mistakes, Said

__all__ = [
    "THROWN_AWAY",
    "between",
    "draw_craig",
    "draw_flange",
    "draw_rows",
    "explain_work",
    "half_moved",
    "misread_arrow",
    "misread_rows",
    "reversed_product",
]


THROWN_AWAY = Said(
    "only the last row's matrix comes out",
    next="Each turn of the loop throws the product away: T must stand on the right of = too.",
)


def draw_craig(rng: np.random.Generator) -> dict[str, DHTable]:
    """A table of the KR6's build in Craig's convention; the lengths in whole centimetres."""
    base, shoulder, upper, elbow, fore, hand = (
        int(rng.integers(low, high)) / 100
        for low, high in ((30, 50), (2, 8), (25, 45), (9, 15), (46, 60), (16, 24))
    )
    rows: list[list[float]] = [
        [0, base, 0, 0],
        [0, 0, shoulder, -90],
        [-90, 0, upper, 0],
        [0, fore, elbow, -90],
        [0, 0, 0, 90],
        [180, hand, 0, -90],
    ]
    return {"table": DHTable.craig(rows, angle="deg")}


def half_moved(table: DHTable) -> Mistakes:
    """What half a conversion of a table looks like, put into the standard matrix."""
    given, right = Arm(table), Arm(table).to("standard")
    rows, moved, still = (
        given.table.rows,
        right.table.rows,
        "θ and d belong to the joint, a and α together to the link behind it.",
    )
    down = np.column_stack([rows[:, :2], np.vstack([np.zeros(2), rows[:-1, 2:]])])
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
        *(
            (
                "conversion-incomplete",
                "the last row still holds a pair, and behind the last joint there is no link",
                np.vstack([moved[:-1], [*moved[-1, :2], *pair]]),
            )
            for pair in rows[1:, 2:]
        ),
        *(
            (
                "conversion-incomplete",
                "whole rows moved up, and θ and d belong to a joint: they stay",
                np.vstack([rows[1:], last]),
            )
            for last in (0 * rows[0], rows[0], rows[-1])
        ),
        *(
            (
                "conversion-incomplete",
                "θ moved up with a and α, and it belongs to the joint: it stays",
                np.column_stack([[*rows[1:, 0], last], moved[:, 1:]]),
            )
            for last in (0.0, rows[0, 0], rows[-1, 0])
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
    yield ("a-d-exchanged", "the distance is d, and a is asked", [alpha, there[1]])
    yield ("theta-alpha-exchanged", "the angle is θ, and α is asked", [there[0], a])
    yield (
        "standard-rows-in-craig-matrix",
        "these are θ and d of the earlier joint's row",
        [here[0], here[1]],
    )
    for i, (_, _, other_a, other_alpha) in enumerate(
        table.rows * [180 / np.pi, 1, 1, 180 / np.pi], 1
    ):
        if i != joint + 1:
            yield (
                "standard-rows-in-craig-matrix",
                f"the distance is a of row {i}, which leads to another axis",
                [alpha, other_a],
            )
            yield (
                "standard-rows-in-craig-matrix",
                f"the angle is α of row {i}, which leads to another axis",
                [other_alpha, a],
            )


def reversed_product(rows: NDArray, q: NDArray) -> NDArray:
    T = np.eye(4)
    for (theta, d, a, alpha), value in zip(rows, q):
        T = standard(theta + value, d, a, alpha) @ T
    return T
