"""Options and outcomes that tell of the story or of a rule: computed as far as they can be, and of
the others why nothing decides them.
"""

from itertools import pairwise

import numpy as np

from . import facts
from .chosen import Q, article, constant, jacobian, on_a_circle, same, turn, turned_round, z_axis
from .reasons import NAMES, STORY, near
from .vectors import ARTICLE, one_row, walk

LESSON = "its lesson's own tests compute it"


def no_row(T):
    """Whether no row makes a pose: its x leans to the old z, or passes it by."""
    return abs(T[2, 0]) + abs(np.cross([0, 0, 1], T[:3, 0]) @ T[:3, 3]) > 1e-6


def shifted(T, by):
    moved = T.copy()
    moved[:3, 3] += T[:3, :3] @ by
    return moved


def slid_origin(alpha):
    """The new origin slid along its own z: whether a row still makes it."""
    return not no_row(shifted(one_row(20, 0.1, 0.3, alpha), [0, 0, 0.2]))


def between_axes(a):
    """The distance of the old z axis and the new one, of a row with this a."""
    T = one_row(20, 0.1, a, 40)
    across = np.cross([0, 0, 1], T[:3, 2])
    return abs(T[:3, 3] @ across) / np.linalg.norm(across)


def x_is_the_way_across():
    """Between parallel axes a row is made where the new x points from one to the other alone."""
    T = one_row(20, 0.1, 0.3, 0)
    other = T.copy()
    other[:3, :3] = T[:3, :3] @ turn("z", 50)
    return not no_row(T) and no_row(other) and slid_origin(0)


def foot_on_the_new_axis():
    """From the new origin the line of x meets the old z at a right angle, and its own z too."""
    T = one_row(20, 0.1, 0.3, 40)
    back = T[:3, 3] - 0.3 * T[:3, 0]
    return near(back[:2], [0, 0]) and np.isclose(T[2, 0], 0) and np.isclose(T[:3, 0] @ T[:3, 2], 0)


def step_lies_along():
    rows = np.array(ARTICLE, dtype=float)
    rows[1, 1] = 0.1
    return same((walk(rows, Q) - article(Q))[:3, 3], 0.1 * z_axis(2))


def converted():
    """The article's rows as Craig's, pairs one row down and the last behind the last joint."""
    rows = np.array(ARTICLE, dtype=float)
    craig = np.column_stack([rows[:, :2], np.vstack([[0, 0], rows[:-1, 2:]])])
    return same(walk(craig, Q, "craig") @ one_row(0, 0, *rows[-1, 2:]), article(Q))


def alpha_between_axes():
    """At every q the angle of neighbouring axes is the α of the row between them."""
    return all(
        np.isclose(z_axis(k, q) @ z_axis(k + 1, q), np.cos(np.radians(ARTICLE[k - 1][3])))
        for q in (Q, -Q, 0 * Q)
        for k in range(1, 6)
    )


def coupled_leaves_the_circle():
    """Where another joint moves along with joint 5, the points lie on no circle."""
    points = np.array([
        walk(ARTICLE, [*Q[:3], 0.5 * x, x, Q[5]])[:3, 3] for x in np.linspace(-80, 80, 9)
    ])  # fmt: skip
    return np.linalg.matrix_rank(np.diff(points, axis=0), tol=1e-6) == 3


def no_limit():
    """A pose is there for any angles, and right for them."""
    return (
        same(article([500, *Q[1:]]), article([140, *Q[1:]]))
        and np.isfinite(article([9000.0] * 6)).all()
    )


def speeds_across(theta_5):
    """Joint speeds, degrees a second, that turn the hand by 10° a second across axes 4 and 5."""
    q = [0, 40, -60, 50, theta_5, 0]
    across = np.cross(z_axis(4, q), z_axis(5, q))
    return np.linalg.solve(jacobian(q), [0, 0, 0, *(10 * across)])


def whirl():
    near_it, before = speeds_across(1), speeds_across(5)
    grown = np.sin(np.radians(5)) / np.sin(np.radians(1))
    return near(near_it[[3, 5]].round(), [572, -573]) and np.allclose(
        near_it[[3, 5]] / before[[3, 5]], grown, rtol=0.01
    )


CUP, OTHER_WRIST = [30, 60, -80, -30, 40, 0], [30, 60, -80, 150, -40, 180]


def no_nearer_to_singular():
    """Both wrists reach one pose, and are as far from a singularity, whose cond has no end."""
    one, other = (np.linalg.cond(jacobian(q)) for q in (CUP, OTHER_WRIST))
    return (
        same(article(CUP), article(OTHER_WRIST))
        and np.isclose(one, other)
        and np.linalg.cond(jacobian([30, 60, -80, -30, 0.01, 0])) > 1e3
    )


def both_jump_by_half_a_turn():
    return sorted(np.abs(np.subtract(CUP, OTHER_WRIST))[[3, 5]]) == [180, 180]


def turned_base():
    """Of a UR5e: how far the ends are apart, seen from two bases half a turn about z away."""
    q = np.random.default_rng(9).uniform(-2, 2, (8, 6))
    ends = [facts.ur5e(x)[:3, 3] for x in q]
    apart = [np.linalg.norm(p - turn("z", 180) @ p) for p in ends]
    return max(apart) > 1


def three_x_turned():
    """Of the maker's UR5e, x2, x3 and x5 turned round: two lengths change their signs, no pose."""
    other = facts.UR5E.copy()
    for k in (2, 3, 5):
        other[k - 1, 2:] *= -1
        other[k - 1 : k + 1, 0] += 180
    changed = (other[:, 2] != facts.UR5E[:, 2]).sum()
    return same(walk(other, Q), walk(facts.UR5E, Q)) and changed == 2


def numbers_of(frames):
    """The rows of frames, each z, origin and x, from the way between neighbours."""
    poses = []
    for z, o, x in np.array(frames, dtype=float):
        poses.append(np.column_stack([x, np.cross(z, x), z, o]))
    rows = []
    for A, B in pairwise(poses):
        R, p = A[:, :3].T @ B[:, :3], A[:, :3].T @ (B[:, 3] - A[:, 3])
        angles = np.degrees([np.arctan2(R[1, 0], R[0, 0]), np.arctan2(R[2, 1], R[2, 2])])
        rows.append([angles[0], p[2], p @ R[:, 0], angles[1]])
    return np.array(rows)


def ada_and_bo():
    """Two learners' frames of one arm: more than half of the twelve numbers differ, and no frame
    is the same.
    """
    Z, Y, X, H = np.array([[0, 0, 1], [0, 1, 0], [1, 0, 0], [0.1, 0, 0.4]], dtype=float)
    elbow = [0.1, 0, 0.8]
    ada = [[Z, 0 * X, X], [Y, H, X], [Y, elbow, Z], [X, [0.1, 0.1, 0.8], -Z]]
    bo = [[Z, 0.2 * Z, Y], [-Y, H, -X], [Y, [0.1, 0.3, 0.8], Z], [Y, [0.5, 0.1, 0.8], X]]
    off = np.abs(numbers_of(ada) - numbers_of(bo)) > 1e-6
    apart = all(any(not np.allclose(*pair) for pair in zip(a, b)) for a, b in zip(ada, bo))
    return apart and off.any(axis=1).all() and 2 * off.sum() > off.size


OPTIONS = {
    ("01.6", "flange-and-tip"): lambda: constant("tool") and not constant("base"),
    ("02.2", "link-length"): lambda: (
        np.isclose(between_axes(0.3), 0.3) and np.isclose(between_axes(0.1), 0.1)
    ),
    ("02.5", "any-two-plates"): lambda: no_row(shifted(one_row(20, 0.1, 0.3, 40), [0, 0.08, 0])),
    ("03.4", "clockwise"): facts.left_hands_count_backwards,
    ("04.3", "any-point"): lambda: not slid_origin(40) and slid_origin(0),
    ("04.8", "nothing"): lambda: turned_round("z2", True),
    ("04.8", "theta-2"): facts.z_hangs_on_five,
    ("04.6", "neither"): step_lies_along,
    ("04.9", "convention"): converted,
    ("06.4", "limits"): no_limit,
    ("06.5", "cannot-tell"): alpha_between_axes,
    ("06.8", "error"): no_limit,
    ("06.8", "wrong-pose"): no_limit,
    ("07.5", "measurement"): lambda: on_a_circle(np.random.default_rng(4).uniform(-2, 2, (6, 4))),
    ("07.5", "nothing"): coupled_leaves_the_circle,
    ("08.12", "singular"): no_nearer_to_singular,
    ("08.12", "branch"): no_nearer_to_singular,
    ("08.12", "limit"): both_jump_by_half_a_turn,
    ("09.9", "nothing"): lambda: same(
        article(Q, np.array(ARTICLE) + np.outer(np.eye(6)[5], [0, 0, 0, 70]))[:3, 3],
        article(Q)[:3, 3],
    ),
}
OUTCOMES = {
    "04.P1": foot_on_the_new_axis,
    "04.P2": ada_and_bo,
    "04.P3": x_is_the_way_across,
    "08.P2": whirl,
    "09.P1": three_x_turned,
    "09.P2": turned_base,
}
UNDECIDED = {
    ("01.6", "tilted"): STORY,
    ("01.6", "transposed"): STORY,
    ("01.6", "wrong-order"): STORY,
    ("02.2", "joint-angle"): NAMES,
    ("02.2", "all-four"): NAMES,
    ("02.5", "one-freedom"): NAMES,
    ("04.3", "housing"): NAMES,
    ("08.3", "limit"): NAMES,
    **{("08.7", o): LESSON for o in ("solver-wrong", "clip", "another-answer", "more-damping")},
    ("08.12", "damping"): NAMES,
    "00.P2": LESSON,
    "08.P3": LESSON,
    "08.P4": LESSON,
}
