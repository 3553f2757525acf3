"""What the two kernels share: how numba is to compile, where the numbers of a packed chain stand,
cosine and sine, the chain rule. (On disk numba keeps what it compiled until
``kernel_one.py`` or ``kernel_many.py`` changes: touch those after a change here or in
``kernel_block.py``.)
"""

import math

import numpy as np
from numba import float64, njit

__all__ = [
    "BASE", "COUPLED", "END", "FAR", "FORWARD", "FRAMES", "JACOBIAN", "JOINTS", "KIND", "OPTIONS",
    "LARGEST_Q", "ROW", "STANDARD", "THETA", "D", "SLIDES", "A", "C", "S", "cos_sin", "fast",
    "chain_rule",
]  # fmt: skip

FORWARD, FRAMES, JACOBIAN = range(3)

# A packed chain: one number each for STANDARD, COUPLED, KIND (of the question; only the kernel for
# many asks it) and LARGEST_Q; from BASE on x, y, z and p of the base, column by column (12); from
# END on the three rows of the end (12); from JOINTS on six numbers for joint i and the step behind
# it, i from 0 (no joint, the step before the first) to n; then the matrix (n, n) of rates, row by
# row, which is diagonal without coupling.
STANDARD, COUPLED, KIND, LARGEST_Q, BASE, END, JOINTS = 0, 1, 2, 3, 4, 16, 28
THETA, D, SLIDES, A, C, S = range(6)

# products and sums may be fused into one instruction; nothing else is left to the compiler. A
# division by 0 gives inf as in numpy, since a test for it would keep loops from being vectorised.
OPTIONS = {"nogil": True, "fastmath": {"contract"}, "error_model": "numpy"}
fast = njit(**OPTIONS)
ROW = float64[::1]

# pi / 2 in three parts of 33 bits: k times the first two is exact for k below a million
TO_QUARTERS = 2 / math.pi
QUARTER = (1.57079632673412561417e00, 6.07710050630396597660e-11, 2.02226624879595063154e-21)
FAR = 1e6  # radians; beyond it the library's cosine and sine are called


@fast
def cos_sin(angle):
    """Cosine and sine: what is left of the angle beside quarter turns, less than 45°, goes into the
    polynomials of fdlibm (k_cos.c, k_sin.c); the number of quarter turns says which of the two is
    which, and with which sign. (That is done by choosing between numbers, not by jumps, which
    vector instructions cannot follow.)
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
def chain_rule(out, rates, n, m):
    """The chain rule for coupled joints, in place: from columns per joint variable to columns per
    number of q.
    """
    row = np.empty(n)
    for j in range(m):
        for r in range(6):
            for k in range(n):
                row[k] = 0.0
                for i in range(n):
                    row[k] += out[j, r * n + i] * rates[n * i + k]
            for k in range(n):
                out[j, r * n + k] = row[k]
