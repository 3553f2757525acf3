"""What a pasted text says of its rows elsewhere than in them: zeros in lists, definitions in words,
a second arm, units that make no arm. It decides, or is asked about.
"""

import numpy as np
import pytest

from dhlab import recognise_table

ROWS = "[[0, 0.3, 0, pi/2], [0, 0, 0.25, 0]]"
STANDARD = np.array([[0, 0.3, 0, np.pi / 2], [0, 0, 0.25, 0]])
SECOND = STANDARD + [[0, 0, 0, 0], [np.pi / 2, 0, 0, 0]]
HEAD = "| i | twist angle | link length | link offset | joint angle |\n"
CRAIG = "| 1 | 0 | 0 | 0.3 | q1 |\n| 2 | pi/2 | 0.25 | 0 | q2 |\n"


def read(text):
    found = recognise_table(text)
    assert len(found.readings) == 1, found
    return found.arm.table


@pytest.mark.parametrize(
    "beside",
    [
        f"# standard, m: theta, d, a, alpha\ndh = {ROWS}\njoint_offset = [0, pi/2]",
        f"# standard, m: theta, d, a, alpha\ndh = {ROWS}\nq_offset = np.array([0, pi/2])",
        "def A(theta, d, a, alpha): pass  # standard, m\nA(q1, 0.3, 0, pi/2) @ A(q2, 0, 0.25, 0)"
        "\njoint_offsets = [0, pi/2]",
        "# standard, m\nd = [0.3, 0]\na = [0, 0.25]\nalpha = [pi/2, 0]\noffset = [0, pi/2]\n"
        "for i in range(2):\n    L.append(RevoluteDH(d=d[i], a=a[i], alpha=alpha[i],"
        " offset=offset[i]))",
    ],
)
def test_zeros_in_a_list_beside_the_rows_belong_to_them(beside):
    np.testing.assert_allclose(read(beside).rows, SECOND, atol=1e-12)


def test_zeros_belong_to_rows_whose_columns_nothing_names():
    found = recognise_table(f"dh = {ROWS}\njoint_offsets = [0, pi/2]")
    assert any(
        reading.arm.table.convention == "standard"
        and np.allclose(reading.arm.table.rows, SECOND, atol=1e-12)
        for reading in found.readings
    )


@pytest.mark.parametrize(
    "said, convention",
    [
        ("alpha: angle from Z(i-1) to Z(i) about X(i-1)", "craig"),
        ("a_i is the distance from z_i to z_{i+1} measured along x_i", "craig"),
        ("a_i is the distance from z_{i-1} to z_i along x_i", "standard"),
        ("twist: from z_{i-1} to z_i, around x_i", "standard"),
    ],
)
def test_definitions_in_words_say_the_convention(said, convention):
    assert read(f"{said}\n{HEAD}{CRAIG}").convention == convention


@pytest.mark.parametrize(
    "text",
    [
        "# standard, m\ndh = {'d1': 0.3, 'a2': 0.25}\n"
        "L = [RevoluteDH(d=dh['d1'], alpha=pi/2), RevoluteDH(a=dh['a2'])]",
        "% standard, m\nd = [0.3, 0]';\na = [0, 0.25]';\nalpha = [90, 0]'/180*pi;",
        f"+# standard, m: theta, d, a, alpha\n+dh = {ROWS}\n-dh = [[0, 0, 0, 0], [0, 0, 0, 0]]\n"
        "+# and more\n+x = 1",
        f"# 标准 m 绕z轴转角θ 沿z轴距离d 沿x轴长度a 绕x轴扭角α\ndh = {ROWS}",
        "# standard, m\ndef dh(theta: float, d: float, a: float, alpha: float): ...\n"
        "rows = [{'a': 0, 'alpha': pi/2, 'd': 0.3, 'theta': 0},"
        " {'a': 0.25, 'alpha': 0, 'd': 0, 'theta': 0}]",
        "L(1) = Link([1 2 3 4], 'standard');\nL(1) = Link([0 0.3 0 pi/2], 'standard');\n"
        "L(2) = Link([0 0 0.25 0], 'standard');",
    ],
)
def test_the_same_arm_is_read_however_its_program_says_it(text):
    np.testing.assert_allclose(read(text).rows, STANDARD, atol=1e-12)


@pytest.mark.parametrize(
    "text",
    [
        "left = [RevoluteDH(d=0.3, alpha=pi/2), RevoluteDH(a=0.25)]\n"
        "right = [RevoluteDH(d=0.3, alpha=-pi/2), RevoluteDH(a=0.25)]",
        "L(1) = Link([0 0.3 0 pi/2]); L(2) = Link([0 0 0.25 0]);\n"
        "L(1) = Link([0 0.4 0 pi/2]); L(2) = Link([0 0 0.25 0]);",
        "my_a = [0, 0.25]\nmy_d = [0.3, 0]\nmy_alpha = [pi/2, 0]\n"
        "other_a = [0, 0.35]\nother_d = [0.4, 0]\nother_alpha = [pi/2, 0]",
        f"| i | θ | d | a | α |\n|---|---|---|---|---|\n| 1 | q1 | 0.4 | 0 | 90 |\n"
        f"| 2 | q2 | 0 | 0.25 | 0 |\n\nin the program:\n```\ndh = {ROWS}\n```",
    ],
)
def test_two_arms_in_one_text_are_asked_about(text):
    with pytest.raises(ValueError, match=r"found .*which one is meant\?"):
        recognise_table(text)


def test_an_order_that_makes_lengths_of_angles_is_not_taken():
    found = recognise_table(
        "def dh(a, d, alpha, theta): pass  # standard, m\n"
        "rows = [[0, -pi/2, 0.3, 0], [0.25, pi/2, 0, 0], [0, 0, 0.2, -pi/4]]"
    )
    assert "order" in found.open
    assert all(dict(one.choices)["order"][1] in ("alpha", "theta") for one in found.readings)


@pytest.mark.parametrize(
    "said, numbers, units",
    [
        ("cm", (0.2848, 0.4208), ["metres", "centimetres"]),
        ("centímetros", (17.5, 11.6), ["centimetres"]),
        ("metres", (284.8, 420.8), ["millimetres", "metres"]),
        ("mm", (284.8, 420.8), ["millimetres"]),
    ],
)
def test_a_unit_in_which_lengths_make_no_arm_is_doubted(said, numbers, units):
    first, second = numbers
    found = recognise_table(
        f"standard, all lengths in {said}\ntheta d a alpha\nq1 {first} 0 90\nq2 0 {second} 0\n"
    )
    assert [one.words.split("; ")[-1].split(",")[0] for one in found.readings] == units


BY_CALL = (
    "# Craig version of the parameters\n# d, a, alpha, theta\n"
    "dh = np.array([[0.1, 0, pi/2, 0], [0, 0.4, 0, 0], [0.05, -0.3, 0, 0]])\nrobot = {}\n"
)


@pytest.mark.parametrize(
    "call",
    [
        'RobotSerial(dh, dh_type="normal")',
        'Arm(dh, convention="standard")',
        "Arm(dh, modified=False)",
        "Robot(dh, DHType.STANDARD)",
        "make_arm(table=dh, dh_convention=Convention::Standard)",
    ],
)
def test_the_call_that_receives_a_table_says_more_than_a_comment(call):
    found = recognise_table(BY_CALL.format(call))
    assert len(found.readings) == 1 and found.arm.table.convention == "standard"


MATRICES = """a = [0, 0.4, 0]; d = [0.1, 0, 0.2]; alpha = [pi/2, 0, 0]
R = [[cos(t[i]), -sin(t[i]), 0, 0], [sin(t[i]), cos(t[i]), 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
D = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, d[i]], [0, 0, 0, 1]]
A = [[1, 0, 0, a[i]], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
X = [[1, 0, 0, 0], [0, cos(alpha[i]), -sin(alpha[i]), 0], [0, sin(alpha[i]), cos(alpha[i]), 0],
     [0, 0, 0, 1]]
"""


@pytest.mark.parametrize(
    "product, convention",
    [
        ("T = R @ D @ A @ X", "standard"),
        ("L.append(R)\nT = L[i].dot(D).dot(A).dot(X)", "standard"),
        ("u = np.dot(X, A)\nv = np.dot(u, R)\nT = np.dot(v, D)", "craig"),
    ],
)
def test_a_product_of_the_texts_own_matrices_says_the_convention(product, convention):
    found = recognise_table(MATRICES + product)
    assert len(found.readings) == 1 and found.arm.table.convention == convention


@pytest.mark.parametrize(
    "theta",
    [
        "[q1*pi/180, q2*pi/180 + pi/2, -q3*pi/180]",
        "[float(a1)*math.pi/180, float(a2)*math.pi/180 + math.pi/2, -float(a3)*math.pi/180]",
        "(a1*d2r, a2*d2r + pi/2, -a3/57.29578)",
    ],
)
def test_joint_values_in_degrees_are_joints(theta):
    lists = "a = [0, 0.4, 0]\nd = [0.1, 0, 0.2]\nalpha = [pi/2, 0, 0]\n# standard\ntheta = "
    assert recognise_table(lists + theta).arm.table.theta == pytest.approx([0, np.pi / 2, 0])


FACTORS = "standard DH: DH(theta, d, a, alpha)\n{}DH(q1, 0.3, 0, -90){}.DH(q2+90, 0, -0.25, 0){}"


@pytest.mark.parametrize(
    "factors, base, tool",
    [
        (("", "", ".Rz(-90).Tx(0.1)"), [0, 0, 0], [0, -0.1, 0]),
        (("Tz(0.5).Rz(90).", "", ""), [0, 0, 0.5], [0, 0, 0]),
        (("Tz(0.5).", "", ".Rz(-90)"), [0, 0, 0.5], [0, 0, 0]),
    ],
)
def test_moves_at_the_ends_of_a_product_are_base_and_tool(factors, base, tool):
    arm = recognise_table(FACTORS.format(*factors)).arm
    assert len(arm) == 2
    assert arm.base[:3, 3] == pytest.approx(base) and arm.tool[:3, 3] == pytest.approx(tool)


@pytest.mark.parametrize(
    "text, said",
    [
        (FACTORS.format("", ".Rz(90)", ""), "between two calls of DH"),
        ("- 1 [90, 0, 0.1, th1]\n- 2 [0, 0.4, 0, th2]\n- 3 [th3, 0.3, 0, 0]", "row 3.*'th3'"),
        (
            "| alpha | a | d | theta |\n|--|--|--|--|\n|90|0|0.1|q1|\n|0|0.4|0|q2|\n|q3|0.3|0|0|\n",
            "row 3.*in column alpha",
        ),
        ("[[q1, 0.1, 0, 90], [q2, 0, 0.4, 0], [0, 0, 0.1, q3]]", "row 3.*'q3' in column number 4"),
    ],
)
def test_what_belongs_to_no_row_is_asked_about(text, said):
    with pytest.raises(ValueError, match=said):
        recognise_table(text)
