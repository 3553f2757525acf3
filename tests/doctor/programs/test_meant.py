"""What the writer of a wrong program meant is among the changes that are tried."""

import numpy as np
import pytest

from dhlab.doctor.programs.source.changes.edits import changes_of
from dhlab.doctor.programs.source.held import kinds_of
from dhlab.doctor.programs.source.memory import remembering
from dhlab.doctor.programs.source.text import Text, text_of

SPACE = {"np": np, "sin": np.sin, "cos": np.cos}
LOOP = "def f(rows, q):\n    T = np.eye(4)\n    for i, w in enumerate(q):\n        {}\n    return T"
BOX = "class Box:\n    def run(self, q):\n        {}\n\n\ndef f(q):\n    return Box().run(q)"
LINK = "def f(t, d, a, al):\n    c, s = np.cos(t), np.sin(t)\n    {}\n    return c, s"
ARM = "L1, L2 = 0.4, 0.3\n\n\ndef f(q):\n    {}"
DATA = "class L:\n    d: float\n    a: float\n\n\ndef f(g: L):\n    {}"
TURN = "def go(x):\n    return x\n\n\ndef turn(t, s):\n    return t * s\n\n\n"


@pytest.mark.parametrize(
    "around, wrong, meant",
    [
        # a number left in where a name belongs
        (LOOP, "T = T @ link(i, 0.5)", "T = T @ link(i, w)"),
        (LOOP, "T = T @ rot(rows[i][0] + 1.57)", "T = T @ rot(rows[i][0] + w)"),
        (LOOP, "a = 0.3 + rows[i][2]", "a = w + rows[i][2]"),
        (LINK, "p = [0.3 * c, 0.3 * s, d]", "p = [a * c, 0.3 * s, d]"),
        # always the same joint
        (LOOP, "T = T @ link(q[1])", "T = T @ link(q[i])"),
        (LOOP, "T = T @ rot(rows[i][0] + q[0])", "T = T @ rot(rows[i][0] + q[i])"),
        (LOOP, "T = T @ rot(rows[0][0] + w)", "T = T @ rot(rows[i][0] + w)"),
        (LOOP, "t = q[-1]", "t = q[i]"),
        # a product that is not kept
        (BOX, "self.T = self.link(q)", "self.T = self.T @ (self.link(q))"),
        (BOX, "self.pose = turn(q) @ move(q)", "self.pose = self.pose @ (turn(q) @ move(q))"),
        (BOX, "self.M[0] = turn(q)", "self.M[0] = self.M[0] @ (turn(q))"),
        (TURN + LOOP, "T = link(w)", "T = turn(T, link(w))"),
        # constants, roughly and in other powers of ten
        (LINK, "f = 180.0 / 3.1", "f = 180.0 / 3.141592653589793"),
        (LINK, "t = t * 0.017", "t = t * 0.017453292519943295"),
        (LINK, "t = t / 57.0", "t = t / 57.29577951308232"),
        (LINK, "t = 3 * t / 180", "t = 3.141592653589793 * t / 180"),
        (LINK, "d, a = d / 1000, a / 100", "d, a = d / 100, a / 100"),
        (LINK, "a *= 0.01", "a *= 0.001"),
        (LINK, "d = 10 * d", "d = 1000 * d"),
        (LINK, "p = np.array([a, 0, d]) / 100", "p = np.array([a, 0, d]) / 1000"),
        # the name of another number, and none
        (ARM, "return link(0, L1, 0, q[1])", "return link(0, L2, 0, q[1])"),
        (ARM, "return link(0, L1, 0, q[0])", "return link(0, 0, 0, q[0])"),
        (ARM, "return L1 * cos(q[0])", "return L2 * cos(q[0])"),
        (ARM, "x = L2 + L2", "x = L1 + L2"),
        # a sign that is handed over and not used
        (LOOP.replace("i, w", "s, w"), "t = rows[0][0] + q[0]", "t = rows[0][0] + s * q[0]"),
        ("def f(x, th=0, s=1):\n    {}", "return th + x", "return th + s * x"),
        ("def f(q, sign):\n    {}", "t = 0.2 + q", "t = 0.2 + sign * q"),
        ("def f(q, w):\n    {}", "t = [0, q[0], 1]", "t = [0, w * q[0], 1]"),
        # an angle of several that was not converted
        (LINK, "t, al = t, np.deg2rad(al)", "t, al = (t * DEG), np.deg2rad(al)"),
        (LINK, "t, d, al = t, d, al / 57.3", "t, d, al = (t * DEG), d, al / 57.3"),
        (LOOP, "t = rows[i][0] + w", "t = (rows[i][0] * DEG) + w"),
        (TURN + LOOP, "T = turn(w, 1)", "T = turn((w * DEG), 1)"),
        # an attribute for its neighbour
        (BOX, "return cos(g.al) * g.a + g.d", "return cos(g.al) * g.d + g.d"),
        (BOX, "return self.a + self.b * self.a", "return self.a + self.b * self.b"),
        (LOOP, "T = move(w.x, w.x, w.y)", "T = move(w.x, w.y, w.y)"),
        (DATA, "return g.d", "return g.a"),
        # cosines and sines of a whole formula; a factor that is lost
        (LINK, "y = cos(al) * d + sin(al) * a", "y = sin(al) * d + cos(al) * a"),
        (LINK, "x, y = d, sin(al) - cos(t)", "x, y = d, cos(al) - sin(t)"),
        (LINK, "return np.sin(t) * np.cos(al)", "return np.cos(t) * np.sin(al)"),
        (LINK, "T[0, 3] = cos(t) + sin(t)", "T[0, 3] = sin(t) + cos(t)"),
        (LINK, "R = [[a * c, d]]", "R = [[a * c, c * d]]"),
        (LINK, "R = [a * s, -c]", "R = [a * s, a * -c]"),
        (LINK + " * d", "r = np.cos(t)", "r = s * np.cos(t)"),
        (LINK, "r = [c * np.sin(al), s]", "r = [c * np.sin(al), np.sin(al) * s]"),
        # functions that are handed on
        (LOOP, "T = reduce(np.multiply, T)", "T = reduce(np.matmul, T)"),
        (LOOP, "c, s = map(np.cos, q), map(np.cos, q)", "c, s = map(np.cos, q), map(np.sin, q)"),
        (LOOP, "c, s = cos, cos", "c, s = cos, sin"),
        (LOOP, "T = reduce(np.add, T)", "T = reduce(np.matmul, T)"),
        # names inside a lambda
        ("g = lambda t, d: {}\n\n\ndef f(t, d):\n    return g(t, d)", "[sin(d), d]", "[sin(t), d]"),
        (LOOP, "g = lambda t, d: [cos(d), d]", "g = lambda t, d: [cos(t), d]"),
        # words: kinds of joints, keys
        (ARM, "return walk('RRRP', q)", "return walk('RRPP', q)"),
        (ARM, "return go('turn', 1), go('slide', 1)", "return go('turn', 1), go('turn', 1)"),
        (LOOP, "a = w['a'] + w['a'] * w['d']", "a = w['a'] + w['d'] * w['d']"),
        (ARM, "return link(q[0], False)", "return link(q[0], True)"),
        # a sliding joint's value, and its function
        (ARM, "rows = [[0, 1, 0], [q[1], 2, 0]]", "rows = [[0, 1, 0], [0, 2 + q[1], 0]]"),
        (ARM, "return link(q[2], 0.1, 0, 0)", "return link(0, 0.1 + q[2], 0, 0)"),
        (TURN + ARM, "return go(1) @ turn(0.2, 0)", "return go(1) @ go(0.2)"),
        (TURN + ARM, "return [turn(1, 2), go(3)]", "return [go(2), go(3)]"),
        # tables that are written as one text
        (ARM, "t = '''\n0 0.3 0 90\n90 0 0.65 180'''", "t = '''\n0 0.3 0 90\n90 0 0.65 -180'''"),
        (ARM, "t = '0 -0.3 0 90; 0 1 2 3'", "t = '0 0.3 0 90; 0 1 2 3'"),
        (ARM, "t = '''0, 0.3\n0.4, 1'''", "t = '''0.3, 0\n0.4, 1'''"),
        (ARM, "t = '''0 0.3\n0.4 1'''", "t = '''0 1\n0.4 0.3'''"),
    ],
)  # fmt: skip
def test_what_was_meant_is_tried(around, wrong, meant):
    meant = around.format(meant.replace("DEG", "(3.141592653589793 / 180)"))
    text = Text(around.format(wrong), "f", SPACE | {"L1": 0.4, "L2": 0.3})
    assert any(text.edited(change) == meant for change in changes_of(text))


def test_no_function_is_put_where_a_number_stands():
    text = Text("def f(x):\n    g = lambda y: y\n    return [x, g(x)]", "f", {})
    kinds = kinds_of(text.function(), 1.0)
    assert kinds["g"] == {"function"} and kinds["x"] == {0}
    wrong = "def f(x):\n    g = lambda y: y\n    return [g, g(x)]"
    assert any(text.edited(change) == wrong for change in changes_of(text))
    assert not any(text.edited(change) == wrong for change in changes_of(text, kinds=kinds))


class Called:
    """An object that is called, as a program may be one."""

    def __call__(self, q):
        return 2 * q


called = Called()


def test_objects_that_are_called_have_a_text():
    text = text_of(called)
    assert text.name == "called" and text.entry is None and text.function()(3) == 6


def test_no_function_is_called_that_does_more_than_calculate():
    program = (
        "def g(x):\n    return x\n\n\ndef h(x):\n    {}\n\n\ndef f(x, y):\n    return g(x + y)"
    )
    for does, many in (("return 2 * x", 1), ("open(x)", 0), ("robot.move(x)", 0)):
        text = Text(program.format(does), "f", {"robot": pytest})
        tried = [change for change in changes_of(text) if b"h(x + y)" in change[0].new]
        assert len(tried) == many, does


def test_what_is_remembered_is_not_changed_by_who_gets_it():
    text = Text(
        "def g(x):\n    return x + 1\n\n\ndef f(x):\n    y = g(x)\n    y += 5\n    return y",
        "f",
        {},
    )
    memory = {}
    f = text.function(memory=memory)
    assert f(np.zeros(2)).tolist() == f(np.zeros(2)).tolist() == [6, 6] and len(memory) == 1
    changed = next(c for c in changes_of(text) if "x - 1" in text.edited(c))
    assert text.function(changed, memory)(np.zeros(2)).tolist() == [4, 4]
    assert remembering(len, memory)("ab") == 2
