"""The same table as another author would have written it: the numbers that stand in it are read,
and no others.
"""

import numpy as np
import pytest

import dhlab as dh
from dhlab.doctor.tables.cells import read_cell

SAID = "Standard DH parameters, lengths in mm, angles in degrees.\n\n"
ROWS = np.array([[0, 0.21, 0, 90], [90, 0, 0.34, 0], [0, 0.06, 0.27, -90]])  # m, degrees
LETTERS = """| i | d | theta | a | alpha |
|---|---|---|---|---|
| J1 | d1 | q1 | 0 | pi/2 |
| J2 | 0 | q2 + pi/2 | a2 | 0 |
| J3 | d3 | q3 | a3 | -pi/2 |
"""


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


@pytest.mark.parametrize(
    "heading, cells",
    [
        ("Maps to", ["shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint"]),
        ("Channel", ["0", "4", "8"]),
        ("Reduction", ["50", "101", "80"]),
        ("Bearing", ["6001", "6203", "51105"]),
        ("Function", ["Yaw", "Pitch", "Pitch"]),
    ],
)
def test_a_column_that_says_nothing_of_angles_or_lengths_is_passed_over(heading, cells):
    rows = [
        "| 1 | q1 | 210 | 0 | 90 |",
        "| 2 | q2 + 90 | 0 | 340 | 0 |",
        "| 3 | q3 | 60 | 270 | -90 |",
    ]
    lines = [f"| i | theta | d | a | alpha | {heading} |", "|---|---|---|---|---|---|"]
    text = SAID + "\n".join(lines + [f"{row} {cell} |" for row, cell in zip(rows, cells)])
    found = dh.recognise_table(text)
    assert holds(found)


@pytest.mark.parametrize(
    "heading, cells",
    [
        ("Zero", ["0", "-90", "90"]),
        ("x", ["0", "10", "0"]),
        ("Tool (mm)", ["0", "0", "80"]),
        ("Actuated", ["yes", "yes", "no"]),
        ("Trim", ["2", "3", "-1"]),
    ],
)
def test_a_column_that_may_count_is_asked_about(heading, cells):
    rows = ["| 1 | q1 | 210 | 0 | 90 |", "| 2 | q2 | 0 | 340 | 0 |", "| 3 | q3 | 60 | 270 | -90 |"]
    lines = [f"| i | theta | d | a | alpha | {heading} |", "|---|---|---|---|---|---|"]
    text = SAID + "\n".join(lines + [f"{row} {cell} |" for row, cell in zip(rows, cells)])
    with pytest.raises(ValueError, match=r"found a column of numbers .*what is it\?"):
        dh.recognise_table(text)


HEADINGS = {
    "Portuguese": ("Ângulo da junta", "Deslocamento", "Comprimento", "Torção"),
    "Polish": ("Kąt przegubu", "Przesunięcie", "Długość", "Skręcenie"),
    "Turkish": ("Eklem açısı", "Eklem kayması", "Uzuv uzunluğu", "Uzuv burulması"),
    "Russian": ("Угол поворота", "Смещение", "Длина", "Угол скручивания"),
    "Japanese": ("関節角", "リンクオフセット", "リンク長", "ねじれ角"),
    "Korean": ("관절각", "링크 오프셋", "링크 길이", "링크 비틀림"),
    "what they mean": ("θ – joint angle", "d – offset", "a – length", "α – twist"),
    "along what": ("θ about z", "d along z", "a along x", "α about x"),
    "length l": ("θ", "d", "l (mm)", "α"),
    "offset s": ("θ", "s", "a", "α"),
    "twist τ": ("θ", "d", "a", "τ"),
}


@pytest.mark.parametrize("names", HEADINGS.values(), ids=HEADINGS)
@pytest.mark.parametrize("first", ["Axis no.", "Joint #", "Öğe", "From→To"])
def test_headings_in_other_words(names, first):
    lines = [
        f"| {first} | {' | '.join(names)} |",
        "|---|---|---|---|---|",
        "| J1 | q1 | 210 | 0 | 90 |",
    ]
    text = SAID + "\n".join(
        [*lines, "| J2 | q2 + 90 | 0 | 340 | 0 |", "| J3 | q3 | 60 | 270 | -90 |"]
    )
    assert holds(dh.recognise_table(text))


CELLS = {
    "θ2 (variable) + 90": 90,
    "**θ2** + 90°": 90,
    "θ2(t) + 90": 90,
    "variable θ2": 0,
    "φ2 + 90": 90,
    "joint 2": 0,
    "θ2 + (π)": 180,
    "θ2 − 79,35°": -79.35,
    "θ2 + π/2 (90°)": 90,
}


@pytest.mark.parametrize("cell", CELLS)
def test_a_variable_and_its_zero_in_other_words(cell):
    read = read_cell(cell)
    turned = read.value if read.unit != "rad" else np.rad2deg(read.value)
    assert len(read.letters) == 1 and np.isclose(turned, CELLS[cell])


@pytest.mark.parametrize(
    "cell, number",
    [
        ("150¹", 150),
        ("310 [1]", 310),
        ("150 (2)", 150),
        ("150†", 150),
        ("12 cm (1)", 12),
        ("~305", 305),
    ]
    + [
        ("π/2 (90°)", np.pi / 2),
        ("-90° (-π/2)", -90),
        ("90 (1.5708)", 90),
        ("1.5708 rad (90°)", 1.5708),
    ],
)
def test_a_number_with_a_mark_or_once_more_in_another_unit(cell, number):
    assert np.isclose(read_cell(cell).value, number)


@pytest.mark.parametrize("cell", ["π/2 (-90°)", "90 (80)", "0 (90°)", "θ2 - π/2 (90°)"])
def test_two_numbers_in_one_cell_are_none(cell):
    with pytest.raises(ValueError, match="expected a number"):
        read_cell(cell)


NUMBERS = """| i | d | theta | a | alpha |
|---|---|---|---|---|
| J1 | 210 | q1 | 0 | pi/2 |
| J2 | 0 | q2 + pi/2 | 340 | 0 |
| J3 | 60 | q3 | 270 | -pi/2 |
"""


@pytest.mark.parametrize("tables", [(NUMBERS, NUMBERS), (NUMBERS, LETTERS), (LETTERS, NUMBERS)])
def test_a_table_that_stands_twice_is_one(tables):
    found = dh.recognise_table(
        "Standard DH parameters in mm.\n\n" + "\nOnce more:\n\n".join(tables)
    )
    assert holds(found) and any("the text has the table" in note for note in found.notes)


def test_two_tables_that_differ_in_a_number_are_two():
    other = NUMBERS.replace("340", "341")
    with pytest.raises(ValueError, match="expected one table, found two"):
        dh.recognise_table(SAID + NUMBERS + "\nThe other arm:\n\n" + other)


@pytest.mark.parametrize(
    "values",
    [
        "- d1 (base): 210 mm\n- a2 (upper arm): 340 mm\n- d3 (side): 60 mm\n- a3 (link): 270 mm",
        "d1 is 210 mm. a2 is 340 mm, a3 is 270 mm and d3 is 60 mm.",
        "- `d1` (base): 210\n- `a2` (upper): 340\n- `d3` (wrist): 60\n- `a3` (lower): 270",
    ],
)
def test_letters_whose_values_are_told_in_words(values):
    assert holds(dh.recognise_table(SAID + LETTERS + "\n" + values + "\n"))


def test_where_a_joint_stands_is_no_value_of_its_letter():
    text = (
        SAID + LETTERS + CONSTANTS.replace("| d1 | 210 |\n", "") + "\nd1 is 210 mm in this pose.\n"
    )
    with pytest.raises(ValueError, match="d1 has no value"):
        dh.recognise_table(text)
