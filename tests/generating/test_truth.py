"""Generated poses and Jacobians are right, for every arm of the library and for random ones."""

import numpy as np
import pytest
from compiling import InC, InPython, random_arm, worst
from draws import few, shared_out

import dhlab as dh
from dhlab.generating import formulas, runs
from dhlab.generating.formulas import forward_formulas, jacobian_formulas
from dhlab.generating.lines import Lines
from dhlab.robots import entry
from dhlab.transform import from_xyz_rpy

TABLES = [f"{arm}.{table}" for arm in few(dh.robots(), 12) for table in entry(arm).tables]


@pytest.mark.slow
@pytest.mark.parametrize("name", shared_out(TABLES, 0, 2))
def test_every_table_of_the_library_in_c(name, gcc, tmp_path):
    arm = dh.load(name)
    assert worst(InC(gcc, arm, tmp_path), arm) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("name", shared_out(TABLES, 1, 2))
def test_every_table_of_the_library_in_python(name):
    arm = dh.load(name)
    assert worst(InPython(arm), arm) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("convention", ["standard", "craig"])
@pytest.mark.parametrize("n", [1, 2, 3, 4, 6, 7, 9])
def test_random_arms_with_every_part(n, convention):
    for seed in few(range(12), 4):
        arm = random_arm(seed, n, convention)
        assert worst(InPython(arm), arm, trials=5, seed=seed) < 1e-12


@pytest.mark.parametrize("k, convention", [(0, "standard"), (1, "craig")])
def test_random_arms_in_c(k, convention, gcc, tmp_path):
    for seed, n in shared_out(enumerate([1, 3, 6, 7]), k, 2):
        folder = tmp_path / str(n)
        folder.mkdir()
        arm = random_arm(100 + seed, n, convention)
        assert worst(InC(gcc, arm, folder), arm, trials=5) < 1e-12


@pytest.mark.parametrize("length", [1e-9, 1e-4, 1.0, 1e3])
def test_tiny_and_huge_lengths_are_right_in_their_own_size(length, gcc, tmp_path):
    rows = [[0, length, 0, 90], [10, 0, 3 * length, 0], [0, 0, 2 * length, 90], [0, length, 0, 0]]
    arm = dh.Arm(dh.DHTable.standard(rows, angle="deg"))
    assert worst(InC(gcc, arm, tmp_path), arm, reach=7 * length) < 1e-13


def test_lengths_of_all_sizes_in_one_table(gcc, tmp_path):
    rows = [[0, 1e-9, 1e3, 90], [0, 1e3, 1e-9, 0], [0, 1e-6, 1.0, -90], [5, 0, 1e-3, 0]]
    arm = dh.Arm(dh.DHTable.craig(rows, angle="deg"))
    assert worst(InC(gcc, arm, tmp_path), arm, reach=2e3) < 1e-14


@pytest.mark.parametrize("alpha", [1e-15, 1e-9, 1e-8, 4e-8, np.pi - 1e-8, np.pi / 2 + 1e-9, 1.5708])
def test_axes_that_are_nearly_parallel_or_square_are_not_made_exact(alpha):
    arm = dh.Arm(dh.DHTable.standard([[0, 0.3, 0.5, alpha], [0, 0.2, 0.4, alpha]], angle="rad"))
    assert worst(InPython(arm), arm, trials=20) < 1e-14


def test_a_base_typed_with_few_digits_is_made_a_rotation_and_said_so(gcc, tmp_path):
    base = from_xyz_rpy([0.1, 0, 0], [0, 0, np.pi / 4]).round(6)
    tool = from_xyz_rpy([0, 0.1, 0], [0.4, 1.0, -0.2]).round(7)
    arm = dh.Arm(dh.load("ur5e").table, base=base, tool=tool)
    assert worst(InC(gcc, arm, tmp_path), arm, trials=5) < 1e-6
    text = dh.generate(arm, "c")
    assert "The rotation of the base was made exact; it was given 2e-07 off." in text
    assert "The rotation of the tool was made exact" in text
    assert "made exact" not in dh.generate(dh.load("ur5e").to("craig"), "c")


def test_a_pose_that_does_not_depend_on_q_compiles(gcc, tmp_path):
    arm = dh.Arm(dh.DHTable.standard([[0, 0.1, 0, 0], [0, 0, 0.2, 90]], angle="deg", joints="PP"))
    assert worst(InC(gcc, arm, tmp_path), arm, trials=3) < 1e-15


def test_joint_angles_may_be_mixtures_of_several_q(monkeypatch):
    """As in an arm whose motors are coupled: one function says how, and both formulas follow it."""
    arm = random_arm(3, 6, "standard")
    mixture = np.diag(arm.sign) @ (np.eye(6) + np.diag([0, -1, 0, 0.25, 0], 1))
    _, offset = runs.joint_variables(arm)
    for module in (runs, formulas):
        monkeypatch.setattr(module, "joint_variables", lambda arm: (mixture, offset))
    for q in np.random.default_rng(2).uniform(-2, 2, (20, 6)):
        own = arm.sign * (mixture @ q)
        T, J = evaluated(forward_formulas(arm), q), evaluated(jacobian_formulas(arm), q)
        assert abs(T - arm.forward(own)).max() < 1e-13
        assert abs(J - arm.jacobian(own) @ np.diag(arm.sign) @ mixture).max() < 1e-13


def evaluated(some, q):
    """Formulas as numbers."""
    lines = Lines(some)
    names = {"cos": np.cos, "sin": np.sin, "q": q}
    for name, text in lines.assignments:
        names[name] = eval(text, names)
    return np.array([[eval(text, names) for text in row] for row in lines.rows])


@pytest.mark.slow
def test_a_chain_of_a_hundred_joints(gcc, tmp_path):
    arm = random_arm(5, 100, "craig")
    assert worst(InC(gcc, arm, tmp_path), arm, trials=3, reach=100) < 1e-12
    flat = dh.Arm(dh.DHTable.standard([[1, 0, 0.1, 0]] * 100, angle="deg"))
    (tmp_path / "flat").mkdir()
    assert worst(InC(gcc, flat, tmp_path / "flat"), flat, trials=3) < 1e-12
