"""One table in the markup of wikis, manuals, forums and settings: the numbers that stand in it are
read, and no others.
"""

import numpy as np
import pytest

import dhlab as dh
from dhlab.doctor.tables.cells import read_cell

ROWS = (("1", "q1", 0.21, 0.0, 90), ("2", "q2 + 90", 0.0, 0.34, 0), ("3", "q3", 0.06, 0.27, -90))
NAMES = ("i", "theta", "d", "a", "alpha")
SAID = "Standard DH parameters, metres and degrees\n"


def lines(row, head, rule=""):
    return SAID + "\n".join([head, *([rule] if rule else []), *(row.format(*one) for one in ROWS)])


def numbered(pattern):
    """One block for each row, with its numbers by name."""
    return "\n".join(
        pattern.format(i=i, zero=90 * (i == "2"), d=d, a=a, alpha=alpha)
        for i, _, d, a, alpha in ROWS
    )


WIKI = "{| class='wikitable'\n! " + "\n! ".join(NAMES)
WRITTEN = {
    "mediawiki, a line for a row": lines(
        "|-\n| {} || {} || style='color:red' | {} || {} || {}", "{|\n! " + " !! ".join(NAMES)
    )
    + "\n|}",
    "mediawiki, a line for a cell": lines("|-\n| {}\n| {}\n| {}\n| {}\n| {}", WIKI) + "\n|}",
    "dokuwiki": lines("| {} | {} | {} | {} | {} |", f"^ {' ^ '.join(NAMES)} ^"),
    "textile": lines("| {} | {} | {} | {} | {} |", f"|_. {' |_. '.join(NAMES)} |"),
    "confluence": lines("|{}|{}|{}|{}|{}|", f"||{'||'.join(NAMES)}||"),
    "asciidoc": lines("\n|{}\n|{}\n|{}\n|{}\n|{}", f"|===\n|{' |'.join(NAMES)}") + "\n|===\n",
    "csv-table": lines(
        "   {}, {}, {}, {}, {}", f".. csv-table:: x\n   :header: {', '.join(NAMES)}\n"
    ),
    "forum": lines(
        "[tr][td]{}[/td][td]{}[/td][td]{}[/td][td]{}[/td][td]{}[/td][/tr]",
        f"[table][tr][th]{'[/th][th]'.join(NAMES)}[/th][/tr]",
    )
    + "\n[/table]",
    "breaks": lines(
        "| {} | {} | {} | {} | {} |", "| i | θ<br>[deg] | d<br>[m] | a<br>[m] | α<br>[deg] |"
    ),
    "page": lines("{0} {1} {2} m {3} m {4}°", "i θ i d i a i α i").replace(" + ", "+"),
    "mail": lines("> {}: {}, {}, {}, {}", "> in the order (theta, d, a, alpha):"),
    "toml": "# "
    + SAID
    + numbered("[[joint]]\ntheta = {zero}\nd = {d}\na = {a}\nalpha = {alpha}\n"),
    "ini": "; " + SAID + numbered("[joint{i}]\ntheta_offset={zero}\nd={d}\na={a}\nalpha={alpha}"),
    "xml": SAID
    + numbered(
        "<link no='{i}'><theta>{zero}</theta><d>{d}</d><a>{a}</a><alpha>{alpha}</alpha></link>"
    ),
    "xml, values": SAID
    + numbered(
        "<link><theta value='{zero}'/><d value='{d}'/><a value='{a}'/>"
        "<alpha value='{alpha}'/></link>"
    ),
    "json": '{"convention": "standard", "units": {"length": "m", "angle": "deg"}, "links": {\n'
    + numbered('"l{i}": {{"theta": {zero}, "d": {d}, "a": {a}, "alpha": {alpha}}},')
    + "}}",
    "decimal commas": SAID
    + numbered("Joint {i}: theta = {zero}, d = {d}, a = {a}, alpha = {alpha}").replace(".", ","),
    "russian": SAID
    + "звено;θ, град;d, м;a, м;α, град\n"
    + "\n".join(f"{i};{t};{d};{a};{al}" for i, t, d, a, al in ROWS).replace(".", ","),
    "masses": lines("{0}\t{1}\t{2}\t{3}\t{4}\t1.5", "\t".join([*NAMES[:4], "alpha", "Masse (kg)"])),
    "tolerances": lines("{0} | {1} | {2} ± 0.001 | {3} | {4}", " | ".join(NAMES)),
}


@pytest.mark.parametrize("form", WRITTEN)
def test_a_table_in_markup_is_read(form):
    found = dh.recognise_table(WRITTEN[form])
    assert len(found.readings) == 1, str(found)
    table = found.arm.table
    assert table.convention == "standard" and table.joints == "RRR"
    numbers = np.array([row[2:] for row in ROWS], float)
    assert np.allclose(np.column_stack([table.d, table.a, np.rad2deg(table.alpha)]), numbers)
    assert np.allclose(np.rad2deg(table.theta), [0, 90, 0])


@pytest.mark.parametrize(
    "said, convention",
    [
        ("convenção clássica", "standard"),
        ("Standardkonvention", "standard"),
        ("quy ước chuẩn", "standard"),
        ("Parameter DH (standar)", "standard"),
        ("修改DH参数", "craig"),
    ],
)
def test_the_convention_is_known_by_its_name_in_other_languages(said, convention):
    text = f"{said}, m\n" + "\n".join(" | ".join(map(str, row)) for row in (NAMES, *ROWS))
    found = dh.recognise_table(text)
    assert len(found.readings) == 1 and found.arm.table.convention == convention


def test_a_column_of_numbers_that_nobody_knows_is_asked_about():
    text = SAID + "\n".join("\t".join(map(str, (*row, 1.5))) for row in ROWS)
    text = text.replace(SAID, SAID + "\t".join([*NAMES, "epsilon_x"]) + "\n")
    with pytest.raises(ValueError, match="epsilon_x"):
        dh.recognise_table(text)


def test_a_minus_in_the_attribute_of_an_element_takes_nothing_from_the_next():
    rows = ((0.0, 0.21, 0.0, 0.0), (0.0, 0.0, 0.05, -1.5707963), (0.0, 0.0, 0.34, -0.5))
    names = ("theta", "d", "a", "alpha")
    told = (" ".join(f'{n}="{value}"' for n, value in zip(names[::-1], row[::-1])) for row in rows)
    elements = "".join(f'  <dh joint="{i}" {one}/>\n' for i, one in enumerate(told, 1))
    found = dh.recognise_table(f'<arm convention="mdh">\n{elements}</arm>\n', angle="rad")
    assert len(found.readings) == 1 and found.arm.table.convention == "craig"
    assert np.allclose(found.arm.table.rows, rows, atol=1e-12)


@pytest.mark.parametrize(
    "said, value", [("7½", 7.5), ("−½", -0.5), ("⅕", 0.2), ("-2¾ in", -2.75), ("π⁄2", np.pi / 2)]
)
def test_a_fraction_of_one_letter_is_added_to_the_number_before_it(said, value):
    assert read_cell(said).value == pytest.approx(value, abs=1e-12)
