"""What a text says beside its rows is in the arm, or it is asked about: never silently wrong."""

import numpy as np
import pytest

from dhlab import recognise_table

LENGTHS = ((0.42, 0.06, "-pi/2"), (0.0, 0.31, "0"), (0.03, 0.045, "-pi/2"), (0.38, 0.0, "pi/2"))
MATRIX = (
    "# standard DH: theta, d, a, alpha\nDH = np.array([\n"
    + ",\n".join(f"  [0, {d}, {a}, {al}]" for d, a, al in LENGTHS)
    + "])\n"
)
LISTS = (
    "% standard DH\na = [0.06 0.31 0.045 0];\nd = [0.42 0 0.03 0.38];\n"
    "alpha = [-pi/2 0 -pi/2 pi/2];\n"
)
ZEROS = (
    "OFF = [0, -pi/2, 0, 0]\nth = q[i] + OFF[i]\n",
    "q[1] = q[1] - np.pi/2\n",
    "q[1] -= np.pi/2\n",
    "theta2 = q2 - 90\n",
    "# joint 2 has an offset of -90 degrees\n",
    "# Note: theta2 = q2 - 90\n",
    "home = np.array([0, -np.pi/2, 0, 0])\nT = fk(q + home)\n",
    "theta = [t1, t2-90, t3, t4]\n",
    "q = q + deg2rad([0 -90 0 0]);\n",
    "joint_zero = {2: -pi/2}\n",
    "t = q[i] + t - (np.pi/2 if i == 1 else 0)\n",
)
SENSES = (
    "dirs = [1, -1, 1, 1]\nth = q[i]*dirs[i]\n",
    "q = q .* [1 -1 1 1];\n",
    "T2 = dh(-q2, 0, 0.31, 0)\n",
    "# joint 2 turns in the negative direction\n",
    "motor_sign = np.array([1, -1, 1, 1])\n",
)
LEFT_OUT = (
    "# a 7-DOF arm\n",
    "q7 = 0\n",
    "# the kinematics of the five axis robot\n",
    "# joint 3 is prismatic\n",
)
HARMLESS = (
    "# a 4-DOF arm\n",
    "offsets = [0, 0, 0, 0]\nth = q[i] + offsets[i]\n",
    "tool_offset = [0, 0, 0.1]\n",
    "while theta > pi:\n    theta = theta - 2*pi\n",
    "q_home = [0, -pi/2, 0, 0]\n",
    "qlim = [-pi, pi]\n",
)


@pytest.mark.parametrize("rows", [MATRIX, LISTS])
@pytest.mark.parametrize("beside", [*ZEROS, *SENSES, *LEFT_OUT])
def test_what_stands_beside_the_rows_is_read_or_asked_about(rows, beside):
    found, fault = None, ""
    try:
        found = recognise_table(rows + beside)
    except ValueError as error:
        fault = str(error)
    if found is None:
        assert "?" in fault
        return
    arm = found.arm
    assert len(arm) == 4 and beside not in LEFT_OUT
    turned = np.allclose(arm.table.theta, [0, -np.pi / 2, 0, 0])
    against = np.allclose(arm.sign, [1, -1, 1, 1])
    assert (turned, against) == (beside in ZEROS, beside in SENSES), found


@pytest.mark.parametrize("rows", [MATRIX, LISTS])
@pytest.mark.parametrize("beside", HARMLESS)
def test_what_changes_nothing_is_not_asked_about(rows, beside):
    found = recognise_table(rows + beside)
    assert len(found.readings) == 1 and (found.arm.table.theta == 0).all()


def test_a_second_table_is_asked_about():
    named = "".join(f"a{i} = 0.{i}; d{i} = 0.1; alpha{i} = 90\n" for i in range(1, 5))
    with pytest.raises(ValueError, match="found two of 4 and 4 rows"):
        recognise_table(LISTS + named)


TORN = (
    "T1 = dh(q1, 0.3, 0, 90)\nT2 = {}\nT3 = dh(q3, 0, 0.4, 0)\nT4 = dh(q4, 0, 0.1, 0)\n",
    "- [0, 0.3, 0, 90]\n- {}\n- [0, 0, 0.4, 0]\n- [0, 0, 0.1, 0]\n",
)
MISSING = "0, 0.2, 90", "0, 0.2, 0, 90, 0.1", "0, 0.2, 0, ??"


@pytest.mark.parametrize("cells", MISSING)
@pytest.mark.parametrize("rows", TORN)
def test_a_row_that_lacks_a_number_is_not_left_out(rows, cells):
    torn = f"dh({cells})" if "dh(" in rows else f"[{cells}]"
    with pytest.raises(ValueError, match=r"line 2: expected"):
        recognise_table(rows.format(torn))
    whole = recognise_table(rows.format(torn.replace(cells, "0, 0.2, 0, 90")), convention="craig")
    assert max(len(reading.arm) for reading in whole.readings) == 4


def test_a_base_in_numbers_is_said_not_to_be_in_the_rows():
    links = "L(1) = Revolute('d', 0.3, 'a', 0, 'alpha', pi/2);\nL(2) = Revolute('a', 0.4);\n"
    found = recognise_table(links + "robot = SerialLink(L, 'base', [0.1, 0.2, 0]);\n")
    assert any("sets a base, [0.1, 0.2, 0]" in note for note in found.notes), found.notes
