"""``DHTable``: the rows of a Denavit-Hartenberg table that know their convention, units and joint
types.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import units
from .checks import COLUMNS, checked_joints, checked_rows, require_finite

__all__ = ["DHTable", "CONVENTIONS", "COLUMNS", "JOINT_WORDS", "joint_letter"]

CONVENTIONS = ("standard", "craig")
JOINT_WORDS = {"revolute": "R", "prismatic": "P"}


@dataclass(frozen=True, eq=False, repr=False)
class DHTable:
    """A Denavit-Hartenberg table. Made by :meth:`standard` or :meth:`craig`; frozen, in radians and
    metres.

    Parameters
    ----------
    convention : "standard" or "craig"
        Standard: ``A_i = Rz(theta_i) Tz(d_i) Tx(a_i) Rx(alpha_i)`` (Paul 1981; Siciliano et al.,
        Robotics, section 2.8.2). Craig (modified): ``A_i = Rx(alpha_{i-1}) Tx(a_{i-1}) Rz(theta_i)
        Tz(d_i)`` (Craig, Introduction to Robotics, eq. 3.6); its row i holds ``a_{i-1}`` and
        ``alpha_{i-1}`` in the columns ``a`` and ``alpha``.
    theta, d, a, alpha : arrays (n,)
        Radians and metres. ``theta`` of a revolute joint and ``d`` of a prismatic one are zero
        offsets, added to the joint variable.
    joints : str or sequence of "R" and "P"
        One letter per row.

    Raises
    ------
    ValueError
        A wrong shape, a number that is not finite, an unknown convention or joint letter.

    Examples
    --------
    >>> table = DHTable.standard([[0, 0.1, 0, 90], [0, 0, 0.4, 0]], angle="deg")
    >>> print(table)
    standard DH, 2 joints (lengths in m, angles in deg)
     i   theta  d    a    alpha
     1   q1     0.1  0    90
     2   q2     0    0.4  0
    """

    convention: str
    theta: NDArray[np.float64]
    d: NDArray[np.float64]
    a: NDArray[np.float64]
    alpha: NDArray[np.float64]
    joints: str

    if TYPE_CHECKING:  # what may be given; the fields above are what it becomes

        def __init__(
            self,
            convention: str,
            theta: ArrayLike,
            d: ArrayLike,
            a: ArrayLike,
            alpha: ArrayLike,
            joints: str | Sequence[str] | None,
        ) -> None: ...

        _rows: NDArray[np.float64]  # the four columns side by side

    def __post_init__(self) -> None:
        if self.convention not in CONVENTIONS:
            raise ValueError(
                'DHTable: expected the convention "standard" or "craig", found'
                f' {self.convention!r}; say which matrix the rows are for ("modified" is "craig"'
                " here)"
            )
        columns = [np.array(getattr(self, name), dtype=float) for name in COLUMNS]
        lengths = [column.size if column.ndim == 1 else column.shape for column in columns]
        if len(set(lengths)) != 1 or columns[0].ndim != 1:
            raise ValueError(
                "DHTable: expected four columns (theta, d, a, alpha) of one length, found"
                f" {lengths}; give one number per joint in each"
            )
        for name, column in zip(COLUMNS, columns):
            column = column + 0.0  # -0.0 prints badly
            column.flags.writeable = False
            object.__setattr__(self, name, column)
        object.__setattr__(
            self, "_rows", np.column_stack([getattr(self, name) for name in COLUMNS])
        )
        require_finite(self._rows, "DHTable")
        object.__setattr__(self, "joints", checked_joints(self.joints, len(columns[0]), "DHTable"))

    @classmethod
    def standard(
        cls,
        rows: ArrayLike,
        *,
        angle: str | None = None,
        length: str = "m",
        joints: str | Sequence[str] | None = None,
    ) -> Self:
        """A table in the standard convention.

        Parameters
        ----------
        rows : (n, 4) numbers
            ``theta`` offset, ``d``, ``a``, ``alpha`` per joint, in this order.
        angle : "deg" or "rad"
            The unit of theta and alpha; always given.
        length : "m" or "mm"
            The unit of d and a.
        joints : str or sequence, optional
            ``"R"`` or ``"P"`` per joint, such as ``"RRP"``; all revolute when left out.

        Returns
        -------
        DHTable

        Raises
        ------
        ValueError
            One sentence that names the row and the column.

        Examples
        --------
        >>> DHTable.standard([[0, 0.1, 0]], angle="deg")
        Traceback (most recent call last):
        ...
        ValueError: DHTable.standard: row 1 has 3 numbers, expected 4 (theta, d, a, alpha); fill in
        what is missing
        """
        return cls._from_rows("standard", rows, angle, length, joints)

    @classmethod
    def craig(
        cls,
        rows: ArrayLike,
        *,
        angle: str | None = None,
        length: str = "m",
        joints: str | Sequence[str] | None = None,
    ) -> Self:
        """A table in Craig's (modified) convention; row i holds theta_i, d_i, a_{i-1}, alpha_{i-1}.
        Parameters as :meth:`standard`.

        Examples
        --------
        >>> rows = [[0, 333, 0, 0], [0, 0, 0, -90]]
        >>> print(DHTable.craig(rows, angle="deg", length="mm", joints="RP"))
        Craig DH, 2 joints (lengths in m, angles in deg)
         i   theta  d      a(i-1)  alpha(i-1)
         1   q1     0.333  0       0
         2   0      q2     0       -90
        """
        return cls._from_rows("craig", rows, angle, length, joints)

    @classmethod
    def _from_rows(
        cls,
        convention: str,
        rows: ArrayLike,
        angle: str | None,
        length: str,
        joints: str | Sequence[str] | None,
    ) -> Self:
        where = f"DHTable.{convention}"
        to_rad = units.scale_of(angle, "angle", where)
        to_m = units.scale_of(length, "length", where)
        numbers = checked_rows(rows, where)
        require_finite(numbers, where)
        theta, d, a, alpha = numbers.T
        letters = checked_joints(joints, len(numbers), where)
        return cls(
            convention,
            units.convert(theta, to_rad),
            units.convert(d, to_m),
            units.convert(a, to_m),
            units.convert(alpha, to_rad),
            letters,
        )

    @classmethod
    def load(cls, path: str | Path) -> "DHTable":
        """The table in a YAML or CSV file (formats in :mod:`dhlab.formats.tablefile`); a file that
        also says base, tool, limits or signs describes an arm and is refused, since a table cannot
        hold them: use ``dhlab.load``.
        """
        from .formats.tablefile import read_table

        return read_table(path)

    def save(
        self,
        path: str | Path,
        *,
        angle: str | None = None,
        length: str = "m",
        overwrite: bool = False,
    ) -> None:
        """Write the table as ``.yaml`` or ``.csv``; :meth:`load` gives every number back.

        Parameters
        ----------
        path : str or path
            Ends in ``.yaml``, ``.yml`` or ``.csv``.
        angle : "deg" or "rad", optional
            Left out: degrees when every angle reads back from them exactly, radians otherwise.
        length : "m" or "mm"
        overwrite : bool
            Replace an existing file; it is kept, with an error, otherwise.
        """
        from .formats.tablefile import write

        write(path, self, angle=angle, length=length, overwrite=overwrite)

    @property
    def rows(self) -> NDArray[np.float64]:
        """(n, 4) array of theta, d, a, alpha; radians and metres."""
        return self._rows.copy()

    @property
    def prismatic(self) -> NDArray[np.bool_]:
        """(n,) booleans: which joints slide."""
        return np.array([letter == "P" for letter in self.joints], dtype=bool)

    def __len__(self) -> int:
        return len(self.joints)

    def __eq__(self, other: object) -> bool:
        """Entry by entry; whether two tables describe one arm is another question, answered by
        ``dhlab.equivalent``.
        """
        if not isinstance(other, DHTable):
            return NotImplemented
        return (
            self.convention == other.convention
            and self.joints == other.joints
            and bool((self._rows == other._rows).all())
        )

    def __hash__(self) -> int:
        return hash((self.convention, self.joints, self.rows.tobytes()))

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
        return DHTable, (self.convention, self.theta, self.d, self.a, self.alpha, self.joints)

    def __repr__(self) -> str:
        return (
            f'DHTable.{self.convention}({self.rows.tolist()}, angle="rad", joints="{self.joints}")'
        )

    def __str__(self) -> str:
        from .printing import table_text

        return table_text(self)

    def _repr_html_(self) -> str:
        from .printing import table_html

        return table_html(self)


def joint_letter(word: object, where: str) -> str:
    """ "R" or "P" for the word a file uses, revolute or prismatic."""
    if not isinstance(word, str) or word not in JOINT_WORDS:
        raise ValueError(f"{where}: expected revolute or prismatic, found {word!r}")
    return JOINT_WORDS[word]
