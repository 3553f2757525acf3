"""What a table does not say of its rows and its letters, and where the text says it elsewhere."""

import numpy as np
import pytest

from dhlab import recognise_table

CRAIG = "modified DH\nalpha | a | theta | d\n{}"
FOUR = "0 | 0 | 0 | 0.33\n-90 | 0 | 0 | 0\n0 | 0.4 | 0 | 0\n90 | 0 | 0 | 0.1\n"


def test_a_last_row_on_the_axis_of_the_joint_before_it_may_be_a_flange():
    found = recognise_table(CRAIG.format(FOUR + "0 | 0 | 0 | 0.2\n"))
    assert found.open == ("row",)
    assert [len(reading.arm) for reading in found.readings] == [4, 5]
    flange = found.readings[0].arm
    assert np.allclose(flange.forward(np.zeros(4))[:3, 3], found.arm.frames(np.zeros(4))[-1][:3, 3]
                       + 0.2 * found.arm.frames(np.zeros(4))[-1][:3, 2])  # fmt: skip


def test_rows_whose_axes_differ_are_joints():
    assert [len(r.arm) for r in recognise_table(CRAIG.format(FOUR)).readings] == [4]


def test_a_text_that_says_how_many_joints_there_are_is_not_asked():
    text = CRAIG.format(FOUR + "0 | 0 | 0 | 0.2\n") + "\nof a 5-DOF arm"
    assert [len(reading.arm) for reading in recognise_table(text).readings] == [5]


def test_one_variable_among_numbers_leaves_the_other_rows_their_joints():
    rows = "0 | 0 | 0 | 0.33\n-90 | 0 | q2 - 90 | 0\n0 | 0.4 | 0 | 0\n90 | 0.1 | 0 | 0\n"
    found = recognise_table(CRAIG.format(rows))
    assert found.open == ("row",) and len(found.arm) == 4


def test_a_table_of_names_and_numbers_gives_the_letters_their_values():
    rows = "| q1 | d1 | 0 | 90 |\n| q2 | 0 | a2 | 0 |\n"
    text = (
        "| what | symbol | value | unit |\n|--|--|--|--|\n| base | d₁ | 89.2 | mm |\n"
        "| arm | $a_2$ | 0.425 | m |\n\nstandard DH\n| theta | d | a | alpha |\n|--|--|--|--|\n"
    )
    arm = recognise_table(text + rows).arm
    assert np.allclose([arm.table.d[0], arm.table.a[1]], [0.0892, 0.425])


def test_a_value_that_is_overwritten_before_it_is_used_does_not_count():
    rows = "# standard: theta, d, a, alpha\ndh = [[q1, L1, 0, 90], [q2, 0, 0.3, 0]]\n"
    assert recognise_table(f"L1 = 0.1\nL1 = 0.2\n{rows}").arm.table.d[0] == 0.2
    with pytest.raises(ValueError, match="which one counts"):
        recognise_table(f"if small:\n    L1 = 0.1\nelse:\n    L1 = 0.2\n{rows}")


def test_capital_and_small_letters_are_two_parameters():
    text = "{A0: 0, a0: 0, d1: 0.75, A1: -pi/2, a1: 0.35, d2: 0, A2: 0, a2: 1.25, d3: 0}"
    arm = recognise_table(text).arm
    assert arm.table.convention == "craig"
    assert np.allclose(arm.table.rows[:, 1:], [[0.75, 0, 0], [0, 0.35, -np.pi / 2], [0, 1.25, 0]])


def test_the_last_tool_that_a_program_sets_counts():
    links = "R = SerialLink([0 0.3 0 pi/2; 0 0 0.4 0])\n"
    product = "R.tool = transl(0.08, 0, 0) * trotz(-pi/2) * transl(0.04, 0, 0);\n"
    assert "not in the rows" in str(recognise_table(links + product))
    found = recognise_table(links + product + "R.tool = eye(4)\n")
    assert "tool" not in str(found) and np.allclose(found.arm.tool, np.eye(4))


def test_the_field_of_a_row_that_is_added_is_its_own_column():
    text = (
        "// craig, [theta_offset, d, a, alpha]\nrows = {{0.0, 0.3, 0, 0}, {0.0, 0, 0.1, 1.5708}};\n"
        "double theta = q + dh.theta_offset;\n"
    )
    assert len(recognise_table(text).arm) == 2


def test_a_range_of_indices_gives_every_row_its_number():
    text = (
        "% standard\nDH.alpha(1) = pi/2; DH.alpha(2) = 0; DH.alpha(3) = 0;\nDH.a(1:3) = 0.2;\n"
        "DH.d(1) = 0.1; DH.d(2:3) = 0;\nDH.theta(1) = 0; DH.theta(2:3) = pi;\n"
    )
    table = recognise_table(text).arm.table
    assert table.a.tolist() == [0.2] * 3 and table.theta.tolist() == [0, np.pi, np.pi]


def test_the_last_row_of_a_link_matrix_is_no_table():
    matrix = (
        "T = [cos(t) -sin(t)*cos(b) sin(t)*sin(b) a*cos(t);\n"
        "     sin(t) cos(t)*cos(b) -cos(t)*sin(b) a*sin(t);\n"
        "     0 sin(b) cos(b) d;\n     0 0 0 1]\n"
    )
    for text in (matrix, matrix.replace("0 0 0 1]", "zeros(1, 3) 1]")):
        with pytest.raises(ValueError, match="recognise_table: expected"):
            recognise_table("% standard DH, a alpha d theta\n" + text)


def test_a_list_of_types_in_small_letters_says_which_joint_slides():
    text = (
        "% standard\nalpha = [0 0 0 0];\na = [0.2 0.45 0.72 0];\nd = [0.21 0 0 0];\n"
        "type = ['r','r','r','p'];\n"
    )
    assert recognise_table(text).arm.table.joints == "RRRP"


def test_a_last_variable_that_is_put_to_0_is_no_joint():
    text = "theta1 = q1; theta2 = q2 - pi/2; theta3 = q3\ns = {alpha0: 0, a0: 0, d1: 0.75,\n"
    text += " alpha1: -pi/2, a1: 0.35, d2: 0,\n alpha2: 0, a2: 0, d3: 0.3, q3: 0}\n"
    found = recognise_table(text)
    assert len(found.readings) == 1 and len(found.arm) == 2
    assert np.allclose(found.arm.tool[:3, 3], [0, 0, 0.3])


def test_numbers_of_a_second_list_are_the_values_of_letters():
    text = (
        "% Craig, m\nsyms th1 th2 th3 th4 th5 d1 d2 d3 d4 d5 a1 a2 a3 a4 a5\n"
        "DH_al = [0, pi/2, 0];\nDH_a = [0, 0, 0.4];\nDH_d = [d1, 0, d3];\n"
        "DH_th = [th1, th2, th3];\nVER_al = [0, pi/2, 0];\nVER_a = [0, 0, 0.4];\n"
        "VER_d = [0.34, 0, 0.1];\nVER_th = [0, 0, 0];\n"
    )
    assert recognise_table(text).arm.table.d.tolist() == [0.34, 0, 0.1]
    with pytest.raises(ValueError, match="d1, d3 have no value"):
        recognise_table(text.replace("VER_d = [0.34, 0,", "VER_d = [0.34, 0.2,"))
    with pytest.raises(ValueError, match="joint 5"):
        recognise_table(text.replace("d1 d2 d3 d4 d5 a1 a2 a3 a4 a5", "d1 d3"))


def test_numbers_put_into_a_matrix_of_names_that_say_nothing_are_no_rows():
    text = (
        "{b0: 0, a0: 0, d1: 0.75, b1: -pi/2, a1: 0.35, d2: 0, q2: q2 - pi/2, b2: 0, a2: 1.25,"
        " d3: 0.1, q3: 0}\n"
    )
    put = "".join(
        f"T{k}_{k + 1} = T.evalf(subs={{ap: b{k}, a: a{k}, th: 0, d: d1}})\n" for k in range(3)
    )
    found = recognise_table(text + put)
    assert found.arm.table.d.tolist() == [0.75, 0] and found.arm.table.theta[1] == -np.pi / 2
    assert found.arm.table.alpha[1] == -np.pi / 2 and len(found.readings) == 1


def test_a_cell_that_speaks_of_two_joints_is_asked_about():
    text = (
        "| i | alpha | a | d | theta |\n|-|-|-|-|-|\n"
        "| 1 | 0 | 0 | 0.1 | theta_1* (Prismatic + Revolute Base) |\n"
        "| 2 | 0 | 0.3 | 0 | theta_2 |\n"
    )
    with pytest.raises(ValueError, match=r"one joint in a row.*which of them moves first\?"):
        recognise_table(text)


def test_zeros_of_a_list_that_a_function_turns_into_radians_are_added_in_segments():
    text = (
        "double d2r(double v) {\n return v / 180 * M_PI;\n}\n"
        "double off[2] = {d2r(-169), d2r(65)};\n"
        "c.addSegment(Segment(Joint(Joint::RotZ), Frame::DH(0.3, M_PI_2, 0.1, off[0] + M_PI)));\n"
        "c.addSegment(Segment(Joint(Joint::RotZ), Frame::DH(0.2, 0, 0, off[1] - M_PI_2)));\n"
    )
    arm = recognise_table(text).arm
    first, second = np.deg2rad([11, -25])
    q = np.array([0.4, -0.7])
    angle = q[0] + first
    x = 0.3 + 0.2 * np.cos(q[1] + second)  # the second link moves in the upright plane of the first
    z = 0.1 + 0.2 * np.sin(q[1] + second)
    assert np.allclose(arm.forward(q)[:3, 3], [x * np.cos(angle), x * np.sin(angle), z])


def test_a_number_that_counts_the_rows_in_each_line_is_put_into_it():
    rows = "jj = {0}; joint(jj) = link({1}, {2}, pi/2, theta(jj) + pi/2);\n"
    text = "% standard, m: a, d, alpha, theta\n"
    made = text + rows.format(1, 0.2, 0.1) + rows.format(2, 0.3, 0)
    table = recognise_table(made).arm.table
    assert table.a.tolist() == [0.2, 0.3] and np.allclose(table.theta, np.pi / 2)
    lettered = text + rows.format(1, 0.2, "-L(1)") + rows.format(2, 0.3, "L(2)")
    with pytest.raises(ValueError, match=r"L\[1\], L\[2\] have no value"):
        recognise_table(lettered)
    answered = recognise_table(lettered, values={"L[1]": 0.1, "L[2]": 0.4})
    assert answered.arm.table.d.tolist() == [-0.1, 0.4]


def test_a_function_of_one_angle_is_a_row_with_a_joint_whatever_the_angle_is_called():
    text = (
        "// standard: a, alpha, d, theta, m\n"
        "inline Matrix4d T01(const double & rad) { return dhT(0.1, M_PI / 2, 0.2, rad); }\n"
        "inline Matrix4d T12(double rad) { return dhT(0.3, 0.0, 0.0, rad - M_PI / 2); }\n"
        "inline Matrix4d T2e() { return dhT(0.4, 0.0, 0.0, 0.0); }\n"
    )
    arms = [reading.arm for reading in recognise_table(text).readings]
    assert len(arms[0]) == 2 and np.allclose(arms[0].table.a, [0.1, 0.3])
    assert np.allclose(arms[0].tool[:3, 3], [0.4, 0, 0])


def test_a_call_that_cannot_be_read_among_others_is_asked_about():
    rows = "A = dh(q1, 0.2, 0, pi/2)\nB = dh(q2, 0, 0.3, 0)\nC = dh(q3, height(7, 2), 0.1, 0)\n"
    with pytest.raises(ValueError, match="line 4: expected 4 numbers in dh"):
        recognise_table(f"# standard: theta, d, a, alpha\n{rows}")


UR_LIKE = """theta d a alpha
0 89 0 90
0 0 -425 0
0 0 -392 0
0 109 0 90
0 95 0 -90
0 82 0 0
"""


def test_rows_of_the_other_convention_are_no_sign_of_a_row_without_a_joint():
    found = recognise_table(UR_LIKE, length="mm", angle="deg")
    assert found.open == ("convention",) and [len(one.arm) for one in found.readings] == [6, 6]
    told = recognise_table(UR_LIKE, length="mm", angle="deg", convention="craig")
    assert told.open == ("row",) and {len(one.arm) for one in told.readings} == {5, 6}


def test_a_flange_behind_rows_of_craig_is_still_asked_about():
    rows = "theta d a alpha\n0 333 0 0\n0 0 0 -90\n0 316 0 90\n0 0 82 90\n0 107 0 0\n"
    found = recognise_table(rows, length="mm", angle="deg")
    assert set(found.open) == {"convention", "row"}
    assert ("craig", 4) in [(one.arm.table.convention, len(one.arm)) for one in found.readings]
