"""Lesson 08: its right answers against independent judges, what its wrong answers are told, and the
other libraries.
"""

from functools import partial
from itertools import permutations

import numpy as np
import pytest
from draws import variants
from oracles import elementary_pose, pose_errors
from right_ways_08 import RIGHT_WAYS, frames_of
from scipy.linalg import expm
from scipy.spatial.transform import Rotation

import dhlab as dh
from dhlab.course import othersolvers
from dhlab.course.exercises import exercises
from dhlab.course.othersolvers import LIBRARIES, STORED, STORED_FROM, STORED_TO, other_solvers
from dhlab.doctor import catalogue
from dhlab.doctor.programs.explain import WRONG_VERSIONS
from dhlab.doctor.programs.wrong.branches import branches, in_order
from dhlab.doctor.programs.wrong.jacobians import geometric_jacobian, pose_error
from dhlab.doctor.programs.wrong.solvers import damped_step, inverse_kinematics, wrapped

LESSON = {key: e for key, e in exercises().items() if key.startswith("08.")}
ARM = dh.load("article-6r")
FUNCTIONS = ["08.2", "08.4", "08.6", "08.8"]


def by_differences(pose, q, h=1e-6):
    """v above ω, from nothing but poses."""
    columns = []
    for k in range(len(q)):
        step = h * np.eye(len(q))[k]
        rate = (pose(q + step) - pose(q - step)) / (2 * h)
        spin = rate[:3, :3] @ pose(q)[:3, :3].T
        columns.append([*rate[:3, 3], spin[2, 1], spin[0, 2], spin[1, 0]])
    return np.array(columns).T


# ---- what the exercises hold to be right


@pytest.mark.parametrize("seed", range(5))
def test_the_jacobian_is_the_derivative_of_the_pose(seed):
    rng = np.random.default_rng(seed)
    n = int(rng.integers(3, 8))
    table = dh.DHTable.standard(
        rng.uniform(-1, 1, (n, 4)), angle="rad", joints=rng.choice(["R", "P"], n).tolist()
    )
    base, tool = (dh.transform.from_xyz_rpy(*rng.uniform(-1, 1, (2, 3))) for _ in range(2))
    arm, q = dh.Arm(table, base=base, tool=tool), rng.uniform(-1, 1, n)
    J = geometric_jacobian(arm.frames(q), arm.forward(q), table.prismatic)
    assert np.allclose(
        J, by_differences(lambda x: base @ elementary_pose(table, x) @ tool, q), atol=1e-8
    )


def test_the_pose_error_carries_the_pose_to_the_goal():
    for T, T_goal in LESSON["08.4"].cases(0):
        e = pose_error(T, T_goal)
        W = np.array([[0, -e[5], e[4]], [e[5], 0, -e[3]], [-e[4], e[3], 0]])
        assert np.allclose(expm(W) @ T[:3, :3], T_goal[:3, :3]) and np.allclose(
            T[:3, 3] + e[:3], T_goal[:3, 3]
        )


def test_the_damped_step_keeps_its_bargain():
    rng = np.random.default_rng(1)
    for _ in range(5):
        J, e, damping = rng.normal(size=(6, 7)), rng.normal(size=6), rng.uniform(0.05, 0.5)
        best = np.linalg.lstsq(
            np.vstack([J, damping * np.eye(7)]), np.hstack([e, np.zeros(7)]), rcond=None
        )[0]
        assert np.allclose(damped_step(J, e, damping), best)


@pytest.mark.parametrize("name", ["article-6r", "ur5e", "irb120"])
def test_the_solver_arrives(name):
    arm, rng = dh.load(name), np.random.default_rng(2)
    for _ in range(4):
        q = rng.uniform(0.3, 1.0, 6) * rng.choice([-1, 1], 6)
        T_goal = elementary_pose(arm.table, q)
        found = inverse_kinematics(arm.table.rows, T_goal, q + rng.uniform(-0.3, 0.3, 6), 0.03, 60)
        assert max(pose_errors(elementary_pose(arm.table, found), T_goal)) < 1e-6


@pytest.mark.parametrize("variant", variants(3))
def test_all_tasks_solved_at_once_are_each_solved_alone(variant):
    exercise = exercises()["08.6"]
    cases = exercise.cases(variant)
    alone = [inverse_kinematics(*case) for case in cases]
    assert len({steps for *_, steps in cases}) > 1  # some are done before others
    assert np.allclose(exercise.right_answers(cases), alone, rtol=0, atol=1e-9)


@pytest.mark.parametrize("variant", variants(3))
def test_all_poses_solved_at_once_are_each_solved_alone(variant):
    exercise = exercises()["08.8"]
    cases = exercise.cases(variant)
    alone = [branches(T) for (T,) in cases]
    assert np.allclose(exercise.right_answers(cases), alone, rtol=0, atol=1e-9)


def octant(x):
    return tuple(np.asarray(x) > 0)


PARTS = {  # of the cases: in how many of them, and in which one a case is
    "08.2": (15, lambda frames, T_end, sliding: tuple(sliding)),
    "08.11": (15, lambda frames, T_end, sliding: tuple(sliding)),
    "08.4": (8, lambda T, T_goal: octant(Rotation.from_matrix((T_goal @ T.T)[:3, :3]).as_rotvec())),
    "08.6": (2, lambda rows, T_goal, q, damping, steps: steps),
    "08.8": (8, lambda T: octant(T[:3, 3] - [0, 0, 0.1])),
}


@pytest.mark.parametrize("variant", variants(3))
@pytest.mark.parametrize("key", PARTS)
def test_a_program_that_is_wrong_in_a_part_of_the_cases_is_refused(key, variant):
    exercise, (many, part) = exercises()[key], PARTS[key]
    general = exercise.cases(variant)[: exercise.calls]
    parts = {part(*case) for case in general}
    assert len(parts) == many
    for wrong in parts:

        def program(*case, wrong=wrong):
            answer = exercise.answer(*case)
            return answer + 0.01 if part(*case) == wrong else answer

        assert exercise.judge(program, variant).status == "wrong"


def test_all_eight_branches_reach_the_pose_and_there_are_no_others():
    rng = np.random.default_rng(3)
    (T,) = LESSON["08.8"].cases(0)[0]
    eight = branches(T)
    assert all(max(pose_errors(elementary_pose(ARM.table, q), T)) < 1e-9 for q in eight)
    apart = np.abs(wrapped(eight[:, None] - eight[None])).max(axis=-1) + 9 * np.eye(8)
    assert apart.min() > 0.05
    found = [
        inverse_kinematics(ARM.table.rows, T, rng.uniform(-3, 3, 6), 0.1, 150) for _ in range(30)
    ]
    arrived = [q for q in found if max(pose_errors(elementary_pose(ARM.table, q), T)) < 1e-6]
    nearest = [int(np.abs(wrapped(eight - q)).max(axis=1).argmin()) for q in arrived]
    assert len(arrived) >= 15 and len(set(nearest)) >= 6
    assert all(np.abs(wrapped(eight[k] - q)).max() < 1e-4 for k, q in zip(nearest, arrived))


def test_the_numbers_in_the_text_are_true():
    assert [
        np.linalg.matrix_rank(
            by_differences(lambda x: elementary_pose(ARM.table, x), np.deg2rad(q)), tol=1e-6
        )
        for q in ([0] * 6, [0, 40, -60, 50, 0, 0], [0, 40, -60, 50, 40, 0])
    ] == [4, 5, 6]
    cup, low = (
        np.deg2rad([30, 60, -80, -30, 40, 0]),
        np.deg2rad([30, -13.5964, 80, -116.4036, 40, 0]),
    )
    T = elementary_pose(ARM.table, cup)
    assert np.allclose(
        elementary_pose(ARM.table, low), T, atol=1e-6
    )  # 08.7: to a thousandth of a millimetre
    assert np.allclose(
        inverse_kinematics(ARM.table.rows, T, np.deg2rad([0, 0, 60, 20, 30, 0]), 0.05, 50),
        low,
        atol=1e-6,
    )
    cut = elementary_pose(ARM.table, low * [1, 0, 1, 1, 1, 1])
    assert np.linalg.norm(cut[:3, 3] - T[:3, 3]) == pytest.approx(0.13, abs=0.005)
    wrist = np.array(frames_of(ARM.table.rows, np.deg2rad([0, 40, -60, 50, 0, 0])))[3][:3, 3] - [
        0,
        0,
        0.1,
    ]
    assert 0.75 - np.linalg.norm(wrist) == pytest.approx(0.10, abs=0.005)
    assert 10 / np.sin(np.deg2rad(1)) == pytest.approx(572, abs=1.5)


# ---- right answers pass, wrong ones are named


def test_values_by_another_way_pass():
    for variant in variants(6):
        q = np.deg2rad(LESSON["08.1"].given(variant)["q"])
        column = by_differences(lambda x: elementary_pose(ARM.table, x), q)[:, 2]
        assert all(
            LESSON["08.1"].judge(answer, variant).status == "right"
            for answer in (column, column.tolist(), tuple(column.round(5)))
        )
        given, arm = LESSON["08.9"].given(variant), dh.load("stanford")
        q = np.where(arm.table.prismatic, given["q"], np.deg2rad(given["q"]))
        J = by_differences(partial(elementary_pose, arm.table), q)
        speeds = np.linalg.lstsq(J, [*given["v"], *given["omega"]], rcond=None)[0]
        assert all(
            LESSON["08.9"].judge(answer, variant).status == "right"
            for answer in (speeds, speeds.tolist(), tuple(speeds.round(5)))
        )


@pytest.mark.parametrize("key", ["08.1", "08.9"])
def test_ten_wrong_values_and_more_are_named(key):
    exercise = LESSON[key]
    for variant in variants(6):
        given = exercise.given(variant)
        right = exercise.answer(**given)
        wrong = [
            value
            for _, _, value in exercise.mistakes(**given)
            if not np.allclose(value, right, rtol=2e-3, atol=2e-3)
        ]
        verdicts = [exercise.judge(value, variant) for value in wrong]
        assert len(wrong) >= 15 and all(v.status == "wrong" and v.mistake for v in verdicts)
        assert len({v.mistake for v in verdicts}) >= 10


@pytest.mark.parametrize("key", FUNCTIONS)
def test_each_function_knows_ten_mistakes_and_three_right_ways(key):
    versions = WRONG_VERSIONS[LESSON[key].family]
    assert len({mistake for mistake, _, _ in versions}) >= 10 and len(RIGHT_WAYS[key]) >= 3
    assert {mistake for mistake, _, _ in versions} <= catalogue().keys()


def _noise(key):
    """Answers of the right shape that no known mistake gives."""
    shape = LESSON[key].shape
    return lambda *case: (
        np.sin(np.arange(1, 1 + np.prod(shape))).reshape(shape) * np.sum(np.asarray(case[0])) / 7
    )


@pytest.mark.parametrize("key", FUNCTIONS)
def test_what_is_not_known_is_wrong_without_a_name(key):
    verdict = LESSON[key].judge(_noise(key))
    assert verdict.status == "wrong" and verdict.mistake is None and verdict.place


def _stanford(variant):
    """Frames, end, kinds of joints and the hand's velocity of 08.9."""
    given, arm = LESSON["08.9"].given(variant), dh.load("stanford")
    q = np.where(arm.table.prismatic, given["q"], np.deg2rad(given["q"]))
    return (
        arm.frames(q),
        arm.forward(q),
        arm.table.prismatic,
        np.array([*given["v"], *given["omega"]]),
    )


@pytest.mark.parametrize("variant", variants(8))
def test_another_end_point_is_seen_in_the_joint_speeds(variant):
    frames, _, sliding, twist = _stanford(variant)
    for end in (
        np.eye(4),
        frames[3],
        frames[5],
        ARM.forward(np.deg2rad([30, 60, -80, -30, 40, 0])),
    ):
        verdict = LESSON["08.9"].judge(
            np.linalg.solve(geometric_jacobian(frames, end, sliding), twist), variant
        )
        assert verdict.mistake == "lever-arm-wrong" and "another end point" in verdict.headline


@pytest.mark.parametrize("variant", variants(8))
def test_wrong_ways_to_joint_speeds_are_told_their_own_next_step(variant):
    frames, T_end, sliding, twist = _stanford(variant)
    J, turning = (
        geometric_jacobian(frames, T_end, sliding),
        geometric_jacobian(frames, T_end, [False] * 6),
    )
    said = {
        "transpose": J.T @ twist,
        "J times": J @ twist,
        "does not turn": np.linalg.pinv(J[:3]) @ twist[:3],
        "other sign": -np.linalg.solve(J, twist),
        "the slide is treated": 1e12 * np.linalg.svd(turning)[2][-1] + 1,
        "deg2rad too": _all_through_deg2rad(variant, twist),
    }
    for words, speeds in said.items():
        verdict = LESSON["08.9"].judge(speeds, variant)
        assert (
            verdict.mistake
            and words in verdict.headline
            and "goal" not in str(verdict)
            and "λ" not in str(verdict)
        ), verdict
    assert LESSON["08.9"].judge(1e12 * np.arange(1, 7), variant).mistake is None


def _all_through_deg2rad(variant, twist):
    arm, q = dh.load("stanford"), np.deg2rad(LESSON["08.9"].given(variant)["q"])
    return np.linalg.solve(arm.jacobian(q), twist)


@pytest.mark.parametrize("variant", variants(8))
def test_a_column_of_what_is_still_in_memory_is_told_so(variant):
    bent, q = np.deg2rad([0, 40, -60, 50, 40, 0]), np.deg2rad(LESSON["08.1"].given(variant)["q"])
    for words, at, to in (
        ("column at bent", bent, bent),
        ("p is the end", q, bent),
        ("frames are those", bent, q),
    ):
        frame, p = ARM.frames(at)[2], ARM.forward(to)[:3, 3]
        verdict = LESSON["08.1"].judge(
            np.hstack([np.cross(frame[:3, 2], p - frame[:3, 3]), frame[:3, 2]]), variant
        )
        assert verdict.mistake == "jacobian-not-renewed" and words in verdict.headline


UNDAMPED = {
    "solve J": lambda J, e: np.linalg.solve(J, e),
    "solve J Jᵀ": lambda J, e: J.T @ np.linalg.solve(J @ J.T, e),
    "inverse": lambda J, e: np.linalg.inv(J) @ e,
    "pseudo-inverse": lambda J, e: np.linalg.pinv(J) @ e,
    "least squares": lambda J, e: np.linalg.lstsq(J, e, rcond=None)[0],
}


def _loop(step, geometric_jacobian=geometric_jacobian):
    def solve(rows, T_goal, q, damping, steps):
        for _ in range(steps):
            frames = np.array(frames_of(rows, q))
            q = q + step(
                geometric_jacobian(frames, frames[-1], [False] * 6), pose_error(frames[-1], T_goal)
            )
        return q

    return solve


@pytest.mark.slow
@pytest.mark.parametrize("name", UNDAMPED)
@pytest.mark.parametrize("variant", range(3))
def test_undamped_steps_are_named_however_they_are_made(name, variant):
    assert LESSON["08.6"].judge(_loop(UNDAMPED[name]), variant).mistake == "damping-missing"
    half = LESSON["08.6"].judge(_loop(lambda J, e: UNDAMPED[name](J, e) / 2), variant)
    assert half.mistake is None and "steps = 1" in half.next and "entry" not in str(half)


def _ending_early(ends):
    """A loop that is left when ``ends(error before, step, error after)`` says so."""

    def solve(rows, T_goal, q, damping, steps):
        for _ in range(steps):
            frames = np.array(frames_of(rows, q))
            e = pose_error(frames[-1], T_goal)
            dq = damped_step(geometric_jacobian(frames, frames[-1], [False] * 6), e, damping)
            q = q + dq
            after = pose_error(np.array(frames_of(rows, q))[-1], T_goal)
            if ends(*map(np.linalg.norm, (e, dq, after))):
                break
        return q

    return solve


@pytest.mark.parametrize(
    "ends",
    [
        lambda before, step, after: after < 1e-3,
        lambda before, step, after: after < 1e-5,
        lambda before, step, after: before < 1e-4,
        lambda before, step, after: step < 1e-4,
        lambda before, step, after: after > before,
    ],
)
def test_a_loop_that_ends_before_its_steps_are_done_is_refused(ends):
    verdict = LESSON["08.6"].judge(_ending_early(ends))
    assert verdict.status == "wrong" and "right at general numbers" in verdict.headline
    assert "Exactly `steps` steps" in verdict.next
    assert LESSON["08.6"].judge(_ending_early(lambda *sizes: False)).status == "right"


READ_OFF = {
    "θ4 is off by 180°": (lambda y, x: (-y, -x), None),
    "θ6 is off by 180°": (None, lambda y, x: (-y, -x)),
    "θ4 runs the wrong way": (lambda y, x: (-y, x), None),
    "θ6 runs the wrong way": (None, lambda y, x: (y, -x)),
    "θ4 is off: the arguments": (lambda y, x: (x, y), None),
}


@pytest.mark.parametrize("words", READ_OFF)
@pytest.mark.parametrize("variant", range(2))
def test_wrong_signs_in_the_wrists_arctan2_are_named(words, variant):
    four, six = READ_OFF[words]

    def wrist(Q):
        return [(*q[:3], _again(q[3], four), q[4], _again(q[5], six)) for q in Q]

    def read(T):
        first = [q for q in branches(T) if np.sin(q[4]) > 0]
        return np.array(
            [
                w
                for q in wrist(first)
                for w in (q, np.array(q) * [1, 1, 1, 1, -1, 1] + [0, 0, 0, np.pi, 0, np.pi])
            ]
        )

    verdict = LESSON["08.8"].judge(read, variant)
    assert verdict.mistake and words in verdict.headline and "column 5" not in str(verdict)


def _again(angle, change):
    return np.arctan2(*change(np.sin(angle), np.cos(angle))) if change else angle


def test_a_jacobian_on_its_side_is_told_to_turn():
    verdict = LESSON["08.2"].judge(lambda *case: np.transpose(geometric_jacobian(*case)))
    assert verdict.status == "wrong" and "5×6" in verdict.headline and "transpose" in verdict.next


def test_a_solver_that_changes_its_start_is_told_so():
    def spoils(rows, T_goal, q, damping, steps):
        q += 0.1
        return q

    assert LESSON["08.6"].judge(spoils).mistake == "inputs-changed"


def test_the_handed_out_pose_error_is_no_attempt_and_its_fix_is_small():
    from scipy.spatial.transform import Rotation

    def handed_out(T, T_goal):
        turn = T[:3, :3].T @ T_goal[:3, :3]
        return np.hstack([T_goal[:3, 3] - T[:3, 3], Rotation.from_matrix(turn).as_rotvec()])

    assert LESSON["08.4"].judge(handed_out).status == "not attempted"


def test_a_program_that_gives_a_column_is_told_what_that_does():
    """The lesson's next cell adds its step to the row of the joints, and would go on with 36
    numbers. A value that is a column is only read, and right.
    """
    verdict = LESSON["08.4"].judge(lambda T, T_goal: pose_error(T, T_goal)[:, None])
    assert "6×1, expected 6" in verdict.headline and "A row and a column" in verdict.next
    q, (T, T_goal) = np.zeros(6), LESSON["08.4"].cases(0)[0]
    assert (q + ARM.jacobian(q).T @ pose_error(T, T_goal)[:, None]).shape == (6, 6)
    value = LESSON["08.13"]
    assert value.judge(np.reshape(value.expected(0), (6, 1))).status == "right"


def test_orders_of_the_loop():
    exercise, right, named, all_wrong = LESSON["08.5"], [], 0, 0
    for letters in permutations("abcdefgh", 5):
        verdict = exercise.judge(list(letters))
        if verdict.status == "right":
            right.append("".join(letters))
        else:
            all_wrong, named = all_wrong + 1, named + (verdict.mistake is not None)
    assert right == ["bdfhc", "bfdhc"] and named == all_wrong == 6718
    assert (
        exercise.judge("b, d, f, h, c").status == "right"
        and exercise.judge("bbdfh").status == "wrong"
    )


def test_orders_are_named_for_what_they_do():
    exercise = LESSON["08.5"]
    for answer, mistake in (
        ("bdfhe", "step-not-accumulated"),
        ("bdfac", "damping-missing"),
        ("bgfhc", "error-sign"),
        ("dbfhc", "jacobian-not-renewed"),
        ("bdfch", "step-not-accumulated"),
        ("bdhfc", "jacobian-not-renewed"),
    ):
        assert exercise.judge(answer).mistake == mistake, answer
    assert exercise.judge("dbfhc").headline == "the frames come first" and "loop" not in str(
        exercise.judge("dbfhc")
    )


def test_branches_in_any_order_are_read_alike():
    (T,) = LESSON["08.8"].cases(1)[0]
    eight, rng = branches(T), np.random.default_rng(4)
    for _ in range(5):
        assert np.allclose(
            in_order(rng.permutation(eight) + 2 * np.pi * rng.integers(-2, 3, eight.shape)), eight
        )


# ---- the other libraries


@pytest.fixture
def none_installed(tmp_path, monkeypatch):
    """A machine without the [oracles] extra."""
    for name in ("roboticstoolbox", "pybullet", "trac_ik"):
        (tmp_path / f"{name}.py").write_text(f"raise ImportError('no {name} here')\n")
    monkeypatch.syspath_prepend(tmp_path)


TASK = ARM, elementary_pose(ARM.table, np.deg2rad(STORED_TO)), np.deg2rad(STORED_FROM)


def _without_last_column(text):
    return [
        line.replace("computed here", "").replace("stored: not installed here", "").rstrip()
        for line in text.splitlines()
    ]


def test_stored_answers_reach_the_goal():
    for name in LIBRARIES:
        T = elementary_pose(ARM.table, np.deg2rad(STORED[name]))
        position, angle = pose_errors(T, TASK[1])
        assert position < 1e-4 and np.rad2deg(angle) < 0.1


def test_without_the_libraries_the_same_numbers_are_shown_and_the_column_says_so(none_installed):
    shown = other_solvers(*TASK)
    assert shown.count("stored: not installed here") == 3 and "computed" not in shown
    assert all(" 30 60 -80 -30 40 0 " in line for line in shown.splitlines()[1:])


@pytest.fixture(scope="module")
def shown():
    """What the libraries that are here answer; to load them takes seconds."""
    return other_solvers(*TASK)


@pytest.mark.slow
@pytest.mark.parametrize(
    "module, name",
    [("roboticstoolbox", "Robotics Toolbox"), ("pybullet", "PyBullet"), ("trac_ik", "TRAC-IK")],
)
def test_where_a_library_is_installed_its_answer_is_the_stored_one(judge, shown, module, name):
    """The example of ``other_solvers`` is this, and not run a second time."""
    judge(module)
    (line,) = (line for line in shown.splitlines() if line.startswith(f" {name}"))
    assert (
        "computed here" in line and " 30 60 -80 -30 40 0 " in line and line.count("under 0.1") == 2
    )


@pytest.mark.slow
def test_another_task_without_libraries_has_no_answer(none_installed):
    arm = dh.load("ur5e")
    shown = other_solvers(arm, arm.forward([0.5] * 6), np.zeros(6))
    assert shown.count("not installed here") == 3 and "stored" not in shown


def test_where_no_process_can_be_had_the_stored_answers_stand(monkeypatch):
    def refused(*args, **kwargs):
        raise PermissionError("no processes here")

    monkeypatch.setattr(othersolvers.subprocess, "run", refused)
    assert other_solvers(*TASK).count("stored") == 3


def test_sliding_joints_are_refused():
    arm = dh.load("stanford")
    with pytest.raises(ValueError, match="turning joints only"):
        other_solvers(arm, arm.forward([0.3] * 6), np.zeros(6))


# ---- any q that reaches the pose of 08.13


def test_every_near_way_of_the_unseen_arm_passes_and_what_misses_is_told_by_how_much():
    ur5e = dh.load("ur5e")
    for variant in variants(4):
        T, q_now = (np.array(x) for x in LESSON["08.13"].given(variant).values())
        ways = ur5e.solve(T).q
        assert len(ways) >= 2
        passed = 0
        for q in ways:
            assert max(pose_errors(elementary_pose(ur5e.table, q), T)) < 1e-6
            near = bool((np.abs(np.rad2deg(wrapped(q - np.deg2rad(q_now)))) < 45).all())
            q = np.deg2rad(q_now) + wrapped(q - np.deg2rad(q_now))
            verdict = LESSON["08.13"].judge(q, variant)
            assert (verdict.status == "right") == near
            assert near or "another branch" in verdict.headline
            passed += near
        assert passed
        degrees = LESSON["08.13"].judge(np.rad2deg(ways[0]), variant)
        assert degrees.mistake == "degrees-for-radians"
        near = ways[0] + np.array([0.02, 0, 0, 0, 0, 0])  # turned about the base's axis
        metres = 2 * np.sin(0.01) * np.hypot(T[0, 3], T[1, 3])
        said = LESSON["08.13"].judge(near, variant).headline
        assert f"{1000 * metres:.3g} mm and 1.15° away" in said


@pytest.mark.parametrize("variant", variants(12))
def test_the_lessons_loop_brings_the_unseen_arm_there_from_where_it_stands(variant):
    T, q_now = (np.array(x) for x in LESSON["08.13"].given(variant).values())
    q = RIGHT_WAYS["08.6"][0](dh.load("ur5e").table.rows, T, np.deg2rad(q_now), 0.05, 100)
    assert LESSON["08.13"].judge(q, variant).status == "right"
    for turns in ([0, 0, -3, 0, 0, 0], [1, 0, 0, 0, 0, 0], [0, 2, 0, 0, 0, -1]):
        verdict = LESSON["08.13"].judge(q + 2 * np.pi * np.array(turns), variant)
        assert verdict.status == "wrong" and "whole turns are left" in verdict.headline
        joint = 1 + int(np.argmax(np.abs(turns)))
        assert verdict.place.startswith(f"joint {joint} would turn by") and "2π" in verdict.next


def test_all_the_ways_at_once_are_told_that_one_is_asked():
    T, q_now = (np.array(x) for x in LESSON["08.13"].given(1).values())
    found = dh.load("ur5e").solve(T)
    near = (np.abs(wrapped(found.q - np.deg2rad(q_now))) < np.pi / 4).all(axis=1)
    for answer in (found, found.q, found.q.tolist()):
        verdict = LESSON["08.13"].judge(answer, 1)
        assert verdict.headline == f"these are {len(found)} q, and one is asked"
        assert verdict.place.startswith(f"{near.sum()} of them reach") and "q_now" in verdict.next
    assert LESSON["08.13"].judge(found.q[~near], 1).place.startswith("none of them reach")
    assert LESSON["08.13"].judge(found.q[near][0], 1).status == "right"


def test_the_lines_of_a_column_make_the_column():
    """The lines of 08.10, run: a right order gives the derivative, a wrong one another or none."""
    exercise, q = LESSON["08.10"], np.deg2rad([10, 30, -40, 25, 50, 0])
    code = {key: text.strip("`") for key, text in exercise.items.items()}
    right = by_differences(partial(elementary_pose, ARM.table), q)[:, 2]

    def column(lines):
        space = {"np": np, "arm": ARM, "q": q, "i": 3}
        try:
            for line in lines:
                exec(code[line], space)
        except NameError:
            return None
        return space.get("column")

    orders = list(permutations(["frames", "end", "frame-before", "lever", "stack"]))
    orders += [
        ("frames", "end", *rest)
        for rest in (
            ("own-frame", "lever", "stack"),
            ("frame-before", "lever-reversed", "stack"),
            ("frame-before", "base-origin", "stack"),
        )
    ]
    for lines in orders:
        found = column(lines)
        good = found is not None and np.allclose(found, right, atol=1e-6)
        assert (exercise.judge(list(lines)).status == "right") == good, lines


BENT_END = elementary_pose(ARM.table, np.deg2rad([0, 40, -60, 50, 40, 0]))[:3, 3]


@pytest.mark.parametrize("key", ["08.2", "08.11"])
@pytest.mark.parametrize(
    "end, said",
    [
        (lambda frames, T: BENT_END, "p is not among the arguments: it is the end at bent"),
        (lambda frames, T: T[3, :3], "p is 0"),
        (lambda frames, T: T[:3, 2], "T_end[:3, 2]"),
        (lambda frames, T: frames[0][:3, 3], "frames[0], which is frames[-6]"),
        (lambda frames, T: frames[-2][:3, 3], "frames[4], which is frames[-2]"),
    ],
)
def test_a_lever_to_another_point_is_told_which(key, end, said):
    def jacobian(frames, T_end, sliding):
        columns = []
        for frame, slides in zip(frames, sliding):
            z, o = frame[:3, 2], frame[:3, 3]
            v = z if slides else np.cross(z, end(frames, T_end) - o)
            columns.append([*v, *(0 * z if slides else z)])
        return np.array(columns).T

    verdict = LESSON[key].judge(jacobian)
    assert verdict.status == "wrong" and said in verdict.place
    if verdict.sparing:
        assert verdict.at_try(1).place == "" and verdict.at_try(2).place
