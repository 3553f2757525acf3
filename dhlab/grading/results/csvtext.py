"""CSV that is safe to open in a spreadsheet: a text that would run as a formula is shown as the
text it is.
"""

import csv
import io
import re
from collections.abc import Iterable

__all__ = ["csv_text"]

# what makes a spreadsheet compute; the wide forms in some of them too
FORMULA = tuple("=+-@\t\r\n＝＋－＠")
# the same within a text, where a spreadsheet ends cells with semicolons or tabs, as in much of
# Europe: to it this is another cell, or another line
# (a quote there is taken for one that begins a cell)
INNER = re.compile(r"([;\t\n][\s\"]*)([=+\-@＝＋－＠])")


def csv_text(rows: Iterable[Iterable[object]]) -> str:
    """Rows as CSV; an apostrophe stands before a text that a spreadsheet would take for a formula.

    Parameters
    ----------
    rows : iterable of iterables
        Texts, numbers (written as they are) and None (an empty cell).

    Examples
    --------
    >>> print(csv_text([["student", "points"], ["=1+1", -0.5]]), end="")
    student,points
    '=1+1,-0.5
    """
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([_cell(value) for value in row] for row in rows)
    return out.getvalue()


def _cell(value):
    if not isinstance(value, str):
        return value
    # a bare carriage return would end the row
    text = value.replace("\r\n", "\n").replace("\r", "\n")
    text = INNER.sub(r"\1'\2", text)
    return f"'{text}" if text.lstrip(" ").startswith(FORMULA) else text
