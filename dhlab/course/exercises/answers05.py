"""What lesson 05 draws, what is right, and what the wrong answers are told:
orders of the moves, the closed form, a row that slides.
"""

from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...doctor.programs.wrong.craig import craig
from ...doctor.programs.wrong.links import standard
from ...transform import inverse
from ..kinds import Known, Mistakes, Said

__all__ = [
    "OTHER_ORDERS",
    "draw_angle",
    "draw_column",
    "draw_slide",
    "explain_order",
    "row_in_radians",
    "slide",
    "wrong_origins",
    "wrong_slides",
]

PRINTED = ["rz", "tz", "tx", "rx"]  # the order that 05.3 gives

OTHER_ORDERS = (
    ["tz", "rz", "tx", "rx"],
    ["rz", "tz", "rx", "tx"],
    ["tz", "rz", "rx", "tx"],
    ["rz", "tx", "tz", "rx"],
)


def draw_angle(rng: np.random.Generator) -> tuple:
    return (float(rng.uniform(0.2, 3.0) * rng.choice([-1, 1])),)


def draw_column(rng: np.random.Generator) -> dict[str, Any]:
    return {
        "theta": float(rng.choice([20, 30, 40, 50, 60])),
        "d": float(rng.integers(1, 6) / 10),
        "a": float(rng.integers(1, 6) / 10),
        "alpha": float(rng.choice([25, 35, 45, 55, 65])),
    }


def row_in_radians(theta: float, d: float, a: float, alpha: float) -> NDArray:
    return standard(np.deg2rad(theta), d, a, np.deg2rad(alpha))


def wrong_origins(theta: float, d: float, a: float, alpha: float) -> Mistakes:
    T = row_in_radians(theta, d, a, alpha)
    t, al = np.deg2rad(theta), np.deg2rad(alpha)
    yield "shift-not-turned-by-theta", "", [a, 0, d]
    yield "rotation-block-misread", "this is the x arrow, without its length", T[:3, 0]
    yield "rotation-block-misread", "this is the z arrow", T[:3, 2]
    yield "degrees-in-sin-cos", "", [a * np.cos(theta), a * np.sin(theta), d]
    yield (
        "a-d-exchanged",
        Said(
            "a and d have changed places",
            next="a is walked along the new x arrow, d along the old z.",
        ),
        [d * np.cos(t), d * np.sin(t), a],
    )
    yield (
        "sin-cos-exchanged",
        Said(
            "sine and cosine of θ have changed places",
            next="Set θ = 0: the origin must lie along x.",
        ),
        [a * np.sin(t), a * np.cos(t), d],
    )
    yield (
        "theta-alpha-exchanged",
        Said(
            "α stands where θ belongs", next="Which of the two turns comes before the step along x?"
        ),
        [a * np.cos(al), a * np.sin(al), d],
    )
    yield (
        "standard-rows-in-craig-matrix",
        Said(
            "the x moves come before the z moves",
            next="Turn and lift along z first, then step along the turned x arrow.",
        ),
        [a, -d * np.sin(al), d * np.cos(al)],
    )
    yield (
        "pose-inverted",
        Said(
            "this is the old origin, seen from the new frame",
            next="Asked is the new origin, seen from the old frame.",
        ),
        np.linalg.inv(T)[:3, 3],
    )
    yield (
        "pi-rounded",
        Said(
            "rounded too early", next="Give four digits or more, or let numpy compute the numbers."
        ),
        np.round(T[:3, 3], 2),
    )


def draw_slide(rng: np.random.Generator) -> dict[str, Any]:
    return {"q3": float(rng.choice([0.4, 0.5, 0.6, 0.7, 0.8]))}


def slide(q3: float) -> NDArray:
    """The sliding row of 05.9: theta = -90°, d = q3, a = 0.05, alpha = 90°."""
    return standard(-np.pi / 2, q3, 0.05, np.pi / 2)


def wrong_slides(q3: float) -> Mistakes:
    half = np.pi / 2
    yield (
        "offset-missing",
        Said("θ is −90° here, not 0", next="θ is a constant of this row: −90° at every q3."),
        standard(0, q3, 0.05, half),
    )
    yield (
        "offset-sign",
        Said("θ is −90° here, not +90°", next="Compare the sign with the row in the text."),
        standard(half, q3, 0.05, half),
    )
    yield (
        "alpha-sign",
        Said("α is +90° here, not −90°", next="Compare the sign with the row in the text."),
        standard(-half, q3, 0.05, -half),
    )
    yield (
        "theta-alpha-exchanged",
        Said(
            "θ and α have changed places, or both their signs",
            next="θ = −90° comes first, α = 90° last.",
        ),
        standard(half, q3, 0.05, -half),
    )
    yield (
        "joint-values-unused",
        Said("q3 is left out", next="Put q3 in place of d; θ stays −90°."),
        standard(-half, 0, 0.05, half),
    )
    for headline, theta in (
        ("q3 was added to θ; this joint slides", -half + q3),
        ("q3 stands in place of θ; this joint slides", q3),
    ):
        yield (
            "prismatic-variable-in-theta",
            Said(headline, next="Put q3 in place of d; θ stays −90°."),
            standard(theta, 0, 0.05, half),
        )
    for theta, alpha in product((half, 1.57, 1.571, 1.5708), repeat=2):
        if (theta, alpha) != (half, half):
            yield (
                "pi-rounded",
                Said(
                    "rounded on the way", next="Write np.pi / 2, or let np.deg2rad make it of 90."
                ),
                standard(-theta, q3, 0.05, alpha),
            )
    yield from _as_other_matrices(q3, half)


def _as_other_matrices(q3, half):
    """The row put into the matrix otherwise, or the matrix written down otherwise."""
    right = standard(-half, q3, 0.05, half)
    for headline, theta, alpha in (
        ("both angles are in degrees", -90, 90),
        ("θ is in degrees", -90, half),
        ("α is in degrees", -half, 90),
    ):
        yield (
            "degrees-in-sin-cos",
            Said(
                f"{headline}, and the function takes radians",
                next="Write np.deg2rad around every angle that is given in degrees.",
            ),
            standard(theta, q3, 0.05, alpha),
        )
    yield "a-d-exchanged", "d and a have changed places", standard(-half, 0.05, q3, half)
    yield "columns-misread", "θ and d have changed places", standard(q3, -half, 0.05, half)
    yield "length-value", "a was left out: it is 0.05", standard(-half, q3, 0, half)
    yield "length-value", "a is 0.05, not 0.5", standard(-half, q3, 0.5, half)
    yield "alpha-value", "α was left out: it is 90°", standard(-half, q3, 0.05, 0)
    yield "standard-rows-in-craig-matrix", "this is Craig's matrix", craig(-half, q3, 0.05, half)
    yield "rotation-transposed", "", inverse(right)[:, [0, 1, 2, 3]] * _BLOCK + right * ~_BLOCK
    yield "matrix-transposed", "", right.T
    yield "pose-inverted", "this is the inverse of the right matrix", inverse(right)


_BLOCK = np.pad(np.ones((3, 3), dtype=bool), (0, 1))


def explain_order(order: list[str]) -> Known | None:
    if order == PRINTED:
        return "order-taken-for-free", Said(
            "this is the order that was given, and another is asked",
            next="Which two neighbours may change places, and nothing changes?",
        )
    if set(order[:2]) == {"tx", "rx"}:
        return "standard-rows-in-craig-matrix", Said(
            "the x moves come before the z moves",
            next="Which pair did the picture's link make first?",
        )
    if order.index("tx") < order.index("rz"):
        return "shift-not-turned-by-theta", Said(
            "Tx(a) stands before Rz(θ)",
            next="Set θ = 90°: the origin must move to y.",
            why="A step along x that is made first does not swing with θ.",
        )
    if order.index("rx") < order.index("tz"):
        return "alpha-before-d", Said(
            "Rx(α) stands before Tz(d)",
            next="Set α = 90°: d must still go along the old z.",
            why="After Rx(α) the z axis is a new one.",
        )
    return "order-taken-for-free", Said(
        "Rx(α) stands before Rz(θ)",
        next="Set α = 90°: θ must still turn about the old z.",
        why="After Rx(α) the z axis is a new one.",
    )
