"""Sixty wrong programs in the style of a class, written by somebody who did not know what the
doctor looks for.

``PROGRAMS`` holds (kind, mistakes, text): two mistakes are joined by " + ", names that describe one
mistake equally well by "|"; "none" where the catalogue had no name for it. The doctor was then
improved on those of even index; those of odd index were kept for measuring.
"""

PROGRAMS = [
    (
        "dh",
        "last-row-missing + matrix-entry-mistyped",
        r"""import numpy as np

def dh_transform(th, d, a, al):
    ct, st = np.cos(th), np.sin(th)
    ca, sa = np.cos(al), np.sin(al)
    R = np.array([[ct, -st*ca, st*sa],
                  [st, ct*ca, -ct*sa],
                  [0, ca, sa]])
    p = np.array([a*ct, a*st, d])
    top = np.hstack((R, p.reshape(3, 1)))
    # homogeneous row
    return np.vstack((top, np.ones(4)))
""",
    ),
    (
        "fk",
        "tool-missing|product-stops-early",
        r"""import numpy as np

# modified DH as in Craig: alpha_{i-1}, a_{i-1}, d_i, theta_i
def link(alpha_prev, a_prev, d, theta):
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha_prev), np.sin(alpha_prev)
    return np.array([[ct, -st, 0, a_prev],
                     [st*ca, ct*ca, -sa, -d*sa],
                     [st*sa, ct*sa, ca, d*ca],
                     [0, 0, 0, 1]])

def forward_kinematics(rows, q):
    rows = np.asarray(rows, dtype=float)
    T = np.eye(4)
    alpha_prev, a_prev = 0.0, 0.0      # alpha_0 = a_0 = 0
    for i in range(len(q)):
        T = T @ link(alpha_prev, a_prev, rows[i, 1], rows[i, 0] + q[i])
        a_prev = rows[i, 2]
        alpha_prev = rows[i, 3]
    return T
""",
    ),
    (
        "dh",
        "alpha-sign + length-unit",
        r"""import numpy as np

def skew(v):
    return np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])

def rodrigues(axis, ang):
    K = skew(axis)
    return np.eye(3) + np.sin(ang) * K + (1 - np.cos(ang)) * K @ K

def dh_transform(theta, d, a, alpha):
    Rz = rodrigues([0, 0, 1], theta)
    Rx = rodrigues([-1, 0, 0], alpha)   # clockwise seen along x
    out = np.identity(4)
    out[:3, :3] = Rz @ Rx
    out[:3, 3] = Rz @ [a, 0, 0] + [0, 0, d / 1000]
    return out
""",
    ),
    (
        "fk",
        "offset-on-wrong-joint",
        r"""import numpy as np

def dh(th, d, a, al):
    T = np.eye(4)
    Z = np.eye(4)
    Z[:2, :2] = [[np.cos(th), -np.sin(th)], [np.sin(th), np.cos(th)]]
    Z[2, 3] = d
    X = np.eye(4)
    X[1:3, 1:3] = [[np.cos(al), -np.sin(al)], [np.sin(al), np.cos(al)]]
    X[0, 3] = a
    T = T.dot(Z)
    T = T.dot(X)
    return T

def forward_kinematics(rows, q):
    rows = np.asarray(rows, float)
    theta = np.roll(rows[:, 0], 1) + np.asarray(q)
    T = np.eye(4)
    for th, (_, d, a, al) in zip(theta, rows):
        T = T @ dh(th, d, a, al)
    return T
""",
    ),
    (
        "dh",
        "length-unit",
        r"""import numpy as np

MM = 1e-3

class Link:
    def __init__(self, theta, d, a, alpha):
        self.theta = theta
        self.d = d * MM      # datasheet lengths
        self.a = a * MM
        self.alpha = alpha

    def matrix(self):
        ct, st = np.cos(self.theta), np.sin(self.theta)
        ca, sa = np.cos(self.alpha), np.sin(self.alpha)
        return np.array([[ct, -st*ca,  st*sa, self.a*ct],
                         [st,  ct*ca, -ct*sa, self.a*st],
                         [0,   sa,     ca,    self.d],
                         [0,   0,      0,     1]])

def dh_transform(theta, d, a, alpha):
    return Link(theta, d, a, alpha).matrix()
""",
    ),
    (
        "fk",
        "product-reversed + alpha-sign",
        r"""import numpy as np

def rot_x(a):
    return np.array([[1,0,0,0],[0,np.cos(a),np.sin(a),0],[0,-np.sin(a),np.cos(a),0],[0,0,0,1]])

def rot_z(a):
    return np.array([[np.cos(a),-np.sin(a),0,0],[np.sin(a),np.cos(a),0,0],[0,0,1,0],[0,0,0,1]])

def shift(x, z):
    m = np.eye(4)
    m[0, 3], m[2, 3] = x, z
    return m

def forward_kinematics(rows, q):
    # recursion: the last link first
    if len(q) == 0:
        return np.eye(4)
    t, d, a, al = rows[0]
    first = rot_z(t + q[0]) @ shift(a, d) @ rot_x(al)
    return forward_kinematics(rows[1:], q[1:]) @ first
""",
    ),
    (
        "fk",
        "alpha-value",
        r"""import numpy as np

def snap(alpha):
    # alpha is always 0 or +-90 degrees on a real arm, remove the numerical rubbish
    return np.pi / 2 * np.round(alpha / (np.pi / 2))

def dh(theta, d, a, alpha):
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(snap(alpha)), np.sin(snap(alpha))
    return np.array([[ct, -st*ca, st*sa, a*ct],
                     [st, ct*ca, -ct*sa, a*st],
                     [0, sa, ca, d],
                     [0, 0, 0, 1]])

def forward_kinematics(rows, q):
    if len(rows) == 0:
        return np.eye(4)
    head, tail = rows[0], rows[1:]
    return dh(head[0] + q[0], *head[1:]) @ forward_kinematics(tail, q[1:])
""",
    ),
    (
        "fk",
        "offset-missing + product-stops-early",
        r"""import numpy as np

def dh(theta, d, a, alpha):
    # rotation and translation of one link
    R = np.array([
        [np.cos(theta), -np.sin(theta) * np.cos(alpha), np.sin(theta) * np.sin(alpha)],
        [np.sin(theta), np.cos(theta) * np.cos(alpha), -np.cos(theta) * np.sin(alpha)],
        [0, np.sin(alpha), np.cos(alpha)]])
    p = np.array([[a * np.cos(theta)], [a * np.sin(theta)], [d]])
    return np.block([[R, p], [np.zeros((1, 3)), 1]])

def forward_kinematics(rows, q):
    T = np.eye(4)
    n = np.shape(rows)[0]
    # python counts from 0 so the last index is n-1
    for i in range(0, n - 1):
        d = rows[i][1]
        a = rows[i][2]
        alpha = rows[i][3]
        theta = q[i]
        T = T @ dh(theta, d, a, alpha)
    return T
""",
    ),
    (
        "dh",
        "standard-rows-in-craig-matrix + pi-rounded",
        r"""import numpy as np

def dh_transform(theta, d, a, alpha):
    theta = round(theta, 1)   # avoid float noise
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha), np.sin(alpha)
    # Introduction to Robotics, (3.6)
    T = np.array([[ct,      -st,      0,   a],
                  [st * ca, ct * ca, -sa, -sa * d],
                  [st * sa, ct * sa,  ca,  ca * d],
                  [0,       0,        0,   1]])
    return T
""",
    ),
    (
        "fk",
        "elementwise-product",
        r"""import numpy as np

def rotz(t):
    return np.array([[np.cos(t), -np.sin(t), 0, 0], [np.sin(t), np.cos(t), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])

def rotx(t):
    return np.array([[1, 0, 0, 0], [0, np.cos(t), -np.sin(t), 0], [0, np.sin(t), np.cos(t), 0], [0, 0, 0, 1]])

def trans(x, y, z):
    return np.array([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]])

def dh(th, d, a, al):
    return rotz(th) @ trans(0, 0, d) @ trans(a, 0, 0) @ rotx(al)

def forward_kinematics(rows, q):
    mats = np.array([dh(r[0] + x, r[1], r[2], r[3]) for r, x in zip(rows, q)])
    # multiply all of them together
    return np.prod(mats, axis=0)
""",
    ),
    (
        "dh",
        "sin-cos-exchanged",
        r"""import numpy as np

def cs(angle):
    z = np.exp(1j * angle)
    return z.imag, z.real

def dh_transform(theta, d, a, alpha):
    ct, st = cs(theta)
    ca, sa = cs(alpha)
    return np.array([[ct, -st * ca, st * sa, a * ct],
                     [st, ct * ca, -ct * sa, a * st],
                     [0, sa, ca, d],
                     [0, 0, 0, 1]])
""",
    ),
    # none: sine taken as sqrt(1 - cos^2), so its sign is lost
    (
        "dh",
        "none",
        r"""import numpy as np

def dh_transform(theta, d, a, alpha):
    ct = np.cos(theta)
    ca = np.cos(alpha)
    # sin^2 + cos^2 = 1, saves calls to sin
    st = np.sqrt(1.0 - ct ** 2)
    sa = np.sqrt(1.0 - ca ** 2)
    T = np.array([[ct, -st * ca, st * sa, a * ct],
                  [st, ct * ca, -ct * sa, a * st],
                  [0, sa, ca, d],
                  [0, 0, 0, 1]])
    return T
""",
    ),
    (
        "fk",
        "one-row-for-all-joints",
        r"""import numpy as np

def dh(theta, d, a, alpha):
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st*ca, st*sa, a*ct],
                     [st, ct*ca, -ct*sa, a*st],
                     [0, sa, ca, d],
                     [0, 0, 0, 1]])

def forward_kinematics(rows, q):
    T = np.eye(4)
    for row in rows:
        off, d, a, alpha = row
        break
    for i in range(len(q)):
        T = T @ dh(rows[i][0] + q[i], d, a, alpha)
    return T
""",
    ),
    (
        "dh",
        "sin-cos-exchanged + length-sign",
        r"""import numpy as np

def dh_transform(theta, d, a, alpha):
    # alpha only: precompute
    twist = {'s': np.cos(alpha), 'c': np.sin(alpha)}
    ct, st = np.cos(theta), np.sin(theta)
    T = np.matrix(np.zeros((4, 4)))
    T[0] = [ct, -st * twist['c'], st * twist['s'], a * ct]
    T[1] = [st, ct * twist['c'], -ct * twist['s'], a * st]
    T[2] = [0, twist['s'], twist['c'], -d]
    T[3, 3] = 1
    return np.asarray(T)
""",
    ),
    (
        "fk",
        "integer-arrays",
        r"""import numpy as np

def dh(theta, d, a, alpha):
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st*ca, st*sa, a*ct],
                     [st, ct*ca, -ct*sa, a*st],
                     [0, sa, ca, d],
                     [0, 0, 0, 1]])

def forward_kinematics(rows, q):
    n = len(rows)
    theta = np.zeros_like(range(n))
    for i in range(n):
        theta[i] = rows[i][0] + q[i]
    T = np.eye(4)
    for i in range(n):
        T = T @ dh(theta[i], rows[i][1], rows[i][2], rows[i][3])
    return T
""",
    ),
    (
        "dh",
        "a-d-exchanged",
        r'''import numpy as np

def _matrix(theta, alpha, a, d):
    """same order as in Spong's table"""
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st*ca, st*sa, a*ct],
                     [st, ct*ca, -ct*sa, a*st],
                     [0., sa, ca, d],
                     [0., 0., 0., 1.]])

def dh_transform(theta, d, a, alpha):
    return _matrix(theta, alpha, d, a)
''',
    ),
    (
        "fk",
        "offset-counted-twice",
        r"""import numpy as np

def link(row, theta):
    theta = theta + row[0]      # offset
    d, a, alpha = row[1], row[2], row[3]
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st*ca, st*sa, a*ct],
                     [st, ct*ca, -ct*sa, a*st],
                     [0, sa, ca, d],
                     [0, 0, 0, 1]])

def forward_kinematics(rows, q):
    rows = np.array(rows)
    thetas = rows[:, 0] + q
    pose = np.eye(4)
    for row, theta in zip(rows, thetas):
        pose = pose @ link(row, theta)
    return pose
""",
    ),
    (
        "dh",
        "pose-inverted + length-value",
        r"""import numpy as np

def dh_transform(theta, d, a, alpha):
    a = a / 2           # to the middle of the link
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    # A_i maps frame i-1 into frame i
    return np.array([
        [ct, st, 0, -a],
        [-st * ca, ct * ca, sa, -d * sa],
        [st * sa, -ct * sa, ca, -d * ca],
        [0, 0, 0, 1],
    ])
""",
    ),
    (
        "dh",
        "mirror",
        r"""import numpy as np

def dh_transform(theta, d, a, alpha):
    z_old = np.array([0.0, 0.0, 1.0])
    # new x axis: old x turned by theta
    x_new = np.array([np.cos(theta), np.sin(theta), 0.0])
    # new z axis: old z turned about x_new by alpha
    z_new = np.cos(alpha) * z_old + np.sin(alpha) * np.cross(x_new, z_old)
    # y finishes the frame
    y_new = np.cross(x_new, z_new)
    pos = d * z_old + a * x_new
    T = np.stack([x_new, y_new, z_new, pos], axis=1)
    return np.vstack([T, [0, 0, 0, 1]])
""",
    ),
    (
        "fk",
        "offset-in-degrees|converted-to-radians-twice + rotation-transposed",
        r"""import numpy as np

def make_T(theta, d, a, alpha):
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha), np.sin(alpha)
    T = np.eye(4)
    T[0] = ct, -st*ca, st*sa, a*ct
    T[1] = st, ct*ca, -ct*sa, a*st
    T[2, 1:] = sa, ca, d
    return T

def forward_kinematics(rows, q):
    T = np.eye(4)
    for (offset, d, a, alpha), joint in zip(rows, q):
        T = T @ make_T(joint + np.radians(offset), d, a, alpha)
    position = T[:3, 3]
    orientation = T[:3, :3].T    # orientation of the tool seen from the base
    result = np.zeros((4, 4))
    result[:3, :3] = orientation
    result[:3, 3] = position
    result[3, 3] = 1
    return result
""",
    ),
    (
        "dh",
        "integer-arrays",
        r"""import numpy as np

def dh_transform(theta, d, a, alpha):
    T = np.array([[1, 0, 0, 0],
                  [0, 1, 0, 0],
                  [0, 0, 1, 0],
                  [0, 0, 0, 1]])
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha), np.sin(alpha)
    T[0] = [ct, -st*ca, st*sa, a*ct]
    T[1] = [st, ct*ca, -ct*sa, a*st]
    T[2, 1:] = [sa, ca, d]
    return T
""",
    ),
    (
        "dh",
        "a-d-exchanged + row-vector-convention",
        r"""import numpy as np

def Translation(x=0, y=0, z=0):
    return np.array([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]], dtype=float)

def Rotation(axis, ang):
    c, s = np.cos(ang), np.sin(ang)
    if axis == 'z':
        R = [[c, -s, 0], [s, c, 0], [0, 0, 1]]
    elif axis == 'x':
        R = [[1, 0, 0], [0, c, -s], [0, s, c]]
    out = np.eye(4)
    for i in range(3):
        for j in range(3):
            out[j][i] = R[i][j]
    return out

def dh_transform(theta, d, a, alpha):
    T = Rotation('z', theta)
    T = T @ Translation(z=a)
    T = T @ Translation(x=d)
    T = T @ Rotation('x', alpha)
    return T
""",
    ),
    # none: position updated with the rotation that already contains this link
    (
        "fk",
        "none",
        r"""import numpy as np

def rotz(t):
    return np.array([[np.cos(t), -np.sin(t), 0, 0], [np.sin(t), np.cos(t), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])

def rotx(t):
    return np.array([[1, 0, 0, 0], [0, np.cos(t), -np.sin(t), 0], [0, np.sin(t), np.cos(t), 0], [0, 0, 0, 1]])

def trans(x, y, z):
    return np.array([[1, 0, 0, x], [0, 1, 0, y], [0, 0, 1, z], [0, 0, 0, 1]])

def dh(th, d, a, al):
    return rotz(th) @ trans(0, 0, d) @ trans(a, 0, 0) @ rotx(al)

def forward_kinematics(rows, q):
    R = np.eye(3)
    p = np.zeros(3)
    for (th0, d, a, alpha), qi in zip(rows, q):
        M = dh(th0 + qi, d, a, alpha)
        # update rotation, then position
        R = R @ M[:3, :3]
        p = p + R @ M[:3, 3]
    T = np.eye(4)
    T[:3, :3] = R
    T[:3, 3] = p
    return T
""",
    ),
    (
        "dh",
        "alpha-before-d",
        r"""from functools import reduce
import numpy as np

def Rot(axis, ang):
    i, j = {"x": (1, 2), "z": (0, 1)}[axis]
    M = np.eye(4)
    M[i, i] = M[j, j] = np.cos(ang)
    M[i, j] = -np.sin(ang)
    M[j, i] = np.sin(ang)
    return M

def Trans(axis, dist):
    M = np.eye(4)
    M["xyz".index(axis), 3] = dist
    return M

def dh_transform(theta, d, a, alpha):
    # first all rotations, then all translations
    ops = [Rot("z", theta), Rot("x", alpha), Trans("z", d), Trans("x", a)]
    return reduce(np.matmul, ops)
""",
    ),
    (
        "dh",
        "theta-alpha-exchanged + lengths-made-positive",
        r"""import numpy as np

def dh_transform(theta, d, a, alpha):
    # lengths can't be negative
    d, a = max(d, -d), max(a, -a)
    c1, s1, c2, s2 = np.array([f(v) for v in (alpha, theta) for f in (np.cos, np.sin)])
    return np.array([[c1, -s1*c2, s1*s2, a*c1],
                     [s1, c1*c2, -c1*s2, a*s1],
                     [0, s2, c2, d],
                     [0, 0, 0, 1]])
""",
    ),
    (
        "fk",
        "joint-values-unused",
        r"""import numpy as np

def dh_matrix(params):
    theta, d, a, alpha = params
    c, s = np.cos(theta), np.sin(theta)
    C, S = np.cos(alpha), np.sin(alpha)
    return np.array([[c, -s*C, s*S, a*c], [s, c*C, -c*S, a*s], [0, S, C, d], [0, 0, 0, 1]])

def forward_kinematics(rows, q):
    table = np.array(rows, dtype=float)   # copy so I don't change the input
    np.add(table[:, 0], q)                # add joint angles to theta column
    T = np.eye(4)
    for p in table:
        T = np.dot(T, dh_matrix(p))
    return T
""",
    ),
    (
        "fk",
        "link-counted-twice",
        r"""import numpy as np

def dh(theta, d, a, alpha):
    # rotation and translation of one link
    R = np.array([
        [np.cos(theta), -np.sin(theta) * np.cos(alpha), np.sin(theta) * np.sin(alpha)],
        [np.sin(theta), np.cos(theta) * np.cos(alpha), -np.cos(theta) * np.sin(alpha)],
        [0, np.sin(alpha), np.cos(alpha)]])
    p = np.array([[a * np.cos(theta)], [a * np.sin(theta)], [d]])
    return np.block([[R, p], [np.zeros((1, 3)), 1]])

def forward_kinematics(rows, q):
    # start with the first link, then multiply the others
    T = dh(rows[0][0] + q[0], rows[0][1], rows[0][2], rows[0][3])
    for j in range(len(q)):
        T = T.dot(dh(rows[j][0] + q[j], rows[j][1], rows[j][2], rows[j][3]))
    return T
""",
    ),
    (
        "dh",
        "degrees-in-sin-cos|angle-unit",
        r"""import math
import numpy as np

RAD2DEG = 180 / math.pi

def cosd(x):
    return math.cos(x * RAD2DEG)

def sind(x):
    return math.sin(x * RAD2DEG)

# ported from my matlab script (there it was cosd / sind)
def dh_transform(theta, d, a, alpha):
    A = np.zeros([4, 4])
    A[0, :] = [cosd(theta), -sind(theta)*cosd(alpha), sind(theta)*sind(alpha), a*cosd(theta)]
    A[1, :] = [sind(theta), cosd(theta)*cosd(alpha), -cosd(theta)*sind(alpha), a*sind(theta)]
    A[2, :] = [0, sind(alpha), cosd(alpha), d]
    A[3, :] = [0, 0, 0, 1]
    return A
""",
    ),
    (
        "fk",
        "translations-not-rotated + converted-to-radians-twice|angle-unit",
        r"""import numpy as np

def quat(axis, ang):
    q = np.zeros(4)
    q[0] = np.cos(ang / 2)
    q[1 + axis] = np.sin(ang / 2)
    return q

def mul(p, q):
    w = p[0]*q[0] - p[1:] @ q[1:]
    v = p[0]*q[1:] + q[0]*p[1:] + np.cross(p[1:], q[1:])
    return np.r_[w, v]

def rotate(q, v):
    conj = q * [1, -1, -1, -1]
    return mul(mul(q, np.r_[0.0, v]), conj)[1:]

def forward_kinematics(rows, q):
    ori = np.array([1.0, 0, 0, 0])
    pos = np.zeros(3)
    for r, angle in zip(rows, np.deg2rad(q)):
        qz = quat(2, r[0] + angle)
        # new origin: d along z, a along the turned x
        step = rotate(qz, np.array([r[2], 0.0, r[1]]))
        pos = pos + step
        ori = mul(ori, mul(qz, quat(0, r[3])))
    T = np.eye(4)
    T[:3, :3] = np.column_stack([rotate(ori, e) for e in np.eye(3)])
    T[:3, 3] = pos
    return T
""",
    ),
    (
        "fk",
        "joint-reversed",
        r"""import numpy as np

def dh(theta_i, d_i, a_i, alpha_i):
    T = np.identity(4)
    c, s = np.cos(theta_i), np.sin(theta_i)
    l, m = np.cos(alpha_i), np.sin(alpha_i)
    T[:3, 0] = [c, s, 0]
    T[:3, 1] = [-s * l, c * l, m]
    T[:3, 2] = [s * m, -c * m, l]
    T[:3, 3] = [a_i * c, a_i * s, d_i]
    return T

def forward_kinematics(rows, q):
    T = np.eye(4)
    n = len(rows)
    for i in range(n):
        off, d, a, alpha = rows[i]
        if i == n - 1:
            # last joint: flange points the other way
            ang = off - q[i]
        else:
            ang = off + q[i]
        T = T @ dh(ang, d, a, alpha)
    return T
""",
    ),
    (
        "dh",
        "matrix-entry-mistyped",
        r"""import numpy as np
from math import sin, cos

def dh_transform(theta, d, a, alpha):
    # straight off the lecture slide
    return np.array([
        [cos(theta), -sin(theta)*cos(alpha),  sin(theta)*sin(alpha), a*cos(theta)],
        [sin(theta),  cos(theta)*cos(alpha),  cos(theta)*sin(alpha), a*sin(theta)],
        [0,           sin(alpha),             cos(alpha),            d],
        [0,           0,                      0,                     1]])
""",
    ),
    (
        "dh",
        "last-row-missing",
        r"""import numpy as np

def dh_transform(theta, d, a, alpha):
    ct = np.cos(theta)
    st = np.sin(theta)
    ca = np.cos(alpha)
    sa = np.sin(alpha)

    T = np.zeros((4, 4))
    # first row
    T[0, 0] = ct
    T[0, 1] = -st * ca
    T[0, 2] = st * sa
    T[0, 3] = a * ct
    # second row
    T[1, 0] = st
    T[1, 1] = ct * ca
    T[1, 2] = -ct * sa
    T[1, 3] = a * st
    # third row
    T[2, 1] = sa
    T[2, 2] = ca
    T[2, 3] = d
    # rest is zero already :)
    return T
""",
    ),
    (
        "dh",
        "shift-not-turned-by-theta|translations-not-rotated",
        r"""import numpy as np

def Rz(t):
    return np.array([[np.cos(t), -np.sin(t), 0], [np.sin(t), np.cos(t), 0], [0, 0, 1]])

def Rx(t):
    return np.array([[1, 0, 0], [0, np.cos(t), -np.sin(t)], [0, np.sin(t), np.cos(t)]])

def dh_transform(theta, d, a, alpha):
    R = Rz(theta) @ Rx(alpha)
    # d along z and a along x
    p = np.array([[a], [0.0], [d]])
    return np.block([[R, p], [np.zeros((1, 3)), np.ones((1, 1))]])
""",
    ),
    (
        "dh",
        "standard-rows-in-craig-matrix|product-reversed",
        r"""import numpy as np

def rotx(al):
    return np.array([[1, 0, 0, 0],
                     [0, np.cos(al), -np.sin(al), 0],
                     [0, np.sin(al), np.cos(al), 0],
                     [0, 0, 0, 1.0]])

def rotz(th):
    return np.array([[np.cos(th), -np.sin(th), 0, 0],
                     [np.sin(th), np.cos(th), 0, 0],
                     [0, 0, 1, 0],
                     [0, 0, 0, 1.0]])

def trans(x, y, z):
    M = np.eye(4)
    M[:3, 3] = x, y, z
    return M

# Craig eq. 3.5:  T = R_x(alpha_{i-1}) D_x(a_{i-1}) R_z(theta_i) D_z(d_i)
def dh_transform(theta, d, a, alpha):
    return rotx(alpha) @ trans(a, 0, 0) @ rotz(theta) @ trans(0, 0, d)
""",
    ),
    (
        "dh",
        "elementwise-product",
        r"""import numpy as np

def dh_transform(theta, d, a, alpha):
    ct = np.cos(theta); st = np.sin(theta)
    ca = np.cos(alpha); sa = np.sin(alpha)
    Rot_z = np.array([[ct,-st,0,0],[st,ct,0,0],[0,0,1,0],[0,0,0,1]])
    Trans_z = np.array([[1,0,0,0],[0,1,0,0],[0,0,1,d],[0,0,0,1]])
    Trans_x = np.array([[1,0,0,a],[0,1,0,0],[0,0,1,0],[0,0,0,1]])
    Rot_x = np.array([[1,0,0,0],[0,ca,-sa,0],[0,sa,ca,0],[0,0,0,1]])
    T = Rot_z*Trans_z*Trans_x*Rot_x
    return T
""",
    ),
    (
        "fk",
        "atan-for-atan2",
        r'''import numpy as np


def _normalize(angle):
    """Normalize an angle so that the trigonometric functions stay accurate."""
    return np.arctan(np.tan(angle))


def _link_transform(theta, d, a, alpha):
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha), np.sin(alpha)
    return np.array([
        [ct, -st * ca, st * sa, a * ct],
        [st, ct * ca, -ct * sa, a * st],
        [0.0, sa, ca, d],
        [0.0, 0.0, 0.0, 1.0],
    ])


def forward_kinematics(rows, q):
    """Forward kinematics of a serial chain of revolute joints."""
    rows = np.asarray(rows, dtype=float)
    q = np.asarray(q, dtype=float).ravel()
    transform = np.eye(4)
    for (offset, d, a, alpha), angle in zip(rows, q):
        theta = _normalize(offset + angle)
        transform = transform @ _link_transform(theta, d, a, alpha)
    return transform
''',
    ),
    (
        "dh",
        "shift-not-turned-by-theta + alpha-in-degrees|converted-to-radians-twice|angle-unit",
        r"""import numpy as np
from numpy import cos, sin, pi

def dh_transform(theta, d, a, alpha):
    alpha = alpha * pi / 180    # table gives alpha = 90, -90, 0 ...
    T = np.eye(4)
    # translation part
    T[0, 3] += a
    T[2, 3] += d
    # rotation part
    T[0, :3] = cos(theta), -sin(theta)*cos(alpha), sin(theta)*sin(alpha)
    T[1, :3] = sin(theta), cos(theta)*cos(alpha), -cos(theta)*sin(alpha)
    T[2, :3] = 0, sin(alpha), cos(alpha)
    return T
""",
    ),
    (
        "dh",
        "rotation-transposed",
        r"""import numpy as np

def dh_transform(theta, d, a, alpha):
    c, s = np.cos, np.sin
    # the new axes written in the old frame
    x_axis = [c(theta), s(theta), 0]
    y_axis = [-s(theta) * c(alpha), c(theta) * c(alpha), s(alpha)]
    z_axis = [s(theta) * s(alpha), -c(theta) * s(alpha), c(alpha)]
    origin = [a * c(theta), a * s(theta), d]

    T = np.eye(4)
    T[:3, :3] = np.vstack((x_axis, y_axis, z_axis))
    T[:3, 3] = origin
    return T
""",
    ),
    (
        "fk",
        "offset-subtracted",
        r"""import numpy as np
import math

def transform(theta, d, a, alpha):
    ct = math.cos(theta)
    st = math.sin(theta)
    ca = math.cos(alpha)
    sa = math.sin(alpha)
    return np.array([[ct, -st*ca, st*sa, a*ct],
                     [st, ct*ca, -ct*sa, a*st],
                     [0, sa, ca, d],
                     [0, 0, 0, 1]])

def forward_kinematics(rows, q):
    i = 0
    T = np.identity(4)
    while i < len(rows):
        th = rows[i][0]
        th -= q[i]
        T = T @ transform(th, rows[i][1], rows[i][2], rows[i][3])
        i += 1
    return T
""",
    ),
    (
        "dh",
        "matrix-entry-mistyped",
        r"""import math
import numpy as np

def dh_transform(theta, d, a, alpha):
    cth, sth = math.cos(theta), math.sin(theta)
    cal, sal = math.cos(alpha), math.sin(alpha)
    row1 = [cth, -sth*cal, sth*sal, a*cth]
    row2 = [sth, cth*cal, -cth*sal, a*sal]
    row3 = [0.0, sal, cal, d]
    row4 = [0.0, 0.0, 0.0, 1.0]
    return np.array([row1, row2, row3, row4])
""",
    ),
    (
        "dh",
        "state-between-calls",
        r"""import numpy as np

steps = []

def add(M):
    steps.append(M)

def dh_transform(theta, d, a, alpha):
    c, s = np.cos(theta), np.sin(theta)
    add(np.array([[c, -s, 0, 0], [s, c, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]))
    add(np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]]))
    add(np.array([[1, 0, 0, a], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]))
    c, s = np.cos(alpha), np.sin(alpha)
    add(np.array([[1, 0, 0, 0], [0, c, -s, 0], [0, s, c, 0], [0, 0, 0, 1]]))
    # now multiply everything from left to right
    res = np.eye(4)
    for M in steps:
        res = res.dot(M)
    return res
""",
    ),
    # none: full angle used where the quaternion needs the half angle (both angles doubled)
    (
        "dh",
        "none|angle-unit",
        r"""import numpy as np

def qmul(p, q):
    w1, x1, y1, z1 = p
    w2, x2, y2, z2 = q
    return np.array([w1*w2 - x1*x2 - y1*y2 - z1*z2,
                     w1*x2 + x1*w2 + y1*z2 - z1*y2,
                     w1*y2 - x1*z2 + y1*w2 + z1*x2,
                     w1*z2 + x1*y2 - y1*x2 + z1*w2])

def q2R(q):
    w, x, y, z = q
    return np.array([[1 - 2*(y*y + z*z), 2*(x*y - w*z), 2*(x*z + w*y)],
                     [2*(x*y + w*z), 1 - 2*(x*x + z*z), 2*(y*z - w*x)],
                     [2*(x*z - w*y), 2*(y*z + w*x), 1 - 2*(x*x + y*y)]])

def axis_quat(angle, axis):
    # w = cos, xyz = axis * sin
    return np.concatenate(([np.cos(angle)], np.sin(angle) * np.asarray(axis)))

def dh_transform(theta, d, a, alpha):
    qz = axis_quat(theta, [0., 0., 1.])
    qx = axis_quat(alpha, [1., 0., 0.])
    T = np.eye(4)
    T[:3, :3] = q2R(qmul(qz, qx))
    T[:3, 3] = q2R(qz) @ np.array([a, 0., d])
    return T
""",
    ),
    (
        "fk",
        "joint-index-off-by-one + length-unit",
        r'''import numpy as np

def dh(th, d, a, al):
    T = np.eye(4)
    Z = np.eye(4)
    Z[:2, :2] = [[np.cos(th), -np.sin(th)], [np.sin(th), np.cos(th)]]
    Z[2, 3] = d
    X = np.eye(4)
    X[1:3, 1:3] = [[np.cos(al), -np.sin(al)], [np.sin(al), np.cos(al)]]
    X[0, 3] = a
    T = T.dot(Z)
    T = T.dot(X)
    return T

def forward_kinematics(rows, q):
    """ converted from MATLAB: for i = 1:n, T = T*A(i); end """
    n = len(rows)
    T = np.eye(4)
    for i in range(1, n + 1):
        r = rows[i - 1]
        qi = q[i % n]
        T = T @ dh(r[0] + qi, r[1], r[2], r[3])
    T[:3, 3] *= 1000.0   # output in mm
    return T
''',
    ),
    (
        "dh",
        "converted-to-radians-twice",
        r'''import numpy as np


def dh_transform(theta: float, d: float, a: float, alpha: float) -> np.ndarray:
    """
    Compute the homogeneous transformation matrix for one link.

    Parameters
    ----------
    theta : float
        Joint angle.
    d : float
        Link offset.
    a : float
        Link length.
    alpha : float
        Link twist.

    Returns
    -------
    np.ndarray
        4x4 homogeneous transformation matrix.
    """
    # numpy's trig functions expect radians
    theta = np.deg2rad(theta)
    alpha = np.deg2rad(alpha)

    cos_t, sin_t = np.cos(theta), np.sin(theta)
    cos_a, sin_a = np.cos(alpha), np.sin(alpha)

    return np.array([
        [cos_t, -sin_t * cos_a, sin_t * sin_a, a * cos_t],
        [sin_t, cos_t * cos_a, -cos_t * sin_a, a * sin_t],
        [0.0, sin_a, cos_a, d],
        [0.0, 0.0, 0.0, 1.0],
    ])
''',
    ),
    (
        "fk",
        "product-starts-late|extra-or-missing-row + lengths-made-positive",
        r"""import numpy as np

def DHmat(theta, d, a, alpha):
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st*ca, st*sa, a*ct],
                     [st, ct*ca, -ct*sa, a*st],
                     [0, sa, ca, d],
                     [0, 0, 0, 1]])

def forward_kinematics(rows, q):
    T = np.eye(4)
    N = len(q)
    # for i = 1:N
    for i in range(1, N):
        a = float(np.where(rows[i][2] < 0, -rows[i][2], rows[i][2]))   # length >= 0
        T = T @ DHmat(rows[i][0] + q[i], rows[i][1], a, rows[i][3])
    return T
""",
    ),
    (
        "fk",
        "state-between-calls",
        r"""import numpy as np

def dh(row):
    t, d, a, al = row
    return np.array([[np.cos(t), -np.sin(t)*np.cos(al), np.sin(t)*np.sin(al), a*np.cos(t)],
                     [np.sin(t), np.cos(t)*np.cos(al), -np.cos(t)*np.sin(al), a*np.sin(t)],
                     [0, np.sin(al), np.cos(al), d],
                     [0, 0, 0, 1]])

def forward_kinematics(rows, q, T=np.eye(4)):
    for i in range(len(q)):
        off, d, a, alpha = rows[i]
        T[:] = T @ dh((off + q[i], d, a, alpha))
    return T.copy()
""",
    ),
    (
        "fk",
        "inputs-changed",
        r"""import numpy as np

from math import cos as C, sin as S

def dh(t, d, a, w):
    M = [[C(t), -S(t) * C(w), S(t) * S(w), a * C(t)],
         [S(t), C(t) * C(w), -C(t) * S(w), a * S(t)],
         [0.0, S(w), C(w), d],
         [0.0, 0.0, 0.0, 1.0]]
    return np.array(M)

class Robot:
    def __init__(self, rows):
        self.rows = rows

    def fk(self, q):
        T = np.eye(4)
        for i, row in enumerate(self.rows):
            row[0] += q[i]
            T = T @ dh(*row)
        return T

def forward_kinematics(rows, q):
    return Robot(rows).fk(q)
""",
    ),
    (
        "fk",
        "product-reversed",
        r"""from functools import reduce
import numpy as np

def A(theta, d, a, alpha):
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st*ca, st*sa, a*ct],
                     [st, ct*ca, -ct*sa, a*st],
                     [0, sa, ca, d],
                     [0, 0, 0, 1]])

def forward_kinematics(rows, q):
    links = [A(r[0] + qi, *r[1:]) for r, qi in zip(rows, q)]
    return reduce(lambda acc, M: M @ acc, links, np.eye(4))
""",
    ),
    (
        "fk",
        "columns-misread + offset-sign",
        r"""import numpy as np

def dh(theta_i, d_i, a_i, alpha_i):
    T = np.identity(4)
    c, s = np.cos(theta_i), np.sin(theta_i)
    l, m = np.cos(alpha_i), np.sin(alpha_i)
    T[:3, 0] = [c, s, 0]
    T[:3, 1] = [-s * l, c * l, m]
    T[:3, 2] = [s * m, -c * m, l]
    T[:3, 3] = [a_i * c, a_i * s, d_i]
    return T

def forward_kinematics(rows, q):
    T = np.eye(4)
    for i, (theta0, alpha, a, d) in enumerate(rows):
        # theta0 is the zero position, measure from there
        T = T @ dh(q[i] - theta0, d, a, alpha)
    return T
""",
    ),
    (
        "dh",
        "matrix-transposed",
        r"""import numpy as np
from math import cos, sin

# C++ version of our lab code:  Eigen::Matrix4d m; double* p = m.data(); ...
def dh_transform(theta, d, a, alpha):
    m = [0.0] * 16
    m[0] = cos(theta)
    m[1] = sin(theta)
    m[2] = 0.0
    m[3] = 0.0
    m[4] = -sin(theta) * cos(alpha)
    m[5] = cos(theta) * cos(alpha)
    m[6] = sin(alpha)
    m[7] = 0.0
    m[8] = sin(theta) * sin(alpha)
    m[9] = -cos(theta) * sin(alpha)
    m[10] = cos(alpha)
    m[11] = 0.0
    m[12] = a * cos(theta)
    m[13] = a * sin(theta)
    m[14] = d
    m[15] = 1.0
    return np.asarray(m).reshape(4, 4)
""",
    ),
    (
        "dh",
        "row-vector-convention",
        r"""import numpy as np

def hom(R=np.eye(3), t=(0, 0, 0)):
    H = np.eye(4)
    H[0:3, 0:3] = R
    H[0:3, 3] = t
    return H

# rotation matrices from wikipedia (transformation of the axes)
def R_z(w):
    return np.array([[np.cos(w), np.sin(w), 0],
                     [-np.sin(w), np.cos(w), 0],
                     [0, 0, 1]])

def R_x(w):
    return np.array([[1, 0, 0],
                     [0, np.cos(w), np.sin(w)],
                     [0, -np.sin(w), np.cos(w)]])

def dh_transform(theta, d, a, alpha):
    T1 = hom(R=R_z(theta))
    T2 = hom(t=(0, 0, d))
    T3 = hom(t=(a, 0, 0))
    T4 = hom(R=R_x(alpha))
    return np.linalg.multi_dot([T1, T2, T3, T4])
""",
    ),
    (
        "fk",
        "a-alpha-from-previous-row",
        r"""import numpy as np

def A_i(alpha, a, d, theta):
    return np.array([
        [np.cos(theta), -np.sin(theta)*np.cos(alpha), np.sin(theta)*np.sin(alpha), a*np.cos(theta)],
        [np.sin(theta), np.cos(theta)*np.cos(alpha), -np.cos(theta)*np.sin(alpha), a*np.sin(theta)],
        [0, np.sin(alpha), np.cos(alpha), d],
        [0, 0, 0, 1]])

def forward_kinematics(rows, q):
    # the book has alpha_{i-1} and a_{i-1} but d_i and theta_i
    a = [0.0] + [r[2] for r in rows]
    alpha = [0.0] + [r[3] for r in rows]
    T = np.eye(4)
    for i, (r, qi) in enumerate(zip(rows, q), start=1):
        T = T @ A_i(alpha[i - 1], a[i - 1], r[1], r[0] + qi)
    return T
""",
    ),
    (
        "fk",
        "product-stops-early|wrong-frame-compared",
        r"""import numpy as np

def dh(theta, d, a, alpha):
    Rz = np.array([[np.cos(theta), -np.sin(theta), 0, 0],
                   [np.sin(theta), np.cos(theta), 0, 0],
                   [0, 0, 1, d],
                   [0, 0, 0, 1]])
    Rx = np.array([[1, 0, 0, a],
                   [0, np.cos(alpha), -np.sin(alpha), 0],
                   [0, np.sin(alpha), np.cos(alpha), 0],
                   [0, 0, 0, 1]])
    return Rz @ Rx

def forward_kinematics(rows, q):
    frames = [np.eye(4)]          # frames[0] is the base
    for k in range(len(rows)):
        off, d, a, al = rows[k]
        frames.append(frames[k] @ dh(off + q[k], d, a, al))
    return frames[len(rows) - 1]
""",
    ),
    (
        "fk",
        "base-turned + matrix-entry-mistyped",
        r"""import numpy as np

BASE = np.array([[0., -1., 0., 0.],     # robot is mounted turned by 90 deg
                 [1., 0., 0., 0.],
                 [0., 0., 1., 0.],
                 [0., 0., 0., 1.]])

def dh(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    T = np.zeros((4, 4))
    T[0, :] = [ct, -st*ca, st*sa, a*ct]
    T[1, :] = [st, ct*ca, -ct*sa, a*st]
    T[2, :] = [0, sa, ca, d*ca]
    T[3, :] = [0, 0, 0, 1]
    return T

def forward_kinematics(rows, q):
    chain = [BASE]
    chain += [dh(rows[i][0] + q[i], *rows[i][1:]) for i in range(len(q))]
    T = chain[0]
    for M in chain[1:]:
        T = T @ M
    return T
""",
    ),
    (
        "dh",
        "atan-for-atan2 + matrix-entry-mistyped",
        r"""import numpy as np
import math

def wrap(x):
    # bring the angle back to -pi..pi
    return math.atan(math.sin(x) / math.cos(x))

def dh_transform(theta, d, a, alpha):
    t = wrap(theta)
    c, s = math.cos(t), math.sin(t)
    k, l = math.cos(alpha), math.sin(alpha)
    T = [[c, s*k, s*l, a*c],
         [s, c*k, -c*l, a*s],
         [0, l, k, d],
         [0, 0, 0, 1]]
    return np.array(T)
""",
    ),
    # none: wrap to pi forgets the last - pi: every theta is pi too large
    (
        "fk",
        "offset-value|none",
        r"""import numpy as np

from math import cos as C, sin as S

def dh(t, d, a, w):
    M = [[C(t), -S(t) * C(w), S(t) * S(w), a * C(t)],
         [S(t), C(t) * C(w), -C(t) * S(w), a * S(t)],
         [0.0, S(w), C(w), d],
         [0.0, 0.0, 0.0, 1.0]]
    return np.array(M)

def wrap_to_pi(x):
    return np.mod(x + np.pi, 2 * np.pi)

def forward_kinematics(rows, q):
    T = np.eye(4)
    for r, qi in zip(rows, q):
        th = wrap_to_pi(r[0] + qi)
        T = np.matmul(T, dh(th, r[1], r[2], r[3]))
    return T
""",
    ),
    (
        "fk",
        "standard-rows-in-craig-matrix + offset-sign",
        r"""import numpy as np
from math import cos, sin

def getT(alpha, a, d, theta):
    return np.array([[cos(theta), -sin(theta), 0, a],
                     [sin(theta)*cos(alpha), cos(theta)*cos(alpha), -sin(alpha), -sin(alpha)*d],
                     [sin(theta)*sin(alpha), cos(theta)*sin(alpha), cos(alpha), cos(alpha)*d],
                     [0, 0, 0, 1]])

def forward_kinematics(rows, q):
    DH = [dict(zip(("theta", "d", "a", "alpha"), r)) for r in rows]
    T0_n = np.eye(4)
    for k, s in enumerate(DH):
        s["theta"] = -s["theta"] + q[k]
        T0_n = T0_n @ getT(s["alpha"], s["a"], s["d"], s["theta"])
    return T0_n
""",
    ),
    (
        "fk",
        "matrix-transposed|row-vector-convention",
        r"""import numpy as np

def forward_kinematics(rows, q):
    rows = np.asarray(rows)
    th = rows[:, 0] + np.asarray(q)
    d, a, al = rows[:, 1:].T
    ct, st, ca, sa = np.cos(th), np.sin(th), np.cos(al), np.sin(al)
    z, o = np.zeros_like(th), np.ones_like(th)
    # all link matrices at once, shape (n, 4, 4)
    A = np.stack([ct, -st*ca, st*sa, a*ct,
                  st, ct*ca, -ct*sa, a*st,
                  z, sa, ca, d,
                  z, z, z, o], axis=-1).reshape(-1, 4, 4)
    T = np.eye(4)
    for Ai in A:
        T = np.einsum('ij,kj->ik', T, Ai)
    return T
""",
    ),
    (
        "fk",
        "joints-summed + a-d-exchanged",
        r"""import numpy as np

def dh(theta, d, a, alpha):
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st*ca, st*sa, a*ct],
                     [st, ct*ca, -ct*sa, a*st],
                     [0, sa, ca, d],
                     [0, 0, 0, 1]])

def forward_kinematics(rows, q):
    rows = np.asarray(rows)
    total = 0.0
    T = np.eye(4)
    for i in range(len(q)):
        total += q[i]          # every joint carries the ones before
        T = T @ dh(rows[i, 0] + total, rows[i, 2], rows[i, 1], rows[i, 3])
    return T
""",
    ),
    (
        "dh",
        "matrix-transposed + degrees-in-sin-cos|angle-unit",
        r"""import numpy as np

def dh_transform(theta, d, a, alpha):
    th = np.degrees(theta)
    xs = (np.cos(th), np.sin(th), 0, 0)
    ys = (-np.sin(th)*np.cos(alpha), np.cos(th)*np.cos(alpha), np.sin(alpha), 0)
    zs = (np.sin(th)*np.sin(alpha), -np.cos(th)*np.sin(alpha), np.cos(alpha), 0)
    ps = (a*np.cos(th), a*np.sin(th), d, 1)
    # put the columns x y z p together
    return np.stack([xs, ys, zs, ps])
""",
    ),
]
