"""What differs between two arms, in words."""

import numpy as np

from ....printing import number
from ....table import COLUMNS
from ...mistakes.remade import ALPHA, THETA

__all__ = [
    "changed_numbers",
    "coupling_texts",
    "difference_text",
    "end_text",
    "moved_by",
    "number_text",
    "wrapped",
]

MOST_SHOWN = 8


def difference_text(wrong, right):
    """What stood there and what should."""
    if wrong.table.convention != right.table.convention:
        return f"the rows are {right.table.convention}"
    if wrong.table.joints != right.table.joints:
        return f"the joints are {right.table.joints}"
    was, should = wrong.table.rows, right.table.rows
    changed = changed_numbers(wrong, right)
    if len(changed) > MOST_SHOWN:
        return f"{len(changed)} numbers of the table change"
    parts = [f"{COLUMNS[c]}{i + 1} {number_text(was[i, c], should[i, c], c)}" for i, c in changed]
    parts += [
        f"joint {i + 1} counts the other way" for i in np.flatnonzero(wrong.sign != right.sign)
    ]
    parts += coupling_texts(wrong, right)
    parts += [
        end_text(wrong, right, end)
        for end in ("base", "tool")
        if not np.allclose(getattr(wrong, end), getattr(right, end), atol=1e-9) and not parts
    ]
    return "; ".join(parts)


def changed_numbers(wrong, right):
    """The (row, column) of every number that differs, angles by more than whole turns."""
    apart = wrong.table.rows - right.table.rows
    apart[:, [THETA, ALPHA]] = wrapped(apart[:, [THETA, ALPHA]])
    return np.argwhere(np.abs(apart) > 1e-9)


def coupling_texts(wrong, right):
    """For every joint that other joints move otherwise: what moves it, and what should."""
    was, should = (np.eye(len(a)) if a.coupling is None else a.coupling for a in (wrong, right))
    return [
        f"joint {j + 1} turns by {_sum_text(was[j] * wrong.sign)}, should turn by"
        f" {_sum_text(should[j] * right.sign)}"
        for j in np.flatnonzero(np.abs(was - should).max(axis=1) > 1e-9)
    ]


def _sum_text(factors):
    """``q3 + q2`` of a row of factors; the joint's own q first."""
    terms = [(k, c) for k, c in enumerate(factors) if c]
    terms.sort(key=lambda term: -term[0])
    said = ""
    for k, c in terms:
        sign = ("-" if c < 0 else "") if not said else (" - " if c < 0 else " + ")
        said += sign + ("" if abs(c) == 1 else f"{number(abs(c), 3)} ") + f"q{k + 1}"
    return said


def number_text(was, should, column):
    """What stood in a column and what should."""
    if column in (THETA, ALPHA):
        was, should = np.rad2deg(was), np.rad2deg(wrapped(should))
        return f"is {number(was, 3)}°, should be {number(should, 3)}°"
    return f"is {number(was * 1000, 2)} mm, should be {number(should * 1000, 2)} mm"


def end_text(wrong, right, end):
    """How far a base or a tool is moved."""
    xyz, turn = moved_by(wrong, right, end)
    shift = ", ".join(number(v * 1000, 1) for v in xyz)
    return f"moved by ({shift}) mm" + (f" and turned by {number(turn, 2)}°" if turn > 0.01 else "")


def moved_by(wrong, right, end):
    """The shift (3,) in m and the turn in degrees by which a base or a tool is moved."""
    was, should = getattr(wrong, end), getattr(right, end)
    moved = should @ np.linalg.inv(was) if end == "base" else np.linalg.inv(was) @ should
    turn = np.rad2deg(np.arccos(np.clip((np.trace(moved[:3, :3]) - 1) / 2, -1, 1)))
    return moved[:3, 3], turn


def wrapped(angle):
    """Into (-π, π]."""
    return np.pi - (np.pi - angle) % (2 * np.pi)
