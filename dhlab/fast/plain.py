"""``Plain``: the product of link matrices of ``dhlab.kinematics``, applied to an arm. It is the
definition that the fast paths are held to, and their equal for a handful of poses.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import kinematics

__all__ = ["Plain"]


@dataclass(frozen=True, eq=False)
class Plain:
    """The parts of an arm, as in ``dhlab.Arm``; every method takes checked numbers (..., n)."""

    table: Any
    base: NDArray[np.float64]
    tool: NDArray[np.float64]
    sign: NDArray[np.float64]
    coupling: NDArray[np.float64] | None

    def joint_values(self, q: NDArray) -> NDArray[np.float64]:
        """coupling · (sign · q), or sign · q."""
        moved = self.sign * q
        return moved if self.coupling is None else moved @ self.coupling.T

    def variables(self, q: NDArray) -> tuple[NDArray, NDArray]:
        """theta and d (..., n) at ``q``."""
        moved, slides = self.joint_values(q), self.table.prismatic
        return (
            self.table.theta + np.where(slides, 0.0, moved),
            self.table.d + np.where(slides, moved, 0.0),
        )

    def links(self, q: NDArray) -> NDArray[np.float64]:
        """Every link matrix (..., n, 4, 4)."""
        table = self.table
        return kinematics.link_matrices(table.convention, *self.variables(q), table.a, table.alpha)

    def frames(self, q: NDArray) -> NDArray[np.float64]:
        """Every frame (..., n + 1, 4, 4)."""
        return kinematics.frames(self.base, self.links(q))

    def forward(self, q: NDArray) -> NDArray[np.float64]:
        """The end pose (..., 4, 4)."""
        return self.frames(q)[..., -1, :, :] @ self.tool

    def jacobian(self, q: NDArray) -> NDArray[np.float64]:
        """The Jacobian (..., 6, n)."""
        chain, table = self.frames(q), self.table
        end = chain[..., -1, :, :] @ self.tool
        if self.coupling is None:
            return kinematics.jacobian(table.convention, chain, end, table.prismatic, self.sign)
        ones = np.ones(len(table))
        J = kinematics.jacobian(table.convention, chain, end, table.prismatic, ones)
        return J @ (self.coupling * self.sign)  # the chain rule
