"""What a program does with the rows that it holds counts, or it is asked about."""

import numpy as np
import pytest

from dhlab import recognise_table

LENGTHS = ((0.42, 0.06, "-pi/2"), (0.0, 0.31, "0"), (0.03, 0.045, "-pi/2"), (0.38, 0.0, "pi/2"))


def rows(second="0", scale=1, unit=""):
    held = [
        f"  [{second if k == 1 else 0}, {d * scale:g}, {a * scale:g}, {al}],"
        for k, (d, a, al) in enumerate(LENGTHS)
    ]
    head = f"# standard: theta, d, a, alpha{unit}\nDH = np.array([\n"
    return head + "\n".join(held) + "\n])\n"


HEAD = "# standard: theta, d, a, alpha\ndh = "
DEFINED = "def dh(theta, d, a, alpha):\n    pass\n"
REPLACED = (
    f"{DEFINED}for i in range(4):\n    T = T @ dh(q[i], DH[i][1], DH[i][2], DH[i][3])\n",
    "DH[:, 0] = q\n",
    "for i in range(4):\n    DH[i][0] = q[i]\n",
)


@pytest.mark.parametrize("program", REPLACED)
def test_a_column_that_the_program_replaces_is_asked_about(program):
    found = recognise_table(rows("-pi/2") + program)
    assert found.open == ("zero",)
    assert [float(reading.arm.table.theta[1]) for reading in found.readings] == [0, -np.pi / 2]
    assert len(recognise_table(rows() + program).readings) == 1


def test_zeros_that_are_added_are_not_asked_about():
    program = f"{DEFINED}T = dh(DH[i][0] + q[i], DH[i][1], DH[i][2], DH[i][3])\n"
    found = recognise_table(rows("-pi/2") + program)
    assert len(found.readings) == 1 and found.arm.table.theta[1] == -np.pi / 2


@pytest.mark.parametrize(
    "program, said",
    [
        ("theta = q[i] - DH[i, 0]\n", "is it subtracted"),
        (f"{DEFINED}T = dh(q[i] + DH[i][0], DH[i][1], DH[i][2], -DH[i][3])\n", "with a minus"),
    ],
)
def test_what_turns_a_column_round_is_asked_about(program, said):
    with pytest.raises(ValueError, match=said):
        recognise_table(rows("-pi/2") + program)


def test_ones_and_minus_ones_by_which_joints_are_multiplied_are_senses():
    found = recognise_table(rows() + "k = [1, -1, 1, 1]\ntheta = k[i] * q[i]\n")
    assert found.arm.sign.tolist() == [1, -1, 1, 1]
    assert recognise_table(rows() + "k = [1, -1, 1, 1]\n").arm.sign.tolist() == [1, 1, 1, 1]


def test_a_comment_that_gives_another_length_is_asked_about():
    text = f"d1 = 0.42  # {{}} mm\n{HEAD}[[q1, d1, 0, 90], [q2, 0, 1, 0]]\n"
    with pytest.raises(ValueError, match=r"line 1: the program has d1 = 0\.42.*which one"):
        recognise_table(text.format(520))
    assert recognise_table(text.format(420)).arm.table.d[0] == 0.42


@pytest.mark.parametrize(
    "text, unit",
    [
        (rows(unit="; in mm") + "T[2, 3] = d / 1000\n", None),
        (rows(scale=1000, unit="; in mm") + "T[2, 3] = d / 1000\n", None),
        (rows(scale=1000, unit="; in metres") + "T[2, 3] = d / 1000\n", "factor in the program"),
    ],
)
def test_the_factor_of_the_program_settles_the_unit(text, unit):
    found = recognise_table(text)
    assert len(found.readings) == 1 and abs(found.arm.table.d[0] - 0.42) < 1e-12
    assert unit is None or unit in str(found)


def test_a_matrix_whose_rows_are_parameters_is_asked_about():
    text = f"{DEFINED}j = np.array([[0.4, 0, 0.1], [0, 0.3, 0], [90, 0, 90], [0, 0, 0]])\n"
    with pytest.raises(ValueError, match=r"j\[0, 0\], j\[1, 0\].*which column is which link\?"):
        recognise_table(rows() + DEFINED + "T = dh(j[0, 0], j[1, 0], j[2, 0], j[3, 0])\n" + text)
