"""A block of frames, a pose a column, and the moves of the walk for all of its columns at once.
``kernel_many.py`` walks with it, and says what its loops are like.
"""

import math

from .kernel_parts import FAR, JOINTS, SLIDES, THETA, D, cos_sin, fast

__all__ = [
    "ALONG", "ACROSS", "ANGLE", "COS", "MOVED", "ROWS", "SIN", "P", "X", "Y", "Z", "add",
    "add_joint", "add_row", "all_below", "cos_sin_rows", "fill", "flush_plane", "keep", "lay",
    "tilt", "turn",
]  # fmt: skip

X, Y, Z, P = 0, 3, 6, 9  # the rows of a block: three for each axis and for the origin
ANGLE, COS, SIN, ALONG, ACROSS, MOVED, ROWS = 12, 13, 14, 15, 16, 17, 18


@fast
def all_below(row, most, m):
    """Whether all numbers are smaller than ``most``; not where one is NaN. (Counted in whole
    numbers, since the compiler may not reorder a search for the largest float.)
    """
    beyond = 0
    for j in range(m):
        beyond |= not abs(row[j]) < most
    return beyond == 0


@fast
def cos_sin_rows(angle, c, s, m):
    """Cosines and sines of a row of angles: by the polynomials, and where one angle is so large
    that the parts of pi / 2 run out of digits, all by the library's functions.
    """
    if all_below(angle, FAR, m):
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
def tilt(F, c, s, m):
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
def add_joint(q, packed, i, F, m):
    """Joint i (from 1): along z by its d; its angle joins the run."""
    n, of = q.shape[1], JOINTS + 6 * i
    rates = JOINTS + 6 * (n + 1) + n * (i - 1)
    moved, angle = F[MOVED], F[ANGLE]
    fill(moved, 0.0, m)
    for k in range(n):
        rate = packed[rates + k]
        if rate != 0.0:
            for j in range(m):
                moved[j] += rate * q[j, k]
    theta, d = packed[of + THETA], packed[of + D]
    if packed[of + SLIDES] != 0.0:
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
def flush_plane(F, m):
    """What was laid out in the plane of x and y becomes part of p."""
    for across in range(2):
        add_row(F, P, X + 3 * across, F[ALONG + across], m)
        fill(F[ALONG + across], 0.0, m)
