"""Zeros and joint values that a program holds beside its rows: what is added under a name of its
own, what only says where a joint stands, and calls that may be one pose.
"""

import numpy as np
import pytest

from dhlab.doctor import recognise_table
from tests.doctor.tables.test_forms import is_the_form

HALF = np.pi / 2


def arm_with(*zeros):
    """Three joints of the texts below, with these zeros."""
    lengths = ((0.31, 0, HALF), (0, 0.42, 0), (0, 0.13, HALF))
    rows = [(zero, *row) for zero, row in zip(zeros, lengths)]
    return {"convention": "standard", "rows": rows, "joints": "RRR", "sign": [1, 1, 1]}


NAMED = """%% standard, metres
a1 = 0; a2 = 0.42; a3 = 0.13;
d1 = 0.31; d2 = 0; d3 = 0;
alpha1 = pi/2; alpha2 = 0; alpha3 = pi/2;
theta1 = 0;
theta2 = 0;
theta3 = 0;
%s
"""


@pytest.mark.parametrize(
    "shift, zeros",
    [
        ("theta2 = theta2 - pi/2;", (0, -HALF, 0)),
        ("theta1=theta1;\ntheta2=theta2+pi/2;\ntheta3=theta3-pi;", (0, HALF, -np.pi)),
        ("theta3 -= pi/2", (0, 0, -HALF)),
    ],
)
def test_an_angle_that_is_moved_on_under_its_own_name_has_a_zero(shift, zeros):
    found = recognise_table(NAMED % shift)
    assert is_the_form(found.arm, arm_with(*zeros)), str(found)


@pytest.mark.parametrize(
    "program",
    [
        "T = fk(theta1, theta2, theta3);\ntheta2 = theta2 + pi/2;\nU = fk(theta1, theta2, theta3);",
        "theta2 = theta2 + pi/2;\nT = fk(theta2);\ntheta2 = theta2 + pi/2;",
    ],
)
def test_an_angle_that_is_used_before_it_is_moved_on_is_asked_about(program):
    with pytest.raises(ValueError, match="no row has such a zero"):
        recognise_table(NAMED % program)


ROWS = """# standard, metres: theta, d, a, alpha
dh = [[0, 0.31, 0, pi/2], [0, 0, 0.42, 0], [0, 0, 0.13, pi/2]]
waist = 0
%s
"""


@pytest.mark.parametrize(
    "program", ["theta[0] += waist * M_PI / 180.0", "theta[0] = theta[0] + waist*pi/180;"]
)
def test_a_joint_value_in_degrees_that_is_added_is_no_zero(program):
    assert is_the_form(recognise_table(ROWS % program).arm, arm_with(0, 0, 0))


def test_a_right_angle_beside_such_a_conversion_is_asked_about():
    with pytest.raises(ValueError, match="no row has such a zero"):
        recognise_table(ROWS % "theta[0] += (waist - 90) * M_PI / 180.0")


@pytest.mark.parametrize("named, asked", [("0.13", False), ("0.131", True), ("1.57", True)])
def test_a_named_offset_may_be_a_length_of_the_rows_in_another_unit(named, asked):
    text = f"""# standard rows
    # i | theta | d (mm) | a (mm) | alpha (deg)
    # 1 | q1    | 310    | 0      | 90
    # 2 | q2    | 0      | 420    | 0
    # 3 | q3    | 0      | 130    | 90
    A3_ELBOW_OFFSET = {named}  # metres
    """
    if asked:
        with pytest.raises(ValueError, match="A3_ELBOW_OFFSET"):
            recognise_table(text)
    else:
        assert is_the_form(recognise_table(text).arm, arm_with(0, 0, 0))


CALLS = """
def dh(theta, d, a, alpha):
    return np.array([[cos(theta), -sin(theta)*cos(alpha), sin(theta)*sin(alpha), a*cos(theta)],
                     [sin(theta), cos(theta)*cos(alpha), -cos(theta)*sin(alpha), a*sin(theta)],
                     [0, sin(alpha), cos(alpha), d], [0, 0, 0, 1]])
A = dh(%s, 0.31, 0, pi/2)  # m
B = dh(%s, 0, 0.42, 0)
C = dh(%s, 0, 0.13, pi/2)
print(A @ B @ C)
"""


def test_calls_with_numbers_alone_that_are_printed_are_one_pose_or_zeros():
    found = recognise_table(CALLS % ("pi/2", "0", "-pi/2"))
    assert found.open == ("zero",)
    arms = [reading.arm for reading in found.readings]
    assert is_the_form(arms[0], arm_with(0, 0, 0)) and is_the_form(
        arms[1], arm_with(HALF, 0, -HALF)
    )


def test_calls_with_variables_keep_their_zeros():
    found = recognise_table(CALLS % ("q1", "q2 + pi/2", "q3"))
    assert is_the_form(found.arm, arm_with(0, HALF, 0))
