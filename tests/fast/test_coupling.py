"""Coupled joints: carried through every rewriting and every file, or refused in a sentence."""

import pickle

import numpy as np
import pytest
from cases import arms, fanuc, judged_pose
from hypothesis import given, settings
from hypothesis import strategies as st

import dhlab as dh
from dhlab.geometry.equivalence import equivalent
from dhlab.geometry.zeros import with_zeros
from dhlab.grading.inside.wire import decode, encode

coupled_arms = arms(largest=6, coupled=st.just(True))
seeds = st.integers(0, 2**32 - 1)


def test_joint_angles_are_coupling_times_what_is_counted():
    arm, q = fanuc(), np.random.default_rng(0).uniform(-1, 1, 6)
    straight = dh.load("article-6r")
    own = q - np.array([0, 0, q[1], 0, 0, 0])
    assert np.allclose(arm.joint_values(q), own, atol=1e-16)
    assert np.allclose(arm.forward(q), straight.forward(own), atol=1e-15)
    assert np.allclose(arm.frames(q), straight.frames(own), atol=1e-15)
    J = straight.jacobian(own)
    J[:, 1] -= J[:, 2]
    assert np.allclose(arm.jacobian(q), J, atol=1e-15)


@given(coupled_arms, seeds)
def test_every_rewriting_keeps_the_pose(arm, seed):
    rng = np.random.default_rng(seed)
    q, offset = rng.uniform(-2, 2, (2, len(arm)))
    sign, frame = rng.choice([-1, 1], len(arm)), int(rng.integers(0, len(arm) + 1))
    right = judged_pose(arm, q)
    for other in ("standard", "craig"):
        assert np.allclose(arm.to(other).forward(q), right, atol=1e-12)
    assert np.allclose(arm.flip_x(frame).forward(q), right, atol=1e-12)
    assert np.allclose(arm.flip_z(frame).forward(q), right, atol=1e-12)
    moved = with_zeros(arm, sign, offset)
    assert np.allclose(moved.forward(q), judged_pose(arm, sign * q + offset), atol=1e-11)


def test_slide_keeps_the_coupling():
    arm = fanuc().slide(2, 0.1)
    q = np.ones(6)
    assert arm.coupling is not None and np.allclose(arm.forward(q), fanuc().forward(q), atol=1e-15)


def test_none_is_none():
    table = dh.load("ur5e").table
    assert dh.Arm(table, coupling=np.eye(6)).coupling is None
    assert dh.Arm(table, coupling=np.eye(6)) == dh.Arm(table)


def test_equality_hash_and_pickle():
    arm = fanuc()
    same = pickle.loads(pickle.dumps(arm))
    assert same == arm and hash(same) == hash(arm)
    assert np.array_equal(same.coupling, arm.coupling) and not same.coupling.flags.writeable
    assert arm != dh.Arm(arm.table, limits=arm.limits)


def test_equivalence_asks_for_the_coupling():
    arm = fanuc()
    assert equivalent(arm, arm.flip_z(2).flip_z(3).to("craig"))
    other = equivalent(arm, dh.Arm(arm.table))
    assert not other and other.reason == "coupling" and other.joint == 3


@given(coupled_arms)
@settings(max_examples=15)
@pytest.mark.parametrize("length", ["m", "mm"])
def test_a_table_file_holds_it(tmp_path_factory, length, arm):
    path = tmp_path_factory.mktemp("coupled") / "arm.yaml"
    arm.save(path, angle="deg", length=length)
    read = dh.load(path)
    assert np.allclose(read.coupling, arm.coupling, rtol=1e-14, atol=0)


def test_a_table_alone_cannot_hold_it(tmp_path):
    dh.Arm(fanuc().table, coupling=fanuc().coupling).save(tmp_path / "arm.yaml")
    with pytest.raises(ValueError, match="found coupling beside it"):
        dh.DHTable.load(tmp_path / "arm.yaml")


def test_the_units_of_a_file_hold_for_its_coupling(tmp_path):
    path = tmp_path / "screw.yaml"
    path.write_text(
        "convention: standard\nunits: {length: mm, angle: deg}\njoints:\n"
        "  - {theta: 0, d: 0, a: 0, alpha: 0}\n"
        "  - {type: prismatic, theta: 0, d: 0, a: 0, alpha: 0}\n"
        "coupling: [[1, 0], [0.5, 1]]\n"  # half a millimetre a degree: a ball screw with a spline
    )
    arm = dh.load(path)
    assert np.isclose(arm.forward([np.deg2rad(90), 0.01])[2, 3], 0.045 + 0.01)
    assert "q2 + 0.0005 q1" in str(arm)


def test_csv_and_urdf_say_that_they_cannot(tmp_path):
    with pytest.raises(ValueError, match="coupled joints; save it as"):
        dh.Arm(fanuc().table, coupling=fanuc().coupling).save(tmp_path / "arm.csv")
    with pytest.raises(ValueError, match="URDF cannot express"):
        dh.to_urdf(fanuc())


def test_protocol_and_calibration_ask_for_joint_values():
    arm, q = fanuc(), np.random.default_rng(0).uniform(-1, 1, (12, 6))
    poses = arm.forward(q)
    with pytest.raises(ValueError, match="arm.joint_values"):
        dh.calibrate_offsets(arm, q, poses)
    with pytest.raises(ValueError, match="arm.joint_values"):
        dh.doctor.protocol(arm, 6)
    bare = dh.Arm(arm.table)
    for right, numbers in ((bare, arm.joint_values(q)), (arm, q)):
        assert dh.diagnose(right, numbers, poses).verdict == "agrees"


def test_printing_shows_what_moves_a_joint():
    text = str(fanuc())
    assert "q3 - q2" in text
    assert "q3 − q2" in fanuc()._repr_html_()


def test_the_grader_carries_it():
    arm = fanuc()
    assert decode(encode(arm)) == dh.Arm(arm.table, coupling=arm.coupling)


def test_the_derivation_knows_it():
    sympy = pytest.importorskip("sympy")
    from dhlab.symbolic.derivation import product

    arm, q = fanuc(), np.random.default_rng(0).uniform(-1, 1, 6)
    T = product(arm)
    names = sorted(T.free_symbols, key=str)
    number = np.array(T.subs(dict(zip(names, q))).evalf(), dtype=float)
    assert sympy and np.allclose(number, arm.forward(q), atol=1e-12)


@pytest.mark.parametrize(
    "coupling, words",
    [
        (np.eye(2).tolist(), "6 rows"),
        (np.full((6, 6), np.nan), "finite"),
        (np.ones((6, 6)), "inverted"),
        ("yes", "6 rows"),
        ([[1, 2], [3]], "6 rows"),
    ],
)
def test_a_wrong_coupling_is_one_plain_sentence(coupling, words):
    with pytest.raises(ValueError, match=words) as error:
        dh.Arm(dh.load("ur5e").table, coupling=coupling)
    assert "expected" in str(error.value) and "\n" not in str(error.value)


def test_the_way_back_knows_it():
    arm, q = fanuc(), np.array([0.3, -0.7, 0.9, 0.4, 0.8, -0.2])
    answer = arm.solve(arm.forward(q))
    assert answer and min(np.abs(found - q).max() for found in answer) < 1e-7


def test_generated_programs_know_it(tmp_path):
    arm, q = fanuc(), np.array([0.3, -0.7, 0.9, 0.4, 0.8, -0.2])
    text = dh.generate(arm, "python", name="arm")
    scope = {"__name__": "generated"}
    exec(text, scope)
    assert np.allclose(np.reshape(scope["arm_forward"](q), (-1, 4))[:3], arm.forward(q)[:3])
    assert np.allclose(np.reshape(scope["arm_jacobian"](q), (6, 6)), arm.jacobian(q))
    assert "coupling" in text
