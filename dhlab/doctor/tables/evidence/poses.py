"""What the numbers in a column theta are: zeros that are added to the joints' values, or the values
of one pose, of which the zeros are 0.
"""

import re
from dataclasses import replace

import numpy as np

from ..cells import BESIDE, cell_or_none
from ..language.brackets import cells_in
from ..language.expressions import key
from ..language.letters import unified
from ..language.roles import role_of

__all__ = [
    "adds_each",
    "adds_theta",
    "holds_joint_values",
    "multiplied_out",
    "poses_in",
    "require_pose",
    "theta_meanings",
    "with_given_angles",
]

LISTED = re.compile(
    r"\b(q(?![a-z]*lim)\w*|joint\w*|angles?\w*|pose\w*|config\w*)[ \t]*[=:][ \t]*[\w.]*\(?"
    r"[\[({]([^\[\](){}=]{3,200})[\])}]",
    re.IGNORECASE,
)
ZEROS = re.compile(r"off|zero|bias|lim|min|max|type|name|sign|dir", re.IGNORECASE)
ADDED = re.compile(
    r"theta[_ -]?(?:off(?:set)?|zero)s?\b|\bq\w*(?:[\[(]\w+[\])])?\s*\+\s*\w*theta"
    r"|\btheta\w*(?:[\[(]\w+[\])])?\s*\+\s*(?:q|joint)",
    re.IGNORECASE,
)
ANGLE = r"(?<![\w.])(?:q|thetas?|th|joint\w*|angles?)\w{0,9}(?:\[\w+\]|\(\w+\))?"
ZERO = r"(?:\w+(?:[\[(]\w+[\])])?(?:\.|->))?\w*(?:off(?:set)?s?|zeros?|theta_?0?)\w*"
EACH = re.compile(  # q[i] + dh.offset
    rf"{ANGLE}\s*\+\s*{ZERO}|(?<![\w.]){ZERO}(?:[\[(]\w+[\])])?\s*\+\s*{ANGLE}", re.IGNORECASE
)
PRINTED = re.compile(r"\b(?:print\w*|disp|pprint|cout|console\.log|display|show)\b")
SOME = re.compile(
    r"\bif\b[^\n]*(?:[<>]|fixed|joint)|\bfixed\b|\?", re.IGNORECASE
)  # not at all of them
WITH_Q = ("SymPyBotics",)  # forms in which a joint's theta is written q + zero
QUARTER_OFF = np.deg2rad(3)  # a zero found by measuring is no further from a quarter turn
LEAST_ODD = 2  # rows with angles that are no quarter turns: one arm may have one such bend


def poses_in(source):
    """The lists of numbers that the text calls joint values.

    Examples
    --------
    >>> from .source import source_of
    >>> poses_in(source_of("for q = [0, -1.57, 0.5]:"))
    ((0.0, -1.57, 0.5),)
    """
    found = []
    for name, inside in LISTED.findall(source.text):
        values = [source.value(cell) for cell in cells_in(inside)]
        if not ZEROS.search(name) and all(one is not None and not one.letters for one in values):
            found.append(tuple(one.number for one in values))
    return tuple(found)


def holds_joint_values(name, source):
    """Whether an array has joints' values that the text takes one by one, as q(1) and q(2).

    Examples
    --------
    >>> from .source import source_of
    >>> text = "q = [0, 0.1]\\ndh = [[q[0], 0, 0.3, 0], [q[1], 0, 0, 0]]"
    >>> holds_joint_values("q", source_of(text))
    True
    """
    element = key(f"{name}[0]")
    taken = re.compile(rf"(?<![\w.]){re.escape(name)}[\[(]\d+[\])]")
    values = element in source.assigned and element not in source.known
    return bool(name and values and taken.search(source.code))


def require_pose(table, source):
    """Numbers that the program gives to theta[0], theta[1] … are no zeros, as quarter turns may be.

    Raises
    ------
    ValueError
        They are quarter turns, under a name that zeros may have too.
    """
    for row in table.rows:
        for cell in row:
            name = cell.letters[0][0] if cell.letters else ""
            if not re.match(r"(?:thetas?|th|phi)\[", name.lower()) or name not in source.assigned:
                continue
            value = cell_or_none(str(source.assigned[name]))
            if value is not None and value.value and not _is_odd(value.value):
                raise ValueError(
                    f"recognise_table: the program gives {name} the number {value.text}; is it a"
                    " zero that is added to the joint's value, or where the joint stands? Write"
                    f" q + ({value.text}) or q into the row"
                )


def adds_theta(source):
    """Whether the text says that the numbers of theta are zeros.

    Examples
    --------
    >>> from .source import source_of
    >>> adds_theta(source_of("# theta_offset, d, a, alpha")), adds_theta(source_of("theta, d, a"))
    (True, False)
    """
    return bool(ADDED.search(source.text))


def adds_each(code):
    """Whether a program adds a joint's value to the zero of each row, in a loop over all of them:
    then every row has a joint.

    Examples
    --------
    >>> adds_each("for i, dh in enumerate(rows): T = T @ link(q[i] + dh.offset, dh.d, dh.a)")
    True
    """
    looped = re.search(r"\bfor\b|\bmap\b|\bfold\b|each\b|\bwhile\b", code)
    return bool(looped and EACH.search(code)) and not SOME.search(code)


def multiplied_out(code):
    """Whether a program multiplies the links together, prints what comes of it, and names no
    joint's variable but the parameter of its functions: its angles are one pose, or zeros.

    Examples
    --------
    >>> multiplied_out("A = dh(0.1, 1.57)\\nB = dh(0.2, 0)\\nprint(A @ B)")
    True
    >>> multiplied_out("A = dh(0.1, q1 + 1.57)\\nB = dh(0.2, q2)\\nprint(A @ B)")
    False
    """
    product = re.search(r"@|\bdot\b|\bmat_?mul\b|\bmultiply\b|[A-Za-z]\w*\s*\*\s*[A-Z]", code)
    moving = re.search(r"(?<![\w.])(?:q|thetas?|th|joint\w*?|angles?)_?(?:\d|[\[(]\w)", code)
    return bool(product and PRINTED.search(code)) and not moving


def with_given_angles(table, source):
    """The table of calls with the numbers that the program gives to their angles by name, ``theta1
    = 90``, for one pose or zeros; as it is where a call has another angle.
    """
    if not table.roles or "theta" not in table.roles or any(table.kinds):
        return table
    k, rows = table.roles.index("theta"), []
    for row in table.rows:
        named = re.fullmatch(r"[A-Za-z]\w*?_?\d", row[k].text.strip())
        of_angle = named and named[0][0].lower() != "q" and role_of(named[0])[0] == "theta"
        given = cell_or_none(str(source.assigned.get(key(named[0])))) if of_angle else None
        if given is None or not given.is_constant:
            return table
        rows.append((*row[:k], given, *row[k + 1 :]))
    if not any(row[k].value for row in rows):
        return table
    return replace(table, rows=tuple(rows), kinds=("R",) * len(rows), posed=True)


def theta_meanings(table, columns):
    """ "zeros", "pose" or both, the likelier first."""
    cells = columns["theta"]
    values = [cell.value for cell in cells]
    if table.replaced or (table.posed and any(values) and not table.adds):
        return ["pose", "zeros"]
    if table.roles and any(BESIDE.fullmatch(unified(cell.text)) and cell.value for cell in cells):
        return ["zeros", "pose"]
    letters = any(not cell.is_constant for role in ("theta", "d") for cell in columns[role])
    if table.form in WITH_Q and any(values) and not letters:
        return ["zeros", "pose"]
    odd = [round(abs(value), 3) for value in values if _is_odd(value)]
    if not odd or table.form or not all(cell.is_constant for cell in cells):
        return ["zeros"]
    if any(len(one) == len(values) and np.allclose(one, values, atol=1e-3) for one in table.poses):
        return ["pose", "zeros"]
    named = table.roles is not None and "theta" in table.roles
    beside = any(cell.value for cell in columns.get("offset", ()))
    doubtful = beside or (len(odd) >= LEAST_ODD and not table.adds)
    return ["zeros", "pose"] if named and doubtful else ["zeros"]


def _is_odd(value):
    """Whether a number is no quarter turn, neither in degrees nor in radians."""
    turns = np.array([np.deg2rad(value), value]) / (np.pi / 2)
    off = np.abs(turns - np.round(turns)) * np.pi / 2
    return not (off[1] < QUARTER_OFF or (off[0] < QUARTER_OFF and abs(value) > 2 * np.pi))
