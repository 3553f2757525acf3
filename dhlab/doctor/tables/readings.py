"""Every reading of a pasted table that its text allows: order, convention, units, rows without a
joint.
"""

from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from ...arm import Arm
from ...kinematics import link_matrices
from ...table import COLUMNS, DHTable
from .chain import arm_of, rows_of
from .evidence.poses import theta_meanings
from .meaning.columns import orders, snapped
from .meaning.joints import joints_of, require_one_column, require_values, rows_of_d
from .meaning.scales import UNIT_WORDS, angle_units, in_metres, in_radians, length_units
from .meaning.still import on_one_axis, unwritten

__all__ = ["BOOKS", "QUESTIONS", "NoOrder", "Reading", "arm_of_rows", "readings", "require_some"]

QUESTIONS = {
    "order": "In which order do the columns stand",
    "convention": "For which matrix are the rows, the standard or Craig's (modified) one?",
    "angle": "Are the angles degrees or radians?",
    "length": "In which unit are the lengths",
    "row": (
        "Does a row without a joint (base, flange or a fixed frame) stand among these, or does each"
        " row have a motor?"
    ),
    "zero": (
        "Are the numbers of theta added to the joints' values, or are they these in one pose?"
    ),
    "index": "Does each d belong to its own row, or to the row above, as the index i-1 says?",
    "form": "How is the text meant",
}
BOOKS = {"standard": "standard convention", "craig": "Craig (modified) convention"}


@dataclass(frozen=True)
class Reading:
    """One way to read a table: the arm, the way in words, what had to be assumed, and which answer
    to each question leads here; notes are worth a second look.

    Examples
    --------
    >>> import dhlab as dh
    >>> found = dh.recognise_table("0 0.1 0 90\\n0 0 0.4 0")
    >>> found.readings[0].arm.table.convention
    'standard'
    """

    arm: Arm
    words: str
    assumptions: tuple = ()
    choices: tuple = ()
    notes: tuple = ()

    def __str__(self):
        return self.words


class NoOrder(ValueError):
    """In no order of the columns are they two of angles and two of lengths."""


def require_some(found, table):
    """There are readings.

    Raises
    ------
    ValueError
        There are none: what the rows lack.
    """
    if not found:
        require_one_column(table.rows)
        require_values(table)
        raise NoOrder(
            "recognise_table: expected two columns of angles and two of lengths, found no order in"
            ' which the columns are that; say the order, as in order="theta d a alpha"'
        )


def readings(table, order, convention, angle, length, right, tidy):
    """Every reading that the text allows, the likeliest first."""
    for found in orders(table, order):
        columns = {role: [row[k] for row in table.rows] for k, role in enumerate(found.roles)}
        for role in ("theta", "d", "a", "alpha"):
            columns.setdefault(role, [])
        columns = _with_own_units(columns, table.units)
        if table.zeros:
            columns["offset"] = _zeros(columns, table.zeros)
        silent = unwritten(table, columns, right)
        either = list(_conventions(table, columns, convention, found))
        for said in either:
            choices = product(
                [said],
                angle_units(table, columns, angle),
                length_units(table, columns, length),
                on_one_axis(table, columns, said[0], silent, len(either) > 1),
                theta_meanings(table, columns),
                rows_of_d(table, columns),
            )
            for choice in choices:
                yield _reading(table, columns, found, choice, tidy)


def _with_own_units(columns, units):
    """The columns, where the headings give two of them different units, with these at the cells."""
    for kinds in (("theta", "alpha", "offset"), ("d", "a")):
        if len({units[role] for role in kinds if role in units}) > 1:
            for role in kinds:
                unit = units.get(role, "")
                columns[role] = [
                    replace(cell, unit=cell.unit or unit) for cell in columns.get(role, ())
                ]
    return columns


def _zeros(columns, beside):
    """The column of zeros with those that stand beside the rows."""
    own = columns.get("offset") or [None] * len(beside)
    for i, (angle, cell) in enumerate(zip(columns["theta"], beside)):
        if cell.value and angle.value:
            raise ValueError(
                f"recognise_table: row {i + 1} has a zero of its own, {angle.text}, and"
                f" {cell.text} stands beside the rows; is it added? Leave one of them out, or add"
                " them up"
            )
    return [cell if cell.value or not other else other for cell, other in zip(beside, own)]


def _conventions(table, columns, given, order):
    """(convention, why) as somebody says it, or both, the likelier first."""
    if given:
        return [(given, "as you say")]
    if order.convention:
        return [(order.convention, order.because)]
    if table.convention:
        return [(table.convention, table.because or "as the text says")]
    both = [("standard", ""), ("craig", "")]
    return both[::-1] if _looks_like_craig(columns) else both


def _said_twice(columns):
    """What is assumed of a column of offsets that stand in theta too, as in q2 - 90 beside -90."""
    angles, zeros = columns["theta"], columns.get("offset", ())
    if not any(cell.value for cell in zeros) or any(
        cell.value != zero.value or (cell.value and cell.unit != zero.unit) or cell.is_constant
        for cell, zero in zip(angles, zeros)
    ):
        return []
    return ["the offsets stand in theta and in a column of their own, and count once"]


def _looks_like_craig(columns):
    """The first row without a and alpha, the last row with: a Craig table more often than not."""
    first, last = (
        [bool(columns[role][k].value or columns[role][k].letters) for role in ("a", "alpha")]
        for k in (0, -1)
    )
    return not any(first) and any(last)


def _reading(table, columns, order, choice, tidy):
    (convention, known), (unit, angle_why), (metre, length_why), still, zero, (index, lengths) = (
        choice
    )
    columns = {**columns, "d": lengths}
    joints, signs = joints_of(table, columns, still)
    assumed = []
    rows = np.column_stack(
        [
            [_angle(cell, role, unit, tidy, assumed) for cell in columns[role]]
            if role in ("theta", "alpha")
            else [in_metres(cell, metre) for cell in columns[role]]
            for role in COLUMNS
        ]
    )
    if zero == "pose":
        rows[[letter == "R" for letter in joints], 0] = 0.0
    twice = _said_twice(columns)
    for i, cell in enumerate(() if twice else columns.get("offset", ())):
        if joints[i] == "P":
            rows[i, 1] += in_metres(cell, metre)
        else:
            rows[i, 0] += _angle(cell, "theta", unit, tidy, assumed)
    shown = [role for role in order.roles if role in COLUMNS or role == "offset"]
    words = [
        *([table.form] if table.form else []),
        f"columns {', '.join(shown)}, {order.why}",
        BOOKS[convention] + (f", {known}" if known else ""),
        UNIT_WORDS[unit] + _why(angle_why),
        UNIT_WORDS[metre] + _why(length_why),
        *_row_words(still, len(rows)),
        *(["theta being the joints' values in one pose"] if zero == "pose" else []),
        *(["each d belonging to the row above"] if index == "above" else []),
    ]
    return Reading(
        arm_of_rows(convention, rows, joints, signs, _limits(table, joints, unit, metre)),
        "; ".join(words),
        tuple(dict.fromkeys([*assumed, *twice])),
        tuple(zip(QUESTIONS, (order.roles, convention, unit, metre, still, zero, index, ""))),
    )


def _why(text):
    return f" {text}" if text.startswith("by") else f", {text}" if text else ""


def _angle(cell, role, unit, tidy, assumed):
    value = in_radians(cell, unit)
    if cell.unit == "rad" and "pi" in cell.text.lower():
        return value
    exact, name = snapped(value)
    if exact is None or abs(value - exact) < 1e-9:
        return value if exact is None or not tidy else exact
    if tidy:
        assumed.append(f"{cell.value:.6g} is taken for {name}, as asked")
        return exact
    if abs(value - exact) < 2e-4:
        assumed.append(f"{cell.value:.10g} is meant as it stands; tidied, it would be {name}")
    return value


def _row_words(still, n):
    """What is said of rows without a variable."""
    fixed = [i for i, letter in still if not letter]
    words = [f"the joint of row {i + 1} slides" for i, letter in still if letter == "P"]
    if not fixed:
        return words
    if set(fixed) == {0}:
        return ["the first row has no joint and is the base", *words]
    if set(fixed) == {n - 1}:
        return ["the last row has no joint and is the flange", *words]
    return [f"rows without a joint: {', '.join(str(i + 1) for i in fixed)}", *words]


def _limits(table, joints, unit, metre):
    """The limits of the joints in radians and metres, None where the text has none."""
    pairs = table.limits or [None] * len(joints)
    scaled = [
        pair
        and tuple(
            in_metres(cell, metre) if letter == "P" else in_radians(cell, unit) for cell in pair
        )
        for pair, letter in zip(pairs, joints)
    ]
    scaled = [pair if pair and pair[0] < pair[1] else None for pair in scaled]
    return scaled if any(scaled) else None


def arm_of_rows(convention, rows, joints, signs, limits=None):
    """The Arm of rows; those without a joint, letter "", are its base, its tool, or a link's."""
    moving = [i for i, letter in enumerate(joints) if letter]
    if not moving:
        raise ValueError(
            "recognise_table: expected at least one joint, found rows without a joint variable only"
        )
    first, last = moving[0], moving[-1] + 1
    kept = slice(first, last)
    limits = None if limits is None else [limits[i] for i in moving]
    limits = limits if limits and any(limits) else None
    if len(moving) < last - first:
        steps = list(rows_of(convention, rows, joints, signs))
        return Arm(**{**_parts(arm_of(steps, convention)), "limits": limits})
    ends = {}
    for name, part in (("base", rows[:first]), ("tool", rows[last:])):
        if len(part):
            T = np.eye(4)
            for row in part:
                T = T @ link_matrices(convention, *row)
            ends[name] = T
    table = DHTable(convention, *rows[kept].T, "".join(joints[kept]))
    return Arm(table, sign=signs[kept], limits=limits, **ends)


def _parts(arm):
    return {"table": arm.table, "base": arm.base, "tool": arm.tool, "sign": arm.sign}
