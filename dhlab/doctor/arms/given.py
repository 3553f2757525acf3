"""What was handed in to :func:`dhlab.diagnose`, checked and made measurements."""

import numpy as np

from ...arm import Arm
from ...geometry.conversion import require_uncoupled
from ...printing import number
from ...transform import pose_fault
from .search.measured import Measured

__all__ = ["EXACT", "measured"]

EXACT = (1e-6, 1e-6)  # what counts as no noise (m, rad): a micrometre, and digits lost in printing
COARSEST = 0.2  # of the arm's reach, and radians: nobody measures worse


def measured(arm, q, poses, noise, base, tool):
    """The Measured in the arguments of ``diagnose``.

    Raises
    ------
    ValueError
        One sentence: expected, found, what to do.
    """
    if not isinstance(arm, Arm):
        raise ValueError(f"diagnose: expected an Arm or a DHTable, found {type(arm).__name__}")
    require_uncoupled(arm, "diagnose")
    for name, value in (("base", base), ("tool", tool)):
        if value not in ("fixed", "free"):
            raise ValueError(f'diagnose: {name}: expected "fixed" or "free", found {value!r}')
    q = np.atleast_2d(arm._checked(q))
    poses = np.asarray(poses)
    if q.ndim != 2 or len(q) == 0 or poses.shape not in ((len(q), 4, 4), (len(q), 3)):
        raise ValueError(
            f"diagnose: expected q (m, {len(arm)}) and as many poses (m, 4, 4) or positions (m, 3),"
            f" found {q.shape} and {poses.shape}"
        )
    if poses.dtype.kind not in "iuf" or not np.isfinite(poses).all():
        raise ValueError(
            "diagnose: poses: expected finite numbers, found something else; take the row out that"
            " could not be measured"
        )
    full = poses.ndim == 3
    if full and (fault := pose_fault(poses, 0.02)):
        raise ValueError(
            f"diagnose: poses: expected poses, but one is none: {fault}; give positions (m, 3) if"
            " the rotations are not known"
        )
    level = EXACT if noise is None else _noise(noise, arm, poses, full)
    R = _orthonormal(poses[:, :3, :3]) if full else None
    return Measured(
        q,
        poses[:, :3, 3] if full else poses.astype(float),
        R,
        level,
        base == "free",
        tool == "free",
    )


def _orthonormal(R):
    U, _, Vt = np.linalg.svd(R.astype(float))
    return U @ Vt


def _noise(noise, arm, poses, full):
    values = np.atleast_1d(np.asarray(noise, dtype=float))
    if values.shape not in ((1,), (2,)) or not (np.isfinite(values).all() and (values >= 0).all()):
        raise ValueError(f"diagnose: noise: expected (m, rad), two numbers from 0, found {noise!r}")
    if full and values.size == 1:
        raise ValueError(
            "diagnose: noise: expected two numbers, since the poses have rotations, found"
            f" {noise!r}; add the angle's, such as 1mm,0.2deg or (0.001, 0.0035)"
        )
    seen = np.ptp(poses[:, :3, 3] if full else poses, axis=0).max()
    reach = float(
        max(np.abs(arm.table.rows[:, 1:3]).sum() + np.linalg.norm(arm.tool[:3, 3]), seen, 0.1)
    )  # either may be in another unit
    if values[0] > COARSEST * reach or (full and values[1] > COARSEST):
        raise ValueError(
            "diagnose: noise: expected metres and radians, much smaller than the arm"
            f" ({number(reach, 3)} m), found {noise!r}; 4 mm are 0.004"
        )
    return max(values[0], EXACT[0] / 10), max(values[-1], EXACT[1] / 10)
