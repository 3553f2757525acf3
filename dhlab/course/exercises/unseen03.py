"""What 03.10 draws and says of wrong answers: a table with no name on it."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...robots import load
from ...table import DHTable
from ..kinds import LAST_ROW, Known, Mistakes, Said, as_numbers, numbers

__all__ = ["draw_unseen", "unseen_point", "whole_pose", "wrong_points"]

UNSEEN = ("piper", "irb120")


def draw_unseen(rng: np.random.Generator) -> dict[str, Any]:
    """A table that no habit gives away: its owner counts in a bracket below joint 1 (Craig) or a
    hand (standard), so both ends hold numbers.
    """
    table = load(str(rng.choice(UNSEEN))).to(str(rng.choice(["standard", "craig"]))).table
    rows = np.array(numbers(table))
    rows[0 if table.convention == "craig" else -1, 2:] = (
        rng.choice([0.05, 0.08, 0.1]),
        rng.choice([-90.0, 90.0]),
    )
    arm = _read_as(table.convention, rows)
    q_check, q = rng.integers(15, 75, (2, len(arm))) * rng.choice([-1, 1], (2, len(arm)))
    return {
        "rows": rows.tolist(),
        "q_check": q_check.tolist(),
        "p_check": arm.forward(np.deg2rad(q_check))[:3, 3].round(3).tolist(),
        "q": q.tolist(),
    }


def _read_as(convention, rows, angle="deg"):
    return Arm(getattr(DHTable, convention)(rows, angle=angle))


def _convention_of(rows, q_check, p_check):
    return min(
        ("standard", "craig"),
        key=lambda name: np.linalg.norm(
            _read_as(name, rows).forward(np.deg2rad(q_check))[:3, 3] - p_check
        ),
    )


def unseen_point(
    rows: list[list[float]], q_check: list[float], p_check: list[float], q: list[float]
) -> NDArray:
    return _read_as(_convention_of(rows, q_check, p_check), rows).forward(np.deg2rad(q))[:3, 3]


def wrong_points(
    rows: list[list[float]], q_check: list[float], p_check: list[float], q: list[float]
) -> Mistakes:
    right = _convention_of(rows, q_check, p_check)
    mistake, other = (
        ("craig-rows-in-standard-matrix", "standard")
        if right == "craig"
        else ("standard-rows-in-craig-matrix", "craig")
    )
    arm, angles = _read_as(right, rows), np.deg2rad(q)
    yield (
        mistake,
        "this is the rows' other reading, which the check pose does not fit",
        _read_as(other, rows).forward(angles)[:3, 3],
    )
    yield from _points_of(right, rows, q)
    yield (
        "conversion-incomplete",
        "the rows were converted and then read in the convention they came from",
        _read_as(right, numbers(arm.to(other).table)).forward(angles)[:3, 3],
    )
    yield (
        "conversion-incomplete",
        "the rows were converted, and base or tool forgotten",
        _read_as(other, numbers(arm.to(other).table)).forward(angles)[:3, 3],
    )
    for _, said, point in _points_of(other, rows, q):
        yield mistake, f"{said}, in the reading that the check pose does not fit", point
    asked = Said("this is p_check, the point at q_check; the point at q is asked", next=PUT_IN)
    yield "joint-values-unused", asked, np.asarray(p_check)
    yield (
        mistake,
        "this is the point at q_check, in the reading that the check pose does not fit",
        _read_as(other, rows).forward(np.deg2rad(q_check))[:3, 3],
    )
    yield "rotation-block-misread", LAST_ROW, np.zeros(3)


def whole_pose(answer: object, **given: Any) -> Known | None:
    """A 4×4 whose last column is the point that is asked, or that column."""
    array, point = as_numbers(answer), unseen_point(**given)
    if array.shape == (4,) and np.allclose(array, [*point, 1], atol=1e-3):
        return None, Said(
            "the place is right, but the 1 at the end is not part of it",
            next="Three numbers are asked: [:3] takes the first three.",
        )
    if array.shape != (4, 4) or not np.allclose(array[:3, 3], point, atol=1e-3):
        return None
    return None, Said(
        "this is the end's whole pose, and its place is asked",
        next="Which column of a pose is the place?",
    )


PUT_IN = "The check pose says which reading is right. Put q into that arm."


def _points_of(convention, rows, q):
    """What one slip makes of the point, in one reading of the rows."""
    arm, angles = _read_as(convention, rows), np.deg2rad(q)
    T = arm.forward(angles)
    yield "joint-values-unused", "this is the point at q = 0", arm.forward(0 * angles)[:3, 3]
    yield (
        "degrees-in-sin-cos",
        "q was left in degrees",
        arm.forward(np.array(q, dtype=float))[:3, 3],
    )
    yield (
        "degrees-in-sin-cos",
        "the rows were read as radians",
        _read_as(convention, rows, "rad").forward(angles)[:3, 3],
    )
    yield (
        "offset-missing",
        "the rows' θ were left out",
        _read_as(convention, np.array(rows) * [0, 1, 1, 1]).forward(angles)[:3, 3],
    )
    yield (
        "offset-subtracted",
        "this is the point at −q: all joints turned the other way",
        arm.forward(-angles)[:3, 3],
    )
    yield "rotation-block-misread", "this is the end's z arrow", T[:3, 2]
    yield "rotation-block-misread", "this is the last row of the rotation", T[2, :3]
    yield "pose-inverted", "this is the base's origin, seen from the end", -T[:3, :3].T @ T[:3, 3]
