"""Every exercise against right answers in several dresses and against wrong ones: how many pass,
how many fail, how many are named, as a Markdown table.

    python benchmarks/exercises.py

Wrong values are the exercise's own mistakes and slips of the hand (a sign, a unit, degrees, an
order, one digit); wrong programs are the doctor's wrong versions of the family; wrong tables its
wrong tables that move the arm; of a choice all other options, of an order up to 200 others. A guess
and the pre-test have no wrong answer; exercises of a kind of their own (frames to place, a table to
repair) and tables of drawn numbers are judged in tests/course.
"""

from itertools import islice, permutations, product

import numpy as np

import dhlab as dh
from dhlab.course.exercises import exercises
from dhlab.course.kinds import Choice, Function, Order, Table, Value
from dhlab.doctor.programs.explain import WRONG_VERSIONS
from dhlab.doctor.tables.rows import wrong_tables

VARIANTS = range(3)


def answers(exercise, variant):
    """(right answers, wrong answers) of one variant."""
    if isinstance(exercise, Value):
        return values(exercise, exercise.given(variant))
    if isinstance(exercise, Function):
        own = exercise.answer
        return [
            own,
            lambda *case: np.asarray(own(*case)).tolist(),
            lambda *case: np.array(own(*case), dtype=float, order="F"),
        ], [f for *_, f in WRONG_VERSIONS[exercise.family]]
    if isinstance(exercise, Table):
        return tables(exercise)
    if isinstance(exercise, Choice):
        letters = exercise.letters(variant)
        right = letters.pop(exercise.correct)
        return [right, right.upper(), f" {right} ", exercise.correct], list(letters.values())
    return orders(exercise, variant)


def orders(exercise, variant):
    """A right order in several dresses, and up to 200 others; an item may stand twice where it must
    for a right one.
    """
    letters, accepts = exercise.letters(variant), exercise.accepts
    given = [list(ids) for ids in permutations(exercise.items, exercise.size)]
    if not any(accepts(ids) for ids in given):
        given = [list(ids) for ids in product(exercise.items, repeat=exercise.size)]
    ids = next(ids for ids in given if accepts(ids))
    right = [letters[key] for key in ids]
    rest = np.random.default_rng(variant).permutation([o for o in given if not accepts(o)])
    wrong = [[letters[key] for key in order] for order in islice(rest.tolist(), 200)]
    return [right, tuple(right), ", ".join(right), ids], wrong


def values(exercise, given):
    """Slips that change the right value; those that do not (a sign of 0, say) are no mistakes."""
    right = np.asarray(exercise.answer(**given), dtype=float)
    slips = [value for *_, value in exercise.mistakes(**given)] + [
        -right,
        1000 * right,
        right / 1000,
        np.rad2deg(right),
        np.deg2rad(right),
        2 * right,
        right + 0.1,
        1.05 * right,
        np.abs(right),
        np.round(right),
        np.flip(right),
        right.T,
        np.zeros_like(right),
    ]
    slips += (
        [
            np.where(np.arange(right.size).reshape(right.shape) == k, right + 0.3, right)
            for k in range(min(right.size, 4))
        ]
        if right.ndim
        else []
    )
    wrong = [np.asarray(slip, dtype=float) for slip in slips]
    allowed = max(5e-3, exercise.tolerance) * (1 + np.abs(right))
    return [right, right.tolist(), right * (1 + 1e-7)], [
        slip
        for slip in wrong
        if slip.shape != right.shape or (np.abs(slip - right) > allowed).any()
    ]


def tables(exercise):
    """The right table as written, and as other right tables of the same arm; the wrong ones that
    move the end.
    """
    arm = exercise.right_arm()
    q = np.random.default_rng(1).uniform(-2, 2, (8, len(arm)))
    right = [rows(arm.table)] + [
        rows(other.table)
        for other in (arm.flip_x(1), arm.flip_x(2))
        if np.allclose(other.base, arm.base) and np.allclose(other.tool, arm.tool)
    ]
    wrong = [
        table
        for _, _, table in wrong_tables(arm.table)
        if (table.convention, table.joints) == (arm.table.convention, arm.table.joints)
    ]
    moved = [
        table
        for table in wrong
        if not np.allclose(
            dh.Arm(table, base=arm.base, tool=arm.tool, sign=arm.sign).forward(q),
            arm.forward(q),
            atol=1e-6,
        )
    ]
    return [*right, np.array(right[0])], [rows(table) for table in moved]


def rows(table):
    return np.c_[np.rad2deg(table.theta), table.d, table.a, np.rad2deg(table.alpha)].tolist()


def main():
    """One line an exercise."""
    print(
        "| exercise | kind | right answers | pass | wrong answers | fail | named"
        " |\n|---|---|---|---|---|---|---|"
    )
    total = np.zeros(5, dtype=int)
    for key, exercise in exercises().items():
        kind = next(
            (
                kind
                for kind in (Value, Function, Table, Choice, Order)
                if isinstance(exercise, kind)
            ),
            None,
        )
        if kind is None or (kind is Table and (exercise.given(0) or exercise.handed_out)):
            continue  # these are judged in tests/course, each in its own way
        count = np.zeros(5, dtype=int)
        for variant in VARIANTS:
            right, wrong = answers(exercise, variant)
            good, bad = (
                [exercise.judge(a, variant) for a in right],
                [v for a in wrong if (v := exercise.judge(a, variant)).status != "not attempted"],
            )
            count += [
                len(good),
                sum(v.status == "right" for v in good),
                len(bad),
                sum(v.status == "wrong" for v in bad),
                sum(v.mistake is not None for v in bad),
            ]
        total += count
        print(
            f"| {key} | {kind.__name__.lower()} | " + " | ".join(map(str, count)) + " |", flush=True
        )
    print("| all | | " + " | ".join(map(str, total)) + " |")


if __name__ == "__main__":
    main()
