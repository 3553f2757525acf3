"""What is said of a table that describes another arm: in which units it would be right, how far off
its end is, and where the two arms part.
"""

import numpy as np
from numpy.typing import NDArray

from ....arm import Arm
from ....doctor.mistakes.remade import with_rows
from ....geometry.equivalence import equivalent
from ....printing import number
from ..exercise import Said
from ..wrong.units import LOOSELY, Group, in_other_units

__all__ = ["IN_DEGREES", "SAME", "apart", "in_table_units", "size", "where"]

SAME = 1e-6  # rad, m; how far a right pose may be off
COLUMNS = (("θ", "deg"), ("d", "m"), ("a", "m"), ("α", "deg"))
IN_DEGREES = np.array([180 / np.pi, 1, 1, 180 / np.pi])


def apart(one: Arm, other: Arm, q: NDArray[np.float64]) -> tuple[float, float]:
    """The largest distance (m) and angle (rad) between two arms' ends over configurations q (m,
    n).
    """
    return _off(one.forward(q), other.forward(q))


def _off(A, B):
    chord = np.linalg.norm(A[..., :3, :3] - B[..., :3, :3], axis=(-1, -2)) / np.sqrt(8)
    return (
        float(np.linalg.norm(A[..., :3, 3] - B[..., :3, 3], axis=-1).max()),
        float(2 * np.arcsin(np.clip(chord, 0, 1)).max()),
    )


def size(off: tuple[float, float]) -> str:
    """How far off an end is, for a reader.

    Examples
    --------
    >>> size((0.0000364, 0.0))
    '0.036 mm and 0°'
    >>> size((0.153, 0.7))
    '153 mm and 40°'
    """
    return f"{_rounded(1000 * off[0])} mm and {_rounded(np.rad2deg(off[1]))}°"


def _rounded(value):
    if not np.isfinite(value):  # lengths that no float can add
        return "∞"
    if value < 1e-5:
        return "0"
    return number(value, 0 if value >= 10 else max(0, 1 - int(np.floor(np.log10(value)))))


def in_table_units(arm: Arm, right: Arm, q: NDArray[np.float64]) -> tuple[str, Said] | None:
    """The slip of units that makes the one arm of the other: of whole columns, else of one entry;
    None when there is none.
    """
    rows, columns = arm.table.rows * IN_DEGREES, np.arange(4)
    q = q[:4]
    asked = right.forward(q)

    def fits(rows):
        return max(_off(_with_rows(arm, rows).forward(q), asked)) <= 2 * LOOSELY

    every = np.ones((len(rows), 1), dtype=bool)
    of_columns = [
        Group(name, unit, every & (columns == k)) for k, (name, unit) in enumerate(COLUMNS)
    ]
    found = in_other_units(rows, of_columns, fits)
    if found:
        return found
    singles = (
        in_other_units(rows, [Group(f"{name} of row {i + 1}", unit, _only(rows.shape, i, k))], fits)
        for i in range(len(rows))
        for k, (name, unit) in enumerate(COLUMNS)
    )
    return next(filter(None, singles), None)


def _only(shape, i, k):
    where = np.zeros(shape, dtype=bool)
    where[i, k] = True
    return where


def _with_rows(arm, rows):
    return with_rows(arm, rows / IN_DEGREES)


def _same_angles(arm, right):
    """Whether two tables have the same θ and α, whole turns apart."""
    turns = (arm.table.rows - right.table.rows)[:, [0, 3]] / (2 * np.pi)
    return arm.table.convention == right.table.convention and np.allclose(turns, turns.round())


def where(arm: Arm, right: Arm, q: NDArray[np.float64], of_rows: bool = True) -> str:
    """The first joint whose axis is not where it must be, and which numbers of the table lead to
    it; ``of_rows``: whether the table was written, not made of axes.
    """
    turned = np.abs(arm.forward(q) - right.forward(q))[:, :3, :3].max() > SAME
    lengths = "" if turned else "; the rotation is right at every pose"
    if lengths and of_rows and _same_angles(arm, right):
        lengths += ", so look at the lengths"
    joint = equivalent(right, arm).joint
    if not joint:
        return f"every joint's axis is where it must be, only the end is not{lengths}"
    if joint == 1:
        return f"the axis of joint 1 is not where it must be{lengths}"
    before = joint - 1
    here = f"the axis of joint {before} is where it must be, that of joint {joint} is not"
    if not of_rows:
        return f"{here}: look at its point and its direction{lengths}"
    lead = (
        f"row {before} leads"
        if arm.table.convention == "standard"
        else f"θ and d of row {before} lead, with a and α of row {joint},"
    )
    return f"{here}: {lead} from the one to the other{lengths}{_hidden(arm, right, before)}"


def _hidden(arm, right, before):
    """Of parallel axes that end with this joint's: a step along them moves none of them. Said where
    such a step is what is wrong.
    """
    table = right.table
    shift = 1 if table.convention == "standard" else 0  # alpha between axes i and i + 1, from 1
    parallel = [abs(np.sin(table.alpha[i - shift])) < SAME for i in range(1, len(table))]
    first = before
    while first > 1 and parallel[first - 2]:
        first -= 1
    if first == before or parallel[before - 1] or table.prismatic[first - 1 : before].any():
        return ""
    if not _a_step_mends(arm, right, first, before):
        return ""
    rows = f"{first} {'and' if before == first + 1 else 'to'} {before}"
    return f"; axes {rows} are parallel: a wrong d in any of these rows shows only here"


def _a_step_mends(arm, right, first, before):
    """Whether another d in these rows, from 1, brings the axis behind them to its place."""
    if arm.table.convention != right.table.convention:
        return False
    rows, along = arm.table.rows * IN_DEGREES, np.s_[first - 1 : before]
    rows[before - 1, 1] += right.table.d[along].sum() - arm.table.d[along].sum()
    joint = equivalent(right, _with_rows(arm, rows)).joint
    return joint is None or joint > before + 1
