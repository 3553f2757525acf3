"""What a picture shows, said from its numbers: directions, places, frames that coincide, and the
table of the frames.
"""

from collections.abc import Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arm import Arm
from ..printing import listed, number
from .drawing.triads import coincident

__all__ = [
    "FRAME_HEADINGS",
    "frame_rows",
    "direction",
    "place",
    "joint_words",
    "configuration",
    "who",
    "arm_sentences",
    "frame_sentences",
]

FRAME_HEADINGS = ("frame", "x (m)", "y (m)", "z (m)", "x axis", "y axis", "z axis")


def frame_rows(poses: NDArray[np.float64], names: Iterable[str]) -> list[list[str]]:
    """A row of texts per frame: name, origin in metres, directions of x, y and z."""
    return [
        [name, *(number(v, 4) for v in pose[:3, 3]), *(_vector(axis) for axis in pose[:3, :3].T)]
        for name, pose in zip(names, poses)
    ]


def _vector(axis):
    return "(" + ", ".join(number(v, 3) for v in axis) + ")"


def direction(axis: NDArray[np.float64]) -> str:
    """A unit vector (3,) in words: the world axis it lies on, or its three components.

    Examples
    --------
    >>> direction([0, 0, -1]), direction([0.6, 0.8, 0])
    ('along -z', 'along (0.6, 0.8, 0)')
    """
    axis = np.asarray(axis, dtype=float)
    k = np.argmax(np.abs(axis))
    if abs(axis[k]) > 1 - 1e-6:
        return f"along {'+' if axis[k] > 0 else '-'}{'xyz'[k]}"
    return f"along {_vector(axis)}"


def place(point: Iterable[float]) -> str:
    """A point (3,) in words, to a tenth of a millimetre.

    Examples
    --------
    >>> place([0.75, -0.2, 0.1])
    'x = 0.75, y = -0.2, z = 0.1 m'
    """
    return ", ".join(f"{letter} = {number(v, 4)}" for letter, v in zip("xyz", point)) + " m"


def _shared_origins(poses, names):
    """A sentence for each set of frames with one origin; empty when there is none."""
    groups = [group for group in coincident(poses[:, :3, 3]) if len(group) > 1]
    return "".join(
        f" Frames {listed(names[k] for k in group)} share one origin." for group in groups
    )


def joint_words(joints: str) -> str:
    """How many joints of which kind.

    Examples
    --------
    >>> joint_words("RRRRRR"), joint_words("RRPR"), joint_words("R")
    ('6 revolute joints', '3 revolute joints and 1 prismatic joint', '1 revolute joint')
    """
    counts = [(joints.count("R"), "revolute"), (joints.count("P"), "prismatic")]
    return listed(
        f"{count} {kind} joint{'s' if count > 1 else ''}" for count, kind in counts if count
    )


def configuration(joints: str, q: ArrayLike) -> str:
    """Joint values as a person writes them.

    Examples
    --------
    >>> configuration("RP", [np.pi / 2, 0.1])
    '90°, 0.1 m'
    """
    return ", ".join(
        f"{number(value, 4)} m" if letter == "P" else f"{number(np.rad2deg(value), 2)}°"
        for letter, value in zip(joints, np.asarray(q))
    )


def who(arm: Arm) -> str:
    """An arm's name and joints, as a sentence begins."""
    kind = f"with {joint_words(arm.table.joints)}"
    return f"{arm.name}: an arm {kind}" if arm.name else f"An arm {kind}"


def arm_sentences(arm: Arm, q: ArrayLike, poses: NDArray[np.float64], names: Sequence[str]) -> str:
    """What is to be seen of an arm at ``q``; the last of the poses is its end."""
    end = poses[-1]
    return (
        f"{who(arm)}, drawn at q = {configuration(arm.table.joints, q)}. Its end is at"
        f" {place(end[:3, 3])}, its x axis {direction(end[:3, 0])} and its z axis"
        f" {direction(end[:3, 2])}.{_shared_origins(poses, names)}"
    )


def frame_sentences(poses: NDArray[np.float64], names: Sequence[str]) -> str:
    """Where each frame is and which way its z axis points; of many, the last."""
    told = list(zip(poses, names))
    told = told if len(told) <= 4 else told[-1:]
    each = [
        f"{name} is at {place(pose[:3, 3])}, its x axis {direction(pose[:3, 0])}, its z axis"
        f" {direction(pose[:3, 2])}."
        for pose, name in told
    ]
    return " ".join(each) + _shared_origins(poses, names)
