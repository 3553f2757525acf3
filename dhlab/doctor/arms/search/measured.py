"""What was measured, and how far a model may be from it."""

from dataclasses import dataclass

import numpy as np
from scipy.special import chdtri

from ....rotations import rotation_vectors

__all__ = ["Measured", "limit"]

FALSE_ALARM = 1e-7  # how often right data may look wrong


@dataclass(frozen=True)
class Measured:
    """What was measured: ``q`` (m, n), positions ``p`` (m, 3) in m, rotations ``R`` (m, 3, 3) or
    None, the noise per axis (m, rad), what is free.

    ``stated`` is False where nobody said how large the noise is: then ``noise`` is only what the
    search reckons with, and ``floor`` the least that it can be, as the digits of the numbers tell.
    ``reach`` is about how far the arm reaches, m.
    """

    q: np.ndarray
    p: np.ndarray
    R: np.ndarray | None
    noise: tuple
    base_free: bool = False
    tool_free: bool = False
    stated: bool = True
    floor: tuple = (1e-7, 1e-7)
    reach: float = 1.0

    @property
    def count(self):
        """How many numbers were measured."""
        return self.p.size * (1 if self.R is None else 2)

    def squares(self, T):
        """The sums of squares that poses (..., m, 4, 4) leave: of positions in m², of rotations in
        rad².
        """
        p = ((T[..., :3, 3] - self.p) ** 2).sum(axis=(-2, -1))
        if self.R is None:
            return p, 0.0 * p
        turn = rotation_vectors(np.swapaxes(T[..., :3, :3], -1, -2) @ self.R)
        return p, (turn**2).sum(axis=(-2, -1))

    def residual(self, T):
        """(m, 3 or 6): predicted minus measured, in units of the noise."""
        position = (T[..., :3, 3] - self.p) / self.noise[0]
        if self.R is None:
            return position
        turn = rotation_vectors(np.swapaxes(T[..., :3, :3], -1, -2) @ self.R) / self.noise[1]
        return np.concatenate([position, turn], axis=-1)

    def left_by(self, residuals):
        """The same sums as :meth:`squares`, from what :meth:`residual` gives, (3m,) or (6m,)."""
        each = (
            residuals.reshape(len(self.q), -1, 3)
            * np.array(self.noise)[: residuals.size // self.p.size, None]
        )
        left = (each**2).sum(axis=(0, 2))
        return (left[0], left[1] if self.R is not None else 0.0)


def limit(freedom):
    """The χ² that noise alone passes once in ten million draws."""
    return chdtri(max(freedom, 1), FALSE_ALARM)
