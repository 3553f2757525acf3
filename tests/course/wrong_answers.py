"""Wrong answers of every exercise, for the tests and for benchmarks/exercises.py: its own, slips of
the hand, and plausible ones that no list foresees.
"""

from itertools import islice, permutations, product

import numpy as np

from dhlab.course.kinds import Order, Table, Value
from dhlab.doctor.tables.rows import wrong_tables

__all__ = ["double_slips", "unforeseen", "wrong_answers", "wrong_frames"]

TURNS = np.array([180 / np.pi, 1, 1, 180 / np.pi])


def wrong_answers(exercise, variant, most=200):
    """Answers that the exercise knows, or that units and signs make of the right one."""
    if isinstance(exercise, Order):
        return _orders(exercise, variant, most)
    own = [wrong for *_, wrong in exercise.mistakes(**exercise.given(variant))]
    if isinstance(exercise, Value):
        return [*own, *_slips(np.asarray(exercise.answer(**exercise.given(variant)), dtype=float))]
    return [*own, *_tables(exercise, variant)][:most]


def unforeseen(exercise, variant):
    """Two slips at once, another axis, another book's formula: at least five, in no list."""
    rng = np.random.default_rng([int(exercise.id.replace(".", "")[:4]), variant])
    if isinstance(exercise, Value):
        return list(_two_slips(np.asarray(exercise.answer(**exercise.given(variant))), rng))
    if isinstance(exercise, Table):
        return list(_two_entries(exercise, variant, rng))
    return _orders(exercise, variant + 7, 8)


def double_slips(exercise, variant, most):
    """Rows, or one row, in which two slips of the hand were made one after the other."""
    rng = np.random.default_rng([most, variant, int(exercise.id.replace(".", ""))])
    table = isinstance(exercise, Table)
    right = _rows(exercise.right_arm(variant).table) if table else exercise.expected(variant)[None]
    for _ in range(most):
        rows = np.array(right, dtype=float)
        for slip in rng.choice(len(BY_HAND), 2, replace=False):
            i, k = rng.integers(len(rows)), rng.integers(4)
            rows = np.asarray(BY_HAND[slip](rows, np.outer(np.arange(len(rows)) == i, ENTRY[k])))
        yield rows.tolist() if table else rows[0].tolist()


ENTRY = np.eye(4)
BY_HAND = [  # of rows, and of a mask of one number
    lambda rows, one: rows * (1 - 2 * one),
    lambda rows, one: rows * (1 - one),
    lambda rows, one: rows + one * [7, 0.03, 0.03, 7],
    lambda rows, one: rows + one * [90, 0, 0, 90],
    lambda rows, one: np.where(one.any(axis=0), rows / TURNS, rows),
    lambda rows, one: rows / TURNS,
    lambda rows, one: rows * [1, 1000, 1000, 1],
    lambda rows, one: rows[:, [0, 2, 1, 3]],
    lambda rows, one: np.roll(rows, 1, axis=0),
    lambda rows, one: np.column_stack([rows[:, :2], np.roll(rows[:, 2:], 1, axis=0)]),
    lambda rows, one: np.column_stack([rows[:, :1], rows[:, 1:3].round(1), rows[:, 3:]]),
]


def _slips(right):
    yield from (-right, 1000 * right, right / 1000, 100 * right, np.rad2deg(right))
    yield from (np.deg2rad(right), 2 * right, right + 0.1, 1.05 * right, np.abs(right))
    yield from (np.round(right), np.flip(right), right.T, np.zeros_like(right))
    for k in range(right.size):
        for change in (lambda x: -x, lambda x: x + 0.3, lambda x: 1000 * x, np.deg2rad, np.rad2deg):
            wrong = right.astype(float).ravel().copy()
            wrong[k] = change(wrong[k])
            yield wrong.reshape(right.shape)


def _two_slips(right, rng):
    """Two entries changed in two ways, entries rolled round, entries mixed."""
    flat = np.asarray(right, dtype=float).ravel()
    if flat.size < 2:
        return
    for _ in range(6):
        wrong = flat.copy()
        i, k = rng.choice(flat.size, 2, replace=False)
        wrong[i], wrong[k] = -1.7 * wrong[i] - 0.11, wrong[k] + rng.choice([-0.23, 0.31, 0.07])
        yield wrong.reshape(np.shape(right))
    yield np.roll(flat, 1).reshape(np.shape(right)) + 0.013
    yield (flat[::-1] * 1.1).reshape(np.shape(right))
    if np.shape(right) == (4, 4):
        T = np.asarray(right, dtype=float)
        for turn in (np.array([[0, 0, 1], [1, 0, 0], [0, 1, 0]]), np.diag([1, -1, -1])):
            other = T.copy()
            other[:3, :3] = T[:3, :3] @ turn
            other[:3, 3] = T[[1, 0, 2], 3] + 0.02
            yield other


def _rows(table):
    return table.rows * TURNS


def _tables(exercise, variant):
    """The doctor's wrong tables of the right one's kind, and units of columns and entries."""
    right = exercise.right_arm(variant)
    for _, _, table in wrong_tables(right.table):
        if (table.convention, table.joints) == (right.table.convention, right.table.joints):
            yield _rows(table).tolist()
    rows = _rows(right.table)
    for columns in ([0], [3], [0, 3]):
        wrong = rows.copy()
        wrong[:, columns] = np.deg2rad(wrong[:, columns])
        yield wrong.tolist()
        wrong[:, [1, 2]] *= 1000
        yield wrong.tolist()
    for i, k in np.argwhere(np.abs(rows) > 0):
        wrong = rows.copy()
        wrong[i, k] = np.deg2rad(wrong[i, k]) if k in (0, 3) else 1000 * wrong[i, k]
        yield wrong.tolist()


def _two_entries(exercise, variant, rng):
    """Two numbers of two rows changed, a row doubled, rows turned round, another link's numbers."""
    right = exercise.right_arm(variant)
    rows = _rows(right.table)
    n = len(rows)
    for _ in range(6):
        wrong = rows.copy()
        i, k = rng.choice(n, 2, replace=False)
        wrong[i, rng.integers(1, 3)] += 0.0371
        wrong[k, rng.choice([0, 3])] += rng.choice([17, -41])
        yield wrong.tolist()
    yield (rows[::-1] + [3, 0, 0.01, 0]).tolist()
    wrong = rows.copy()
    wrong[0], wrong[1] = rows[1] + [0, 0.011, 0, 0], rows[0]
    yield wrong.tolist()


def _orders(exercise, variant, most):
    """Orders that are not right, as ids; an item may stand twice where it must for a right one."""
    given = [list(ids) for ids in permutations(exercise.items, exercise.size)]
    if exercise.repeats:
        given = [list(ids) for ids in product(exercise.items, repeat=exercise.size)]
    rest = [ids for ids in given if not exercise.accepts(ids)]
    picked = np.random.default_rng(variant).permutation(len(rest))
    return [rest[k] for k in islice(picked, most)]


def wrong_frames(rows, axes):
    """One step changed: other axes' directions and lines, points beside and along, arrows across
    and along.
    """
    n = len(rows) - 1
    for i, (z, o, x) in enumerate(rows):
        z, o, x = np.asarray(z, dtype=float), np.asarray(o, dtype=float), np.asarray(x, dtype=float)
        directions = [np.cross(z, x), x, z + 0.4 * x, *(np.asarray(d) for _, d, *_ in axes)]
        points = [
            o + 0.1 * z,
            o + 0.1 * x,
            o + 0.1 * np.cross(z, x),
            np.asarray(rows[i - 1][1]),
            np.asarray(rows[min(i + 1, n)][1]),
            np.zeros(3),
        ]
        for part, changes in (
            (0, directions),
            (1, points),
            (2, [z, np.cross(z, x), x + 0.5 * z, np.asarray(rows[i - 1][0]), x + z]),
        ):
            for change in changes:
                yield [
                    *rows[:i],
                    [change if k == part else v for k, v in enumerate((z, o, x))],
                    *rows[i + 1 :],
                ]
