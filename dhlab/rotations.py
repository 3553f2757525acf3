"""Rotation matrices and rotation vectors (axis times angle), in radians, for any shape of batches.

scipy does this too, and takes 20 MB to load; nearly every room needs no more of it than this.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["rotation_vectors", "from_rotation_vectors", "skew"]

SMALL = 1e-9  # twice the sine: below, sine and angle are the same number
HALF_A_TURN = -1.98  # twice the cosine of 172°


def rotation_vectors(R: NDArray[np.float64]) -> NDArray[np.float64]:
    """The rotation vectors (..., 3) of rotations (..., 3, 3).

    ``sin(angle) · axis`` stands in ``R - Rᵀ`` (Siciliano et al., Robotics, eq. 2.27); near half a
    turn, where that fades, the axis comes from ``R + Rᵀ``.

    Examples
    --------
    >>> from dhlab.transform import rot_z
    >>> rotation_vectors(rot_z(np.array([0.3, np.pi]))[:, :3, :3]).round(6)
    array([[0.      , 0.      , 0.3     ],
           [0.      , 0.      , 3.141593]])
    """
    skew = np.stack(
        [R[..., 2, 1] - R[..., 1, 2], R[..., 0, 2] - R[..., 2, 0], R[..., 1, 0] - R[..., 0, 1]],
        axis=-1,
    )
    twice_sine = np.sqrt((skew * skew).sum(-1))
    twice_cosine = R[..., 0, 0] + R[..., 1, 1] + R[..., 2, 2] - 1
    small = twice_sine < SMALL
    angle = np.arctan2(twice_sine, twice_cosine)
    vectors = skew * np.where(small, 0.5, angle / np.where(small, 1, twice_sine))[..., None]
    half = twice_cosine < HALF_A_TURN
    if half.any():
        vectors[half] = _half_turns(R[half], skew[half]) * angle[half, None]
    return vectors


def _half_turns(R, skew):
    """The axes (m, 3) of rotations by nearly half a turn: R + Rᵀ is a multiple of the identity and
    one of axis · axisᵀ, of which the column with the largest diagonal is taken.
    """
    both = R + np.swapaxes(R, -1, -2)
    both[:, range(3), range(3)] += (1 - np.trace(R, axis1=-2, axis2=-1))[:, None]
    k = np.arange(len(R)), np.argmax(np.diagonal(both, axis1=-2, axis2=-1), axis=-1)
    axes = both[k]
    axes /= np.linalg.norm(axes, axis=-1, keepdims=True)
    return axes * np.where((axes * skew).sum(-1) < 0, -1.0, 1.0)[:, None]


def from_rotation_vectors(vectors: ArrayLike) -> NDArray[np.float64]:
    """The rotations (..., 3, 3) of rotation vectors (..., 3), by Rodrigues' formula (Siciliano et
    al., Robotics, eq. 2.25).

    Examples
    --------
    >>> from_rotation_vectors([0, 0, np.pi / 2]).round(6)
    array([[ 0., -1.,  0.],
           [ 1.,  0.,  0.],
           [ 0.,  0.,  1.]])
    """
    v = np.asarray(vectors, dtype=float)
    angle = np.sqrt((v * v).sum(-1))[..., None, None]
    K = skew(v)
    # sin(x)/x and (1 - cos(x))/x², also where x is 0
    half = np.sinc(angle / (2 * np.pi))
    return np.eye(3) + np.sinc(angle / np.pi) * K + half * half / 2 * (K @ K)


def skew(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    """The matrices (..., 3, 3) that multiply as the cross product with vectors (..., 3).

    Examples
    --------
    >>> skew(np.array([1.0, 2.0, 3.0])) @ [0, 0, 1], np.cross([1, 2, 3], [0, 0, 1])
    (array([ 2., -1.,  0.]), array([ 2, -1,  0]))
    """
    K = np.zeros((*vectors.shape, 3))
    K[..., 2, 1], K[..., 0, 2], K[..., 1, 0] = np.moveaxis(vectors, -1, 0)
    return K - np.swapaxes(K, -1, -2)
