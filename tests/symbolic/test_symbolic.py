"""Formulas against numbers: lambdified products against ``arm.forward``, derivatives against its
Jacobian and finite differences.
"""

import sys
from itertools import product

import numpy as np
import pytest
from draws import few

from dhlab import Arm, DHTable, load, robots, symbolic
from dhlab.symbolic.numbers import the_sympy
from dhlab.transform import from_xyz_rpy, rot_x, rot_z, trans_x, trans_z


@pytest.fixture(autouse=True)
def seeded():
    """Every test draws the same numbers, whichever ran before it; sympy is loaded by the process
    that runs the tests, not by every one that collects them.
    """
    global rng, sympy
    sympy = pytest.importorskip("sympy")
    rng = np.random.default_rng(7)


def numbers(T, n, q):
    return np.array(sympy.lambdify(symbolic.variables(n), T)(*q), dtype=float)


def worst(T, arm, trials=4):
    n = len(arm)
    return max(
        np.abs(numbers(T, n, q) - arm.forward(q)).max() for q in rng.uniform(-2.5, 2.5, (trials, n))
    )


def random_arm(convention, joints):
    n = len(joints)
    rows = np.column_stack(
        [
            rng.choice([0, 90, -90, 180, 35.5], n),
            rng.choice([0, 0.1, -0.25], n),
            rng.choice([0, 0.4, -0.1], n),
            rng.choice([0, 90, -90, 180, 60, 23.25], n),
        ]
    )
    table = getattr(DHTable, convention)(rows, angle="deg", joints=joints)
    base, tool = (
        from_xyz_rpy([0.1, 0, 0.5], [0, 0.3, np.pi / 2]),
        from_xyz_rpy([0, 0.02, 0.1], [np.pi, 0, -np.pi / 4]),
    )
    return Arm(table, base=base, tool=tool, sign=rng.choice([1, -1], n))


@pytest.mark.parametrize("convention", ["standard", "craig"])
def test_steps_multiply_up_to_the_link_matrix(convention):
    found = symbolic.steps(convention)
    theta, d, a, alpha = 0.7, 0.2, -0.4, 1.1
    values = dict(zip(sympy.symbols("theta d a alpha", real=True), (theta, d, a, alpha)))
    moves = [rot_z(theta), trans_z(d), trans_x(a), rot_x(alpha)]
    moves = moves if convention == "standard" else [moves[3], moves[2], moves[0], moves[1]]
    running = np.eye(4)
    for step, move in zip(found, moves, strict=True):
        running = running @ move
        assert np.abs(np.array(step.matrix.subs(values), dtype=float) - move).max() < 1e-15
        assert np.abs(np.array(step.product.subs(values), dtype=float) - running).max() < 1e-15
    assert found[-1].product == symbolic.link(convention=convention)
    assert (
        found[0]
        ._repr_latex_()
        .startswith(r"$\mathrm{" + ("Rot}(z" if convention == "standard" else "Rot}(x"))
    )
    assert found._repr_latex_().count("so far") == 4


@pytest.mark.slow
@pytest.mark.parametrize("name", few(robots(), 6))
def test_product_of_every_arm_of_the_library(name):
    arm = load(name)
    assert worst(symbolic.product(arm), arm) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize(
    "convention, joints",
    few(
        product(["standard", "craig"], ["RRRRRR", "P", "RPRRPR", "RRRRRRR", "PRP", "PPPR", "RRP"]),
        3,
    ),
)
def test_product_of_random_arms_whole_and_with_joints_fixed(convention, joints):
    arm, n = random_arm(convention, joints), len(joints)
    assert worst(symbolic.product(arm), arm) < 1e-12
    q = rng.uniform(-2, 2, n).round(3)
    for some in (rng.choice(n, max(n - 2, 1), replace=False), range(n)):
        T = symbolic.product(arm, {int(i) + 1: q[i] for i in some})
        assert (
            T.free_symbols
            == {symbolic.variables(n)[i] for i in range(n) if i not in set(some)} & T.free_symbols
        )
        assert np.abs(numbers(T, n, q) - arm.forward(q)).max() < 1e-12


def test_parallel_axes_are_gathered_also_across_fixed_joints():
    q = symbolic.variables(6)
    article = symbolic.product(load("article-6r"))
    assert {call.args[0] for call in article.atoms(sympy.cos)} == {
        q[0],
        q[1],
        q[1] + q[2],
        q[1] + q[2] + q[3],
        q[4],
        q[5],
    }
    wrist = symbolic.product(load("article-6r-wrist"), {5: 0})
    assert q[3] + q[5] in {call.args[0] for call in wrist.atoms(sympy.cos)}
    middle = symbolic.product(load("article-6r"), {3: 0.2})
    assert q[1] + q[3] + sympy.Rational(1, 5) in {call.args[0] for call in middle.atoms(sympy.cos)}
    assert symbolic.product(load("article-6r"), dict.fromkeys(range(1, 7), 0)) == sympy.Matrix(
        [
            [1, 0, 0, sympy.Rational(3, 4)],
            [0, 0, -1, -sympy.Rational(1, 5)],
            [0, 1, 0, sympy.Rational(1, 10)],
            [0, 0, 0, 1],
        ]
    )


def test_a_hair_from_parallel_is_not_parallel():
    table = DHTable.standard(
        [[0, 0.1, 0.4, np.pi / 2], [0, 0.1, 0.3, -1.5708], [0, 0, 0.2, 1e-9], [0, 0, 0.1, 0]],
        angle="rad",
    )
    T = symbolic.product(table)
    assert sympy.cos(sympy.Add(*symbolic.variables(4)[2:])) not in T.atoms(sympy.cos)
    assert worst(T, Arm(table)) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("name", few(["article-6r", "ur5e", "stanford", "panda"], 2))
def test_derivatives(name):
    arm = load(name)
    n, T = len(arm), symbolic.product(arm)
    q = rng.uniform(-2, 2, n)
    J, end, step = arm.jacobian(q), arm.forward(q), 1e-6
    for i in range(1, n + 1):
        dT = numbers(symbolic.derivative(T, i), n, q)
        assert np.abs(dT[:3, 3] - J[:3, i - 1]).max() < 1e-12
        assert np.abs(dT[:3, :3] @ end[:3, :3].T - np.cross(np.eye(3), J[3:, i - 1])).max() < 1e-12
        h = step * np.eye(n)[i - 1]
        assert np.abs(dT - (arm.forward(q + h) - arm.forward(q - h)) / (2 * step)).max() < 1e-8
        assert symbolic.derivative(T, symbolic.variables(n)[i - 1]) == symbolic.derivative(T, i)


def test_exact_numbers():
    pi, Rational = sympy.pi, sympy.Rational
    for value, expected in [
        (np.pi, pi),
        (np.deg2rad(-45), -pi / 4),
        (np.deg2rad(79.35), pi * Rational(7935, 18000)),
        (0.3, Rational(3, 10)),
        (0, 0),
    ]:
        assert symbolic.exact(value, "angle") == expected
    for value, expected in [
        (0.35, Rational(7, 20)),
        (-0.0825, Rational(-33, 400)),
        (3, 3),
        (0.1 + 0.2, Rational(3, 10)),
        (1e-3, Rational(1, 1000)),
    ]:
        assert symbolic.exact(value) == expected
    assert symbolic.exact(sympy.Symbol("h")) == sympy.Symbol("h")
    for value in rng.uniform(-3, 3, 50):
        for kind in ("length", "angle"):
            assert abs(float(symbolic.exact(value, kind)) - value) < 1e-15 * max(1, abs(value))


def test_shorthand_and_latex():
    q1, q2, q3 = symbolic.variables(3)
    assert symbolic.latex(sympy.cos(q1 + q2)) == "c_{12}"
    assert symbolic.latex(sympy.sin(q2 - q3)) == "s_{2-3}"
    assert "cos" in symbolic.latex(sympy.cos(q1), shorthand=False) and "cos" in symbolic.latex(
        sympy.cos(2 * q1)
    )
    assert symbolic.short(symbolic.product(load("ur5e")))._repr_latex_().startswith("$")
    assert symbolic.latex(symbolic.steps()[0].matrix).count(r"\theta") == 4


def test_what_is_refused():
    for call, words in [
        (lambda: symbolic.product("ur5e"), "DHTable or an Arm"),
        (lambda: symbolic.product(load("ur5e"), {7: 0}), "1 to 6"),
        (lambda: symbolic.product(load("ur5e"), {0: 0}), "counted from 1"),
        (lambda: symbolic.product(load("ur5e"), {1: np.nan}), "finite"),
        (lambda: symbolic.product(load("ur5e"), {1: "x"}), "finite number"),
        (lambda: symbolic.steps("modified"), "craig"),
        (lambda: symbolic.derivative(sympy.eye(4), 0), "number of a joint"),
    ]:
        with pytest.raises(ValueError, match=words) as error:
            call()
        assert "\n" not in str(error.value)


def test_without_sympy(monkeypatch):
    monkeypatch.setitem(sys.modules, "sympy", None)
    the_sympy.cache_clear()
    for call in (symbolic.steps, symbolic.link, lambda: symbolic.product(load("ur5e"))):
        with pytest.raises(ValueError, match=r"pip install dhlab-kinematics\[symbolic\]"):
            call()
