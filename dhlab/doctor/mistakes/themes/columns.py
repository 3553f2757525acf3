"""Convention and columns: rows for the other matrix, rows that lend their neighbour's numbers,
columns in another order.
"""

from itertools import combinations, permutations

import numpy as np

from ....kinematics import link_matrices
from ....table import COLUMNS as NAMES
from ..changes import ALL, EACH, ArmChange, MeasuredChange, Rearranged, RowChange, Slip
from ..registry import COLUMNS, CONVENTION, mistake
from ..remade import A, with_rows

A_FOR_D, THETA_FOR_ALPHA = (0, 2, 1, 3), (3, 1, 2, 0)
# the orders of MATLAB, of lecture notes and of papers, read as θ d a α
COMMON_ORDERS = ((3, 2, 1, 0), (3, 2, 0, 1), (2, 3, 1, 0), (3, 1, 0, 2))


def _read_as(convention):
    """The same rows, for the other matrix; taken back the same way."""
    other = {"standard": "craig", "craig": "standard"}[convention]

    def make(arm):
        if arm.table.convention == other:
            yield None, "", with_rows(arm, arm.table.rows, convention=convention)

    def undo(arm):
        if arm.table.convention == convention:
            yield with_rows(arm, arm.table.rows, convention=other), ()

    return ArmChange(make, undo=undo)


@mistake("standard-rows-in-craig-matrix", preference=CONVENTION, value_of=("rows are standard",))
def standard_rows_in_craig_matrix():
    yield _read_as("craig")
    yield Slip(
        "link",
        "the four moves reversed are Craig's order",
        lambda *row: link_matrices("craig", *row),
    )


@mistake("craig-rows-in-standard-matrix", preference=CONVENTION, value_of=("rows are craig",))
def craig_rows_in_standard_matrix():
    yield _read_as("standard")
    yield Slip(
        "craig link",
        "the moves about and along z come first",
        lambda *row: link_matrices("standard", *row),
    )


@mistake("a-alpha-from-previous-row")
def a_alpha_from_previous_row():
    def make(arm):
        rows = arm.table.rows
        rows[:, A:] = np.vstack([[0, 0], rows[:-1, A:]])
        yield None, "", with_rows(arm, rows)

    def undo(arm):
        """The last row's a and alpha were lost: they are left to be fitted."""
        rows = arm.table.rows
        rows[:, A:] = np.vstack([rows[1:, A:], [0, 0]])
        last = len(rows) - 1
        yield with_rows(arm, rows), ((last, A), (last, A + 1))

    yield ArmChange(make, undo=undo)
    yield Slip("reading", "", _neighbour(1, False))
    yield Slip("reading", "row 1 takes them from the last row", _neighbour(1, True))
    yield Slip("reading", "here it is the row after", _neighbour(-1, False))
    yield Slip("reading", "here it is the row after", _neighbour(-1, True))


def _neighbour(step, wrap):
    """a and alpha from another row; the row that has no neighbour takes 0, or the one at the other
    end.
    """

    def change(rows, q):
        moved = np.roll(rows[..., A:], step, axis=-2)
        if not wrap:
            moved[..., 0 if step > 0 else -1, :] = 0
        return np.concatenate([rows[..., :A], moved], axis=-1), q

    return change


@mistake("a-d-exchanged", preference=COLUMNS)
def a_d_exchanged():
    yield RowChange(Rearranged(A_FOR_D), rows=(EACH, ALL), argument="", reading="")


@mistake("theta-alpha-exchanged")
def theta_alpha_exchanged():
    yield RowChange(Rearranged(THETA_FOR_ALPHA), rows=(EACH, ALL), argument="", reading="")


@mistake("columns-misread")
def columns_misread():
    for order in permutations(range(4)):
        if order not in (tuple(range(4)), A_FOR_D, THETA_FOR_ALPHA):
            names = ", ".join(NAMES[order.index(k)] for k in range(4))
            yield RowChange(
                Rearranged(order),
                rows=(ALL,) if order in COMMON_ORDERS else (),
                place="",
                argument=f"taken as {names}",
                reading=f"read as {names}",
            )
    for column, name in ((3, "alpha"), (1, "d"), (2, "a")):
        yield Slip("reading", f"q is added to {name}", _q_in(column))
    yield MeasuredChange(_joint_columns_swapped, "q")
    yield MeasuredChange(_axes_swapped)


def _q_in(column):
    """q added to another column than theta."""

    def change(rows, q):
        rows = rows.copy()
        rows[..., column] += q
        return rows, 0 * q

    return change


@mistake("one-number-for-another")
def one_number_for_another():
    for given, wanted in ((1, 2), (2, 1), (0, 3), (3, 0)):
        place = f"{NAMES[given]} is used where {NAMES[wanted]} belongs"
        yield Slip("arguments", place, _used_for(given, wanted))


def _used_for(given, wanted):
    """One number used in two places: its own, and that of another."""
    order = tuple(given if k == wanted else k for k in range(4))
    return lambda *row: tuple(row[k] for k in order)


def _joint_columns_swapped(n):
    for i, j in combinations(range(n), 2):
        order = [j if k == i else i if k == j else k for k in range(n)]
        place = f"q{i + 1} and q{j + 1} have changed places"
        yield None, place, lambda q, p, R, order=order: (q[:, order], p, R)


def _axes_swapped(n):
    for a, b in combinations(range(3), 2):
        order = [b if k == a else a if k == b else k for k in range(3)]
        place = f"{'xyz'[a]} and {'xyz'[b]} have changed places"
        yield None, place, lambda q, p, R, order=order: (q, p[:, order], R)
