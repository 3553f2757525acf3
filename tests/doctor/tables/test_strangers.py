"""Tables as strangers write them: more in a cell than its number, numbers that sentences give."""

import numpy as np
import pytest

import dhlab as dh

HEAD = "Standard DH, lengths in mm, angles in degrees.\n\n"
ROWS = np.array([[0, 0.21, 0, 90], [90, 0, 0.34, 0], [0, 0.06, 0.27, -90]])  # degrees and metres
TABLE = """| Joint | θ | d | a | α |
|---|---|---|---|---|
| 1 | θ1 | {d} | 0 | 90 |
| 2 | {theta} | 0 | {a} | 0 |
| 3 | θ3 | {d3} | {a3} | {alpha} |
"""
CELLS = {"theta": "θ2 + 90", "d": "210", "a": "340", "d3": "60", "a3": "270", "alpha": "-90"}
LETTERS = HEAD + TABLE.format(**{**CELLS, "d": "L1", "a": "L2", "d3": "L3", "a3": "L4"}) + "\n"


def holds(text):
    """Whether one arm is read, with the numbers of ROWS."""
    found = dh.recognise_table(text)
    table = found.arm.table
    read = np.column_stack([np.rad2deg(table.theta), table.d, table.a, np.rad2deg(table.alpha)])
    return len(found.readings) == 1 and np.allclose(read, ROWS, rtol=0, atol=1e-6)


@pytest.mark.parametrize(
    "column, cell",
    [
        ("d", "**210** (=100+110)"),
        ("d", "L0 + L1 = 210 mm"),
        ("d", "D1_BASE = 210"),
        ("d", "210 mm (0.21 m)"),
        ("d", "210 (d1)"),
        ("d", "d1 [210]"),
        ("d", "ca. 210 (see note 1)"),
        ("d", "<b>210</b>"),
        ("d", "210*"),
        ("theta", "θ2 = q2 + 90°"),
        ("theta", "q2 (offset: 90°)"),
        ("theta", "θ₂ + 90° ∈ [-120°, 120°]"),
        ("alpha", "-90° = -π/2"),
        ("alpha", "-90 / -1.5708"),
    ],
)
def test_a_cell_that_says_its_number_and_more(column, cell):
    assert holds(HEAD + TABLE.format(**{**CELLS, column: cell}))


@pytest.mark.parametrize(
    "cell", ["210 (=100+120)", "210 (+20 flange)", "L1 = 210 = 220", "210 / 250", "210 (0.2 m)"]
)
def test_a_cell_that_says_two_numbers_is_refused(cell):
    with pytest.raises(ValueError, match="expected a number"):
        dh.recognise_table(HEAD + TABLE.format(**{**CELLS, "d": cell}))


def test_a_joint_that_a_remark_turns_round_is_asked_about():
    with pytest.raises(ValueError, match="against its axis"):
        dh.recognise_table(HEAD + TABLE.format(**{**CELLS, "theta": "θ2 + 90 (reversed)"}))


def test_a_star_behind_a_number_is_the_variable_s_or_a_footnote_s():
    stars = HEAD + "| i | θ | d | a | α |\n|---|---|---|---|---|\n| 1 | {} | 210 | 0 | 90 |\n"
    stars += "| 2 | {} | 0 | 340 | 0 |\n| 3 | {} | {} | 270 | -90 |\n"
    assert holds(stars.format("0*", "90*", "0*", "60"))
    with pytest.raises(ValueError, match="star"):
        dh.recognise_table(stars.format("0*", "90*", "0", "60*"))


@pytest.mark.parametrize(
    "said",
    [
        "with (L1, L2, L3, L4) = (210, 340, 60, 270) mm",
        "L1/L2/L3/L4 = 210/340/60/270 mm",
        "- **L1** = 21 cm\n- **L2** = 34 cm\n- **L3** = 6 cm\n- **L4** = 27 cm",
        "L1 → 210 mm\nL2 → 340 mm\nL3 → 60 mm\nL4 → 270 mm",
        "L1: base, 210 mm\nL2: upper arm, 340 mm\nL3: elbow, 60 mm\nL4: forearm, 270 mm",
        "L1 (210 mm) is the base, L2 (340 mm) follows, then L3 (60 mm) and L4 (270 mm).",
        "L1 = 210 mm, L2 = 340 mm, L3 = 60 mm sowie L4 = 270 mm",
        "| L1 | L2 | L3 | L4 |\n|---|---|---|---|\n| 210 mm | 340 mm | 60 mm | 270 mm |",
        "L1 = 210 | L2 = 340 | L3 = 60 | L4 = 270",
    ],
)
def test_letters_get_their_values(said):
    assert holds(LETTERS + said)


@pytest.mark.parametrize(
    "said",
    [
        "- Joint 1: θ = q1, d (mm) = 210, a (mm) = 0, α (deg) = 90\n"
        "- Joint 2: θ = q2 + 90°, d (mm) = 0, a (mm) = 340, α (deg) = 0\n"
        "- Joint 3: θ = q3, d (mm) = 60, a (mm) = 270, α (deg) = -90",
        "* Joint 1 — θ₁ (variable), d₁ = 210 mm, a₁ = 0, α₁ = 90°\n"
        "* Joint 2 — θ₂ + 90° (variable), d₂ = 0, a₂ = 340 mm, α₂ = 0°\n"
        "* Joint 3 — θ₃ (variable), d₃ = 60 mm, a₃ = 270 mm, α₃ = -90°",
        "Link lengths a: 0, 340, 270 mm; link offsets d: 210, 0, 60 mm; twists α: 90°, 0°, -90°;"
        " joint offsets θ: 0°, 90°, 0°.",
        "Link 1 has d = 210, a = 0 and alpha = 90; link 2 has d = 0, a = 340 and alpha = 0; link 3"
        " has d = 60, a = 270 and alpha = -90. The second joint has an offset of 90 deg.",
        "In the order (θ, d, a, α):\n1. θ1, 210, 0, 90\n2. θ2 + 90, 0, 340, 0\n3. θ3, 60, 270, -90",
        '"joint";"theta";"d_m";"a_m";"alpha"\n"1";"q1";"0,21";"0";"90"\n'
        '"2";"q2 + 90";"0";"0,34";"0"\n"3";"q3";"0,06";"0,27";"-90"',
        "Rows theta d a alpha:\n0, 210, 0, 90, 90, 0, 340, 0, 0, 60, 270, -90",
        TABLE.format(**CELLS) + "| Total |  | 270 | 610 | |",
        "| i | θ | d (mm) | d (m) | a | α (deg) | α (rad) |\n|--|--|--|--|--|--|--|\n"
        "| 1 | q1 | 210 | 0.21 | 0 | 90 | 1.571 |\n| 2 | q2 + 90 | 0 | 0 | 340 | 0 | 0 |\n"
        "| 3 | q3 | 60 | 0.06 | 270 | -90 | -1.571 |",
    ],
)
def test_rows_in_sentences_lists_and_files(said):
    assert holds(HEAD + said)


def test_what_a_joint_ranges_over_is_no_value_of_its_letter():
    text = HEAD + "| i | θ | d | a | α |\n|---|---|---|---|---|\n| 1 | q1 | 210 | 0 | 90 |\n"
    text += "| 2 | 0 | d2 | 340 | 0 |\n\n- d2: 0 to 150 mm\n"
    assert dh.recognise_table(text).arm.table.joints == "RP"


def test_a_numeric_table_beside_the_same_in_letters_is_read():
    numbers = "".join(
        f"    DHParameter(theta_offset={t}, d={d}, a={a}, alpha={al}),\n"
        for t, d, a, al in ((0, 210, 0, 90), (90, 0, 340, 0), (0, 60, 270, -90))
    )
    assert holds(LETTERS + f"\ndh_table = [\n{numbers}]\n")


TEX = r"""\begin{table}\caption{Classical DH parameters\label{t}}
\begin{tabular}{cccccc}
\multirow{2}{*}{Joint} & \multicolumn{4}{c}{Parameters} & \multirow{2}{*}{Range} \\ \cline{2-5}
 & \makecell{$\theta_i$\\(deg)} & $d_i$ [mm] & $a_i$ [mm] & $\alpha_i$ (\textdegree) & \\ \hline
\rowcolor{gray} 1 & \ensuremath{\theta_1} & 210\tnote{a} & 0 & $\nicefrac{180}{2}$ & $\pm 170$ \\
2 & $\theta_2+90$ & 0 & 340 & 0 & $\pm 100$ \\
3 & $\theta_3^*$ & 60 & 270 & --90 & $\pm 150$ \\
\end{tabular}\end{table}
"""
ALIGNED = r"""% standard DH, mm and degrees
\begin{align}
\theta_1 &= q_1, & d_1 &= 210, & a_1 &= 0, & \alpha_1 &= 90 \\
\theta_2 &= q_2 + 90, & d_2 &= 0, & a_2 &= 340, & \alpha_2 &= 0 \\
\theta_3 &= q_3, & d_3 &= 60, & a_3 &= 270, & \alpha_3 &= -90
\end{align}
"""
JSON = """{"convention": "standard", "rows": [
 {"d": {"value": 210, "unit": "mm"}, "a": {"value": 0, "unit": "mm"},
  "alpha": {"value": 90, "unit": "deg"}, "theta": {"value": 0, "unit": "deg"}},
 {"d": {"value": 0, "unit": "mm"}, "a": {"value": 340, "unit": "mm"},
  "alpha": {"value": 0, "unit": "deg"}, "theta": {"value": 90, "unit": "deg"}},
 {"d": {"value": 60, "unit": "mm"}, "a": {"value": 270, "unit": "mm"},
  "alpha": {"value": -90, "unit": "deg"}, "theta": {"value": 0, "unit": "deg"}}]}
"""
NUMBERED = """standard_dh:  # mm, degrees
  link_1: {theta_1: q1, d_1: 210, a_1: 0, alpha_1: 90}
  link_2: {theta_2: q2 + 90, d_2: 0, a_2: 340, alpha_2: 0}
  link_3: {theta_3: q3, d_3: 60, a_3: 270, alpha_3: -90}
"""
TITLED = """In the modified DH convention the frames are placed otherwise; we use the standard one.

### Standard DH parameters (mm, degrees)
""" + TABLE.format(**CELLS)


@pytest.mark.parametrize("text", [TEX, ALIGNED, JSON, NUMBERED, TITLED])
def test_pages_files_and_titles(text):
    assert holds(text)


def test_an_empty_cell_of_a_length_is_nought_where_no_nought_is_written():
    assert holds(
        HEAD
        + TABLE.format(**CELLS)
        .replace("| 0 | 90 |", "| | 90 |")
        .replace("| 0 | 340 | 0 |", "| | 340 | 0 |")
    )
    with pytest.raises(ValueError, match="empty cell"):
        dh.recognise_table(HEAD + TABLE.format(**{**CELLS, "d3": " ", "a3": "0"}))


def test_two_tables_with_other_numbers_are_asked_about():
    links = "".join(
        f"- Joint {k}: θ = q{k}, d = {d}, a = {a}, α = {alpha}\n"
        for k, d, a, alpha in ((1, 210, 0, 90), (2, 0, 340, 0), (3, 60, 270, -90))
    )
    old = TABLE.format(**{**CELLS, "d": "200", "a": "350"})
    for text in (links + "\n" + old, LETTERS + "\n" + old + "\nL1 = 1, L2 = 2, L3 = 3, L4 = 4"):
        with pytest.raises(ValueError, match="expected one table"):
            dh.recognise_table(HEAD + text)
