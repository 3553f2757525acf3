"""Every path gives the plain product: one pose, a handful, many; both conventions, every shape and
type of q, an array of one's own to write to.
"""

import copy
import pickle
from dataclasses import replace

import numpy as np
import pytest
from cases import arms, judged_jacobian, judged_pose
from hypothesis import given
from hypothesis import strategies as st
from oracles import exponential_pose

import dhlab as dh
from dhlab.fast import many, one
from dhlab.fast.chain import chain_of
from dhlab.fast.straight import straight

QUESTIONS = ("forward", "frames", "jacobian")
seeds = st.integers(0, 2**32 - 1)


def shape_of(arm, question):
    n = len(arm)
    return {"forward": (4, 4), "frames": (n + 1, 4, 4), "jacobian": (6, n)}[question]


def plain(arm, question, q):
    return getattr(arm._kinematics.plain, question)(q)


def by_rows(arm, question, q):
    out = np.full((len(q), *shape_of(arm, question)), np.nan)
    getattr(many, question)(arm._kinematics.chain, q, out)
    return out


def by_program(arm, question, q):
    program = straight(getattr(one, question), arm._kinematics.chain, shape_of(arm, question))
    return np.array([_or_plain(program(row), arm, question, row) for row in q.tolist()])


def by_floats(arm, question, q):
    chain, shape = arm._kinematics.chain, shape_of(arm, question)
    return np.array(
        [
            _or_plain(_floats(getattr(one, question), chain, row, shape), arm, question, row)
            for row in q.tolist()
        ]
    )


def _floats(ask, chain, row, shape):
    try:
        return np.reshape(ask(chain, row), shape)
    except OverflowError:
        return None


def _or_plain(answer, arm, question, row):
    """Where the angles of parallel joints add up to many turns, the plain product takes over."""
    return plain(arm, question, np.array(row)) if answer is None else answer


@given(arms(), seeds)
@pytest.mark.parametrize("question", QUESTIONS)
def test_every_path_is_the_plain_product(question, arm, seed):
    q = np.random.default_rng(seed).uniform(-4, 4, (5, len(arm)))
    right = plain(arm, question, q)
    for path in (by_rows, by_program, by_floats):
        assert np.allclose(path(arm, question, q), right, rtol=0, atol=2e-13)


@given(arms(largest=5), seeds)
def test_the_plain_product_is_the_judges(arm, seed):
    q = np.random.default_rng(seed).uniform(-3, 3, len(arm))
    assert np.allclose(plain(arm, "forward", q), judged_pose(arm, q), atol=1e-12)
    assert np.allclose(plain(arm, "jacobian", q), judged_jacobian(arm, q), atol=1e-7)


@pytest.mark.slow
@given(arms(coupled=st.just(False)), seeds)
def test_rows_are_the_product_of_exponentials(arm, seed):
    q = np.random.default_rng(seed).uniform(-3, 3, (4, len(arm)))
    right = [arm.base @ exponential_pose(arm.table, arm.sign * row) @ arm.tool for row in q]
    assert np.allclose(by_rows(arm, "forward", q), right, atol=1e-11)


@given(arms(), seeds)
@pytest.mark.parametrize("question", QUESTIONS)
def test_the_program_of_an_arm_does_what_floats_do(question, arm, seed):
    q = np.random.default_rng(seed).uniform(-4, 4, (5, len(arm)))
    assert np.array_equal(by_program(arm, question, q), by_floats(arm, question, q))


@pytest.mark.parametrize("name", ["article-6r", "panda", "stanford", "cobra600"])
@pytest.mark.parametrize("question", QUESTIONS)
def test_the_same_answer_however_many_are_asked(name, question):
    arm = dh.load(name)
    q = np.random.default_rng(0).uniform(-3, 3, (5000, len(arm)))
    right, ask = plain(arm, question, q), getattr(arm, question)
    for m in (0, 1, 2, 39, 40, 41, 1000, 5000):  # a part of a chunk, one, several
        assert np.allclose(ask(q[:m]), right[:m], rtol=0, atol=1e-14)
    alone = [ask(row) for row in q[:20]]  # in floats at first, by the arm's program then
    assert np.allclose(alone, right[:20], rtol=0, atol=1e-14)
    assert np.array_equal(ask(q[0]), alone[0])


@pytest.mark.parametrize("question", QUESTIONS)
def test_single_precision_is_rounded_once(question):
    arm = dh.load("ur5e")
    q = np.random.default_rng(0).uniform(-3, 3, (200, 6)).astype(np.float32)
    for given_q in (q, q[:5], q[0]):
        answer = getattr(arm, question)(given_q)
        assert answer.dtype == np.float32
        right = getattr(arm, question)(given_q.astype(float))
        assert np.abs(answer - right).max() <= np.spacing(np.float32(1.5))


@pytest.mark.parametrize("question", QUESTIONS)
@pytest.mark.parametrize("m", [(), (1,), (7,), (3, 70)])
def test_out_is_written_and_handed_back(question, m):
    arm = dh.load("panda")
    q = np.random.default_rng(1).uniform(-2, 2, (*m, 7))
    right, shape = getattr(arm, question)(q), (*m, *shape_of(arm, question))
    wide = np.full((*shape, 2), np.nan)
    for out in (np.empty(shape), np.empty(shape, np.float32), wide[..., 0]):
        assert getattr(arm, question)(q, out=out) is out
        assert np.allclose(out, right, atol=1e-6 if out.dtype == np.float32 else 0)
    assert np.isnan(wide[..., 1]).all()


@pytest.mark.parametrize(
    "out, words",
    [
        (np.empty((5, 4, 4)), "shape"),
        (np.empty((50, 4, 4), int), "float64"),
        ([0], "found list"),
        (np.broadcast_to(np.zeros(1), (50, 4, 4)), "read-only"),
    ],
)
def test_a_wrong_out_is_one_plain_sentence(out, words):
    with pytest.raises(ValueError, match=words) as error:
        dh.load("ur5e").forward(np.zeros((50, 6)), out=out)
    assert "expected" in str(error.value) and "\n" not in str(error.value)


def test_the_memory_of_q_is_not_written_to():
    q = np.zeros((4, 4))
    with pytest.raises(ValueError, match="memory of its own"):
        dh.Arm(dh.DHTable.standard([[0, 0, 1, 0]] * 4, angle="deg")).forward(q[0], out=q)


@pytest.mark.parametrize("m", [1, 10, 3000])
@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
def test_a_joint_that_is_no_number_is_named_in_every_path(m, bad):
    arm, q = dh.load("stanford"), np.zeros((m, 6))
    q[-1, 2] = bad
    for question in QUESTIONS:
        with pytest.raises(ValueError, match="joint 3 is NaN or infinite"):
            getattr(arm, question)(q)
        with pytest.raises(ValueError, match="joint 3 is NaN or infinite"):
            getattr(arm, question)(q[-1])


@pytest.mark.parametrize("kind", [np.int64, np.uint8, np.float16, np.longdouble, ">f8"])
def test_every_kind_of_number_is_taken(kind):
    arm, q = dh.load("ur5e"), np.ones((100, 6))
    for m in (slice(None), slice(3), 0):
        assert np.allclose(arm.forward(q[m].astype(kind)), arm.forward(q[m]), atol=1e-15)


def test_q_may_lie_anyhow_in_memory():
    arm = dh.load("ur5e")
    wide = np.random.default_rng(3).uniform(-1, 1, (6, 300))
    q = np.ascontiguousarray(wide.T)
    right = arm.forward(q)
    assert np.array_equal(arm.forward(wide.T), right)
    assert np.array_equal(arm.forward(np.repeat(q, 2, axis=0)[::2]), right)
    assert np.array_equal(arm.forward(q.reshape(3, 100, 6)), right.reshape(3, 100, 4, 4))
    q.flags.writeable = False
    assert np.array_equal(arm.forward(q), right)


def test_what_an_arm_has_worked_out_stays_its_own():
    arm = dh.load("ur5e")
    q = np.ones((100, 6))
    arm.forward(q), [arm.forward(row) for row in q]
    other = replace(arm, sign=-arm.sign)
    assert not np.allclose(other.forward(q), arm.forward(q))
    assert np.allclose(other.forward(-q), arm.forward(q), atol=1e-14)
    for same in (pickle.loads(pickle.dumps(arm)), copy.copy(arm), copy.deepcopy(arm)):
        assert same == arm and np.array_equal(same.forward(q), arm.forward(q))


def test_zero_is_written_without_a_sign():
    arm = dh.load("article-6r")
    for m in ((), (1,), (100,)):
        for question in QUESTIONS:
            answer = getattr(arm, question)(np.zeros((*m, 6)))
            assert not np.signbit(answer[answer == 0]).any()


def test_right_angles_leave_no_dust():
    chain = chain_of(dh.load("article-6r")._kinematics.plain)
    assert {abs(step.c) for step in chain.steps} == {0.0, 1.0}
    almost = dh.DHTable.standard([[0, 0, 1, 1e-12], [0, 0, 1, 0]], angle="rad")
    assert not chain_of(dh.Arm(almost)._kinematics.plain).steps[1].parallel


@pytest.mark.parametrize("size", [30.0, 1e4, 1e9])
@pytest.mark.parametrize("question", QUESTIONS)
def test_many_turns_of_parallel_joints_keep_their_digits(question, size):
    """Where angles are added up before the cosine is taken, the sum of large ones is rounded."""
    arm = dh.load("article-6r")  # joints 2, 3 and 4 are parallel
    q = np.random.default_rng(0).uniform(-size, size, (100, 6))
    right = plain(arm, question, q)
    assert np.allclose(getattr(arm, question)(q), right, rtol=0, atol=2e-14)
    alone = [getattr(arm, question)(row) for row in q[:30]]
    assert np.allclose(alone, right[:30], rtol=0, atol=2e-14)
