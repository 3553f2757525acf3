"""How coarsely the measurements were written: the steps of their digits, and the least noise that
this makes.
"""

import warnings

import numpy as np
from scipy.spatial.transform import Rotation

__all__ = ["written_noise"]

UNIFORM = 1 / np.sqrt(12)  # standard deviation of what is lost when a step is rounded
LENGTHS = [10.0**-k for k in range(3, 8)]  # m: a pose of whole centimetres may well be exact
DEGREES = np.deg2rad([1, 0.1, 0.01, 1e-3, 1e-4])
RADIANS = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6]


def written_noise(p, R):
    """The least standard deviation (m, rad) that the digits of the measurements leave.

    Joint values do not count: whole degrees may well have been commanded.

    Parameters
    ----------
    p : array (m, 3)
        Positions, m.
    R : array (m, 3, 3) or None
        Rotations, as they were given.

    Returns
    -------
    (float, float)
        0 where every digit was kept.

    Examples
    --------
    >>> f"{1e3 * written_noise(np.array([[0.412, -0.07, 0.333]]), None)[0]:.2f} mm"
    '0.29 mm'
    """
    return _step(p, LENGTHS) * UNIFORM, 0.0 if R is None else _turns(R) * UNIFORM


def _step(values, steps):
    """The coarsest step of which all values are multiples; 0 when there is none."""
    size = np.abs(values).max(initial=0)
    for step in steps:
        apart = np.abs(values - step * np.round(values / step)).max(initial=0)
        if apart < max(1e-4 * step, 1e-13 * size) and apart < 1e-9 + 1e-12 * size:
            return step if size else 0.0
    return 0.0


def _turns(R):
    """The coarsest step of rotations, whichever way they were written; right angles are exact."""
    rotations = Rotation.from_matrix(R)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # of roll and yaw that are one turn
        angles = rotations.as_euler("xyz")
    written = [
        (angles, DEGREES),
        (angles, RADIANS),
        (rotations.as_rotvec(), DEGREES),
        (rotations.as_rotvec(), RADIANS),
        (R, RADIANS),
    ]
    special = np.abs(R - np.round(R)).max() < 1e-9
    if special:
        return 0.0
    return max(*(_step(*pair) for pair in written), 2 * _step_of_quaternions(rotations.as_quat()))


def _step_of_quaternions(quaternions):
    """The coarsest step of the quaternions' digits before their lengths were made one."""
    row = np.arange(len(quaternions))
    largest = quaternions[row, np.abs(quaternions).argmax(axis=1)]
    for step in RADIANS:
        near = np.round(largest / step)[:, None] + [-1, 0, 1]
        back = quaternions[:, None] * (near * step / largest[:, None])[..., None] / step
        if np.abs(back - np.round(back)).max(axis=2).min(axis=1).max() < 1e-4:
            return step
    return 0.0
