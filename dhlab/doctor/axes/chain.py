"""An arm as an axis sheet has it: the product of the joints' motions about the written axes, and
the end pose at zero (Brockett 1984; Lynch & Park, Modern Robotics, section 4.1).
"""

from dataclasses import dataclass, replace

import numpy as np

from ...rotations import skew

__all__ = ["Chain", "Around", "about"]


@dataclass(frozen=True)
class Chain:
    """Axes through ``p`` (n, 3) m along the unit vectors ``z`` (n, 3), ``letters`` such as "RRP",
    and the end pose ``end`` (4, 4) at q = 0; ``zero`` (n,) is added to q.
    """

    p: np.ndarray
    z: np.ndarray
    letters: str
    end: np.ndarray
    zero: np.ndarray

    def motions(self, q):
        """What each joint does: (n, m, 4, 4) for q (m, n)."""
        return np.array(
            [
                about(self.p[i], self.z[i], letter, q[:, i] + self.zero[i])
                for i, letter in enumerate(self.letters)
            ]
        )

    def forward(self, q):
        """End poses (m, 4, 4)."""
        T = np.broadcast_to(np.eye(4), (len(q), 4, 4))
        for each in self.motions(q):
            T = T @ each
        return T @ self.end

    def with_axis(self, i, p=None, z=None, zero=None):
        """The same chain with one axis (0-based) as given."""
        new = {"p": self.p.copy(), "z": self.z.copy(), "zero": self.zero.copy()}
        for name, value in (("p", p), ("z", z), ("zero", zero)):
            if value is not None:
                new[name][i] = value
        return replace(self, **new)

    def axes(self):
        """The axes as :func:`dhlab.assign_frames` takes them, in the zero pose that q = 0 means."""
        if not self.zero.any():
            return [(p, z, letter) for p, z, letter in zip(self.p, self.z, self.letters)]
        X, found = np.eye(4), []
        for p, z, letter, zero in zip(self.p, self.z, self.letters, self.zero):
            found.append((X[:3, :3] @ p + X[:3, 3], X[:3, :3] @ z, letter))
            X = X @ about(p, z, letter, np.array([zero]))[0]
        return found

    def end_at_zero(self):
        """The end pose at q = 0."""
        return self.forward(np.zeros((1, len(self.letters))))[0]


@dataclass(frozen=True)
class Around:
    """What stands before and behind each joint at every measured q: T = before · joint · behind."""

    before: np.ndarray
    behind: np.ndarray

    @classmethod
    def of(cls, chain, q):
        """Of a chain at q (m, n): two arrays (n + 1, m, 4, 4), the last for the end."""
        n, motions = len(chain.letters), chain.motions(q)
        before = np.broadcast_to(np.eye(4), (n + 1, len(q), 4, 4)).copy()
        behind = np.broadcast_to(chain.end, (n + 1, len(q), 4, 4)).copy()
        for i in range(n):
            before[i + 1] = before[i] @ motions[i]
        for i in range(n - 2, -1, -1):
            behind[i] = motions[i + 1] @ behind[i + 1]
        return cls(before, behind)


def about(p, z, letter, q):
    """Motions (m, 4, 4) by q (m,) about the line (p, z), or along it when it slides.

    Examples
    --------
    >>> half_turn = about(np.array([1.0, 0, 0]), np.array([0.0, 0, 1]), "R", np.array([np.pi]))
    >>> half_turn[0, :3, 3].round(9) + 0
    array([2., 0., 0.])
    """
    T = np.broadcast_to(np.eye(4), (len(q), 4, 4)).copy()
    if letter == "P":
        T[:, :3, 3] = q[:, None] * z
        return T
    K = skew(z)
    s, c = np.sin(q)[:, None, None], np.cos(q)[:, None, None]
    R = np.eye(3) + s * K + (1 - c) * (K @ K)
    T[:, :3, :3] = R
    T[:, :3, 3] = p - R @ p
    return T
