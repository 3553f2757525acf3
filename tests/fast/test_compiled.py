"""The kernels that numba compiles give what the other paths give, and are loaded only when that
pays. (Skipped by name where numba is not installed; CI has it.)
"""

import os
import subprocess
import sys
from types import SimpleNamespace

import numpy as np
import pytest
from cases import arms
from hypothesis import given
from hypothesis import strategies as st

import dhlab as dh
from dhlab.fast import compiled
from dhlab.fast.compiled import Compiled

QUESTIONS = ("forward", "frames", "jacobian")
BY_NAME = "numba is not installed (the extra [fast]), so nothing was compiled"


@pytest.fixture(scope="module")
def numba():
    if compiled.kernels() is None:
        if os.environ.get("CI"):
            pytest.fail("CI needs numba: install the [fast] extra")
        pytest.skip(BY_NAME)


def machine(arm, kind):
    shape = ((4, 4), (len(arm) + 1, 4, 4), (6, len(arm)))[kind]
    return Compiled(arm._kinematics.chain, kind, shape, fallback=lambda q, out: "the slow way")


@given(arms(), st.integers(0, 2**32 - 1))
@pytest.mark.parametrize("kind", range(3))
def test_kernels_are_the_plain_product(numba, kind, arm, seed):
    q = np.random.default_rng(seed).uniform(-4, 4, (130, len(arm)))
    right = getattr(arm._kinematics.plain, QUESTIONS[kind])(q)
    kernel, out = machine(arm, kind), np.full(right.shape, np.nan)
    assert kernel.rows(None, q, out)
    assert np.allclose(out, right, rtol=0, atol=1e-13 * max(1, np.abs(right).max()))
    alone = [kernel.take(row) for row in q[:5]]
    assert np.allclose(alone, right[:5], rtol=0, atol=1e-13 * max(1, np.abs(right).max()))
    assert np.array_equal(kernel.floats(q[0].tolist()), alone[0])


@pytest.mark.parametrize("m", [0, 1, 63, 64, 65, 128, 8193, 20000])
def test_blocks_and_threads_leave_nothing_out(numba, m):
    arm = dh.load("panda")
    q = np.random.default_rng(m).uniform(-3, 3, (m, 7))
    out = np.full((m, 4, 4), np.nan)
    assert machine(arm, 0).rows(None, q, out)
    assert np.allclose(out, arm._kinematics.plain.forward(q), rtol=0, atol=1e-14)


@pytest.mark.parametrize("angle", [1e4, 1e6, 1e9, 1e300])
def test_large_angles_keep_their_digits(numba, angle):
    arm = dh.Arm(dh.DHTable.standard([[0, 0, 1, 0]], angle="deg"))
    q = np.array([[angle]] * 3)
    out = np.empty((3, 4, 4))
    machine(arm, 0).rows(None, q, out)
    assert np.allclose(out, arm._kinematics.plain.forward(q), rtol=0, atol=4e-16)
    assert np.allclose(machine(arm, 0).take(q[0]), out[0], rtol=0, atol=4e-16)


def test_many_turns_of_parallel_joints_keep_their_digits(numba):
    arm = dh.load("article-6r")  # joints 2, 3 and 4 are parallel
    q = np.random.default_rng(0).uniform(-1e4, 1e4, (200, 6))
    for kind, question in enumerate(QUESTIONS):
        right, kernel = getattr(arm._kinematics.plain, question)(q), machine(arm, kind)
        out = np.empty(right.shape)
        assert kernel.rows(None, q, out)
        assert np.allclose(out, right, rtol=0, atol=2e-14)
        assert np.allclose([kernel.take(row) for row in q], right, rtol=0, atol=2e-14)


def test_what_is_no_row_of_doubles_goes_the_slow_way(numba):
    take = machine(dh.load("ur5e"), 0).take
    q = np.zeros(6)
    bad = q.copy()
    bad[3] = np.nan
    for given_q in ([0] * 6, q.astype(int), q.astype(np.float32), q[:5], np.zeros((2, 6)), bad, 0):
        assert isinstance(take(given_q), str)
    series = SimpleNamespace(ndim=1, dtype=np.dtype(float), values=q)  # as a column of a table
    assert isinstance(take(series), str)
    packed = np.zeros(1, np.dtype([("name", "u1"), ("q", "f8", 6)]))["q"][0]
    assert not packed.flags.aligned and np.array_equal(take(packed), take(q))
    q.flags.writeable = False
    assert np.array_equal(take(q), take(np.zeros(12)[::2]))


def test_what_says_it_has_one_dimension_and_has_more_goes_the_slow_way(numba):
    class Flat(np.ndarray):
        ndim = property(lambda self: 1)

    assert isinstance(machine(dh.load("ur5e"), 0).take(np.zeros((6, 1)).view(Flat)), str)


def test_a_child_process_has_threads_of_its_own(numba):
    program = (
        "import os, sys, numpy as np, dhlab as dh; arm = dh.load('ur5e');"
        "q = np.zeros((40000, 6)); arm.forward(q); child = os.fork();"
        "done = child == 0 and bool(np.isfinite(arm.forward(q)).all());"
        "child == 0 and os._exit(0 if done else 1);"
        "sys.exit(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))"
    )
    environment = {**os.environ, "DHLAB_NUMBA": "1"}
    subprocess.run([sys.executable, "-c", program], check=True, env=environment, timeout=100)


def test_a_numba_that_does_not_work_is_left_out(tmp_path):
    (tmp_path / "numba.py").write_text("raise ImportError('needs another numpy')", "utf-8")
    program = (
        "import warnings, numpy as np, dhlab as dh\n"
        "with warnings.catch_warnings(record=True) as said:\n"
        "    warnings.simplefilter('always')\n"
        "    T = dh.load('ur5e').forward(np.zeros((100, 6)))\n"
        "assert np.isfinite(T).all() and 'needs another numpy' in str(said[0].message)"
    )
    environment = {**os.environ, "DHLAB_NUMBA": "1", "PYTHONPATH": str(tmp_path)}
    subprocess.run([sys.executable, "-c", program], check=True, env=environment)


@pytest.mark.parametrize("wanted", ["0", "1"])
@pytest.mark.parametrize("m", [None, 5, 300])
def test_a_coupling_that_overflows_is_refused(numba, monkeypatch, wanted, m):
    monkeypatch.setenv("DHLAB_NUMBA", wanted)
    rows = [[0, 0.1, 0.2, 0.3]] * 3
    arm = dh.Arm(dh.DHTable.standard(rows, angle="rad"), coupling=[[1, 1, 0], [0, 1, 0], [0, 0, 1]])
    q = np.array([1e308, 1e308, 1.0])
    with pytest.raises(ValueError, match="the coupling makes finite joint values"):
        arm.forward(q if m is None else np.tile(q, (m, 1)))


def test_long_doubles_are_taken_as_doubles():
    arm = dh.Arm(dh.DHTable.standard([[0, 0.1, 0.2, 0.3]], angle="rad", joints="P"))
    assert arm.forward(np.array([0.5], np.longdouble)).dtype == np.float64
    if np.finfo(np.longdouble).max > np.finfo(float).max:
        with pytest.raises(ValueError, match="joint 1 is NaN or infinite"):
            arm.forward(np.array([1], np.longdouble) * np.longdouble("1e400"))


def test_other_layouts_and_types_of_a_batch(numba):
    arm, q = dh.load("ur5e"), np.random.default_rng(0).uniform(-1, 1, (300, 6))
    right, kernel = arm._kinematics.plain.forward(q), machine(arm, 0)
    wide = np.zeros((300, 4, 4, 2))
    for given_q, out in (
        (np.asfortranarray(q), np.empty((300, 4, 4))),
        (q, wide[..., 1]),
        (q, np.empty((300, 4, 4), np.float32)),
    ):
        assert kernel.rows(None, given_q, out)
        assert np.allclose(out, right, rtol=0, atol=1e-6 if out.dtype == np.float32 else 1e-14)


def test_a_batch_with_nan_is_refused_by_name(numba, monkeypatch):
    monkeypatch.setenv("DHLAB_NUMBA", "1")
    arm, q = dh.Arm(dh.load("ur5e").table), np.zeros((20000, 6))
    q[15000, 4] = np.inf
    with pytest.raises(ValueError, match="joint 5 is NaN or infinite"):
        arm.forward(q)
    with pytest.raises(ValueError, match="joint 5 is NaN or infinite"):
        arm.forward(q[15000])


def test_arms_change_over_when_it_pays(numba, monkeypatch):
    monkeypatch.delenv("DHLAB_NUMBA", raising=False)
    monkeypatch.setattr(compiled.Work, "seconds", 0.0)
    arm, q = dh.Arm(dh.load("ur5e").table), np.ones((100, 6))
    before = arm.forward(q)
    assert not arm._kinematics.paths[0].compiled
    monkeypatch.setattr(compiled.Work, "seconds", 2 * compiled.PATIENCE)
    after = arm.forward(q)
    assert arm._kinematics.paths[0].compiled
    assert np.allclose(after, before, rtol=0, atol=1e-15)
    for question in QUESTIONS:
        one = getattr(arm, question)(q[0])
        assert np.allclose(one, getattr(arm, question)(q)[0], rtol=0, atol=1e-15)


def test_a_few_poses_never_load_numba():
    program = (
        "import sys, numpy, dhlab as dh; arm = dh.load('ur5e');"
        "arm.forward([0] * 6); arm.jacobian(numpy.zeros((50000, 6)));"
        "print('numba' in sys.modules)"
    )
    environment = {key: value for key, value in os.environ.items() if key != "DHLAB_NUMBA"}
    run = subprocess.run(
        [sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=True
    )
    assert run.stdout.strip() == "False"
