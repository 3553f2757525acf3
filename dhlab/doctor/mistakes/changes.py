"""The ways in which a mistake is made: what it changes, in rows, arms, joint values, programs,
poses and measurements.

Each class is one kind of thing that goes wrong. A mistake's function (see
:mod:`dhlab.doctor.mistakes.registry`) yields one object for each way; every search takes the kinds
that it can use.

A *slip* is one wrong step of a program that is right otherwise. The steps, in order: ``"reading"``
(the rows and q that are used), ``"arguments"`` (what reaches the link matrix), ``"link"`` (the link
matrix itself), ``"entry"`` (one of its entries), ``"each link"`` (the finished link), ``"product"``
(of the links), ``"result"`` (the finished pose).
"""

from collections.abc import Callable
from dataclasses import dataclass

from ...table import COLUMNS

__all__ = [
    "ALL",
    "EACH",
    "FIRST",
    "LAST",
    "SLIDING",
    "ArmChange",
    "JointChange",
    "MeasuredChange",
    "PoseChange",
    "Rearranged",
    "RowChange",
    "Scaled",
    "Slip",
    "Symptom",
    "of_numbers",
    "scaled",
]

# the rows of a table in which a mistake is made: all at once, or one of these
ALL, EACH, FIRST, LAST, SLIDING = "all", "each", "first", "last", "sliding"


# ---- four numbers made of four


@dataclass(frozen=True)
class Scaled:
    """(theta, d, a, alpha) times four factors."""

    factors: tuple

    def __call__(self, *row):
        return tuple(value * factor for value, factor in zip(row, self.factors))

    @property
    def undone(self):
        """What takes it back; None where a number is lost."""
        return Scaled(tuple(1 / f for f in self.factors)) if all(self.factors) else None


@dataclass(frozen=True)
class Rearranged:
    """(theta, d, a, alpha) taken in another order."""

    order: tuple

    def __call__(self, *row):
        return tuple(row[k] for k in self.order)

    @property
    def undone(self):
        """What takes it back."""
        return Rearranged(tuple(self.order.index(k) for k in range(4)))


def scaled(**factors):
    """The change that multiplies the named numbers.

    Examples
    --------
    >>> scaled(alpha=-1)(0.1, 0.2, 0.3, 0.4)
    (0.1, 0.2, 0.3, -0.4)
    """
    return Scaled(tuple(factors.get(name, 1) for name in COLUMNS))


def of_numbers(names, change):
    """The change that puts the named numbers, each by itself, through a function.

    Examples
    --------
    >>> of_numbers(("d", "a"), abs)(-0.1, -0.2, -0.3, -0.4)
    (-0.1, 0.2, 0.3, -0.4)
    """
    return lambda *row: tuple(
        change(value) if name in names else value for name, value in zip(COLUMNS, row)
    )


# ---- the ways


@dataclass(frozen=True, kw_only=True)
class Change:
    """One way in which a mistake is made; ``mistake`` is its id, which the registry fills in."""

    mistake: str = ""


@dataclass(frozen=True)
class RowChange(Change):
    """Other numbers in a row: of an arm, of a table that was typed, of a program.

    Parameters
    ----------
    change : callable
        (theta, d, a, alpha) of a row, or of many as arrays of one shape, to the four wrong ones;
        radians and metres.
    parameter : str, optional
        The number that it changes, where it is one; then one fitted number may be named by it.
    rows : tuple
        Which rows of an arm: :data:`EACH`, :data:`ALL`, :data:`FIRST`, :data:`LAST`,
        :data:`SLIDING`; empty when it is made in programs only.
    typed : tuple, optional
        The same for a table that was typed, where it differs.
    place : str
        Where, in words, when all rows of a typed table have it.
    where : str, optional
        Where, in words with {row}, when one row has it; the row, and which length it is.
    argument, reading : str, optional
        Where, in words, when a program does it to the arguments of its link matrix (joint value
        included), or to the rows as it reads them (without).
    end : "base" or "tool", optional
        The row stands for this end of the arm, so no joint is named.
    within : float
        How near the number that stood there (a length: relative) must be to the wrong one.
    undo : callable, optional
        What takes it back; :func:`scaled` and :class:`Rearranged` know it themselves.
    """

    change: Callable
    parameter: str | None = None
    rows: tuple = (EACH, ALL)
    typed: tuple | None = None
    place: str = "all rows"
    where: str | None = None
    argument: str | None = None
    reading: str | None = None
    end: str | None = None
    within: float = 1e-3
    undo: Callable | None = None

    def place_of(self, row):
        """Where it is, in words, in a typed table; ``row`` from 1, 0 for all rows."""
        if row == 0:
            return self.place
        length = f", {self.parameter}" if self.parameter in ("d", "a") else ""
        return (self.where or f"row {{row}}{length}").format(row=row)

    @property
    def undone(self):
        """What takes it back, None where no change of rows does."""
        return self.undo or getattr(self.change, "undone", None)


@dataclass(frozen=True)
class ArmChange(Change):
    """Another arm, where more changes than the numbers of a row.

    Parameters
    ----------
    make : callable
        Yields (joint or None, place in words for a typed table, wrong Arm) of a right Arm.
    parameter : str, optional
        ``"sign"``, ``"base"``, ``"tool"``, or a number of the row.
    undo : callable, optional
        Yields (right Arm, entries (row, column) left to be fitted) of a wrong Arm.
    twice : bool
        Made twice it takes itself back, so that no ``undo`` is needed.
    only : "arm" or "typed", optional
        It is made on arms only, or in typed tables only.
    """

    make: Callable
    parameter: str | None = None
    undo: Callable | None = None
    twice: bool = False
    only: str | None = None

    def taken_back(self, arm):
        """Yields (right Arm, entries left to be fitted) of a wrong Arm."""
        if self.twice:
            yield from ((right, ()) for _, _, right in self.make(arm))
        elif self.undo is not None:
            yield from self.undo(arm)


@dataclass(frozen=True)
class JointChange(Change):
    """Joint values mixed up: a matrix times q.

    Parameters
    ----------
    matrix : callable
        The number of joints n to (n, n).
    reading, measured : str, optional
        Where, in words, when a program does it to q, and when it happened to measured joint values.
    """

    matrix: Callable
    reading: str | None = None
    measured: str | None = None


@dataclass(frozen=True)
class PoseChange(Change):
    """A finished pose gone wrong, (..., 4, 4) to (..., 4, 4): a program's result, each of its
    links, a measurement.

    Parameters
    ----------
    change : callable
    place : str
    each_link : bool
        Whether programs do it to every link as well.
    measured : str, optional
        Where, in words, when it happened to measured poses; it is its own inverse then.
    """

    change: Callable
    place: str = ""
    each_link: bool = True
    measured: str | None = None


@dataclass(frozen=True)
class MeasuredChange(Change):
    """Something wrong with what was measured, beyond joint values and poses as wholes.

    Parameters
    ----------
    undo : callable
        The number of joints n to (joint or None, place, repair): ``repair(q, p, R)`` gives right
        joint values (m, n), positions (m, 3) and rotations (m, 3, 3) or None.
    of : "q" or "poses"
    rotations : bool
        Whether it needs rotations.
    """

    undo: Callable
    of: str = "poses"
    rotations: bool = False


@dataclass(frozen=True)
class Slip(Change):
    """One wrong step of a program (a slip).

    Parameters
    ----------
    step : str
        One of the steps named at the top of this file.
    place : str
        Which part of the step it is, as the reader of a verdict is told.
    change : callable
        For ``"reading"``, ``"arguments"``, ``"link"`` and ``"product"``: what is computed there
        instead. For ``"entry"``, ``"each link"`` and ``"result"``: what becomes of the right value.
        ``doctor/programs/search/steps.py`` calls it and says with which arguments.
    """

    step: str
    place: str
    change: Callable


@dataclass(frozen=True)
class Symptom(Change):
    """What wrong answers of a pose-valued program look like, whatever made them so.

    Parameters
    ----------
    look : callable
        (answers, right ones), arrays (m, 4, 4), to the place in words, None where it is not seen.
    alone : bool
        Whether it is seen in the answers alone; such symptoms are asked last.
    explains : bool
        Whether nothing else can be wrong where it is seen.
    """

    look: Callable
    alone: bool = False
    explains: bool = False
