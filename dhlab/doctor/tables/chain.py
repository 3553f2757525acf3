"""An arm that is told as a chain of constant moves and joints, in any order."""

import warnings
from dataclasses import dataclass

import numpy as np

from ...arm import Arm
from ...geometry.procedure.frames import NearlyParallelWarning, assign_frames
from ...kinematics import link_matrices
from ...table import DHTable

__all__ = ["Step", "arm_of", "joint_along", "still"]
MOST_JOINTS = 60


@dataclass(frozen=True)
class Step:
    """A constant pose, or with ``letter`` "R" or "P" a joint along ``axis``, which counts against
    it where ``sign`` is -1.
    """

    pose: np.ndarray | None = None
    letter: str = ""
    axis: tuple = (0.0, 0.0, 1.0)
    sign: int = 1
    limits: tuple | None = None


def still(pose):
    """A Step that does not move."""
    return Step(np.asarray(pose, dtype=float))


def joint_along(letter, axis, sign=1, limits=None):
    """A Step that turns about an axis, or slides along it: "x", "y", "z" or three numbers."""
    named = {"x": (1.0, 0, 0), "y": (0, 1.0, 0), "z": (0, 0, 1.0)}
    vector = named[axis] if isinstance(axis, str) else axis
    return Step(None, letter, tuple(vector), sign, limits)


def rows_of(convention, rows, letters, signs, limits=None):
    """The Steps of table rows; a letter "" is a row without a joint."""
    for (theta, d, a, alpha), letter, sign, limit in zip(
        rows, letters, signs, limits or [None] * len(rows)
    ):
        turn = still(link_matrices("standard", theta, d, 0.0, 0.0))
        across = still(link_matrices("standard", 0.0, 0.0, a, alpha))
        move = [joint_along(letter, "z", sign, limit)] if letter else []
        yield from [*move, turn, across] if convention == "standard" else [across, *move, turn]


def arm_of(steps, convention="standard"):
    """The Arm of a chain of Steps; its forward pose is the chain's for every q.

    Parameters
    ----------
    steps : sequence of Step
    convention : "standard" or "craig"
        Of the table that it gets.

    Raises
    ------
    ValueError
        No joint is in it, or more than any arm has.

    Examples
    --------
    >>> from dhlab.transform import trans
    >>> steps = [joint_along("R", "z"), still(trans([0.4, 0, 0.1]))]
    >>> arm_of(steps).forward([0.0])[:3, 3]
    array([0.4, 0. , 0.1])
    """
    steps = list(steps)
    moving = sum(bool(step.letter) for step in steps)
    if moving > MOST_JOINTS:
        raise ValueError(
            f"recognise_table: expected at most {MOST_JOINTS} joints, found {moving}; paste one arm"
        )
    T, axes, signs, limits = np.eye(4), [], [], []
    for step in steps:
        if not step.letter:
            T = T @ step.pose
            continue
        direction = T[:3, :3] @ np.asarray(step.axis, dtype=float) * step.sign
        axes.append((T[:3, 3].copy(), direction, step.letter))
        signs.append(step.sign), limits.append(step.limits)
    if not axes:
        raise ValueError(
            "recognise_table: expected at least one joint, found constant moves only; name the"
            " joint variables, as q1"
        )
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", NearlyParallelWarning)
        try:
            arm = assign_frames(axes, end=T, convention=convention)
        except ValueError as error:
            raise ValueError(f"recognise_table: the chain makes no table: {error}") from None
    return Arm(
        DHTable(convention, *arm.table.rows.T, arm.table.joints),
        base=arm.base,
        tool=arm.tool,
        sign=arm.sign,
        limits=limits if any(limits) else None,
    )
