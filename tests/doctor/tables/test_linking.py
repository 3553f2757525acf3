"""Link functions that a program has and does not call: what they compute settles what is read."""

import numpy as np
import pytest

import dhlab as dh
from tests.oracles import shift, turn

ROWS = [(0.0, 0.31, 0.0, np.pi / 2), (0.4, 0.0, 0.27, 0.0), (0.0, 0.12, 0.05, 0.0)]
STANDARD = "[[c, -s*ca, s*sa, a*c], [s, c*ca, -c*sa, a*s], [0, sa, ca, d], [0, 0, 0, 1]]"
CRAIG = "[[c, -s, 0, a], [s*ca, c*ca, -sa, -d*sa], [s*sa, c*sa, ca, d*ca], [0, 0, 0, 1]]"
MATRIX = """    c, s, ca, sa = np.cos(t), np.sin(t), np.cos(w), np.sin(w)
    return np.array({})
"""
# columns w, a, d, t behind names that say nothing
LISTED = """
import numpy as np
v = [[np.pi / 2, 0, 0.31, 0], [0, 0.27, 0, 0.4], [0, 0.05, 0.12, 0]]
"""
BY_NUMBER = LISTED + "def f(i, q):\n    w, a, d, t = v[i]\n    t = t + q\n" + MATRIX
BY_ROW = LISTED + "def f(row, q):\n    w, a, d, t = row\n    t = t + q\n" + MATRIX
OF_OBJECT = """
import numpy as np
class Part:
    def __init__(self, w, a, d, t=0.0):
        self.w, self.a, self.d, self.t = w, a, d, t
    def f(self, q):
        t, w, a, d = self.t + q, self.w, self.a, self.d
{}
v = [Part(np.pi / 2, 0, 0.31), Part(0, 0.27, 0, 0.4), Part(0, 0.05, 0.12)]
"""
FORMS = {
    "by its number": BY_NUMBER,
    "by a row": BY_ROW,
    "by an object": OF_OBJECT.format(MATRIX.replace("    ", "        ")),
}


def is_arm(arm, convention):
    """Whether an arm's rows are these, multiplied out of elementary moves."""
    q = np.random.default_rng(6).uniform(-1, 1, (5, 3))
    expected = []
    for values in q:
        T = np.eye(4)
        for (theta, d, a, alpha), value in zip(ROWS, values):
            z, x = turn([0, 0, theta + value]) @ shift([0, 0, d]), shift([a, 0, 0])
            x = x @ turn([alpha, 0, 0])
            T = T @ (z @ x if convention == "standard" else x @ z)
        expected.append(T)
    return np.allclose(arm.forward(q), expected, rtol=0, atol=1e-9)


@pytest.mark.parametrize("matrix", ["standard", "craig"])
@pytest.mark.parametrize("form", FORMS)
def test_a_link_function_says_order_and_convention(form, matrix):
    """Called for each row, without a product in the text; joints' zeros may be a pose."""
    found = dh.recognise_table(FORMS[form].format(STANDARD if matrix == "standard" else CRAIG))
    assert {reading.arm.table.convention for reading in found.readings} == {matrix}
    assert "order" not in found.open
    assert any(is_arm(reading.arm, matrix) for reading in found.readings)


def test_a_link_function_that_is_called_is_asked_for_its_product():
    """What the program adds where it calls it, its function does not say."""
    text = BY_NUMBER.format(STANDARD)
    text += "def forward(q, robot):\n    return robot.chain([f(i, q[i] + 0.1) for i in range(3)])\n"
    found = dh.recognise_table(text)
    assert not any("called for each row" in str(reading) for reading in found.readings)


def test_a_row_less_one_is_not_the_last_one():
    """v[i - 1] is the last row for 0: such a function decides nothing."""
    text = BY_NUMBER.replace("v[i]", "v[i - 1]").replace("0.4]", "0]").format(STANDARD)
    found = dh.recognise_table(text)
    assert {len(reading.arm) for reading in found.readings} == {3}


def test_a_link_function_does_not_say_which_rows_have_a_joint():
    """It is asked as it was."""
    text = BY_ROW.format(STANDARD).replace("0.12, 0]]", "0.12, 0], [0, 0, 0.1, 0]]  # the flange")
    said = dh.recognise_table(text.replace("0.4]", "0]") + "# a robot with 3 joints\n")
    assert {len(reading.arm) for reading in said.readings} == {3, 4} and "row" in said.open
    with pytest.raises(ValueError, match="order"):
        dh.recognise_table(text + "# a robot with 3 joints\n")


def test_what_is_cut_out_of_a_class_is_computed():
    """Methods without their class, a library without its import, an angle that is calculated."""
    text = """
    def __init__(self):
        self.reach = [0.31, 0.27, 0.05, 0.12]
        self.bend = atan2(0.12, 0.16)
    def pose(self, q):
        self.rows = [[q[0], self.reach[0], 0, pi/2],
                     [q[1] + 0.4 + self.bend - self.bend, 0, self.reach[1], 0],
                     [q[2], self.reach[3], self.reach[2], 0]]
        T = np.eye(4)
        for t, d, a, w in self.rows:
            c, s, ca, sa = cos(t), sin(t), cos(w), sin(w)
            T = copy.deepcopy(np.matmul(T, %s))
        return T
"""
    found = dh.recognise_table(text % STANDARD)
    assert len(found.readings) == 1 and is_arm(found.arm, "standard")


def test_an_object_that_a_class_makes_of_itself_is_one():
    """As a text is pasted whose last lines stand too far to the right."""
    text = (
        BY_ROW.format(CRAIG).replace("def f", "def link")
        + """
class Arm:
    def __init__(self, rows):
        self.rows = rows
    def pose(self, q):
        T = np.eye(4)
        for row, value in zip(self.rows, q):
            T = T @ link(row, value)
        return T

    one = Arm(v)
"""
    )
    found = dh.recognise_table(text)
    assert len(found.readings) == 1 and is_arm(found.arm, "craig")


def test_the_product_counts_where_the_numbers_speak_against_the_order():
    """Turns in a column that the rows alone are read to have lengths in."""
    text = """
%         alpha     d      theta
DH = [    pi,       0,     0;    % base
          pi/2,     0.31,  0;
          pi/2,     0.27,  pi;
          0,        0.12,  pi ];
function T = fkin(q, DH)
    T = link(DH(1,3), DH(1,2), 0, DH(1,1));
    for i = 1:3
        T = T * link(q(i) + DH(i+1,3), DH(i+1,2), 0, DH(i+1,1));
    end
end
function T = link(theta, d, a, alpha)
    T = [cos(theta) -sin(theta)*cos(alpha)  sin(theta)*sin(alpha) a*cos(theta);
         sin(theta)  cos(theta)*cos(alpha) -cos(theta)*sin(alpha) a*sin(theta);
         0 sin(alpha) cos(alpha) d; 0 0 0 1];
end
"""
    rows = [(0, 0.31, 0, np.pi / 2), (np.pi, 0.27, 0, np.pi / 2), (np.pi, 0.12, 0, 0)]
    q = np.array([0.3, -0.7, 1.1])
    T = turn([np.pi, 0, 0])
    for (theta, d, _, alpha), value in zip(rows, q):
        T = T @ turn([0, 0, theta + value]) @ shift([0, 0, d]) @ turn([alpha, 0, 0])
    found = dh.recognise_table(text)
    assert len(found.readings) == 1, str(found)
    assert np.allclose(found.arm.forward(q), T, rtol=0, atol=1e-9)
