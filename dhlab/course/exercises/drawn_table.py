"""A table exercise whose numbers differ from learner to learner."""

from collections.abc import Callable
from dataclasses import dataclass, fields

import numpy as np

from ...arm import Arm
from ...table import DHTable
from ..kinds import Table

__all__ = ["DrawnTable", "numbers"]


@dataclass(frozen=True, kw_only=True)
class DrawnTable(Table):
    """A DH table to be written for numbers that are drawn; judged as :class:`Table` does, so every
    right table passes.

    ``draw(rng)`` gives the task's numbers by name and ``arm(**given)`` the right Arm;
    ``slips(**given)`` yields (mistake, place, rows) that only this task invites, rows in degrees
    and metres; ``handed_out(**given)`` is the broken table of a "smallest fix", which is no attempt
    as long as it is unchanged.
    """

    draw: Callable
    arm: Callable
    slips: Callable = lambda **given: ()
    handed_out: Callable = None
    answer: Arm = None

    def __post_init__(self):
        object.__setattr__(self, "answer", self.arm(**self.given(0)))

    def given(self, variant):
        return self.draw(self.rng(variant))

    def compare(self, answer, variant):
        given = self.given(variant)
        if self.handed_out and _same_rows(answer, self.handed_out(**given)):
            return self.judge(None)
        right = self.arm(**given)
        make = getattr(DHTable, right.table.convention)

        def wrong_arms():
            for mistake, place, rows in self.slips(**given):
                yield mistake, place, Arm(make(rows, angle="deg"), base=right.base, tool=right.tool)

        shared = {field.name: getattr(self, field.name) for field in fields(Table)}
        return Table(**shared | {"answer": right, "mistakes": wrong_arms}).compare(answer, variant)


def numbers(table):
    """The rows of a DHTable as lists, degrees and metres, without the dust of rounding.

    Examples
    --------
    >>> numbers(DHTable.standard([[0, 100, 0, 90]], angle="deg", length="mm"))
    [[0.0, 0.1, 0.0, 90.0]]
    """
    return (table.rows * [180 / np.pi, 1, 1, 180 / np.pi]).round(9).tolist()


def _same_rows(answer, rows):
    """Whether an answer, in whatever dress, holds these rows (degrees and metres)."""
    table = getattr(answer, "table", answer)
    if isinstance(table, DHTable):
        table = numbers(table)
    try:
        return np.shape(table) == np.shape(rows) and np.allclose(
            np.asarray(table, dtype=float), rows, rtol=0, atol=1e-6
        )
    except (TypeError, ValueError):
        return False
