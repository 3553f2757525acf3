"""Every exercise against right answers in eight dresses and against wrong ones: how many pass, how
many fail, how many are named or told where, how many sentences are not true, and how long a check
takes; as a Markdown table.

    python benchmarks/exercises.py            # all exercises
    python benchmarks/exercises.py 02 06.10   # some

Right answers come as lists, as arrays made at once for all, from a recursive program, as numbers of
SymPy, as an object of a class, in float32, as np.matrix and from programs that think in degrees.
Wrong values are the exercise's own mistakes and slips of the hand, and mistakes that no list
foresees; wrong programs are the doctor's wrong versions of the family; wrong tables its wrong
tables that move the arm; of an order up to 120 others. Whether a sentence is true is decided by the
predicates of tests/course/claims, of what is told, why, and what is to be done next: of numbers,
tables and orders, and of programs for a link or a chain. Other programs are measured by
benchmarks/doctor_programs.py. The last line says how long a check takes: the median is to be 0.3 s
at most and the longest 1 s, SymPy apart. numba, which a learner seldom has and which is loaded once
in a process, is left out.
"""

import os
import sys
from pathlib import Path
from statistics import median
from time import process_time

import numpy as np

TESTS = Path(__file__).parents[1] / "tests"
os.environ.setdefault("DHLAB_NUMBA", "0")
sys.path[:0] = [str(TESTS), str(TESTS / "course")]

from claims import judged  # noqa: E402
from claims import programs as of_programs  # noqa: E402
from claims.advice import unfounded  # noqa: E402
from claims.facts import reaches  # noqa: E402
from wrong_answers import unforeseen, wrong_answers  # noqa: E402

from dhlab.course.exercises import exercises  # noqa: E402
from dhlab.course.kinds import Choice, Function, Order, Table, Value, numbers  # noqa: E402
from dhlab.doctor.programs.explain import WRONG_VERSIONS  # noqa: E402

VARIANTS = range(2)
KINDS = (Value, Function, Table, Choice, Order)
HEADINGS = (
    "exercise",
    "kind",
    "right answers",
    "refused",
    "wrong answers",
    "passed",
    "named",
    "told where",
    "sentences not true",
    "median (s)",
    "longest (s)",
)
OF_POSES = ("dh_transform", "craig_transform", "forward_kinematics")
MEDIAN, LONGEST = 0.3, 1.0  # s of the processor that a check may take
SYMBOLIC = "SymPy"  # its own arithmetic takes its time, and is timed apart


def dresses(value):
    """A right value as people hand it in: (dress, answer)."""
    import sympy

    array = np.asarray(value, dtype=float)
    yield "lists", array.tolist()
    yield "vectorised", np.stack([array, array])[0]
    yield SYMBOLIC, np.array([sympy.Float(x, 17) for x in array.flat]).reshape(array.shape)
    yield "class", Handed(array)
    yield "float32", array.astype(np.float32)
    if array.ndim:
        yield "np.matrix", np.asmatrix(array)
    yield "degrees inside", np.deg2rad(np.rad2deg(array))
    yield "rounded by nothing", tuple(array.tolist()) if array.ndim else float(array)


class Handed:
    """Something that numpy can read, and that is no array."""

    def __init__(self, array):
        self.array = array

    def __array__(self, dtype=None, copy=None):
        return np.array(self.array, dtype=dtype)


def programs(right):
    """A right program in eight dresses, as far as they fit any program: (dress, program)."""
    import sympy

    def recursive(*case, depth=3):
        return right(*case) if depth == 0 else recursive(*case, depth=depth - 1)

    class Program:
        def __call__(self, *case):
            return right(*case)

        def solve(self, *case):
            return right(*case)

    def symbolic(*case):
        array = np.asarray(right(*case), dtype=float)
        return np.array([sympy.Float(x, 17) for x in array.flat]).reshape(array.shape)

    def degrees_inside(*case):
        turned = np.rad2deg(np.asarray(right(*case), dtype=float))
        return np.deg2rad(turned)

    yield "lists", lambda *case: np.asarray(right(*case)).tolist()
    yield "vectorised", lambda *case: np.stack([right(*case)] * 2)[1]
    yield "recursive", lambda *case: recursive(*case)
    yield SYMBOLIC, symbolic
    yield "class", Program().solve
    yield "float32", lambda *case: np.asarray(right(*case), dtype=np.float32)
    yield "np.matrix", lambda *case: _as_matrix(right(*case))
    yield "degrees inside", degrees_inside


def _as_matrix(array):
    return np.asmatrix(array) if np.ndim(array) == 2 else array


def answers(exercise, variant):
    """Right answers with their dress, and wrong ones."""
    if isinstance(exercise, Function):
        wrong = [f for *_, f in WRONG_VERSIONS.get(exercise.family, ())]
        return list(programs(exercise.answer)), wrong[:: max(1, len(wrong) // 30)]
    if isinstance(exercise, Choice):
        letters = exercise.letters(variant)
        right = letters.pop(exercise.correct)
        dressed = [right, right.upper(), f" {right} ", exercise.correct]
        return [("letter", answer) for answer in dressed], list(letters.values())
    wrong = [*wrong_answers(exercise, variant, 120), *unforeseen(exercise, variant)]
    if isinstance(exercise, Value):
        return list(dresses(exercise.answer(**exercise.given(variant)))), wrong
    if isinstance(exercise, Order):
        return [("letters", ids) for ids in orders(exercise)], wrong
    return [*dressed_table(exercise, variant)], wrong


def orders(exercise):
    """A right order, as ids and in capitals."""
    from itertools import permutations, product

    given = (list(ids) for ids in permutations(exercise.items, exercise.size))
    if exercise.repeats:
        given = (list(ids) for ids in product(exercise.items, repeat=exercise.size))
    ids = next(ids for ids in given if exercise.accepts(ids))
    letters = [exercise.letters()[key] for key in ids]
    return [ids, letters, tuple(letters), ", ".join(letters).upper()]


def dressed_table(exercise, variant):
    """The right table as rows in every dress, as a table and as an arm; for an impostor, none."""
    if exercise.id == "07.4":
        return
    right = exercise.right_arm(variant)
    for dress, rows in dresses(numbers(right.table)):
        fits = np.allclose(right.base, np.eye(4)) and np.allclose(right.tool, np.eye(4))
        if fits:
            yield dress, rows
    yield "class", right


def moved(exercise, variant, answer, verdict):
    """Whether a wrong answer is wrong: a table may be another right one, a number right enough."""
    if verdict.status != "right":
        return True
    if isinstance(exercise, Table):
        return False  # judged by the arm: what passes is the arm, or 07.4's impostor
    given = exercise.given(variant)
    if exercise.id == "08.13":  # any q that reaches the pose from near by is right
        return not reaches(answer, given["T"])
    right = np.asarray(exercise.answer(**given), dtype=float)
    off = np.asarray(answer, dtype=float) - right
    for k in exercise.turns:  # whole turns are no mistake
        off[k] = (off[k] + 180) % 360 - 180
    allowed = max(0.02, exercise.tolerance)  # 07.7 is measured, and good to half a degree
    return np.abs(off).max() > allowed * (1 + np.abs(right).max())


def measured(exercise):
    """The counts of one exercise, and the times of its checks."""
    count, times = np.zeros(7, dtype=int), []
    for variant in VARIANTS:
        right, wrong = answers(exercise, variant)
        for dress, answer in right:
            start = process_time()
            verdict = exercise.judge(answer, variant)
            if dress != SYMBOLIC:
                times.append(process_time() - start)
            count[:2] += 1, verdict.status != "right"
            if verdict.status != "right":
                print(f"refused: {exercise.id} {dress}: {verdict}", file=sys.stderr)
        for answer in wrong:
            start = process_time()
            verdict = exercise.judge(answer, variant)
            times.append(process_time() - start)
            if verdict.status == "not attempted":
                continue
            if verdict.status == "right":
                if callable(answer) or moved(exercise, variant, answer, verdict):
                    count[[2, 3]] += 1
                    print(f"passed: {exercise.id} {answer}", file=sys.stderr)
                continue
            named = verdict.mistake is not None
            count[[2, 4 if named else 5]] += 1
            if isinstance(exercise, (Value, Table, Order)) or _is_of_poses(exercise, named):
                true = _is_true(exercise, verdict, answer, variant)
                count[6] += not true
                if not true:
                    print(f"not true: {exercise.id} {verdict} of {answer}", file=sys.stderr)
    return count, times


def _is_of_poses(exercise, named):
    """Whether there are predicates for what is said of a program."""
    return named and getattr(exercise, "family", "") in OF_POSES


def _is_true(exercise, verdict, answer, variant):
    if any(unfounded(exercise, verdict, answer, variant)):
        return False
    if isinstance(exercise, Function):
        return of_programs.judged(verdict, answer, exercise.family)
    return judged(exercise, verdict, answer, variant)


def main():
    """One line an exercise."""
    print(f"| {' | '.join(HEADINGS)} |\n|{'---|' * len(HEADINGS)}", flush=True)
    total, every = np.zeros(7, dtype=int), []
    for key, exercise in exercises().items():
        kind = next((kind for kind in KINDS if isinstance(exercise, kind)), None)
        if kind is None or (sys.argv[1:] and not key.startswith(tuple(sys.argv[1:]))):
            continue
        count, times = measured(exercise)
        total, every = total + count, every + times
        row(key, kind.__name__.lower(), count, times)
    row("all", "", total, every)
    slow = sum(seconds > LONGEST for seconds in every)
    print(
        f"\n{len(every)} checks, SymPy apart: median {median(every):.3f} s (at most {MEDIAN}),"
        f" longest {max(every):.2f} s (at most {LONGEST}); {slow} longer than that"
    )


def row(key, kind, count, times):
    cells = [key, kind, *map(str, count), f"{median(times):.3f}", f"{max(times):.2f}"]
    print(f"| {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main()
