"""One arm in the styles of programs: what holds a row, what multiplies the links. The arm's numbers
stand here apart from the programs, so that the truth needs no reader.
"""

import numpy as np
import pytest

from dhlab import recognise_table
from dhlab.arm import Arm
from dhlab.table import DHTable

RIGHT = Arm(
    DHTable.standard(
        [(0, 0.25, 0, np.pi / 2), (0, 0, 0.32, 0), (np.pi / 2, 0, 0.21, 0)], angle="rad"
    )
)
Q = np.random.default_rng(4).uniform(-1, 1, (5, 3))
ENTRIES = "[{c}, -{s}*k, {s}*w, a*{c}], [{s}, {c}*k, -{c}*w, a*{s}], [0, w, k, d], [0, 0, 0, 1]"
MATRIX = ENTRIES.format(c="c", s="s")
BRACES = MATRIX.replace("[", "{").replace("]", "}")

NAMED_TUPLES = f"""
from collections import namedtuple
from math import cos, sin, pi
Row = namedtuple("Row", "zero d a twist")
rows = [Row(0, 0.25, 0, pi / 2), Row(0, 0, 0.32, 0), Row(pi / 2, 0, 0.21, 0)]
def mul(A, B):
    return [[sum(A[i][k] * B[k][j] for k in range(4)) for j in range(4)] for i in range(4)]
def step(row, q):
    zero, d, a, twist = row
    c, s, k, w = cos(row.zero + q), sin(row.zero + q), cos(twist), sin(twist)
    return [{MATRIX}]
def fk(qs):
    out = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
    for row, q in zip(rows, qs):
        out = mul(out, step(row, q))
    return out
"""
ROTATIONS = """
import numpy as np
from scipy.spatial.transform import Rotation as R
def dh(theta, d, a, alpha):
    T = np.eye(4)
    T[:3, :3] = (R.from_euler('z', theta) * R.from_euler('x', alpha)).as_matrix()
    T[:3, 3] = [a * np.cos(theta), a * np.sin(theta), d]
    return T
def robot(q):
    links = dh(q[0], 0.25, 0, np.pi/2), dh(q[1], 0, 0.32, 0), dh(q[2] + np.pi/2, 0, 0.21, 0)
    return np.einsum('ij,jk->ik', np.einsum('ij,jk->ik', links[0], links[1]), links[2])
"""
PICKED = f"""
import numpy as np
P = np.array([0, 0.25, 0, np.pi/2, 0, 0, 0.32, 0, np.pi/2, 0, 0.21, 0]).reshape(3, 4)
def A(t, d, a, al):
    c, s, k, w = np.cos(t), np.sin(t), np.cos(al), np.sin(al)
    return np.array([{MATRIX}])
def forward(q):
    p = P.copy()
    p[[0, 1, 2], 0] += np.array(q)[[0, 1, 2]]
    return A(*p[0]) @ A(*p[1]) @ A(*p[2])
"""
GENERATED = f"""
import numpy as np
class Arm:
    joints = [dict(d=0.25, a=0, tilt=90, zero=0), dict(d=0, a=0.32, tilt=0, zero=0),
              dict(d=0, a=0.21, tilt=0, zero=90)]
    def matrices(self, q):
        for joint, angle in zip(self.joints, q):
            yield self.matrix(angle + np.radians(joint["zero"]), joint)
    def matrix(self, t, joint):
        d, a, al = joint["d"], joint["a"], np.radians(joint["tilt"])
        c, s, k, w = np.cos(t), np.sin(t), np.cos(al), np.sin(al)
        return np.array([{MATRIX}])
    def pose(self, q):
        T = np.eye(4)
        for A in self.matrices(q):
            T = T @ A
        return T
"""
CELLS = """
function T = arm(q)
  rows = {0, 0.25, 0, 90; 0, 0, 0.32, 0; 90, 0, 0.21, 0};
  T = eye(4);
  for k = 1:size(rows, 1)
    [t, d, a, w] = rows{k, :};
    T = T * one(q(k) + deg2rad(t), d, a, deg2rad(w));
  end
end
function M = one(t, d, a, w)
  M = [cos(t) -sin(t)*cos(w) sin(t)*sin(w) a*cos(t)
       sin(t) cos(t)*cos(w) -cos(t)*sin(w) a*sin(t)
       0 sin(w) cos(w) d
       0 0 0 1];
end
"""
RECORDS = """
clear
L(1) = struct('a', 0, 'w', 90, 'd', 0.25, 'q0', 0);
L(2) = struct('a', 0.32, 'w', 0, 'd', 0, 'q0', 0);
L(3) = struct('a', 0.21, 'w', 0, 'd', 0, 'q0', 90);
q = [10 20 30];
T = eye(4);
for i = 1:3
    p = L(i);
    t = q(i) + p.q0;
    T = T * [cosd(t), -sind(t)*cosd(p.w), sind(t)*sind(p.w), p.a*cosd(t);
        sind(t), cosd(t)*cosd(p.w), -cosd(t)*sind(p.w), p.a*sind(t);
        0, sind(p.w), cosd(p.w), p.d;
        0, 0, 0, 1];
end
"""
FIELDS = """
function T = arm(q)
    s(1).d = 0.25; s(1).a = 0;    s(1).w = pi/2; s(1).q0 = 0;
    s(2).d = 0;    s(2).a = 0.32; s(2).w = 0;    s(2).q0 = 0;
    s(3).d = 0;    s(3).a = 0.21; s(3).w = 0;    s(3).q0 = pi/2;
    T = eye(4);
    for i = 1:numel(s)
        T = T * trotz(q(i) + s(i).q0) * transl(0, 0, s(i).d) * transl(s(i).a, 0, 0) * trotx(s(i).w);
    end
end
"""
STATIC = """
classdef arm < handle
    properties
        a = [0 0.32 0.21];
        d = [0.25 0 0];
        w = [pi/2 0 0];
    end
    methods
        function T = fk(obj, q)
            T = eye(4);
            for i = 1:3
                T = T * obj.A(q(i) + (i == 3)*pi/2, obj.d(i), obj.a(i), obj.w(i));
            end
        end
    end
    methods (Static)
        function M = A(t, d, a, w)
            M = [cos(t) -cos(w)*sin(t) sin(w)*sin(t) a*cos(t);
                 sin(t) cos(w)*cos(t) -sin(w)*cos(t) a*sin(t);
                 0 sin(w) cos(w) d; 0 0 0 1];
        end
    end
end
"""
POINTERS = f"""
#define D2R(x) ((x) * M_PI / 180.0)
typedef struct {{ float d, a, al; }} joint_t;
static const joint_t arm[3] = {{
  {{ .d = 0.25f, .a = 0.f, .al = D2R(90) }}, {{ .d = 0.f, .a = 0.32f, .al = 0.f }},
  {{ .d = 0.f, .a = 0.21f, .al = 0.f }}, }};
enum {{ FIRST, SECOND, THIRD }};
static const float home[3] = {{ [FIRST] = 0.f, [SECOND] = 0.f, [THIRD] = M_PI_2 }};
static void link(const joint_t *j, float t, float out[4][4]) {{
  float c = cosf(t), s = sinf(t), k = cosf(j->al), w = sinf(j->al), a = j->a, d = j->d;
  float m[4][4] = {{{BRACES}}};
  memcpy(out, m, sizeof(m));
}}
static void mul(float x[4][4], float y[4][4], float r[4][4]) {{
  for (int i = 0; i < 4; i++)
    for (int j = 0; j < 4; j++) {{
      r[i][j] = 0;
      for (int k = 0; k < 4; k++) r[i][j] += x[i][k] * y[k][j];
    }}
}}
void fk(const float *q, float T[4][4]) {{
  float A[4][4], tmp[4][4];
  link(&arm[0], q[0] + home[0], T);
  for (int i = 1; i < 3; i++) {{
    link(&arm[i], q[i] + home[i], A);
    mul(T, A, tmp);
    memcpy(T, tmp, sizeof(tmp));
  }}
}}
"""
ANGLE_AXIS = """
Eigen::Affine3d step(double theta, double d, double a, double alpha) {
  return Eigen::Affine3d(Eigen::AngleAxisd(theta, Eigen::Vector3d::UnitZ())
      * Eigen::Translation3d(a, 0, d) * Eigen::AngleAxisd(alpha, Eigen::Vector3d::UnitX()));
}
Eigen::Affine3d solve(const Eigen::VectorXd& q) {
  Eigen::Affine3d T = Eigen::Affine3d::Identity();
  T = T * step(q(0), 0.25, 0.0, M_PI / 2);
  T = T * step(q(1), 0.0, 0.32, 0.0);
  T = T * step(q(2) + M_PI / 2, 0.0, 0.21, 0.0);
  return T;
}
"""
MAPPED = f"""
const DEG = Math.PI / 180;
const chain = [
  {{ d: 250, a: 0, twist: 90, zero: 0 }}, {{ d: 0, a: 320, twist: 0, zero: 0 }},
  {{ d: 0, a: 210, twist: 0, zero: 90 }},
].map(l => ({{ ...l, twist: l.twist * DEG, zero: l.zero * DEG, d: l.d / 1000, a: l.a / 1000 }}));
const dot = (r, B, j) => r.reduce((s, v, k) => s + v * B[k][j], 0);
const mul = (A, B) => A.map((r, i) => B[0].map((_, j) => dot(r, B, j)));
const link = ({{ d, a, twist, zero }}, q) => {{
  const [c, s] = [Math.cos(q + zero), Math.sin(q + zero)];
  const [k, w] = [Math.cos(twist), Math.sin(twist)];
  return [{MATRIX}];
}};
export const forward = (q) => chain.map((l, i) => link(l, q[i])).reduce(mul);
"""
ARRAYS_OF_ZEROS = f"""
public class Kinematics {{
  private static final double[][] P = {{ {{0, 0.25, 0, Math.PI / 2}}, {{0, 0, 0.32, 0}},
                                         {{Math.PI / 2, 0, 0.21, 0}} }};
  public static double[][] forward(double[] q) {{
    double[][] t = identity();
    for (int i = 0; i < P.length; i++)
      t = times(t, link(P[i][0] + q[i], P[i][1], P[i][2], P[i][3]));
    return t;
  }}
  static double[][] identity() {{
    double[][] e = new double[4][4];
    for (int i = 0; i < 4; i++) e[i][i] = 1.0;
    return e;
  }}
  static double[][] times(double[][] x, double[][] y) {{
    double[][] r = new double[4][4];
    for (int i = 0; i < 4; i++)
      for (int j = 0; j < 4; j++)
        for (int k = 0; k < 4; k++) r[i][j] += x[i][k] * y[k][j];
    return r;
  }}
  static double[][] link(double t, double d, double a, double al) {{
    double c = Math.cos(t), s = Math.sin(t), k = Math.cos(al), w = Math.sin(al);
    return new double[][] {{ {BRACES} }};
  }}
}}
"""
BLOCKS = """
Eigen::Matrix4d link(double t, double d, double a, double al) {
  Eigen::Matrix3d R;
  R = Eigen::AngleAxisd(t, Eigen::Vector3d::UnitZ()).toRotationMatrix()
      * Eigen::AngleAxisd(al, Eigen::Vector3d::UnitX()).toRotationMatrix();
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  T.block<3, 3>(0, 0) = R;
  T.block<3, 1>(0, 3) = Eigen::Vector3d(a * cos(t), a * sin(t), d);
  return T;
}
Eigen::Vector3d position(const Eigen::VectorXd& q) {
  Eigen::Matrix4d T = link(q(0), 0.25, 0, M_PI / 2) * link(q(1), 0, 0.32, 0);
  T = T * link(q(2) + M_PI / 2, 0, 0.21, 0);
  return T.block<3, 1>(0, 3);
}
"""
FILLED_ROWS = """
struct DhRow { double theta, d, a, alpha; };
Eigen::Matrix4d toMatrix(const DhRow& r, double q) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  const double c = cos(r.theta + q), s = sin(r.theta + q), k = cos(r.alpha), w = sin(r.alpha);
  m.row(0) << c, -s * k, s * w, r.a * c;
  m.row(1) << s, c * k, -c * w, r.a * s;
  m.row(2) << 0, w, k, r.d;
  return m;
}
Eigen::Matrix4d fk(const std::vector<double>& q) {
  static const std::vector<DhRow> rows{{0, 0.25, 0, M_PI_2}, {0, 0, 0.32, 0}, {M_PI_2, 0, 0.21, 0}};
  Eigen::Matrix4d T = Eigen::Matrix4d::Identity();
  for (size_t i = 0; i < rows.size(); ++i) T = T * toMatrix(rows[i], q[i]);
  return T;
}
"""
DERIVED = """
public class ArmFK : MonoBehaviour {
  public float[] jointAngles = new float[3];
  private readonly float[] d = { 0.25f, 0f, 0f };
  private readonly float[] a = { 0f, 0.32f, 0.21f };
  private readonly float[] alpha = { 90f, 0f, 0f };
  Matrix4x4 Link(int i) {
    float t = (jointAngles[i] + (i == 2 ? 90f : 0f)) * Mathf.Deg2Rad;
    float c = Mathf.Cos(t), s = Mathf.Sin(t);
    float k = Mathf.Cos(alpha[i] * Mathf.Deg2Rad), w = Mathf.Sin(alpha[i] * Mathf.Deg2Rad);
    Matrix4x4 m = Matrix4x4.identity;
    m.SetRow(0, new Vector4(c, -s * k, s * w, a[i] * c));
    m.SetRow(1, new Vector4(s, c * k, -c * w, a[i] * s));
    m.SetRow(2, new Vector4(0, w, k, d[i]));
    return m;
  }
  void Update() {
    Matrix4x4 T = Matrix4x4.identity;
    for (int i = 0; i < 3; i++) T *= Link(i);
    transform.position = T.GetColumn(3);
  }
}
"""
TYPED = f"""
interface Link {{ a: number; alpha: number; d: number; theta: number }}
const links: Link[] = [
  {{ a: 0, alpha: Math.PI / 2, d: 0.25, theta: 0 }}, {{ a: 0.32, alpha: 0, d: 0, theta: 0 }},
  {{ a: 0.21, alpha: 0, d: 0, theta: Math.PI / 2 }},
];
function T(l: Link, q: number): number[][] {{
  const c = Math.cos(q + l.theta), s = Math.sin(q + l.theta), a = l.a, d = l.d;
  const k = Math.cos(l.alpha), w = Math.sin(l.alpha);
  return [{MATRIX}];
}}
function times(A: number[][], B: number[][]): number[][] {{
  return A.map((row) => B[0].map((_, j) => row.reduce((sum, v, k) => sum + v * B[k][j], 0)));
}}
export function fk(q: number[]): number[][] {{
  let M = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];
  for (const [i, l] of links.entries()) {{
    M = times(M, T(l, q[i]));
  }}
  return M;
}}
"""
STYLES = {
    "Python, named tuples": NAMED_TUPLES, "Python, SciPy's rotations": ROTATIONS,
    "Python, indices in a list": PICKED, "Python, a generator": GENERATED,
    "MATLAB, cells": CELLS, "MATLAB, records": RECORDS,
    "MATLAB, records by fields": FIELDS, "MATLAB, static methods": STATIC, "C, pointers": POINTERS,
    "C++, AngleAxis": ANGLE_AXIS, "JavaScript, map and reduce": MAPPED,
    "Java, arrays of zeros": ARRAYS_OF_ZEROS, "C++, blocks": BLOCKS, "C++, rows": FILLED_ROWS,
    "C#, a derived class": DERIVED, "TypeScript": TYPED,
}  # fmt: skip


@pytest.mark.parametrize("style", STYLES)
def test_a_program_is_computed_in_the_style_of_its_author(style):
    found = recognise_table(STYLES[style])
    assert len(found.readings) == 1, str(found)
    assert np.allclose(found.arm.forward(Q), RIGHT.forward(Q), rtol=0, atol=1e-9)


def test_what_is_read_without_any_length_is_no_arm_beside_the_product():
    text = """
import numpy as np
def rot_z(deg):
    c, s = np.cos(np.radians(deg)), np.sin(np.radians(deg))
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
def rot_x(deg):
    c, s = np.cos(np.radians(deg)), np.sin(np.radians(deg))
    return np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
def pose(R, p):
    return np.vstack((np.column_stack((R, p)), [0, 0, 0, 1]))
def links(q1, q2, q3):
    A = pose(rot_z(q1) @ rot_x(90), [0, 0, 0.25])
    B = pose(rot_z(q2), rot_z(q2) @ [0.32, 0, 0])
    return A @ B @ pose(rot_z(q3 + 90), rot_z(q3 + 90) @ [0.21, 0, 0])
"""
    found = recognise_table(text)
    assert len(found.readings) == 1
    assert np.allclose(found.arm.forward(Q), RIGHT.forward(Q), rtol=0, atol=1e-9)


def test_a_matrix_of_which_a_part_is_set_in_an_unknown_way_is_no_link():
    text = BLOCKS.replace("T.block<3, 1>(0, 3) =", "T.somewhere(3).there =")
    try:
        found = recognise_table(text)
    except ValueError:
        return
    assert len(found.readings) > 1 or np.allclose(found.arm.forward(Q), RIGHT.forward(Q))
