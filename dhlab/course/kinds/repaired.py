"""Two more kinds of table exercises: a broken table to be repaired, and a wrong table that passes a
weak test.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...doctor import explain_rows
from ...printing import number
from ..verdict import RIGHT
from . import Said, Table, as_arm

__all__ = ["Repair", "Impostor"]

COLUMNS = ("theta", "d", "a", "alpha")
SAME = 1e-6  # rad, m; and what a pose may differ by


@dataclass(frozen=True, kw_only=True)
class Repair(Table):
    """A broken table to be repaired.

    ``draw(rng)`` gives the task by name; its ``rows`` (n, 4), degrees and metres, are the broken
    table, which is no attempt as long as it is unchanged.
    """

    draw: Callable

    def given(self, variant):
        return self.draw(self.rng(variant))

    def judge(self, answer, variant=0):
        return super().judge(
            None if _unchanged(answer, self.given(variant)["rows"]) else answer, variant
        )

    def compare(self, answer, variant):
        verdict = super().compare(answer, variant)
        if verdict.status == RIGHT or verdict.mistake is not None:
            return verdict
        return self._by_entries(answer, _in_radians(self.given(variant)["rows"])) or verdict

    def _by_entries(self, answer, broken):
        """What to say of an answer in which one entry was changed: the wrong entry, or the right
        one to a wrong number; None for others.
        """
        try:
            rows = as_arm(answer, self.answer).table.rows
        except ValueError:
            return None
        changed = (
            [] if rows.shape != broken.shape else list(zip(*np.nonzero(abs(rows - broken) > SAME)))
        )
        if len(changed) != 1:
            return None
        ((i, k),) = changed
        place = f"row {i + 1}, {COLUMNS[k]}"
        if abs(broken[i, k] - self.answer.table.rows[i, k]) < SAME:
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
    right one unchanged is no attempt.
    """

    def judge(self, answer, variant=0):
        rows = self.answer.table.rows * [180 / np.pi, 1, 1, 180 / np.pi]
        return super().judge(None if _unchanged(answer, rows) else answer, variant)

    def compare(self, answer, variant):
        try:
            arm = as_arm(answer, self.answer)
        except ValueError as error:
            return self.wrong(headline=str(error))
        if len(arm) != len(self.answer):
            return self.wrong(
                headline=f"expected {len(self.answer)} rows, found {len(arm)}",
                next="One row per joint.",
            )
        q = self.poses_at(variant)
        seen, hidden = _apart(arm, self.answer, 0 * q[:1]), _apart(arm, self.answer, q)
        if max(seen) > SAME:
            finding = explain_rows(arm, self.answer, q)
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


def _unchanged(answer, rows):
    """Whether an answer is rows of plain numbers, and just these."""
    try:
        array = np.asarray(answer, dtype=float)
    except (TypeError, ValueError):
        return False
    return array.shape == np.shape(rows) and np.allclose(array, rows, rtol=0, atol=1e-12)


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
