"""What is said of slips that learners made in programs, and what must not be said of them: each
sentence fits the answer that it is said of.
"""

from functools import partial

import numpy as np
import pytest
from claims import programs
from claims.advice import unfounded
from right_ways_08 import frames_of
from scipy.spatial.transform import Rotation

from dhlab.course.exercises import exercises
from dhlab.course.kinds import Function
from dhlab.doctor.programs.source.foretold import foretold_pairs
from dhlab.doctor.programs.wrong.branches import branches
from dhlab.doctor.programs.wrong.jacobians import geometric_jacobian, pose_error
from dhlab.robots import load
from dhlab.transform import inverse, rot_x, rot_z, trans_x, trans_z

E = exercises()
PROGRAMS = [key for key, e in E.items() if isinstance(e, Function)]


@pytest.mark.parametrize("key", PROGRAMS)
def test_two_changes_are_foretold_of_answers_of_any_shape(key):
    """A Jacobian has no determinant, a vector no blocks: of two terms of a sum, each mended by one
    change, the pair is foretold all the same.
    """
    rng = np.random.default_rng(1)
    right, one, other, idle = rng.normal(size=(4, 3, *E[key].shape))
    answers = np.array([right + one, right + other, right + one + other + idle])
    assert [0, 1] in foretold_pairs(right + one + other, answers, right).tolist()


def slide_of_the_joint_before(frames, T_end, sliding):
    cols = []
    for i in range(len(sliding)):
        z, o = frames[i][:3, 2], frames[i][:3, 3]
        if i > 0 and sliding[i - 1]:
            cols.append(np.hstack([z, 0 * z]))
        else:
            cols.append(np.hstack([np.cross(z, T_end[:3, 3] - o), z]))
    return np.array(cols).T


def test_a_jacobian_that_is_not_square_is_judged():
    for variant in range(3):
        assert E["08.2"].judge(slide_of_the_joint_before, variant).status == "wrong"


def jacobian(column, done=lambda cols: np.array(cols).T):
    """A program of 08.2 made of ``column(i, frames, p, slides)``."""

    def f(frames, T_end, sliding):
        p = T_end[:3, 3]
        return done([column(i, frames, p, sliding) for i in range(len(sliding))])

    return f


def swung(z, lever, slides):
    return np.hstack([z, 0 * z] if slides else [np.cross(z, lever), z])


def at(i, frames):
    return frames[i][:3, 2], frames[i][:3, 3]


def right_column(i, frames, p, sliding):
    z, o = at(i, frames)
    return swung(z, p - o, sliding[i])


def column_before(i, frames, p, sliding):
    z, o = at(i - 1, frames)
    return swung(z, p - o, sliding[i])


def column_by_star(i, frames, p, sliding):
    z, o = at(i, frames)
    return np.hstack([z, 0 * z] if sliding[i] else [z * (p - o), z])


def column_turned_back(i, frames, p, sliding):
    return right_column(i, frames, p, sliding) * [1, 1, 1, -1, -1, -1]


def column_slid_along_x(i, frames, p, sliding):
    slid = np.hstack([frames[i][:3, 0], np.zeros(3)])
    return slid if sliding[i] else right_column(i, frames, p, sliding)


def column_without_o(i, frames, p, sliding):
    return swung(frames[i][:3, 2], p, sliding[i])


def column_with_z_for_o(i, frames, p, sliding):
    z, _ = at(i, frames)
    return swung(z, p - z, sliding[i])


def column_by_dot(i, frames, p, sliding):
    z, o = at(i, frames)
    return np.hstack([z, 0 * z] if sliding[i] else [np.dot(z, p - o), z])


def column_about_its_own_z(i, frames, p, sliding):
    return swung(np.array([0.0, 0.0, 1.0]), p - frames[i][:3, 3], sliding[i])


def column_of_the_tool(sign):
    """The lever is the tool's own step, from the last frame to the end, or the reverse."""
    return lambda i, frames, p, sliding: swung(
        frames[i][:3, 2], sign * (p - frames[-1][:3, 3]), sliding[i]
    )


def jacobian_of_a_whole_pose(frames, T_end, sliding):
    columns, p = [], frames[-1][:3, 3]
    for frame, slides in zip(frames, sliding):
        z = frame[:3, 2]
        columns.append(swung(z, z if slides else T_end - p, slides))
    return np.array(columns).T


def as_rows(cols):
    return np.array(cols).reshape(6, len(cols))


JACOBIANS = [  # (exercise, program, what must be said, what must not)
    ("08.2", slide_of_the_joint_before, "sliding is asked of the joint before", "differ"),
    ("08.2", jacobian(column_before), "joint 1 has the last frame's", "differ"),
    ("08.2", jacobian(column_by_star), "np.cross(z, p − o) belongs", "@"),
    ("08.2", jacobian(column_turned_back), "ω has the other sign", "error"),
    ("08.2", jacobian(column_slid_along_x), "v is wrong in the columns of the sliding", "1, 2"),
    ("08.2", jacobian(right_column, as_rows), ".T does", "differ"),
    ("08.2", jacobian(right_column, lambda c: np.rad2deg(c).T), "in degrees", "differ"),
    ("08.2", jacobian(right_column, lambda c: np.array(c[:1]).T), "return inside", "Print"),
    ("08.2", jacobian(column_with_z_for_o), "or z or a row in its place", "end alone, o was"),
    ("08.2", jacobian(column_by_dot), "np.cross gives three", "count"),
    ("08.2", jacobian(column_about_its_own_z), "z is 0 0 1 for every joint", "another frame"),
    ("08.2", jacobian(column_of_the_tool(1)), "the last frame to the end, for every", "differ"),
    ("08.11", jacobian(column_of_the_tool(-1)), "the end to the last frame, for every", "pen"),
    ("08.11", jacobian_of_a_whole_pose, "which three numbers of the pose", "lacks"),
    ("08.11", jacobian(column_without_o), "o was not taken off", "pen"),
]


@pytest.mark.parametrize("key, f, said, unsaid", JACOBIANS)
def test_what_is_said_of_a_jacobian(key, f, said, unsaid):
    verdict = str(E[key].judge(f, 1))
    assert said in verdict and unsaid not in verdict, verdict


@pytest.mark.parametrize("kinds", [(0, 1), (1, 1), (0, 0)])
def test_the_columns_that_are_named_are_the_wrong_ones(kinds):
    """Of sliding or turning joints, asked of the program's own numbers."""
    spoil = [1 + 0.1 * kinds[0], 1 + 0.1 * kinds[1]]

    def f(frames, T_end, sliding):
        return E["08.2"].answer(frames, T_end, sliding) * np.where(sliding, *spoil[::-1])

    place = E["08.2"].judge(f, 1).place
    if any(kinds):
        assert ("every column" in place) == all(kinds)
        assert ("of the sliding joints, and in no others" in place) == (kinds == (0, 1))


# ---- 08.4, 08.6, 08.8


def turn_of(R):
    return Rotation.from_matrix(R).as_rotvec()


def position_by_the_tool(T, T_goal):
    R, R_goal = T[:3, :3], T_goal[:3, :3]
    return np.hstack([R.T @ (T_goal[:3, 3] - T[:3, 3]), turn_of(R_goal @ R.T)])


def loop(step, onward=lambda q, dq: q + dq):
    def solve(rows, T_goal, q, damping, steps):
        for _ in range(steps):
            frames = np.array(frames_of(rows, q))
            J = geometric_jacobian(frames, frames[-1], [False] * 6)
            q = onward(q, step(J, pose_error(frames[-1], T_goal), damping))
        return q

    return solve


def damped(J, e, damping):
    return J.T @ np.linalg.solve(J @ J.T + damping**2 * np.eye(6), e)


def by_chance(T):
    return np.random.default_rng().uniform(-2, 2, (8, 6))


ARTICLE_J = load("article-6r").jacobian
ARTICLE_T = load("article-6r").forward
NEAR_SINGULAR = np.deg2rad([0, 40, -60, 50, 1, 0])


def with_arm(jacobian_too, pose_too):
    """The loop with ``arm``, which the first cell made, in place of what rows describes."""

    def solve(rows, T_goal, q, damping, steps):
        for _ in range(steps):
            frames = np.array(frames_of(rows, q))
            J = geometric_jacobian(frames, frames[-1], [False] * 6)
            J, T = ARTICLE_J(q) if jacobian_too else J, ARTICLE_T(q) if pose_too else frames[-1]
            q = q + damped(J, pose_error(T, T_goal), damping)
        return q

    return solve


def inverse_forgotten(J, e, k):
    return (J.T @ J + k**2 * np.eye(6)) @ J.T @ e


SOLVERS = [
    ("08.4", position_by_the_tool, "the turn is right; the position is", "Rᵀ R"),
    (
        "08.6",
        loop(lambda J, e, k: np.linalg.solve(J @ J.T + k**2 * np.eye(6), e)),
        "Jᵀ is",
        "differ",
    ),
    ("08.6", loop(lambda J, e, k: damped(J, e, 0.05)), "0.05 in every call", "differ"),
    ("08.6", loop(damped, lambda q, dq: dq), "q = dq forgets", "differ"),
    ("08.6", loop(inverse_forgotten), "the inverse is missing", "differ"),
    ("08.6", with_arm(True, False), "the Jacobian is that of the article's arm", "pose"),
    ("08.6", with_arm(False, True), "the pose is that of the article's arm", "Jacobian is"),
    ("08.6", with_arm(True, True), "Jacobian and pose are those of the article's arm", "differ"),
    (
        "08.6",
        loop(lambda J, e, k: damped(ARTICLE_J(NEAR_SINGULAR), e, k)),
        "the damping's cell left in memory",
        "rows",
    ),
    ("08.8", by_chance, "draws random numbers", "np.eye(4)"),
    ("08.8", lambda T: np.rad2deg(branches(T)) + 360, "in degrees; radians", "forward"),
]


@pytest.mark.parametrize("variant", range(2, 5))
@pytest.mark.parametrize(
    "nearly",
    [
        loop(lambda J, e, k: (J.T @ J + np.eye(6)) @ J.T @ e),
        loop(lambda J, e, k: J.T @ (J @ J.T) @ e),
        loop(lambda J, e, k: damped(1.001 * J, e, k)),
        loop(lambda J, e, k: damped(ARTICLE_J(0 * NEAR_SINGULAR), e, k)),
        loop(lambda J, e, k: damped(load("ur5e").jacobian(NEAR_SINGULAR), e, k)),
    ],
)
def test_what_is_said_of_one_solver_is_not_said_of_another(nearly, variant):
    verdict = E["08.6"].judge(nearly, variant)
    assert verdict.status == "wrong"
    for said in ("inverse is missing", "the article's arm", "left in memory"):
        assert said not in str(verdict)


@pytest.mark.parametrize("key, f, said, unsaid", SOLVERS)
def test_what_is_said_of_a_solver(key, f, said, unsaid):
    verdict = str(E[key].judge(f, 1))
    assert said in verdict and unsaid not in verdict, verdict


# ---- 05, 06, 07, 09


def with_d_for_a(theta, d, a, alpha):
    return rot_z(theta) @ trans_z(d) @ trans_x(d) @ rot_x(alpha)


def with_theta_for_alpha(theta, d, a, alpha):
    return rot_z(theta) @ trans_z(d) @ trans_x(a) @ rot_x(theta)


def not_written_yet(alpha):
    return None


def with_nothing(theta, d, a, alpha):
    return rot_z(theta) @ trans_z(d) @ trans_x(a) @ not_written_yet(alpha)


def seen_from_the_end(theta, d, a, alpha):
    return inverse(rot_z(theta) @ trans_z(d) @ trans_x(a) @ rot_x(alpha))


def the_other_conventions(theta, d, a, alpha):
    return rot_x(alpha) @ trans_x(a) @ rot_z(theta) @ trans_z(d)


def both_converted(rows, q):
    T = np.eye(4)
    for (offset, d, a, alpha), x in zip(rows, q):
        theta, alpha = offset + np.deg2rad(x), np.deg2rad(alpha)
        T = T @ rot_z(theta) @ trans_z(d) @ trans_x(a) @ rot_x(alpha)
    return T


def all_four(theta, d, a, alpha):
    return [rot_z(theta), trans_z(d), trans_x(a), rot_x(alpha)]


def with_dots(theta, d, a, alpha):
    return rot_z(theta) @ trans_z(d) @ ...


def of_whole_numbers(alpha):
    return np.array([[1, 0, 0, 0], [0, 0, -1, 0], [0, 1, 0, 0], [0, 0, 0, 1]])


def called(theta, d, a, alpha):
    return rot_z(theta) @ trans_z(d) @ trans_x(a) @ rot_x(alpha)


def last_alone(rows, q):
    for (offset, d, a, alpha), x in zip(rows, q):
        T = called(offset + x, d, a, alpha)
    return T


MOVES = [
    ("05.1", of_whole_numbers, "the same whatever goes in", "cut off"),
    ("05.4", all_four, "what they make together", "alone"),
    ("05.4", with_dots, "dots are left in the program", "4×4"),
    ("05.6", called, "made by calling functions", "Right"),
    ("05.7", called, "made by calling functions", "One sign"),
    ("09.8", last_alone, "only the last row's matrix comes out", "begins"),
    ("05.4", with_d_for_a, "d is used where a belongs", "entries"),
    ("05.4", with_theta_for_alpha, "theta is used where alpha belongs", "differ"),
    ("05.4", with_nothing, "is None, a single number or three dots", "4×4"),
    ("05.4", seen_from_the_end, "T_ab is frame b written in frame a", "T_06"),
    ("05.6", the_other_conventions, "the matrix of Craig's convention", "joins on the right"),
    ("05.7", the_other_conventions, "the matrix of Craig's convention", "joins on the right"),
    ("07.2", both_converted, "onverted to radians twice", "offset"),
]


@pytest.mark.parametrize("key, f, said, unsaid", MOVES)
def test_what_is_said_of_moves_and_products(key, f, said, unsaid):
    verdict = str(E[key].judge(f, 1))
    assert said in verdict and unsaid not in verdict, verdict


@pytest.mark.parametrize("f", [with_d_for_a, with_theta_for_alpha])
def test_the_number_that_is_named_is_used_for_the_other(f):
    assert programs.judged(E["05.4"].judge(f, 1), f, "dh_transform")


def half_of_the_branches(frames, T_end, sliding):
    columns = []
    for frame, slides in zip(frames, sliding):
        z, o = frame[:3, 2], frame[:3, 3]
        if slides:
            columns.append(...)
        else:
            columns.append(np.hstack([np.cross(z, T_end[:3, 3] - o), z]))
    return np.array(columns).T


def dots_in_a_column(frames, T_end, sliding):
    columns = []
    for frame, slides in zip(frames, sliding):
        z, o = frame[..., :3, 2], frame[..., :3, 3]
        columns.append([*z, ..., ..., ...] if slides else [*np.cross(z, T_end[:3, 3] - o), *z])
    return np.array(columns).T


def nothing_where_it_slides(frames, T_end, sliding):
    columns = []
    for frame, slides in zip(frames, sliding):
        z, o = frame[:3, 2], frame[:3, 3]
        if slides:
            ...
        else:
            columns.append(np.hstack([np.cross(z, T_end[:3, 3] - o), z]))
    return np.array(columns).T


@pytest.mark.parametrize("key", ["08.2", "08.11"])
@pytest.mark.parametrize(
    "f, line", [(half_of_the_branches, 5), (dots_in_a_column, 4), (nothing_where_it_slides, 5)]
)
def test_dots_in_one_branch_are_no_attempt(key, f, line):
    verdict = E[key].judge(f, 1)
    assert verdict.status == "not attempted" and verdict.points == 0
    assert verdict.place == f"line {f.__code__.co_firstlineno + line}"


def test_dots_that_choose_entries_are_no_gap():
    def of_all(frames, T_end, sliding):
        z, o = frames[:-1, :3, 2], frames[:-1, ..., :3, 3]
        v = np.where(np.array(sliding)[..., None], z, np.cross(z, T_end[..., :3, 3] - o))
        return np.vstack([v.T, np.where(sliding, 0, z.T)])

    def reversed_lever(frames, T_end, sliding):
        return of_all(frames, T_end, sliding)[..., ::-1]

    assert E["08.2"].judge(of_all, 1).status == "right"
    assert E["08.2"].judge(reversed_lever, 1).status == "wrong"


@pytest.mark.parametrize("key, f", [(key, f) for key, f, *_ in JACOBIANS + SOLVERS + MOVES])
def test_reasons_and_next_steps_hold(key, f):
    assert not [*unfounded(E[key], E[key].judge(f, 1), f, 1)]


class Compiled:
    """A function as numba's ``njit`` gives it back: called, with the code of the one it wraps."""

    def __init__(self, f):
        self.__wrapped__, self.__code__ = f, f.__code__

    def __call__(self, *args):
        return self.__wrapped__(*args)


def test_compiled_programs_are_judged_as_what_they_compute():
    right = Compiled(lambda alpha: rot_x(alpha))
    wrong = Compiled(lambda alpha: rot_x(-alpha))
    for f, status in ((right, "right"), (wrong, "wrong")):
        for program in (f, lambda alpha, f=f: f(alpha), partial(f)):
            assert E["05.1"].judge(program, 0).status == status
