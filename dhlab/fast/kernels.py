"""The walk as numba compiles it: ``answer`` for many poses, ``answer_one`` for one. Only
``compiled.py`` imports this file, when numba is wanted.

It is the walk of ``walk.py`` and the tricks of ``many.py``, with three differences that a compiler
makes worth while:

* *A block of poses stays in the first-level cache* (``BLOCK``), and every loop over it is so small
  that the compiler turns it into vector instructions.
* *Cosine and sine are two short polynomials* (``cos_sin``), since a call of the library's for one
  angle at a time costs more than all the rest; they too run eight angles at once.
* *The result is written where it belongs, pose by pose*: no transposed copy.

One function answers all three questions (``kind``), so that there is one to compile. The chain
comes as one row of numbers, since every argument costs a tenth of a microsecond; ``compiled.packed``
says what stands where.
"""

import math

import numpy as np
from numba import boolean, float64, njit, types

__all__ = ["BLOCK", "FORWARD", "FRAMES", "JACOBIAN", "answer", "answer_one"]

BLOCK = 128  # poses; half of it where every frame is kept
FORWARD, FRAMES, JACOBIAN = range(3)
STANDARD, COUPLED, KIND, BASE, END, JOINTS = 0, 1, 2, 3, 15, 27  # places in a packed chain
THETA, D, SLIDES, A, C, S = range(6)  # of joint i, and of step i
X, Y, Z, P = 0, 3, 6, 9  # rows of a block of frames: three for each axis and for the origin
ANGLE, COS, SIN, ALONG, ACROSS, MOVED, ROWS = 12, 13, 14, 15, 16, 17, 18

# products and sums may be fused into one instruction; nothing else is left to the compiler
LOOSE = {"cache": True, "nogil": True, "fastmath": {"contract"}, "error_model": "numpy"}
fast = njit(**LOOSE)

# for other types numba would compile again, for seconds, at somebody's call
ANY_ROW, ROW = types.Array(float64, 1, "A", readonly=True), float64[::1]
ROWS_READ = types.Array(float64, 2, "C", readonly=True)
ONE_TYPES = [boolean(ANY_ROW, ROW, float64[:, ::1]), boolean(ANY_ROW, ROW, float64[:, :, ::1])]
MANY_TYPES = [boolean(ROWS_READ, ROW, float64[:, ::1])]

# pi / 2 in three parts of 33 bits: k times the first two is exact for k below a million
TO_QUARTERS = 2 / math.pi
QUARTER = (1.57079632673412561417e00, 6.07710050630396597660e-11, 2.02226624879595063154e-21)
FAR = 1e6  # radians


@fast
def cos_sin(angle):
    """Cosine and sine: what is left of the angle beside quarter turns, less than 45°, goes into the
    polynomials of fdlibm (k_cos.c, k_sin.c), which are exact to the last bit; the number of quarter
    turns says which of the two is which, and with which sign.
    """
    k = np.floor(angle * TO_QUARTERS + 0.5)
    r = ((angle - k * QUARTER[0]) - k * QUARTER[1]) - k * QUARTER[2]
    z = r * r
    high = 2.75573137070700676789e-06 + z * (
        -2.50507602534068634195e-08 + z * 1.58969099521155010221e-10
    )
    low = 8.33333333332248946124e-03 + z * (-1.98412698298579493134e-04 + z * high)
    sine = r + r * z * (-1.66666666666666324348e-01 + z * low)
    high = -2.75573143513906633035e-07 + z * (
        2.08757232129817482790e-09 + z * -1.13596475577881948265e-11
    )
    low = -1.38888888888741095749e-03 + z * (2.48015872894767294178e-05 + z * high)
    cosine = 1.0 - 0.5 * z + z * z * (4.16666666666666019037e-02 + z * low)
    half = np.floor(0.5 * k)
    odd = k != 2.0 * half
    sign = 1.0 - 2.0 * (half - 2.0 * np.floor(0.5 * half))
    return sign * (-sine if odd else cosine), sign * (cosine if odd else sine)


@fast
def within(row, most, m):
    """Whether all numbers are smaller than ``most``; not where one is NaN. (Counted in whole
    numbers, since the compiler may not reorder a search for the largest float.)
    """
    beyond = 0
    for j in range(m):
        beyond |= not abs(row[j]) < most
    return beyond == 0


@fast
def phases(angle, c, s, m):
    """The same for every size of angle: the library's functions where the parts of pi / 2 run
    out of digits.
    """
    if within(angle, FAR, m):
        for j in range(m):
            c[j], s[j] = cos_sin(angle[j])
    else:
        for j in range(m):
            c[j], s[j] = math.cos(angle[j]), math.sin(angle[j])


@fast
def fill(row, number, m):
    for j in range(m):
        row[j] = number


@fast
def keep(F, first, last, kept, m):
    """Rows of the frames for later. (A loop: what numba makes of ``kept[:, :m] = F[...]`` takes
    seconds to compile.)
    """
    for r in range(first, last):
        for j in range(m):
            kept[r - first, j] = F[r, j]


@fast
def turn(F, m):
    c, s = F[COS], F[SIN]
    for k in range(len(F) // 6):
        x, y = F[X + k], F[Y + k]
        for j in range(m):
            i, h = x[j], y[j]
            x[j] = i * c[j] + h * s[j]
            y[j] = h * c[j] - i * s[j]


@fast
def lean(F, c, s, m):
    """About x by alpha; the frame's y and z only change places where that is a right angle."""
    for k in range(len(F) // 6):
        y, z = F[Y + k], F[Z + k]
        if c == 0.0:
            for j in range(m):
                i = y[j]
                y[j] = s * z[j]
                z[j] = -s * i
        else:
            for j in range(m):
                i, h = y[j], z[j]
                y[j] = i * c + h * s
                z[j] = h * c - i * s


@fast
def add(F, p, x, length, m):
    """``length`` along the axis of rows x, to the rows p."""
    for k in range(len(F) // 6):
        to, of = F[p + k], F[x + k]
        for j in range(m):
            to[j] += of[j] * length


@fast
def add_row(F, p, x, lengths, m):
    """The same for a length per pose."""
    for k in range(len(F) // 6):
        to, of = F[p + k], F[x + k]
        for j in range(m):
            to[j] += of[j] * lengths[j]


@fast
def enter(q, numbers, i, F, m):
    """Joint i (from 1): along z by its d; its angle joins the run."""
    n, of = q.shape[1], JOINTS + 6 * i
    rates = JOINTS + 6 * (n + 1) + n * (i - 1)
    moved, angle = F[MOVED], F[ANGLE]
    fill(moved, 0.0, m)
    for k in range(n):
        rate = numbers[rates + k]
        if rate != 0.0:
            for j in range(m):
                moved[j] += rate * q[j, k]
    theta, d = numbers[of + THETA], numbers[of + D]
    if numbers[of + SLIDES] != 0.0:
        for j in range(m):
            moved[j] += d
            angle[j] += theta
        add_row(F, P, Z, moved, m)
        return
    for j in range(m):
        angle[j] += moved[j] + theta
    if d != 0.0:
        add(F, P, Z, d, m)


@fast
def lay(F, a, m):
    """By a in the direction that the run has by now."""
    for j in range(m):
        F[ALONG, j] += a * F[COS, j]
        F[ACROSS, j] += a * F[SIN, j]


@fast
def settle(F, m):
    """What was laid out in the plane of x and y becomes part of p."""
    for across in range(2):
        add_row(F, P, X + 3 * across, F[ALONG + across], m)
        fill(F[ALONG + across], 0.0, m)


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
def go_to_end(F, numbers, m):
    """p becomes the end point."""
    for axis in range(3):
        add(F, P, X + 3 * axis, numbers[END + 4 * axis + 3], m)


@fast
def no_turn(end):
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
def moments(F, numbers, axes, m):
    """Of every axis: rows 0 to 2 are z, rows 3 to 5 a point, which becomes the lever from there to
    the end; rows 6 to 8 become z × lever, or z where the joint slides, whose z becomes 0.
    """
    n = len(axes)
    for i in range(n):
        axis, slides = axes[i], numbers[JOINTS + 6 * (i + 1) + SLIDES] != 0.0
        rate = 1.0 if numbers[COUPLED] != 0.0 else numbers[JOINTS + 6 * (n + 1) + n * i + i]
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
def per_count(out, rates, n, m):
    """The chain rule for coupled joints: from per joint variable to per unit of q."""
    row = np.empty(n)
    for j in range(m):
        for r in range(6):
            for k in range(n):
                row[k] = 0.0
                for i in range(n):
                    row[k] += out[j, r * n + i] * rates[n * i + k]
            for k in range(n):
                out[j, r * n + k] = row[k]


@fast
def carry(q, numbers, F, kept, m):
    """Carry a block of frames along the chain: ``along_the_joints`` and ``frame_by_frame`` of
    ``walk.py`` in one. ``kept`` takes the frames, or axes and points of the joints.
    """
    n, kind, laid = q.shape[1], numbers[KIND], False
    standard = numbers[STANDARD] != 0.0
    for r in range(ROWS):
        fill(F[r], numbers[BASE + r] if r < ANGLE else 0.0, m)
    for i in range(n + 1):
        of = JOINTS + 6 * i
        a, c, s = numbers[of + A], numbers[of + C], numbers[of + S]
        level = c == 1.0 and s == 0.0
        if i > 0:
            enter(q, numbers, i, F, m)
            runs_on = kind != FRAMES and level and i < n
            if laid and (kind == JACOBIAN or not runs_on):
                settle(F, m)
                laid = False
            if kind == JACOBIAN:
                keep(F, Z, ANGLE, kept[i - 1], m)
            phases(F[ANGLE], F[COS], F[SIN], m)
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
        if not level:
            lean(F, c, s, m)
        if kind == FRAMES and i > 0 and standard:
            keep(F, X, ANGLE, kept[i], m)


@njit(MANY_TYPES, **LOOSE)
def answer(q, numbers, out):
    """The end poses, frames or Jacobians of ``q`` (m, n) into ``out`` (m, ...), a row of numbers
    each; False where a number of q is NaN or infinite.
    """
    n, kind = q.shape[1], numbers[KIND]
    size = BLOCK // 2 if kind == FRAMES else BLOCK
    F = np.empty((ROWS, size))
    kept = np.empty((n + 1, 12, size) if kind == FRAMES else (n, 9, size))
    upright = no_turn(numbers[END:])
    for start in range(0, len(q), size):
        m = min(size, len(q) - start)
        part, result = q[start : start + m], out[start : start + m]
        if not within(part.reshape(-1), np.inf, m * n):
            return False
        carry(part, numbers, F, kept, m)
        if kind == FRAMES:
            write_frames(kept, result, m)
            continue
        go_to_end(F, numbers, m)
        if kind == FORWARD and upright:
            write_frames(F.reshape(1, ROWS, size), result, m)
            continue
        if kind == FORWARD:
            write_behind(F, numbers[END:], result, m)
            continue
        moments(F, numbers, kept, m)
        write_columns(kept, result, m)
        if numbers[COUPLED] != 0.0:
            per_count(result, numbers[JOINTS + 6 * (n + 1) :], n, m)
    return True


@fast
def summed(p, x, length):
    return (p[0] + length * x[0], p[1] + length * x[1], p[2] + length * x[2])


@fast
def rotated(x, y, c, s):
    """x and y turned about z, or y and z about x."""
    return (
        (x[0] * c + y[0] * s, x[1] * c + y[1] * s, x[2] * c + y[2] * s),
        (y[0] * c - x[0] * s, y[1] * c - x[1] * s, y[2] * c - x[2] * s),
    )


@fast
def write_one(x, y, z, p, out, at):
    for k in range(3):
        out[at + 4 * k] = x[k] + 0.0
        out[at + 4 * k + 1] = y[k] + 0.0
        out[at + 4 * k + 2] = z[k] + 0.0
        out[at + 4 * k + 3] = p[k] + 0.0
        out[at + 12 + k] = 0.0
    out[at + 15] = 1.0


@fast
def behind(x, y, z, p, numbers, column):
    """p and a column of the end's pose, seen from the frame."""
    at = END + column
    p = summed(p, x, numbers[at])
    return summed(summed(p, y, numbers[at + 4]), z, numbers[at + 8])


@njit(ONE_TYPES, **LOOSE)
def answer_one(q, numbers, result):
    """The same for one pose, its frame in registers; False where ``q`` is not n finite numbers."""
    n, kind, out = len(q), numbers[KIND], result.reshape(-1)
    rates = JOINTS + 6 * (n + 1)
    if len(numbers) != rates + n * n:
        return False
    standard, coupled = numbers[STANDARD] != 0.0, numbers[COUPLED] != 0.0
    x = (numbers[BASE], numbers[BASE + 1], numbers[BASE + 2])
    y = (numbers[BASE + 3], numbers[BASE + 4], numbers[BASE + 5])
    z = (numbers[BASE + 6], numbers[BASE + 7], numbers[BASE + 8])
    p = (numbers[BASE + 9], numbers[BASE + 10], numbers[BASE + 11])
    angle = along = across = 0.0
    for i in range(n + 1):
        of = JOINTS + 6 * i
        a, step_c, step_s = numbers[of + A], numbers[of + C], numbers[of + S]
        if i > 0:
            moved = numbers[rates + (n + 1) * (i - 1)] * q[i - 1]
            if coupled:
                moved = 0.0
                for k in range(n):
                    moved += numbers[rates + n * (i - 1) + k] * q[k]
            if moved - moved != 0.0:  # NaN
                return False
            slides = numbers[of + SLIDES] != 0.0
            angle += numbers[of + THETA] + (0.0 if slides else moved)
            p = summed(p, z, numbers[of + D] + (moved if slides else 0.0))
            runs_on = kind != FRAMES and i < n and step_c == 1.0 and step_s == 0.0
            if kind == JACOBIAN or not runs_on:
                p = summed(summed(p, x, along), y, across)
                along = across = 0.0
            if kind == JACOBIAN:
                for k in range(3):
                    out[n * k + i - 1], out[n * (3 + k) + i - 1] = p[k], z[k]
            if not runs_on or a != 0.0:
                c, s = cos_sin(angle) if abs(angle) < FAR else (math.cos(angle), math.sin(angle))
            if runs_on:
                if a != 0.0:
                    along += a * c
                    across += a * s
                continue
            x, y = rotated(x, y, c, s)
            angle = 0.0
        if kind == FRAMES and (i == 0 or not standard):
            write_one(x, y, z, p, out, 16 * i)
        if kind != FRAMES and i == n:
            break
        p = summed(p, x, a)
        y, z = rotated(y, z, step_c, step_s)
        if kind == FRAMES and i > 0 and standard:
            write_one(x, y, z, p, out, 16 * i)
    if kind == FRAMES:
        return True
    p = behind(x, y, z, p, numbers, 3)
    if kind == FORWARD:
        origin = (0.0, 0.0, 0.0)
        u, v, w = (
            behind(x, y, z, origin, numbers, 0),
            behind(x, y, z, origin, numbers, 1),
            behind(x, y, z, origin, numbers, 2),
        )
        write_one(u, v, w, p, out, 0)
        return True
    for i in range(n):
        rate = 1.0 if coupled else numbers[rates + (n + 1) * i]
        lx, ly, lz = p[0] - out[i], p[1] - out[n + i], p[2] - out[2 * n + i]
        x0, x1, x2 = rate * out[3 * n + i], rate * out[4 * n + i], rate * out[5 * n + i]
        if numbers[JOINTS + 6 * (i + 1) + SLIDES] != 0.0:
            out[i], out[n + i], out[2 * n + i] = x0 + 0.0, x1 + 0.0, x2 + 0.0
            out[3 * n + i] = out[4 * n + i] = out[5 * n + i] = 0.0
        else:
            out[i], out[n + i] = x1 * lz - x2 * ly + 0.0, x2 * lx - x0 * lz + 0.0
            out[2 * n + i] = x0 * ly - x1 * lx + 0.0
            out[3 * n + i], out[4 * n + i], out[5 * n + i] = x0 + 0.0, x1 + 0.0, x2 + 0.0
    if coupled:
        per_count(out.reshape(1, -1), numbers[rates:], n, 1)
    return True
