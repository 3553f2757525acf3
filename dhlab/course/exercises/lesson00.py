"""Lesson 00, start here: one exercise to try the tools on, and the five questions of the
pre-test.
"""

from dataclasses import replace

import numpy as np

from ...transform import rot_z
from ..kinds import Option, Prediction, PreTest, Said, Value, as_numbers, is_array_of

__all__ = ["EXERCISES"]


def _draw_turn(rng):
    R = rot_z(np.deg2rad(rng.choice([20, 25, 35, 50, 65, 70])))[:3, :3].round(3)
    return {"R": R, "v": [float(value) for value in rng.choice(np.arange(2, 9), 3, replace=False)]}


ENTRYWISE = Said(
    "multiplied entry by entry, with * in place of @",
    next="@ takes each row of R against the whole of v, and adds up.",
)


def _wrong_products(R, v):
    v = np.asarray(v)
    yield (
        "row-vector-convention",
        Said(
            "this is v @ R: it uses the columns of R where the rows belong",
            next="Put R on the left of @.",
        ),
        v @ R,
    )
    yield (
        "elementwise-product",
        replace(ENTRYWISE, place="the sums of the columns of R * v"),
        (R * v).sum(axis=0),
    )
    yield (
        "elementwise-product",
        Said(
            "only the diagonal of R was used",
            next="Each number of the result needs a whole row of R.",
        ),
        np.diag(R) * v,
    )
    yield (
        "product-starts-late",
        Said("this is v itself, R was not used", next="Multiply v by R, with @ between the two."),
        v,
    )
    yield (
        "rotation-block-misread",
        Said(
            "this is the first column of R, v was not used",
            next="Multiply the whole R and v, with @ between the two.",
        ),
        R[:, 0],
    )
    yield (
        "rotation-block-misread",
        Said(
            "this is the first row of R, v was not used",
            next="Multiply the whole R and v, with @ between the two.",
        ),
        R[0],
    )
    yield "product-reversed", Said("R was applied twice", next="One product is enough."), R @ R @ v


def _misshapen_product(answer, R, v):
    array = as_numbers(answer)
    if is_array_of(array, R * v) or is_array_of(array, (R.T * v).T):
        return "elementwise-product", ENTRYWISE
    return None


EXERCISES = [
    Value(
        id="00.1",
        title="A matrix and a vector",
        draw=_draw_turn,
        answer=lambda R, v: R @ np.asarray(v),
        mistakes=_wrong_products,
        misshapen=_misshapen_product,
        entries=("first number", "second number", "third number"),
        praise="That is all the mathematics you need to begin.",
        hints=(
            "Each number of the result is one row of R against the whole of v.",
            "numpy writes the matrix product as @, with the matrix on the left.",
        ),
    ),
    Prediction(
        id="00.P1",
        title="The cosine of 90",
        question="What does `np.cos(90)` give?",
        options={"zero": "0", "negative": "about −0.45", "error": "an error"},
        correct="negative",
        outcome=(
            "np.cos takes radians, and 90 radians are 14 turns and a bit. Degrees must be converted"
            " first: np.cos(np.deg2rad(90)) is 0 (printed as 6e-17)."
        ),
    ),
    Prediction(
        id="00.P2",
        title="The same arm, another cup",
        question="It missed the first cup by 15 cm. By how much does it miss the second?",
        options={"same": "by the same 15 cm", "more": "by more than that", "hit": "not at all"},
        correct="hit",
        outcome=(
            "the second cup is hit, and the first one is missed as before. Now you see why it took"
            " two days."
        ),
    ),
    PreTest(
        id="00.2",
        title="What a column of a pose says",
        question=(
            "The pose of an arm's hand in the base is a 4×4 matrix. What do the first three numbers"
            " of its third column say?"
        ),
        correct="hand-in-base",
        lesson="01",
        options={
            "hand-in-base": Option(
                "where the hand's z arrow points, seen from the base",
                "An arrow of the hand, written in the base: you will draw it.",
            ),
            "base-in-hand": Option(
                "where the base's z arrow points, seen from the hand",
                "An arrow of the base, written in the hand: you will hold both readings against a"
                " picture.",
                "rotation-transposed",
            ),
            "distance": Option(
                "how far the hand is from the base along z",
                "A distance along z: you will see which of the sixteen numbers that is.",
                "rotation-block-misread",
            ),
        },
    ),
    PreTest(
        id="00.3",
        title="What a row says of two axes",
        question=(
            "A row of a DH table reads: θ = q2, d = 0, a = 0.4 m, α = 0. What does it say of the"
            " two joint axes that it connects?"
        ),
        correct="parallel",
        lesson="02",
        options={
            "meet": Option(
                "they meet, and the link behind them is 0.4 m long",
                "Two axes that meet: you will move a from 0 to 0.4 and watch them.",
                "intersecting-axes-given-a-length",
            ),
            "parallel": Option(
                "they are parallel, 0.4 m apart",
                "Two parallel axes: you will move each of the four numbers and watch them.",
            ),
            "shifted": Option(
                "the second is the first, shifted by 0.4 m along itself",
                "A shift along the axis: you will see which of the four numbers makes it.",
                "a-d-exchanged",
            ),
        },
    ),
    PreTest(
        id="00.4",
        title="Two tables of one arm",
        question="Two books print a table of the same arm, and the numbers differ. What follows?",
        correct="own-program",
        lesson="03",
        options={
            "one-wrong": Option(
                "one is wrong, or has a misprint",
                "Then somebody should be told. You will put two such tables to the test.",
                "table-taken-as-unique",
            ),
            "own-program": Option(
                "both may be right, each in its own program",
                "You will see two such tables move together.",
            ),
            "any-program": Option(
                "both may be right, in any program",
                "You will feed one table to the other's program and see.",
                "standard-rows-in-craig-matrix",
            ),
        },
    ),
    PreTest(
        id="00.5",
        title="The order of a product",
        question=(
            "A_i is the pose of frame i in frame i−1. Which product is the pose of frame 6 in frame"
            " 0, and why?"
        ),
        correct="left-to-right",
        lesson="05",
        options={
            "left-to-right": Option(
                "A_1 A_2 … A_6: what is nearest to the base stands on the left",
                "You read it from the base outwards. You will make the moves one by one and see.",
            ),
            "right-to-left": Option(
                "A_6 … A_2 A_1: what is done first stands on the right",
                "You read it from the hand inwards. You will make the moves one by one and see.",
                "product-reversed",
            ),
            "either": Option(
                "either: all six are there, so the order does not matter",
                "Turn right and walk, or walk and turn right: you will try it.",
                "order-taken-for-free",
            ),
        },
    ),
    PreTest(
        id="00.6",
        title="What one agreeing pose proves",
        question=(
            "With all joints at 0, a table puts the hand exactly where it was measured. What does"
            " that prove?"
        ),
        correct="little",
        lesson="07",
        options={
            "table": Option(
                "the table is right",
                "You will meet a table that passes this test.",
                "only-zero-pose-checked",
            ),
            "lengths": Option(
                "the lengths are right, the angles perhaps not",
                "You will meet lengths that pass this test.",
                "only-position-checked",
            ),
            "little": Option(
                "little: many wrong tables agree there as well", "You will build one of them."
            ),
        },
    ),
]
