"""Two more kinds of table exercises: a broken table to be repaired, and a wrong table that passes a
weak test.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

from ...doctor import explain_rows
from ...printing import number
from ..verdict import RIGHT, Verdict
from . import Said, Table, as_arm

__all__ = ["Repair", "Impostor"]

COLUMNS = ("theta", "d", "a", "alpha")
SAME = 1e-6  # rad, m; and what a pose may differ by


@dataclass(frozen=True, kw_only=True)
class Repair(Table):
    """A broken table to be repaired: the one that is handed out."""

    handed_out: Callable

    def compare(self, answer: Any, variant: int) -> Verdict:
        verdict = super().compare(answer, variant)
        if verdict.status == RIGHT or verdict.mistake is not None:
            return verdict
        return self._by_entries(answer, variant) or verdict

    def _by_entries(self, answer, variant):
        """What to say of an answer in which one entry was changed: the wrong entry, or the right
        one to a wrong number; None for others.
        """
        right = self.right_arm(variant)
        broken = _in_radians(self.handed_out(**self.given(variant)))
        try:
            rows = as_arm(answer, right).table.rows
        except ValueError:
            return None
        changed = (
            [] if rows.shape != broken.shape else list(zip(*np.nonzero(abs(rows - broken) > SAME)))
        )
        if len(changed) != 1:
            return None
        ((i, k),) = changed
        place = f"row {i + 1}, {COLUMNS[k]}"
        if abs(broken[i, k] - right.table.rows[i, k]) < SAME:
            return self.wrong(
                headline="this entry was right before you changed it",
                place=place,
                next="Put it back. Which entry does the evidence point at?",
            )
        return self.wrong(
            "length-value" if k in (1, 2) else None,
            place=Said(
                "the right entry, but not yet the right number",
                place=place,
                next="How much does the evidence say is missing, and with which sign?",
            ),
        )


@dataclass(frozen=True, kw_only=True)
class Impostor(Table):
    """A wrong table to be found that nobody can tell from the right one, ``answer``, at q = 0; the
    right one is what is handed out.
    """

    handed_out: Callable

    def compare(self, answer: Any, variant: int) -> Verdict:
        right = self.right_arm(variant)
        arm = self.arm_of(answer, right)
        if isinstance(arm, Verdict):
            return arm
        q = self.poses_at(variant)
        seen, hidden = _apart(arm, right, 0 * q[:1]), _apart(arm, right, q)
        if max(seen) > SAME:
            finding = explain_rows(arm, right, q)
            return self.wrong(
                finding and finding.mistake,
                place=Said(
                    f"q = 0 finds this one out: {_size(seen)} off there",
                    place=finding.place if finding else "",
                    next="Look for a change that a stretched arm does not show.",
                ),
            )
        if max(hidden) < SAME:
            return self.wrong(
                "table-taken-as-unique",
                headline="this table passes because it is right: it is the same arm at every q",
                next="Change a number so that the arm is another one.",
            )
        return self.say(
            RIGHT,
            f"{self.praise} At q = 0 it cannot be told from the right table; at general q it is up"
            f" to {_size(hidden)} off.",
        )


def _in_radians(rows):
    return np.asarray(rows, dtype=float) * [np.pi / 180, 1, 1, np.pi / 180]


def _apart(one, other, q):
    """The largest distance (m) and angle (rad) between two arms' ends over configurations q (m,
    n).
    """
    A, B = one.forward(q), other.forward(q)
    chord = np.linalg.norm(A[..., :3, :3] - B[..., :3, :3], axis=(-1, -2)) / np.sqrt(8)
    return (
        np.linalg.norm(A[..., :3, 3] - B[..., :3, 3], axis=-1).max(),
        2 * np.arcsin(np.clip(chord, 0, 1)).max(),
    )


def _size(apart):
    return f"{number(1000 * apart[0], 0)} mm and {number(np.rad2deg(apart[1]), 0)}°"
