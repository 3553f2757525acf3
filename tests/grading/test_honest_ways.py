"""Right answers written in ways that hide, from who only reads a notebook, what a program depends
on: they keep their marks in a room that runs no more than that.
"""

import ast
import sys
from pathlib import Path

import nbformat
import pytest

sys.path.insert(0, str(Path(__file__).parent))
import corpus
from corpus import answer, closed, first
from corpus_making import RIGHT_FORM
from judging import marks_of

from dhlab.grading.grade import grade
from dhlab.grading.inside.reading.slices import needed, statement
from dhlab.grading.judging.programs import ABSENT
from dhlab.grading.settings import Settings

FORM = "".join(f"    {line}\n" for line in RIGHT_FORM.splitlines())
LINK = f"def form(theta, d, a, alpha):\n{FORM}"
IN_CLASS = "".join(f"    {line}\n" for line in LINK.replace("form(", "form(self, ").splitlines())
MOVES = """def move(kind, v):
    T, c, s = np.eye(4), np.cos(v), np.sin(v)
    i, j = {"z": (0, 1), "x": (1, 2)}[kind[1]]
    if kind[0] == "r":
        T[i, i] = T[j, j] = c
        T[i, j], T[j, i] = -s, s
    else:
        T["xyz".index(kind[1]), 3] = v
    return T
STEPS = [["rz", 1], ["tz", 2], ["tx", 3], ["rx", 4]]
for step in STEPS:
    step[1] -= 1
first = STEPS[0]
first.append("about z")"""


def out_of_order(notebook, facts):
    """The check was written above, and run after, the cell with the program."""
    cells = notebook["cells"]
    at = [
        next(k for k, cell in enumerate(cells) if found(cell))
        for found in (
            lambda cell: cell["metadata"].get("exercise") == "05.6",
            lambda cell: cell["source"].startswith('check("05.6"'),
        )
    ]
    cells[at[0]], cells[at[1]] = cells[at[1]], cells[at[0]]


def in_every_dress(notebook, facts):
    answer(
        "05.5",
        "from fractions import Fraction\nfrom decimal import Decimal\n"
        "origin = [Fraction(float(origin[0])), Decimal(float(origin[1])), np.array(origin[2])]",
    )(notebook, facts)
    closed(
        "计数 = zähle()\nif (n := 计数) < 0: raise ValueError(f'{n=}')\n"
        "return functools.reduce(np.matmul, ziehe(theta, d, a, alpha))",
        "import functools\nimport sympy as sp\nzahl: int = 0\n"
        "def zähle() -> int:\n    global zahl\n    zahl += 1\n    return zahl\n"
        f"def 连杆矩阵(θ: float, d: float, a: float, α: float) -> np.ndarray:\n"
        f"    theta, alpha = θ, α\n{FORM}\n"
        "x = sp.symbols('x')\none = sp.lambdify(x, x * sp.eye(4), 'numpy')\n"
        "def ziehe(*row):\n    yield np.einsum('ij,jk->ik', 连杆矩阵(*row), np.asarray(one(1)))\n"
        "    yield np.block([[np.eye(3), np.zeros((3, 1))], [np.zeros((1, 3)), np.ones((1, 1))]])",
    )(notebook, facts)


PAGE = LINK + "E = np.zeros((4, 4))\ndef page(M, k): M[k, k] = 1\n"
BY_E = "(theta, d, a, alpha):\n    return E @ form(theta, d, a, alpha)\n"


def several(*answers):
    """Several exercises of a notebook, each answered in a way of its own."""

    def make(notebook, facts):
        for key, source in answers:
            answer(key, source)(notebook, facts)

    return make


ADDED = several(
    (
        "05.1",
        "import contextlib\nKNOWN = {}\ndef add(name, f): KNOWN[name] = f\n"
        "for name, f in [('cos', np.cos)]:\n    add(name, f)\n"
        "if 'sin' not in KNOWN:\n    with contextlib.suppress(ValueError):\n"
        "        add('sin', np.sin)\n"
        "def rot_x(alpha):\n    c, s = KNOWN['cos'](alpha), KNOWN['sin'](alpha)\n"
        "    return np.array([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])",
    ),
    ("05.4", f"{PAGE}[page(E, k) for k in range(4)]\ndef dh_transform{BY_E}"),
    (
        "05.6",
        f"{PAGE}res = np.matmul(np.eye(4), 3 * np.eye(4), out=E)\n"
        f"_ = np.fill_diagonal(E, 1)\ndef dh_closed{BY_E}",
    ),
    # this only who runs it sees
    ("05.7", f"{PAGE}done = [*map(page, [E] * 4, range(4))]\ndef dh_from_a_blog{BY_E}"),
)
OF_OTHER_TYPES = several(
    ("05.2", "from enum import Enum\nclass Rule(str, Enum):\n    mine = rule\nrule = Rule.mine"),
    (
        "05.3",
        "from collections import deque\nclass Letter(str):\n    __str__ = None\n"
        "order = deque([Letter(x) for x in order])",
    ),
    ("05.5", "origin = dict(enumerate(origin)).values()"),
)
DECORATED = several(
    (
        "05.4",
        "from quick_one import prange, vectorize\nimport bars.tqdm\n"
        f"{LINK}@vectorize(['f8(f8)'])\ndef one(x): return 1 if x > 0 else 0\n"
        "def dh_transform(*row):\n    T = np.eye(4)\n    for _ in prange(1):\n"
        "        for A in bars.tqdm([form(*row)], leave=False):\n            T = T @ A\n"
        "    return T * one(np.ones(4))",
    ),
    (
        "05.6",
        f"import quick_one as nb\n@nb.njit\n{LINK}@nb.njit(nb.float64[:, :](nb.f8), cache=True)\n"
        "def dh_closed(theta, d, a, alpha): return form(theta, d, a, alpha)",
    ),
)


def with_magics(notebook, facts):
    first(f"%%writefile kin.py\nimport numpy as np\n{LINK}")(notebook, facts)
    several(
        (
            "05.1",
            "with open('mine.py', 'w') as file:\n    file.write('def same(x): return x')\n"
            "import mine\ndef rot_x(alpha):\n    c, s = mine.same(np.cos(alpha)), np.sin(alpha)\n"
            "    return np.array([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]])",
        ),
        (
            "05.4",
            "%%capture kept\n%matplotlib inline\n!echo begun\n"
            f"{LINK}t = %timeit -o -n 1 -r 1 form(0, 0, 0, 0)\ndef dh_transform(*row):\n"
            "    return form(*row)",
        ),
        ("05.6", "import kin\ndef dh_closed(*row): return kin.form(*row)"),
        ("05.7", "%run kin.py\ndef dh_from_a_blog(*row): return form(*row)"),
    )(notebook, facts)


WAYS = {
    "changed by a helper": ADDED,
    "with magics and modules": with_magics,
    "of other types": OF_OTHER_TYPES,
    "decorated by what is not there": DECORATED,
    "a register": closed(
        "return KNOWN['form'](theta, d, a, alpha)",
        "KNOWN = {}\ndef register(f):\n    KNOWN[f.__name__] = f\n    return f\n@register\n" + LINK,
    ),
    "a register by name": closed(
        "return KNOWN['dh'](theta, d, a, alpha)",
        "KNOWN = {}\ndef named(name):\n    def note(f):\n        KNOWN[name] = f\n"
        f"        return f\n    return note\n@named('dh')\n{LINK}",
    ),
    "a table changed in a loop": answer(
        "05.4",
        f"{MOVES}\ndef dh_transform(*row):\n    T = np.eye(4)\n"
        "    for kind, place, *_ in STEPS:\n        T = T @ move(kind, row[place])\n"
        "    assert len(STEPS[0]) == 3\n    return T",
    ),
    "subclasses that note themselves": closed(
        "return Kind.known[0]().form(theta, d, a, alpha)",
        "class Kind:\n    known = []\n    def __init_subclass__(cls): Kind.known.append(cls)\n"
        f"class Standard(Kind):\n{IN_CLASS}",
    ),
    "a function for each type": closed(
        "return power(form(theta, d, a, alpha))",
        f"import functools\n{LINK}@functools.singledispatch\ndef power(x): raise TypeError(x)\n"
        "@power.register\ndef _(x: np.ndarray): return x",
    ),
    "another name for a list": closed(
        "return found[0](theta, d, a, alpha)", f"found = []\nmine = found\n{LINK}mine.append(form)"
    ),
    "an answer of a method that nobody needs": closed(
        "return found[-1](theta, d, a, alpha)", f"{LINK}found = [form, print]\nlast = found.pop()"
    ),
    "cells out of order": out_of_order,
    "in every dress": in_every_dress,
}


@pytest.mark.cage
def test_right_answers_keep_their_marks(tmp_path):
    for name, make in WAYS.items():
        corpus.put(tmp_path / "class" / name, make, {})
    results, _ = grade(tmp_path / "class", tmp_path / "out", settings=Settings(cage=None))
    assert {one.student: corpus.lost(one) for one in results} == {name: set() for name in WAYS}


def test_a_plain_run_takes_the_same_types():
    notebook = corpus.solved()
    OF_OTHER_TYPES(notebook, {})
    assert {mark.status for mark in marks_of(nbformat.from_dict(notebook))} == {"right"}


@pytest.mark.cage
def test_who_is_wrong_is_told_what_a_plain_run_tells(tmp_path):
    halved = PAGE.replace("= 1", "= 2") + "done = [*map(page, [E] * 4, range(4))]\n"
    compared = (
        "import dhlab as dh\narm = dh.Arm(dh.DHTable.standard([[0, 0, 0, 0]], angle='rad'))\n"
        "np.testing.assert_allclose(arm.forward([0]), np.eye(4))\n"
    )
    wrong = several(
        ("05.4", f"{halved}def dh_transform{BY_E}"),
        ("05.6", f"{compared}def dh_closed(*row): return np.zeros((4, 4))"),
    )
    corpus.put(tmp_path / "class" / "ada", wrong, {})
    ((found,), _) = grade(tmp_path / "class", tmp_path / "out", settings=Settings(cage=None))
    notebook = corpus.solved()
    wrong(notebook, {})
    plain = {mark.exercise: mark for mark in marks_of(nbformat.from_dict(notebook))}
    for mark in found.marks:
        if mark.points < mark.of:
            assert mark.headline == plain[mark.exercise].headline
    assert corpus.lost(found) >= {"05.4", "05.6"}


@pytest.mark.cage
def test_who_uses_a_package_that_is_not_there_is_told(tmp_path):
    missing = several(
        ("05.1", "import robotlib\nrot_x = robotlib.turn"),
        ("05.2", "del rule\nnp.eye(4) @ robotlib.link(0, 0, 0, 0)"),
        (
            "05.4",
            "import roboticstoolbox as rtb\ndef dh_transform(theta, d, a, alpha):\n"
            "    return rtb.RevoluteDH(d=d, a=a, alpha=alpha).A(theta).A",
        ),
        ("05.5", "from robotlib import origin"),
        ("05.6", "def dh_closed(*row):\n    import roboticstoolbox\n    return 0"),
        ("05.7", "def dh_from_a_blog(*row):\n    for _ in bar([0]):\n        return np.eye(3)"),
    )

    def make(notebook, facts):
        first("from bars import bar")(notebook, facts)
        missing(notebook, facts)

    corpus.put(tmp_path / "class" / "ada", make, {})
    ((found,), _) = grade(tmp_path / "class", tmp_path / "out", settings=Settings(cage=None))
    said = {mark.exercise: mark for mark in found.marks if mark.points < mark.of}
    assert "is not there where it is graded (roboticstoolbox)" in said["05.4"].headline
    assert "is not there where it is graded" in said["05.6"].next
    assert "what a module gives that is not there where it is graded" in said["05.1"].headline
    assert {said[key].next for key in ("05.1", "05.2")} == {ABSENT}
    assert "module_that_is_not_there" in str(said["05.5"])
    assert said["05.7"].headline == "the answer has the shape 3×3, expected 4×4"


@pytest.mark.parametrize(
    "source, wanted",
    [
        ("for row in table: row[0] = 1", "table"),
        ("for k, row in enumerate(table.rows): row.append(k)", "table"),
        ("last = table.pop()", "table"),
        ("table = []\nother = table\nother += [1]", "table"),
        ("part = table[0]\npart[1] = 2", "table"),
        ("@table.register\ndef f(): pass", "table"),
        ("class Two(table): pass", "table"),
        ("for k in range(4): f(table, k)", "table"),
        ("for row in table: f(row)", "table"),
        ("[f(table, k) for k in range(4)]", "table"),
        ("if ready: f(table)", "table"),
        ("try:\n    f(table)\nexcept ValueError: pass", "table"),
        ("with np.errstate(): f(table)", "table"),
        ("_ = f(table)", "table"),
        ("def f(): g(table)\nf()", "table"),
        ("T = np.add(a, b, out=table)", "table"),
    ],
)
def test_what_changes_a_name_is_taken(source, wanted):
    found = [statement(0, node) for node in ast.parse(source).body]
    assert needed(found, {wanted}) == found


@pytest.mark.parametrize(
    "source",
    [
        "for row in table: print(row)",
        "T = f(table)",
        "for k in range(4): print(table[k])",
        "for k in range(4): f(np.eye(k))",
        "pi = np.pi\npi = 3",
        "class Two(dict): pass",
        "@functools.cache\ndef f(): pass",
    ],
)
def test_what_changes_nothing_is_not(source):
    found = [statement(0, node) for node in ast.parse(source).body]
    assert needed(found, {"table", "np"}) == []
