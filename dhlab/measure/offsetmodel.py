"""Poses of an arm as functions of its zero offsets, and of where it stands and what it holds; with
derivatives.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..arm import Arm
from ..rotations import from_rotation_vectors, rotation_vectors
from ..table import DHTable
from .leastsquares import least_squares

__all__ = ["OffsetModel", "Weights"]

# standard deviations of a position (m) and of a turn (rad; None where none was measured)
Weights = tuple[float, Any]


class OffsetModel:
    """``W · arm(q + offsets) · E`` against what was measured.

    The unknowns are a vector: n offsets (added to theta, or to d), then, when free, W as shift and
    rotation vector (6), then E likewise (its shift alone when only positions were measured).

    Parameters
    ----------
    arm : Arm
    q : array (m, n)
    poses : array (m, 4, 4) or (m, 3)
    base, tool : bool
        Whether W and E are free.
    """

    def __init__(
        self, arm: Arm, q: NDArray[np.float64], poses: NDArray[np.float64], base: bool, tool: bool
    ) -> None:
        self.arm, self.q, self.n, self.slides = arm, q, len(arm), arm.table.prismatic
        self.points = poses if poses.ndim == 2 else poses[:, :3, 3]
        self.R = None if poses.ndim == 2 else poses[:, :3, :3]
        self.n_base, self.n_tool = 6 * base, (3 if self.R is None else 6) * tool
        self.size = self.n + self.n_base + self.n_tool
        self.numbers = self.points.size * (1 if self.R is None else 2)

    def start(self, offsets: NDArray[np.float64] | None = None) -> NDArray[np.float64]:
        """Unknowns to begin from: the offsets, with base and tool put where they fit best."""
        x = np.zeros(self.size)
        x[: self.n] = 0.0 if offsets is None else offsets
        T = self.arm.forward(self._moved(x))
        R, p, R_W = T[:, :3, :3], T[:, :3, 3], np.eye(3)
        if self.n_base:
            R_W = self._turn_of_base(R, p)
            x[self.n : self.n + 6] = np.r_[
                (self.points - p @ R_W.T).mean(axis=0), rotation_vectors(R_W)
            ]
        if self.n_tool == 6 and self.R is not None:
            x[-3:] = rotation_vectors(_nearest((np.swapaxes(R_W @ R, 1, 2) @ self.R).sum(axis=0)))
        return x

    def _turn_of_base(self, R, p):
        if self.R is not None and not self.n_tool:
            return _nearest((self.R @ np.swapaxes(R, 1, 2)).sum(axis=0))
        return _nearest((self.points - self.points.mean(axis=0)).T @ (p - p.mean(axis=0)))

    def _moved(self, x):
        return self.q + self.arm.sign * x[: self.n]  # sign · (q + sign · x) = sign · q + x

    def _split(self, x):
        """Shifts and rotation vectors of W and E; zeros where fixed."""
        rest = np.r_[
            x[self.n : self.n + self.n_base],
            np.zeros(6 - self.n_base),
            x[self.n + self.n_base :],
            np.zeros(6 - self.n_tool),
        ]
        return rest[:3], rest[3:6], rest[6:9], rest[9:]

    def base(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """W (4, 4)."""
        if not self.n_base:
            return np.eye(4)
        t, w, _, _ = self._split(x)
        return _pose(from_rotation_vectors(w), t)

    def tool(self, x: NDArray[np.float64]) -> NDArray[np.float64]:
        """E (4, 4)."""
        if not self.n_tool:
            return np.eye(4)
        _, _, u, e = self._split(x)
        return _pose(from_rotation_vectors(e), u)

    def parts(
        self, x: NDArray[np.float64]
    ) -> tuple[NDArray[np.float64], NDArray[np.float64] | None]:
        """Model minus measurement: positions (m, 3) in m, and rotations (m, 9) as chords, in rad to
        first order, or None.
        """
        T = self.base(x) @ self.arm.forward(self._moved(x)) @ self.tool(x)
        rotation = None if self.R is None else (T[:, :3, :3] - self.R).reshape(-1, 9) / np.sqrt(2)
        return T[:, :3, 3] - self.points, rotation

    def residual(self, x: NDArray[np.float64], weights: Weights) -> NDArray[np.float64]:
        """All of it in standard deviations, flat; ``weights`` are (m, rad)."""
        p, r = self.parts(x)
        return (
            p.ravel() / weights[0]
            if r is None
            else np.r_[p.ravel() / weights[0], r.ravel() / weights[1]]
        )

    def jacobian(self, x: NDArray[np.float64], weights: Weights) -> NDArray[np.float64]:
        """Derivative of :meth:`residual` by the unknowns: (numbers, size)."""
        q, (t, w, u, e) = self._moved(x), self._split(x)
        W, E, F = self.base(x), self.tool(x), self.arm.forward(q)
        J = self.arm.jacobian(q) * self.arm.sign
        T = W @ F @ E
        omega = np.swapaxes(J[:, 3:], 1, 2)
        v = np.swapaxes(J[:, :3], 1, 2) + np.cross(omega, (F[:, :3, :3] @ u)[:, None])
        v, omega = v @ W[:3, :3].T, omega @ W[:3, :3].T  # (m, unknown, 3)
        many = (len(q), 3, 3)
        if self.n_base:
            turn = np.broadcast_to(_left(w).T, many)
            shift = np.broadcast_to(np.eye(3), many)
            v = np.concatenate([v, shift, np.cross(turn, (T[:, :3, 3] - t)[:, None])], axis=1)
            omega = np.concatenate([omega, np.zeros(many), turn], axis=1)
        if self.n_tool:
            R = W[:3, :3] @ F[:, :3, :3]
            v = np.concatenate(
                [v, np.swapaxes(R, 1, 2), np.zeros((len(q), self.n_tool - 3, 3))], axis=1
            )
            omega = np.concatenate(
                [omega, np.zeros(many), np.swapaxes(R @ _left(e), 1, 2)[:, : self.n_tool - 3]],
                axis=1,
            )
        rows = [np.swapaxes(v, 1, 2).reshape(-1, self.size) / weights[0]]
        if self.R is not None:
            # (m, unknown, column, 3)
            dR = np.cross(omega[:, :, None, :], np.swapaxes(T[:, :3, :3], 1, 2)[:, None])
            rows.append(
                np.moveaxis(np.swapaxes(dR, 2, 3), 1, 3).reshape(-1, self.size)
                / weights[1]
                / np.sqrt(2)
            )
        return np.vstack(rows)

    def solve(
        self, x: NDArray[np.float64], weights: Weights, keep: NDArray[np.bool_] | None = None
    ) -> NDArray[np.float64]:
        """Least squares from ``x``, over the unknowns in ``keep`` (all when left out)."""
        keep = np.ones(self.size, dtype=bool) if keep is None else keep

        def whole(part):
            full = x.copy()
            full[keep] = part
            return full

        return whole(
            least_squares(
                lambda part: self.residual(whole(part), weights),
                x[keep],
                lambda part: self.jacobian(whole(part), weights)[:, keep],
            )
        )

    def corrected(self, x: NDArray[np.float64]) -> Arm:
        """The arm with offsets, base and tool put in."""
        table = self.arm.table
        theta = table.theta + np.where(self.slides, 0.0, x[: self.n])
        d = table.d + np.where(self.slides, x[: self.n], 0.0)
        base = self.base(x) @ self.arm.base if self.n_base else self.arm.base
        tool = self.arm.tool @ self.tool(x) if self.n_tool else self.arm.tool
        return Arm(
            DHTable(table.convention, theta, d, table.a, table.alpha, table.joints),
            base,
            tool,
            self.arm.limits,
            self.arm.sign,
            self.arm.name,
            self.arm.source,
        )


def _nearest(A):
    """The rotation nearest to a matrix (3, 3): to a sum of rotations their mean, to one of products
    of points the turn that carries the ones to the others best (Kabsch 1976).
    """
    U, _, Vt = np.linalg.svd(A)
    return U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt


def _pose(R, p):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T


def _left(w):
    """The left Jacobian of a rotation vector: ω = _left(w) dw/dt (Barfoot, State Estimation for
    Robotics, chapter 7).
    """
    angle = np.linalg.norm(w)
    K = np.cross(np.eye(3), w)  # [w×]
    if angle < 1e-6:
        return np.eye(3) + K / 2
    return (
        np.eye(3) + (1 - np.cos(angle)) / angle**2 * K + (angle - np.sin(angle)) / angle**3 * K @ K
    )
