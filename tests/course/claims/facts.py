"""What is always so, computed: by products of turns and shifts, and from the lines of axes."""

import numpy as np

from .programs import chain, link

CRAIG, STANDARD = ("Rx", "Tx", "Rz", "Tz"), ("Rz", "Tz", "Tx", "Rx")

ROWS = np.array([[0.3, 0.2, 0.4, 0.5], [-0.7, 0.1, 0.3, -0.9], [1.1, 0.3, 0.2, 0.4]])


def _pose(rows, order):
    return chain([link(row, order) for row in rows])


def x_hangs_on_four():
    """x_1 turned round in a standard table: a_1, α_1, θ_1, θ_2 change, and the arm stays."""
    other = ROWS * [[1, 1, -1, -1], [1, 1, 1, 1], [1, 1, 1, 1]]
    other[:2, 0] += np.pi
    some = ROWS.copy()
    some[0, 0] += np.pi
    return np.allclose(_pose(other, STANDARD), _pose(ROWS, STANDARD)) and not np.allclose(
        _pose(some, STANDARD), _pose(ROWS, STANDARD)
    )


def _z_turned(order, before, behind, joint):
    other = ROWS.copy()
    other[[before, behind], 3] += np.pi
    other[joint, :2] *= -1
    return np.allclose(_pose(other, order), _pose(ROWS, order))


def z_hangs_on_five():
    """z_1 turned round: the twists to and from it, and the joint about it."""
    return _z_turned(STANDARD, 0, 1, 1)


def z_of_craig():
    """z_2 of Craig's, the axis of joint 2: α_1 in row 2, α_2 in row 3, d_2 and θ_2."""
    return _z_turned(CRAIG, 1, 2, 1)


def order_counts():
    """A turn before a shift across its axis carries the shift along; a shift along it, not."""
    turned = link([0.5, 0, 0.3, 0], ("Rz", "Tx")), link([0.5, 0, 0.3, 0], ("Tx", "Rz"))
    along = link([0.5, 0.3, 0, 0], ("Rz", "Tz")), link([0.5, 0.3, 0, 0], ("Tz", "Rz"))
    return not np.allclose(*turned) and np.allclose(*along)


def new_z_after_tipping():
    tipped = link([0, 0, 0, 0.5], ("Rx",))[:3, 2]
    gone = link([0, 0.3, 0, 0.5], ("Rx", "Tz"))[:3, 3]
    return not np.allclose(tipped, [0, 0, 1]) and np.allclose(gone, 0.3 * tipped)


def last_column_of_standard():
    theta, d, a, _ = row = [0.4, 0.3, 0.5, 0.9]
    return np.allclose(link(row, STANDARD)[:3, 3], [a * np.cos(theta), a * np.sin(theta), d])


def last_row_carries():
    left, right = link([0, 0.3, 0.4, 0], STANDARD), link([0.2, 0.1, 0.2, 0.3], STANDARD)
    without = right * [[1], [1], [1], [0]]
    return np.allclose((left @ without)[:3, 3], right[:3, 3])


def arrows_are_columns():
    R = link(ROWS[0], STANDARD)[:3, :3]
    x, y, z = R.T
    return np.allclose(np.cross(x, y), z) and np.allclose(R.T @ R, np.eye(3))


def right_factor_in_new_frame():
    """T_12's shift is turned by R_01 when it is multiplied on the right."""
    A, B = link(ROWS[0], STANDARD), link(ROWS[1], STANDARD)
    return np.allclose((A @ B)[:3, 3], A[:3, :3] @ B[:3, 3] + A[:3, 3])


def inverse_sees_back():
    T = link(ROWS[0], STANDARD)
    return np.allclose(np.linalg.inv(T)[:3, 3], -T[:3, :3].T @ T[:3, 3])


def no_quadrant():
    """Of two angles with one sine (or quotient), asin (or atan) gives one."""
    return np.isclose(np.arcsin(np.sin(2.0)), np.pi - 2) and np.isclose(
        np.arctan(np.sin(2.0) / np.cos(2.0)), 2 - np.pi
    )


def star_is_by_entries():
    A = np.arange(9.0).reshape(3, 3)
    return (A * A)[1, 2] == 25 and (A @ A)[1, 2] == A[1] @ A[:, 2]


def whole_numbers_cut():
    grid = np.array([[1, 0], [0, 1]])
    grid[0, 0] = 0.7071
    return grid[0, 0] == 0 and grid.dtype.kind == "i"


def turn_back_from_goal():
    R, G = link(ROWS[0], STANDARD)[:3, :3], link(ROWS[1], STANDARD)[:3, :3]
    return np.allclose((G @ R.T) @ R, G) and np.allclose(R @ (R.T @ G), G)


# the article's six axes as directions and points, from its drawing
AXES = [
    ([0, 0, 1], [0, 0, 0]), ([0, -1, 0], [0, 0, 0.1]), ([0, -1, 0], [0.4, 0, 0.1]),
    ([0, -1, 0], [0.75, 0, 0.1]), ([0, 0, -1], [0.75, -0.1, 0]), ([0, -1, 0], [0.75, 0, 0.1]),
]  # fmt: skip


def how(one, other):
    """How two axes, (point, direction), lie to each other, from the lines alone."""
    (p, u), (s, v) = ([np.array(x, dtype=float) for x in axis[:2]] for axis in (one, other))
    across, between = np.cross(u, v), s - p
    if np.allclose(across, 0):
        return "line" if np.allclose(np.cross(u, between), 0) else "parallel"
    return "meet" if np.isclose(between @ across, 0) else "skew"


def lies(k):
    """How axis k + 1 of the article's arm lies to axis k."""
    return how(*((point, direction) for direction, point in AXES[k - 1 : k + 1]))


def sum_of_d_counts():
    """Of two neighbours with α = 0 between them a part of d moves from the one to the other."""
    parallel = ROWS * [[1, 1, 1, 0], [1, 1, 1, 1], [1, 1, 1, 1]]
    moved = parallel + np.outer([0.1, -0.1, 0], [0, 1, 0, 0])
    both = parallel + np.outer([0.1, 0, 0], [0, 1, 0, 0])
    there = _pose(parallel, STANDARD)
    return np.allclose(_pose(moved, STANDARD), there) and not np.allclose(
        _pose(both, STANDARD), there
    )


UR5E = np.column_stack([  # the maker's numbers, degrees and metres
    np.zeros(6), (0.1625, 0, 0, 0.1333, 0.0997, 0.0996), (0, -0.425, -0.3922, 0, 0, 0),
    (90, 0, 0, 90, -90, 0),
])  # fmt: skip


def ur5e(q):
    """The end of a UR5e, by its maker's numbers."""
    return _pose(np.column_stack([q, UR5E[:, 1:3], np.radians(UR5E[:, 3])]), STANDARD)


def reaches(q, T):
    """Whether the UR5e's end comes to the place of T, to a millimetre."""
    return np.linalg.norm(ur5e(q)[:3, 3] - np.asarray(T)[:3, 3]) < 1.1e-3


def straight_line_of_a_bend():
    """A link of 282 mm with a step of 24 mm: the straight line between its ends, and its turn."""
    seen, step = 0.282, 0.024
    turn = np.arctan(step / seen)
    straight = np.hypot(seen, step) * np.array([np.cos(turn), np.sin(turn)])
    return turn > 0.01 and np.allclose(straight, [seen, step])


def same_rows_another_arm():
    return not np.allclose(_pose(ROWS, CRAIG), _pose(ROWS, STANDARD))


def only_standard_ends_with_a_link():
    """The last a and alpha move the end of standard rows from where the last joint left it; Craig's
    rows end with the joint.
    """
    return STANDARD[2:] == ("Tx", "Rx") and set(CRAIG[2:]) == {"Rz", "Tz"}


def product_from_one():
    T = link(ROWS[0], STANDARD)
    return np.allclose(np.eye(4) @ T, T) and not (np.zeros((4, 4)) @ T).any()


def left_hands_count_backwards():
    """A quarter turn about z carries x to y, and its transpose carries x to −y."""
    R = link([np.pi / 2, 0, 0, 0], ("Rz",))[:3, :3]
    return np.allclose(R[:, 0], [0, 1, 0]) and np.allclose(R.T[:, 0], [0, -1, 0])


def one_keeps_its_row():
    R = link([0.4, 0, 0, 0], ("Rz",))[:3, :3]
    return R[2, 2] == 1 and np.allclose(R @ [0, 0, 1], [0, 0, 1])


def turns_look_alike():
    """Of turns by a small angle about y, z and x: the minus stands below in that about y alone."""
    angle, minus = 0.4, []
    for k in range(3):
        across = np.cross(np.eye(3)[k], np.eye(3)).T
        R = np.eye(3) + np.sin(angle) * across + (1 - np.cos(angle)) * across @ across
        i, j = np.argwhere(R < -1e-9)[0]
        minus.append(i > j)
    return minus == [False, True, False]
