"""What was asked: one target and the conditions on its solutions."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from .joints import bounds

__all__ = ["Question", "free_joints"]


@dataclass(frozen=True)
class Question:
    """One target for an arm.

    Parameters
    ----------
    arm : Arm
    T : array (4, 4)
    limits : bool
        Only solutions within the arm's stated limits count.
    near : array (n,) or None
        Where the arm stands: solutions nearest to it come first.
    holds : tuple of {joint from 0: value of q}, or None
        The stated values of the redundancy.
    tolerance : float
        Metres and radians.
    """

    arm: Arm
    T: NDArray[np.float64]
    limits: bool = False
    near: NDArray[np.float64] | None = None
    holds: tuple[Mapping[int, float], ...] | None = None
    tolerance: float = 1e-9

    @property
    def reference(self) -> NDArray[np.float64]:
        """Where the arm stands; when that is not said, q = 0, or the limit nearest to 0."""
        low, high = bounds(self.arm)
        return np.clip(0.0, low, high) if self.near is None else self.near


def free_joints(arm: Arm, hold: Iterable[int]) -> NDArray[np.bool_]:
    """Which joints may move while those of ``hold`` stay: booleans (n,)."""
    return ~np.isin(np.arange(len(arm)), list(hold))
