"""Every reading of a pasted table that its text allows: order, convention, units, extra rows."""

from dataclasses import dataclass
from itertools import product

import numpy as np

from ...arm import Arm
from ...kinematics import link_matrices
from ...table import COLUMNS, DHTable
from .columns import angle_units, length_units, orders, snapped

__all__ = ["QUESTIONS", "Reading", "readings"]

QUESTIONS = {
    "order": "In which order do the columns stand",
    "convention": "For which matrix are the rows, the standard or Craig's (modified) one?",
    "angle": "Are the angles degrees or radians?",
    "length": "Are the lengths metres or millimetres?",
    "row": (
        "Does a row without a joint (base or flange) stand among these, or does each row have a"
        " motor?"
    ),
}


@dataclass(frozen=True)
class Reading:
    """One way to read a table: the arm, the way in words, what had to be assumed, and which answer
    to each question leads here.

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

    def __str__(self):
        return self.words


def readings(table, order, convention, angle, length, right):
    """Every reading that the text allows, the likeliest first."""
    for roles, why in orders(table, order):
        columns = {role: [row[k] for row in table.rows] for k, role in enumerate(roles)}
        conventions = [convention] if convention else ["standard", "craig"]
        if not convention and _looks_like_craig(columns):
            conventions.reverse()
        choices = product(
            conventions,
            angle_units(table, columns, angle),
            length_units(table, columns, length),
            _extra_rows(table, columns, right),
        )
        for name, unit, metre, extra in choices:
            yield _reading(table, columns, roles, why, name, unit, metre, extra)


def _looks_like_craig(columns):
    """The first row without a and alpha, the last row with: a Craig table more often than not."""
    first, last = ([columns[role][k].value for role in ("a", "alpha")] for k in (0, -1))
    return not any(first) and any(last)


def _extra_rows(table, columns, right):
    """Which rows have no joint: ("", "base" or "tool") by labels, by the missing variable, or by
    the number of joints asked for.
    """
    n = len(table.rows)
    named = "base" if table.labels[0] in ("base", "0 (base)") else ""
    named = named or (
        "tool"
        if any(word in table.labels[-1] for word in ("flange", "tool", "hand", "ee", "end"))
        else ""
    )
    moves = [any(not columns[role][i].is_constant for role in columns) for i in range(n)]
    fixed = (
        [not moved for moved in moves] if any(moves) else [kind == "fixed" for kind in table.kinds]
    )
    if n < 2:
        return [""]
    if named or (sum(fixed) == 1 and (fixed[0] or fixed[-1])):
        return [named or ("base" if fixed[0] else "tool")]
    if right is not None and n == len(right) + 1 and not any(moves):
        return ["base", "tool"]
    if table.labels[0] == "0" and not any(moves):
        return ["", "base"]
    return [""]


def _reading(table, columns, roles, why, convention, unit, metre, extra):
    assumed = []
    numbers = {
        role: np.array([_scaled(cell, role, unit, metre, assumed) for cell in column])
        for role, column in columns.items()
        if role != "sigma"
    }
    numbers["theta"] = numbers["theta"] + numbers.pop("offset", 0)
    joints = [_joint(table, columns, i) for i in range(len(table.rows))]
    signs = [_sign(columns, i) for i in range(len(table.rows))]
    rows = np.column_stack([numbers[role] for role in COLUMNS])
    order = f"columns {', '.join(role for role in roles if role in numbers)}, {why}"
    return Reading(
        _arm(convention, rows, joints, signs, extra),
        f"{order}; {_words(convention, unit, metre)}{EXTRA[extra]}",
        tuple(dict.fromkeys(assumed)),
        tuple(zip(QUESTIONS, (roles, convention, unit, metre, extra))),
    )


EXTRA = {
    "": "",
    "base": "; the first row has no joint and is the base",
    "tool": "; the last row has no joint and is the flange",
}


def _words(convention, unit, metre):
    """Convention and units, in words."""
    units = {
        "deg": "degrees",
        "rad": "radians",
        "mixed": "radians, with numbers beyond 2π as degrees",
    }[unit]
    book = "Craig (modified)" if convention == "craig" else "standard"
    return f"{book} convention; {units}; {'millimetres' if metre == 'mm' else 'metres'}"


def _sign(columns, i):
    """How the joint variable of row i counts."""
    moving = [columns[role][i] for role in ("theta", "d") if not columns[role][i].is_constant]
    return moving[0].sign if moving else 1


def _scaled(cell, role, unit, metre, assumed):
    if role in ("d", "a"):
        return (
            cell.value
            * {"mm": 1e-3, "cm": 1e-2, "m": 1.0}[
                cell.unit if cell.unit in ("mm", "cm", "m") else metre
            ]
        )
    in_degrees = cell.unit == "deg" or (
        cell.unit != "rad" and (unit == "deg" or (unit == "mixed" and abs(cell.value) > 2 * np.pi))
    )
    if in_degrees:
        return np.deg2rad(cell.value)
    value, said = snapped(cell.value) if cell.unit != "rad" else (cell.value, "")
    assumed.extend([said] if said else [])
    return value


def _joint(table, columns, i):
    if table.kinds[i] in ("R", "P"):
        return table.kinds[i]
    if "sigma" in columns:
        return "P" if columns["sigma"][i].value else "R"
    return "P" if not columns["d"][i].is_constant and columns["theta"][i].is_constant else "R"


def _arm(convention, rows, joints, signs, extra):
    kept = (
        slice(1, None) if extra == "base" else slice(None, -1) if extra == "tool" else slice(None)
    )
    fixed = {"base": rows[0], "tool": rows[-1]}.get(extra)
    ends = {} if fixed is None else {extra: link_matrices(convention, *fixed)}
    table = DHTable(convention, *rows[kept].T, "".join(joints[kept]))
    return Arm(table, sign=signs[kept], **ends)
