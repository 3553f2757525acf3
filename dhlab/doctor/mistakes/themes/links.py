"""One link's matrix: the order of its four moves, their directions, and its entries."""

import numpy as np

from ....kinematics import link_matrices
from ....transform import rot_x, rot_y, rot_z, trans_x, trans_z
from ..changes import ArmChange, RowChange, Slip, Symptom, of_numbers
from ..entries import typed, wrong_entries
from ..registry import mistake
from ..remade import ALPHA, THETA, A, with_rows

__all__ = ["MOVES", "exchanged", "in_another_order", "in_order", "mistyped"]

STANDARD, CRAIG = ("Rz", "Tz", "Tx", "Rx"), ("Rx", "Tx", "Rz", "Tz")
X_BEFORE_Z, ALPHA_BEFORE_D = ("Tx", "Rz", "Tz", "Rx"), ("Rz", "Tx", "Rx", "Tz")


APART = ({"Rz", "Tx"}, {"Rz", "Rx"}, {"Tz", "Rx"})  # the pairs whose order counts
MOVES = {
    "Rz": lambda row: rot_z(row[0]),
    "Tz": lambda row: trans_z(row[1]),
    "Tx": lambda row: trans_x(row[2]),
    "Rx": lambda row: rot_x(row[3]),
}


def in_order(names, *row):
    """The four moves multiplied in any order, such as ``("Rx", "Tx", "Rz", "Tz")``."""
    first, second, third, fourth = (MOVES[name](row) for name in names)
    return first @ second @ third @ fourth


def exchanged(names, right):
    """Which moves stand before which, and should not: what all orders have in common that make the
    same matrix.

    Examples
    --------
    >>> exchanged(("Rx", "Rz", "Tx", "Tz"), CRAIG)
    'Rz stands before Tx'
    >>> exchanged(CRAIG, STANDARD)
    'Tx stands before Rz; Rx stands before Rz and Tz'
    """
    said = []
    for move in right:
        later = [
            other
            for other in right
            if {move, other} in APART
            and names.index(move) < names.index(other)
            and right.index(move) > right.index(other)
        ]
        if later:
            said.append(f"{move} stands before {' and '.join(later)}")
    return "; ".join(said)


def in_another_order(names, step="link", place=""):
    """The slip of multiplying the moves so."""
    return Slip(step, place, lambda *row: in_order(names, *row))


@mistake("shift-not-turned-by-theta")
def shift_not_turned_by_theta():
    yield in_another_order(X_BEFORE_Z)


@mistake("alpha-before-d")
def alpha_before_d():
    yield in_another_order(ALPHA_BEFORE_D)


@mistake("turn-about-y")
def turn_about_y():
    for name, turn in (("alpha", "Rx"), ("theta", "Rz")):
        order = tuple("Ry" if move == turn else move for move in STANDARD)
        yield Slip("link", f"the turn by {name}", _about_y(order, name))


def _about_y(order, name):
    column = THETA if name == "theta" else ALPHA

    def link(*row):
        moves = {**MOVES, "Ry": lambda row: rot_y(row[column])}
        first, second, third, fourth = (moves[move](row) for move in order)
        return first @ second @ third @ fourth

    return link


@mistake("sin-cos-exchanged")
def sin_cos_exchanged():
    for name in ("alpha", "theta"):
        change = of_numbers((name,), lambda x: np.pi / 2 - x)
        yield RowChange(change, rows=(), argument=name)
    yield Slip("link", "cos alpha is 1 everywhere", _half_exchanged)


def _half_exchanged(theta, d, a, alpha):
    """cos(alpha) kept as 1, as if alpha were 0 there and 90° in the sine."""
    T = link_matrices("standard", theta, d, a, alpha)
    T[..., :3, 1] = np.stack([-np.sin(theta), np.cos(theta), np.sin(alpha)], axis=-1)
    T[..., 2, 2] = 1
    return T


@mistake("bent-link")
def bent_link():
    """A link that is bent: its a written as the part along one arm of the bend, without the angle
    that the bend takes from this theta and gives to the next.
    """

    def make(arm):
        rows = arm.table.rows
        for i, k in _bends(arm):
            bend = rows[i, THETA] - np.pi / 2 * np.round(rows[i, THETA] / (np.pi / 2))
            if SMALLEST_BEND < abs(bend) < np.pi / 4:
                yield i + 1, f"rows {i + 1} and {i + 2}", _bent(arm, i, k, -bend, np.cos(bend))

    def undo(arm):
        for i, k in _bends(arm):
            for bend in (0.2, -0.2):
                yield (
                    _bent(arm, i, k, bend, 1 / np.cos(bend)),
                    ((i, THETA), (_a(arm, i), A), (k, THETA)),
                )

    yield ArmChange(make, "theta", undo=undo)


SMALLEST_BEND = np.deg2rad(3)


def _a(arm, i):
    """The row that holds the length behind joint i (from 0)."""
    return i if arm.table.convention == "standard" else i + 1


def _bends(arm):
    """(i, i + 1) where a link of some length lies between two parallel revolute joints."""
    rows, standard = arm.table.rows, arm.table.convention == "standard"
    for i in range(len(arm) - 1):
        row = i if standard else i + 1
        parallel = rows[row, A] and abs(np.sin(rows[row, ALPHA])) < 1e-9
        if parallel and arm.table.joints[i : i + 2] == "RR":
            yield i, i + 1


def _bent(arm, i, k, bend, factor):
    """The arm with the angle of a bend taken from theta k and given to theta i, a times a
    factor.
    """
    rows = arm.table.rows
    side = np.cos(rows[_a(arm, i), ALPHA])  # the next axis may be turned over
    rows[i, THETA] += bend
    rows[k, THETA] -= side * bend
    rows[_a(arm, i), A] *= factor
    return with_rows(arm, rows)


MISTYPED = "matrix-entry-mistyped"


@mistake(MISTYPED)
def matrix_entry_mistyped():
    for entry, monomial in wrong_entries():
        yield mistyped(entry, monomial)
    yield Symptom(_one_or_two_entries, explains=True)


def mistyped(entry, monomial):
    """The slip that puts a Monomial into an entry (row, column) of the link matrix."""

    def change(T, *row):
        T = T.copy()
        T[(..., *entry)] = monomial(*row)
        return T

    return Slip("entry", typed(entry, monomial), change, mistake=MISTYPED)


def _one_or_two_entries(answers, right):
    off = (np.abs(answers - right) > 1e-9 * (1 + np.abs(right))).any(axis=0)
    wrong = np.argwhere(off)
    if len(wrong) > 2 or not off[:3].any():
        return None
    return " and ".join(f"row {i + 1}, column {j + 1}" for i, j in wrong)
