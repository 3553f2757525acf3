"""What both measurements take: configurations and the poses or points that were measured there."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..transform import pose_fault

__all__ = ["measured", "noise_of"]


def measured(
    q: ArrayLike, poses: ArrayLike, n: int | None, where: str
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """``q`` (m, n) and ``poses`` (m, 4, 4) or (m, 3) as float arrays, or a sentence; ``n`` None: as
    many joints as q has.
    """
    q, poses = _array(q), _array(poses)
    if q.ndim != 2 or (n is not None and q.shape[1] != n) or not len(q):
        raise ValueError(
            f"{where}: q: expected one row of {n or 'n'} joint values per measurement, found shape"
            f" {q.shape}; give an array (m, {n or 'n'}) in radians, metres for a prismatic joint"
        )
    if poses.shape not in ((len(q), 3), (len(q), 4, 4)):
        raise ValueError(
            f"{where}: poses: expected ({len(q)}, 3) positions or ({len(q)}, 4, 4) poses, one per"
            f" row of q, found shape {poses.shape}"
        )
    for name, array in (("q", q), ("poses", poses)):
        bad = np.argwhere(~np.isfinite(array))
        if len(bad):
            raise ValueError(
                f"{where}: {name}: expected finite numbers, found NaN or infinity in row"
                f" {bad[0][0] + 1}; take the row out"
            )
    if poses.ndim == 3:
        for k, T in enumerate(poses, 1):
            fault = pose_fault(T, 1e-3)
            if fault:
                raise ValueError(
                    f"{where}: poses: row {k}: expected a 4×4 pose, but {fault}; look at how it was"
                    " computed"
                )
    return q, poses


def _array(given: ArrayLike) -> NDArray[np.float64]:
    try:
        array = np.asarray(given)
    except ValueError:  # ragged
        array = np.array(None)
    return array.astype(float) if array.dtype.kind in "iuf" else np.array(np.nan)


def noise_of(noise: ArrayLike | None, where: str) -> tuple[float, float | None] | None:
    """(position in m, rotation in rad or None) from what was given as ``noise``; None stays
    None.
    """
    if noise is None:
        return None
    values = np.atleast_1d(_array(noise))
    if values.shape not in ((1,), (2,)) or not (np.isfinite(values).all() and (values > 0).all()):
        raise ValueError(
            f"{where}: noise: expected a standard deviation in m, or (m, rad), above 0, found"
            f" {noise!r}; leave it out to have it estimated"
        )
    return (values[0], values[1] if len(values) == 2 else None)
