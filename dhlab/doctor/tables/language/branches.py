"""What a program adds to theta at one joint only: ``if joint == 1: theta = theta - pi/2``."""

import re

__all__ = ["added_in_branches"]

BRANCH = re.compile(
    r"^[ \t]*(?:el(?:se )?)?if\s*\(?\s*(\w+)\s*==\s*(\d+)\s*\)?[ \t]*[:{]?[ \t]*\n?([^\n]*)",
    re.MULTILINE,
)
ANGLE = r"\b(?:theta|th|q)\w*(?:\[\w+\]|\(\w+\))?"
ADDED = (
    re.compile(rf"[(,]\s*{ANGLE}\s*([-+])\s*([\w./*]+)\s*[,)]"),  # dh(theta - pi/2, d, a, alpha)
    re.compile(rf"^\s*{ANGLE}\s*([-+])=\s*([\w./*]+)\s*;?\s*$"),
    re.compile(rf"^\s*{ANGLE}\s*=\s*{ANGLE}\s*([-+])\s*([\w./*]+)\s*;?\s*$"),
)
FROM_ZERO = r"\bfor\s+{0}\b(?:\s*,\s*\w+)?\s+in\s+(?:range|enumerate)\s*\([^,\n]*:"
STARTS = r"\b{0}\s*=\s*(\d+)(?![\d.])"


def added_in_branches(code):
    r"""{row, counted from 0, or None where its count is not told: what is added}.

    Examples
    --------
    >>> added_in_branches("for i in range(6):\n  if i == 1:\n    theta -= pi/2\n")
    {1: '-pi/2'}
    """
    found: dict = {}
    for match in BRANCH.finditer(code):
        body = match[3]
        added = next((one for pattern in ADDED if (one := pattern.search(body))), None)
        if added and (added.re is not ADDED[0] or body.count(",") >= 3):
            first = _first(match[1], code)
            found[None if first is None else int(match[2]) - first] = added[1] + added[2]
    return found


def _first(name, code):
    """From which number a name counts; None where the text does not say."""
    if re.search(FROM_ZERO.format(name), code):
        return 0
    start = re.search(STARTS.format(name), code)
    return int(start[1]) if start else None
