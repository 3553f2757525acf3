"""What lesson 06 draws, what is right, and what the wrong answers are told:
the article's arm and its offsets, structures of four arms.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...doctor.programs.wrong.craig import craig
from ...doctor.programs.wrong.products import product
from ...robots import load
from ...table import DHTable
from ..kinds import Known, Mistakes, Said

__all__ = [
    "IN_THE_LOOP",
    "OF_LENGTHS",
    "STRUCTURES",
    "UPRIGHT",
    "draw_unseen",
    "explain_lengths",
    "explain_structures",
    "unseen_pose",
    "wrong_offsets",
    "wrong_unseen",
    "wrong_zero_poses",
    "zero_pose",
]

ARTICLE: list[list[float]] = [
    [0, 0.1, 0, 90],
    [0, 0, 0.4, 0],
    [0, 0, 0.35, 0],
    [0, 0.1, 0, 90],
    [0, 0, 0, -90],
    [0, 0.1, 0, 0],
]
UPRIGHT: list[list[float]] = [
    [0, 0.1, 0, 90],
    [90, 0, 0.4, 0],
    [-90, 0, 0.35, 0],
    [0, 0.1, 0, 90],
    [0, 0, 0, -90],
    [0, 0.1, 0, 0],
]


IN_DEGREES = np.array([180 / np.pi, 1, 1, 180 / np.pi])
THETA, ALPHA = np.eye(4)[[0, 3]]
LENGTHS = 1 - THETA - ALPHA


def _article_rows():
    return DHTable.standard(ARTICLE, angle="deg").rows


def zero_pose() -> NDArray:
    return product(_article_rows(), np.zeros(6))


def wrong_zero_poses() -> Mistakes:
    rows, q = _article_rows(), np.zeros(6)
    yield "alpha-in-degrees", "α went in in degrees", product(rows * IN_DEGREES, q)
    yield (
        "converted-to-radians-twice",
        Said("the rows were converted twice", next="`rows` is converted already: pass it on."),
        product(rows / IN_DEGREES, q),
    )
    yield from _of_the_chain(rows, q)


def _of_the_chain(rows, q):
    """Slips of the product that a finished pose can tell."""
    T = product(rows, q)
    yield (
        "standard-rows-in-craig-matrix",
        "this is what Craig's matrix makes of the rows",
        product(rows, q, link=craig),
    )
    yield "product-stops-early", "the last row was left out", product(rows[:-1], q[:-1])
    yield "product-starts-late", "the first row was left out", product(rows[1:], q[1:])
    yield "pose-inverted", "this is the base's pose, seen from the end", np.linalg.inv(T)
    yield "matrix-transposed", "", T.T
    turned = T.copy()
    turned[:3, :3] = T[:3, :3].T
    yield "rotation-transposed", "", turned
    yield "a-d-exchanged", "", product(rows[:, [0, 2, 1, 3]], q)
    yield "product-reversed", "the links are multiplied in the reverse order", _backwards(rows, q)
    bare = T.copy()
    bare[3] = 0
    yield "last-row-missing", "", bare


def _backwards(rows, q):
    """The product with its factors in the reverse order."""
    return product(rows[::-1], q[::-1])


def draw_unseen(rng: np.random.Generator) -> dict[str, Any]:
    return {"q": (rng.integers(15, 60, 6) * rng.choice([-1, 1], 6)).astype(float)}


def unseen_pose(q: list[float]) -> NDArray:
    return load("irb120").forward(np.deg2rad(q))


def wrong_unseen(q: list[float]) -> Mistakes:
    rows, q_rad = load("irb120").table.rows, np.deg2rad(q)
    no_offset = rows * [0, 1, 1, 1]
    for mistake, said, wrong, values in (
        (
            "converted-to-radians-twice",
            Said(
                "the rows were converted twice",
                next="Run the cell that makes irb120 once more, then convert once.",
            ),
            rows / IN_DEGREES,
            q_rad,
        ),
        (
            "length-unit",
            Said(
                "the lengths went through np.deg2rad too",
                next="Only θ and α are angles: convert these two columns.",
            ),
            rows / IN_DEGREES[0] ** LENGTHS,
            q_rad,
        ),
        ("degrees-in-sin-cos", "the rows were left in degrees", rows * IN_DEGREES, q_rad),
        ("degrees-in-sin-cos", "rows and q were left in degrees", rows * IN_DEGREES, q),
        ("degrees-in-sin-cos", "q was left in degrees", rows, q),
        ("alpha-in-degrees", "α was left in degrees", rows * IN_DEGREES[0] ** ALPHA, q_rad),
        ("offset-in-degrees", "θ was left in degrees", rows * IN_DEGREES[0] ** THETA, q_rad),
        ("converted-to-radians-twice", "q was converted twice", rows, np.deg2rad(q_rad)),
        ("offset-missing", "both offsets were left out", no_offset, q_rad),
        ("offset-counted-twice", "both offsets were added twice", rows * [2, 1, 1, 1], q_rad),
        ("offset-subtracted", "q was taken off the offsets, not added", rows, -q_rad),
        ("offset-sign", "the offset of joint 2 has the other sign", rows * [-1, 1, 1, 1], q_rad),
        ("joint-values-unused", "this is the pose at q = 0", rows, 0 * q_rad),
        (
            "joint-index-off-by-one",
            "every joint has the q of the joint behind it",
            rows,
            np.roll(q_rad, -1),
        ),
        (
            "joint-index-off-by-one",
            "every joint has the q of the joint before it",
            rows,
            np.roll(q_rad, 1),
        ),
    ):
        yield mistake, said, product(wrong, np.asarray(values, dtype=float))
    for k in np.flatnonzero(rows[:, 0]):
        alone = rows.copy()
        alone[k, 0] = 0
        yield (
            "offset-missing",
            Said(f"the offset of joint {k + 1} was left out", next="Which rows have a θ?"),
            product(alone, q_rad),
        )
    yield from _of_the_chain(rows, q_rad)


ON_THE_ARM = {
    "d1": "d1 runs along the first joint's axis: follow z0 in the picture.",
    "a2": "a2 runs across, from axis 2 to axis 3: what lies between them?",
    "a3": "a3 runs across, from axis 3 to axis 4: what lies between them?",
    "d4": "d runs along a joint's axis: follow z3, then z5, in the picture.",
}  # d6 is never the only wrong one


OF_LENGTHS = {
    "d1": "shoulder-height",
    "a2": "upper-arm",
    "a3": "forearm",
    "d4": "sideways",
    "d6": "wrist-to-tool",
}


def explain_lengths(parts: list[str]) -> Known | None:
    wrong = [name for part, (name, wanted) in zip(parts, OF_LENGTHS.items()) if part != wanted]
    exchanged = parts[0] == "upper-arm" or parts[1] == "shoulder-height"
    mistake = "a-d-exchanged" if exchanged else "length-value"
    headline = (
        f"{' and '.join(wrong)} are exchanged"
        if len(wrong) == 2
        else f"{', '.join(wrong)} are not in their places"
    )
    return mistake, Said(headline, next=ON_THE_ARM[wrong[0]])


SAYS = {
    "parallel": (True, False),
    "one-point": (False, True),
    "both": (True, True),
    "neither": (False, False),
}  # axes 2, 3, 4 parallel; axes 4, 5, 6 in one point


STRUCTURES = {
    "the article's arm": "both",
    "the UR5e": "parallel",
    "the AR4": "one-point",
    "the Piper": "one-point",
}


def explain_structures(structures: list[str]) -> Known | None:
    wrong = [
        (arm, given, wanted)
        for given, (arm, wanted) in zip(structures, STRUCTURES.items())
        if given != wanted
    ]
    arm, given, wanted = wrong[0]
    look = (
        "α2 and α3: are both 0"
        if SAYS[given][0] != SAYS[wanted][0]
        else "a4, a5 and d5: are all three 0"
    )
    headline = "look again at " + " and ".join(
        filter(None, (", ".join(name for name, _, _ in wrong[:-1]), wrong[-1][0]))
    )
    return "structure-from-prose", Said(
        headline, next=f"{arm[0].upper()}{arm[1:]}: look at {look}?"
    )


def _upright(offset_2, offset_3):
    rows = [list(row) for row in UPRIGHT]
    rows[1][0], rows[2][0] = offset_2, offset_3
    return Arm(DHTable.standard(rows, angle="deg"))


STANDS = {
    0: "is level, pointing forward",
    90: "points straight up",
    180: "is level, pointing backward",
    270: "points straight down",
}  # by its angle to the floor


def wrong_offsets() -> Mistakes:
    """The offsets of 06.6 in radians, and in other quarter turns: what the arm then looks like
    where the encoders read 0.
    """
    radians = Said(
        "the offsets look like radians", next="This table is in degrees: 90, not 1.5708."
    )
    for quarter in (np.pi / 2, 1.57, 1.571, 1.5708):
        for signs in ((1, -1), (1, 0), (0, -1), (1, 1), (-1, 1), (-1, -1), (-1, 0), (0, 1)):
            yield "angle-unit", radians, _upright(signs[0] * quarter, signs[1] * quarter)
    for offset_2 in STANDS:
        for offset_3 in STANDS:
            if (offset_2, offset_3) != (90, 270):
                yield (
                    _offset_mistake(offset_2, offset_3),
                    _seen(offset_2, offset_3),
                    _upright(offset_2, offset_3),
                )


def _offset_mistake(offset_2, offset_3):
    if (offset_2 == 0 and offset_3 in (0, 270)) or (offset_2, offset_3) == (90, 0):
        return "offset-missing"
    if (offset_2, offset_3) in ((90, 90), (270, 270), (270, 90)):
        return "offset-sign"
    return (
        "offset-counted-twice"
        if (offset_2, offset_3) in ((90, 180), (180, 270))
        else "offset-value"
    )


def _seen(offset_2, offset_3):
    if offset_2 != 90:
        return Said(
            f"where the encoders read 0, your upper arm {STANDS[offset_2]}",
            next="It must point straight up there; positive q2 lifts it from the level.",
        )
    return Said(
        "the upper arm is right; where the encoders read 0, your forearm"
        f" {STANDS[(offset_2 + offset_3) % 360]}",
        next=(
            "θ3 is measured from the upper arm, not from the floor. With the arm up, which θ3 makes"
            " the forearm level?"
        ),
    )


IN_THE_LOOP = {  # two slips of Python, by the place that the doctor names
    ("product-starts-late", "only the last row is used"): Said(
        "only the last row's matrix comes out",
        next="Each turn of the loop throws the product away: write T = T @ A.",
    ),
    ("product-stops-early", "only the first row is used"): Said(
        "only the first row's matrix comes out",
        next="Is the return inside the loop? It belongs behind it.",
    ),
}
