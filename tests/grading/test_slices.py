"""A statement read where it stands is the statement that the parser found."""

import json

import pytest

from dhlab.course.workspace import handed_out
from dhlab.grading.inside.cells import parsed
from dhlab.grading.inside.slices import statement, statements

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
