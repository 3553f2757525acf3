"""What is wrong with a table that was written down: the changes to the right table that give the
same arm.
"""

from dataclasses import replace

import numpy as np

from ...table import DHTable
from ..finding import find

__all__ = ["explain_rows", "wrong_tables"]


def explain_rows(given, right, q):
    """The mistake that turns the right arm into the given one.

    Parameters
    ----------
    given : Arm
        The answer; its poses differ from the right ones.
    right : Arm
    q : array (m, n)
        Configurations at which the poses are compared, general ones (no zeros, no multiples of
        90°).

    Returns
    -------
    Finding or None

    Examples
    --------
    >>> import dhlab as dh
    >>> right = dh.load("article-6r")
    >>> rows = right.table.rows
    >>> rows[3, 3] *= -1
    >>> q = np.random.default_rng(1).uniform(-2, 2, (5, 6))
    >>> explain_rows(dh.Arm(dh.DHTable.standard(rows, angle="rad")), right, q).message[:32]
    'alpha has the wrong sign (row 4)'
    """
    if len(given) != len(right):
        return None
    poses = given.forward(q)
    fitting = [
        (mistake, place, table)
        for mistake, place, table in wrong_tables(right.table)
        if np.allclose(replace(right, table=table).forward(q), poses, rtol=0, atol=1e-8)
    ]
    if not fitting:
        return None
    mistake, place, _ = min(
        fitting,
        key=lambda found: (
            not _written_alike(found[2], given.table),
            _changed(found[2], right.table),
            found[1] == "all rows",
        ),
    )
    return find(mistake, place)


def _written_alike(a, b):
    return a.convention == b.convention and np.allclose(a.rows, b.rows, rtol=0, atol=1e-9)


def _changed(a, b):
    """How many numbers a mistake changes: of several that make the same arm, the smallest is
    told.
    """
    return int((np.abs(a.rows - b.rows) > 1e-9).sum()) if a.convention == b.convention else 1


def wrong_tables(table):
    """Tables that hold one mistake each: yields (mistake, place, DHTable)."""
    yield from _whole_table(table)
    for i in range(len(table)):
        yield from _one_row(table, i)
    for i in range(len(table)):
        yield from _frames(table, i)


def _whole_table(table):
    rows = table.rows
    other = "craig" if table.convention == "standard" else "standard"
    yield (
        "standard-rows-in-craig-matrix" if other == "craig" else "craig-rows-in-standard-matrix",
        "",
        replace(table, convention=other),
    )
    for mistake, place, order in (
        ("a-d-exchanged", "all rows", [0, 2, 1, 3]),
        ("theta-alpha-exchanged", "all rows", [3, 1, 2, 0]),
        ("columns-misread", "", [3, 2, 1, 0]),
        ("columns-misread", "", [2, 3, 1, 0]),
    ):
        yield mistake, place, _with_rows(table, rows[:, order])
    yield "length-unit", "all lengths", replace(table, d=table.d * 1000, a=table.a * 1000)
    yield "alpha-sign", "all rows", replace(table, alpha=-table.alpha)
    yield "offset-missing", "all rows", replace(table, theta=0 * table.theta)
    yield "offset-sign", "all rows", replace(table, theta=-table.theta)
    yield "lengths-made-positive", "", replace(table, d=np.abs(table.d), a=np.abs(table.a))
    down = np.vstack([[0, 0], rows[:-1, 2:]])
    yield "a-alpha-from-previous-row", "", replace(table, a=down[:, 0], alpha=down[:, 1])


def _one_row(table, i):
    place = f"row {i + 1}"
    theta, d, a, alpha = table.rows[i]
    yield "alpha-sign", place, _with_row(table, i, [theta, d, a, -alpha])
    yield "length-sign", f"{place}, d", _with_row(table, i, [theta, -d, a, alpha])
    yield "length-sign", f"{place}, a", _with_row(table, i, [theta, d, -a, alpha])
    yield "a-d-exchanged", place, _with_row(table, i, [theta, a, d, alpha])
    yield "theta-alpha-exchanged", place, _with_row(table, i, [alpha, d, a, theta])
    yield "offset-missing", place, _with_row(table, i, [0, d, a, alpha])
    yield "offset-sign", place, _with_row(table, i, [-theta, d, a, alpha])
    for factor in (1000, 1e-3):
        yield "length-unit", f"{place}, d", _with_row(table, i, [theta, d * factor, a, alpha])
        yield "length-unit", f"{place}, a", _with_row(table, i, [theta, d, a * factor, alpha])
    yield "alpha-in-degrees", place, _with_row(table, i, [theta, d, a, np.rad2deg(alpha)])
    yield "offset-in-degrees", place, _with_row(table, i, [np.rad2deg(theta), d, a, alpha])
    for k in (i - 1, i + 1):
        if 0 <= k < len(table) and theta:
            moved = table.rows
            moved[k, 0] += theta
            moved[i, 0] = 0
            yield (
                "offset-on-wrong-joint",
                f"it belongs to row {i + 1}, you have it in row {k + 1}",
                _with_rows(table, moved),
            )


def _frames(table, i):
    """Slips made while placing frames, which change a row in more than one entry or by half a
    turn.
    """
    place = f"row {i + 1}"
    theta, d, a, alpha = table.rows[i]
    half_turn = abs(abs(alpha) - np.pi) < 1e-9
    yield "x-flip-incomplete", f"x{i + 1}", _with_row(table, i, [theta, d, -a, -alpha])
    yield "x-flip-incomplete", f"x{i + 1}", _with_row(table, i, [theta + np.pi, d, -a, -alpha])
    name, where = (
        ("antiparallel-taken-for-parallel", place)
        if half_turn
        else ("z-flip-incomplete", f"z{i + 1}")
    )
    yield name, where, _with_row(table, i, [theta, d, a, alpha + np.pi])
    yield "offset-counted-twice", place, _with_row(table, i, [2 * theta, d, a, alpha])
    if i + 1 < len(table) and alpha == 0:
        both = table.rows
        both[i, 1] = both[i + 1, 1] = d + both[i + 1, 1]
        yield "parallel-offset-in-both-rows", f"rows {i + 1} and {i + 2}", _with_rows(table, both)
    if table.joints[i] == "P":
        yield "prismatic-constant-lost", place, _with_row(table, i, [0, 0, a, alpha])
        yield "prismatic-constant-lost", f"{place}, d", _with_row(table, i, [theta, 0, a, alpha])
    yield (
        "prismatic-variable-in-theta",
        place,
        replace(
            table, joints=table.joints[:i] + "RP"[table.joints[i] == "R"] + table.joints[i + 1 :]
        ),
    )


def _with_row(table, i, row):
    rows = table.rows
    rows[i] = row
    return _with_rows(table, rows)


def _with_rows(table, rows):
    theta, d, a, alpha = rows.T
    return DHTable(table.convention, theta, d, a, alpha, table.joints)
