"""A statement read where it stands is the statement that the parser found; which functions of a
lesson only show something.
"""

import json

import pytest

from dhlab.course.workspace import handed_out
from dhlab.grading.inside.reading.cells import parsed, plain
from dhlab.grading.inside.reading.demonstrations import print_of, showing
from dhlab.grading.inside.reading.magics import without_magics
from dhlab.grading.inside.reading.notebook import Cell
from dhlab.grading.inside.reading.slices import statement, statements
from dhlab.grading.inside.shell import run_cell

ODD = [
    "x = 1; y = 'é'; z = x + y",
    "def f(x):\r\n  return x\r\ny = f(3)",
    "x = (1,\n 2); y = 3\\\n + x",
    "\x0cx = 1\n\x0cy = x",
    "@np.vectorize\ndef f(a): return b\n@known\nclass A(B):\n    x = y\n",
    "s = '''a\nb\x0b\u2028c'''; t = s",
    "if a: b = 1\nelse:\n  c = d",
    "%time x = 1\ny = x",
    "%%time\nx = 1\ny = x",
    "x = 1\ry = x",
    "ä = 1; b = ä; c = [q for q in b if (w := q)]",
    "async def f(): await g()\nfor i in r: pass",
    "lambda: x\n'a' 'b' if c else d",
]


@pytest.mark.parametrize("source", ODD)
def test_an_odd_statement_reads_as_if_it_were_written_anew(source):
    nodes = parsed(source, "<cell>")
    assert nodes and statements(3, source) == [statement(3, node) for node in nodes]


@pytest.mark.parametrize(
    "source",
    [
        "x = 1  # why 1?",
        "# why?\nx = 1",
        "x = '#'  # what's that?",
        "x = '''\n# why?\n'''",
        "np.sin?",
        "'#'.join?",
        "x = !ls",
        "%time y = 1  # why?",
    ],
)
def test_a_question_in_a_comment_is_no_magic_and_every_other_is(source):
    assert plain(source).strip() == without_magics(source).strip()


def test_so_does_every_statement_of_the_lessons():
    found = [
        ("".join(cell["source"]), path.name)
        for path in sorted(handed_out().glob("[0-9][0-9]*.ipynb"))
        for cell in json.loads(path.read_text(encoding="utf-8"))["cells"]
        if cell["cell_type"] == "code"
    ]
    for source, name in found:
        anew = [statement(0, node) for node in parsed(source, "<cell>")]
        assert statements(0, source) == anew, (name, source)
    assert len(found) > 300


LESSON = """import numpy as np
def shows(rows):
    for row in rows:
        print(np.round(row))
def counts(rows): total.append(1)
def sets(rows): rows[0] = 1
def notes(rows): check("07.1", rows)
def follows(rows): return mine(rows)
def binds(rows):
    global total
    total = rows"""


def showing_in(*cells, handed_out=LESSON):
    return showing([Cell(source, []) for source in cells], {print_of(handed_out)})


def test_a_function_of_the_lesson_that_changes_nothing_only_shows():
    assert showing_in(LESSON, "total = []; mine = shows") == {"shows"}


@pytest.mark.parametrize(
    "own", ["shows = print", "def shows(rows): check('07.1', rows)", "shows.x = 1"]
)
def test_a_function_that_a_student_has_touched_is_called(own):
    assert not showing_in(LESSON, own)
    assert not showing_in(LESSON + "\n" + own)


def test_only_the_calls_whose_answer_nobody_takes_are_left_out():
    seen = []
    space = {"shows": seen.append, "other": seen.append}
    source = "shows(1); x = shows(2); other(3); print(shows(4)); shows(other(5)); y = [shows(6)]"
    run_cell(source, "<cell>", space, {"shows"})
    assert seen == [2, 3, 5, None, 6]  # what is printed alone nobody takes either


def test_what_a_cell_shows_at_its_end_is_kept_as_jupyter_keeps_it():
    space = {}
    for source in (
        "x = 3\nx + 1",
        "y = _",
        "print(5)",
        "9;",
        "x = 2",
        "z = _",
        "_ = 5",
        "8",
        "own = _",
    ):
        run_cell(source, "<cell>", space)
    assert (space["y"], space["z"], space["own"]) == (4, 4, 5)
