"""Programs in Craig's convention. The right pose is that of four moves written out, the wrong
programs are typed as a learner would.
"""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import dhlab as dh


def link(theta, d, a, alpha):
    """Craig, eq. 3.6, typed."""
    ct, st, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array(
        [
            [ct, -st, 0, a],
            [st * ca, ct * ca, -sa, -sa * d],
            [st * sa, ct * sa, ca, ca * d],
            [0, 0, 0, 1],
        ]
    )


def standard(theta, d, a, alpha):
    z, x = np.eye(4), np.eye(4)
    z[:3, :3], z[2, 3] = Rotation.from_euler("z", theta).as_matrix(), d
    x[:3, :3], x[0, 3] = Rotation.from_euler("x", alpha).as_matrix(), a
    return z @ x


def chain(one):
    def forward_kinematics(rows, q):
        T = np.eye(4)
        for (offset, d, a, alpha), value in zip(rows, q):
            T = T @ one(offset + value, d, a, alpha)
        return T

    return forward_kinematics


def sign_lost(theta, d, a, alpha):
    T = link(theta, d, a, alpha)
    T[1, 3] *= -1
    return T


def test_right_programs_agree():
    assert dh.diagnose_function(link, "dh_transform", convention="craig")
    assert dh.diagnose_function(chain(link), "forward_kinematics", convention="craig")
    panda = dh.load("panda")
    found = dh.diagnose_function(
        lambda q: chain(link)(panda.table.rows, q) @ panda.tool,
        "forward_kinematics",
        arm=panda,
        convention="craig",
    )
    assert found, str(found)


@pytest.mark.parametrize(
    "program, kind, mistake",
    [
        (standard, "dh_transform", "craig-rows-in-standard-matrix"),
        (chain(standard), "forward_kinematics", "craig-rows-in-standard-matrix"),
        (lambda t, d, a, al: link(t, d, a, -al), "dh_transform", "alpha-sign"),
        (chain(lambda t, d, a, al: link(t, d, a, -al)), "forward_kinematics", "alpha-sign"),
    ],
)
def test_the_mistake_is_named(program, kind, mistake):
    found = dh.diagnose_function(program, kind, convention="craig")
    assert (found.verdict, found.findings[0].mistake) == ("explained", mistake)


def test_a_craig_program_is_told_where_the_standard_one_was_asked_for():
    found = dh.diagnose_function(link, "dh_transform")
    assert found.findings[0].mistake == "standard-rows-in-craig-matrix"


def test_what_nothing_explains_is_no_mistake_by_name():
    assert not dh.diagnose_function(sign_lost, "dh_transform", convention="craig")


def test_a_convention_that_is_none_is_one_sentence():
    with pytest.raises(ValueError, match='expected the convention "standard" or "craig"'):
        dh.diagnose_function(link, "dh_transform", convention="modified")
    with pytest.raises(ValueError, match="expected an arm in the craig convention"):
        dh.diagnose_function(
            chain(link), "forward_kinematics", arm=dh.load("ur5e"), convention="craig"
        )
