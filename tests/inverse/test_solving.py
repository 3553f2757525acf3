"""``arm.solve``: every configuration for a pose, judged by a forward kinematics that is not
dhlab's.
"""

import numpy as np
import pytest
from draws import few
from oracles import exponential_pose, pose_errors

import dhlab as dh
from dhlab.robots import entry
from dhlab.robots.drawing_up import topology
from dhlab.transform import from_xyz_rpy, rot_x

TURNING = [name for name in few(dh.robots(), 24) if dh.load(name).table.joints == "R" * 6]
CLOSED = [  # the others are prepared
    name
    for name in TURNING
    if "2-3-4" in topology(dh.load(name)) or "spherical wrist" in topology(dh.load(name))
]
SPARE = ["iiwa14", "iiwa7", "panda"]
SLIDING = ["cobra600", "stanford"]
LENGTHS = {"l1": 0.4, "l2": 0.3, "l3": 0.1}


def judged(arm, q):
    """The end pose by the product of exponentials."""
    return arm.base @ exponential_pose(arm.table, arm.sign * q) @ arm.tool


def among(arm, q, answer, tolerance=1e-6):
    """Whether q is one of the solutions, whole turns aside."""
    apart = np.asarray(answer.q) - q
    turned = (apart + np.pi) % (2 * np.pi) - np.pi
    apart = np.where(arm.table.prismatic, apart, turned)
    return bool((np.abs(apart) < tolerance).all(axis=1).any())


def random_q(arm, seed, count=1):
    low, high = np.full(len(arm), -np.pi), np.full(len(arm), np.pi)
    for i in np.flatnonzero(arm.table.prismatic):
        low[i], high[i] = arm.limits[i]
    return np.random.default_rng(seed).uniform(low, high, (count, len(arm)))


def agree(first, second):
    """The same set of solutions."""
    return len(first) == len(second) and all(among(first.arm, q, second) for q in first)


@pytest.mark.slow
@pytest.mark.parametrize("name", few(CLOSED, 6))
def test_closed_form(judge, name):
    judge("ssik")
    arm = dh.load(name)
    for q in few(random_q(arm, 1, 5), 2):
        T = judged(arm, q)
        answer = arm.solve(T)
        assert "closed form" in answer.method and answer.complete
        assert among(arm, q, answer)
        assert all(max(pose_errors(judged(arm, row), T)) < 1e-9 for row in answer)
        assert answer.residuals.max() < 1e-9


@pytest.mark.slow
@pytest.mark.parametrize("name", few(TURNING + SLIDING, 6))
def test_search(name):
    arm = dh.load(name)
    q = random_q(arm, 2, 2)
    answers = arm.solve(np.array([judged(arm, row) for row in q]), method="search")
    for row, answer in zip(q, answers, strict=True):
        assert among(arm, row, answer) and not answer.complete
        assert all(max(pose_errors(judged(arm, one), answer.T)) < 1e-9 for one in answer)


@pytest.mark.parametrize("name", ["puma560", "ur5e", "ar4", "piper", "kr6_r700"])
def test_search_and_closed_form_find_the_same(judge, name):
    judge("ssik")
    arm = dh.load(name)
    for q in random_q(arm, 3, 2):
        T = arm.forward(q)
        assert agree(arm.solve(T), arm.solve(T, method="search"))


@pytest.mark.slow
@pytest.mark.parametrize("name", SPARE)
def test_a_stated_redundancy(judge, name):
    judge("ssik")
    arm = dh.load(name)
    joint = 7 if name == "panda" else 3
    for q in few(random_q(arm, 4, 4), 2):
        T = judged(arm, q)
        answer = arm.solve(T, redundancy=q[joint - 1])
        assert among(arm, q, answer) and np.allclose(answer.q[:, joint - 1], q[joint - 1])
        assert agree(answer, arm.solve(T, redundancy={joint: q[joint - 1]}))
        assert all(max(pose_errors(judged(arm, row), T)) < 1e-9 for row in answer)


@pytest.mark.slow
@pytest.mark.parametrize("name", SPARE)
@pytest.mark.parametrize("method", [None, "search"])
def test_no_stated_redundancy(name, method):
    arm = dh.load(name)
    low, high = np.transpose(arm.limits)
    for q in np.random.default_rng(5).uniform(low, high, (2, 7)):
        T = judged(arm, q)
        answer = arm.solve(T, limits=True, method=method)
        assert answer and answer.within_limits.all()
        assert all(max(pose_errors(judged(arm, row), T)) < 1e-9 for row in answer)


def test_several_values_of_the_redundancy():
    arm = dh.load("iiwa14")
    T = arm.forward([0.1, 0.2, 0.3, -1.4, 0.5, 0.6, 0.7])
    answer = arm.solve(T, redundancy=[0.3, 0.5])
    assert len(answer) == 16 and set(answer.q[:, 2].round(9)) == {0.3, 0.5}
    assert answer.held == ({3: 0.3}, {3: 0.5})


@pytest.mark.parametrize("name", SPARE)
def test_near_decides_the_redundancy_and_the_order(name):
    arm = dh.load(name)
    q = np.array([0.1, 0.2, 0.3, -1.4, 0.5, 0.6, 0.7])
    assert np.allclose(arm.solve(arm.forward(q), near=q)[0], q, atol=1e-8)


def two_links():
    rows = [[0, 0, LENGTHS["l1"], 0], [0, 0, LENGTHS["l2"], 0], [0, 0, LENGTHS["l3"], 0]]
    return dh.Arm(dh.DHTable.standard(rows, angle="deg"), name="planar")


def test_the_planar_arm_has_its_two_elbows():
    """Craig, Introduction to Robotics, section 4.4: law of cosines, elbow up and down."""
    l1, l2, l3 = LENGTHS.values()
    for x, y, phi in np.random.default_rng(6).uniform([0.2, -0.3, -3], [0.4, 0.3, 3], (5, 3)):
        wx, wy = x - l3 * np.cos(phi), y - l3 * np.sin(phi)
        cosine = (wx**2 + wy**2 - l1**2 - l2**2) / (2 * l1 * l2)
        answer = two_links().solve(from_xyz_rpy([x, y, 0], [0, 0, phi]))
        assert len(answer) == (2 if abs(cosine) < 1 else 0)
        for elbow in (np.arccos(cosine), -np.arccos(cosine)) if answer else ():
            shoulder = np.arctan2(wy, wx) - np.arctan2(l2 * np.sin(elbow), l1 + l2 * np.cos(elbow))
            assert among(answer.arm, [shoulder, elbow, phi - shoulder - elbow], answer)


@pytest.mark.parametrize("method", [None, "search"])
def test_the_eight_ways_of_the_puma(judge, method):
    """Left or right, elbow up or down, wrist flipped or not: Paul and Zhang 1986, as Robotics
    Toolbox has it.
    """
    rtb = judge("roboticstoolbox")
    arm, robot = dh.load("puma560"), rtb.models.DH.Puma560()
    for q in np.random.default_rng(7).uniform(-1, 1, (3, 6)):
        T = robot.fkine(q).A
        answer = arm.solve(T, method=method)
        ways = [robot.ikine_a(T, a + b + c) for a in "lr" for b in "ud" for c in "nf"]
        known = [way.q for way in ways if way.success]
        assert len(known) == len(answer) == 8
        assert all(among(arm, row, answer) for row in known)


@pytest.mark.parametrize("name", ["panda", "kr6_r700", "puma560.craig_mod", "xarm6"])
def test_the_other_convention_has_the_same_solutions(name):
    arm = dh.load(name)
    T = arm.forward(random_q(arm, 8)[0])
    method = "search" if name == "xarm6" else None
    stated = {"redundancy": 0.4} if len(arm) == 7 else {}
    other = arm.to("standard").solve(T, method=method, **stated)
    assert agree(arm.solve(T, method=method, **stated), other)


def test_base_tool_signs_offsets_and_both_ways_of_counting():
    arm = dh.load("irb120")
    moved = dh.Arm(
        arm.table,
        base=from_xyz_rpy([1, 2, 3], [0.1, 0.2, 0.3]),
        tool=from_xyz_rpy([0.1, 0, 0.2], [0.4, -0.2, 1]),
        sign=[-1, 1, -1, 1, -1, 1],
    )
    q = np.array([0.3, -0.2, 0.4, 1, 0.7, -2])
    answer = moved.solve(judged(moved, q))
    assert len(answer) == 8 and among(moved, q, answer)


def test_many_targets_at_once_are_what_each_is_alone():
    arm = dh.load("article-6r")
    T = arm.forward(random_q(arm, 9, 3))
    for one, answer in zip(T, arm.solve(T), strict=True):
        assert agree(answer, arm.solve(one))
    assert arm.solve(np.empty((0, 4, 4))) == []


def test_the_order_is_by_distance():
    arm = dh.load("ur5e")
    near = np.array([0.5, -1.2, 0.8, 0, 1, 0])
    answer = arm.solve(arm.forward([0.1, -1, 1, 0.4, 0.5, 0.6]), near=near)
    away = np.abs(answer.q - near).max(axis=1)
    assert (np.diff(away) >= 0).all() and (np.abs(answer.q - near) <= np.pi + 1e-9).all()


def test_limits_are_kept_on_demand_by_whole_turns():
    arm = dh.load("puma560")
    q = np.deg2rad([10, 200, -200, 20, 30, 60])
    T = arm.forward(q)
    every, kept = arm.solve(T), arm.solve(T, limits=True)
    assert kept.within_limits.all() and among(arm, q, kept)
    assert np.abs(kept.q - q).max(axis=1).min() < 1e-8  # not a turn away
    assert len(kept) == every.within_limits.sum() < len(every) == len(kept) + len(kept.outside)


def test_a_solution_on_a_limit_keeps_it():
    arm = dh.load("irb120")
    low, high = np.transpose(arm.limits)
    q = np.where([1, 0, 1, 0, 1, 0], low, high)
    q[4] = 0.3
    assert among(arm, q, arm.solve(arm.forward(q), limits=True))


def test_a_singular_pose_names_the_family():
    arm = dh.load("puma560")
    q = np.array([0.1, 0.2, 0.3, 0.4, 0.0, 0.6])
    for method in (None, "search"):
        answer = arm.solve(arm.forward(q), method=method)
        k = answer.families.index((4, 6))
        assert np.allclose(answer[k][[0, 1, 2, 4]], q[[0, 1, 2, 4]], atol=1e-6)
        assert np.isclose(answer[k][3] + answer[k][5], 1.0, atol=1e-6)
        assert sum(map(bool, answer.families)) == 1 and len(answer) == 7


def test_the_stretched_arm_is_singular_and_stands_alone():
    arm = two_links()
    answer = arm.solve(arm.forward([0.3, 0, 0.2]))
    assert len(answer) == 1 and answer.families == ((),)
    assert np.allclose(
        answer[0], [0.3, 0, 0.2], atol=1e-4
    )  # a double root: the square root of 1e-9


def test_a_pose_typed_with_seven_digits_is_met():
    arm = dh.load("ur5e")
    T = arm.forward([0.1, -1, 1, 0.4, 0.5, 0.6]).round(7)
    answer = arm.solve(T)
    assert len(answer) == 8 and np.abs(answer.T - T).max() < 1e-6


def test_what_comes_back_is_a_sequence():
    arm = dh.load("article-6r")
    answer = arm.solve(arm.forward([0.3, 0.4, -0.7, 0.5, 0.9, 0.2]))
    assert answer and list(map(len, answer)) == [6] * len(answer)
    assert np.array_equal(np.asarray(answer), answer.q) and np.array_equal(answer[-1], answer.q[-1])
    assert answer.reason is None and answer.nearest is None
    assert answer.to_dict()["solved"] is True and "8 solutions" in repr(answer)
    assert "<table" in answer._repr_html_()


@pytest.mark.parametrize("key", ["puma560.akb_mod", "piper.sdk_old", "ur5_cb.arte"])
def test_alternative_tables_are_solved_too(key):
    name, table = key.split(".")
    arm = entry(name).tables[table]
    q = random_q(arm, 10)[0]
    assert among(arm, q, arm.solve(judged(arm, q)))


def test_more_than_seven_joints_and_a_sliding_one():
    rows = [[0, 0.3, 0, 90], [0, 0, 0.4, 0], [0, 0, 0.3, 90], [0, 0.2, 0, -90], [0, 0, 0.1, 90]]
    rows += [[0, 0.2, 0, -90], [0, 0, 0.1, 90], [0, 0.1, 0, 0]]
    arm = dh.Arm(dh.DHTable.standard(rows, angle="deg", joints="RRRRPRRR"), name="long")
    T = arm.forward([0.1, 0.2, 0.3, 0.4, 0.1, 0.6, 0.7, 0.8])
    answer = arm.solve(T)
    assert answer and all(max(pose_errors(judged(arm, q), T)) < 1e-9 for q in answer)
    held = arm.solve(T, redundancy={2: 0.2, 5: 0.1})
    assert held and np.allclose(held.q[:, [1, 4]], [0.2, 0.1])


def test_a_general_arm_is_searched_at_once_and_says_how_to_prepare_it(judge):
    judge("ssik")
    arm = dh.load("jaco6")
    answer = arm.solve(arm.forward([0.1, 2.2, 2.5, 0.3, 0.4, 0.5]))
    assert "search" in answer.method and any("--prepare" in note for note in answer.notes)
    with pytest.raises(ValueError, match="minutes"):
        arm.solve(answer.T, method="closed form")


@pytest.mark.parametrize(
    "arguments, words",
    [
        ({"T": np.eye(3)}, "expected a pose"),
        ({"T": np.diag([1, 1, -1, 1])}, "mirror"),
        ({"T": 2 * np.eye(4)}, "last row"),
        ({"T": [[1, 2], [3]]}, "expected a pose"),
        ({"tolerance": 0}, "above 0"),
        ({"tolerance": "1 mm"}, "above 0"),
        ({"near": [0, 0]}, "6 values"),
        ({"near": np.zeros((2, 6))}, "one configuration"),
        ({"redundancy": 0.3}, "joint to spare"),
        ({"method": "newton"}, "closed form"),
    ],
)
def test_mistakes_are_told_in_one_sentence(arguments, words):
    arm = dh.load("ur5e")
    with pytest.raises(ValueError, match=words) as told:
        arm.solve(**({"T": np.eye(4)} | arguments))
    assert "\n" not in str(told.value)


@pytest.mark.parametrize(
    "redundancy, words",
    [
        ({0: 1.0}, "joints from 1 to 7"),
        ({8: 1.0}, "joints from 1 to 7"),
        ({1: 0.1, 2: 0.2}, "one joint"),
        ({3: np.nan}, "joint 3"),
        ({3: "a"}, "joint 3"),
        ([], "joint 7"),
    ],
)
def test_a_redundancy_that_makes_no_sense(redundancy, words):
    with pytest.raises(ValueError, match=words):
        dh.load("panda").solve(np.eye(4), redundancy=redundancy)


def test_closed_form_is_refused_where_there_is_none():
    arm = dh.load("cobra600")
    with pytest.raises(ValueError, match="no closed form"):
        arm.solve(arm.forward([0, 0.1, 0.1, 0]) @ rot_x(0.0), method="closed form")


FANUC = np.eye(6)
FANUC[2, 1] = -1  # joint 3 is counted against the floor: motor 2 turns it back


@pytest.mark.parametrize("method", [None, "search"])
def test_coupled_joints_on_the_way_back(method):
    arm = dh.load("kr6_r700")
    coupled = dh.Arm(arm.table, tool=arm.tool, sign=arm.sign, limits=arm.limits, coupling=FANUC)
    q = np.deg2rad([20, -60, 40, 10, 50, -30])
    T = arm.base @ exponential_pose(arm.table, FANUC @ (arm.sign * q)) @ arm.tool
    answer = coupled.solve(T, method=method)
    assert among(coupled, q, answer)
    assert len(answer) == len(arm.solve(T, method=method))
    assert all(np.abs(coupled.forward(row) - T).max() < 1e-9 for row in answer)
    assert among(coupled, q, coupled.solve(T, method=method, limits=True))


def test_a_coupled_joint_can_be_held_too():
    arm = dh.load("iiwa14")
    C = np.eye(7)
    C[2, 1] = 0.5
    coupled = dh.Arm(arm.table, tool=arm.tool, coupling=C)
    q = np.array([0.1, 0.2, 0.3, -1.4, 0.5, 0.6, 0.7])
    for joint in (3, 1):
        answer = coupled.solve(coupled.forward(q), redundancy={joint: q[joint - 1]})
        assert among(coupled, q, answer)
        assert np.allclose(answer.q[:, joint - 1], q[joint - 1])
