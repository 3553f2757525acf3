"""What the rows of a pasted text mean: which have no joint, what theta's numbers are, in which unit
the lengths stand. Read as the text says or asked about, never otherwise.
"""

import numpy as np
import pytest

from dhlab import recognise_table

HEAD = "Standard DH (m)\n| i | θ | d | a | α |\n|---|---|---|---|---|\n"
ROWS = "| 1 | {0} | 0.3 | 0 | 90° |\n| 2 | {1} | 0 | 0.25 | 0 |\n"
LAST = "| {0} | {1} | 0 | 0.1 | 0 |\n"
PLAIN = HEAD + ROWS.format("0", "0")
MOVING = HEAD + ROWS.format("q1", "q2")


def lengths(arm):
    return len(arm), round(float(arm.tool[0, 3]), 6)


@pytest.mark.parametrize(
    "text",
    [
        MOVING + LAST.format("3", "0"),
        MOVING + LAST.format("3", "fixed"),
        PLAIN + LAST.format("T", "0"),
        PLAIN + LAST.format("2→E", "0"),
        PLAIN + LAST.format("3 (fixed)", "0"),
        "links = [ # standard, m\n dict(theta=0, d=0.3, a=0, alpha=pi/2),\n"
        " dict(theta=0, d=0, a=0.25, alpha=0),\n dict(theta=0, d=0, a=0.1, alpha=0, fixed=True)]",
        "joint1: {theta: 0, d: 0.3, a: 0, alpha: 1.5708}\n"
        "joint2: {theta: 0, d: 0, a: 0.25, alpha: 0}\ntool: {theta: 0, d: 0, a: 0.1, alpha: 0}\n"
        "convention: standard\n",
        "# standard: theta, d, a, alpha\nDH = {{0, 0.3, 0, pi/2}, {0, 0, 0.25, 0}, {0, 0, 0.1, 0}};"
        "\nt = {Kind::Revolute, Kind::Revolute, Kind::Static};",
        "L(1) = Link('d', 0.3, 'a', 0, 'alpha', pi/2);\nL(2) = Link('d', 0, 'a', 0.25, 'alpha', 0);"
        "\nrobot = SerialLink(L);\nrobot.tool = transl(0.1, 0, 0);",
        "stdDH\n| j | theta | d | a | alpha |\n| 1 | q1 | 0.3 | 0 | 1.5708 |\n"
        "| 2 | q2 | 0 | 0.25 | 0 |\ntool:    t = (0.1, 0, 0), RPY/xyz = (0, 0, 0) deg\n",
        "standard DH: dh(theta, d, a, alpha)\ndh(q1, 0.3, 0, 90).dh(q2, 0, 0.25, 0).Tx(0.1)",
    ],
)
def test_a_row_that_the_text_says_has_no_joint_is_the_tool(text):
    found = recognise_table(text)
    assert len(found.readings) == 1 and lengths(found.arm) == (2, 0.1), found


@pytest.mark.parametrize(
    "text",
    [
        "A 2-DOF arm.\n" + PLAIN + LAST.format("3", "0"),
        PLAIN + LAST.format("gripper", "0"),
        "[ # standard, m\n{'name': 'base', 'theta': 0, 'd': 0.3, 'a': 0, 'alpha': pi/2},\n"
        "{'name': 'elbow', 'theta': 0, 'd': 0, 'a': 0.25, 'alpha': 0},\n"
        "{'name': 'gripper', 'theta': 0, 'd': 0, 'a': 0.1, 'alpha': 0}]",
    ],
)
def test_a_row_that_may_have_no_joint_is_asked_about(text):
    found = recognise_table(text)
    assert found.open == ("row",)
    assert {lengths(one.arm) for one in found.readings} >= {(2, 0.1), (3, 0.0)}


def test_a_row_of_numbers_in_a_scara_may_slide():
    text = MOVING + "| 3 | 0 | 0.2 | 0 | 0 |\n| 4 | q4 | 0 | 0 | 0 |\n"
    found = recognise_table("A SCARA arm. " + text)
    assert found.arm.table.joints == "RRPR" and found.open == ("row",)


COUNTED_BEFORE = "Standard DH (m)\n| i | θ | d_{i-1} | a | α |\n|---|---|---|---|---|\n"


@pytest.mark.parametrize(
    "rows, lengths",
    [
        ("| 1 | q1 | 0.3 | 0 | 90° |\n| 2 | q2 | 0.1 | 0.25 | 0 |\n", [(0.3, 0.1), (0.4, 0)]),
        ("| 1 | q1 | 0 | 0 | 90° |\n| 2 | q2 | 0.1 | 0.25 | 0 |\n", [(0, 0.1), (0.1, 0)]),
        ("| 1 | q1 | 0.3 | 0 | 90° |\n| 2 | q2 | 0 | 0.25 | 0 |\n", [(0.3, 0)]),
    ],
)
def test_d_of_the_link_before_is_that_of_its_row_or_of_the_row_above(rows, lengths):
    found = recognise_table(COUNTED_BEFORE + rows)
    assert [tuple(one.arm.table.d.round(9)) for one in found.readings] == lengths
    assert found.open == (("index",) if len(lengths) > 1 else ())


def test_d_is_that_of_its_row_where_the_text_defines_it_so():
    text = COUNTED_BEFORE + "| 1 | q1 | 0.3 | 0 | 90° |\n| 2 | q2 | 0.1 | 0.25 | 0 |\n"
    found = recognise_table(text + "\nd_i: distance from x_{i-1} to x_i along z_{i-1}\n")
    assert tuple(found.arm.table.d) == (0.3, 0.1) and "own row" in " ".join(found.notes)


@pytest.mark.parametrize(
    "text, said",
    [
        (HEAD + ROWS.format("q1", "q1"), "q1 in 2 rows"),
        (HEAD + ROWS.format("q2", "q1"), "found q2, q1"),
        (PLAIN.replace("| 1 |", "| 3 |"), "found 3, 2"),
        (COUNTED_BEFORE + "| 1 | q1 | 0 | 0 | 90° |\n| 2 | 0 | L9 | 0 | 0 |\n", "to its own row"),
        (
            "# dh(theta, d, a, alpha)\ndh(q1, 1, 0, 90) @ dh(q2, 0, 1, 0) @ hand",
            "goes on with hand",
        ),
        (MOVING + "joint 2: -\n", "which joint is turned"),
        (
            "L1 = RevoluteDH(d=0.1, a=0.2)\nL2 = RevoluteDH(a=0.3,\n",
            "line 2: expected a whole link",
        ),
    ],
)
def test_rows_out_of_order_or_cut_off_are_refused(text, said):
    with pytest.raises(ValueError, match=said):
        recognise_table(text)


@pytest.mark.parametrize(
    "text, first",
    [
        (HEAD + ROWS.format("30°", "45°"), "zeros"),
        ("at q = [0.3, -0.5]:\n" + HEAD + ROWS.format("0.3 rad", "-0.5 rad"), "pose"),
    ],
)
def test_odd_angles_may_be_zeros_or_one_pose(text, first):
    found = recognise_table(text)
    assert found.open == ("zero",) and dict(found.readings[0].choices)["zero"] == first
    assert any((one.arm.table.theta == 0).all() for one in found.readings)


@pytest.mark.parametrize(
    "sizes, units",
    [
        ((0.75, 1.25, 1.5), {"m", "in"}),
        ((0.3, 1.25, 1.5), {"m"}),
        ((290, 270, 302), {"mm"}),
        ((4, 5, 13), {"cm", "in", "m"}),
        ((40, 50, 30), {"cm", "mm", "m"}),
        ((2, 1, 0), {"m", "in"}),
    ],
)
def test_a_unit_is_taken_where_no_other_makes_an_arm(sizes, units):
    rows = "".join(f"q{k} {size} 0 90\n" for k, size in enumerate(sizes, 1))
    found = recognise_table(f"standard DH\ntheta d a alpha\n{rows}")
    assert {dict(one.choices)["length"] for one in found.readings} == units


def test_numbers_with_narrow_gaps_stay_apart():
    text = "standard\n     theta        d     a    alpha\ni1   q1  0.1091 -0.3923   0.0000\n"
    text += "i2   q2  0.0000  0.2500   1.5708\n"
    assert np.allclose(recognise_table(text).arm.table.rows[0, 1:3], (0.1091, -0.3923))


def test_the_header_against_the_words_is_asked_about():
    text = (
        "Standard DH\n| α_{i-1} | a_{i-1} | d_i | θ_i |\n|-|-|-|-|\n|0|0|0.3|q1|\n|90°|0.2|0|q2|\n"
    )
    assert recognise_table(text).open == ("convention",)


def test_each_column_has_its_own_unit():
    text = "Standard\n| θ | d (mm) | a (m) | α |\n|-|-|-|-|\n|q1|300|0|90°|\n|q2|0|0.25|0|\n"
    table = recognise_table(text).arm.table
    assert np.allclose((table.d[0], table.a[1]), (0.3, 0.25))


TEX = r"""
# \begin{pmatrix}
#  \cos\theta_i & -\sin\theta_i \cos\alpha_{i-1} & \sin\theta_i \sin\alpha_{i-1} & a_{i-1} C \\
#  \sin\theta_i & ENTRY & -\cos\theta_i \sin\alpha_{i-1} & a_{i-1} \sin\theta_i \\
#  0 & \sin\alpha_{i-1} & \cos\alpha_{i-1} & d_i \\
#  0 & 0 & 0 & 1
# \end{pmatrix}
# $i$ & $a_{i-1}$ [mm] & $\alpha_{i-1}$ [rad] & $d_i$ [mm] & $\theta_i$ \\
# 1 & 0 & $\frac{\pi}{2}$ & 131.5 & $\theta_1$ \\
# 2 & 110 & 0 & 0 & $\theta_2$ \\
"""


@pytest.mark.parametrize(
    "entry, note",
    [
        ("\\cos\\theta_i \\cos\\alpha_{i-1}", "computes or names the other"),
        ("\\cos\\theta_i \\cos\\alpha_{i-1} ?", "could not be read"),
    ],
)
def test_a_matrix_in_comments_is_held_against_the_index_of_the_header(entry, note):
    found = recognise_table(TEX.replace("ENTRY", entry).replace("C ", r"\cos\theta_i "))
    assert found.open == ("convention",) and note in str(found)
    standard = next(r.arm for r in found.readings if r.arm.table.convention == "standard")
    assert np.allclose(standard.table.a, [0, 0.11])


@pytest.mark.parametrize(
    "beside, n",
    [
        ("", 1),
        ("Conventions are defined in `docs/frames.md`.", 2),
        ("T = Rx(alpha) * Tx(a) * Rz(theta) * Tz(d)", 2),
    ],
)
def test_what_the_text_says_is_held_against_the_index_i_of_the_headings(beside, n):
    rows = "| i | a_i (m) | alpha_i (rad) | d_i | theta_i |\n|-|-|-|-|-|\n|1|0.1|1.5708|0.2|q1|\n"
    found = recognise_table(f"{beside}\n\n{rows}|2|0.3|0|0|q2|\n|3|0|0|0.1|q3|\n")
    assert len(found.readings) == n and found.open == ("convention",) * (n - 1)
    assert found.readings[0].arm.table.convention == "standard"
