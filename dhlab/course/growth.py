"""From the pre-test to the post-test: what the learner could answer then, and what now."""

from collections.abc import Mapping
from html import escape
from typing import Any

from ..printing import grid_text
from .kinds import Exercise
from .verdict import NOT_ATTEMPTED, RIGHT

__all__ = ["Growth"]

HEADINGS = ("question", "then (lesson 00)", "now (lesson 09)")
THEN = {True: "✓ knew it", False: "not yet", None: "not asked"}


class Growth:
    """A line per question of the post-test: what was known at first, and how it stands now.

    Parameters
    ----------
    exercises : dict of str to Exercise
    known : dict of str to bool
        Of each question of the pre-test that was answered, whether the first answer was right.
    best : dict of str to (status, points)
    """

    def __init__(
        self,
        exercises: Mapping[str, Exercise],
        known: Mapping[str, bool],
        best: Mapping[str, tuple[str, float]],
    ) -> None:
        self._rows: dict[str, dict[str, Any]] = {
            key: {
                "title": e.title,
                "then": known.get(e.mirrors),
                "now": best.get(key, (NOT_ATTEMPTED, 0))[0] == RIGHT,
            }
            for key, e in exercises.items()
            if e.mirrors
        }

    def to_dict(self) -> dict[str, dict[str, Any]]:
        """{id: {title, then (True, False, or None when it was not asked), now}}."""
        return self._rows

    def _cells(self):
        return [
            [row["title"], THEN[row["then"]], "✓ right" if row["now"] else "not yet"]
            for row in self._rows.values()
        ]

    def _sum(self):
        rows = self._rows.values()
        now = f"now {sum(row['now'] for row in rows)} of {len(rows)}"
        if all(row["then"] is None for row in rows):
            return f"{now}; the pre-test is not in this course folder"
        return f"then {sum(bool(row['then']) for row in rows)} of {len(rows)}, {now}"

    def __str__(self) -> str:
        return grid_text(HEADINGS, self._cells()) + "\n " + self._sum()

    __repr__ = __str__

    def _repr_html_(self):
        head = "".join(
            f'<th scope="col" style="text-align:left">{escape(heading)}</th>'
            for heading in HEADINGS
        )
        rows = "".join(
            "<tr>"
            + "".join(f'<td style="text-align:left">{escape(cell)}</td>' for cell in cells)
            + "</tr>"
            for cells in self._cells()
        )
        return (
            f"<table><caption>{self._sum()}</caption><thead><tr>{head}</tr></thead>"
            f"<tbody>{rows}</tbody></table>"
        )
