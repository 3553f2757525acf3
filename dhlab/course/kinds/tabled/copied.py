"""``Copied``: a table whose numbers are given and are to be copied, converted or put right."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ..exercise import Said
from .arms import IN_DEGREES
from .entries import COLUMNS, difference, differing, in_part, places
from .handed_in import as_arm
from .tables import Table

__all__ = ["Copied"]


@dataclass(frozen=True, kw_only=True)
class Copied(Table):
    """A table whose numbers are given and are to be copied, converted or put right: what is said
    of a wrong one is read off what was typed, number by number, never off the arm that it makes.

    ``compared`` is the next step where numbers differ.
    """

    compared: str = ""

    def named(self, row: int, column: int) -> str:
        """What a number is called, both counted from 0."""
        return f"{COLUMNS[column]} of row {row + 1}"

    def asked(self, off: NDArray[np.bool_]) -> str:
        """The next step where the numbers of a mask are not right."""
        return self.compared

    def _slip(self, arm, right, q, variant):
        rows, wanted = (one.table.rows * IN_DEGREES for one in (arm, right))
        if arm.table.convention != right.table.convention or not differing(rows, wanted).any():
            return super()._slip(arm, right, q, variant)
        unit = in_part(rows, wanted, self.named)
        if unit:
            return self.told(*unit)
        for mistake, said, wrong in self._mistaken(variant):
            if not differing(rows, wrong.table.rows * IN_DEGREES).any():
                return self.told(mistake, said)
        spoilt = self._spoilt(rows, wanted, right, variant)
        mistake, said = spoilt or difference(rows, wanted)
        after = self.asked(differing(rows, wanted))
        return self.told(mistake, replace(said, next=said.next or after))

    def _spoilt(self, rows, wanted, right, variant):
        """What is said of entries that were right as they were handed out; None."""
        if self.handed_out is None:
            return None
        given = as_arm(self.handed_out(**self.given(variant)), right).table.rows * IN_DEGREES
        was_right = differing(rows, wanted) & ~differing(given, wanted)
        if not was_right.any():
            return None
        return None, Said(
            "what was right as it was handed out is changed",
            place=places(was_right),
            next="Put this back first.",
        )
