"""Programs as learners write them, each with what is wrong with it; the expectations were written
down before the doctor saw them.

A program is its text, run anew for every diagnosis, so that nothing outlives it. ``WRONG`` holds
(kind, ids, text), two ids for two mistakes at once; ``RIGHT`` holds (kind, text).
"""

WRONG, RIGHT = [], []
KINDS = {"dh": "dh_transform", "fk": "forward_kinematics"}


def program(kind, text):
    """The function that a text defines."""
    space = {"__name__": "learner"}
    exec(compile(text, "<learner>", "exec"), space)
    return space[kind]


def wrong(kind, ids, text):
    WRONG.append((KINDS[kind], tuple(ids.split(" + ")), text))


def right(kind, text):
    RIGHT.append((KINDS[kind], text))


LINK = """
import numpy as np

def dh(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st * ca, st * sa, a * ct],
                     [st, ct * ca, -ct * sa, a * st],
                     [0, sa, ca, d],
                     [0, 0, 0, 1]])
"""

MOVES = """
import numpy as np
from numpy import sin, cos

def Rz(t): return np.array([[cos(t), -sin(t), 0, 0], [sin(t), cos(t), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
def Rx(t): return np.array([[1, 0, 0, 0], [0, cos(t), -sin(t), 0], [0, sin(t), cos(t), 0], [0, 0, 0, 1]])
def Tz(d): return np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, d], [0, 0, 0, 1.0]])
def Tx(a): return np.array([[1, 0, 0, a], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])
"""

# ---- dh_transform: one entry of the closed form

wrong(
    "dh",
    "matrix-entry-mistyped",
    """
import math
def dh_transform(theta, d, a, alpha):
    c = math.cos(theta); s = math.sin(theta)
    ca = math.cos(alpha); sa = math.sin(alpha)
    return [[c, s*ca, s*sa, a*c],
            [s, c*ca, -c*sa, a*s],
            [0, sa, ca, d],
            [0, 0, 0, 1]]
""",
)
wrong(
    "dh",
    "matrix-entry-mistyped",
    """
from numpy import *
def dh_transform(th, d, a, al):
    row1 = [cos(th), -sin(th)*cos(al), sin(th)*sin(al), a*cos(th)]
    row2 = [sin(th), cos(th)*cos(al), cos(th)*sin(al), a*sin(th)]
    row3 = [0, sin(al), cos(al), d]
    return array([row1, row2, row3, [0, 0, 0, 1]])
""",
)
wrong(
    "dh",
    "matrix-entry-mistyped",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    T = np.eye(4)
    T[0, :] = np.cos(theta), -np.sin(theta) * np.cos(alpha), np.sin(theta) * np.sin(alpha), a * np.cos(theta)
    T[1, :] = np.sin(theta), np.cos(theta) * np.cos(alpha), -np.cos(theta) * np.sin(alpha), a * np.sin(theta)
    T[2, 1:] = -np.sin(alpha), np.cos(alpha), d
    return T
""",
)
wrong(
    "dh",
    "matrix-entry-mistyped",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * c], [0, sa, ca, d], [0, 0, 0, 1]])
""",
)
wrong(
    "dh",
    "matrix-entry-mistyped",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    # forgot the d
    return np.array([
        [np.cos(theta), -np.sin(theta)*np.cos(alpha),  np.sin(theta)*np.sin(alpha), a*np.cos(theta)],
        [np.sin(theta),  np.cos(theta)*np.cos(alpha), -np.cos(theta)*np.sin(alpha), a*np.sin(theta)],
        [0,              np.sin(alpha),                np.cos(alpha),               0],
        [0, 0, 0, 1]])
""",
)
wrong(
    "dh",
    "matrix-entry-mistyped",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    ct, st = np.cos(theta), np.sin(theta)
    cal, sal = np.cos(alpha), np.sin(alpha)
    A = np.matrix([[ct, -st*cal, st*sal, a*ct],
                   [st, ct*cal, -ct*cal, a*st],
                   [0, sal, cal, d],
                   [0, 0, 0, 1]])
    return A
""",
)
wrong(
    "dh",
    "matrix-entry-mistyped",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([ct, -st, st*sa, a*ct, st, ct*ca, -ct*sa, a*st, 0, sa, ca, d, 0, 0, 0, 1]).reshape(4, 4)
""",
)
wrong(
    "dh",
    "matrix-entry-mistyped",
    MOVES
    + """
def dh_transform(theta, d, a, alpha):
    T = Rz(theta) @ Tx(a) @ Rx(alpha)     # d comes later
    return T
""",
)

# ---- dh_transform: order of the moves, the wrong convention, the wrong product

wrong(
    "dh",
    "standard-rows-in-craig-matrix",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st, 0, a],
                     [st*ca, ct*ca, -sa, -d*sa],
                     [st*sa, ct*sa, ca, d*ca],
                     [0, 0, 0, 1]])
""",
)
wrong(
    "dh",
    "product-reversed",
    MOVES
    + """
from functools import reduce
def dh_transform(theta, d, a, alpha):
    return reduce(lambda acc, M: M @ acc, [Rz(theta), Tz(d), Tx(a), Rx(alpha)])
""",
)
wrong(
    "dh",
    "shift-not-turned-by-theta",
    MOVES
    + """
def dh_transform(theta, d, a, alpha):
    return Tx(a) @ Rz(theta) @ Tz(d) @ Rx(alpha)
""",
)
wrong(
    "dh",
    "shift-not-turned-by-theta",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    T = np.zeros((4, 4))
    T[0:3, 0] = [np.cos(theta), np.sin(theta), 0]
    T[0:3, 1] = [-np.sin(theta)*np.cos(alpha), np.cos(theta)*np.cos(alpha), np.sin(alpha)]
    T[0:3, 2] = [np.sin(theta)*np.sin(alpha), -np.cos(theta)*np.sin(alpha), np.cos(alpha)]
    T[0:3, 3] = [a, 0, d]
    T[3, 3] = 1
    return T
""",
)
wrong(
    "dh",
    "alpha-before-d",
    MOVES
    + """
def dh_transform(theta, d, a, alpha):
    turn_z, turn_x = Rz(theta), Rx(alpha)
    return np.dot(np.dot(np.dot(turn_z, Tx(a)), turn_x), Tz(d))
""",
)
wrong(
    "dh",
    "order-taken-for-free",
    MOVES
    + """
def dh_transform(theta, d, a, alpha):
    # turns first, then shifts
    return Rz(theta) @ Rx(alpha) @ Tz(d) @ Tx(a)
""",
)
wrong(
    "dh",
    "elementwise-product",
    MOVES
    + """
def dh_transform(theta, d, a, alpha):
    return Rz(theta) * Tz(d) * Tx(a) * Rx(alpha)
""",
)
wrong(
    "dh",
    "elementwise-product",
    MOVES
    + """
def dh_transform(theta, d, a, alpha):
    T = np.eye(4)
    for M in [Rz(theta), Tz(d), Tx(a), Rx(alpha)]:
        T = np.multiply(T, M)
    return T
""",
)

# ---- dh_transform: the matrix as a whole

wrong(
    "dh",
    "sin-cos-exchanged",
    """
from math import sin, cos
import numpy
def dh_transform(theta, d, a, alpha):
    c, s = cos(theta), sin(theta)
    ca, sa = sin(alpha), cos(alpha)
    return numpy.array([[c, -s*ca, s*sa, a*c], [s, c*ca, -c*sa, a*s], [0, sa, ca, d], [0, 0, 0, 1]])
""",
)
wrong(
    "dh",
    "sin-cos-exchanged",
    """
from math import sin, cos
import numpy
def dh_transform(theta, d, a, alpha):
    st, ct, sa, ca = cos(theta), sin(theta), sin(alpha), cos(alpha)
    return numpy.array([[ct, -st*ca, st*sa, a*ct], [st, ct*ca, -ct*sa, a*st], [0, sa, ca, d], [0, 0, 0, 1]])
""",
)
wrong(
    "dh",
    "integer-arrays",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    T = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    T[0] = [c, -s*ca, s*sa, a*c]
    T[1] = [s, c*ca, -c*sa, a*s]
    T[2] = [0, sa, ca, d]
    return T
""",
)
wrong(
    "dh",
    "integer-arrays",
    MOVES
    + """
def dh_transform(theta, d, a, alpha):
    T = np.identity(4, dtype=int)
    T[:, :] = Rz(theta) @ Tz(d) @ Tx(a) @ Rx(alpha)
    return T.astype(float)
""",
)
wrong(
    "dh",
    "last-row-missing",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    T = np.zeros((4, 4))
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    T[:3, :3] = [[ct, -st*ca, st*sa], [st, ct*ca, -ct*sa], [0, sa, ca]]
    T[:3, 3] = a*ct, a*st, d
    return T
""",
)
wrong(
    "dh",
    "last-row-missing",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    R = np.array([[ct, -st*ca, st*sa], [st, ct*ca, -ct*sa], [0, sa, ca]])
    p = np.array([[a*ct], [a*st], [d]])
    return np.hstack([R, p])
""",
)
wrong(
    "dh",
    "matrix-transposed",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    x = [ct, st, 0, 0]
    y = [-st*ca, ct*ca, sa, 0]
    z = [st*sa, -ct*sa, ca, 0]
    o = [a*ct, a*st, d, 1]
    return np.array([x, y, z, o])
""",
)
wrong(
    "dh",
    "matrix-transposed",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    flat = [ct, -st*ca, st*sa, a*ct, st, ct*ca, -ct*sa, a*st, 0, sa, ca, d, 0, 0, 0, 1]
    return np.reshape(flat, (4, 4), order="F")
""",
)
wrong(
    "dh",
    "rotation-transposed",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    x = np.array([np.cos(theta), np.sin(theta), 0])
    z = np.array([np.sin(theta)*np.sin(alpha), -np.cos(theta)*np.sin(alpha), np.cos(alpha)])
    y = np.cross(z, x)
    T = np.eye(4)
    T[:3, :3] = np.stack([x, y, z])
    T[:3, 3] = a * x + [0, 0, d]
    return T
""",
)
wrong(
    "dh",
    "mirror",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    x = np.array([np.cos(theta), np.sin(theta), 0])
    z = np.array([np.sin(theta)*np.sin(alpha), -np.cos(theta)*np.sin(alpha), np.cos(alpha)])
    y = np.cross(x, z)
    T = np.eye(4)
    T[:3, :3] = np.column_stack([x, y, z])
    T[:3, 3] = a * x + [0, 0, d]
    return T
""",
)
wrong(
    "dh",
    "pose-inverted",
    MOVES
    + """
def dh_transform(theta, d, a, alpha):
    return np.linalg.inv(Rz(theta).dot(Tz(d)).dot(Tx(a)).dot(Rx(alpha)))
""",
)
wrong(
    "dh",
    "row-vector-convention",
    """
import numpy as np
def rotz(t): return np.array([[np.cos(t), np.sin(t), 0, 0], [-np.sin(t), np.cos(t), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
def rotx(t): return np.array([[1, 0, 0, 0], [0, np.cos(t), np.sin(t), 0], [0, -np.sin(t), np.cos(t), 0], [0, 0, 0, 1]])
def shift(x, z):
    T = np.eye(4)
    T[0, 3], T[2, 3] = x, z
    return T
def dh_transform(theta, d, a, alpha):
    return rotz(theta) @ shift(a, d) @ rotx(alpha)
""",
)
wrong(
    "dh",
    "alpha-sign",
    """
import numpy as np
def rotz(t): return np.array([[np.cos(t), -np.sin(t), 0, 0], [np.sin(t), np.cos(t), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
def rotx(t): return np.array([[1, 0, 0, 0], [0, np.cos(t), np.sin(t), 0], [0, -np.sin(t), np.cos(t), 0], [0, 0, 0, 1]])
def shift(x, z):
    T = np.eye(4)
    T[0, 3], T[2, 3] = x, z
    return T
def dh_transform(theta, d, a, alpha):
    return rotz(theta) @ shift(a, d) @ rotx(alpha)
""",
)

# ---- dh_transform: units, arguments, state

wrong(
    "dh",
    "converted-to-radians-twice",
    LINK
    + """
def dh_transform(theta, d, a, alpha):
    theta = np.deg2rad(theta)
    alpha = np.deg2rad(alpha)
    return dh(theta, d, a, alpha)
""",
)
wrong(
    "dh",
    "converted-to-radians-twice",
    """
import math
def dh_transform(theta_deg, d, a, alpha_deg):
    t = theta_deg / 180 * math.pi
    al = alpha_deg / 180 * math.pi
    return [[math.cos(t), -math.sin(t)*math.cos(al), math.sin(t)*math.sin(al), a*math.cos(t)],
            [math.sin(t), math.cos(t)*math.cos(al), -math.cos(t)*math.sin(al), a*math.sin(t)],
            [0, math.sin(al), math.cos(al), d], [0, 0, 0, 1]]
""",
)
wrong(
    "dh",
    "degrees-in-sin-cos",
    LINK
    + """
def dh_transform(theta, d, a, alpha):
    return dh(np.degrees(theta), d, a, np.degrees(alpha))
""",
)
wrong(
    "dh",
    "converted-to-radians-twice",
    LINK
    + """
def dh_transform(theta, d, a, alpha):
    return dh(theta, d, a, alpha * np.pi / 180)   # tables have alpha in degrees
""",
)
wrong(
    "dh",
    "length-unit",
    LINK
    + """
def dh_transform(theta, d, a, alpha):
    return dh(theta, d / 1000., a / 1000., alpha)  # mm
""",
)
wrong(
    "dh",
    "a-d-exchanged",
    LINK.replace("def dh(theta, d, a, alpha)", "def dh_transform(theta, a, d, alpha)"),
)
wrong(
    "dh",
    "columns-misread",
    LINK.replace("def dh(theta, d, a, alpha)", "def dh_transform(a, alpha, d, theta)"),
)
wrong(
    "dh",
    "columns-misread",
    LINK.replace("def dh(theta, d, a, alpha)", "def dh_transform(alpha, a, d, theta)"),
)
wrong(
    "dh",
    "columns-misread",
    LINK.replace("def dh(theta, d, a, alpha)", "def dh_transform(alpha, a, theta, d)"),
)
wrong(
    "dh",
    "pi-rounded",
    LINK
    + """
def dh_transform(theta, d, a, alpha):
    return np.round(dh(theta, d, a, alpha), 3)
""",
)
wrong(
    "dh",
    "pi-rounded",
    LINK
    + """
PI = 3.14
def dh_transform(theta, d, a, alpha):
    theta = np.radians(theta * 180 / PI)
    alpha = np.radians(alpha * 180 / PI)
    return dh(theta, d, a, alpha)
""",
)
wrong(
    "dh",
    "state-between-calls",
    MOVES
    + """
T = np.eye(4)
def dh_transform(theta, d, a, alpha):
    global T
    for M in (Rz(theta), Tz(d), Tx(a), Rx(alpha)):
        T = T @ M
    return T
""",
)
wrong(
    "dh",
    "state-between-calls",
    """
import numpy as np
M = np.zeros((4, 4)); M[3, 3] = 1
def dh_transform(theta, d, a, alpha, moves=[]):
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    moves.append(np.array([[c, -s*ca, s*sa, a*c], [s, c*ca, -c*sa, a*s], [0, sa, ca, d], [0, 0, 0, 1]]))
    return moves[0]
""",
)

# ---- dh_transform: two at once

wrong(
    "dh",
    "degrees-in-sin-cos + matrix-transposed",
    LINK
    + """
def dh_transform(theta, d, a, alpha):
    return dh(np.rad2deg(theta), d, a, np.rad2deg(alpha)).T
""",
)
wrong(
    "dh",
    "converted-to-radians-twice + standard-rows-in-craig-matrix",
    MOVES
    + """
def dh_transform(theta, d, a, alpha):
    theta, alpha = np.deg2rad(theta), np.deg2rad(alpha)
    return Rx(alpha) @ Tx(a) @ Rz(theta) @ Tz(d)
""",
)
wrong(
    "dh",
    "converted-to-radians-twice + matrix-entry-mistyped",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    th, al = np.radians(theta), np.radians(alpha)
    c, s, ca, sa = np.cos(th), np.sin(th), np.cos(al), np.sin(al)
    return np.array([[c, -s*ca, s*sa, a*c], [s, c*ca, c*sa, a*s], [0, sa, ca, d], [0, 0, 0, 1]])
""",
)
wrong(
    "dh",
    "a-d-exchanged + alpha-before-d",
    MOVES
    + """
def dh_transform(theta, a, d, alpha):
    return Rz(theta) @ Tx(a) @ Rx(alpha) @ Tz(d)
""",
)
wrong(
    "dh",
    "matrix-entry-mistyped + matrix-entry-mistyped",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[c, -s*ca, s*sa, a*s], [s, c*ca, c*sa, a*c], [0, sa, ca, d], [0, 0, 0, 1]])
""",
)

# ---- forward_kinematics: the loop

wrong(
    "fk",
    "product-reversed",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for i in range(len(rows)):
        A = dh(rows[i][0] + q[i], rows[i][1], rows[i][2], rows[i][3])
        T = np.dot(A, T)
    return T
""",
)
wrong(
    "fk",
    "product-reversed",
    LINK
    + """
from functools import reduce
def forward_kinematics(rows, q):
    As = [dh(o + x, d, a, al) for (o, d, a, al), x in zip(rows, q)]
    return reduce(lambda T, A: A @ T, As)
""",
)
wrong(
    "fk",
    "product-reversed",
    LINK
    + """
def forward_kinematics(rows, q):
    if len(q) == 0:
        return np.identity(4)
    return forward_kinematics(rows[1:], q[1:]) @ dh(rows[0][0] + q[0], *rows[0][1:])
""",
)
wrong(
    "fk",
    "product-stops-early",
    LINK
    + """
def forward_kinematics(rows, q):
    n = len(rows)
    T = np.eye(4)
    for i in range(n - 1):
        theta, d, a, alpha = rows[i]
        T = T @ dh(theta + q[i], d, a, alpha)
    return T
""",
)
wrong(
    "fk",
    "product-stops-early",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, angle in zip(rows, q):
        T = T @ dh(row[0] + angle, row[1], row[2], row[3])
        return T
""",
)
wrong(
    "fk",
    "product-starts-late",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    i = 1
    while i < len(rows):
        T = T @ dh(rows[i, 0] + q[i], rows[i, 1], rows[i, 2], rows[i, 3])
        i += 1
    return T
""",
)
wrong(
    "fk",
    "product-starts-late",
    LINK
    + """
def forward_kinematics(rows, q):
    for row, angle in zip(rows, q):
        T = np.eye(4)
        T = T @ dh(row[0] + angle, row[1], row[2], row[3])
    return T
""",
)
wrong(
    "fk",
    "link-counted-twice",
    LINK
    + """
def forward_kinematics(rows, q):
    T = dh(rows[0][0] + q[0], *rows[0][1:])
    for row, angle in zip(rows, q):
        T = T @ dh(row[0] + angle, *row[1:])
    return T
""",
)
wrong(
    "fk",
    "elementwise-product",
    LINK
    + """
def forward_kinematics(rows, q):
    T = dh(rows[0][0] + q[0], *rows[0][1:])
    for i in range(1, len(q)):
        T = T * dh(rows[i][0] + q[i], *rows[i][1:])
    return T
""",
)
wrong(
    "fk",
    "elementwise-product",
    LINK
    + """
def forward_kinematics(rows, q):
    links = np.array([dh(r[0] + x, r[1], r[2], r[3]) for r, x in zip(rows, q)])
    return np.prod(links, axis=0)
""",
)
wrong(
    "fk",
    "translations-not-rotated",
    LINK
    + """
def forward_kinematics(rows, q):
    R = np.eye(3); p = np.zeros(3)
    for row, x in zip(rows, q):
        A = dh(row[0] + x, row[1], row[2], row[3])
        p = p + A[:3, 3]
        R = R @ A[:3, :3]
    T = np.eye(4)
    T[:3, :3] = R
    T[:3, 3] = p
    return T
""",
)
wrong(
    "fk",
    "order-taken-for-free",
    LINK
    + """
def forward_kinematics(rows, q):
    R = np.eye(3); p = np.zeros(3)
    for row, x in zip(rows, q):
        A = dh(row[0] + x, row[1], row[2], row[3])
        R = R @ A[:3, :3]
        p = p + R @ A[:3, 3]          # R is already the new one
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T
""",
)

# ---- forward_kinematics: joint values and offsets

wrong(
    "fk",
    "joint-index-off-by-one",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for i, (theta, d, a, alpha) in enumerate(rows):
        T = T @ dh(theta + q[i - 1], d, a, alpha)
    return T
""",
)
wrong(
    "fk",
    "joint-index-off-by-one",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    n = len(q)
    for i, (theta, d, a, alpha) in enumerate(rows):
        T = T @ dh(theta + q[(i + 1) % n], d, a, alpha)
    return T
""",
)
wrong(
    "fk",
    "joint-index-off-by-one",
    LINK
    + """
def forward_kinematics(rows, q):
    q = list(q) + [0]
    T = np.eye(4)
    for i in range(1, len(rows) + 1):
        theta, d, a, alpha = rows[i - 1]
        T = T @ dh(theta + q[i], d, a, alpha)
    return T
""",
)
wrong(
    "fk",
    "joint-index-off-by-one",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for i in range(len(rows)):
        theta, d, a, alpha = rows[i]
        T = T @ dh(theta + q[0], d, a, alpha)
    return T
""",
)
wrong(
    "fk",
    "joints-summed",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    angle = 0
    for i, row in enumerate(rows):
        angle += q[i]
        T = T @ dh(row[0] + angle, row[1], row[2], row[3])
    return T
""",
)
wrong(
    "fk",
    "joints-summed",
    LINK
    + """
def forward_kinematics(rows, q):
    thetas = np.cumsum([row[0] + x for row, x in zip(rows, q)])
    T = np.eye(4)
    for th, row in zip(thetas, rows):
        T = T @ dh(th, *row[1:])
    return T
""",
)
wrong(
    "fk",
    "offset-missing",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for (_, d, a, alpha), theta in zip(rows, q):
        T = T @ dh(theta, d, a, alpha)
    return T
""",
)
wrong(
    "fk",
    "offset-sign",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for (offset, d, a, alpha), theta in zip(rows, q):
        T = T @ dh(theta - offset, d, a, alpha)
    return T
""",
)
wrong(
    "fk",
    "offset-subtracted",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for (offset, d, a, alpha), theta in zip(rows, q):
        T = T @ dh(offset - theta, d, a, alpha)
    return T
""",
)
wrong(
    "fk",
    "offset-counted-twice",
    LINK
    + """
def forward_kinematics(rows, q):
    q = [x + row[0] for x, row in zip(q, rows)]
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(row[0] + x, row[1], row[2], row[3])
    return T
""",
)
wrong(
    "fk",
    "joint-values-unused",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for i in range(len(q)):
        T = T @ dh(*rows[i])
    return T
""",
)
wrong(
    "fk",
    "all-joints-left-handed",
    """
import numpy as np
def forward_kinematics(rows, q):
    T = np.eye(4)
    for (o, d, a, al), x in zip(rows, q):
        t = o + x
        Rz = np.array([[np.cos(t), np.sin(t), 0, 0], [-np.sin(t), np.cos(t), 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])
        Rx = np.array([[1, 0, 0, a], [0, np.cos(al), -np.sin(al), 0], [0, np.sin(al), np.cos(al), 0], [0, 0, 0, 1]])
        T = T @ Rz @ Rx
    return T
""",
)

# ---- forward_kinematics: units

wrong(
    "fk",
    "converted-to-radians-twice",
    LINK
    + """
def forward_kinematics(rows, q):
    q = np.deg2rad(q)
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(row[0] + x, *row[1:])
    return T
""",
)
wrong(
    "fk",
    "converted-to-radians-twice",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(np.radians(row[0] + x), row[1], row[2], np.radians(row[3]))
    return T
""",
)
wrong(
    "fk",
    "converted-to-radians-twice",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(np.radians(row[0]) + x, row[1], row[2], row[3])
    return T
""",
)
wrong(
    "fk",
    "degrees-in-sin-cos",
    LINK
    + """
def forward_kinematics(rows, q):
    q_deg = [x * 180 / np.pi for x in q]
    T = np.eye(4)
    for row, x in zip(rows, q_deg):
        T = T @ dh(row[0] + x, *row[1:])
    return T
""",
)
wrong(
    "fk",
    "length-unit",
    LINK
    + """
def forward_kinematics(rows, q):
    rows = np.array(rows) * [1, 0.001, 0.001, 1]
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(row[0] + x, *row[1:])
    return T
""",
)

# ---- forward_kinematics: rows, matrices, results

wrong(
    "fk",
    "a-alpha-from-previous-row",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for i in range(len(rows)):
        a = rows[i-1][2] if i > 0 else 0
        alpha = rows[i-1][3] if i > 0 else 0
        T = T @ dh(rows[i][0] + q[i], rows[i][1], a, alpha)
    return T
""",
)
wrong(
    "fk",
    "standard-rows-in-craig-matrix",
    """
import numpy as np
def A(theta, d, a, alpha):
    ct, st = np.cos(theta), np.sin(theta)
    ca, sa = np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st, 0, a], [st*ca, ct*ca, -sa, -d*sa], [st*sa, ct*sa, ca, d*ca], [0, 0, 0, 1]])
def forward_kinematics(dh_table, q):
    T = np.eye(4)
    for k in range(len(q)):
        T = T @ A(dh_table[k][0] + q[k], dh_table[k][1], dh_table[k][2], dh_table[k][3])
    return T
""",
)
wrong(
    "fk",
    "columns-misread",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for (a, alpha, d, theta), x in zip(rows, q):
        T = T @ dh(theta + x, d, a, alpha)
    return T
""",
)
wrong(
    "fk",
    "a-d-exchanged",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for (theta, a, d, alpha), x in zip(rows, q):
        T = T @ dh(theta + x, d, a, alpha)
    return T
""",
)
wrong(
    "fk",
    "theta-alpha-exchanged",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for (alpha, d, a, theta), x in zip(rows, q):
        T = T @ dh(theta + x, d, a, alpha)
    return T
""",
)
wrong(
    "fk",
    "one-row-for-all-joints",
    LINK
    + """
def forward_kinematics(rows, q):
    links = [lambda x: dh(row[0] + x, row[1], row[2], row[3]) for row in rows]
    T = np.eye(4)
    for link, x in zip(links, q):
        T = T @ link(x)
    return T
""",
)
wrong(
    "fk",
    "pose-inverted",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(row[0] + x, *row[1:])
    return np.linalg.inv(T)
""",
)
wrong(
    "fk",
    "rotation-transposed",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(row[0] + x, *row[1:])
    pose = np.eye(4)
    pose[:3, :3] = [T[:3, 0], T[:3, 1], T[:3, 2]]
    pose[:3, 3] = T[:3, 3]
    return pose
""",
)
wrong(
    "fk",
    "matrix-transposed",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = dh(row[0] + x, *row[1:]).T @ T
    return T
""",
)
wrong(
    "fk",
    "integer-arrays",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    for row, x in zip(rows, q):
        T[:] = T @ dh(row[0] + x, *row[1:])
    return T
""",
)
wrong(
    "fk",
    "pi-rounded",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = np.around(T @ dh(row[0] + x, *row[1:]), 3)
    return T
""",
)
wrong(
    "fk",
    "last-row-missing",
    """
import numpy as np
def dh(theta, d, a, alpha):
    T = np.zeros((4, 4))
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    T[:3] = [[ct, -st*ca, st*sa, a*ct], [st, ct*ca, -ct*sa, a*st], [0, sa, ca, d]]
    return T
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(row[0] + x, *row[1:])
    return T
""",
)
wrong(
    "fk",
    "matrix-entry-mistyped",
    """
import numpy as np
def dh(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st * ca, st * sa, a * ct], [st, ct * ca, -ct * sa, a * ca], [0, sa, ca, d], [0, 0, 0, 1]])
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(row[0] + x, *row[1:])
    return T
""",
)
wrong(
    "fk",
    "matrix-entry-mistyped",
    """
from math import cos, sin
def mul(A, B):
    return [[sum(A[i][k] * B[k][j] for k in range(4)) for j in range(4)] for i in range(4)]
def forward_kinematics(rows, q):
    T = [[1 if i == j else 0 for j in range(4)] for i in range(4)]
    for (o, d, a, al), x in zip(rows, q):
        t = o + x
        T = mul(T, [[cos(t), -sin(t)*cos(al), sin(t)*sin(al), a*cos(t)], [sin(t), cos(t)*cos(al), -cos(t)*sin(al), a*sin(t)],
                    [0, sin(al), -cos(al), d], [0, 0, 0, 1]])
    return T
""",
)
wrong(
    "fk",
    "state-between-calls",
    LINK
    + """
def forward_kinematics(rows, q, T=np.eye(4)):
    for row, x in zip(rows, q):
        T[:] = T @ dh(row[0] + x, *row[1:])
    return T.copy()
""",
)
wrong(
    "fk",
    "state-between-calls",
    LINK
    + """
class Chain:
    def __init__(self):
        self.T = np.eye(4)
    def run(self, rows, q):
        for i in range(len(q)):
            self.T = self.T @ dh(rows[i][0] + q[i], *rows[i][1:])
        return self.T
chain = Chain()
def forward_kinematics(rows, q):
    return chain.run(rows, q)
""",
)
wrong(
    "fk",
    "state-between-calls",
    LINK
    + """
cache = {}
def forward_kinematics(rows, q):
    if len(q) not in cache:
        T = np.eye(4)
        for row, x in zip(rows, q):
            T = T @ dh(row[0] + x, *row[1:])
        cache[len(q)] = T
    return cache[len(q)]
""",
)
wrong(
    "fk",
    "inputs-changed",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for i in range(len(q)):
        rows[i][0] += q[i]
        T = T @ dh(*rows[i])
    return T
""",
)
wrong(
    "fk",
    "inputs-changed",
    LINK
    + """
def forward_kinematics(rows, q):
    q += rows[:, 0]
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(x, *row[1:])
    return T
""",
)

# ---- forward_kinematics: two at once

wrong(
    "fk",
    "product-reversed + offset-missing",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = dh(x, row[1], row[2], row[3]) @ T
    return T
""",
)
wrong(
    "fk",
    "converted-to-radians-twice + joint-index-off-by-one",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for i, row in enumerate(rows):
        T = T @ dh(row[0] + np.deg2rad(q[i-1]), *row[1:])
    return T
""",
)
wrong(
    "fk",
    "matrix-entry-mistyped + product-reversed",
    """
import numpy as np
def dh(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st * ca, st * sa, a * ct], [st, ct * ca, ct * sa, a * st], [0, sa, ca, d], [0, 0, 0, 1]])
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = dh(row[0] + x, *row[1:]) @ T
    return T
""",
)
wrong(
    "fk",
    "product-stops-early + converted-to-radians-twice",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for i in range(len(rows) - 1):
        T = T @ dh(rows[i][0] + np.radians(q[i]), *rows[i][1:])
    return T
""",
)
wrong(
    "fk",
    "product-stops-early + joint-index-off-by-one",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q[1:]):
        T = T @ dh(row[0] + x, *row[1:])
    return T
""",
)
wrong(
    "fk",
    "a-d-exchanged + offset-missing",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(x, row[2], row[1], row[3])
    return T
""",
)
wrong(
    "fk",
    "standard-rows-in-craig-matrix + offset-sign",
    MOVES
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for (o, d, a, al), x in zip(rows, q):
        T = T @ Rx(al) @ Tx(a) @ Rz(x - o) @ Tz(d)
    return T
""",
)
wrong(
    "fk",
    "matrix-entry-mistyped + joints-summed",
    """
import numpy as np
def dh(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[ct, st * ca, st * sa, a * ct], [st, ct * ca, -ct * sa, a * st], [0, sa, ca, d], [0, 0, 0, 1]])
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, np.cumsum(q)):
        T = T @ dh(row[0] + x, *row[1:])
    return T
""",
)
wrong(
    "fk",
    "pose-inverted + offset-missing",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(x, *row[1:])
    R, p = T[:3, :3], T[:3, 3]
    return np.vstack([np.column_stack([R.T, -R.T @ p]), [0, 0, 0, 1]])
""",
)
wrong(
    "fk",
    "shift-not-turned-by-theta + converted-to-radians-twice",
    """
import numpy as np
def dh(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[ct, -st * ca, st * sa, a], [st, ct * ca, -ct * sa, 0], [0, sa, ca, d], [0, 0, 0, 1]])
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(row[0] + np.deg2rad(x), *row[1:])
    return T
""",
)
wrong(
    "fk",
    "matrix-entry-mistyped + matrix-entry-mistyped",
    """
import numpy as np
def dh(theta, d, a, alpha):
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[ct, st * ca, st * sa, a * ct], [st, ct * ca, ct * sa, a * st], [0, sa, ca, d], [0, 0, 0, 1]])
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(row[0] + x, *row[1:])
    return T
""",
)

# ---- right ones in odd styles

right("dh", LINK.replace("def dh(", "def dh_transform("))
right(
    "dh",
    LINK + "def dh_transform(theta, d, a, alpha):\n    return dh(theta, d, a, alpha).tolist()\n",
)
right(
    "dh",
    LINK + "def dh_transform(theta, d, a, alpha):\n    return np.matrix(dh(theta, d, a, alpha))\n",
)
right(
    "dh",
    LINK + "def dh_transform(theta, d, a, alpha):\n    return dh(theta, d, a,"
    " alpha).astype(np.float32)\n",
)
right(
    "dh",
    MOVES + "def dh_transform(*row):\n    print(row)\n    t, d, a, al = row\n    return"
    " np.linalg.multi_dot([Tz(d), Rz(t), Rx(al), Tx(a)])\n",
)
right(
    "dh",
    """
import cmath
def dh_transform(theta, d, a, alpha):
    e, f = cmath.exp(1j * theta), cmath.exp(1j * alpha)
    c, s, u, v = e.real, e.imag, f.real, f.imag
    return ((c, -s * u, s * v, a * c), (s, c * u, -c * v, a * s), (0, v, u, d), (0, 0, 0, 1))
""",
)
right(
    "dh",
    """
import numpy as np
from scipy.spatial.transform import Rotation as R
def dh_transform(theta, d, a, alpha):
    T = np.eye(4)
    T[:3, :3] = R.from_euler("ZX", [theta, alpha]).as_matrix()
    T[:3, 3] = R.from_euler("z", theta).apply([a, 0, d])
    return T
""",
)
right(
    "dh",
    """
import numpy as np
M = np.zeros((4, 4))          # reused, but filled anew each time
def dh_transform(theta, d, a, alpha):
    M[:] = [[np.cos(theta), -np.sin(theta)*np.cos(alpha), np.sin(theta)*np.sin(alpha), a*np.cos(theta)],
            [np.sin(theta), np.cos(theta)*np.cos(alpha), -np.cos(theta)*np.sin(alpha), a*np.sin(theta)],
            [0, np.sin(alpha), np.cos(alpha), d], [0, 0, 0, 1]]
    return M
""",
)
right(
    "fk",
    LINK
    + """
from functools import reduce
def forward_kinematics(rows, q):
    return reduce(np.matmul, [dh(r[0] + x, r[1], r[2], r[3]) for r, x in zip(rows, q)]).tolist()
""",
)
right(
    "fk",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.asmatrix(np.eye(4))
    for i in range(len(rows)):
        T = T * np.asmatrix(dh(rows[i][0] + q[i], *rows[i][1:]))
    return T
""",
)
right(
    "fk",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in reversed(list(zip(rows, q))):
        T = dh(row[0] + x, *row[1:]) @ T
    return T
""",
)
right(
    "fk",
    LINK
    + """
def forward_kinematics(rows, q, i=0):
    if i == len(q):
        return np.eye(4)
    return dh(rows[i][0] + q[i], *rows[i][1:]) @ forward_kinematics(rows, q, i + 1)
""",
)
right(
    "fk",
    LINK
    + """
class Robot:
    def __init__(self, rows):
        self.rows = [tuple(r) for r in rows]
    def __call__(self, q):
        T = np.eye(4, dtype=np.float32)
        for (o, d, a, al), x in zip(self.rows, q):
            T = T @ dh(o + x, d, a, al).astype(np.float32)
        return T
def forward_kinematics(rows, q):
    return Robot(rows)(q)
""",
)
right(
    "fk",
    """
from math import cos, sin
def forward_kinematics(rows, q):
    R, p = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0]
    for (o, d, a, al), x in zip(rows, q):
        t = o + x
        A = [[cos(t), -sin(t)*cos(al), sin(t)*sin(al)], [sin(t), cos(t)*cos(al), -cos(t)*sin(al)], [0, sin(al), cos(al)]]
        v = [a*cos(t), a*sin(t), d]
        p = [p[i] + sum(R[i][k] * v[k] for k in range(3)) for i in range(3)]
        R = [[sum(R[i][k] * A[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    return [R[0] + [p[0]], R[1] + [p[1]], R[2] + [p[2]], [0, 0, 0, 1]]
""",
)
right(
    "fk",
    """
import dhlab
def forward_kinematics(rows, q):
    return dhlab.Arm(dhlab.DHTable.standard(rows, angle="rad")).forward(q)
""",
)
right(
    "fk",
    LINK
    + """
T = np.eye(4)
def forward_kinematics(rows, q):
    global T
    T = np.eye(4)
    for k in range(len(q)):
        T = T.dot(dh(q[k] + rows[k][0], rows[k][1], rows[k][2], rows[k][3]))
    return T
""",
)
