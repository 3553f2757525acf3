"""What the words of a text and its own functions say of the rows that were read: convention, units,
joints, poses; and where one row stands for many.
"""

import re
from dataclasses import replace

from ..evidence.poses import adds_each, adds_theta, poses_in
from ..meaning.scales import measured_in, multiples_said, takes_thousandths, the_measure
from .accounted import counts_in, joints_said, speaks_of_sliding
from .conventions import with_convention

__all__ = ["OF_ANGLES", "with_words"]

OF_ANGLES = re.compile(r"\b(?:cos|sin)[df]?(?:\s*[({]|theta|alpha)")
LOOP = re.compile(r"\bfor\b[^\n]*(?:\bin\b|[=;])|\]\s*\*\s*\w")


def with_words(table, source):
    """What the words of the text and its own functions add to what the dialect says."""
    if len(table.rows) == 1 and not table.form and OF_ANGLES.search(source.code):
        raise ValueError(
            "recognise_table: expected the rows of a table, found a link matrix and one row; is it"
            " the last row of the matrix? Paste the rows of all links"
        )
    if len(table.rows) == 1 and LOOP.search(source.code):
        raise ValueError(
            "recognise_table: expected the rows of all links, found one row and a loop; does it"
            " make the row several times? Write a row for each link"
        )
    if not (table.roles or any(cell.value or cell.letters for row in table.rows for cell in row)):
        raise ValueError(
            "recognise_table: expected a table, found zeros only, as of an arm that stands at"
            " q = 0; paste the rows with the lengths and angles"
        )
    return _with_sayings(with_convention(table, source), source)


def _with_sayings(table, source):
    """The table with what words of the text say of its units and joints."""
    multiple = multiples_said(source, table.rows)
    return replace(
        table,
        length=table.length or source.length or measured_in(source.text, table.rows, table.roles),
        angle=table.angle or source.angle,
        measured=the_measure(source.text),
        joints=counts_in(source),
        worded=tuple(joints_said(source)),
        poses=poses_in(source),
        adds=adds_theta(source),
        each=adds_each(source.code),
        slides=speaks_of_sliding(source),
        scaled=takes_thousandths(source.code),
        multiple=multiple,
        notes=(*table.notes, f"a comment multiplies lengths: {multiple[:60]!r}")
        if multiple
        else table.notes,
    )
