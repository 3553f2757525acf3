"""A class of 60 simulated students, and what the grader and the class report make of it.

Run ``python benchmarks/classroom.py [OUT]`` from the project's top folder. It hands out lessons 05
and 06, lets each student answer (right in many wordings, wrong in known ways and in ways nobody
foresaw, left out), spoils some files, lets two students copy, grades, and prints how many wrong
answers the report names, how many of the planted mistakes it names rightly, and which copies it
finds. The programs are those of ``tests/doctor/wrong_programs.py`` and ``unseen_programs.py``, each
rewritten at random for every student.
"""

import argparse
import ast
import hashlib
import json
import os
import re
import sys
import tempfile
import time
from collections import Counter
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from itertools import permutations, product
from pathlib import Path

import nbformat
import numpy as np

from dhlab.course.exercises import exercises
from dhlab.course.exercises.closed05 import ClosedForm
from dhlab.course.kinds import Choice, Function, Order, Table, Value
from dhlab.doctor import catalogue
from dhlab.doctor.tables.rows import wrong_tables
from dhlab.grading.grade import grade
from dhlab.grading.handing_out.release import key_of, release
from dhlab.grading.handing_out.variants import variants
from dhlab.grading.intake.roster import Student
from dhlab.grading.reports.items import items
from dhlab.grading.reports.publish import publish
from dhlab.grading.settings import read_settings

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "doctor" / "programs"))
from unseen_programs import UNSEEN
from wrong_programs import RIGHT, WRONG

ROT_X = (
    "import numpy as np\ndef rot_x(alpha):\n    c, s = np.cos(alpha), np.sin(alpha)\n    return"
    " np.array([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])\n"
)
WRONG_ROT_X = {
    "rotation-transposed": ROT_X.replace("c, -s, 0], [0, s, c", "c, s, 0], [0, -s, c"),
    "degrees-in-sin-cos": ROT_X.replace("c, s =", "alpha = np.rad2deg(alpha)\n    c, s ="),
    "converted-to-radians-twice": ROT_X.replace("c, s =", "alpha = np.deg2rad(alpha)\n    c, s ="),
}
PRODUCT = re.compile(r"multi_dot|@")  # of matrices
NAMES = [
    "Ada Lovelace",
    "李小龙",
    "<script>alert('no')</script>",
    '=HYPERLINK("http://example.org")',
    "Søren Ålund",
    "O'Neil & Sons",
    "‮evil",
]
BAD_QUESTION = "05.2"  # misleading: the more one knows, the likelier the wrong answer
SPOILED = {7: b"", 17: b'{"cells": [', 27: "not a notebook".encode("utf-16"), 37: b"[1, 2, 3]"}
MISSING, LOOPING, UNTOUCHED, LATE = {47}, {53}, {57}, (3, 13, 23, 33)
COPIES = {41: 40, 51: 50}  # who copied from whom; 41 changed the names of things, 51 nothing


@dataclass
class Plan:
    """One student: how able, what was planted for each exercise (a status, or the id of a mistake),
    and the code; ``drawn`` are the programs before they were rewritten, which several may share.
    """

    student: Student
    able: float
    planted: dict = field(default_factory=dict)
    code: dict = field(default_factory=dict)
    drawn: dict = field(default_factory=dict)


def roster(size=60):
    """The students; some are called things that a page or a spreadsheet would choke on."""
    return tuple(
        Student(
            f"s{k:03d}",
            NAMES[k] if k < len(NAMES) else f"Student {k}",
            f"s{k:03d}@example.org",
            "zh_CN" if k == 1 else "en",
        )
        for k in range(size)
    )


def plans(lessons=("05", "06"), size=60, seed=7, numbers=None):
    """What every student answers; ``numbers`` are their variants by id, 0 when left out."""
    rng = np.random.default_rng(seed)
    scored = {key: e for key, e in exercises().items() if key[:2] in lessons and e.points}
    hard = {key: rng.normal(-0.6, 0.7) for key in scored}
    made = [Plan(student, rng.normal()) for student in roster(size)]
    for k, plan in enumerate(made):
        for key, exercise in scored.items():
            _answer(plan, exercise, hard[key], (numbers or {}).get(plan.student.student, 0), rng)
        if COPIES.get(k, size) < k:
            plan.planted, plan.code = (
                dict(made[COPIES[k]].planted),
                {key: _renamed(code, k) for key, code in made[COPIES[k]].code.items()},
            )
    return made


def _answer(plan, exercise, hard, variant, rng):
    slope = -2 if exercise.id == BAD_QUESTION else 2
    knows = rng.random() < 1 / (1 + np.exp(-slope * (plan.able - hard)))
    if (not knows and rng.random() < 0.1) or (
        isinstance(exercise, Function) and not _programs(exercise)
    ):
        return  # left out
    plan.planted[exercise.id], code = (
        _right(exercise, variant, rng) if knows else _wrong(exercise, variant, rng)
    )
    if isinstance(exercise, Function):
        plan.drawn[exercise.id], code = code, restyled(code, rng)
    plan.code[exercise.id] = code


def _right(exercise, variant, rng):
    if isinstance(exercise, Value):
        return "right", repr(
            np.asarray(exercise.answer(**exercise.given(variant)), dtype=float).tolist()
        )
    if isinstance(exercise, Function):
        texts = _programs(exercise)[0]
        return "right", texts[rng.integers(len(texts))]
    if isinstance(exercise, Table):
        return "right", repr(_degrees(exercise.right_arm(variant).table))
    return "right", (
        repr(exercise.letters(variant)[exercise.correct])
        if isinstance(exercise, Choice)
        else repr(_order(exercise, True, variant, rng))
    )


def _programs(exercise):
    """The right texts and the (mistake, text) of the wrong ones; empty for a function that nobody
    has collected programs of.
    """
    if exercise.family == "rot_x":
        return [ROT_X], list(WRONG_ROT_X.items())
    # the checks ask for more digits than float32 has, and some for typed entries
    texts = [
        text
        for kind, text in RIGHT
        if kind == exercise.family
        and "float32" not in text
        and not (isinstance(exercise, ClosedForm) and PRODUCT.search(text))
    ]
    return (
        (
            texts,
            [
                (ids[0], text)
                for kind, ids, text in WRONG + UNSEEN
                if kind == exercise.family and len(ids) == 1
            ],
        )
        if texts
        else ()
    )


def _degrees(table):
    return np.c_[np.rad2deg(table.theta), table.d, table.a, np.rad2deg(table.alpha)].tolist()


def _order(exercise, right, variant, rng):
    """The letters of an order that is accepted, or of one that is not; items may come twice where
    there are more places than items or a right answer has them twice.
    """
    orders = list(
        product(exercise.items, repeat=exercise.size)
        if right
        else permutations(exercise.items, exercise.size)
    ) or list(product(exercise.items, repeat=exercise.size))
    ids = next(
        ids for ids in rng.permutation(orders).tolist() if bool(exercise.accepts(ids)) == right
    )
    letters = exercise.letters(variant)
    return [letters[key] for key in ids]


def _wrong(exercise, variant, rng):
    """(the planted mistake, None when nobody foresaw it; the code)."""
    if isinstance(exercise, Value):
        given = exercise.given(variant)
        right = np.asarray(exercise.answer(**given), dtype=float)
        known = [
            (mistake, value)
            for mistake, _, value in exercise.mistakes(**given)
            if not np.allclose(value, right, rtol=1e-2, atol=1e-2)
        ]
        mistake, value = (
            known[rng.integers(len(known))]
            if rng.random() < 0.85
            else (None, right + rng.normal(size=right.shape))
        )
        return mistake, repr(np.asarray(value, dtype=float).tolist())
    if isinstance(exercise, Function):
        texts = _programs(exercise)[1]
        return texts[rng.integers(len(texts))]
    if isinstance(exercise, Table):
        right = exercise.right_arm(variant).table
        versions = [
            (mistake, table)
            for mistake, _, table in wrong_tables(right)
            if table.convention == right.convention and not np.allclose(table.rows, right.rows)
        ]
        mistake, table = versions[rng.integers(len(versions))]
        return mistake, repr(_degrees(table))
    if isinstance(exercise, Order):
        return "some order", repr(_order(exercise, False, variant, rng))
    letters = exercise.letters(variant) | {"?": "?"}
    chosen = str(rng.choice([key for key in letters if key != exercise.correct]))
    return None if chosen == "?" else exercise.options[chosen].mistake, repr(letters[chosen])


class _Restyle(ast.NodeTransformer):
    """The same program in somebody else's hand: factors exchanged, results named before they are
    returned, tuples taken apart.
    """

    def __init__(self, rng):
        self.rng = rng

    def visit_BinOp(self, node):
        self.generic_visit(node)
        if isinstance(node.op, ast.Mult) and self.rng.random() < 0.5:
            node.left, node.right = node.right, node.left
        return node

    def visit_Return(self, node):
        self.generic_visit(node)
        if node.value is None or self.rng.random() < 0.5:
            return node
        name = str(self.rng.choice(["result", "answer", "whole", "out", "pose_of_end"]))
        return [
            ast.Assign([ast.Name(name, ast.Store())], node.value),
            ast.Return(ast.Name(name, ast.Load())),
        ]

    def visit_Assign(self, node):
        self.generic_visit(node)
        target, value = node.targets[0], node.value
        both = (
            isinstance(target, ast.Tuple)
            and isinstance(value, ast.Tuple)
            and all(isinstance(name, ast.Name) for name in target.elts)
        )
        if (
            not both
            or {n.id for n in ast.walk(value) if isinstance(n, ast.Name)}
            & {name.id for name in target.elts}
            or self.rng.random() < 0.5
        ):
            return node
        return [ast.Assign([name], part) for name, part in zip(target.elts, value.elts)]


def restyled(text, rng):
    """A program rewritten at random with the same results."""
    if "matrix" in text:  # there * is no product of entries
        return text
    return ast.unparse(ast.fix_missing_locations(_Restyle(rng).visit(ast.parse(text)))) + "\n"


class _Rename(ast.NodeTransformer):
    """Own names for the arguments and variables of functions: what a copyist changes."""

    def __init__(self, names):
        self.names = names

    def visit_Name(self, node):
        node.id = self.names.get(node.id, node.id)
        return node

    def visit_arg(self, node):
        node.arg = self.names.get(node.arg, node.arg)
        return node


def _renamed(code, k):
    if k % 2 == 0 or "def " not in code:
        return code
    tree = ast.parse(code)
    own = {
        node.id
        for node in ast.walk(tree)
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store)
    } | {node.arg for node in ast.walk(tree) if isinstance(node, ast.arg)}
    return (
        "# all my own work\n"
        + ast.unparse(_Rename({name: f"my_{name}" for name in own}).visit(tree))
        + "\n"
    )


def fill_in(notebook, plan):
    """A student's notebook: the handed-out one with the plan's code in the place of the stubs."""
    made = nbformat.from_dict(notebook)
    for cell, check in zip(made.cells, made.cells[1:]):
        key = cell.metadata.get("exercise")
        if key in plan.code:
            name = check.source.partition(", ")[2].rstrip(")")
            code = plan.code[key]
            cell.source = (
                f"{code}{name} = {defined}" if (defined := _defined(code)) else f"{name} = {code}"
            )
    return made


def _defined(code):
    functions = [node.name for node in ast.parse(code).body if isinstance(node, ast.FunctionDef)]
    return functions[-1] if functions else ""


def hand_in(folder, handed_out, made):
    """Write every student's files: a folder each, some spoiled, some late, one missing."""
    for k, plan in enumerate(made):
        own = Path(folder) / plan.student.student
        if k in MISSING:
            continue
        own.mkdir(parents=True)
        for path in sorted((Path(handed_out) / plan.student.student).glob("*.ipynb")):
            notebook = nbformat.read(path, as_version=4)
            text = nbformat.writes(notebook if k in UNTOUCHED else fill_in(notebook, plan)).encode()
            if k in LOOPING:
                text = json.dumps(_with_a_loop(json.loads(text))).encode()
            target = own / path.name
            target.write_bytes(SPOILED.get(k, text))
            moment = time.time() if k in LATE else time.time() - 5 * 86400
            os.utime(target, (moment, moment))


def _with_a_loop(notebook):
    cell = next(
        cell for cell in notebook["cells"] if cell["metadata"].get("exercise") in ("05.4", "06.2")
    )
    cell["source"] = (
        "def dh_transform(*row):\n    while True: pass\nforward_kinematics = dh_transform"
    )
    return notebook


def tally(results, made):
    """(wrong answers, named, planted mistakes of known kind, of these named as planted)."""
    planted = {plan.student.student: plan.planted for plan in made}
    wrong = [
        (mark, planted[graded.student].get(mark.exercise))
        for graded in results
        for mark in graded.marks
        if mark.status == "wrong"
    ]
    known = [(mark, mistake) for mark, mistake in wrong if mistake in catalogue()]
    rightly = sum(
        mark.mistake in catalogue() and catalogue()[mark.mistake].id == catalogue()[mistake].id
        for mark, mistake in known
    )
    return len(wrong), sum(mark.mistake is not None for mark, _ in wrong), len(known), rightly


COURSE = """late: {{percent_per_day: 10, floor: 50}}
limits: {{cell_seconds: {seconds}}}
lessons:
"""


def simulate(folder, lessons=("05", "06"), size=60, seed=7, jobs=1, seconds=8):
    """Hand out, answer, hand in, grade and report in a folder; (results, plans, the class report's
    path). A cell has so many seconds, and one student has an endless loop.
    """
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    # the same class every time
    (folder / "teacher.key").write_text(
        hashlib.sha256(f"class {seed}".encode()).hexdigest() + "\n", encoding="utf-8"
    )
    key, _ = key_of(folder / "teacher.key", folder / "handed-out")
    everybody = roster(size)
    due = (datetime.now(UTC) - timedelta(days=1.2)).isoformat(timespec="seconds")
    (folder / "course.yaml").write_text(
        COURSE.format(seconds=seconds)
        + "".join(f'  "{lesson}": {{due: {due}}}\n' for lesson in lessons)
    )
    settings = read_settings(folder / "course.yaml")
    release(folder / "handed-out", everybody, key, tuple(settings.lessons))
    made = plans(
        tuple(settings.lessons),
        size,
        seed,
        variants(key, [student.student for student in everybody]),
    )
    hand_in(folder / "handed-in", folder / "handed-out", made)
    results, planned = grade(
        folder / "handed-in",
        folder / "graded",
        roster=everybody,
        key=key,
        settings=settings,
        jobs=jobs,
    )
    report = publish(planned, results, everybody, folder / "graded")
    return results, made, report


def main():
    """Print what the report makes of the class."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("out", nargs="?", metavar="OUT", help="where the class is kept")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        begun = time.perf_counter()
        results, made, report = simulate(options.out or temporary, jobs=2)
        print(
            f"{len(results)} students, two lessons, in {time.perf_counter() - begun:.0f} s:"
            f" {dict(Counter(graded.status for graded in results))}"
        )
        wrong, named, known, rightly = tally(results, made)
        print(f"wrong answers: {wrong}, of which {named} have a name ({named / wrong:.0%})")
        print(
            f"planted mistakes of a known kind: {known}, of which {rightly} are named as planted"
            f" ({rightly / known:.0%})"
        )
        print(
            "items that look bad:",
            ", ".join(
                f"{item.exercise} ({item.discrimination:.2f})"
                for item in items(results)
                if item.suspect
            ),
            f"(planted: {BAD_QUESTION})",
        )
        print(
            "answers right for another's numbers:",
            ", ".join(f"{g.student} has those of {g.guess_of}" for g in results if g.guess_of),
            f"(planted: {COPIES})",
        )
        text = report.read_text(encoding="utf-8")
        print(
            "code alike:",
            re.findall(
                r"<tr><td>[^<]*\((s\d+)\) and [^<]*\((s\d+)\)</td><td class=\"n\">(\d+ %)", text
            ),
        )


if __name__ == "__main__":
    main()
