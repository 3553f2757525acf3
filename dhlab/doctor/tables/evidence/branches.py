"""What a program does at single joints: adds to theta, ``if joint == 1: theta = theta - pi/2`` or
``dh(q[1] - pi/2, d[1], a[1], alpha[1])`` beside the arrays; or slides, ``if i == 2: T = T @ dh(0,
q[i], a[i], alpha[i])``.
"""

import re
from collections import Counter

from ..language.roles import role_of

__all__ = [
    "added_at_joints",
    "added_in_words",
    "row_of",
    "sliding_at_joints",
    "slid_by_calls",
    "turned_at_joints",
]

CONDITION = r"if\s*\(?\s*(\w+)\s*==\s*(\d+)\s*\)?"
BRANCH = re.compile(
    rf"^[ \t]*(?:el(?:se )?)?{CONDITION}[ \t]*[:{{]?[ \t]*\n?([^\n]*)", re.MULTILINE
)
ANGLE = r"\b(?:theta|th|q)[A-Za-z_]*(?:\[\w+\]|\(\w+\))?(?![\w\[(])"  # of any joint: no theta2
CONSTANT = r"([-+])\s*([\w./*]+)"
ADDED = (
    re.compile(rf"[(,]\s*{ANGLE}\s*{CONSTANT}\s*[,)]"),  # dh(theta - pi/2, d, a, alpha)
    re.compile(rf"^\s*{ANGLE}\s*([-+])=\s*([\w./*]+)\s*;?\s*}}?\s*$"),
    re.compile(rf"^\s*{ANGLE}\s*=\s*{ANGLE}\s*{CONSTANT}\s*;?\s*}}?\s*$"),
)
# q[i] - pi/2 if i == 1 else q[i]
CHOSEN = re.compile(rf"{ANGLE}\s*{CONSTANT}\s+\b{CONDITION}\s+else\b")
# dh(a[1], alpha[1], d[1], q[1] - pi/2)
INDEXED = re.compile(r"[(,]\s*(?:theta|th|q)\w*([\[(])(\d+)[\])]\s*([-+])\s*([\w./*]+)\s*(?=[,)])")
# if elbow == 1 names no joint
NO_ROW = re.compile(
    r"\bif\s*\(?\s*(?!(?:[ijkn]|\w*(?:joint|link|idx|index|count)\w*)\b)\w+\s*==\s*\d+"
)
# theta2 = q[1] - pi/2, q[1] -= pi/2: quarter turns, for others may only move the joint on
QUARTER = r"([-+])=?\s*((?:[\w.*/]*pi\b[\w./*]*|1\.57\d*|3\.14\d*|90|180)(?:\.0*)?)"
ASSIGNED = re.compile(
    rf"^\s*(?:(?:theta|th|q)\w*(?:[\[(]\d+[\])])?\s*=\s*)?(?:theta|th|q)\w*([\[(])(\d+)[\])]"
    rf"\s*{QUARTER}\s*;?\s*$"
)
# dh(a[1], alpha[1], d[1], -q[1])
TURNED = re.compile(r"[(,]\s*-\s*(?:theta|th|q)\w*([\[(])(\d+)[\])]")
MOVING = re.compile(r"\b(?:theta|th|q)\w*\s*[\[(]\s*[A-Za-z_]\w*\s*[\])]")  # of any joint: q[i]
CALL = re.compile(r"(?<!def )\b(\w+)\s*\(((?:[^()\n]|\([^()\n]*\))*)\)")
COMMA = re.compile(r",(?![^(\[]*[)\]])")
ELEMENT, NUMBERED = re.compile(r"(\w+)([\[(])(\d+)[\])]"), re.compile(r"(?:q|d|joint)_?\d")
SET = re.compile(r"^\s*d\w*(?:\[\w+\]|\(\w+\))?\s*(\+?=)(?!=)([^\n;]*)", re.MULTILINE)
ORDINALS = "first second third fourth fifth sixth seventh".split()
TOLD = re.compile(  # the second joint angle has an offset of -90 deg
    rf"\b(?:(?:joint|axis)[ _]?(?P<k>\d)|(?P<nth>{'|'.join(ORDINALS)}) (?:joint|axis))\b"
    r"(?: (?:angle|variable|has|have|with|an?|the|zero|constant|fixed|angular|theta|joint))*"
    r" offset (?:of|is|=) (?P<zero>[-+]?(?:\d[\d.]* ?(?:°|deg(?:rees)?\b)|\d?\*?pi(?:/\d)?\b))",
    re.IGNORECASE,
)
BEFORE = re.compile(rf"{CONDITION}[ \t]*[:{{]?[ \t]*\n?[^\n]*$")
BEHIND = re.compile(rf"\s+{CONDITION}\s+else\b")
FROM_ZERO = r"\bfor\s+{0}\b(?:\s*,\s*(?:\w+|\([\w, ]*\)))?\s+in\s+(?:range|enumerate)\s*\([^,\n]*:"
STARTS = r"\b{0}\s*=\s*(\d+)(?![\d.])"


def added_at_joints(code, indexed=False):
    r"""{row, counted from 0, or None where its count is not told: what is added}.

    Parameters
    ----------
    code : str
    indexed : bool
        Whether calls with indices say it, too: the rows were not read from them.

    Examples
    --------
    >>> added_at_joints("for i in range(6):\n  if i == 1:\n    theta -= pi/2\n")
    {1: '-pi/2'}
    """
    found: dict = {}
    code = NO_ROW.sub("", code)
    for match in BRANCH.finditer(code):
        body = match[3]
        added = next((one for pattern in ADDED if (one := pattern.search(body))), None)
        if added and (added.re is not ADDED[0] or body.count(",") >= 3):
            found[row_of(match[1], match[2], code)] = added[1] + added[2]
    for match in CHOSEN.finditer(code):
        found[row_of(match[3], match[4], code)] = match[1] + match[2]
    for line in code.split("\n") if indexed else ():
        for match in INDEXED.finditer(line) if line.count(",") >= 3 else ():
            found[int(match[2]) - (match[1] == "(")] = match[3] + match[4]
        if match := ASSIGNED.match(line):
            found[int(match[2]) - (match[1] == "(")] = match[3] + match[4]
    return found


def added_in_words(text):
    """{row, counted from 0: what is added}, as sentences say it of single joints.

    Examples
    --------
    >>> added_in_words("The second joint has an offset of -90 deg.")
    {1: '-90 deg'}
    """
    return {
        int(match["k"] or ORDINALS.index(match["nth"].lower()) + 1) - 1: match["zero"]
        for match in TOLD.finditer(text)
    }


def turned_at_joints(code):
    """The rows, counted from 0, whose joint a call takes with a minus.

    Examples
    --------
    >>> turned_at_joints("T = dh(a[1], alpha[1], d[1], -q[1])")
    [1]
    """
    lines = [line for line in code.split("\n") if line.count(",") >= 3]
    found = (match for line in lines for match in TURNED.finditer(line))
    return [int(match[2]) - (match[1] == "(") for match in found]


def sliding_at_joints(code):
    r"""{row, counted from 0, or None where it is not told: whether its own d counts}, of the joints
    whose variable moves d, beside others whose variable turns.

    Examples
    --------
    >>> sliding_at_joints(
    ...     "for i in range(3):\n  if i == 2: T = T @ dh(0, q[i], a[i], b[i])\n"
    ...     "  else: T = T @ dh(q[i], d[i], a[i], b[i])\n"
    ... )
    {2: False}
    """
    moved = {}
    for call in CALL.finditer(code):
        args = COMMA.split(call[2])
        place = next((k for k, arg in enumerate(args) if MOVING.search(arg)), None)
        if len(args) >= 4 and place is not None:
            moved.setdefault((call[1], len(args)), []).append((_branch(call, code), place, args))
    found = {}
    for calls in moved.values():
        usual = {place for branch, place, _ in calls if not branch}
        usual = usual or {Counter(place for _, place, _ in calls).most_common(1)[0][0]}
        for branch, place, args in calls:
            if place not in usual or len(usual) > 1:
                found[_of(branch, code)] = "+" in args[place]
    for one in SET.finditer(code):
        if MOVING.search(one[2]):
            found[_of(_branch(one, code), code)] = "+" in one[1] + one[2]
    return found


def slid_by_calls(code):
    """{row, counted from 0: False} of the calls that take a joint's variable in the place of d, and
    the other three numbers from arrays.

    Examples
    --------
    >>> slid_by_calls("dh(q1, d[0], a[0], alpha[0]) @ dh(th[1], q2, a[1], alpha[1])")
    {1: False}
    """
    found = {}
    for call in CALL.finditer(code):
        args = [arg.strip() for arg in COMMA.split(call[2])]
        elements = [one for arg in args if (one := ELEMENT.fullmatch(arg))]
        variables = [arg for arg in args if NUMBERED.fullmatch(arg)]
        rows = {int(one[3]) - (one[2] == "(") for one in elements}
        roles = {role_of(one[1])[0] for one in elements}
        shape = len(elements), len(variables), len(args), len(rows)
        if shape == (3, 1, 4, 1) and roles == {"theta", "a", "alpha"}:
            found[rows.pop()] = False
    return found


def _branch(match, code):
    """The condition ``name == number`` of the branch in which something stands, or None."""
    return BEFORE.search(code[: match.start()]) or BEHIND.match(code[match.end() :])


def _of(branch, code):
    return row_of(branch[1], branch[2], code) if branch else None


def row_of(name, number, code):
    """The row that ``name == number`` means; None where the text does not say how it counts."""
    if re.search(FROM_ZERO.format(name), code):
        return int(number)
    start = re.search(STARTS.format(name), code)
    return int(number) - int(start[1]) if start else None
