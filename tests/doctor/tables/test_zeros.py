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


SLIDES = '''"""An arm of two turning joints and one that slides, in metres; modified rows.

  theta1: -90 to 90 degrees
  {name}: -0.05 to 0.0 m
"""
def forward(theta1, theta2, {name}):
    """{name}: {told} m, the stroke"""
    rows = [  # theta, d, a, alpha
        (theta1, 0.31, 0, 0),
        (theta2, 0, 0.42, 0),
        (0, {name}, 0.13, 0),
        (0, -0.02, 0, 0),
    ]
'''


@pytest.mark.parametrize("name", ["s3", "d3"])
def test_a_range_in_the_words_about_a_parameter_is_no_value_of_it(name):
    found = recognise_table(SLIDES.format(name=name, told="-0.05 to 0"))
    right = {
        "convention": "craig",
        "rows": [(0, 0.31, 0, 0), (0, 0, 0.42, 0), (0, 0, 0.13, 0), (0, -0.02, 0, 0)],
        "joints": "RRPF",
        "sign": [1, 1, 1, 1],
    }
    assert is_the_form(found.readings[0].arm, right), str(found)


FOUR = """# standard, metres: theta, d, a, alpha
dh = [[q1, 0.31, 0, pi/2], [q2, 0, 0.42, 0], [q3, 0, 0.13, 0], [q4, 0, 0.06, 0]]
%s
"""
WRIST = {
    "convention": "standard",
    "rows": [(0, 0.31, 0, HALF), (0, 0, 0.42, 0), (0, 0, 0.13, 0), (0, 0, 0.06, 0)],
    "joints": "RRRR",
    "sign": [1, 1, 1, 1],
}


@pytest.mark.parametrize(
    "point",
    [
        "tip_offset = np.array([0.001, 0.02, 0.07, 1.0])\nend = T @ tip_offset",
        "pen_offset = [0.001, 0.02, 0.07, 1]\nend = np.dot(T, pen_offset)",
        "gripper_offset = [0.01, 0, 0.07, 0]",
    ],
)
def test_a_place_at_the_end_of_the_arm_is_no_list_of_zeros(point):
    assert is_the_form(recognise_table(FOUR % point).arm, WRIST)


def test_a_list_of_quarter_turns_stays_a_list_of_zeros():
    found = recognise_table(FOUR % "joint_offset = [0, -pi/2, 0, 0]")
    turned = {
        **WRIST,
        "rows": [(0 if k != 1 else -HALF, *row[1:]) for k, row in enumerate(WRIST["rows"])],
    }
    assert is_the_form(found.arm, turned)


OUTSIDE = """
Matrix link(double theta, double d, double a, double alpha) {
  double t00 = cos(theta), t01 = -sin(theta) * cos(alpha);
  double t02 = sin(theta) * sin(alpha), t03 = a * cos(theta);
  double t10 = sin(theta), t11 = cos(theta) * cos(alpha);
  double t12 = -cos(theta) * sin(alpha), t13 = a * sin(theta);
  double t20 = 0, t21 = sin(alpha), t22 = cos(alpha), t23 = d;
  return {t00, t01, t02, t03, t10, t11, t12, t13, t20, t21, t22, t23, 0, 0, 0, 1};
}
// metres
double dh[4][4] = {{0, 0.2, 0, M_PI}, {0, 0.31, 0, M_PI/2}, {0, 0, 0.42, 0}, {0, 0, 0.13, M_PI/2}};
%s
for (int i = 0; i < 3; i++)
  T = T * link(dh[i + 1][0] + q[i], dh[i + 1][1], dh[i + 1][2], dh[i + 1][3]);
"""


def test_a_row_that_is_taken_outside_of_the_loop_over_the_joints_has_none():
    found = recognise_table(OUTSIDE % "Matrix T = link(dh[0][0], dh[0][1], dh[0][2], dh[0][3]);")
    rows = [(0, 0.2, 0, np.pi), *arm_with(0, 0, 0)["rows"]]
    right = {**arm_with(0, 0, 0), "rows": rows, "joints": "FRRR", "sign": [1] * 4}
    assert len(found.readings) == 1 and is_the_form(found.arm, right), str(found)


GIVEN = """# metres
{0}1 = 90
{0}2 = -90
{0}3 = 40
A = dh({0}1, 0.31, 0, 90)
B = dh({0}2, 0, 0.42, 0)
C = dh({0}3, 0, 0.13, 90)
T = A @ B @ C
"""
HEAD = CALLS.partition("A = ")[0].replace(
    "return", "theta, alpha = radians(theta), radians(alpha)\n    return"
)


@pytest.mark.parametrize("name", ["theta", "teta"])
def test_numbers_that_calls_take_by_the_name_of_an_angle_are_one_pose_or_zeros(name):
    found = recognise_table(HEAD + GIVEN.format(name))
    assert found.open == ("zero",)
    pose, zeros = (reading.arm for reading in found.readings)
    assert is_the_form(pose, arm_with(0, 0, 0))
    assert is_the_form(zeros, arm_with(*np.deg2rad([90, -90, 40])))


def test_numbers_that_calls_take_by_the_name_of_a_joint_value_are_a_pose():
    assert is_the_form(recognise_table(HEAD + GIVEN.format("q")).arm, arm_with(0, 0, 0))
