"""``Copied``: a table whose numbers are given and are to be copied, converted or put right."""

from dataclasses import dataclass, replace

from ..exercise import Said
from .arms import IN_DEGREES
from .entries import COLUMNS, difference, differing, in_part, places
from .tables import Table, as_arm

__all__ = ["Copied"]


@dataclass(frozen=True, kw_only=True)
class Copied(Table):
    """A table whose numbers are given and are to be copied, converted or put right: what is said
    of a wrong one is read off what was typed, number by number, never off the arm that it makes.

    ``compared`` is the next step where numbers differ.
    """

    compared: str

    def _slip(self, arm, right, q, variant):
        rows, wanted = (one.table.rows * IN_DEGREES for one in (arm, right))
        if arm.table.convention != right.table.convention or not differing(rows, wanted).any():
            return super()._slip(arm, right, q, variant)
        unit = in_part(rows, wanted, lambda i, k: f"{COLUMNS[k]} of row {i + 1}")
        if unit:
            return self.told(*unit)
        for mistake, said, wrong in self._mistaken(variant):
            if not differing(rows, wrong.table.rows * IN_DEGREES).any():
                return self.told(mistake, said)
        spoilt = self._spoilt(rows, wanted, right, variant)
        found = spoilt or difference(rows, wanted)
        return found and self.told(found[0], replace(found[1], next=found[1].next or self.compared))

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
