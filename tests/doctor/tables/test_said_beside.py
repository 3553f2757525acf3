"""What stands beside a number: its name, limits, what a program adds before it is used."""

import numpy as np
import pytest

from dhlab import recognise_table
from dhlab.doctor.tables.cells import read_cell
from tests.doctor.tables.test_forms import is_the_form

CELLS = """Modified DH
| i | alpha_{{i-1}} | a_{{i-1}} | d_i | theta_i |
|---|---|---|---|---|
| 1 | 0 | 0 | 0.1 m | {first} |
| 2 | -90° | {second} | 0 | theta2 |
"""
CRAIG = {
    "convention": "craig",
    "rows": [(0, 0.1, 0, 0), (0, 0, 0.12, -np.pi / 2)],
    "joints": "RR",
    "sign": [1, 1],
}
SERIAL = """
d_1 = 0.1;
h = 1.2;
{}
arm = SerialLink([0 d_1 0.1 pi/2; 0 0 0.3 0; 0 0 0.2 0], 'name', 'arm');
{}
"""
ARM = """
robot = rtb.DHRobot([rtb.RevoluteDH(d=0.4, alpha=np.pi/2), rtb.RevoluteDH(a=0.5)])
{}
robot.base = SE3(0, 0, 3)
"""


@pytest.mark.parametrize("first", ["theta1(-120, 120)", "theta1 (-120°, 120°)", "theta1"])
@pytest.mark.parametrize("second", ["L_uh = 0.12 m", "Lu = 0.12 m", "0.12 m"])
def test_limits_and_names_beside_a_value_are_no_part_of_it(first, second):
    found = recognise_table(CELLS.format(first=first, second=second))
    assert is_the_form(found.arm, CRAIG)


@pytest.mark.parametrize(
    "before, behind, height",
    [("d_1 = d_1 + h;", "", 1.3), ("", "d_1 = d_1 + h;", 0.1), ("", "", 0.1)],
)
def test_what_is_added_to_a_number_counts_where_the_number_is_used_below(before, behind, height):
    found = recognise_table(SERIAL.format(before, behind))
    assert found.arm.table.d[0] == pytest.approx(height)


@pytest.mark.parametrize(
    "between, height", [("robot = rtb.models.DH.Puma560()", 0), ("T = robot.fkine(q)", 3)]
)
def test_the_base_of_another_robot_under_the_same_name_is_not_the_arms(between, height):
    found = recognise_table(ARM.format(between))
    assert found.arm.base[2, 3] == pytest.approx(height)


@pytest.mark.parametrize("name", ["reverse_rotation_direction", "inverted", "flip"])
def test_a_joint_that_is_said_to_turn_the_other_way_does(name):
    found = recognise_table(f"""Standard DH, m
        [{{a: 0.1, d: 0.4, alpha: -Math.PI/2, theta: 0, {name}: true}},
         {{a: 0.3, d: 0, alpha: 0, theta: 0, {name}: false}}]""")
    assert found.arm.sign.tolist() == [-1, 1]


def test_two_numbers_behind_a_function_are_its_own():
    assert read_cell("atan2(0.3, 0.4)").value == pytest.approx(np.arctan2(0.3, 0.4))


def test_pi_may_carry_the_mark_of_a_header():
    found = recognise_table("""Standard DH, m
        float a[2] = {0.0f, 0.3f};
        float alpha[2] = {-90.0f * KIN_PI / 180.0f, 0.0f};
        float d[2] = {0.1f, 0.0f};""")
    assert found.arm.table.alpha == pytest.approx([-np.pi / 2, 0])


LENGTHS = {
    "fields of a class": """
class Arm:
    L1: float = 0.4
    L2: float = 0.3  # fore
""",
    "a list": "params = [0.4, 0.3]\nL1 = params[0]; L2 = params[1]\n",
    "a remark in brackets": "Links: L1 = 0.4, L2 = 0.3 (default in metres)\n",
}


@pytest.mark.parametrize("said", LENGTHS.values(), ids=LENGTHS)
def test_lengths_are_found_where_the_text_has_them(said):
    table = "Standard DH, m\n| theta | d | a | alpha |\n|--|--|--|--|\n"
    rows = "| q1 | 0 | L1 | 0 |\n| q2 | 0 | L2 | 0 |\n"
    found = recognise_table(f"{said}\n{table}{rows}")
    assert found.arm.table.a == pytest.approx([0.4, 0.3])


def test_a_type_of_the_language_is_no_row():
    found = recognise_table("""Standard DH, m
        export type Link = {
          a: number
          alpha: number
          d: number
        }
        export const ARM = [
          { a: 0, alpha: Math.PI / 2, d: 0.4 },
          { a: 0.3, alpha: 0, d: 0 },
        ]""")
    assert len(found.arm) == 2 and found.arm.table.d == pytest.approx([0.4, 0])


def test_zeros_that_a_robot_of_the_toolbox_is_given_are_its_links():
    found = recognise_table("""
        L(1) = Link([0 0.1 0 pi/2]);
        L(2) = Link([0 0 0.3 0]);
        rob = SerialLink(L);
        rob.offset = [0 pi/4];""")
    assert found.arm.table.theta == pytest.approx([0, np.pi / 4])
