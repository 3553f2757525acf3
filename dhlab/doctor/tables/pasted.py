"""What a reader of one dialect hands on: rows of cells, and what the text says of them."""

from dataclasses import dataclass, field

from .cells import Cell

__all__ = ["Pasted", "Row", "from_rows"]

NOTHING = Cell(0.0)


@dataclass(frozen=True)
class Pasted:
    """Rows of Cells with what the text around them says.

    ``roles`` are the columns' names in order, None when nothing says them, and ``why`` how they are
    known; ``units`` by role; ``convention`` as far as it is said, and ``because`` how; ``labels``,
    ``kinds`` ("R", "P", "fixed" or ""), ``signs``, ``zeros`` (Cells that the text adds to theta
    beside the rows) and ``limits`` one per row; ``form`` is what dialect it is, in words;
    ``length`` and ``angle`` what words of the text say of all numbers, ``measured`` the one unit in
    which it measures anything, "" without one, ``joints`` how many it
    speaks of and ``worded`` how many in words, ``poses`` the lists that it calls joint values,
    ``adds`` whether it says that theta is added to them, ``each`` whether its program does so in a
    loop over all rows, ``slides`` whether it has a "word" of a
    joint that slides, or calls the "arm" one of these, ``scaled`` whether its program takes
    thousandths, ``multiple`` the comment that calls its lengths multiples of others, ``replaced``
    whether the program puts the joints' values in the place of theta, ``behind`` whether the
    header counts d, and not theta, from the link before, ``lines`` the first and the last line of
    the rows, where it is known, ``posed`` whether a program multiplies calls with numbers alone out
    and prints the result, ``callers`` the link function that makes each row, where there are two.
    """

    rows: tuple
    roles: tuple | None = None
    why: str = "as the header says"
    units: dict = field(default_factory=dict)
    convention: str | None = None
    because: str = ""
    labels: tuple = ()
    kinds: tuple = ()
    signs: tuple = ()
    zeros: tuple = ()
    limits: tuple = ()
    form: str = ""
    length: str = ""
    angle: str = ""
    measured: str = ""
    joints: tuple = ()
    worded: tuple = ()
    poses: tuple = ()
    adds: bool = False
    each: bool = False
    slides: str = ""
    scaled: bool = False
    multiple: str = ""
    replaced: bool = False
    behind: bool = False
    lines: tuple = ()
    posed: bool = False
    callers: tuple = ()
    notes: tuple = ()


@dataclass
class Row:
    """One row of a dialect that names its numbers: Cells by role."""

    cells: dict
    kind: str = ""
    label: str = ""
    sign: int = 1
    limits: tuple | None = None


def from_rows(rows, **said):
    """The Pasted table of Rows; what a row leaves out is 0.

    Examples
    --------
    >>> from_rows([Row({"d": Cell(0.1)}), Row({"a": Cell(0.4)})]).rows[1][2].value
    0.4
    """
    roles = ("theta", "d", "a", "alpha", "offset")
    return Pasted(
        tuple(tuple(row.cells.get(role, NOTHING) for role in roles) for row in rows),
        roles,
        labels=tuple(row.label for row in rows),
        kinds=tuple(row.kind for row in rows),
        signs=tuple(row.sign for row in rows),
        limits=tuple(row.limits for row in rows),
        **said,
    )
