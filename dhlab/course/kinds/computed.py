"""Answers that are worked out: a number or an array, a program, a table."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...arm import Arm
from ...doctor import explain_function, explain_rows
from ...doctor.programs.calling import Called, CallFault, call_all, is_stub
from ...geometry.equivalence import equivalent
from ...table import DHTable
from ..verdict import NOT_ATTEMPTED, RIGHT
from .exercise import Exercise, untouched

__all__ = ["Value", "Function", "Table", "CASES", "as_arm"]

CASES = 24  # seeded inputs of a function exercise, and poses of a table exercise


def _no_draw(rng):
    return {}


@dataclass(frozen=True, kw_only=True)
class Value(Exercise):
    """A number or an array to be given.

    ``draw(rng)`` gives the task's numbers by name; ``answer(**given)`` the right value;
    ``mistakes(**given)`` yields (mistake, place, wrong value); ``entries`` names the entries of a
    vector, for the place; ``turns`` are the positions of the entries that are angles in degrees:
    these are compared modulo 360, with the right value and with the wrong ones.
    """

    answer: Callable
    draw: Callable = _no_draw
    mistakes: Callable = lambda **given: ()
    entries: tuple = ()
    turns: tuple = ()
    tolerance: float = 1e-3

    def given(self, variant):
        return self.draw(self.rng(variant))

    def compare(self, answer, variant):
        given = self.given(variant)
        expected = np.asarray(self.answer(**given), dtype=float)
        try:
            array = np.asarray(answer)
            array = (
                array
                if array.dtype.kind in "iuf"
                else array.astype(float, casting="unsafe" if array.dtype.kind == "O" else "safe")
            )
        except (TypeError, ValueError):
            return self.wrong(
                headline=f"expected {_amount(expected)}, found {type(answer).__name__}",
                next="Give plain numbers, all of them, no text.",
            )
        if array.shape != expected.shape:
            return self.wrong(headline=f"expected {_amount(expected)}, found {_amount(array)}")
        if not np.isfinite(array).all():
            return self.wrong(headline="expected finite numbers, found NaN or infinity")
        off = self.differs(array, expected)
        if not off.any():
            return self.right()
        for mistake, place, value in self.mistakes(**given):
            if (
                np.shape(value) == array.shape
                and not self.differs(array, np.asarray(value, dtype=float)).any()
            ):
                return self.wrong(mistake, place=place)
        if np.array_equal(array, np.trunc(expected)) and array.dtype.kind == "i":
            return self.wrong("integer-arrays")
        return self.wrong(headline="these are not the numbers", place=self._place(off))

    def differs(self, array, value):
        """Which entries of an array differ from those of a value, or of a stack of values; whole
        turns apart where they are angles.
        """
        difference = np.asarray(array - value)
        angles = np.isin(np.arange(array.size), self.turns).reshape(array.shape)
        difference = np.where(angles, difference - 360 * np.round(difference / 360), difference)
        return ~(np.abs(difference) <= self.tolerance * (1 + np.abs(value)))

    def _place(self, off):
        if off.ndim == 2:
            i, j = np.argwhere(off)[0] + 1
            return f"{off.sum()} of {off.size} entries, the first in row {i}, column {j}"
        names = self.entries or [f"number {k + 1}" for k in range(off.size)]
        return ", ".join(name for name, bad in zip(names, np.ravel(off)) if bad) if off.ndim else ""


def _amount(array):
    return "one number" if array.ndim == 0 else f"{'×'.join(map(str, array.shape))} numbers"


@dataclass(frozen=True, kw_only=True)
class Function(Exercise):
    """A function to be written, compared with the right one on seeded inputs.

    ``draw(rng)`` gives the arguments of one call, general ones; ``special`` are calls that come
    after them, where an if may hide (zeros, right angles); ``answer(*case)`` the right result;
    ``family`` names the wrong versions that the doctor compares with; ``handed_out`` is the broken
    program of a "smallest fix", which is no attempt as long as it is unchanged; ``read(answer)`` is
    the answer as it is compared, what is free in it (whole turns, an order) taken out; ``library``:
    it may call dhlab's own kinematics, which otherwise earns nothing when it is graded.
    """

    answer: Callable
    draw: Callable
    names: tuple
    family: str
    special: tuple = ()
    handed_out: Callable = None
    shape: tuple = (4, 4)
    read: Callable = np.asarray
    library: bool = False
    tolerance: float = 1e-9

    def cases(self, variant):
        """The arguments of every call."""
        rng = self.rng(variant)
        return [*(self.draw(rng) for _ in range(CASES)), *self.special]

    def judge(self, answer, variant=0):
        if is_stub(answer):
            answer = None
        try:
            return super().judge(answer, variant)
        except NotImplementedError:
            return super().judge(None, variant)

    def compare(self, answer, variant):
        if not callable(answer) and not isinstance(answer, Called):
            return self.wrong(
                headline=f"expected the function itself, found {type(answer).__name__}",
                next="Hand in its name without brackets.",
            )
        cases = self.cases(variant)
        try:
            answers = [
                self.read(given) for given in call_all(answer, cases, self.shape, self.names)
            ]
        except CallFault as fault:
            return self.wrong(
                fault.mistake, headline=fault.headline, place=fault.place, next=fault.next
            )
        if self.handed_out and all(
            np.allclose(a, self.handed_out(*case)) for a, case in zip(answers, cases)
        ):
            return self.say(
                NOT_ATTEMPTED,
                "the program answers as it did when it was handed out",
                next="If you have changed something, it makes no difference: look elsewhere.",
            )
        expected = [self.answer(*case) for case in cases]
        off = [
            not np.allclose(a, e, rtol=self.tolerance, atol=self.tolerance)
            for a, e in zip(answers, expected)
        ]
        if not any(off):
            return self.right()
        if not any(off[:CASES]):
            return self.wrong(
                headline=(
                    "right at general numbers, wrong where an angle is 0, 90° or 180°, or a length"
                    " is 0"
                ),
                place=self._call(cases[off.index(True)]),
                next=(
                    "Look for a special case in the program: an if, a division, or a rounding of"
                    " small numbers to 0."
                ),
            )
        answers, expected, cases, off = (
            answers[:CASES],
            expected[:CASES],
            cases[:CASES],
            off[:CASES],
        )
        finding = explain_function(answers, expected, cases, self.family)
        known = self.refine(finding and finding.mistake, answers, cases)
        if known:
            return self.wrong(known[0], place=known[1])
        if finding:
            return self.wrong(
                finding.mistake, place="; ".join(filter(None, (finding.place, finding.detail)))
            )
        if all(np.array_equal(a, answers[0]) for a in answers):
            return self.wrong(
                headline="the answer is the same whatever goes in",
                next="Does the function use its arguments, and return what the loop made?",
            )
        return self.wrong(
            headline="the answers differ from the right ones",
            place=f"{sum(off)} of {len(off)} calls; {self._parts(answers, expected)}",
        )

    def refine(self, mistake, answers, cases):
        """(mistake, place or Said) where the exercise knows more of wrong answers than the doctor,
        who found ``mistake`` or None; else None.
        """
        return None

    def _call(self, case):
        """The arguments of a call, where they are few enough to be read."""
        return (
            "with " + ", ".join(f"{name} = {value:.4g}" for name, value in zip(self.names, case))
            if all(np.ndim(value) == 0 for value in case)
            else ""
        )

    def _parts(self, answers, expected):
        """Which block of the pose is wrong."""
        difference = np.abs(np.array(answers) - np.array(expected)).max(axis=0)
        if len(self.shape) == 2 and self.shape != (4, 4):
            return "wrong in column " + ", ".join(
                str(j + 1) for j in np.flatnonzero(difference.max(axis=0) > 1e-9)
            )
        if self.shape != (4, 4):
            return (
                f"numbers {', '.join(str(k + 1) for k in np.flatnonzero(difference > 1e-9))} differ"
                if len(self.shape) == 1
                else ""
            )
        R, p = difference[:3, :3].max() > 1e-9, difference[:3, 3].max() > 1e-9
        return (
            "rotation and position"
            if R and p
            else "only the rotation"
            if R
            else "only the position"
        )


@dataclass(frozen=True, kw_only=True)
class Table(Exercise):
    """A DH table to be written, in metres and degrees, judged by the arm it describes: every right
    table passes.

    ``answer`` is the right Arm; ``mistakes()`` yields (mistake, place, wrong Arm) beyond those of
    the doctor's :func:`wrong_tables`.
    """

    answer: Arm
    mistakes: Callable = tuple

    def poses_at(self, variant):
        """General configurations, (m, n)."""
        return self.rng(variant).uniform(0.2, 1.3, (CASES, len(self.answer))) * self.rng(
            variant + 1
        ).choice([-1, 1], (CASES, len(self.answer)))

    def judge(self, answer, variant=0):
        rows = list(answer) if isinstance(answer, (list, tuple)) else []
        stubs = [
            i
            for i, row in enumerate(rows, 1)
            if untouched(row) or isinstance(row, (list, tuple)) and any(untouched(x) for x in row)
        ]
        if stubs:
            return self.say(
                NOT_ATTEMPTED,
                place=f"row {', row '.join(map(str, stubs))}",
                next="Put a number in place of every ...",
            )
        return super().judge(answer, variant)

    def compare(self, answer, variant):
        try:
            arm = as_arm(answer, self.answer)
        except ValueError as error:
            return self.wrong(headline=str(error))
        n = len(self.answer)
        if len(arm) != n:
            return self.wrong(
                headline=f"expected {n} rows, found {len(arm)}", next="One row per joint."
            )
        q = self.poses_at(variant)
        difference = np.abs(arm.forward(q) - self.answer.forward(q)).max(axis=0)
        verdict = equivalent(self.answer, arm)
        if difference.max() < 1e-6:
            choices = "; ".join(choice.message for choice in verdict.differences)
            return self.say(
                RIGHT,
                (
                    f"{self.praise} Yours is another right table than ours: {choices}."
                    if choices
                    else self.praise
                ),
            )
        for mistake, place, wrong in self.mistakes():
            if np.allclose(wrong.forward(q), arm.forward(q), rtol=0, atol=1e-6):
                return self.wrong(mistake, place=place)
        finding = explain_rows(arm, self.answer, q)
        if finding:
            return self.wrong(finding.mistake, place=finding.place)
        rotation = difference[:3, :3].max() > 1e-6
        words = (
            "theta, alpha or the order of the rows"
            if rotation
            else "d and a: the rotation is right at every pose"
        )
        axis = (
            f"joint {verdict.joint} is the first whose axis is not where it must be; "
            if verdict.joint
            else "every joint's axis is right, only the end is not; "
        )
        return self.wrong(headline="this is another arm", place=f"{axis}look at {words}")


def as_arm(answer, right):
    """The answer as an Arm with the right one's base, tool and signs; rows are degrees and
    metres.
    """
    if isinstance(answer, Arm):
        return answer
    if not isinstance(answer, DHTable):
        make = DHTable.standard if right.table.convention == "standard" else DHTable.craig
        answer = make(
            answer,
            angle="deg",
            joints=(
                right.table.joints
                if np.iterable(answer) and len(list(answer)) == len(right)
                else None
            ),
        )
    if len(answer) != len(right):
        return Arm(answer)
    return Arm(answer, base=right.base, tool=right.tool, sign=right.sign)
