"""The walk for one pose, as numba compiles it: the frame stays in registers. Only ``compiled.py``
imports this file, when numba is wanted.

What remains is the price of a call from Python, about a tenth of a microsecond an array; so the
chain comes as one row of numbers, and ``kernel_parts.py`` says what stands where. The walk is
written once and compiled for each of the three questions, what the others want left out.
"""

import math

from numba import boolean, float64, njit, types

from .kernel_parts import (  # isort: skip
    BASE, COUPLED, END, FAR, FORWARD, FRAMES, JACOBIAN, JOINTS, LARGEST_Q, OPTIONS, ROW,
    SLIDES, STANDARD, THETA, A, C, D, S, cos_sin, fast, chain_rule,
)  # fmt: skip

__all__ = ["answers_one"]

ANY_ROW = types.Array(float64, 1, "A", readonly=True)
TO_MATRIX = boolean(ANY_ROW, ROW, float64[:, ::1])
TO_FRAMES = boolean(ANY_ROW, ROW, float64[:, :, ::1])


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
def behind(x, y, z, p, packed, column):
    """p and a column of the end's pose, seen from the frame."""
    at = END + column
    p = summed(p, x, packed[at])
    return summed(summed(p, y, packed[at + 4]), z, packed[at + 8])


@njit(inline="always", **OPTIONS)
def walk(q, packed, result, kind):
    """The end pose, frames or Jacobian of ``q`` (n,) into ``result``; False where q is not n finite
    numbers.
    """
    n, out = len(q), result.reshape(-1)
    rates = JOINTS + 6 * (n + 1)
    if len(packed) != rates + n * n:
        return False
    standard, coupled = packed[STANDARD] != 0.0, packed[COUPLED] != 0.0
    x = (packed[BASE], packed[BASE + 1], packed[BASE + 2])
    y = (packed[BASE + 3], packed[BASE + 4], packed[BASE + 5])
    z = (packed[BASE + 6], packed[BASE + 7], packed[BASE + 8])
    p = (packed[BASE + 9], packed[BASE + 10], packed[BASE + 11])
    angle = along = across = 0.0
    joined = True
    for i in range(n):
        joined = joined and abs(q[i]) < packed[LARGEST_Q]
    for i in range(n + 1):
        of = JOINTS + 6 * i
        a, step_c, step_s = packed[of + A], packed[of + C], packed[of + S]
        if i > 0:
            moved = packed[rates + (n + 1) * (i - 1)] * q[i - 1]
            if coupled:
                moved = 0.0
                for k in range(n):
                    moved += packed[rates + n * (i - 1) + k] * q[k]
            if moved - moved != 0.0:  # NaN, also where it is infinite
                return False
            slides = packed[of + SLIDES] != 0.0
            angle += packed[of + THETA] + (0.0 if slides else moved)
            p = summed(p, z, packed[of + D] + (moved if slides else 0.0))
            runs_on = joined and kind != FRAMES and i < n and step_c == 1.0 and step_s == 0.0
            if kind == JACOBIAN or not runs_on:
                p = summed(summed(p, x, along), y, across)
                along = across = 0.0
            if kind == JACOBIAN:
                for k in range(3):  # for the columns below; out has room for both
                    out[n * k + i - 1], out[n * (3 + k) + i - 1] = p[k], z[k]
            if not runs_on or a != 0.0:  # where a run goes on in place, nothing has a direction yet
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
    p = behind(x, y, z, p, packed, 3)
    if kind == FORWARD:
        origin = (0.0, 0.0, 0.0)
        u, v, w = (
            behind(x, y, z, origin, packed, 0),
            behind(x, y, z, origin, packed, 1),
            behind(x, y, z, origin, packed, 2),
        )
        write_one(u, v, w, p, out, 0)
        return True
    for i in range(n):
        rate = 1.0 if coupled else packed[rates + (n + 1) * i]
        lx, ly, lz = p[0] - out[i], p[1] - out[n + i], p[2] - out[2 * n + i]
        x0, x1, x2 = rate * out[3 * n + i], rate * out[4 * n + i], rate * out[5 * n + i]
        if packed[JOINTS + 6 * (i + 1) + SLIDES] != 0.0:
            out[i], out[n + i], out[2 * n + i] = x0 + 0.0, x1 + 0.0, x2 + 0.0
            out[3 * n + i] = out[4 * n + i] = out[5 * n + i] = 0.0
        else:
            out[i], out[n + i] = x1 * lz - x2 * ly + 0.0, x2 * lx - x0 * lz + 0.0
            out[2 * n + i] = x0 * ly - x1 * lx + 0.0
            out[3 * n + i], out[4 * n + i], out[5 * n + i] = x0 + 0.0, x1 + 0.0, x2 + 0.0
    if coupled:
        chain_rule(out.reshape(1, -1), packed[rates:], n, 1)
    return True


@njit(TO_MATRIX, cache=True, **OPTIONS)
def forward_one(q, packed, result):
    return walk(q, packed, result, FORWARD)


@njit(TO_FRAMES, cache=True, **OPTIONS)
def frames_one(q, packed, result):
    return walk(q, packed, result, FRAMES)


@njit(TO_MATRIX, cache=True, **OPTIONS)
def jacobian_one(q, packed, result):
    return walk(q, packed, result, JACOBIAN)


def answers_one():
    """The three, as functions that take what the signature says: an array of one dimension, of
    doubles. They look at no more than the size of its numbers (TypeError), so that the caller has
    to see to the rest. Called by its name a kernel would first look for the version that suits its
    arguments, a fifth of the time of a pose; here there is only one.
    """
    return [
        next(iter(kernel.overloads.values())).entry_point
        for kernel in (forward_one, frames_one, jacobian_one)
    ]
