"""``OfAxes``: an arm to be made of its joint axes by ``dh.assign_frames``."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....arm import Arm
from ...verdict import RIGHT, Verdict
from ..exercise import Said
from .arms import apart, size, where
from .tables import Table

__all__ = ["OfAxes"]

NO_ARM_YET = Said(
    "these are joint axes, not yet an arm",
    next="Hand in what dh.assign_frames makes of the axes and the end.",
)
LOADED = Said(
    "this arm was loaded: it says where its numbers come from",
    next="Hand in the arm that dh.assign_frames makes of the axes you write down.",
)


@dataclass(frozen=True, kw_only=True)
class OfAxes(Table):
    """An arm that is made of axes: what is wrong is told of points, directions and the end. Rows of
    its table are nothing that the learner wrote.
    """

    def arm_of(self, answer: Any, right: Arm) -> Arm | Verdict:
        if _are_axes(answer):
            return self.told(None, NO_ARM_YET)
        return super().arm_of(answer, right)

    def judged(self, arm: Arm, right: Arm, variant: int) -> Verdict:
        verdict = super().judged(arm, right, variant)
        if arm.source and verdict.status == RIGHT:
            return self.told(None, LOADED)
        return verdict

    def _explained(self, arm: Arm, right: Arm, q: NDArray[np.float64], variant: int) -> Verdict:
        return self.known(arm, q, variant) or self.wrong(
            headline=f"this is another arm: up to {size(apart(arm, right, q))} off at the end",
            place=where(arm, right, q, of_rows=False),
        )


def _are_axes(answer):
    """Whether an answer is pairs of points and directions, perhaps with the end beside them."""
    if isinstance(answer, Arm) or not isinstance(answer, (list, tuple)) or not len(answer):
        return False
    if len(answer) == 2 and np.shape(answer[1]) == (4, 4):
        return _are_axes(answer[0])
    return all(
        isinstance(axis, (list, tuple)) and len(axis) == 2 and all(np.size(x) == 3 for x in axis)
        for axis in answer
    )
