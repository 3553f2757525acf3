"""One move of one frame, on the columns of a table: every other table of an arm is made of them."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from ..table import DHTable
from ..transform import inverse

__all__ = ["FREE", "Edit", "half_turn"]


# |sin alpha| (and |a| in m) below this leave the slide (and the twist) free: what it costs is below
# the rounding of a pose
FREE = 1e-12


def half_turn(angle: float) -> float:
    """``angle`` and 180° more or less, whichever is nearer to 0: two half turns give the number
    back.

    Examples
    --------
    >>> float(half_turn(0.0)) == np.pi, float(half_turn(np.pi))
    (True, 0.0)
    """
    return angle - np.pi if angle > 0 else angle + np.pi


class Edit:
    """The columns of an arm opened for one move at frame i; :meth:`arm` closes it, giving G to the
    base or the tool at the ends.
    """

    def __init__(self, arm: Arm, i: int, verb: str) -> None:
        n = len(arm)
        if (
            isinstance(i, (bool, np.bool_))
            or not isinstance(i, (int, np.integer))
            or not 0 <= i <= n
        ):
            raise ValueError(
                f"{verb}: expected a frame from 0 to {n}, found {i!r}; frames 1 to {n - 1} stand"
                " between two rows"
            )
        self.of, self.i, self.verb = arm, int(i), verb
        self.standard = arm.table.convention == "standard"
        self.theta, self.d, self.a, self.alpha = (np.array(column) for column in arm.table.rows.T)
        self.sign = np.array(arm.sign)
        self.coupling = None if arm.coupling is None else np.array(arm.coupling)
        self.rows = [k for k in (i - 1, i) if 0 <= k < n]  # 0-based: row i, then row i + 1

    @property
    def normal_row(self) -> int | None:
        """The 0-based row of a_i and alpha_i, or None where the table has no such entry."""
        k = self.i - 1 if self.standard else self.i
        return k if 0 <= k < len(self.theta) else None

    def normal(self, times: float, turn: Callable[[float], float]) -> None:
        k = self.normal_row
        if k is not None:
            self.a[k], self.alpha[k] = times * self.a[k], turn(self.alpha[k])

    def turn_joint(self, k: int) -> None:
        """The joint of row ``k`` (0-based) counts the other way, in the table and at the
        controller; so does its share in the joints that are coupled to it.
        """
        self.theta[k], self.d[k], self.sign[k] = -self.theta[k], -self.d[k], -self.sign[k]
        if self.coupling is not None:
            self.coupling[k] *= -1
            self.coupling[:, k] *= -1

    def free_cosine(self, cannot: str, fixed: str, lengths_too: bool = False) -> float:
        """cos(alpha_i), which is ±1; a sentence when frame i has no such freedom."""
        k = self.normal_row
        if k is None:
            return 1.0
        if abs(np.sin(self.alpha[k])) > FREE:
            angle = np.rad2deg(self.alpha[k])
            raise ValueError(
                f"{self.verb}: frame {self.i} {cannot}, since alpha{self.i} = {angle:.6g}° is"
                f" neither 0° nor 180°: the axes there are not parallel, so {fixed} stays where"
                " it is"
            )
        if lengths_too and abs(self.a[k]) > FREE:
            raise ValueError(
                f"{self.verb}: frame {self.i} {cannot}, since a{self.i} = {self.a[k]:.6g} m is not"
                f" 0: the axes there do not coincide, so {fixed} stays as it is"
            )
        return np.sign(np.cos(self.alpha[k]))

    def add(self, column: NDArray[np.float64], amount: float, cosine: float) -> None:
        """``amount`` in frame i: into row i and out of row i + 1, one of them seen through
        alpha_i.
        """
        before, behind = (cosine, 1.0) if self.standard else (1.0, cosine)
        if self.i > 0:
            column[self.i - 1] += amount * before
        if self.i < len(column):
            column[self.i] -= amount * behind

    def arm(self, G: NDArray[np.float64]) -> Arm:
        arm, t = self.of, self.of.table
        table = DHTable(t.convention, self.theta, self.d, self.a, self.alpha, t.joints)
        base = arm.base @ G if self.i == 0 else arm.base
        tool = inverse(G) @ arm.tool if self.i == len(arm) else arm.tool
        return Arm(
            table,
            base=base,
            tool=tool,
            limits=arm.limits,
            sign=self.sign,
            name=arm.name,
            source=arm.source,
            coupling=self.coupling,
        )
