"""The product itself: link matrices, frames, end pose and Jacobian, for one configuration or a
batch of any leading shape.

These functions take plain arrays that have been checked before (by ``Arm``); the leading shape of
``theta`` and ``d`` is the batch.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["link_matrices", "frames", "jacobian", "manipulability"]


def link_matrices(
    convention: str, theta: ArrayLike, d: ArrayLike, a: ArrayLike, alpha: ArrayLike
) -> NDArray[np.float64]:
    """Every ``A_i`` of a table whose joint variables have been filled in.

    Parameters
    ----------
    convention : "standard" or "craig"
    theta, d : arrays (..., n)
        Radians and metres, joint variables included.
    a, alpha : arrays (n,)

    Returns
    -------
    array (..., n, 4, 4)
        Standard: ``Rz(theta) Tz(d) Tx(a) Rx(alpha)`` (Siciliano et al., Robotics, eq. 2.52);
        Craig: ``Rx(alpha) Tx(a) Rz(theta) Tz(d)`` (Craig, Introduction to Robotics, eq. 3.6).

    Examples
    --------
    >>> link_matrices("standard", [0.0], [0.1], [0.4], [0.0])[0, :3, 3]
    array([0.4, 0. , 0.1])
    """
    theta, d = np.asarray(theta, dtype=float), np.asarray(d, dtype=float)
    if theta.shape != d.shape:  # for a handful of poses the question costs as much as their product
        theta, d = np.broadcast_arrays(theta, d)
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha), np.sin(alpha)
    A = np.zeros((*theta.shape, 4, 4))
    A[..., 3, 3] = 1.0
    if convention == "standard":
        A[..., 0, 0], A[..., 0, 1], A[..., 0, 2], A[..., 0, 3] = ct, -st * ca, st * sa, a * ct
        A[..., 1, 0], A[..., 1, 1], A[..., 1, 2], A[..., 1, 3] = st, ct * ca, -ct * sa, a * st
        A[..., 2, 1], A[..., 2, 2], A[..., 2, 3] = sa, ca, d
    else:
        A[..., 0, 0], A[..., 0, 1], A[..., 0, 3] = ct, -st, a
        A[..., 1, 0], A[..., 1, 1], A[..., 1, 2], A[..., 1, 3] = st * ca, ct * ca, -sa, -d * sa
        A[..., 2, 0], A[..., 2, 1], A[..., 2, 2], A[..., 2, 3] = st * sa, ct * sa, ca, d * ca
    return A


def frames(base: ArrayLike, A: NDArray[np.float64]) -> NDArray[np.float64]:
    """Every frame of the chain, the base first.

    Parameters
    ----------
    base : array (4, 4)
    A : array (..., n, 4, 4)
        Link matrices.

    Returns
    -------
    array (..., n + 1, 4, 4)
        ``[base, base A_1, base A_1 A_2, …]``.

    Examples
    --------
    >>> frames(np.eye(4), np.broadcast_to(np.eye(4), (5, 3, 4, 4))).shape
    (5, 4, 4, 4)
    """
    n = A.shape[-3]
    chain = np.empty((*A.shape[:-3], n + 1, 4, 4))
    chain[..., 0, :, :] = base
    for i in range(n):
        np.matmul(chain[..., i, :, :], A[..., i, :, :], out=chain[..., i + 1, :, :])
    return chain


def jacobian(
    convention: str,
    chain: NDArray[np.float64],
    end: NDArray[np.float64],
    prismatic: NDArray[np.bool_],
    sign: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Geometric Jacobian at the end point, in the frame that ``chain`` is written in (Siciliano et
    al., Robotics, eq. 3.30).

    Parameters
    ----------
    convention : "standard" or "craig"
        Says where the axis of joint i lies: on z_{i-1} (standard) or on z_i (Craig).
    chain : array (..., n + 1, 4, 4)
        From :func:`frames`.
    end : array (..., 4, 4)
        The end pose, tool included.
    prismatic : array (n,) of bool
    sign : array (n,)
        How each joint counts: +1 or -1.

    Returns
    -------
    array (..., 6, n)
        Rows v (m per rad, or m per m) then ω.

    Examples
    --------
    >>> chain = frames(np.eye(4), link_matrices("standard", [0.0], [0.0], [0.5], [0.0]))
    >>> jacobian("standard", chain, chain[-1], np.array([False]), np.array([1.0]))[:, 0]
    array([0. , 0.5, 0. , 0. , 0. , 1. ])
    """
    of_joint = chain[..., :-1, :, :] if convention == "standard" else chain[..., 1:, :, :]
    z = of_joint[..., :3, 2] * sign[:, None]
    lever = end[..., None, :3, 3] - of_joint[..., :3, 3]
    slides = prismatic[:, None]
    J = np.empty((*z.shape[:-2], 6, z.shape[-2]))
    J[..., :3, :] = np.swapaxes(np.where(slides, z, np.cross(z, lever)), -1, -2)
    J[..., 3:, :] = np.swapaxes(np.where(slides, 0.0, z), -1, -2)
    return J


def manipulability(J: NDArray[np.float64]) -> NDArray[np.float64]:
    """How far an end is from a pose in which it cannot move some way (Yoshikawa, Manipulability of
    Robotic Mechanisms, Int. J. Robotics Research 4(2), 1985).

    Parameters
    ----------
    J : array (..., 6, n)
        Jacobians.

    Returns
    -------
    array (...)
        The square root of det(J Jᵀ), which is the product of the singular values of J, the volume
        that unit joint speeds span; of an arm with fewer than six joints, of its n singular values.

    Examples
    --------
    >>> J = np.zeros((6, 2))
    >>> J[:2] = [[0, -1], [2, 1]]  # a planar arm, stretched half way
    >>> manipulability(J).round(6)
    np.float64(2.0)
    """
    return np.linalg.svd(J, compute_uv=False).prod(axis=-1)
