"""Joint axes where a table was expected: points and directions, screws, twists."""

import re

__all__ = ["axes_in"]

WORDS = re.compile(
    r"\b(?:ax[ei]s|screws?|twists?|[SB]list|direction\w*|point\w*|through|omega|[wvrq]_?\d)\b",
    re.IGNORECASE,
)
ROWS = re.compile(
    r"\balpha|\btwist angle|\blink (?:twist|length|off)|\bdh(?:\b|_|table|param)", re.IGNORECASE
)
NUMBER = r"[-+]?\s*[\w.+*/()-]+"
TRIPLE = re.compile(rf"[\[({{]\s*(?:{NUMBER}\s*[,; ]\s*){{2}}{NUMBER}\s*[\])}}]")
SIX = re.compile(r"(?:-?\d[\d.]*[\s,;]+){5}-?\d[\d.]*")


def axes_in(source):
    """What to say where the text holds joint axes, no rows; "" of other texts.

    Examples
    --------
    >>> from .source import source_of
    >>> axes_in(source_of("axis (0, 0, 1) through (0, 0, 0)\\naxis (0, 1, 0) through (0, 0, 0.3)"))
    'recognise_table: expected rows of theta, d, a, alpha, found joint axes: a point and a\
 direction each; write them as an axis sheet, and dhlab from-axes (dh.assign_frames) makes the\
 table'
    """
    if not WORDS.search(source.text) or ROWS.search(source.text):
        return ""
    if len(TRIPLE.findall(source.code)) >= 3:
        form = "a point and a direction each"
    elif len(SIX.findall(source.code)) >= 2:
        form = "six numbers each, as screws have them; a screw (w, v) goes through the point w × v"
    else:
        return ""
    return (
        f"recognise_table: expected rows of theta, d, a, alpha, found joint axes: {form}; write"
        " them as an axis sheet, and dhlab from-axes (dh.assign_frames) makes the table"
    )
