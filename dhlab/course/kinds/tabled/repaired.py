"""Two more kinds of table exercises: a broken table to be repaired, and a wrong table that passes a
weak test.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ....arm import Arm
from ....doctor import explain_rows
from ....geometry.equivalence import equivalent
from ...verdict import RIGHT, Verdict
from .. import Said, Table, as_arm
from ..reading import Unreadable, plain
from .arms import SAME, apart, in_table_units, size

__all__ = ["Repair", "Impostor"]

NOISY = 0.1  # of what was to be mended: what is left is not seen in measured points
COLUMNS = ("theta", "d", "a", "alpha")
VALUES = ("offset-value", "length-value", "length-value", "alpha-value")


@dataclass(frozen=True, kw_only=True)
class Repair(Table):
    """A broken table to be repaired: the one that is handed out. ``nearly`` is the next step of a
    number that is within a tenth of what was to be mended.
    """

    handed_out: Callable
    nearly: str

    def drawn(self, answer: Any, variant: int = 0) -> Any:
        return None  # the first axis that does not fit is what is asked for

    def unchanged(self, answer: Any, variant: int) -> Verdict:
        """The Verdict on the table that was handed out; on one in which a 0 was negated."""
        try:
            rows = plain(answer)
        except Unreadable:
            return super().unchanged(answer, variant)
        negated = np.argwhere(np.signbit(rows) & (rows == 0))
        if not len(negated):
            return super().unchanged(answer, variant)
        i, k = negated[0]
        return self.wrong(
            headline=f"row {i + 1}, {COLUMNS[k]} is 0, and 0 has no sign to lose",
            next=f"Row {i + 1} makes the axis of joint {i + 2}."
            if i + 1 < len(rows)
            else "Row i makes the axis of joint i + 1.",
        )

    def _explained(self, arm, right, q, variant):
        """The Verdict on another arm: which of the changed entries were right before."""
        known = self.known(arm, q, variant)
        if known:
            return known
        broken = as_arm(self.handed_out(**self.given(variant)), right).table
        table = arm.table
        same_kind = (table.convention, table.joints) == (broken.convention, broken.joints)
        if not same_kind or in_table_units(arm, right, q):
            return super()._explained(arm, right, q, variant)
        changed = np.argwhere(np.abs(table.rows - broken.rows) > SAME)
        if not len(changed):
            return super()._explained(arm, right, q, variant)
        was_right = [
            f"row {i + 1}, {COLUMNS[k]}"
            for i, k in changed
            if abs(broken.rows[i, k] - right.table.rows[i, k]) < SAME
        ]
        if len(changed) > 1:
            left = np.abs(table.rows - right.table.rows) > SAME
            return self._several(changed, was_right, left.sum() == len(was_right))
        if was_right:
            return self.wrong(
                headline="this entry was right before you changed it",
                place=was_right[0],
                next="Put it back. Which entry does the evidence point at?",
            )
        ((i, k),) = changed
        missing = np.abs(right.table.rows[i, k] - [table.rows[i, k], broken.rows[i, k]])
        return self.told(
            VALUES[k],
            Said(
                "the right entry, but not yet the right number",
                place=f"row {i + 1}, {COLUMNS[k]}",
                next=(
                    self.nearly
                    if missing[0] < NOISY * missing[1]
                    else "How much does the evidence say is missing, and with which sign? Add it to"
                    " the number that was handed out."
                ),
            ),
        )

    def _several(self, changed, was_right, mended):
        """The Verdict on more changes than the one that is enough; ``mended``: it is among them."""
        several = len(was_right) > 1
        back = "Put these back" if several else "Put this one back"
        return self.wrong(
            headline=f"{len(changed)} entries are changed, and one change is enough",
            place=f"{'; '.join(was_right)} {'were' if several else 'was'} right before",
            next=f"{back}, and keep the other change."
            if mended
            else f"{back}. Which entry does the evidence point at?",
        )


@dataclass(frozen=True, kw_only=True)
class Impostor(Table):
    """A wrong table to be found that nobody can tell from the right one, ``answer``, at q = 0; the
    right one is what is handed out.
    """

    handed_out: Callable

    def drawn(self, answer: Any, variant: int = 0) -> Any:
        return None  # a wrong table is what is asked for

    def judged(self, arm: Arm, right: Arm, variant: int) -> Verdict:
        q = self.poses_at(variant)
        seen, hidden = apart(arm, right, 0 * q[:1]), apart(arm, right, q)
        if max(seen) > SAME:
            unit = in_table_units(arm, right, 0 * q)
            if unit:
                return self.told(*unit)
            finding = explain_rows(arm, right, q)
            return self.wrong(
                finding and finding.mistake,
                place=Said(
                    f"q = 0 finds this one out: {size(seen)} off there",
                    next="Look for a change that a stretched arm does not show.",
                ),
            )
        if max(hidden) < SAME:
            return self.told(
                "table-taken-as-unique",
                Said(
                    "this table passes because it is right: it is the same arm at every q",
                    why=_what_is_free(arm, right),
                    next="Change a number so that the arm is another one.",
                ),
            )
        return self.say(
            RIGHT,
            f"{self.praise} At q = 0 it cannot be told from the right table; at general q it is up"
            f" to {size(hidden)} off.",
        )


def _what_is_free(arm, right):
    """In what two tables of one arm differ, in words."""
    choices = "; ".join(choice.message for choice in equivalent(right, arm).differences)
    if not choices:
        return "All that differs is whole turns, which change nothing."
    return f"All that differs is free in a table: {choices}."
