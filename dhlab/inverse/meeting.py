"""Where lines meet."""

import numpy as np
from numpy.typing import NDArray

__all__ = ["meeting_point"]

MEET = 1e-9  # m, as the doctor's exact comparison has it


def meeting_point(p: NDArray[np.float64], z: NDArray[np.float64]) -> NDArray[np.float64] | None:
    """The point where the lines (p, z) (k, 3) meet, or None when they do not all meet in one.

    The point whose squared distances to all lines add up to the least, accepted when none passes it
    by more than a nanometre.

    Examples
    --------
    >>> meeting_point(np.array([[0.0, 0, 5], [2, 0, 0]]), np.array([[0.0, 0, 1], [1, 0, 0]]))
    array([0., 0., 0.])
    >>> meeting_point(np.zeros((2, 3)) + [[0], [1]], np.array([[0.0, 0, 1], [1, 0, 0]])) is None
    True
    """
    across = np.eye(3) - z[:, :, None] * z[:, None, :]
    point = np.linalg.lstsq(
        across.sum(axis=0), (across @ p[..., None]).sum(axis=0)[:, 0], rcond=None
    )[0]
    gaps = np.linalg.norm((across @ (point - p)[..., None])[..., 0], axis=1)
    return point + 0.0 if gaps.max() <= MEET else None
