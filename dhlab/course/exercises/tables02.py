"""What lesson 02 draws and says of poses that no row makes, and of rows as somebody prints them."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...robots import load
from ...table import DHTable
from ...transform import rot_x, rot_y, trans
from ..kinds import Mistakes, Said
from .answers02 import lengths, link, read_off

__all__ = ["draw_poses", "draw_printed", "makeable", "miscopied", "misjudged", "printed_arm"]


def draw_poses(rng: np.random.Generator) -> dict[str, Any]:
    """Four poses in the order of the seed: two that a row makes, one shifted along y1, one whose x1
    leans and meets z0 all the same. So each of the two conditions is needed.
    """
    (d1, a1), (d2, a2) = lengths(rng), lengths(rng)
    row = link(float(rng.choice([25, 40, 65])), d1, a1, float(rng.choice([30, 55, 70])))
    back = link(-float(rng.choice([20, 50, 75])), -d2, -a2, float(rng.choice([35, 60, 80])))
    aside = link(30.0, d2, a1, 40.0) @ trans([0, 0.08, 0])
    leaning = link(50.0, d1, a2, 0.0) @ rot_y(np.deg2rad(25)) @ rot_x(np.deg2rad(35))
    poses = [row, back, aside, leaning]
    return {f"T_{letter}": poses[k] for letter, k in zip("abcd", rng.permutation(4))}


def leftovers(T: NDArray) -> tuple[float, float]:
    """What no row can make: how far x leans towards the old z, and how far its line passes by it
    (m).
    """
    return T[2, 0], np.cross([0, 0, 1], T[:3, 0]) @ T[:3, 3]


def makeable(**poses: NDArray) -> list[float]:
    return [float(max(map(abs, leftovers(T))) < 1e-9) for T in poses.values()]


def misjudged(**poses: NDArray) -> Mistakes:
    """All fifteen wrong answers, each with its first reason."""
    right, names = np.array(makeable(**poses)), list(poses)
    yield (
        "four-numbers-for-any-pose",
        Said(
            "1 and 0 look exchanged",
            next="1 is for a pose that one row makes, and whose leftovers are both 0.",
        ),
        1 - right,
    )
    for code in range(16):
        given = np.array([code >> k & 1 for k in range(4)], dtype=float)
        if (given == right).all() or (given == 1 - right).all():
            continue
        k = int(np.argmax(given != right))
        yield *_reason(names[k], poses[names[k]], given[k]), given


def _reason(name, T, given):
    """Why the answer for one pose is wrong, as (mistake, place)."""
    look = f'Print leftovers(poses["{name}"])'
    if given:
        lean, _ = leftovers(T)
        if abs(lean) > 1e-9:
            return "x-not-across-z", Said(
                f"{name} cannot be made by one row: its x1 leans towards z0",
                next=f"{look}: both numbers must be 0.",
            )
        return "origin-off-common-normal", Said(
            f"{name} cannot be made by one row: its x1 passes z0 by",
            next=f"{look}: both numbers must be 0.",
        )
    if read_off(T)[2] < 0:
        return "minus-taken-for-error", Said(
            f"{name} can be made by one row",
            next=f"{look}. A minus sign in the pose is no objection.",
        )
    return "measured-in-other-frame", Said(
        f"{name} can be made by one row", next=f"{look}: is anything left over?"
    )


def draw_printed(rng: np.random.Generator) -> dict[str, Any]:
    """A UR arm's table as its maker prints it: θ (rad), a (m), d (m), α (rad)."""
    name = str(rng.choice(["ur3e", "ur10e", "ur5_cb", "ur10_cb"]))
    return {"arm": name, "rows": load(name).table.rows[:, [0, 2, 1, 3]].tolist()}


def _in_our_order(rows):
    return [[np.rad2deg(theta), d, a, np.rad2deg(alpha)] for theta, a, d, alpha in rows]


def printed_arm(arm: str, rows: list[list[float]]) -> Arm:
    return Arm(DHTable.standard(_in_our_order(rows), angle="deg"))


def miscopied(arm: str, rows: list[list[float]]) -> Mistakes:
    right = np.array(_in_our_order(rows))
    yield (
        "columns-misread",
        Said(
            "these are the rows as printed: θ, a, d, α, the angles in radians",
            next="Two columns change places, and the angles are wanted in degrees.",
        ),
        rows,
    )
    yield (
        "a-d-exchanged",
        Said("the columns stand as printed: θ, a, d, α", next="Which two change places?"),
        right[:, [0, 2, 1, 3]],
    )
