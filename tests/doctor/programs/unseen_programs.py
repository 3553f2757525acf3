"""More wrong programs, written after the doctor was finished and not used to improve it: what it
makes of programs it was not built on.

``UNSEEN`` is as ``WRONG`` in ``wrong_programs.py``; the expectations were written down before the
first run.
"""

from wrong_programs import KINDS, LINK, MOVES

UNSEEN = []


def unseen(kind, ids, text):
    UNSEEN.append((KINDS[kind], tuple(ids.split(" + ")), text))


unseen(
    "dh",
    "matrix-entry-mistyped",
    LINK.replace("def dh(", "def dh_transform(").replace("[0, sa, ca, d]", "[0, sa, ca, d * ca]"),
)
unseen(
    "dh",
    "matrix-entry-mistyped",
    LINK.replace("def dh(", "def dh_transform(").replace("-ct * sa", "-ct - sa"),
)
unseen(
    "dh",
    "matrix-entry-mistyped",
    LINK.replace("def dh(", "def dh_transform(").replace("a * ct]", "a + ct]"),
)
unseen(
    "dh",
    "sin-cos-exchanged + matrix-transposed",
    LINK
    + """
def dh_transform(theta, d, a, alpha):
    return dh(theta, d, a, np.pi/2 - alpha).T
""",
)
unseen(
    "dh",
    "degrees-in-sin-cos",
    """
import numpy as np
def dh_transform(theta, d, a, alpha):
    c, s, ca, sa = np.cos(np.rad2deg(theta)), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[c, -s*ca, s*sa, a*c], [s, c*ca, -c*sa, a*s], [0, sa, ca, d], [0, 0, 0, 1]])
""",
)
unseen(
    "dh",
    "converted-to-radians-twice + length-unit",
    LINK
    + """
def dh_transform(theta, d, a, alpha):
    return dh(np.deg2rad(theta), d / 1000, a / 1000, np.deg2rad(alpha))
""",
)
unseen(
    "dh",
    "lengths-made-positive",
    LINK + "def dh_transform(theta, d, a, alpha):\n    return dh(theta, abs(d), abs(a), alpha)\n",
)
unseen(
    "dh",
    "pose-inverted + row-vector-convention",
    MOVES
    + """
def dh_transform(theta, d, a, alpha):
    return np.linalg.inv(Rz(-theta) @ Tz(d) @ Tx(a) @ Rx(-alpha))
""",
)
unseen(
    "dh",
    "integer-arrays",
    """
import math
def dh_transform(theta, d, a, alpha):
    T = [[math.cos(theta), -math.sin(theta)*math.cos(alpha), math.sin(theta)*math.sin(alpha), a*math.cos(theta)],
         [math.sin(theta), math.cos(theta)*math.cos(alpha), -math.cos(theta)*math.sin(alpha), a*math.sin(theta)],
         [0, math.sin(alpha), math.cos(alpha), d], [0, 0, 0, 1]]
    return [[int(x) for x in row] for row in T]
""",
)
unseen(
    "dh",
    "rotation-block-misread",
    LINK
    + """
def dh_transform(theta, d, a, alpha):
    T = dh(theta, d, a, alpha)
    T[:, [1, 2]] = T[:, [2, 1]]
    return T
""",
)
unseen(
    "fk",
    "product-reversed + converted-to-radians-twice",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, np.radians(q)):
        T = np.matmul(dh(row[0] + x, *row[1:]), T)
    return T
""",
)
unseen(
    "fk",
    "extra-or-missing-row",
    LINK
    + """
def forward_kinematics(rows, q):
    T = dh(0, 0, 0, np.pi/2)
    for row, x in zip(rows, q):
        T = T @ dh(row[0] + x, *row[1:])
    return T
""",
)
unseen(
    "fk",
    "product-stops-early + product-starts-late",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for i in range(1, len(rows) - 1):
        T = T @ dh(rows[i][0] + q[i], *rows[i][1:])
    return T
""",
)
unseen(
    "fk",
    "product-starts-late + joint-index-off-by-one",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows[1:], q):
        T = T @ dh(row[0] + x, *row[1:])
    return T
""",
)
unseen(
    "fk",
    "state-between-calls",
    LINK
    + """
class Arm:
    frames = [np.eye(4)]
    def forward(self, rows, q):
        for row, x in zip(rows, q):
            self.frames.append(self.frames[-1] @ dh(row[0] + x, *row[1:]))
        return self.frames[-1]
def forward_kinematics(rows, q):
    return Arm().forward(rows, q)
""",
)
unseen(
    "fk",
    "offset-sign + product-stops-early",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for i in range(len(q) - 1):
        T = T @ dh(q[i] - rows[i][0], *rows[i][1:])
    return T
""",
)
unseen(
    "fk",
    "matrix-transposed + product-reversed",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = dh(row[0] + x, *row[1:]) @ T
    return T.T
""",
)
unseen(
    "fk",
    "rotation-transposed",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        A = dh(row[0] + x, *row[1:])
        A[:3, :3] = A[:3, :3].T
        T = T @ A
    return T
""",
)
unseen(
    "fk",
    "offset-counted-twice + a-d-exchanged",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for (o, a, d, al), x in zip(rows, q):
        T = T @ dh(o + x + o, d, a, al)
    return T
""",
)
unseen(
    "fk",
    "columns-misread + product-reversed",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for (al, a, d, th), x in zip(rows, q):
        T = dh(th + x, d, a, al) @ T
    return T
""",
)
unseen(
    "fk",
    "translations-not-rotated + offset-missing",
    LINK
    + """
def forward_kinematics(rows, q):
    R, p = np.eye(3), np.zeros(3)
    for row, x in zip(rows, q):
        A = dh(x, *row[1:])
        R, p = R @ A[:3, :3], p + A[:3, 3]
    return np.vstack([np.c_[R, p], [0, 0, 0, 1]])
""",
)
unseen(
    "fk",
    "pi-rounded",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(round(row[0] + x, 2), row[1], row[2], round(row[3], 2))
    return T
""",
)
unseen(
    "fk",
    "prismatic-variable-in-theta",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(row[0], row[1] + x, row[2], row[3])
    return T
""",
)
unseen(
    "fk",
    "last-row-missing",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for row, x in zip(rows, q):
        T = T @ dh(row[0] + x, *row[1:])
    return T[:3]
""",
)
unseen(
    "fk",
    "joints-summed + matrix-entry-mistyped",
    LINK.replace("[0, sa, ca, d]", "[0, -sa, ca, d]")
    + """
def forward_kinematics(rows, q):
    T, total = np.eye(4), 0.0
    for row, x in zip(rows, q):
        total = total + x
        T = T @ dh(row[0] + total, *row[1:])
    return T
""",
)
unseen(
    "fk",
    "product-stops-early",
    LINK
    + """
def forward_kinematics(rows, q):
    T = np.eye(4)
    for i in range(6):
        if i < len(rows) - 1:
            T = T @ dh(rows[i][0] + q[i], *rows[i][1:])
        else:
            break
    return T
""",
)
