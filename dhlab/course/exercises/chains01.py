"""What lesson 01 draws for its chains of frames, what is right, and what wrong answers are told."""

import itertools
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...transform import inverse, rot_x, rot_z, trans
from ..kinds import LAST_ROW, Known, Mistakes, Said, as_numbers, is_array_of
from .answers01 import general_pose

__all__ = [
    "FROM_BASE_TO_TOOL",
    "LINKS",
    "draw_chain",
    "draw_tool",
    "explain_chain",
    "misshapen_point",
    "misshapen_tip",
    "point_in_base",
    "wrong_points",
    "wrong_tips",
]


def draw_chain(rng: np.random.Generator) -> dict[str, Any]:
    return {
        "T_01": (trans([0.1, 0.2, 0.3]) @ rot_z(np.pi / 2)).round(6) + 0.0,
        "p_12": [float(v) for v in rng.integers(1, 6, 3) / 10],
    }


def point_in_base(T_01: NDArray, p_12: list[float]) -> NDArray:
    return T_01[:3, :3] @ p_12 + T_01[:3, 3]


ADDED = "One way follows the other, and neither is walked back."
TURN = "p_0 = R_01 p_1 + p_01: turn, then shift."


def wrong_points(T_01: NDArray, p_12: list[float]) -> Mistakes:
    R, p = T_01[:3, :3], T_01[:3, 3]
    yield (
        "translations-not-rotated",
        Said(
            "the two shifts were added, and p_12 was not turned",
            why="p_12 is written in plate 1's arrows.",
            next=TURN,
        ),
        p + p_12,
    )
    yield (
        "rotation-transposed",
        Said(
            "p_12 was turned the wrong way: the columns of R were used where its rows belong",
            next="R stands on the left of @, and not transposed.",
        ),
        R.T @ p_12 + p,
    )
    yield "product-stops-early", Said("the shift of plate 1 is missing", next=TURN), R @ p_12
    yield (
        "product-starts-late",
        Said("this is p_12 itself, still written in plate 1", next=TURN),
        np.asarray(p_12),
    )
    yield (
        "pose-inverted",
        Said("this goes the other way: from the base into plate 1", next=TURN),
        R.T @ (np.asarray(p_12) - p),
    )
    yield (
        "product-reversed",
        Said(
            "you shifted first and then turned",
            why="p_01 is written in the base's arrows already, and needs no turn.",
            next=TURN,
        ),
        R @ (np.asarray(p_12) + p),
    )
    yield (
        "product-stops-early",
        Said("this is the origin of plate 1; p_12 was not used", next=TURN),
        p,
    )
    for what, taken in (("shift of plate 1", R @ p_12 - p), ("turned p_12", p - R @ p_12)):
        yield (
            "length-sign",
            Said(f"the {what} was taken away, where it is added", why=ADDED, next=TURN),
            taken,
        )


def misshapen_point(answer: object, T_01: NDArray, p_12: list[float]) -> Known | None:
    array = as_numbers(answer)
    if is_array_of(array.ravel(), [*point_in_base(T_01, p_12), 1]):
        return None, Said(
            "the place is right, but the 1 at the end is not part of it",
            next="Three numbers are asked: [:3] takes the first three.",
        )
    if is_array_of(array.ravel(), [*(T_01[:3, :3] @ p_12), 0]):
        return "product-stops-early", Said(
            "the shift of plate 1 is missing",
            why="With a 0 in fourth place T_01 only turns.",
            next="Append a 1 to a point, and take three numbers of the result.",
        )
    if is_array_of(array, T_01[:3, :3] * p_12 + T_01[:3, 3]):
        return "elementwise-product", Said(
            "multiplied entry by entry, with * in place of @",
            next="@ takes each row of R against the whole of p_12, and adds up.",
        )
    return None


def draw_tool(rng: np.random.Generator) -> dict[str, Any]:
    return {
        "T_0F": general_pose(rng, 0.7, digits=3),
        "T_FT": (
            (
                trans(
                    [
                        0.0,
                        round(float(rng.uniform(0.03, 0.06)), 3),
                        round(float(rng.uniform(0.12, 0.2)), 3),
                    ]
                )
                @ rot_x(np.pi / 6)
            ).round(4)
        ),
    }


CHAIN = "Write the chain with its subscripts: 0 to F, F to T."


def wrong_tips(T_0F: NDArray, T_FT: NDArray) -> Mistakes:
    R, p, t = T_0F[:3, :3], T_0F[:3, 3], T_FT[:3, 3]
    yield (
        "wrong-frame-compared",
        Said(
            "this is the flange's origin, not the tip",
            next="The tip is a step further: which pose leads from F to T?",
        ),
        p,
    )
    yield (
        "translations-not-rotated",
        Said(
            "the two shifts were added, and the tool's was not turned",
            why="The tool's shift is written in the flange's arrows.",
            next=CHAIN,
        ),
        p + t,
    )
    yield (
        "product-reversed",
        Said(
            "the two poses are multiplied in the reverse order",
            next="The inner subscripts must meet. " + CHAIN,
        ),
        (T_FT @ T_0F)[:3, 3],
    )
    yield (
        "pose-inverted",
        Said("the tool's pose was inverted", next="T_FT is T written in F, as it is needed."),
        (T_0F @ inverse(T_FT))[:3, 3],
    )
    yield (
        "pose-inverted",
        Said("the flange's pose was inverted", next="T_0F is F written in 0, as it is needed."),
        (inverse(T_0F) @ T_FT)[:3, 3],
    )
    yield (
        "pose-inverted",
        Said(
            "this is the base's origin, seen from the tool",
            next="T in 0 is asked, not 0 in T. No inverse is needed.",
        ),
        inverse(T_0F @ T_FT)[:3, 3],
    )
    yield (
        "wrong-frame-compared",
        Said("this is the tip in the flange's arrows, not in the base's", next=CHAIN),
        t,
    )
    yield (
        "product-stops-early",
        Said(
            "the way from the base to the flange is missing",
            next="The tool's shift is turned rightly. What must be added to it?",
        ),
        R @ t,
    )
    yield (
        "product-reversed",
        Said(
            "you shifted first and then turned",
            why="The flange's place is written in the base already, and needs no turn.",
            next="Turn the tool's shift, then add.",
        ),
        R @ (p + t),
    )
    yield (
        "rotation-transposed",
        Said(
            "the tool's shift was turned the wrong way: the columns of R were used where its rows"
            " belong",
            next="R stands on the left of @, and not transposed.",
        ),
        R.T @ t + p,
    )
    for what, taken in (("tool's shift", p - R @ t), ("way to the flange", R @ t - p)):
        yield (
            "length-sign",
            Said(f"the {what} was taken away, where it is added", why=ADDED, next=CHAIN),
            taken,
        )
    yield "rotation-block-misread", "this is the tool's z arrow", (T_0F @ T_FT)[:3, 2]
    yield "rotation-block-misread", LAST_ROW, np.zeros(3)


def misshapen_tip(answer: object, T_0F: NDArray, T_FT: NDArray) -> Known | None:
    array, right = as_numbers(answer), T_0F @ T_FT
    if is_array_of(array.ravel(), right[:, 3]):
        return None, Said(
            "the place is right, but the 1 at the end is not part of it",
            next="Three numbers are asked: [:3] takes the first three.",
        )
    if is_array_of(array, right):
        return None, Said(
            "this is the tool's whole pose, and its origin is asked",
            next="Which column of T_0T is the origin?",
        )
    return None


LINKS = {
    "t-2f": "T_2F",
    "t-10": "T_10",
    "t-12": "T_12",
    "t-ft": "T_FT",
    "t-01": "T_01",
    "t-tf": "T_TF",
}

FROM_BASE_TO_TOOL = ["t-01", "t-12", "t-2f", "t-ft"]


def explain_chain(order: list[str]) -> Known | None:
    if order == FROM_BASE_TO_TOOL[::-1]:
        return "product-reversed", Said(
            "the four are right, in the reverse order",
            next="The pose nearest to the base stands on the left.",
        )
    poses = [LINKS[link] for link in order]
    apart = next(
        (
            f"{one}, then {two}: {one[3]} does not meet {two[2]}"
            for one, two in itertools.pairwise(poses)
            if one[3] != two[2]
        ),
        "",
    )
    ends = f"the product begins with {poses[0][2]} and ends with {poses[-1][3]}"
    turned = [pose for pose in poses if pose in ("T_TF", "T_10")]
    if turned:
        return "pose-inverted", Said(
            f"{turned[0]}: an inverse, which is not needed"
            if len(turned) == 1
            else f"{' and '.join(turned)}: two inverses, which are not needed",
            place=apart or ends,
            next="After T_01 comes a pose that begins with 1, and so on to T.",
        )
    return "product-reversed", Said(
        "two neighbours do not meet",
        place=apart,
        next="Begin with 0. After T_01 comes a pose that begins with 1.",
    )
