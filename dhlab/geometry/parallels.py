"""Axes that are nearly parallel, as a calibration leaves them: their common normal is far away, so
the d of their rows are huge and cancel.
"""

from dataclasses import dataclass

import numpy as np

from ..arm import Arm

__all__ = ["Cancelling", "cancelling"]

NEARLY = 0.03  # rad, how far from parallel; 0 is parallel
HUGE = 5.0  # times all other lengths together


@dataclass(frozen=True)
class Cancelling:
    """Neighbouring joints (from 1) whose d cancel, and what is left of them (m).

    Examples
    --------
    >>> print(Cancelling((2, 3, 4), 0.1104))
    d2, d3, d4 are large and cancel to 0.1104 m: axes 2, 3, 4 are nearly parallel, as a
    calibration leaves them, and their common normals lie far away. The numbers are no mistake
    """

    joints: tuple[int, ...]
    total: float

    def __str__(self):
        lengths, axes = (", ".join(f"{p}{i}" for i in self.joints) for p in ("d", ""))
        return (
            f"{lengths} are large and cancel to {self.total:.4g} m: axes {axes} are nearly"
            " parallel, as a calibration leaves them, and their common normals lie far away."
            " The numbers are no mistake"
        )


def cancelling(arm: Arm) -> list[Cancelling]:
    """The runs of nearly parallel axes of an arm whose d are huge and cancel.

    Examples
    --------
    >>> import dhlab as dh
    >>> rows = [[0, 500, 0.4, 0.001], [0, -499.9, 0, 1.57]]
    >>> cancelling(dh.Arm(dh.DHTable.standard(rows, angle="rad")))[0].joints
    (1, 2)
    >>> cancelling(dh.load("ur5e"))
    []
    """
    table = arm.table
    n = len(arm)
    alpha = table.alpha[: n - 1] if table.convention == "standard" else table.alpha[1:]
    found = []
    for first, last in _runs((np.abs(np.sin(alpha)) < NEARLY) & (np.sin(alpha) != 0), n):
        sense = np.cumprod([1.0, *np.sign(np.cos(alpha[first:last]))])
        d = table.d[first : last + 1]
        others = np.abs(table.a).sum() + np.abs(np.delete(table.d, range(first, last + 1))).sum()
        total = float(sense @ d)
        if np.abs(d).max() > HUGE * max(others, abs(total)):
            found.append(Cancelling(tuple(range(first + 1, last + 2)), total))
    return found


def _runs(joined, n):
    """(first, last) joint from 0 of every run of axes of which neighbours are joined."""
    first = 0
    for i in range(n):
        if i == n - 1 or not joined[i]:
            if i > first:
                yield first, i
            first = i + 1
