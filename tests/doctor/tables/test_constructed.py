"""What programs set in constructors, records and parameters is known to their products."""

import numpy as np
import pytest

import dhlab as dh

ENTRIES = """cos(t), -sin(t)*cos(w), sin(t)*sin(w), a*cos(t),
       sin(t), cos(t)*cos(w), -cos(t)*sin(w), a*sin(t),
       0, sin(w), cos(w), d,
       0, 0, 0, 1"""
QUARTER = np.pi / 2
ROWS = [(0, 0.31, 0, QUARTER), (QUARTER, 0, 0.27, 0), (0, 0, 0.12, 0)]

TEXTS = {
    "a matrix by reference": """
const float a[] = {0, 0.27f, 0.12f};
const float d[] = {0.31f, 0, 0};
const float w[] = {PI/2, 0, 0};
const float zero[] = {0, PI/2, 0};
float q[3] = {0, PI/4, -PI/2};  // where it starts
void link(float t, float a, float d, float w, Matrix<4, 4>& H) {
  H = {ENTRIES};
}
void where(float* q_now, float& x) {
  Matrix<4,4> T = {1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1};
  Matrix<4,4> one;
  for (int i = 0; i < 3; i++) {
    link(q_now[i] + zero[i], a[i], d[i], w[i], one);
    T = T * one;
  }
  x = T(0,3);
}
""",
    "lengths in a constructor's list": """
  Eigen::Matrix4d link(double t, double d, double a, double w) const {
    Eigen::Matrix4d T;
    T << ENTRIES;
    return T;
  }
  Eigen::Matrix4d fk(double q1, double q2, double q3) const {
    return link(q1, lift_, 0, M_PI/2) * link(q2 + M_PI/2, 0, upper_, 0) * link(q3, 0, fore_, 0);
  }
private:
  double lift_;
  double upper_, fore_;
};
Arm::Arm(int id) : Node("arm"), id_(id), lift_(0.31), upper_{0.27}, fore_(0.12)
{
}
""",
    "lengths in a record": """
struct Lengths {
  double lift = 310.0;
  double upper = 270.0;
  double fore = 120.0;
};
Eigen::Matrix4d fk(const Lengths& has, const std::array<double, 3>& q) {
  const double lift = has.lift / 1000.0;
  Eigen::Matrix4d A, B, C;
  A << cos(q[0]), 0, sin(q[0]), 0, sin(q[0]), 0, -cos(q[0]), 0, 0, 1, 0, lift, 0, 0, 0, 1;
  B << -sin(q[1]), -cos(q[1]), 0, -has.upper / 1000.0 * sin(q[1]),
       cos(q[1]), -sin(q[1]), 0, has.upper / 1000.0 * cos(q[1]), 0, 0, 1, 0, 0, 0, 0, 1;
  C << cos(q[2]), -sin(q[2]), 0, has.fore / 1000.0 * cos(q[2]),
       sin(q[2]), cos(q[2]), 0, has.fore / 1000.0 * sin(q[2]), 0, 0, 1, 0, 0, 0, 0, 1;
  return A * B * C;
}
""",
    "the joints' values in a record": """
const arm = { lift: 0.31, upper: 0.27, fore: 0.12, q1: 30 * (pi / 180), q2: 0.4, q3: -0.2 };
const q1 = arm.q1;
const q2 = arm.q2;
function link(t, d, a, w) {
  return matrix([[cos(t), -sin(t)*cos(w), sin(t)*sin(w), a*cos(t)],
    [sin(t), cos(t)*cos(w), -cos(t)*sin(w), a*sin(t)], [0, sin(w), cos(w), d], [0, 0, 0, 1]]);
}
const one = link(q1, arm.lift, 0, pi / 2);
const two = multiply(one, link(q2 + pi / 2, 0, arm.upper, 0));
const three = multiply(two, link(arm.q3, 0, arm.fore, 0));
""",
}
LINK = """
import numpy as np
from dataclasses import dataclass
def link(t, d, a, w):
    c, s, cw, sw = np.cos(t), np.sin(t), np.cos(w), np.sin(w)
    return np.array([[c, -s*cw, s*sw, a*c], [s, c*cw, -c*sw, a*s], [0, sw, cw, d], [0, 0, 0, 1]])
"""
TEXTS |= {
    "the one table for a parameter": LINK
    + """
def pose(dh_rows, q):
    T = np.eye(4)
    for k in range(len(dh_rows)):
        t, d, a, w = dh_rows[k]
        T = T @ link(t + q[k], d, a, w)
    return T
ARM = [[0, 0.31, 0, np.pi/2], [np.pi/2, 0, 0.27, 0], [0, 0, 0.12, 0]]  # the last is the hand
""",
    "an object that needs nothing": LINK
    + """
@dataclass
class Piece:
    d: float
    a: float
    w: float
    zero: float
    low: float
PIECES = (Piece(0.31, 0, np.pi/2, 0, -1), Piece(0, 0.27, 0, np.pi/2, -2), Piece(0, 0.12, 0, 0, -1))
@dataclass
class Arm:
    pieces: tuple = PIECES
    name: str = "small"
def poses(arm: Arm, q):
    T, found = np.eye(4), []
    for value, one in zip(np.asarray(q), arm.pieces):
        T = T @ link(value + one.zero, one.d, one.a, one.w)
        found.append(T.copy())
    return found
""",
    "a function for each link": LINK
    + """
LEAN = np.arctan2(1, 0)
def T_01(angle):
    return link(np.deg2rad(angle), 0.31, 0, np.pi/2)
def T_12(angle):
    return link(np.deg2rad(angle) + LEAN, 0, 0.27, 0)
def T_23(angle):
    return link(np.deg2rad(angle), 0, 0.12, 0)
""",
    "types in the rows": """
for i in range(n):
    p = rows[i]
    t = p['theta'] + (q[i] if p['type'] == 'revolute' else 0)
    d = p['d'] + (q[i] if p['type'] == 'prismatic' else 0)
    T = T @ link(t, d, p['a'], p['alpha'])   # Rz(theta) Tz(d) Tx(a) Rx(alpha), standard DH
rows = [
    {'theta': 0, 'd': 0.31, 'a': 0, 'alpha': np.pi/2, 'type': 'revolute'},
    {'theta': np.pi/2, 'd': 0, 'a': 0.27, 'alpha': 0, 'type': 'revolute'},
    {'theta': 0, 'd': 0, 'a': 0.12, 'alpha': 0, 'type': 'revolute'},
]
""",
}


@pytest.mark.parametrize("name", TEXTS)
def test_what_is_set_elsewhere_is_known_to_the_product(name):
    found = dh.recognise_table(TEXTS[name].replace("ENTRIES", ENTRIES))
    assert len(found.readings) == 1, str(found)
    table = found.arm.table
    assert table.convention == "standard" and table.joints == "RRR"
    assert np.allclose(table.rows, ROWS, rtol=0, atol=1e-9), str(found.arm)
    assert list(found.arm.sign) == [1, 1, 1]


def test_zeros_of_a_size_that_is_not_known_are_zeros():
    found = dh.recognise_table("""
a = [0, 0.27, 0.12];
d = [0.31, 0, 0];
alpha = [pi/2, 0, 0];
arm = SerialLink([zeros(3,1) d' a' alpha'], 'standard');
arm.offset = zeros(1, size(a, 2));
""")
    assert len(found.readings) == 1 and not found.arm.table.theta.any()


def test_numbered_members_are_links_of_the_class():
    found = dh.recognise_table("""
class DHLink {
  float r, alpha, d;
public:
  DHLink(float rValue, float alphaValue, float dValue) {
    r = rValue; alpha = alphaValue; d = dValue;
  }
};
Arm() :
  link1(0.0f, PI / 2.0f, 0.31f),
  link2(0.27f, 0.0f, 0.0f),
  link3(0.12f, 0.0f, 0.0f)
""", convention="standard")  # fmt: skip
    rows = found.arm.table.rows
    assert np.allclose(rows[:, 1:], np.array(ROWS)[:, 1:], rtol=0, atol=1e-9)


FIELDS = """DH(1).a = 0; DH(1).alpha = pi/2; DH(1).d = 0.31;
DH(2).a = 0.27; DH(2).alpha = 0; DH(2).d = 0;
DH(3).a = 0.12; DH(3).alpha = 0; DH(3).d = 0;
"""
MADE = """for i = 1:3
    links{i} = Link('revolute', 'd', DH(i).d, 'a', DH(i).a, 'alpha', DH(i).alpha, 'm', M(i));
end
"""
SYMBOLS = """
    q1, q2, q3, d1, a2 = symbols("q1 q2 q3 d1 a2")
    s = {q1: q1, q2: q2 + pi/2, d1: 0.31, a2: 0.27, q3: 0}
    def link(t, d, a, w):
        T = Matrix([[cos(t), -sin(t)*cos(w), sin(t)*sin(w), a*cos(t)],
                    [sin(t), cos(t)*cos(w), -cos(t)*sin(w), a*sin(t)],
                    [0, sin(w), cos(w), d], [0, 0, 0, 1]])
        return T.subs(s)
    T0_1 = link(q1, d1, 0, pi/2)
    T1_2 = link(q2, 0, a2, 0)
    T2_G = link(q3, 0, 0.12, 0)
"""


@pytest.mark.parametrize(
    "before",
    ["DH = struct('d', cell(1,3), 'a', cell(1,3));", "DH = load('arm.mat');", "DH = [];", ""],
)
def test_fields_of_records_in_an_array_count_from_one_whoever_made_it(before):
    text = f"{before}\n{FIELDS}{MADE}arm = SerialLink([links{{:}}], 'name', 'it');\n"
    table = dh.recognise_table(text).arm.table
    assert np.allclose(table.rows, np.multiply(ROWS, [0, 1, 1, 1]))


@pytest.mark.parametrize("one, two", [("L1", "L2"), ("L(1)", "L(2)")])
def test_links_that_no_robot_takes_are_in_the_order_of_their_names(one, two):
    text = f"rows = [0 0.31 0 pi/2; 0 0 0.27 0];\n{one} = Link([rows(1,:) 0 pi]);\n"
    table = dh.recognise_table(text + f"{two} = Link([rows(2,:) 0 -pi/2]);").arm.table
    assert np.allclose(table.rows, [[np.pi, 0.31, 0, QUARTER], [-QUARTER, 0, 0.27, 0]])


def test_what_is_put_in_for_a_joint_is_its_zero_or_fixes_it_where_others_stay():
    found = dh.recognise_table(SYMBOLS)
    assert len(found.arm) == 2 and len(found.readings) == 1
    q = np.random.default_rng(3).uniform(-1, 1, (4, 2))
    whole = dh.Arm(dh.DHTable.standard(ROWS, angle="rad"))
    assert np.allclose(found.arm.forward(q), whole.forward(np.column_stack([q, np.zeros(4)])))


QUOTED = """
rows = [{"t": "q1", "d": 0.31, "a": 0, "w": pi/2}, {"t": "q2 + pi/2", "d": 0, "a": 0.27, "w": 0}]
def fk():
    T = eye(4)
    for row in rows:
        t, d, a, w = READ(row["t"]), row["d"], row["a"], row["w"]
        T = T @ array([[cos(t), -sin(t)*cos(w), sin(t)*sin(w), a*cos(t)],
                       [sin(t), cos(t)*cos(w), -cos(t)*sin(w), a*sin(t)],
                       [0, sin(w), cos(w), d], [0, 0, 0, 1]])
    return T
"""


@pytest.mark.parametrize("read", ["eval", "sympify", "parse_expr"])
def test_an_expression_in_quotes_that_a_program_evaluates_keeps_its_zero(read):
    table = dh.recognise_table(QUOTED.replace("READ", read)).arm.table
    assert np.allclose(table.rows, ROWS[:2])


def test_a_zero_in_quotes_that_somebody_elses_function_reads_is_not_left_out():
    with pytest.raises(ValueError, match="recognise_table"):
        dh.recognise_table(QUOTED.replace("READ", "my_own"))
