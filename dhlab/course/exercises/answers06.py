"""What lesson 06 draws, what is right, and what the wrong answers are told:
the article's arm, structures of four arms.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...doctor.programs.wrong.craig import craig
from ...doctor.programs.wrong.products import product
from ...robots import load
from ...table import DHTable
from ..kinds import Known, Mistakes, Said

__all__ = [
    "IN_THE_LOOP",
    "OF_LENGTHS",
    "STRUCTURES",
    "draw_unseen",
    "explain_lengths",
    "explain_structures",
    "unseen_pose",
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


IN_DEGREES = np.array([180 / np.pi, 1, 1, 180 / np.pi])
THETA, ALPHA = np.eye(4)[[0, 3]]
LENGTHS = 1 - THETA - ALPHA


def _article_rows():
    return DHTable.standard(ARTICLE, angle="deg").rows


def zero_pose() -> NDArray:
    return product(_article_rows(), np.zeros(6))


def wrong_zero_poses() -> Mistakes:
    rows, q = _article_rows(), np.zeros(6)
    yield "alpha-in-degrees", "α was left in degrees", product(rows * IN_DEGREES, q)
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
    yield from _without_a_row(rows, q)
    for k in range(1, len(rows) - 1):
        yield (
            "product-stops-early",
            Said(
                f"this is the pose of frame {{{k}}}, after {k} of {len(rows)} rows",
                next="How many rows does your product take?",
            ),
            product(rows[:k], q[:k]),
        )
    yield (
        "product-stops-early",
        Said("this is np.eye(4), the pose before the first row", next="What multiplies it?"),
        np.eye(4),
    )
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


def _without_a_row(rows, q):
    """What is left of the product without a row; where two rows leave the same, both are told."""
    n, left = len(rows), [product(np.delete(rows, k, 0), np.delete(q, k)) for k in range(len(rows))]
    for k, T in enumerate(left):
        others = [i + 1 for i in range(n) if np.allclose(left[i], T)]
        name = {1: "the first row", n: "the last row"}.get(k + 1, f"row {k + 1}")
        if len(others) > 1:  # nobody can tell
            name = " or ".join(f"row {i}" for i in others)
        early = "product-starts-late" if k == 0 else "product-stops-early"
        yield early, Said(f"{name} was left out", next="How many rows does your product take?"), T


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
        (
            "converted-to-radians-twice",
            Said(
                "the rows and q were converted twice",
                next="Run the cell that makes irb120 once more, then convert once.",
            ),
            rows / IN_DEGREES,
            np.deg2rad(q_rad),
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
    yield (
        "wrong-frame-compared",
        Said(
            "this is the pose of the article's arm, and that of the IRB 120 is asked",
            next="Make rows in radians of irb120, under a name of their own.",
        ),
        product(_article_rows(), q_rad),
    )
    for k in np.flatnonzero(rows[:, 0]):
        alone = rows.copy()
        alone[k, 0] = 0
        yield (
            "offset-missing",
            Said(
                f"the offset of joint {k + 1} was left out",
                next="In which rows of irb120 is θ not 0?",
            ),
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


IN_THE_LOOP = {  # two slips of Python, by the place that the doctor names
    ("product-starts-late", "only the last row is used"): Said(
        "only the last row's matrix comes out",
        next="Each turn of the loop throws the product away: write T = T @ A in it, and"
        " T = np.eye(4) before it.",
    ),
    ("product-stops-early", "only the first row is used"): Said(
        "only the first row's matrix comes out",
        next="Is the return inside the loop? It belongs behind it.",
    ),
}
