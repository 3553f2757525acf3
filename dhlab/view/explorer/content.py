"""Arms as plain numbers for the explorer's JavaScript; and numbers from it, checked."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from traitlets import TraitType

from ...arm import Arm

__all__ = ["Numbers", "arm_data", "pose_data"]


def arm_data(arm: Arm) -> dict[str, Any]:
    """An arm as JSON: radians and metres, matrices row by row."""
    data = {
        "name": arm.name,
        "convention": arm.table.convention,
        "joints": arm.table.joints,
        "rows": arm.table.rows.tolist(),
        "base": pose_data(arm.base),
        "tool": pose_data(arm.tool),
        "sign": arm.sign.tolist(),
        "limits": None if arm.limits is None else [pair and list(pair) for pair in arm.limits],
    }
    if arm.coupling is not None:  # a page says nothing of what is not there
        data["coupling"] = arm.coupling.tolist()
    return data


def pose_data(T: ArrayLike) -> list[float]:
    """A pose (4, 4) as 16 numbers, row by row."""
    return np.asarray(T, dtype=float).ravel().tolist()


class Numbers(TraitType):
    """So many finite numbers, in the shape ``obj.counts`` has for them: a read-only array here, a
    list on the way to JavaScript.
    """

    def __init__(self, **keywords: Any) -> None:
        super().__init__(np.zeros(0), **keywords)
        self.tag(
            sync=True,
            to_json=lambda value, widget: value.tolist(),
            from_json=lambda value, widget: value,
        )

    def validate(self, obj: Any, value: Any) -> NDArray[np.float64]:
        """The numbers as an array, or a sentence."""
        shape = obj.counts[self.name]
        try:
            array = np.array(value)
        except ValueError:  # ragged
            array = np.array(None)
        if array.dtype.kind not in "iuf" or array.shape != shape or not np.isfinite(array).all():
            raise ValueError(
                f"explorer.{self.name}: expected {' × '.join(map(str, shape))} finite numbers"
                f" (radians, metres for lengths), found {value!r}"
            )
        array = array.astype(float)
        array.flags.writeable = False
        return array

    def set(self, obj: Any, value: Any) -> None:
        """Keep the array and tell nobody when nothing changes."""
        new: Any = self._validate(obj, value)
        if not np.array_equal(new, obj._trait_values.get(self.name)):
            super().set(obj, new)
