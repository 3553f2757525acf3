"""The walk for many poses, as numba compiles it. Only ``compiled.py`` imports this file, when numba
is wanted.

It is the walk of ``walk.py``, with parallel axes turned once and zeros skipped; and it has three
tricks that a compiler makes worth while:

* *A block of poses stays in the nearest caches* (``BLOCK``: 18 rows of 128 doubles are 18 kB, in
  the first level; a Jacobian's axes or all frames of six joints are 50 to 75 kB, in the second),
  and every loop over it is so small that the compiler turns it into vector instructions, four or
  eight poses at a time.
* *Cosine and sine are two short polynomials* (``kernel_parts.cos_sin``): a call of the library's
  for one angle at a time costs more than all the rest; the polynomials are vector instructions too.
* *The result is written where it belongs, pose by pose*: no transposed copy.

One function answers all three questions, so that there is one to compile. Where the loop inside is
long, loops over the three components run to ``len(F) // 6``, which is 3, but unknown to the
compiler: it would write the loop out three times, and take as much longer to compile.
"""

import numpy as np
from numba import boolean, float64, njit, types

from .kernel_block import (  # isort: skip
    ANGLE, COS, ROWS, SIN, P, X, Y, Z, add, add_joint, all_below, cos_sin_rows, fill, flush_plane,
    keep, lay, tilt, turn,
)  # fmt: skip
from .kernel_parts import (  # isort: skip
    BASE, COUPLED, END, FORWARD, FRAMES, JACOBIAN, JOINTS, KIND, LARGEST_Q, OPTIONS, ROW, SLIDES,
    STANDARD, A, C, S, chain_rule, fast,
)  # fmt: skip

__all__ = ["BLOCK", "answer_many"]

BLOCK = 128  # poses; half of it where every frame is kept

# for other types numba would compile again, for seconds, at somebody's call
ROWS_READ, ROWS_WRITTEN = types.Array(float64, 2, "C", readonly=True), float64[:, ::1]
TYPES = [boolean(ROWS_READ, ROW, ROWS_WRITTEN)]


@fast
def write_frames(frames, out, m):
    """Frames (k, 12, BLOCK), pose by pose: memory takes a long stretch faster than many pieces."""
    for j in range(m):
        for i in range(len(frames)):
            for k in range(3):
                at = 16 * i + 4 * k
                out[j, at] = frames[i, X + k, j] + 0.0  # a zero loses its sign
                out[j, at + 1] = frames[i, Y + k, j] + 0.0
                out[j, at + 2] = frames[i, Z + k, j] + 0.0
                out[j, at + 3] = frames[i, P + k, j] + 0.0
            at = 16 * i + 12
            out[j, at] = out[j, at + 1] = out[j, at + 2] = 0.0
            out[j, at + 3] = 1.0


@fast
def go_to_end(F, packed, m):
    """p becomes the end point."""
    for axis in range(3):
        add(F, P, X + 3 * axis, packed[END + 4 * axis + 3], m)


@fast
def turns_nothing(end):
    """Whether the constant pose ``end`` (12 numbers) has no rotation."""
    turned = 0.0
    for k in range(3):
        for column in range(3):
            turned += abs(end[4 * k + column] - (1.0 if column == k else 0.0))
    return turned == 0.0


@fast
def write_behind(F, end, out, m):
    """The frame turned by the rotation of ``end`` (12 numbers), pose by pose."""
    for j in range(m):
        for k in range(3):
            x, y, z = F[X + k, j], F[Y + k, j], F[Z + k, j]
            for column in range(3):
                turned = x * end[column] + y * end[4 + column] + z * end[8 + column]
                out[j, 4 * k + column] = turned + 0.0
            out[j, 4 * k + 3] = F[P + k, j] + 0.0
        out[j, 12] = out[j, 13] = out[j, 14] = 0.0
        out[j, 15] = 1.0


@fast
def moments(F, packed, axes, m):
    """The columns of the Jacobian. ``axes`` (n, 9, m) holds for each joint its axis z in rows 0 to
    2 and a point of it in rows 3 to 5. Then rows 6 to 8 become the velocity of the end, z × (end -
    point), and rows 0 to 2 stay the angular velocity z; where the joint slides, velocity z and
    angular velocity 0. Rows 3 to 5 are used up.
    """
    n = len(axes)
    for i in range(n):
        axis, slides = axes[i], packed[JOINTS + 6 * (i + 1) + SLIDES] != 0.0
        rate = 1.0 if packed[COUPLED] != 0.0 else packed[JOINTS + 6 * (n + 1) + n * i + i]
        for k in range(len(F) // 6):
            z, lever, end = axis[k], axis[3 + k], F[P + k]
            for j in range(m):
                z[j] *= rate
                lever[j] = end[j] - lever[j]
        for k in range(len(F) // 6):
            g, h = (k + 1) % 3, (k + 2) % 3
            y, z, b, c, moment = axis[g], axis[h], axis[3 + g], axis[3 + h], axis[6 + k]
            for j in range(m):
                moment[j] = axis[k, j] if slides else y[j] * c[j] - z[j] * b[j]
        if slides:
            for k in range(len(F) // 6):
                fill(axis[k], 0.0, m)


@fast
def write_columns(axes, out, m):
    """Jacobians, pose by pose: the moments of the axes over the axes."""
    n = len(axes)
    for j in range(m):
        for r in range(3):
            for i in range(n):
                out[j, r * n + i] = axes[i, 6 + r, j] + 0.0
                out[j, (3 + r) * n + i] = axes[i, r, j] + 0.0


@fast
def carry(q, packed, joined, F, kept, m):
    """Carry a block of frames F (ROWS, m) along the chain: ``along_the_joints`` and
    ``frame_by_frame`` of ``walk.py`` in one. ``kept`` takes the frames, or axes and points of the
    joints.
    """
    n, kind, laid = q.shape[1], packed[KIND], False
    standard = packed[STANDARD] != 0.0
    for r in range(ROWS):
        fill(F[r], packed[BASE + r] if r < ANGLE else 0.0, m)
    for i in range(n + 1):
        of = JOINTS + 6 * i
        a, c, s = packed[of + A], packed[of + C], packed[of + S]
        parallel = c == 1.0 and s == 0.0
        if i > 0:
            add_joint(q, packed, i, F, m)
            runs_on = joined and kind != FRAMES and parallel and i < n
            if laid and (kind == JACOBIAN or not runs_on):
                flush_plane(F, m)
                laid = False
            if kind == JACOBIAN:
                keep(F, Z, ANGLE, kept[i - 1], m)
            cos_sin_rows(F[ANGLE], F[COS], F[SIN], m)
            if runs_on:
                if a != 0.0:
                    lay(F, a, m)
                    laid = True
                continue
            turn(F, m)
            fill(F[ANGLE], 0.0, m)
        if kind == FRAMES and (i == 0 or not standard):
            keep(F, X, ANGLE, kept[i], m)
        if kind != FRAMES and i == n:
            return  # its step is in the end
        if a != 0.0:
            add(F, P, X, a, m)
        if not parallel:
            tilt(F, c, s, m)
        if kind == FRAMES and i > 0 and standard:
            keep(F, X, ANGLE, kept[i], m)


@njit(TYPES, cache=True, **OPTIONS)
def answer_many(q, packed, out):
    """The end poses, frames or Jacobians of ``q`` (m, n) into ``out`` (m, ...), a row of numbers
    each; False where a number of q is NaN or infinite, and the blocks before it are written.
    """
    n, kind = q.shape[1], packed[KIND]
    size = BLOCK // 2 if kind == FRAMES else BLOCK
    F = np.empty((ROWS, size))
    kept = np.empty((n + 1, 12, size) if kind == FRAMES else (n, 9, size))
    unturned = turns_nothing(packed[END:])
    for start in range(0, len(q), size):
        m = min(size, len(q) - start)
        part, result = q[start : start + m], out[start : start + m]
        joined = all_below(part.reshape(-1), packed[LARGEST_Q], m * n)
        if not joined and not all_below(part.reshape(-1), np.inf, m * n):
            return False
        carry(part, packed, joined, F, kept, m)
        if kind == FRAMES:
            write_frames(kept, result, m)
            continue
        go_to_end(F, packed, m)
        if kind == FORWARD and unturned:
            write_frames(F.reshape(1, ROWS, size), result, m)
            continue
        if kind == FORWARD:
            write_behind(F, packed[END:], result, m)
            continue
        moments(F, packed, kept, m)
        write_columns(kept, result, m)
        if packed[COUPLED] != 0.0:
            chain_rule(result, packed[JOINTS + 6 * (n + 1) :], n, m)
    return True
