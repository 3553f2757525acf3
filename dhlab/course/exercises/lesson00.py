"""Lesson 00, start here: one exercise to try the tools on, and the five questions of the
pre-test.
"""

from dataclasses import replace

import numpy as np

from ...transform import rot_z
from ..kinds import Option, Prediction, PreTest, Said
from .shaped_value import ShapedValue, as_numbers, is_array_of

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
    ShapedValue(
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
        options={"a": "0", "b": "about -0.45", "c": "an error"},
        correct="b",
        outcome=(
            "np.cos takes radians, and 90 radians are 14 turns and a bit. Degrees must be converted"
            " first: np.cos(np.deg2rad(90)) is 0 (printed as 6e-17)."
        ),
    ),
    Prediction(
        id="00.P2",
        title="The same arm, another cup",
        options={"a": "by the same 15 cm", "b": "by more than that", "c": "not at all"},
        correct="c",
        outcome=(
            "the second cup is hit. One arrow is reversed, and the arm is right at some poses and"
            " wrong at others. Now you see why it took two days."
        ),
    ),
    PreTest(
        id="00.2",
        title="What a column of a pose says",
        correct="a",
        lesson="01",
        options={
            "a": Option(
                "where the hand's z arrow points, seen from the base",
                "An arrow of the hand, written in the base: you will draw it.",
            ),
            "b": Option(
                "where the base's z arrow points, seen from the hand",
                "An arrow of the base, written in the hand: you will hold both readings against a"
                " picture.",
                "rotation-transposed",
            ),
            "c": Option(
                "how far the hand is from the base along z",
                "A distance along z: you will see which of the sixteen numbers that is.",
                "rotation-block-misread",
            ),
        },
    ),
    PreTest(
        id="00.3",
        title="What a row says of two axes",
        correct="b",
        lesson="02",
        options={
            "a": Option(
                "they meet, and the link behind them is 0.4 m long",
                "Two axes that meet: you will move a from 0 to 0.4 and watch them.",
                "intersecting-axes-given-a-length",
            ),
            "b": Option(
                "they are parallel, 0.4 m apart",
                "Two parallel axes: you will move each of the four numbers and watch them.",
            ),
            "c": Option(
                "the second is the first, shifted by 0.4 m along itself",
                "A shift along the axis: you will see which of the four numbers makes it.",
                "a-d-exchanged",
            ),
        },
    ),
    PreTest(
        id="00.4",
        title="Two tables of one arm",
        correct="b",
        lesson="03",
        options={
            "a": Option(
                "one of the two is wrong",
                "Then somebody should be told. You will put two such tables to the test.",
                "table-taken-as-unique",
            ),
            "b": Option(
                "both may be right, and each needs a program that fits it",
                "You will see two such tables move together.",
            ),
            "c": Option(
                "both may be right, and any program will do for either",
                "You will feed one table to the other's program and see.",
                "standard-rows-in-craig-matrix",
            ),
        },
    ),
    PreTest(
        id="00.5",
        title="The order of a product",
        correct="a",
        lesson="05",
        options={
            "a": Option(
                "A_1 A_2 … A_6: each matrix is written in the frame that the ones before it"
                " lead to",
                "From the base outwards: you will make the moves one by one.",
            ),
            "b": Option(
                "A_6 … A_2 A_1: what is done first stands on the right",
                "From the hand inwards: you will make the moves one by one.",
                "product-reversed",
            ),
            "c": Option(
                "either: all six are there, so the order does not matter",
                "Turn right and walk, or walk and turn right: you will try it.",
                "order-taken-for-free",
            ),
        },
    ),
    PreTest(
        id="00.6",
        title="What one agreeing pose proves",
        correct="c",
        lesson="07",
        options={
            "a": Option(
                "the table is right",
                "You will meet a table that passes this test.",
                "only-zero-pose-checked",
            ),
            "b": Option(
                "the lengths are right, the angles perhaps not",
                "You will meet lengths that pass this test.",
                "only-position-checked",
            ),
            "c": Option("little: many wrong tables agree there as well", "You will count them."),
        },
    ),
]
