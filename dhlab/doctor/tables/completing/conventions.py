"""For which convention a table is, by its heading and by what the rest of the text says; left open
where they contradict each other, or where a matrix stands in the text that cannot be read.
"""

import re
from dataclasses import replace

from ..evidence.conventions import convention_in, defined_in, has_formula
from ..evidence.makers import called_convention
from ..evidence.orders import previous_in
from ..evidence.source import convention_titled

__all__ = ["with_convention"]

NAMES = {"standard": "standard", "craig": "modified (Craig)"}
BY_INDEX = "by the index i-1", "since all headings carry the index"
ELSEWHERE = re.compile(  # conventions are defined in frames.md
    r"\bconventions?\b[^.\n|]{0,60}\b(?:defined|described|given|explained|documented|see)\b"
    r"[^\n|]{0,40}\.(?:md|rst|txt|pdf|tex|py|m|hp?p?|ya?ml)\b",
    re.IGNORECASE,
)
SHIFTED = re.compile(  # T(alpha0, a0, d1, q1)
    r"\([^()\n]*(?<![\w.])(?:alpha_?0\W+a_?0|a_?0\W+alpha_?0)\b[^()\n]*\bd_?1\b[^()\n]*\)"
)


def with_convention(table, source):
    """The table with the convention that its text says, None where that is to be asked."""
    if _has_own_index(table):
        return _by_own_index(table, source)
    if not table.convention:
        return _said(table, source)
    if table.because.startswith(BY_INDEX) and (note := _against_the_heading(table, source)):
        return replace(table, convention=None, because="", notes=(*table.notes, note))
    return table


def _has_own_index(table):
    """Whether the first row has a and alpha, and dashes for theta and d: a0 and alpha0 of a table
    whose row n holds a_n and alpha_n beside theta_n and d_n.
    """
    first = dict(zip(table.roles or (), table.rows[0]))
    empty = all(role in first and first[role].text == "-" for role in ("theta", "d"))
    held = all(role in first and first[role].text != "-" for role in ("a", "alpha"))
    return empty and held and not table.because.startswith(BY_INDEX[0])


def _by_own_index(table, source):
    """The table with its first row for a base where the program, ``T(alpha0, a0, d1, q1)``, or
    numbers in that row say so: each a and alpha follows the theta and d of its row, as in standard
    rows, whatever the program's matrix is. Where nothing does, the convention is to be asked.
    """
    n = len(table.rows)
    first = dict(zip(table.roles, table.rows[0]))
    if SHIFTED.search(source.code) or any(first[role].value for role in ("a", "alpha")):
        because = "as a and alpha follow theta and d of their row: row 0 has them alone"
        kinds = ("fixed", *(table.kinds or ("",) * n)[1:])
        return replace(table, convention="standard", because=because, kinds=kinds)
    note = "row 0 has a and alpha alone: do they stand in the row of their joint, or in the next?"
    return replace(table, convention=None, because="", notes=(*table.notes, note))


def _against_the_heading(table, source):
    """What of the text is against the index in the table's heading; "" where nothing is."""
    computed = convention_in(source)
    if not computed and not source.convention and has_formula(source.text):
        return "a link matrix of the text could not be read, and may be another than the heading's"
    if not table.because.startswith(BY_INDEX[0]):
        if _said(replace(table, convention=None), source).convention == "craig":
            return "the headings carry the index i, as standard rows do, and the text says Craig's"
        if not computed and not source.convention and ELSEWHERE.search(source.text):
            return "the text leaves the convention to another file"
        return ""
    told = "the index i-1 in the header is Craig's, and the text"
    if computed and computed[0] == "standard":
        return f"{told} computes or names the other"
    return f"{told} speaks of the standard rows" if source.convention == "standard" else ""


def _said(table, source):
    """The table with the convention that the text computes, calls, names or defines."""
    computed = convention_in(source)
    if computed and source.convention and computed[0] != source.convention:
        told, found = NAMES[source.convention], NAMES[computed[0]]
        note = f"the text names the {told} convention, and its program computes the {found} one"
        return replace(table, notes=(*table.notes, note))
    if computed:
        return replace(table, convention=computed[0], because=computed[1])
    if called := called_convention(source.code):
        return replace(table, convention=called, because="as the call in the text says")
    if table.why == "as the comment says" and previous_in(source):
        return replace(table, convention="craig", because="by the index i-1 in the comment")
    if source.convention and has_formula(source.text):
        told = f"the text names the {NAMES[source.convention]} convention, and its link matrix"
        return replace(table, notes=(*table.notes, f"{told} could not be read"))
    if source.convention:
        return replace(table, convention=source.convention, because="as the text says")
    if defined := defined_in(source):
        return replace(table, convention=defined, because="as the text defines a and alpha")
    first = table.lines[0] if table.lines else 0
    if titled := "" if has_formula(source.text) else convention_titled(source, first):
        return replace(table, convention=titled, because="as the title of the table says")
    return table
