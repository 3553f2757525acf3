"""What labels, headings and remarks of a table say of its rows, and programs of their columns."""

import numpy as np
import pytest

from dhlab import recognise_table

HALF = np.pi / 2
LINKS = """# theta, d, a, alpha in m and degrees; the standard convention
rows = [
    [0, 0.2, 0, 90],   # link 1 -> 2
    [0, 0, 0.3, 0],    # link 2 -> 3
    [90, 0, 0, {}],   # link 3 -> 4
    [0, 0.1, 0, 0],    # link 4 -> end
]"""
JOINTS = """Modified DH
| Joint | alpha(i-1) | a(i-1) | d_i (m) | theta offset | Note |
|---|---|---|---|---|---|
| 1 | 0 | 0 | 0.3 | 0 | base |
| 2 | -90° | 0.05 | 0 | -90° | upper arm |
| 3 | 0 | 0.25 | 0 | 0 | forearm |
| 4 | {} | 0 | 0.1 | 0 | tool |
"""


@pytest.mark.parametrize("text, turned, straight", [(LINKS, "90", "0"), (JOINTS, "90°", "0")])
def test_a_last_row_that_is_counted_is_a_joint_or_asked_about(text, turned, straight):
    assert [len(one.arm) for one in recognise_table(text.format(turned)).readings] == [4]
    lengths = {len(one.arm) for one in recognise_table(text.format(straight)).readings}
    assert lengths == {3, 4}


def test_limits_beside_the_zeros_are_no_column_theta():
    arm = recognise_table(
        "Standard DH\n| Joint | a (mm) | d (mm) | α (°) | θ_offset (°) | θ_min (°) | θ_max (°) |\n"
        "|--|--|--|--|--|--|--|\n| J1 | 90 | 410 | -90 | 0 | -160 | 160 |\n"
        "| J2 | 350 | 0 | 0 | -90 | -80 | 110 |\n"
    ).arm
    expected = [[0, 0.41, 0.09, -HALF], [-HALF, 0, 0.35, 0]]
    assert np.allclose(arm.table.rows, expected)


def test_an_angle_that_is_called_fixed_has_no_joint():
    block = "{}:\n  d: {}\n  theta: {}\n  a: 0.2\n  alpha: 0.0\n\n"
    rows = [("j1", 0.1, "q1"), ("j2", 0, "q2 + 0.5"), ("end", 0.05, "-pi/2 (fixed)")]
    arm = recognise_table("standard DH, m, rad\n\n" + "".join(block.format(*r) for r in rows)).arm
    assert len(arm) == 2 and arm.table.theta[1] == 0.5
    assert np.allclose(arm.tool, [[0, 1, 0, 0], [-1, 0, 0, -0.2], [0, 0, 1, 0.05], [0, 0, 0, 1]])


def test_two_letters_with_one_value_and_a_decimal_comma():
    text = (
        "Standard-DH\n| i | θ_i | d_i | a_i | α_i |\n|--|--|--|--|--|\n| 1 | q1 | d1 | 0 | 90° |\n"
        "| 2 | q2 | 0 | a2 | 0 |\n| 3 | q3 | 0 | a3 | 0 |\n\n"
        "Maße: d1 = 82,5 mm, a2 = a3 = 140 mm.\n"
    )
    table = recognise_table(text).arm.table
    assert np.allclose([table.d[0], *table.a[1:]], [0.0825, 0.14, 0.14])


def test_a_column_of_numbered_names_is_none_of_the_four():
    text = (
        "Standard DH\n| Joint | In the model | θ | d (m) | a (m) | α (rad) |\n|--|--|--|--|--|--|\n"
        "| 1 | Hinge_1 | q₁ | 0.05 | 0 | π/2 |\n| 2 | Hinge_2 | q₂ | 0 | 0.3 | 0 |\n"
        "| 3 | Hinge_4 | q₃ | 0 | 0.2 | 0 |\n"
    )
    assert np.allclose(recognise_table(text).arm.table.a, [0, 0.3, 0.2])


PLANAR = """lengths in meters
| Joint $i$ | $\\theta_i$ | $d_i$ | $a_i$ | $\\alpha_i$ |
|---|---|---|---|---|
| 1 | $\\theta_1$ | 0 | {} | 0 |
| 2 | $\\theta_2$ | 0 | 0.7 | 0 |
"""


def test_a_planar_arm_with_a_length_in_each_row_is_standard_by_its_index():
    found = recognise_table(PLANAR.format("0.9"))
    q = np.array([0.4, 0.5])
    tip = 0.9 * np.array([np.cos(0.4), np.sin(0.4)]) + 0.7 * np.array([np.cos(0.9), np.sin(0.9)])
    assert not found.open and np.allclose(found.arm.forward(q)[:2, 3], tip)
    assert "convention" in recognise_table(PLANAR.format("0")).open
    assert "convention" in recognise_table("after Craig\n" + PLANAR.format("0.9")).open or (
        recognise_table("after Craig\n" + PLANAR.format("0.9")).arm.table.convention == "craig"
    )


def test_calls_tell_which_joints_slide():
    found = recognise_table(
        "teta = [0 0 0]; d = [0.4 0 0.2]; a = [0.1 -0.1 0]; alfa = [0 -pi/2 0];  % standard, m\n"
        "A1 = denavit(q1, d(1), a(1), alfa(1));\nA2 = denavit(teta(2), q2, a(2), alfa(2));\n"
        "A3 = denavit(q3, d(3), a(3), alfa(3));\n"
    )
    assert {one.arm.table.joints for one in found.readings} == {"RPR"}


def test_lists_under_a_name_and_the_word_value_are_columns():
    lists = {"alpha": [0.0, 1.57, 0.0], "a": [0.0, 0.0, -0.5], "d": [0.12, 0.0, 0.1]}
    parts = "".join(
        f'    "{name}": {{\n        "value": {values},\n        "unit": "-",\n    }},\n'
        for name, values in lists.items()
    )
    found = recognise_table(f"# modified DH, in m and rad\nDH = {{\n{parts}}}\n")
    assert not found.open
    assert np.allclose(found.arm.table.rows[:, 1:].T, [lists[k] for k in ("d", "a", "alpha")])


def test_columns_that_matlab_turns_round_and_joins():
    found = recognise_table(
        "p = [[0 0 0.1 0]; [pi/2 0 0 0]; [0 0.3 0 0]];\np = fliplr(p);\np = [p, [0 0 0]'];\n"
        "p = [p, [0 pi/2 0]'];\nL(1) = Link(p(1,1:6), 'modified');\n"
        "L(2) = Link(p(2,1:6), 'modified');\nL(3) = Link(p(3,1:6), 'modified');\n"
        "robot = SerialLink(L);\n"
    )
    rows = [[0, 0.1, 0, 0], [HALF, 0, 0, HALF], [0, 0, 0.3, 0]]
    assert any(
        len(one.arm) == 3 and np.allclose(one.arm.table.rows, rows) for one in found.readings
    )


@pytest.mark.parametrize("order", ["standard", "craig"])
def test_nested_groups_tell_the_convention(order):
    names = {"standard": "hinge rise reach tilt", "craig": "tilt reach hinge rise"}[order].split()
    nested = "".join(f"{a}.add({b}); " for a, b in zip(["parent", *names], names))
    found = recognise_table(
        "const rows = [ // mm\n  { d: 300, a: 50, alpha: 90, theta_offset: 0 },\n"
        "  { d: 0, a: 350, alpha: 0, theta_offset: 90 },\n"
        "  { d: 0, a: 80, alpha: 90, theta_offset: 0 } ];\n"
        f"{nested}hinges.push(hinge);\nrise.position.z = r.d; reach.position.x = r.a;\n"
        "tilt.rotation.x = rad(r.alpha);\n"
        "hinges[i].rotation.z = rad(q[i] + rows[i].theta_offset);\n"
    )
    assert {one.arm.table.convention for one in found.readings} == {order}
