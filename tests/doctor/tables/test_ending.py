"""A text that was cut off within a row is refused: what it has lost is not read as nothing."""

import pytest

from dhlab import recognise_table

ROWS = (("q1", 0.42, 0.06, "-pi/2"), ("q2", 0.0, 0.31, "0"), ("q3", 0.03, 0.045, "-pi/2"))
WRITTEN = {
    "rows": "dh = [  # standard: theta, d, a, alpha\n"
    + ",\n".join(f"  [{t}, {d}, {a}, {al}]" for t, d, a, al in ROWS),
    "links": "L = [\n"
    + ",\n".join(f"  RevoluteDH(d={d}, a={a}, alpha={al})" for _, d, a, al in ROWS),
    "calls": "def dh(theta, d, a, alpha): # standard\n"
    + "\n".join(f"T{i} = dh({t}, {d}, {a}, {al})" for i, (t, d, a, al) in enumerate(ROWS)),
    "table": "standard DH\ni | theta | d | a | alpha\n"
    + "\n".join(f"{i} | {t} | {d} | {a} | {al}" for i, (t, d, a, al) in enumerate(ROWS, 1)),
    "pages": "standard DH\ni  theta  d  a  alpha\n"
    + "\n".join(f"{i}  {t}  {d}  {a}  {al}" for i, (t, d, a, al) in enumerate(ROWS, 1)),
    "names": "# standard DH\n"
    + "\n".join(f"- theta: {t}\n  d: {d}\n  a: {a}\n  alpha: {al}" for t, d, a, al in ROWS),
}


@pytest.mark.parametrize("form", WRITTEN)
def test_a_text_is_refused_when_it_ends_within_a_row(form):
    text = WRITTEN[form]
    last = text.rindex("0.03")
    for at in (last + 4, last + 6, text.rindex("0.045") + 6):
        with pytest.raises(ValueError, match="recognise_table: "):
            recognise_table(text[:at])


@pytest.mark.parametrize("form", WRITTEN)
def test_a_whole_text_is_read(form):
    closing = "\n]" if form in ("rows", "links") else ""
    found = recognise_table(WRITTEN[form] + closing)
    assert [len(reading.arm) for reading in found.readings] == [3]


def test_a_link_matrix_that_is_cut_off_behind_the_rows_takes_nothing_from_them():
    text = WRITTEN["rows"] + "]\ndef link(t, d, a, al):\n  return np.array([[cos(t), -sin(t)*cos(al"
    assert len(recognise_table(text).arm) == 3


def test_a_bracket_behind_a_mark_in_quotation_marks_is_no_open_one():
    text = WRITTEN["rows"] + ']\nlog("read %s rows" % len(dh.rows))\nT = fk(0.1, 0.2, 0.3)\n'
    assert len(recognise_table(text).arm) == 3


CLOSED = {
    "wiki": "{| class='x'\n! i !! theta !! d !! a !! alpha\n"
    + "\n".join(
        f"|-\n| {i} || {t} || {d} || {a} || {al}" for i, (t, d, a, al) in enumerate(ROWS, 1)
    )
    + "\n|}",
    "page": "<table><tr><th>theta</th><th>d</th><th>a</th><th>alpha</th></tr>"
    + "\n".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in ROWS)
    + "\n</table>",
    "tex": "\\begin{tabular}{cccc}\n$\\theta$ & $d$ & $a$ & $\\alpha$ \\\\\n"
    + "\n".join(" & ".join(map(str, row)) + " \\\\" for row in ROWS)
    + "\n\\end{tabular}",
    "xml": "<arm>\n"
    + "\n".join(
        f"<link><theta>{t}</theta><d>{d}</d><a>{a}</a><alpha>{al}</alpha></link>"
        for t, d, a, al in ROWS
    )
    + "\n</arm>",
}


@pytest.mark.parametrize("form", CLOSED)
def test_a_table_without_its_end_is_refused(form):
    whole = CLOSED[form]
    found = recognise_table(whole + "\nstandard DH\n")
    assert [len(reading.arm) for reading in found.readings] == [3]
    with pytest.raises(ValueError, match="nothing closes"):
        recognise_table("standard DH\n" * (form != "xml") + whole[: whole.rindex("\n")])


@pytest.mark.parametrize(
    "tail", ["\n3", "\n3 | q", "\n+---+---", "\n3 | q3 | 0.03 | 0.045"], ids=len
)
def test_a_table_that_ends_with_the_beginning_of_a_row_is_refused(tail):
    text = "standard DH\n+---+----+---+---+---+\n" + WRITTEN["table"].partition("\n")[2]
    text = text[: text.rindex("\n")]
    assert len(recognise_table(text).arm) == 2
    with pytest.raises(ValueError, match="recognise_table: "):
        recognise_table(text + tail)


def test_a_program_that_ends_within_a_word_or_a_call_that_others_begin_with_is_refused():
    text = "\n".join(
        f"chain.addSegment(Segment(Joint(Joint::RotZ), Frame::DH({a}, {al}, {d}, 0)));"
        for _, d, a, al in ROWS
    )
    assert len(recognise_table(text).arm) == 3
    for tail in ("\ncha", "\nchain.addSegm", "\nchain.addSegment(Segment(Joint(Joint::RotZ),\n"):
        with pytest.raises(ValueError, match="ends within"):
            recognise_table(text + tail)


def test_a_row_between_bars_that_has_none_at_its_end_is_refused():
    text = "standard DH\n| theta | d | a | alpha |\n"
    text += "\n".join(f"| {t} | {d} | {a} | {al} |" for t, d, a, al in ROWS)
    assert len(recognise_table(text).arm) == 3
    with pytest.raises(ValueError, match="ends within"):
        recognise_table(text[:-2])
