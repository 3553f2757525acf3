"""Programs whose chain is computed: the truth is a product that these tests multiply themselves."""

import numpy as np
import pytest

import dhlab as dh
from dhlab.doctor.tables.computed.chains import chain_of
from dhlab.doctor.tables.computed.languages.python import statements_of
from tests.oracles import shift, turn

STANDARD = """
def link(th, d, a, al):
    c, s, ca, sa = np.cos(th), np.sin(th), np.cos(al), np.sin(al)
    return np.array([[c, -s*ca, s*sa, a*c], [s, c*ca, -c*sa, a*s], [0, sa, ca, d], [0, 0, 0, 1]])
"""
CRAIG = """
def link(al, a, d, th):
    c, s, ca, sa = np.cos(th), np.sin(th), np.cos(al), np.sin(al)
    return np.array([[c, -s, 0, a], [s*ca, c*ca, -sa, -d*sa], [s*sa, c*sa, ca, d*ca], [0, 0, 0, 1]])
"""
QUARTER = np.pi / 2
BENT = [(0.0, 0.31, 0.0, QUARTER), (-QUARTER, 0.0, 0.27, 0.0), (0.3, 0.12, 0.05, -QUARTER)]


def pose(rows, q, convention="standard", letters=None, signs=None):
    """The product of rows theta, d, a, alpha at joint values, out of elementary moves."""
    T = np.eye(4)
    for k, (theta, d, a, alpha) in enumerate(rows):
        step = (signs or [1] * len(rows))[k] * q[k]
        slides = letters is not None and letters[k] == "P"
        theta, d = (theta, d + step) if slides else (theta + step, d)
        z, x = turn([0, 0, theta]) @ shift([0, 0, d]), shift([a, 0, 0]) @ turn([alpha, 0, 0])
        T = T @ (z @ x if convention == "standard" else x @ z)
    return T


def agrees(text, rows, **said):
    """Whether the one reading of a text is the arm of rows."""
    found = dh.recognise_table(text)
    assert len(found.readings) == 1, str(found)
    q = np.random.default_rng(3).uniform(-1, 1, (5, len(rows)))
    expected = [pose(rows, values, **said) for values in q]
    return np.allclose(found.arm.forward(q), expected, rtol=0, atol=1e-9)


COLUMNS_IN_A_LOOP = """
import numpy as np
twist = [90, 0, -90]
reach = {"base": 0, "upper": 270, "fore": 50}
up = np.array([310, 0, 120]) / 1000
def chain(values):
    pose = np.eye(4)
    for k, (length, w) in enumerate(zip(reach.values(), twist)):
        pose = pose @ link(values[k] + shift(k), up[k], length * 1e-3, w * np.pi / 180)
    return pose
def shift(k):
    if k == 1:
        return -np.pi / 2
    return 0.3 if k == 2 else 0
"""
CLASS = """
import numpy as np
class Joint:
    def __init__(self, up, out, twist, zero=0.0):
        self.up, self.out, self.twist, self.zero = up, out, twist, zero
    def pose(self, angle):
        return link(angle + self.zero, self.up, self.out, np.radians(self.twist))
class Arm:
    joints = [Joint(0.31, 0, 90), Joint(0, 0.27, 0, -np.pi / 2)]
    def __init__(self):
        self.all = self.joints + [Joint(0.12, 0.05, -90, zero=0.3)]
    def where(self, angles_deg):
        T = np.identity(4)
        for joint, angle in zip(self.all, np.deg2rad(angles_deg)):
            T = T.dot(joint.pose(angle))
        return T
"""
REDUCED = """
from functools import reduce
import numpy as np
def rows(q):
    return [[q[0], .31, 0, np.pi/2], [q[1] - np.pi/2, 0, .27, 0], [q[2] + .3, .12, .05, -np.pi/2]]
def forward(q):
    return reduce(np.matmul, [link(*row) for row in rows(q)])
"""
SYMBOLIC = """
import sympy as sp
import numpy as np
q1, q2, q3, L = sp.symbols('q1 q2 q3 L')
def link(th, d, a, al):
    return sp.Matrix([
        [sp.cos(th), -sp.sin(th)*sp.cos(al), sp.sin(th)*sp.sin(al), a*sp.cos(th)],
        [sp.sin(th), sp.cos(th)*sp.cos(al), -sp.cos(th)*sp.sin(al), a*sp.sin(th)],
        [0, sp.sin(al), sp.cos(al), d], [0, 0, 0, 1]])
T = link(q1, 0.31, 0, sp.pi/2) * link(q2 - sp.pi/2, 0, L, 0) * link(q3 + 0.3, 0.12, 0.05, -sp.pi/2)
T = sp.simplify(T.subs({L: 0.27}))
"""
BY_HAND = """
import numpy as np
def times(A, B):
    return [[sum(A[i][k] * B[k][j] for k in range(4)) for j in range(4)] for i in range(4)]
def forward(first, second, third):
    T = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    angles = [first, second, third]
    table = [(0, .31, 0, np.pi/2), (-np.pi/2, 0, .27, 0), (.3, .12, .05, -np.pi/2)]
    i = 0
    while i < len(table):
        zero, up, out, twist = table[i]
        T = times(T, link(angles[i] + zero, up, out, twist).tolist())
        i += 1
    return T
"""
ELEMENTARY = """
import numpy as np
def rz(t):
    R = np.array([[np.cos(t), -np.sin(t)], [np.sin(t), np.cos(t)]])
    return np.block([[R, np.zeros((2, 2))], [np.zeros((2, 2)), np.eye(2)]])
def rx(t):
    T = np.eye(4)
    T[1:3, 1:3] = [[np.cos(t), -np.sin(t)], [np.sin(t), np.cos(t)]]
    return T
def shifted(x, z):
    T = np.eye(4)
    T[:3, 3] = [x, 0, z]
    return T
def forward(q):
    T = np.eye(4)
    for zero, up, out, twist, angle in [(0, .31, 0, np.pi/2, q[0]), (-np.pi/2, 0, .27, 0, q[1]),
                                        (.3, .12, .05, -np.pi/2, q[2])]:
        T = T @ rz(angle + zero) @ shifted(0, up) @ shifted(out, 0) @ rx(twist)
    return T
"""
SLIDERS = """
import numpy as np
def shown(_):
    angles = [np.radians(slider.val) for slider in sliders]
    angles[1] -= np.pi / 2
    angles[2] += .3
    A = [link(angles[0], .31, 0, np.pi/2), link(angles[1], 0, .27, 0),
         link(angles[2], .12, .05, -np.pi/2)]
    draw(A[0] @ A[1] @ A[2])
"""


@pytest.mark.parametrize(
    "text",
    [COLUMNS_IN_A_LOOP, CLASS, REDUCED, BY_HAND, SLIDERS],
    ids=["columns", "class", "reduce", "by hand", "sliders"],
)
def test_a_program_is_read_by_what_it_multiplies(text):
    assert agrees(STANDARD + text, BENT)


@pytest.mark.parametrize("text", [SYMBOLIC, ELEMENTARY], ids=["symbolic", "elementary"])
def test_its_own_links_are_read(text):
    assert agrees(text, BENT)


def test_matrices_tell_the_convention():
    text = "import numpy as np" + CRAIG + """
def forward(q):
    sizes = dict(zip("xyz", (0.2, 0.3, 0.4)))
    T = link(0, 0, sizes["x"], q[0])
    for k, name in enumerate("yz", 1):
        T = T @ link(np.pi / 2 * (k == 1), sizes[name], 0.1 * k, q[k] - np.pi / 4)
    return T
"""  # fmt: skip
    rows = [(0, 0.2, 0, 0), (-np.pi / 4, 0.1, 0.3, QUARTER), (-np.pi / 4, 0.2, 0.4, 0)]
    assert agrees(text, rows, convention="craig")
    assert dh.recognise_table(text).arm.table.convention == "craig"


def test_a_joint_that_slides_and_one_that_counts_backwards():
    text = "import numpy as np" + STANDARD + """
def forward(first, lift, last):
    sizes = [0.3, 0.2, 0.15]
    parts = [link(-first, sizes[0], 0, np.pi/2), link(0, sizes[1] - lift, 0, 0)]
    parts.append(link(last, 0, sizes[2], 0))
    return np.linalg.multi_dot(parts)
"""  # fmt: skip
    rows = [(0, 0.3, 0, QUARTER), (0, 0.2, 0, 0), (0, 0, 0.15, 0)]
    assert agrees(text, rows, letters="RPR", signs=[-1, -1, 1])


def test_a_toolbox_robot_made_in_a_loop():
    text = """
import roboticstoolbox as rtb
from math import pi
class Own(rtb.DHRobot):
    def __init__(self):
        heights, reaches = [0.3, 0, 0.1], [0, 0.25, 0.15]
        parts = []
        for k in range(3):
            parts.append(rtb.RevoluteDH(d=heights[k], a=reaches[k], alpha=pi/2 if k == 0 else 0))
        super().__init__(parts, name="own")
"""
    rows = [(0, 0.3, 0, QUARTER), (0, 0, 0.25, 0), (0, 0.1, 0.15, 0)]
    assert agrees(text, rows)


POSED = """
import numpy as np
def forward(lengths, values):
    T = np.eye(4)
    for a, value in zip(lengths, values):
        T = T @ link(value, 0.1, a, 0)
    return T
q = [0.4, -0.7, 0.2]
print(forward([0.3, 0.25, 0.2], q))
"""


def test_the_values_of_joints_in_one_pose_are_no_zeros():
    assert agrees(STANDARD + POSED, [(0, 0.1, 0.3, 0), (0, 0.1, 0.25, 0), (0, 0.1, 0.2, 0)])


def test_quarter_turns_under_a_name_of_zeros_and_of_values_are_not_decided():
    said = (STANDARD + POSED).replace("q = [0.4, -0.7, 0.2]", "theta = [0, -np.pi/2, 0.2]")
    with pytest.raises(ValueError):
        dh.recognise_table(said.replace("0.2], q)", "0.2], theta)"))


def test_the_way_of_a_condition_that_nobody_knows_is_not_guessed():
    text = "import numpy as np" + STANDARD + CRAIG.replace("def link", "def modified") + """
def forward(q, kind):
    T = np.eye(4)
    for k, a in enumerate((0.3, 0.2)):
        T = T @ (link(q[k], 0.1, a, 1.2) if kind == "standard" else modified(1.2, a, 0.1, q[k]))
    return T
"""  # fmt: skip
    assert chain_of(text) is None
    assert chain_of(text.replace("q, kind)", "q, kind='standard')"))[0].convention == "standard"
    assert chain_of(text.replace("q, kind)", "q, kind='craig')"))[0].convention == "craig"
    printed = text.replace("    T =", "    if kind: print(q)\n    T =", 1)
    assert chain_of(printed.replace('kind == "standard"', "True")) is not None


@pytest.mark.parametrize("end", ["", "\nT = A1 @ A2 @", "\nT = A1 @ A2", "\nA4 = link(q[3], 0."])
def test_a_program_that_was_cut_off_is_no_shorter_arm(end):
    calls = "\n".join(f"A{k} = link(q[{k - 1}], 0.{k}, 0.2, 1.2)" for k in (1, 2, 3))
    text = f"import numpy as np{STANDARD}\n{calls}"
    assert len(chain_of(text)[0].rows) == 3
    found = chain_of(text + end)
    assert found is None or len(found[0].rows) == 3


def test_a_part_of_the_rows_that_is_multiplied_is_not_the_arm():
    text = "import numpy as np" + STANDARD + """
# standard DH, metres: theta, d, a, alpha
rows = [[0, 0.31, 0, np.pi/2], [0, 0, 0.27, 0], [0, 0.12, 0.05, 0], [0, 0.2, 0, np.pi/2]]
def wrist(q):
    T = np.eye(4)
    for k in range(3):
        T = T @ link(q[k], *rows[k][1:])
    return T
"""  # fmt: skip
    assert all(len(one.arm) == 4 for one in dh.recognise_table(text).readings)


def test_a_statement_in_a_loop_that_is_not_understood_leaves_the_others():
    text = "import numpy as np" + STANDARD + """
def jacobian(q):
    rows, T, J = [(.31, 0, np.pi/2), (0, .27, 0), (.12, .05, -np.pi/2)], np.eye(4), np.zeros((6, 3))
    for i in range(3):
        J[3:, i] = np.einsum('ij,j', T[:3, :3], [0, 0, 1]) @ np.nothing
        T = T @ link(q[i] + (0, -np.pi/2, .3)[i], *rows[i])
        del J
    return J
"""  # fmt: skip
    assert np.allclose(chain_of(text)[0].rows, BENT)
    failing = text.replace("rows[i]", "rows[i:][1]")
    assert chain_of(failing) is None


def test_functions_of_matlab_are_known_before_they_stand_there():
    calls = "T = link(q(1), .31, 0, pi/2) * link(q(2) - pi/2, 0, .27, 0);\n"
    links, _ = chain_of("% two links\n" + calls + LINK_IN_MATLAB)
    assert np.allclose(links.rows, BENT[:2])


UNDECIDED = {
    "coupled joints": "T = link(q[0], 0.3, 0, 1.2) @ link(q[1] - q[0], 0, 0.4, 0)",
    "a length that is not known": "T = link(q[0], 0.3, 0, 1.2) @ link(q[1], 0, reach, 0)",
    "a joint twice": "T = link(q[0], 0.3, 0, 1.2) @ link(q[0], 0, 0.4, 0)",
    "a factor that is not known": (
        "T = link(q[0], 0.3, 0, 1.2) @ link(q[1], 0, 0.4, 0) @ other.link(q[2])"
    ),
    "a named factor that is not known": """A1 = link(q[0], 0.3, 0, 1.2)
    A2 = link(q[1], 0, 0.4, 0)
    T = A1 @ A2 @ other.link(q[2])""",
    "as many joints as anybody likes": """T = np.eye(4)
    for angle in q:
        T = T @ link(angle, 0.1, 0.2, 0.3)""",
    "two arms": """T = link(q[0], 0.3, 0, 1.2) @ link(q[1], 0, 0.4, 0)
    return link(q[0], 0.2, 0, 1.2) @ link(q[1], 0, 0.5, 0)""",
    "a loop that fails in its last turn": """T = np.eye(4)
    for k in range(4):
        T = T @ link(q[k], [0.1, 0.2, 0.3][k], 0, 1.2)""",
}


@pytest.mark.parametrize("name", UNDECIDED)
def test_no_chain_where_a_part_is_not_known(name):
    text = f"import numpy as np{STANDARD}\ndef forward(q):\n    {UNDECIDED[name]}\n    return T\n"
    assert chain_of(text) is None


def test_what_is_written_and_not_computed_is_asked_about():
    text = "import numpy as np" + STANDARD + """
rows = [[0, 0.31, 0, np.pi/2], [0, 0, 0.27, 0], [0, 0.12, 0.05, 0]]  # theta, d, a, alpha
def forward(q):
    T = np.eye(4)
    for k, (zero, up, out, twist) in enumerate(rows):
        T = T @ link(q[k] + zero, up, out * 2 - 0.01, twist)
    return T
"""  # fmt: skip
    found = dh.recognise_table(text)
    rows = [(0, 0.31, -0.01, QUARTER), (0, 0, 0.53, 0), (0, 0.12, 0.09, 0)]
    q = np.array([0.3, -0.4, 0.5])
    assert any(np.allclose(one.arm.forward(q), pose(rows, q)) for one in found.readings)
    assert len(found.readings) == 1 or found.questions


def test_constant_matrices_at_the_ends_are_no_rows():
    text = "import numpy as np" + STANDARD + """
def forward(q):
    base = np.array([[0, -1, 0, 0.2], [1, 0, 0, 0], [0, 0, 1, 0.1], [0, 0, 0, 1]])
    sizes = (0.31, 0.27)
    return base @ link(q[0], sizes[0], 0, np.pi/2) @ link(q[1], 0, sizes[1], 0)
"""  # fmt: skip
    links, _ = chain_of(text)
    assert links.ends == ("base",)
    assert np.allclose(links.rows, [(0, 0.31, 0, QUARTER), (0, 0, 0.27, 0)])


SHIFTED = """
    turned[1] -= np.pi / 2
    turned[2] = turned[2] + .3
    sizes = [(.31, 0, np.pi/2), (0, .27, 0), (.12, .05, -np.pi/2)]
    return np.linalg.multi_dot([link(turned[i], *sizes[i]) for i in range(3)])
"""


@pytest.mark.parametrize(
    "begin",
    [
        "def forward(turned):",
        "def forward(q):\n    turned = q.copy()",
        "def forward(q):\n    turned = np.array(q)",
        "def forward(q):\n    turned = list(q[:3])",
        "def forward(q):\n    twice(q)\n    turned = q * 1.0\ndef twice(turned):",
        "def forward(q):\n    turned = np.zeros(3)\n    turned[:] = q",
        "def forward(q):\n    turned = np.radians(q[:3])",
    ],
)
def test_zeros_added_to_a_list_that_nobody_knows_are_no_less_added(begin):
    text = f"import numpy as np\n{STANDARD}\n{begin}{SHIFTED}"
    links, _ = chain_of(text)
    assert np.allclose(links.rows, BENT)


@pytest.mark.parametrize(
    "line", ["q[some(q)] -= 1.57", "q[:] = other(q)", "q[1:] -= 1.57", "q.sort()", "change(q)"]
)
def test_a_list_that_is_changed_in_a_way_that_is_not_known_gives_no_chain(line):
    text = f"""import numpy as np
{STANDARD}
def forward(q):
    {line}
    return link(q[0], 0.3, 0, 1.5) @ link(q[1], 0, 0.4, 0)
"""
    assert chain_of(text) is None or line in ("q.sort()", "change(q)")


LINK_IN_MATLAB = """
function T = link(th, d, a, al)
    T = [cos(th) -sin(th)*cos(al)  sin(th)*sin(al) a*cos(th);
         sin(th)  cos(th)*cos(al) -cos(th)*sin(al) a*sin(th);   % the second row
         0 sin(al) cos(al) d; 0 0 0 1];
end
"""
MATLAB = {
    "columns in a loop": """
function [T, all] = forward(q)
    twist = [90 0 -90]' * pi/180;
    sizes = [310, 0; 0, 270; 120, 50] / 1000; zero = [0, -pi/2, .3];
    T = eye(4); all = cell(1, 3);
    for k = 1:length(twist)
        all{k} = link(q(k) + zero(k), sizes(k, 1), sizes(k, end), twist(k));
        T = T * all{k};
    end
end
""",
    "cells multiplied afterwards": """
syms q1 q2 q3 real
rows = [q1 .31 0 pi/2; q2-pi/2 0 .27 0; q3+.3 .12 .05 -pi/2];
for i = 1:size(rows, 1)
    row = rows(i, :);
    A(:, :, i) = link(row(1), row(2), row(3), row(4));
end
T = A(:,:,1) * A(:,:,2) ...
    * A(:,:,3);
disp(simplify(T))
""",
    "an object": """
classdef Leg
    properties
        up = [0.31 0 0.12];
        out
    end
    methods
        function obj = Leg()
            obj.out = 10 .^ [-9 0 0] .* [0 0.27 0.05];
        end
        function T = where(obj, q)
            T = eye(4); i = 0;
            while i < 3
                i = i + 1;
                switch i
                    case 2
                        zero = -pi/2; w = 0;
                    case {1, 3}
                        zero = 0.3 * (i == 3); w = pi/2 * (2 - i);
                end
                T = T * obj.one(q(i) + zero, obj.up(i), obj.out(i), w);
            end
        end
        function A = one(~, th, d, a, al)
            A = link(th, d, a, al);
        end
    end
end
""",
}


@pytest.mark.parametrize("name", MATLAB)
def test_matlab_is_read_by_what_it_multiplies(name):
    links, _ = chain_of(LINK_IN_MATLAB + MATLAB[name])
    assert links.convention == "standard" and links.letters == ("R", "R", "R")
    assert np.allclose(links.rows, BENT, rtol=0, atol=1e-8)


def test_a_toolbox_robot_in_matlab_is_made_in_a_loop():
    text = """
heights = [0.3 0 0.1]; reaches = [0 0.25 0.15];
for k = 1:3
    L(k) = Link('d', heights(k), 'a', reaches(k), 'alpha', (k == 1) * pi/2, 'm', 3);
end
arm = SerialLink(L, 'name', 'own');
"""
    assert agrees(text, [(0, 0.3, 0, QUARTER), (0, 0, 0.25, 0), (0, 0.1, 0.15, 0)])


def test_a_toolbox_robot_with_a_length_that_nobody_knows_is_none():
    text = "% a robot\nL(1) = Link([0 L1 0 pi/2]);\nL(2) = Link([0 0 0.3 0]);\nR = SerialLink(L);\n"
    assert chain_of(text) is None
    assert chain_of("L1 = 0.2;\n" + text) is not None


@pytest.mark.parametrize(
    "line",
    ["x = zeros(1e6);", "x = 1:1e9;", "for i = 1:1e9, x = i; end", "x = " + "(" * 99 + "1;",
     "while true, x = 1; end", "for " * 200, "case 1 " * 200, "else " * 200, "(" * 1500,
     "[1 " * 600, "a'" * 900, "x = 9^9^9^9;", "system('true');", "x = [" + "1 " * 900 + "];"],
)  # fmt: skip
def test_hostile_matlab_ends_within_the_budget(line):
    assert chain_of(f"% a program\n{line}\n{LINK_IN_MATLAB}") is None


BRACES = {
    "C": """
#define L1 0.31
const double up[3] = {L1, 0, 0.12};
double out_[] = {0.0, 270 / 1000.0, 0.05};
static const float twist[3] = {M_PI / 2, 0.0f, -M_PI_2};
void link(double th, double d, double a, double al, double T[4][4]) {
  /* row by row */
  double c = cos(th), s = sin(th);
  T[0][0] = c; T[0][1] = -s * cos(al); T[0][2] = s * sin(al); T[0][3] = a * c;
  T[1][0] = s; T[1][1] = c * cos(al); T[1][2] = -c * sin(al); T[1][3] = a * s;
  T[2][0] = 0; T[2][1] = sin(al); T[2][2] = cos(al); T[2][3] = d;
  T[3][0] = T[3][1] = T[3][2] = 0; T[3][3] = 1;
}
void times(double A[4][4], double B[4][4], double C[4][4]) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; j++) {
      double sum = 0.0;
      for (int k = 0; k < 4; k++) sum += A[i][k] * B[k][j];
      C[i][j] = sum;
    }
}
void forward(const double q[3], double T[4][4]) {
  double A1[4][4], A2[4][4], A3[4][4], T12[4][4];
  link(q[0], up[0], out_[0], twist[0], A1);
  link(q[1] - M_PI / 2, up[1], out_[1], twist[1], A2);
  link(q[2] + 0.3, up[2], out_[2], twist[2], A3);
  times(A1, A2, T12);
  times(T12, A3, T);
}
""",
    "C++": """
#include <Eigen/Dense>
using namespace Eigen;
class Leg {
 public:
  Leg() { rows_ << 0, 0.31, 0, M_PI / 2, -M_PI / 2, 0, 0.27, 0, 0.3, 0.12, 0.05, -M_PI / 2; }
  Eigen::Matrix4d link(double th, double d, double a, double al) const {
    Matrix4d T = Matrix4d::Identity();
    T << cos(th), -sin(th) * cos(al), sin(th) * sin(al), a * cos(th),
         sin(th), cos(th) * cos(al), -cos(th) * sin(al), a * sin(th),
         0, sin(al), cos(al), d, 0, 0, 0, 1;
    return T;
  }
  Eigen::Matrix4d forward(const std::vector<double>& q) {
    std::vector<double> sizes = {0.31, 0.0, 0.12};
    const double reach[3] = {0, 0.27, 0.05};
    Matrix4d T = Matrix4d::Identity();
    for (size_t i = 0; i < sizes.size(); i++) {
      double zero = (i == 1) ? -M_PI / 2 : 0.3 * (i == 2);
      double al = i == 0 ? M_PI / 2 : (i == 2 ? -M_PI / 2 : 0.0);
      T *= link(q[i] + zero, sizes[i], reach[i], al);
    }
    return T;
  }
 private:
  Eigen::MatrixXd rows_;
};
""",
    "JavaScript": """
const sizes = [{d: 0.31, a: 0, alpha: 90}, {d: 0, a: 0.27, alpha: 0},
  {d: 0.12, a: 0.05, alpha: -90}];
function link(th, d, a, al) {
  const c = Math.cos(th), s = Math.sin(th), ca = Math.cos(al), sa = Math.sin(al);
  return [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]];
}
function multiply(A, B) {
  const C = [];
  for (let i = 0; i < 4; i++) {
    C[i] = [];
    for (let j = 0; j < 4; j++) {
      C[i][j] = 0;
      for (let k = 0; k < 4; k++) C[i][j] += A[i][k] * B[k][j];
    }
  }
  return C;
}
function forward(q) {
  let T = link(q[0], sizes[0].d, sizes[0].a, sizes[0].alpha * Math.PI / 180);
  const zeros = [0, -Math.PI / 2, 0.3];
  for (let i = 1; i < 3; i++) {
    const row = sizes[i];
    T = multiply(T, link(q[i] + zeros[i], row.d, row.a, row.alpha * Math.PI / 180));
  }
  return T;
}
""",
}


BRACES["three.js"] = """
const sizes = [[0.31, 0, 90], [0, 0.27, 0], [0.12, 0.05, -90]];
function pose(th, d, a, al) {
  const c = Math.cos(th), s = Math.sin(th), ca = Math.cos(al), sa = Math.sin(al);
  return new THREE.Matrix4().set(c, -s * ca, s * sa, a * c, s, c * ca, -c * sa, a * s,
    0, sa, ca, d, 0, 0, 0, 1);
}
function moved() {
  const zeros = [0, -Math.PI / 2, 0.3];
  const angles = [ref(0), ref(0), ref(0)];
  const T = new THREE.Matrix4();
  for (let i = 0; i < sizes.length; i++) {
    const [d, a, alpha] = sizes[i];
    T.multiply(pose(angles[i].value + zeros[i], d, a, THREE.MathUtils.degToRad(alpha)));
  }
  return T;
}
"""
BRACES["C# in Unity"] = """
struct Row { public float zero, up, reach; public float twist; }
Matrix4x4 Link(float th, float d, float a, float al) {
  Matrix4x4 m = Matrix4x4.identity;
  m.SetRow(0, new Vector4(Mathf.Cos(th), -Mathf.Sin(th) * Mathf.Cos(al), 0f, a * Mathf.Cos(th)));
  m.SetRow(1, new Vector4(Mathf.Sin(th), Mathf.Cos(th) * Mathf.Cos(al), 0f, a * Mathf.Sin(th)));
  m.m02 = Mathf.Sin(th) * Mathf.Sin(al); m.m12 = -Mathf.Cos(th) * Mathf.Sin(al);
  m.SetRow(2, new Vector4(0, Mathf.Sin(al), Mathf.Cos(al), d));
  return m;
}
Row[] rows = { {0f, 0.31f, 0f, 90f}, {-90f, 0f, 0.27f, 0f},
  {0.3f * Mathf.Rad2Deg, .12f, .05f, -90f} };
Matrix4x4 Forward(float[] angles) {
  Matrix4x4 T = Matrix4x4.identity;
  for (int i = 0; i < rows.Length; i++) {
    Row row = rows[i];
    T *= Link((angles[i] + row.zero) * Mathf.Deg2Rad, row.up, row.reach, row.twist * Mathf.Deg2Rad);
  }
  return T;
}
"""


@pytest.mark.parametrize("name", BRACES)
def test_a_program_with_braces_is_read_by_what_it_multiplies(name):
    links, _ = chain_of(BRACES[name])
    assert links.convention == "standard" and links.letters == ("R", "R", "R")
    assert np.allclose(links.rows, BENT, rtol=0, atol=1e-9)


def test_a_product_that_is_written_to_something_unknown_is_no_shorter_chain():
    text = BRACES["C"].replace("const double q[3], double T[4][4]", "const double q[3], Pose* T")
    assert chain_of(text) is None


@pytest.mark.parametrize(
    "line",
    ["while (true) { x = 1; }", "for (;;) {}", "for (int i = 0; i < 1e9; i++) x = i;",
     "double x[9999][9999];", "int f(int n) { return f(n + 1) + f(n); }", "x = " + "(" * 99 + "1;",
     "{" * 1500, "if (a) " * 300, "else " * 300, "a<b," * 450,
     "a ? b : " * 200, "system(\"true\");", "x = a ? b : " * 60 + "1;",
     "T << " + "1, " * 900 + "1;"],
)  # fmt: skip
def test_hostile_braces_end_within_the_budget(line):
    assert chain_of(f"const double a = 1;\nint b = 2;\n{line}\n") is None


HOSTILE = {
    "a power": "x = 10**10**10",
    "a long loop": "for i in range(10**9):\n    pass",
    "loops in loops": "for i in range(200):\n for j in range(200):\n  for k in range(200):\n   x",
    "a text repeated": "x = 'ab' * 10**9",
    "lists that double": "x = [1]\nwhile True:\n    x = x + x\n    if len(x) < 0: break",
    "a large array": "x = np.zeros((10**5, 10**5))",
    "recursion": "def f(n):\n    return f(n + 1) + f(n)\nf(0)",
    "deep brackets": "x = " + "(" * 110 + "1" + ")" * 110,
    "many signs": "x = " + "- " * 900 + "1",
    "numbers that grow": "x = 2\nfor i in range(100):\n    x = x * x * x",
    "a class of itself": "class A:\n    def __init__(self):\n        self.a = A()\nA()",
    "a shift": "x = 1 << 10**9",
    "a list in itself": "x = []\nx.append(x)\ny = np.array(x)\nprint(x == x)",
    "a lambda": "f = lambda f: f(f)\nf(f)",
    "attributes": "x = ().__class__.__bases__[0].__subclasses__()\nopen('/etc/passwd').read()",
    "importing": "import os\nos.system('true')\n__import__('os').system('true')\neval('1')",
}


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_text_ends_within_the_budget(name):
    text = f"import numpy as np\n{HOSTILE[name]}\n{STANDARD}"
    assert chain_of(text) is None
    with pytest.raises(ValueError, match="recognise_table: "):
        dh.recognise_table(text)


def test_what_stands_beside_hostile_lines_is_computed():
    text = f"import numpy as np\nx = 10**10**10\n{STANDARD}{REDUCED}"
    assert len(chain_of(text)[0].rows) == 3


def test_prompts_and_parts_of_programs_are_read():
    session = "\n".join(f">>> {line}" for line in ("import numpy as np", "a = [1, 2]"))
    assert len(statements_of(session)) == 2
    cut = "        self.a = [1, 2]\n\n    def where(self, q):\n        return q\n    def lost(self"
    assert [type(node).__name__ for node in statements_of("import numpy\n" + cut)]


ARMS_OF_LINKS = """L(1) = Link('d', 0.4, 'a', 0.1, 'alpha', -pi/2);
L(2) = Link('d', 0, 'a', 0.3, 'alpha', 0);
{before}
rob = SerialLink(L, 'name', 'two');
{after}
"""


@pytest.mark.parametrize(
    "before, after",
    [
        ("L(2).d = 3;", ""),
        ("L(2).offset = -pi/2;", ""),
        ("L(2).d = k;", ""),
        ("", "rob.links(2).d = 3;"),
    ],
)
def test_what_is_set_of_a_link_later_is_not_passed_over(before, after):
    plain = dh.recognise_table(ARMS_OF_LINKS.format(before="", after=""))
    try:
        found = dh.recognise_table(ARMS_OF_LINKS.format(before=before, after=after))
    except ValueError:
        return  # asked about, in a sentence
    same = [np.array_equal(one.arm.table.rows, plain.arm.table.rows) for one in found.readings]
    assert not all(same), str(found)
