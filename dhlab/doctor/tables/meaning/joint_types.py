"""Kinds of joints that a text writes as two numbers, or makes one by one, as MATLAB does."""

import re
from dataclasses import replace

from ..cells import Cell
from ..language.words import KINDS
from .columns import IMPLIED

__all__ = ["kinds_by_number", "kinds_by_star", "with_made_joints", "with_sigma"]

# setFixedTransform(body3.Joint, dh(3,:), 'dh'), setFixedTransform(jnt1, [0 pi/2 0 0], 'dh')
FIXED_TRANSFORM = re.compile(
    r"\bsetFixedTransform\s*\(\s*([A-Za-z_][\w.]*(?:\{\d+\}[\w.]*)?)\s*,\s*(?:\w+\((\d+)\s*,\s*:\)|\[)"
)
STAR = re.compile(r"^[^*]+\*$")  # 0.15*
JOINT_MADE = r"(?<![\w.]){}\s*=\s*rigidBodyJoint\s*\(\s*[^,()]+(?:,\s*['\"](\w+)['\"]\s*)?\)"


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


def kinds_by_star(kinds, rows, roles):
    """(kinds, notes) of rows with a star behind a number: behind each theta it marks a joint that
    turns; behind others it is a footnote's, where the row has a variable.

    Raises
    ------
    ValueError
        The star may mark the joint that slides, or rows without it may have no joint.
    """
    starred = [
        {role for role, cell in zip(roles, row) if cell.is_constant and STAR.search(cell.text)}
        for row in rows
    ]
    if not any(starred) or "theta" not in roles:
        return kinds, ()
    k = roles.index("theta")
    marked = ["theta" in one for one in starred]
    for i, (row, one) in enumerate(zip(rows, starred)):
        still = row[k].is_constant and row[k] != IMPLIED and not kinds[i]
        if still and (any(marked) != marked[i] or (one == {"d"} and not marked[i])):
            raise ValueError(
                f"recognise_table: row {i + 1}: does the star behind a number mark the joint's"
                " variable, or a footnote? Write q for theta, or d + 0.1 for d, where a joint"
                " moves, and no star elsewhere"
            )
    if all(marked):
        return tuple(kind or "R" for kind in kinds), ("a star behind theta marks the variable",)
    return kinds, ("a star behind a number is taken for a footnote's: look what it says",)


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


def with_made_joints(table, source):
    """The table of ``setFixedTransform`` with the types of the joints that its calls name, row by
    row: one that ``rigidBodyJoint`` makes, or the own joint of a body, which does not move.
    """
    calls = list(FIXED_TRANSFORM.finditer(source.code))
    rows = [int(call[2]) if call[2] else k for k, call in enumerate(calls, 1)]
    if rows != [*range(1, len(table.rows) + 1)] or any(table.kinds):
        return table
    kinds = [_made(call[1], source.code[: call.start()]) for call in calls]
    return table if None in kinds else replace(table, kinds=tuple(kinds))


def _made(joint, before):
    """The kind of the joint of a call by what the program did before it; None where that says
    nothing.
    """
    made = re.findall(JOINT_MADE.format(re.escape(joint)), before)
    if made:
        return KINDS.get((made[-1] or "fixed").lower())
    if not joint.lower().endswith(".joint"):
        return None
    given = re.findall(rf"(?<![\w.]){re.escape(joint)}\s*=\s*([A-Za-z_][\w.]*)\s*[;\n]", before)
    return _made(given[-1], before) if given and given[-1] != joint else "fixed"
