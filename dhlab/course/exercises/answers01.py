"""What lesson 01 draws, what is right, and what the wrong answers are told:
reading and building poses.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...transform import from_xyz_rpy, inverse, rot_x, rot_y, rot_z, trans
from ..kinds import Known, Mistakes, Said, as_numbers, is_array_of

__all__ = [
    "draw_corner",
    "draw_pose",
    "general_pose",
    "misread_axis",
    "misshapen_axis",
    "plate",
    "wrong_plates",
]


def general_pose(
    rng: np.random.Generator, reach: float = 0.5, digits: int | None = None
) -> NDArray:
    """A pose without zeros and without right angles; rounded where it is to be read, and then no
    rotation to the last digit.
    """
    T = from_xyz_rpy(
        rng.uniform(0.1, reach, 3) * rng.choice([-1, 1], 3),
        rng.uniform(0.3, 1.2, 3) * rng.choice([-1, 1], 3),
    )
    return T if digits is None else T.round(digits)


def draw_pose(rng: np.random.Generator) -> dict[str, Any]:
    return {
        "T_01": (
            from_xyz_rpy(
                rng.integers(1, 6, 3) / 10, np.deg2rad(rng.choice([20, 30, 40, 50, 60], 3))
            ).round(3)
        )
    }


def _a_row(which):
    return Said(
        f"this is the {which} row; the plate's arrows are columns",
        why="The rows say where the base's arrows are, seen from the plate.",
        next="Which column is the x arrow? Take it from top to bottom.",
    )


def misread_axis(T_01: NDArray) -> Mistakes:
    yield "rotation-transposed", _a_row("first"), T_01[0, :3]
    yield "rotation-block-misread", "this is the plate's y arrow", T_01[:3, 1]
    yield "rotation-block-misread", "this is the plate's z arrow", T_01[:3, 2]
    yield "rotation-block-misread", "this is the plate's origin", T_01[:3, 3]
    yield (
        "rotation-block-misread",
        Said(
            "this is the plate's x arrow turned round",
            next="Take the first column with the signs it has.",
        ),
        -T_01[:3, 0],
    )
    yield "rotation-transposed", _a_row("second"), T_01[1, :3]
    yield "rotation-transposed", _a_row("third"), T_01[2, :3]


def misshapen_axis(answer: object, T_01: NDArray) -> Known | None:
    array = as_numbers(answer)
    if is_array_of(array.ravel(), T_01[:, 0]):
        return None, Said(
            "the last 0 is not part of the arrow",
            next="An arrow is three numbers: [:3] takes the first three.",
        )
    if is_array_of(array.ravel(), T_01[0]):
        return "rotation-transposed", _a_row("first")
    return None


def draw_corner(rng: np.random.Generator) -> dict[str, Any]:
    x, y, z = rng.integers(1, 9, 3) / 10
    return {"x": float(x), "y": float(y), "z": float(z)}


def plate(x: float, y: float, z: float) -> NDArray:
    """The plate of 01.2: its x arrow along y0, its z arrow up."""
    T = np.eye(4)
    T[:3, :3] = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    T[:3, 3] = x, y, z
    return T


TURNED_BACK = Said(
    "turned the other way: the x arrow points against y0",
    next="The first column is the x arrow, in the base: along y0. The right hand then gives y.",
)


def wrong_plates(x: float, y: float, z: float) -> Mistakes:
    T = plate(x, y, z)
    yield "rotation-transposed", TURNED_BACK, trans([x, y, z]) @ rot_z(-np.pi / 2)
    yield "matrix-transposed", "", T.T
    yield (
        "pose-inverted",
        Said(
            "this is the inverse: where the base is, seen from the camera plate",
            next="Every arrow, and the origin, is written in the base.",
        ),
        inverse(T),
    )
    yield (
        "mirror",
        Said(
            "the y arrow points the wrong way: x, y and z form a left hand",
            next="Point your right hand's fingers from x to y: the thumb is z.",
        ),
        trans([x, y, z]) @ np.array([[0, 1, 0, 0], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]),
    )
    yield (
        "rotation-block-misread",
        Said(
            "the plate is not turned: its x arrow still points along x0",
            next="The first column is the x arrow, in the base: along y0.",
        ),
        trans([x, y, z]),
    )
    yield "last-row-missing", "", np.vstack([T[:3], np.zeros(4)])
    yield (
        "product-reversed",
        Said(
            "the shift was made along the turned arrows",
            why="(x, y, z) is written in the base.",
            next=(
                "The fourth column is x, y, z as they are; of a product, the shift stands on the"
                " left."
            ),
        ),
        rot_z(np.pi / 2) @ trans([x, y, z]),
    )
    yield (
        "degrees-in-sin-cos",
        Said(
            "90 was taken for radians",
            why="numpy and from_xyz_rpy take angles in radians.",
            next="np.deg2rad(90), or np.pi / 2.",
        ),
        trans([x, y, z]) @ rot_z(90),
    )
    for name, turn in (("x", rot_x), ("y", rot_y)):
        for angle in (np.pi / 2, -np.pi / 2):
            yield (
                "rotation-block-misread",
                Said(
                    f"turned about {name}: the z arrow no longer points up",
                    next="Which arrow stays where it was?",
                ),
                trans([x, y, z]) @ turn(angle),
            )
