"""What was handed in to :func:`dhlab.diagnose`, checked and made measurements."""

from dataclasses import replace

import numpy as np

from ...arm import Arm
from ...geometry.parallels import cancelling
from ...printing import number
from ...transform import pose_fault
from .digits import written_noise
from .search.measured import Measured

__all__ = ["EXACT", "distinct", "measured", "oddities", "one_in", "thinned"]

EXACT = 1e-6  # what counts as no noise, of the arm's reach and in radians: digits lost in printing
GUESSED = (1e-3, 2e-3)  # what the search reckons with where no noise is stated (of the reach, rad)
COARSEST = 0.2  # of the arm's reach, and radians: nobody measures worse
TURNS = 2 * 2 * np.pi  # a joint value beyond two full turns was hardly meant in radians
MOST_POSES = 500  # of a longer log
TIMES = 20  # a table so many times larger or smaller than what was measured has another unit


def measured(arm, q, poses, noise, base, tool):
    """The Measured in the arguments of ``diagnose``.

    Raises
    ------
    ValueError
        One sentence: expected, found, what to do.
    """
    if not isinstance(arm, Arm):
        raise ValueError(f"diagnose: expected an Arm or a DHTable, found {type(arm).__name__}")
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
    p = poses[:, :3, 3] if full else poses.astype(float)
    reach = _reach(arm, p)
    floor = np.maximum(written_noise(p, poses[:, :3, :3] if full else None), _exact(reach))
    level = GUESSED * np.array([reach, 1])
    if noise is not None:
        level = np.array(_noise(noise, arm, p, full))
    return Measured(
        q,
        p,
        _orthonormal(poses[:, :3, :3]) if full else None,
        tuple(np.maximum(level, floor)),
        base == "free",
        tool == "free",
        stated=noise is not None,
        floor=tuple(floor),
        reach=reach,
    )


def one_in(count):
    """Of so many poses, one in how many is used."""
    return max(-(-count // MOST_POSES), 1)


def thinned(data):
    """(the Measured with at most five hundred of the poses, evenly from all of them; a note that
    says so): a log of a hundred thousand tells no more, and takes a hundred times as long.

    Examples
    --------
    >>> rows = np.zeros((5000, 3))
    >>> few, (note,) = thinned(Measured(rows, rows, None, (1e-3, 1e-3)))
    >>> len(few.q), note
    (500, 'Of 5000 poses one in 10 was used, 500 in all.')
    """
    step = one_in(len(data.q))
    if step == 1:
        return data, ()
    R = None if data.R is None else data.R[::step]
    few = replace(data, q=data.q[::step], p=data.p[::step], R=R)
    return few, (f"Of {len(data.q)} poses one in {step} was used, {len(few.q)} in all.",)


def _exact(reach):
    return np.array([EXACT * reach, EXACT])


def _size(arm):
    """About how far the arm reaches by its table, m; huge d that cancel count for what is left."""
    rows, left = arm.table.rows, 0.0
    for run in cancelling(arm):
        rows[[i - 1 for i in run.joints], 1] = 0.0
        left += abs(run.total)
    return float(np.abs(rows[:, 1:3]).sum() + left + np.linalg.norm(arm.tool[:3, 3]))


def _reach(arm, p):
    """About how far the arm reaches, m: as far as its end was seen to move, or as far from the base
    as it was, if the table reaches so far; a table may be in another unit.
    """
    seen = max(float(np.ptp(p, axis=0).max()), min(_size(arm), float(np.abs(p).max())))
    return seen or _size(arm) or 1.0


def distinct(q):
    """How many configurations differ."""
    return len(np.unique(np.round(q, 6), axis=0))


def oddities(arm, data):
    """Sentences on what can hardly be meant; read before anything else is."""
    lines, kinds = len(data.q), distinct(data.q)
    if kinds < lines:
        what = "one and the same configuration" if kinds == 1 else f"only {kinds} configurations"
        yield f"The {lines} lines hold {what}; a line that repeats another proves nothing new."
    turned = np.abs(data.q[:, ~arm.table.prismatic]).max(initial=0)
    if turned > TURNS:
        yield (
            f"A joint stands at {number(turned, 1)} radians, which is"
            f" {number(turned / (2 * np.pi), 1)} turns: are these degrees?"
        )
    size, seen = _size(arm), float(np.abs(data.p).max())
    if size > TIMES * max(seen, 1e-9) or size < seen / TIMES:
        yield (
            f"The table's lengths add up to {number(size, 3)} m, the measured points lie within"
            f" {number(seen, 3)} m: expected metres in both, is one of them in another unit?"
        )


def _orthonormal(R):
    U, _, Vt = np.linalg.svd(R.astype(float))
    return U @ Vt


def _noise(noise, arm, p, full):
    values = np.atleast_1d(np.asarray(noise, dtype=float))
    if values.shape not in ((1,), (2,)) or not (np.isfinite(values).all() and (values >= 0).all()):
        raise ValueError(f"diagnose: noise: expected (m, rad), two numbers from 0, found {noise!r}")
    if full and values.size == 1:
        raise ValueError(
            "diagnose: noise: expected two numbers, since the poses have rotations, found"
            f" {noise!r}; add the angle's, such as 1mm,0.2deg or (0.001, 0.0035)"
        )
    reach = max(_size(arm), float(np.ptp(p, axis=0).max()), 0.1)  # either may be in another unit
    if values[0] > COARSEST * reach or (full and values[1] > COARSEST):
        raise ValueError(
            "diagnose: noise: expected metres and radians, much smaller than the arm"
            f" ({number(reach, 3)} m), found {noise!r}; 4 mm are 0.004"
        )
    return values[0], values[-1]
