"""What each mistake of the catalogue does to a right arm: the other half of an entry, beside its
words.

A function per mistake yields :class:`Fault` s, one for each place the mistake can be made;
registered under the mistake's id. Adding a mistake is one function here, one entry in
``catalogue.yaml`` and one test.
"""

from dataclasses import dataclass, replace

import numpy as np

from ...arm import Arm
from ...geometry.freedoms import half_turn
from ...transform import rot_x, rot_z, trans
from .fitting import with_rows

__all__ = ["Fault", "FAULTS", "faults"]

THETA, D, A, ALPHA = range(4)
NAMES = ("theta", "d", "a", "alpha")
DEG = 180 / np.pi
FAULTS = {}


@dataclass(frozen=True)
class Fault:
    """A mistake made at one place of a right arm: its id, joint (1-based) or None, parameter or
    None, and the wrong Arm.
    """

    mistake: str
    joint: int | None
    parameter: str | None
    arm: Arm


def fault(mistake, parameter=None):
    """Register a function of a right arm that yields (joint or None, wrong Arm)."""

    def register(function):
        FAULTS.setdefault(mistake, []).append((parameter, function))
        return function

    return register


def faults(arm):
    """Every mistake at every place, made on a right arm; those that change nothing in the numbers
    are left out.
    """
    for mistake, makers in FAULTS.items():
        for parameter, make in makers:
            for joint, wrong in make(arm):
                if wrong != arm:
                    yield Fault(mistake, joint, parameter, wrong)


def _each(arm, change):
    """One wrong arm per row: ``change(rows, i)`` alters a copy of the rows."""
    for i in range(len(arm)):
        rows = arm.table.rows
        change(rows, i)
        yield i + 1, with_rows(arm, rows)


def _negate(column):
    def change(rows, i):
        rows[i, column] *= -1

    return change


def _scale(column, factor):
    def change(rows, i):
        rows[i, column] *= factor

    return change


# --- convention and columns ---


@fault("standard-rows-in-craig-matrix")
def _(arm):
    if arm.table.convention == "standard":
        yield None, with_rows(arm, arm.table.rows, convention="craig")


@fault("craig-rows-in-standard-matrix")
def _(arm):
    if arm.table.convention == "craig":
        yield None, with_rows(arm, arm.table.rows, convention="standard")


@fault("a-alpha-from-previous-row")
def _(arm):
    rows = arm.table.rows
    rows[:, A:] = np.vstack([[0, 0], rows[:-1, A:]])
    yield None, with_rows(arm, rows)


@fault("columns-misread")
def _(arm):
    for order in ([3, 2, 1, 0], [3, 2, 0, 1], [2, 3, 1, 0], [3, 1, 0, 2]):
        yield None, with_rows(arm, arm.table.rows[:, order])


@fault("a-d-exchanged")
def _(arm):
    yield None, with_rows(arm, arm.table.rows[:, [0, 2, 1, 3]])
    for i in range(len(arm)):
        rows = arm.table.rows
        rows[i, [D, A]] = rows[i, [A, D]]
        yield i + 1, with_rows(arm, rows)


@fault("theta-alpha-exchanged")
def _(arm):
    yield None, with_rows(arm, arm.table.rows[:, [3, 1, 2, 0]])
    for i in range(len(arm)):
        rows = arm.table.rows
        rows[i, [THETA, ALPHA]] = rows[i, [ALPHA, THETA]]
        yield i + 1, with_rows(arm, rows)


# --- entries ---


@fault("alpha-sign", "alpha")
def _(arm):
    yield from _each(arm, _negate(ALPHA))
    yield None, with_rows(arm, arm.table.rows * [1, 1, 1, -1])


@fault("length-sign", "d")
def _(arm):
    yield from _each(arm, _negate(D))


@fault("length-sign", "a")
def _(arm):
    yield from _each(arm, _negate(A))


@fault("lengths-made-positive")
def _(arm):
    rows = arm.table.rows
    rows[:, D:ALPHA] = np.abs(rows[:, D:ALPHA])
    yield None, with_rows(arm, rows)
    rows = rows.copy()
    rows[:, ALPHA] = np.abs(rows[:, ALPHA])
    yield None, with_rows(arm, rows)


@fault("length-unit")
def _(arm):
    for factor in (10, 0.1, 100, 0.01):
        yield None, with_rows(arm, arm.table.rows * [1, factor, factor, 1])
    for factors in (
        [1, 1000, 1000, 1],
        [1, 1e-3, 1e-3, 1],
        [1, 1000, 1, 1],
        [1, 1, 1000, 1],
        [1, 1e-3, 1, 1],
        [1, 1, 1e-3, 1],
        [1, 25.4e-3, 25.4e-3, 1],
        [1, 1 / 25.4e-3, 1 / 25.4e-3, 1],
    ):
        yield None, with_rows(arm, arm.table.rows * factors)


@fault("length-unit", "d")
def _(arm):
    for factor in (1000, 1e-3):
        yield from _each(arm, _scale(D, factor))


@fault("length-unit", "a")
def _(arm):
    for factor in (1000, 1e-3):
        yield from _each(arm, _scale(A, factor))


@fault("alpha-in-degrees", "alpha")
def _(arm):
    yield None, with_rows(arm, arm.table.rows * [1, 1, 1, DEG])
    yield from _each(arm, _scale(ALPHA, DEG))


@fault("angle-unit")
def _(arm):
    for factors in (
        [DEG, 1, 1, DEG],
        [1 / DEG, 1, 1, 1 / DEG],
        [1, 1, 1, 1 / DEG],
        [1 / DEG, 1, 1, 1],
        [DEG, 1, 1, 1],
    ):
        yield None, with_rows(arm, arm.table.rows * factors)


@fault("pi-rounded")
def _(arm):
    for digits in (2, 3, 4):
        rows = arm.table.rows
        rows[:, [THETA, ALPHA]] = np.round(rows[:, [THETA, ALPHA]], digits)
        yield None, with_rows(arm, rows)


@fault("z-across-joint-axis", "alpha")
def _(arm):
    for turn in (np.pi / 2, -np.pi / 2):

        def change(rows, i, turn=turn):
            rows[i, ALPHA] += turn

        yield from _each(arm, change)


@fault("antiparallel-taken-for-parallel", "alpha")
def _(arm):
    for joint, wrong in _each(arm, lambda rows, i: rows.__setitem__((i, ALPHA), 0.0)):
        if abs(abs(arm.table.alpha[joint - 1]) - np.pi) < 1e-9:
            yield joint, wrong


@fault("parallel-offset-in-both-rows", "d")
def _(arm):
    """The offset of a row counted again in a row whose axis is parallel."""
    step = 1 if arm.table.convention == "standard" else 0
    for i in range(len(arm) - 1):
        if abs(np.sin(arm.table.alpha[i + 1 - step])) > 1e-9:
            continue
        for source, target in ((i, i + 1), (i + 1, i)):
            if arm.table.d[source] and not arm.table.d[target]:
                rows = arm.table.rows
                rows[target, D] = rows[source, D]
                yield target + 1, with_rows(arm, rows)


@fault("intersecting-axes-given-a-length", "a")
def _(arm):
    """The offset along the next axis written as a of this row."""
    for i in range(len(arm) - 1):
        if arm.table.a[i] == 0 and arm.table.d[i + 1] and abs(np.sin(arm.table.alpha[i])) > 1e-9:
            rows = arm.table.rows
            rows[i, A], rows[i + 1, D] = rows[i + 1, D], 0
            yield i + 1, with_rows(arm, rows)


# --- joint variables ---


def _offsets(arm, change):
    """All zero offsets changed at once, and each alone."""
    yield None, with_rows(arm, np.column_stack([change(arm.table.theta), arm.table.rows[:, 1:]]))

    def one(rows, i):
        rows[i, THETA] = change(rows[i, THETA])

    yield from _each(arm, one)


@fault("offset-missing", "theta")
def _(arm):
    yield from _offsets(arm, lambda theta: 0 * theta)


@fault("offset-sign", "theta")
def _(arm):
    yield from _offsets(arm, np.negative)


@fault("offset-counted-twice", "theta")
def _(arm):
    yield from _offsets(arm, lambda theta: 2 * theta)


@fault("offset-in-degrees", "theta")
def _(arm):
    yield from _offsets(arm, lambda theta: theta * DEG)


@fault("offset-on-wrong-joint", "theta")
def _(arm):
    for i in range(len(arm)):
        for k in (i - 1, i + 1):
            if 0 <= k < len(arm) and arm.table.theta[i]:
                rows = arm.table.rows
                rows[k, THETA] += rows[i, THETA]
                rows[i, THETA] = 0
                yield i + 1, with_rows(arm, rows)


@fault("joint-reversed", "sign")
def _(arm):
    for i in range(len(arm)):
        yield i + 1, replace(arm, sign=arm.sign * np.where(np.arange(len(arm)) == i, -1, 1))


@fault("all-joints-left-handed", "sign")
def _(arm):
    yield None, replace(arm, sign=-arm.sign)
    yield None, with_rows(arm, arm.table.rows * [-1, 1, 1, 1], sign=-arm.sign)


@fault("prismatic-variable-in-theta")
def _(arm):
    for i, letter in enumerate(arm.table.joints):
        if letter == "P":
            yield (
                i + 1,
                with_rows(
                    arm,
                    arm.table.rows,
                    joints=arm.table.joints[:i] + "R" + arm.table.joints[i + 1 :],
                ),
            )


@fault("prismatic-constant-lost")
def _(arm):
    for i, letter in enumerate(arm.table.joints):
        if letter == "P":
            for column in (THETA, D):
                rows = arm.table.rows
                rows[i, column] = 0
                yield i + 1, with_rows(arm, rows)


# --- frames ---


@fault("x-flip-incomplete")
def _(arm):
    """X_i turned round with some of its four changes forgotten (of a, alpha, theta_i,
    theta_{i+1}).
    """
    for i in range(len(arm) - 1):
        for kept in ((1, 1, 0, 0), (1, 0, 1, 1), (1, 0, 0, 0), (1, 1, 1, 0), (1, 1, 0, 1)):
            yield i + 1, with_rows(arm, flipped_x(arm, i, kept))


def flipped_x(arm, i, kept):
    """The rows with X_{i+1} turned round, as far as ``kept`` says: (a, alpha, theta of the row,
    theta of the next).
    """
    rows, k = arm.table.rows, i + (arm.table.convention == "craig")
    for column, keep in zip((A, ALPHA), kept):
        rows[k, column] *= -1 if keep else 1
    for row, keep in zip((i, i + 1), kept[2:]):
        rows[row, THETA] = half_turn(rows[row, THETA]) if keep else rows[row, THETA]
    return rows


@fault("z-flip-incomplete")
def _(arm):
    """Z turned round with some of its changes forgotten (alpha of two rows, theta and d and sense
    of the joint on that axis).
    """
    for i in range(len(arm) - 1):
        for kept in (
            (1, 0, 0, 0, 0),
            (0, 1, 0, 0, 0),
            (1, 1, 0, 0, 0),
            (1, 1, 1, 1, 0),
            (1, 1, 0, 1, 1),
            (1, 1, 1, 0, 1),
            (1, 0, 1, 1, 1),
        ):
            yield i + 1, flipped_z(arm, i, kept)


def flipped_z(arm, i, kept):
    """The arm with Z of frame i+1 turned round, as far as ``kept`` says: (alpha before, alpha
    after, theta, d, sign).
    """
    rows, sign = arm.table.rows, arm.sign.copy()
    joint = i + 1 if arm.table.convention == "standard" else i
    for row, keep in zip((i, i + 1), kept):
        rows[row, ALPHA] = half_turn(rows[row, ALPHA]) if keep else rows[row, ALPHA]
    for column, keep in zip((THETA, D), kept[2:]):
        rows[joint, column] *= -1 if keep else 1
    sign[joint] *= -1 if kept[4] else 1
    return with_rows(arm, rows, sign=sign)


# --- base and tool ---


@fault("tool-missing", "tool")
def _(arm):
    yield None, replace(arm, tool=np.eye(4))
    last = arm.table.rows
    last[-1, D] = 0
    yield None, with_rows(arm, last)


@fault("tool-on-wrong-side", "tool")
def _(arm):
    yield None, replace(arm, base=trans(arm.tool[:3, 3]) @ arm.base, tool=np.eye(4))


@fault("base-height-missing-or-twice", "base")
def _(arm):
    for factor in (0, 2):
        rows = arm.table.rows
        rows[0, D] *= factor
        yield None, with_rows(arm, rows)
    yield None, replace(arm, base=trans([0, 0, -arm.base[2, 3]]) @ arm.base)


@fault("base-turned", "base")
def _(arm):
    for turn in (rot_z(np.pi), rot_z(np.pi / 2), rot_z(-np.pi / 2), rot_x(np.pi)):
        yield None, replace(arm, base=turn @ arm.base)
