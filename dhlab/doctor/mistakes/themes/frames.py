"""Frames: axes that were placed wrongly, and axes turned round by half."""

from itertools import combinations, product

import numpy as np

from ....geometry.freedoms import half_turn
from ..changes import EACH, ArmChange, RowChange, of_numbers
from ..registry import mistake
from ..remade import ALPHA, THETA, A, D, with_rows

# ---- axes


@mistake("z-across-joint-axis")
def z_across_joint_axis():
    for turn in (np.pi / 2, -np.pi / 2):
        change = of_numbers(("alpha",), lambda alpha, turn=turn: alpha + turn)
        yield RowChange(change, "alpha", rows=(EACH,), within=np.deg2rad(0.1))


@mistake("antiparallel-taken-for-parallel")
def antiparallel_taken_for_parallel():
    def zero(alpha):
        return np.where(np.abs(np.abs(alpha) - np.pi) < 1e-9, 0.0, alpha)

    yield RowChange(of_numbers(("alpha",), zero), "alpha", rows=(EACH,))


@mistake("parallel-offset-in-both-rows")
def parallel_offset_in_both_rows():
    yield ArmChange(_counted_twice, "d")
    yield ArmChange(_counted_twice_further, "d", only="typed")
    yield ArmChange(_sum_in_both, "d", only="typed")


def _counted_twice(arm):
    """The offset of a row counted again in a row whose axis is parallel."""
    for i in range(len(arm) - 1):
        for source, target in ((i, i + 1), (i + 1, i)):
            if _parallel(arm, i) and arm.table.d[source] and not arm.table.d[target]:
                rows = arm.table.rows
                rows[target, D] = rows[source, D]
                yield target + 1, f"rows {i + 1} and {i + 2}", with_rows(arm, rows)


def _counted_twice_further(arm):
    """The same, where rows of parallel axes stand between the two."""
    for i, k in combinations(range(len(arm)), 2):
        if k > i + 1 and all(_parallel(arm, j) for j in range(i, k)):
            for source, target in ((i, k), (k, i)):
                if arm.table.d[source] and not arm.table.d[target]:
                    rows = arm.table.rows
                    rows[target, D] = rows[source, D]
                    yield target + 1, f"rows {i + 1} and {k + 1}", with_rows(arm, rows)


def _sum_in_both(arm):
    for i in range(len(arm) - 1):
        if _parallel(arm, i):
            rows = arm.table.rows
            rows[[i, i + 1], D] = rows[i : i + 2, D].sum()
            yield i + 1, f"rows {i + 1} and {i + 2}", with_rows(arm, rows)


def _parallel(arm, i):
    """Whether the axes along which the d of rows i and i + 1 (from 0) run are parallel."""
    step = 1 if arm.table.convention == "standard" else 0
    return abs(np.sin(arm.table.alpha[i + 1 - step])) < 1e-9


@mistake("intersecting-axes-given-a-length")
def intersecting_axes_given_a_length():
    """The offset along the next axis written as a of this row."""

    def make(arm):
        rows = arm.table.rows
        for i in range(len(arm) - 1):
            if rows[i, A] == 0 and rows[i + 1, D] and abs(np.sin(rows[i, ALPHA])) > 1e-9:
                yield i + 1, f"row {i + 1}", _moved(arm, (i + 1, D), (i, A))

    def undo(arm):
        rows = arm.table.rows
        for i in range(len(arm) - 1):
            if rows[i, A] and not rows[i + 1, D]:
                yield _moved(arm, (i, A), (i + 1, D)), ()

    yield ArmChange(make, "a", undo=undo)


def _moved(arm, source, target):
    """The arm with a number of its table moved to another place."""
    rows = arm.table.rows
    rows[target], rows[source] = rows[source], 0
    return with_rows(arm, rows)


# ---- half turns


@mistake("x-flip-incomplete")
def x_flip_incomplete():
    """X_i turned round with some of its four changes forgotten (of a, alpha, theta_i,
    theta_{i+1}).
    """
    parts = ((1, 1, 0, 0), (1, 0, 1, 1), (1, 0, 0, 0), (1, 1, 1, 0), (1, 1, 0, 1))

    def make(arm):
        for i in range(1, len(arm)):
            for kept in parts:
                yield i, f"x{i}", with_rows(arm, _flipped_x(arm, i, kept))

    def make_at_the_end(arm):
        i = len(arm) if arm.table.convention == "standard" else 0
        for kept in ((1, 1, 0, 0), (1, 1, 1, 1)):
            yield max(i, 1), f"x{i}", with_rows(arm, _flipped_x(arm, i, kept))

    yield ArmChange(make, undo=_rest_of_flip_x)
    yield ArmChange(make_at_the_end, only="typed")


def _flipped_x(arm, i, kept):
    """The rows with x_i turned round, as far as ``kept`` says: (a, alpha, theta_i, theta_{i+1})."""
    rows, n = arm.table.rows, len(arm)
    row = i - 1 if arm.table.convention == "standard" else i
    for column, keep in zip((A, ALPHA), kept):
        rows[row, column] *= -1 if keep else 1
    for row, keep in zip((i - 1, i), kept[2:]):
        if keep and 0 <= row < n:
            rows[row, THETA] = half_turn(rows[row, THETA])
    return rows


def _rest_of_flip_x(arm):
    """What is left to do of a flip, or the part that was done taken back: up to two of the four
    changes.
    """
    for i in range(1, len(arm)):
        for kept in product((0, 1), repeat=4):
            if 0 < sum(kept) <= 2:
                yield with_rows(arm, _flipped_x(arm, i, kept)), ()


@mistake("z-flip-incomplete")
def z_flip_incomplete():
    """Z_i turned round with some of its changes forgotten (alpha of two rows, theta and d and sense
    of the joint on that axis).
    """
    parts = (
        (1, 0, 0, 0, 0),
        (0, 1, 0, 0, 0),
        (1, 1, 0, 0, 0),
        (1, 1, 1, 1, 0),
        (1, 1, 0, 1, 1),
        (1, 1, 1, 0, 1),
        (1, 0, 1, 1, 1),
    )

    def make(arm):
        for i in range(len(arm) - 1):
            for kept in parts:
                yield i + 1, f"z{i + 1}", _flipped_z(arm, i, kept)

    turned = of_numbers(("alpha",), np.vectorize(half_turn))
    near = np.deg2rad(0.1)
    yield RowChange(turned, "alpha", rows=(), typed=(EACH,), where="z{row}", within=near)
    yield ArmChange(make, undo=_rest_of_flip_z)


def _flipped_z(arm, i, kept):
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


def _rest_of_flip_z(arm):
    """As for x: up to two of the five changes."""
    for i in range(len(arm) - 1):
        for kept in product((0, 1), repeat=5):
            if 0 < sum(kept) <= 2:
                yield _flipped_z(arm, i, kept), ()
