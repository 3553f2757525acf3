"""``Table``: a DH table to be written, judged by the arm it describes."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...arm import Arm
from ...doctor import explain_rows
from ...geometry.equivalence import equivalent
from ...table import DHTable
from ..verdict import NOT_ATTEMPTED, RIGHT, Verdict
from .exercise import Exercise, no_draw, untouched
from .functions import CASES

__all__ = ["Table", "as_arm", "numbers"]

SAME = 1e-6  # rad, m; how far a right pose may be off


@dataclass(frozen=True, kw_only=True)
class Table(Exercise):
    """A DH table to be written, in metres and degrees, judged by the arm it describes: every right
    table passes.

    ``draw(rng)`` gives the task's numbers by name and ``answer(**given)`` the right Arm;
    ``mistakes(**given)`` yields (mistake, place, wrong Arm or its rows in degrees and metres)
    beyond those of the doctor's :func:`wrong_tables`; ``handed_out(**given)`` is the table of a
    "smallest fix", in degrees and metres, which is no attempt as long as it is unchanged.
    """

    answer: Callable
    draw: Callable = no_draw
    mistakes: Callable = lambda **given: ()
    handed_out: Callable | None = None

    def given(self, variant: int) -> Mapping[str, Any]:
        return self.draw(self.rng(variant))

    def right_arm(self, variant: int = 0) -> Arm:
        """The arm that is asked for."""
        return self.answer(**self.given(variant))

    def poses_at(self, variant: int) -> NDArray[np.float64]:
        """General configurations, (m, n)."""
        shape = CASES, len(self.right_arm(variant))
        return self.rng(variant).uniform(0.2, 1.3, shape) * self.rng(variant + 1).choice(
            [-1, 1], shape
        )

    def judge(self, answer: Any, variant: int = 0) -> Verdict:
        rows = list(answer) if isinstance(answer, (list, tuple)) else []
        stubs = [
            i
            for i, row in enumerate(rows, 1)
            if untouched(row) or (isinstance(row, (list, tuple)) and any(untouched(x) for x in row))
        ]
        if stubs:
            return self.say(
                NOT_ATTEMPTED,
                place=f"row {', row '.join(map(str, stubs))}",
                next="Put a number in place of every ...",
            )
        return super().judge(None if self._unchanged(answer, variant) else answer, variant)

    def compare(self, answer: Any, variant: int) -> Verdict:
        right = self.right_arm(variant)
        arm = self.arm_of(answer, right)
        if isinstance(arm, Verdict):
            return arm
        q = self.poses_at(variant)
        if not _apart(arm, right, q):
            choices = "; ".join(choice.message for choice in equivalent(right, arm).differences)
            other = f" Yours is another right table than ours: {choices}." if choices else ""
            return self.say(RIGHT, f"{self.praise}{other}")
        for mistake, place, wrong in self.mistakes(**self.given(variant)):
            if not _apart(as_arm(wrong, right), arm, q):
                return self.wrong(mistake, place=place)
        finding = explain_rows(arm, right, q)
        if finding:
            return self.wrong(finding.mistake, place=finding.place)
        return self.wrong(headline="this is another arm", place=_where(arm, right, q))

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
        try:
            arm = as_arm(answer, right)
        except ValueError as error:
            return self.wrong(headline=str(error))
        if len(arm) == len(right):
            return arm
        return self.wrong(
            headline=f"expected {len(right)} rows, found {len(arm)}", next="One row per joint."
        )


def _apart(one, other, q):
    """Whether two arms' ends differ somewhere."""
    return not np.allclose(one.forward(q), other.forward(q), rtol=0, atol=SAME)


def _where(arm, right, q):
    """The first joint whose axis is not where it must be, and which numbers may be to blame."""
    difference = np.abs(arm.forward(q) - right.forward(q)).max(axis=0)
    words = (
        "theta, alpha or the order of the rows"
        if difference[:3, :3].max() > SAME
        else "d and a: the rotation is right at every pose"
    )
    joint = equivalent(right, arm).joint
    axis = (
        f"joint {joint} is the first whose axis is not where it must be; "
        if joint
        else "every joint's axis is right, only the end is not; "
    )
    return f"{axis}look at {words}"


def as_arm(answer: Any, right: Arm) -> Arm:
    """The answer as an Arm with the right one's base, tool and signs; rows are degrees and metres.

    Raises
    ------
    ValueError
        It is no table.
    """
    if isinstance(answer, Arm):
        return answer
    if not isinstance(answer, DHTable):
        make = DHTable.standard if right.table.convention == "standard" else DHTable.craig
        fits = np.iterable(answer) and len(list(answer)) == len(right)
        answer = make(answer, angle="deg", joints=right.table.joints if fits else None)
    if len(answer) != len(right):
        return Arm(answer)
    return Arm(answer, base=right.base, tool=right.tool, sign=right.sign)


def numbers(table: DHTable) -> list[list[float]]:
    """The rows of a table, degrees and metres, without the dust of rounding.

    Examples
    --------
    >>> numbers(DHTable.standard([[0, 100, 0, 90]], angle="deg", length="mm"))
    [[0.0, 0.1, 0.0, 90.0]]
    """
    return (table.rows * [180 / np.pi, 1, 1, 180 / np.pi]).round(9).tolist()
