"""What the pictures were given: checked, and in one shape."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arm import Arm
from ..transform import pose_fault
from .drawing.style import POSES

__all__ = [
    "require_arm",
    "given_poses",
    "given_names",
    "given_arm_at",
    "given_arm_at_all",
    "all_frames",
    "spread",
]


def given_poses(poses: ArrayLike) -> NDArray[np.float64]:
    """One pose or several as an array (k, 4, 4), or a sentence."""
    try:
        chain = np.asarray(poses)
    except ValueError:  # ragged
        chain = np.array(None)
    if chain.shape == (4, 4):
        chain = chain[None]
    if chain.ndim != 3 or chain.shape[1:] != (4, 4) or not len(chain):
        raise ValueError(
            "view.frames: expected one pose (4, 4) or several (k, 4, 4), found shape"
            f" {chain.shape}; build them with dhlab.transform"
        )
    fault = pose_fault(chain)
    if fault:
        raise ValueError(
            f"view.frames: expected poses, but of what was given {fault}; build them with"
            " dhlab.transform"
        )
    return chain.astype(float)


def given_names(names: Iterable[object] | None, count: int, default: list[str]) -> list[str]:
    """One text per thing to be named, or a sentence; ``default`` when there are none."""
    if names is None:
        return default
    listed = [names] if isinstance(names, str) or not np.iterable(names) else list(names)
    if len(listed) != count:
        raise ValueError(
            f"names: expected {count}, one for each, found {len(listed)}; leave them out for"
            " numbers"
        )
    for name in listed:
        if not isinstance(name, (str, int)):
            raise ValueError(f"names: expected texts, found {name!r}; write it in quotes")
    return [str(name) for name in listed]


def require_arm(arm: object, where: str) -> None:
    """A sentence when this is no Arm."""
    if not isinstance(arm, Arm):
        raise ValueError(
            f"{where}: expected an Arm first, found {type(arm).__name__}; make one with"
            " dhlab.Arm(table) or dhlab.load(name)"
        )


def given_arm_at(arm: Arm, q: ArrayLike | None) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """One configuration (n,) and the arm's frames at it (n + 1, 4, 4), or a sentence."""
    require_arm(arm, "view.arm")
    q = np.zeros(len(arm)) if q is None else q
    chain = arm.frames(q)
    if chain.ndim != 3:
        raise ValueError(
            f"view.arm: expected one configuration of {len(arm)} values, found shape {np.shape(q)};"
            " several are for view.poses"
        )
    return np.asarray(q, dtype=float), chain


def given_arm_at_all(arm: Arm, qs: ArrayLike) -> NDArray[np.float64]:
    """The arm's frames (k, n + 1, 4, 4) at every configuration, or a sentence."""
    require_arm(arm, "view.poses")
    chains = arm.frames(qs)
    if chains.ndim != 4 or not 1 <= len(chains) <= len(POSES):
        raise ValueError(
            f"view.poses: expected 1 to {len(POSES)} configurations (k, {len(arm)}), found shape"
            f" {np.shape(qs)}; give a list of them"
        )
    return chains


def all_frames(
    arm: Arm, chain: NDArray[np.float64]
) -> tuple[NDArray[np.float64], list[str], list[str]]:
    """Every frame of an arm with its tool's: poses (k, 4, 4), subscripts, and what to write at the
    origins.

    Base and tool are named when they are not the identity; the base's frame is frame 0.
    """
    n = len(chain) - 1
    names = [str(i) for i in range(n + 1)]
    titles = [f"{{{name}}}" for name in names]
    if not np.array_equal(arm.base, np.eye(4)):
        titles[0] = "{0} base"
    if np.array_equal(arm.tool, np.eye(4)):
        return chain, names, titles
    return np.concatenate([chain, [chain[-1] @ arm.tool]]), [*names, "tool"], [*titles, "tool"]


def spread(points: NDArray[np.float64]) -> float:
    """The longest side of the upright box around points (k, 3)."""
    return float(np.ptp(points, axis=0).max())
