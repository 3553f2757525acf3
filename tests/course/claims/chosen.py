"""What the options of a question and the outcomes of a guess assert, where it can be computed: by
products of links, differences of them and plain geometry that are not dhlab's.

``OPTIONS`` has a predicate for what an option is told, or for its text where that is the claim;
``OUTCOMES`` one for what is seen after a guess. ``further`` has those that tell of the story.
"""

from itertools import permutations

import numpy as np

from . import facts
from .vectors import ARTICLE, C, S, back, one_row, walk

Q = np.array([20.0, -35, 50, 15, 40, -60])
FLAT, TWICE = np.array(ARTICLE) * [1, 1, 1, 0], [1, 1, 1, np.pi / 180]
BENT = [0, 60, -60, 0, 0, 0]


def turn(axis, angle):
    """A turn about x, y or z of the base, (3, 3), degrees."""
    k = "xyz".index(axis)
    i, j = (k + 1) % 3, (k + 2) % 3
    R = np.eye(3)
    R[i, i], R[i, j], R[j, i], R[j, j] = C(angle), -S(angle), S(angle), C(angle)
    return R


def same(*matrices):
    return np.allclose(matrices[0], matrices[1], atol=1e-9)


def article(q, rows=ARTICLE, convention="standard"):
    return walk(rows, q, convention)


def jacobian(q, step=1e-4):
    """Six rows by differences: of the place, and of the turn seen in the base."""
    T, columns = article(q), []
    for k in range(6):
        more, less = (article(np.add(q, sign * step * np.eye(6)[k])) for sign in (1, -1))
        d = (more - less) / np.radians(2 * step)
        W = d[:3, :3] @ T[:3, :3].T
        columns.append([*d[:3, 3], W[2, 1], W[0, 2], W[1, 0]])
    return np.array(columns).T


def rank(q):
    return np.linalg.matrix_rank(jacobian(q), tol=1e-5)


def changed(row, column, by):
    rows = np.array(ARTICLE, dtype=float)
    rows[row, column] += by
    return rows


def quarter_turn_shows(rows):
    """Whether a quarter turn of joint 1 turns the whole pose about z0."""
    turned = np.eye(4)
    turned[:3, :3] = turn("z", 90)
    return same(walk(rows, [90, *Q[1:]]), turned @ walk(rows, [0, *Q[1:]]))


def on_a_circle(rows):
    """Whether the end's points lie on one circle while joint 5 alone turns."""
    points = [walk(rows, [*Q[:4], x, Q[5]])[:3, 3] for x in np.linspace(-80, 80, 9)]
    centre = np.linalg.lstsq(
        2 * np.diff(points, axis=0), np.diff(np.sum(np.square(points), axis=1)), rcond=None
    )[0]
    flat = np.linalg.matrix_rank(np.diff(points, axis=0), tol=1e-9) == 2
    return flat and np.ptp(np.linalg.norm(points - centre, axis=1)) < 1e-9


def orders_that_give(row):
    """How many of the 24 orders of the moves give the standard matrix of a row, radians."""
    right = facts.link(row, facts.STANDARD)
    return sum(np.allclose(facts.link(row, o), right) for o in permutations(facts.STANDARD))


def differ(one, other):
    return not same(one, other)


def turned_round(which, right):
    """Whether turning x1, x2 or z2 round in the article's table changes what is said, and no
    pose.
    """
    rows = np.array(ARTICLE, dtype=float)
    joints = np.ones(6)
    if which.startswith("x"):
        i = int(which[1])
        rows[i - 1, 2:] *= -1
        rows[i - 1 : i + 1, 0] += 180
    else:
        rows[1:3, 3] += 180
        rows[2, 0:2] *= -1
        joints[2] = -1
    return same(walk(rows, Q * joints), article(Q)) == right


def base_repairs(rows, convention):
    """Whether one constant pose before and one behind make two readings of the rows one arm."""
    B = walk(rows, 0 * Q) @ back(walk(rows, 0 * Q, convention))
    return all(same(walk(rows, q), B @ walk(rows, q, convention)) for q in (Q, -Q, Q[::-1]))


def slid_by(one, other):
    rows = np.array(ARTICLE, dtype=float)
    rows[1, 1], rows[2, 1] = one, other
    return walk(rows, Q)


def tool_seen_from(seen, q):
    """A constant step along the tool's z: what it is in the base's arrows, or in the tool's."""
    T = article(q)
    step = T[:3, 2] * 0.15
    return step if seen == "base" else T[:3, :3].T @ step


def constant(seen):
    return np.allclose(tool_seen_from(seen, Q), tool_seen_from(seen, -Q))


def seen_from_tool(q):
    """By how much 0.05 m more of a in row 2 moves the end, in the tool's arrows."""
    return article(q)[:3, :3].T @ (article(q, changed(1, 2, 0.05)) - article(q))[:3, 3]


def moved(joint):
    """Q with one joint moved, from 0."""
    return Q + 30 * np.eye(6)[joint]


def only_where_the_point_is():
    """A base that is shifted and turned: the difference of one point, with two turns of the hand
    about it, is the same.
    """
    B, one = walk([[20, 0.1, 0.2, 30]], [0]), article(Q)
    other = one.copy()
    other[:3, :3] = one[:3, :3] @ turn("x", 50)
    return same((B @ one - one)[:3, 3], (B @ other - other)[:3, 3])


def hidden(row):
    """A sign of the z arrow that cannot show at this row: what stands there is 0."""
    return abs(facts.link(row, facts.STANDARD)[1, 2]) < 1e-9


def moves_point(row, column):
    """Whether a number of the table moves the end's point."""
    return differ(article(Q, changed(row, column, 0.2))[:3, 3], article(Q)[:3, 3])


A, B = one_row(30, 0.1, 0.2, 0), one_row(-50, 0.3, 0.1, 0)
GENERAL, UNIT = (0.4, 0.3, 0.5, 0.9), (0, 0, 1.0, 0)

OPTIONS = {
    ("02.2", "link-offset"): lambda: same(
        one_row(30, 0.2, 0.3, 40)[:3, :3], one_row(30, 0.5, 0.3, 40)[:3, :3]
    ),
    ("02.5", "two-conditions"): lambda: abs(one_row(30, 0.2, 0.3, 40)[2, 0]) < 1e-12,
    ("02.5", "pointing-away"): lambda: turned_round("x1", True),
    ("03.4", "link-before"): lambda: (
        not same(article(Q), article(Q, convention="craig"))
        and np.isclose(one_row(0, 0, 0, 90)[2, 2], 0)
    ),
    ("03.4", "base"): lambda: not base_repairs(ARTICLE, "craig"),
    ("03.4", "mistyped"): lambda: facts.order_counts(),
    ("04.3", "meets-z0"): lambda: abs(one_row(30, 0.2, 0.3, 40)[2, 0]) < 1e-12,
    ("04.3", "starts-on-z0"): lambda: differ(one_row(0, 0, 0.3, 90)[:3, 3], [0, 0, 0]),
    ("04.6", "row-3"): lambda: same(slid_by(0, 0.1), slid_by(0.1, 0)),
    ("04.6", "both-rows"): lambda: np.isclose(
        np.linalg.norm((slid_by(0.1, 0.1) - slid_by(0, 0.1))[:3, 3]), 0.1
    ),
    ("04.6", "either-row"): lambda: same(slid_by(0.04, 0.06), slid_by(0.1, 0)),
    ("04.8", "alpha-3"): lambda: turned_round("z2", True),
    ("04.8", "lengths"): facts.z_hangs_on_five,
    ("04.9", "last-frame"): lambda: constant("tool"),
    ("04.9", "base-frame"): lambda: only_where_the_point_is() and not constant("base"),
    ("04.9", "length"): lambda: (
        all(same(seen_from_tool(q) * 20, walk(ARTICLE[2:], q[2:])[0, :3]) for q in (Q, -Q))
        and all(differ(seen_from_tool(Q), seen_from_tool(moved(k))) for k in range(2, 5))
    ),
    ("05.2", "none"): lambda: same(
        facts.link(GENERAL, ("Rz", "Tz")), facts.link(GENERAL, ("Tz", "Rz"))
    ),
    ("05.2", "about-one-axis"): lambda: orders_that_give(GENERAL) == 5,
    ("05.2", "turns-with-shifts"): lambda: differ(
        facts.link(GENERAL, ("Rz", "Tx")), facts.link(GENERAL, ("Tx", "Rz"))
    ),
    ("05.2", "both-turns"): lambda: differ(
        facts.link(GENERAL, ("Rz", "Rx")), facts.link(GENERAL, ("Rx", "Rz"))
    ),
    ("05.8", "unit-step"): lambda: orders_that_give(UNIT) == 24,
    ("05.8", "right-angles"): lambda: hidden((np.pi / 2, 0.3, 0.4, np.pi / 2)),
    ("05.8", "positions"): lambda: same(
        facts.link((0.4, 0.3, 0.5, 0.9), facts.STANDARD)[:3, 3],
        facts.link((0.4, 0.3, 0.5, 0.1), facts.STANDARD)[:3, 3],
    ),
    ("05.8", "general"): lambda: not hidden(GENERAL),
    ("06.4", "table"): lambda: all(
        quarter_turn_shows(changed(i, k, 0.3)) for i in range(6) for k in range(4)
    ),
    ("06.4", "program"): lambda: quarter_turn_shows(
        np.random.default_rng(1).uniform(-1, 1, (6, 4))
    ),
    ("06.4", "nothing"): lambda: differ(
        backwards([90, *Q[1:]])[:2, 3], (turn("z", 90) @ backwards([0, *Q[1:]])[:3, 3])[:2]
    ),
    ("06.5", "third-pitch"): lambda: same(z_axis(2), z_axis(3)) and same(z_axis(3), z_axis(4)),
    ("06.5", "wrist-roll"): lambda: (
        np.isclose(z_axis(4) @ x_of_forearm(), 0) and same(np.abs(z_axis(4) @ z_axis(3)), 1.0)
    ),
    ("06.5", "tool-roll"): lambda: same(z_axis(6), article(Q)[:3, 2]),
    ("06.8", "right-pose"): lambda: same(article([500, *Q[1:]]), article([140, *Q[1:]])),
    ("07.5", "table"): lambda: on_a_circle(np.random.default_rng(2).uniform(-2, 2, (6, 4))),
    ("07.5", "row-5"): lambda: on_a_circle(changed(4, 3, 40)) and on_a_circle(changed(4, 2, 0.3)),
    ("08.3", "stretched"): lambda: (
        np.linalg.norm(article(BENT)[:3, 3]) < np.linalg.norm(article([0] * 6)[:3, 3])
    ),
    ("08.3", "one-line"): lambda: rank([0, 60, -60, 20, 0, 0]) == 5,
    ("08.3", "no-inverse"): lambda: same(
        one_row(0, 0, 0, -90) @ back(one_row(0, 0, 0, -90)), np.eye(4)
    ),
    ("09.9", "last-angles"): lambda: not moves_point(5, 3),
    ("09.9", "lengths"): lambda: moves_point(1, 2) and moves_point(2, 2),
    ("09.9", "sense"): lambda: differ(article(Q * [-1, 1, 1, 1, 1, 1])[:3, 3], article(Q)[:3, 3]),
}


def z_axis(joint, q=Q):
    """The axis of a joint of the article's arm, in the base."""
    return walk(ARTICLE[: joint - 1], q[: joint - 1])[:3, 2]


def x_of_forearm(q=Q):
    return walk(ARTICLE[:3], q[:3])[:3, 0]


def backwards(q):
    """The product with its factors in the reverse order."""
    return walk(ARTICLE[::-1], q[::-1])


OUTCOMES = {
    "00.P1": lambda: round(float(np.cos(90)), 2) == -0.45,
    "01.P1": lambda: same(turn("x", 90) @ [0, 0, 1], [0, -1, 0]),
    "01.P2": lambda: same((A @ B)[:3, :3], (B @ A)[:3, :3]) and differ(A @ B, B @ A),
    "02.P1": lambda: same(one_row(0, 0, 0.3, 10)[:3, 3], one_row(0, 0, 0.3, 80)[:3, 3]),
    "02.P2": lambda: np.isclose(np.linalg.norm(one_row(25, 0.3, 0.4, 60)[:3, 3]), 0.5),
    "02.P3": lambda: (
        same(one_row(90, 0, 0.1, 0)[:3, 3], [0, 0.1, 0])
        and differ(one_row(90, 0, 0.1, 0)[:3, :3], np.eye(3))
    ),
    "03.P1": lambda: (
        differ(walk(ARTICLE[:2], [0, 0])[:3, 3], walk(ARTICLE[:2], [0, 30])[:3, 3])
        and same(
            walk(ARTICLE[:2], [0, 0], "craig")[:3, 3], walk(ARTICLE[:2], [0, 30], "craig")[:3, 3]
        )
    ),
    "03.P2": lambda: (
        same(article(0 * Q, convention="craig")[:3, 3], [0.75, -0.2, -0.1])
        and same(article(0 * Q)[:3, :3], article(0 * Q, convention="craig")[:3, :3])
        and differ(article(Q), article(Q, convention="craig"))
    ),
    "04.P4": lambda: turned_round("x2", True),
    "05.P1": lambda: same((turn("z", 90) @ [0.4, 0, 0])[:2], [0, 0.4]),
    "05.P2": lambda: orders_that_give(UNIT) == 24,
    "06.P1": lambda: same(article([90, 0, 0, 0, 0, 0])[:3, 3], [0.2, 0.75, 0.1]),
    "06.P2": lambda: same(article(0 * Q, convention="craig")[:3, 3], [0.75, -0.2, -0.1]),
    "07.P1": lambda: all(
        np.isclose(np.linalg.norm((article(q, changed(1, 2, 0.05)) - article(q))[:3, 3]), 0.05)
        for q in (Q, -Q)
    ),
    "07.P2": lambda: on_a_circle(np.random.default_rng(3).uniform(-2, 2, (6, 4))),
    "08.P1": lambda: rank([0] * 6) == 4,
}
