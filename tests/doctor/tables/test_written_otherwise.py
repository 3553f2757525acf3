"""The same table as another author would have written it: the numbers that stand in it are read,
and no others.
"""

import numpy as np
import pytest

import dhlab as dh

SAID = "Standard DH parameters, lengths in mm, angles in degrees.\n\n"
ROWS = np.array([[0, 0.21, 0, 90], [90, 0, 0.34, 0], [0, 0.06, 0.27, -90]])  # m, degrees
LETTERS = """| i | d | theta | a | alpha |
|---|---|---|---|---|
| J1 | d1 | q1 | 0 | pi/2 |
| J2 | 0 | q2 + pi/2 | a2 | 0 |
| J3 | d3 | q3 | a3 | -pi/2 |
"""
NAMED = ("theta", "d", "a", "alpha")


def holds(found, rows=ROWS):
    """Whether one arm is read, with these numbers (theta, d, a, alpha; degrees and metres)."""
    table = found.arm.table
    read = np.column_stack([np.rad2deg(table.theta), table.d, table.a, np.rad2deg(table.alpha)])
    return len(found.readings) == 1 and np.allclose(read, rows, rtol=0, atol=1e-9)


CONSTANTS = "\n| letter | mm |\n|---|---|\n| d1 | 210 |\n| a2 | 340 |\n| d3 | 60 |\n| a3 | 270 |\n"


@pytest.mark.parametrize("mark", [",", ";", "\t", "   "])
def test_a_table_of_constants_between_bars_does_not_decide_how_the_rows_are_split(mark):
    rows = [["i", "theta", "d", "a", "alpha"], ["1", "q1", "d1", "0", "90"]]
    rows += [["2", "q2 + 90", "0", "a2", "0"], ["3", "q3", "d3", "a3", "-90"]]
    text = SAID + "\n".join(mark.join(row) for row in rows) + "\n"
    assert holds(dh.recognise_table(text + CONSTANTS))
    assert holds(dh.recognise_table(CONSTANTS + text))


def test_a_row_with_a_letter_and_a_zero_gives_the_letter_no_value():
    assert holds(dh.recognise_table(SAID + LETTERS + CONSTANTS))
    with pytest.raises(ValueError, match="d1, a2, d3, a3 have no value"):
        dh.recognise_table(SAID + LETTERS)
