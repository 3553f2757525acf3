"""Kinds of joints that a text writes as two numbers: which of them slides."""

import re
from dataclasses import replace

from ..cells import Cell

__all__ = ["kinds_by_number", "with_sigma"]


def number_of_sliding(text):
    """ "1" or "0" where the text says that this is a joint that slides, "" where it does not.

    Examples
    --------
    >>> number_of_sliding("0 = revolute, 1 = prismatic"), number_of_sliding("revolute: 1")
    ('1', '0')
    """
    for turns, slides in (("0", "1"), ("1", "0")):
        for number, word in ((slides, "prismatic"), (turns, "revolut")):
            before = rf"\b{number}\s*(?:=|:|->|is|means|for)\s*(?:an? )?\(?['\"]?{word}"
            behind = rf"\b{word}\w*['\"]?\s*(?:=|:|->|is|then)?\s*{number}\b(?!\s*[=:.])"
            if re.search(f"{before}|{behind}", text, re.IGNORECASE):
                return slides
    return "0" if re.search(r"(?:alpha|theta)\W+(?:is_?)?revolut", text, re.IGNORECASE) else ""


def with_sigma(table, source):
    """The table with sigma 1 for joints that slide, where the text says that 1 turns."""
    if "sigma" not in (table.roles or ()) or number_of_sliding(source.text) != "0":
        return table
    k = table.roles.index("sigma")
    rows = [(*r[:k], Cell(1.0 - r[k].value, text=r[k].text), *r[k + 1 :]) for r in table.rows]
    return replace(table, rows=tuple(rows))


def kinds_by_number(kinds, text=""):
    """(kinds, notes) where a column of types has two numbers, 0 and 1: most joints turn, unless the
    text says which number slides.

    Raises
    ------
    ValueError
        There are as many of the one as of the other, or more than two.

    Examples
    --------
    >>> kinds_by_number(("0", "0", "1", "0"))[0]
    ('R', 'R', 'P', 'R')
    """
    numbers = sorted({kind for kind in kinds if kind.isdigit()}, key=kinds.count)
    if known := number_of_sliding(text):
        return tuple(
            ("P" if kind == known else "R") if kind.isdigit() else kind for kind in kinds
        ), ()
    if len(numbers) < 2:
        return tuple("" if kind.isdigit() else kind for kind in kinds), ()
    if len(numbers) > 2 or kinds.count(numbers[0]) == kinds.count(numbers[1]):
        raise ValueError(
            f"recognise_table: expected types R and P, found {', '.join(sorted(numbers))}; which"
            " number is a joint that slides? Write R and P"
        )
    said = {numbers[0]: "P", numbers[1]: "R"}
    note = f"type {numbers[0]} is taken for a joint that slides, {numbers[1]} for one that turns"
    return tuple(said.get(kind, kind) for kind in kinds), (note,)
