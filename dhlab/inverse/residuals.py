"""How far a configuration is from a target pose, in metres and radians; and targets, checked."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arm import Arm
from ..rotations import rotation_vectors
from ..transform import RIGID_TOLERANCE, pose_fault

__all__ = ["missing", "require_targets", "residuals"]


def missing(arm: Arm, q: NDArray[np.float64], T: NDArray[np.float64]) -> NDArray[np.float64]:
    """What moves the end at ``q`` (m, n) to the targets ``T`` (m, 4, 4): (m, 6), metres along and
    the rotation vector about the axes of the frame that :meth:`Arm.forward` uses.

    Examples
    --------
    >>> import dhlab as dh
    >>> arm = dh.load("cobra600")
    >>> missing(arm, np.zeros((1, 4)), arm.forward([[0.3, -0.3, 0, 0.1]]))[0, 5].round(6)
    np.float64(-0.1)
    """
    here = arm.forward(q)
    turn = T[:, :3, :3] @ np.swapaxes(here[:, :3, :3], -1, -2)
    return np.concatenate([T[:, :3, 3] - here[:, :3, 3], rotation_vectors(turn)], axis=1)


def residuals(arm: Arm, q: NDArray[np.float64], T: NDArray[np.float64]) -> NDArray[np.float64]:
    """Distance (m) and angle (rad) between the end at every ``q`` (m, n) and the target ``T``
    (4, 4), or one target each (m, 4, 4): (m, 2).
    """
    q = np.asarray(q, dtype=float)
    off = missing(arm, q, np.broadcast_to(T, (len(q), 4, 4)))
    return np.stack([np.linalg.norm(off[:, :3], axis=1), np.linalg.norm(off[:, 3:], axis=1)], 1)


def require_targets(T: ArrayLike) -> tuple[NDArray[np.float64], bool]:
    """Target poses (m, 4, 4), each with the nearest exact rotation, and whether one was given
    rather than a batch; or a sentence.

    A pose typed with seven digits is no exact rotation; no arm could meet it to 1e-9.
    """
    try:
        array = np.asarray(T)
    except ValueError:  # ragged
        array = np.array(None)
    fault = (
        f"its shape is {array.shape}"
        if array.ndim not in (2, 3) or array.shape[-2:] != (4, 4)
        else pose_fault(array)
    )
    if fault:
        raise ValueError(
            f"solve: T: expected a pose (4, 4), or a batch of them (m, 4, 4), but {fault}; the"
            f" rotation has to be rigid to {RIGID_TOLERANCE:g}: build it with dhlab.transform"
        )
    targets = np.array(array.reshape(-1, 4, 4), dtype=float)
    U, _, Vh = np.linalg.svd(targets[:, :3, :3])
    targets[:, :3, :3] = U @ Vh
    targets[:, 3] = [0, 0, 0, 1]
    return targets, array.ndim == 2
