"""``Table``: a DH table to be written, judged by the arm it describes."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ....arm import Arm
from ....doctor import catalogue, explain_rows
from ....doctor.finding import Finding
from ....geometry.equivalence import equivalent
from ....printing import listed as joined
from ...verdict import NOT_ATTEMPTED, RIGHT, Verdict
from ..exercise import Exercise, Said, listed, no_draw, untouched
from ..functions import CASES
from ..kept import kept, kept_apart
from ..partial import PART_IS_RIGHT, filled_up
from ..wrong.drawn import drawn_table
from ..wrong.titles import OF_CRAIG, OF_TABLES
from .arms import IN_DEGREES, SAME, apart, in_table_units, size, where
from .entries import COLUMNS, differing
from .handed_in import as_arm, entries, lies_on_its_side, turned_round

__all__ = ["Table"]

ON_ITS_SIDE = Said(
    "rows and columns have changed places",
    next="One row per joint, with four numbers in each: np.transpose turns a table round.",
)


@dataclass(frozen=True, kw_only=True)
class Table(Exercise):
    """A DH table to be written, in metres and degrees, judged by the arm it describes: every right
    table passes.

    ``draw(rng)`` gives the task's numbers by name and ``answer(**given)`` the right Arm;
    ``mistakes(**given)`` yields (mistake, what is said, wrong Arm or its rows in degrees and
    metres) beyond those of the doctor's :func:`wrong_tables`; ``handed_out(**given)`` is the table
    of a "smallest fix", in degrees and metres, which is no attempt as long as it is unchanged.
    ``tolerance`` (rad, m) is how far the end may be off at any of the poses. ``convention`` is the
    one that is asked for, where the task asks for one ("" where any will do).
    """

    greek: ClassVar[bool] = True
    answer: Callable
    draw: Callable = no_draw
    mistakes: Callable = lambda **given: ()
    handed_out: Callable | None = None
    tolerance: float = SAME
    convention: str = ""

    @kept_apart
    def given(self, variant: int) -> Mapping[str, Any]:
        return self.draw(self.rng(variant))

    @kept
    def right_arm(self, variant: int) -> Arm:
        """The arm that is asked for."""
        return self.answer(**self.given(variant))

    def poses_at(self, variant: int) -> NDArray[np.float64]:
        """General configurations, (m, n)."""
        shape = CASES, len(self.right_arm(variant))
        return self.rng(variant).uniform(0.2, 1.3, shape) * self.rng(variant + 1).choice(
            [-1, 1], shape
        )

    def judge(self, answer: Any, variant: int = 0) -> Verdict:
        answer = listed(answer)
        if self._unchanged(answer, variant):
            return self.unchanged(answer, variant)
        return super().judge(answer, variant)

    def unchanged(self, answer: Any, variant: int) -> Verdict:
        """The Verdict on the table that was handed out."""
        return self.say(
            NOT_ATTEMPTED,
            "this is the table as it was handed out",
            next="Change it in the cell above, run that cell, then run this one again.",
        )

    def gaps(self, answer: Any) -> list[str]:
        rows = answer if isinstance(answer, (list, tuple)) else []
        return [
            f"row {i}" if untouched(row) else f"row {i}, {joined(names)}"
            for i, row in enumerate(rows, 1)
            if (names := [c for c, x in zip(COLUMNS, entries(row)) if untouched(x)])
        ]

    def so_far(self, answer: Any, variant: int) -> str:
        right = self.right_arm(variant).table.rows * IN_DEGREES
        filled = filled_up([entries(row) for row in answer], right)
        fits = filled is not None and not differing(filled, right).any()
        return PART_IS_RIGHT if fits else ""

    def compare(self, answer: Any, variant: int) -> Verdict:
        right = self.right_arm(variant)
        arm = self.arm_of(answer, right)
        return arm if isinstance(arm, Verdict) else self.judged(arm, right, variant)

    def judged(self, arm: Arm, right: Arm, variant: int) -> Verdict:
        """The Verdict on the arm that an answer describes."""
        q = self.poses_at(variant)
        off = apart(arm, right, q)
        if max(off) <= self.tolerance:
            if self.convention not in ("", arm.table.convention):
                return self._in_the_other(arm)
            return self._right(arm, right, off)
        return self.slowly(self._explained(arm, right, q, variant))

    def drawn(self, answer: Any, variant: int = 0) -> Any:
        right = self.right_arm(variant)
        arm = self.arm_of(answer, right)
        if isinstance(arm, Verdict) or arm.table.joints != right.table.joints:
            return None
        return drawn_table(arm, right)

    def _right(self, arm, right, off):
        """The Verdict on a right table: how it is another one than ours, or how far off it is."""
        if max(off) > SAME:
            return self.say(RIGHT, f"{self.praise} Yours is within {size(off)} of ours.")
        choices = "; ".join(choice.message for choice in equivalent(right, arm).differences)
        other = f" Yours is another right table than ours: {choices}." if choices else ""
        return self.say(RIGHT, f"{self.praise}{other}")

    def _in_the_other(self, arm):
        """The Verdict on rows of the right arm in the convention that was not asked."""
        names = {"standard": "standard rows", "craig": "Craig's rows"}
        return self.wrong(
            headline=f"these are {names[arm.table.convention]} of the right arm;"
            f" {names[self.convention]} are asked",
            next="Which of the four columns change when the convention does?",
        )

    def _explained(self, arm, right, q, variant):
        """The Verdict on another arm than the right one."""
        if len(right) == 4 and max(apart(turned_round(arm), right, q)) <= SAME:
            return self.told(None, ON_ITS_SIDE)
        return self._slip(arm, right, q, variant) or self.wrong(
            headline=f"this is another arm: up to {size(apart(arm, right, q))} off at the end",
            place=where(arm, right, q),
        )

    def _slip(self, arm, right, q, variant):
        """The Verdict on a slip that has a name; None."""
        unit = in_table_units(arm, right, q)
        if unit:
            return self.told(*unit)
        known = self.known(arm, q, variant)
        if known:
            return known
        finding = explain_rows(arm, right, q)
        return finding and self.found(finding, right.table.convention)

    def known(self, arm: Arm, q: NDArray[np.float64], variant: int) -> Verdict | None:
        """The Verdict on an arm that the exercise's own mistakes make; None."""
        for mistake, said, wrong in self._mistaken(variant):
            if max(apart(wrong, arm, q)) <= SAME:
                return self.told(mistake, said)
        return None

    @cached_property
    def _mistaken(self):
        """Of a variant: (mistake, what is said, wrong Arm) of the exercise's own mistakes; kept for
        the next try.
        """

        @lru_cache(maxsize=1)
        def of(variant):
            right = self.right_arm(variant)
            found = self.mistakes(**self.given(variant))
            return [(mistake, said, as_arm(wrong, right)) for mistake, said, wrong in found]

        return of

    def found(self, finding: Finding, convention: str = "standard") -> Verdict:
        """The Verdict on a mistake that the doctor found in a table, in the words of this exercise
        or by its title. What the catalogue sees elsewhere (turned by twice that angle, a pose that
        fits another matrix) need not be true of this arm.
        """
        if {finding.mistake, (finding.mistake, finding.place)} & self.words.keys():
            return self.wrong(finding.mistake, place=finding.place)
        mistake = catalogue()[finding.mistake]
        of_craig = OF_CRAIG.get(finding.mistake) if convention == "craig" else None
        said = (
            of_craig
            or OF_TABLES.get(finding.mistake)
            or Said(mistake.title, next=mistake.next, why=mistake.why)
        )
        all_that_have = finding.place == "all rows" and finding.mistake.startswith("offset")
        place = "every row that has one" if all_that_have else finding.place
        return self.told(finding.mistake, replace(said, place=place))

    def _unchanged(self, answer, variant):
        """Whether an answer, in whatever dress, is the table that was handed out."""
        if self.handed_out is None or untouched(answer):
            return False
        right = self.right_arm(variant)
        given = as_arm(self.handed_out(**self.given(variant)), right)
        try:
            arm = as_arm(answer, right)
        except ValueError:
            return False
        return (
            (arm.table.convention, arm.table.joints) == (given.table.convention, given.table.joints)
            and np.allclose(arm.table.rows, given.table.rows, rtol=0, atol=SAME)
            and np.allclose([arm.base, arm.tool], [given.base, given.tool])
            and np.array_equal(arm.sign, given.sign)
        )

    def arm_of(self, answer: Any, right: Arm) -> Arm | Verdict:
        """The answer as an Arm of as many joints as the right one; what is said of any other."""
        if lies_on_its_side(answer, len(right)):
            return self.told(None, ON_ITS_SIDE)
        try:
            arm = as_arm(answer, right)
        except ValueError as error:
            return self.wrong(headline=re.sub(r"^DHTable\.\w+: ", "", str(error)))
        if len(arm) == len(right):
            return arm
        return self.wrong(
            headline=f"expected {len(right)} rows, found {len(arm)}", next="One row per joint."
        )
