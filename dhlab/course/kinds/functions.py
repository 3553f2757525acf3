"""``Function``: a program to be written, compared with the right one on seeded inputs."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ...doctor import catalogue, explain_function
from ...doctor.programs.cases import is_long, where
from ...doctor.programs.explain import AND, NUMBERS
from ...doctor.programs.running.answers import answers_in_time
from ...doctor.programs.running.calling import Called, CallFault, is_stub
from ...doctor.programs.source.precision import SINGLE, single_precision
from ...printing import listed as joined
from ...table import COLUMNS
from ..verdict import NOT_ATTEMPTED, RIGHT, WRONG, Verdict
from .dots import lines_with_dots
from .exercise import Exercise, Said
from .kept import kept_apart
from .wrong.titles import IN_DEGREES, OF_LINKS, OF_OTHERS, OF_POSES, OF_PROGRAMS
from .wrong.units import Group, in_other_units

__all__ = ["CASES", "Function"]

NEAR = 1e-7  # largest deviation of a program that was changed by way of trial
SECONDS = 0.5  # of the processor, to look for the lines that must change
COARSER = 100  # times what an exercise allows itself, where that is much: single precision
IN_DOUBLE = "It computes in single precision (float32): say dtype=float, and check it again."
# seeded inputs of a function exercise, unless it says how many, and poses of a table exercise
CASES = 24


@dataclass(frozen=True, kw_only=True)
class Function(Exercise):
    """A function to be written, compared with the right one on seeded inputs.

    ``draw(rng)`` gives the arguments of one call, general ones, or with ``together``
    ``draw(rng, count)`` those of all; there are ``calls`` of them. ``special`` are calls that come
    after them, where an if may hide (zeros, right angles); ``answer(*case)`` the right result;
    ``family`` names the wrong versions that the doctor compares with; ``handed_out`` is the broken
    program of a "smallest fix", which is no attempt as long as it is unchanged; ``read(answer)`` is
    the answer as it is compared, what is free in it (whole turns, an order) taken out; ``library``:
    it may call dhlab's own kinematics, which otherwise earns nothing when it is graded;
    ``if_special`` is the next step of a program that is wrong in special calls alone; ``angles``:
    the answers are angles, in radians; ``watched``: it is asked which functions made matrices.
    """

    answer: Callable
    draw: Callable
    names: tuple
    family: str
    together: bool = False
    calls: int = CASES
    special: tuple = ()
    handed_out: Callable | None = None
    shape: tuple = (4, 4)
    read: Callable = np.asarray
    library: bool = False
    if_special: str = (
        "Look for a special case in the program: an if, a division, or a rounding of small numbers"
        " to 0."
    )
    angles: bool = False
    tolerance: float = 1e-9
    watched: ClassVar[bool] = False

    @kept_apart
    def cases(self, variant: int) -> list[tuple]:
        """The arguments of every call."""
        rng = self.rng(variant)
        if self.together:
            return [*self.draw(rng, self.calls), *self.special]
        return [*(self.draw(rng) for _ in range(self.calls)), *self.special]

    def right_answers(self, cases: Sequence[tuple]) -> list[NDArray]:
        """The right answer to each call."""
        return [self.answer(*case) for case in cases]

    def judge(self, answer: Any, variant: int = 0) -> Verdict:
        if is_stub(answer):
            answer = None
        try:
            return super().judge(answer, variant)
        except NotImplementedError:
            return super().judge(None, variant)
        except KeyboardInterrupt:
            return self.wrong(
                headline="you interrupted the check before it came to an end",
                next="Run the cell again.",
            )

    def compare(self, answer: Any, variant: int) -> Verdict:
        verdict = self._called(answer, variant)
        gaps = lines_with_dots(answer) if verdict.status == WRONG else []
        if not gaps:
            return verdict
        return self.say(
            NOT_ATTEMPTED,
            "dots are left in the program",
            place=f"line{'s' if len(gaps) > 1 else ''} {joined(map(str, gaps))}",
            next="Put what belongs there in place of every ...",
        )

    def _called(self, answer, variant):
        """The Verdict on what a program gives when it is called."""
        if not callable(answer) and not isinstance(answer, Called):
            return self.wrong(
                headline=f"expected the function itself, found {type(answer).__name__}",
                next="Hand in its name without brackets.",
            )
        cases = self.cases(variant)
        try:
            called, given = answers_in_time(answer, cases, self.shape, self.names)
            cases, general = [cases[k] for k in called], sum(k < self.calls for k in called)
            told = isinstance(answer, Called) and answer.single
            single = told or single_precision(answer, given)
            tolerance = max(SINGLE, COARSER * self.tolerance) if single else self.tolerance
            answers = [self.read(one) for one in given]
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
        expected = self.right_answers(cases)
        verdict = self._in_degrees(given, expected) or self._compared(
            answers, expected, cases, general, tolerance
        )
        known = verdict.status == RIGHT or verdict.mistake
        return verdict if known else self._told_where(verdict, answer, cases)

    def _in_degrees(self, given, expected):
        """The Verdict on angles that are right as degrees; None."""
        if self.angles and all(
            np.allclose(self.read(np.deg2rad(one)), right, rtol=0, atol=NEAR)
            for one, right in zip(given, expected)
        ):
            return self.told(None, IN_DEGREES)
        return None

    def _told_where(self, verdict, f, cases):
        """The Verdict, with the lines in which something must change, where trying finds them."""
        if self.handed_out or self.read is not np.asarray:
            return verdict
        from ...doctor.programs.source.lines import lines_to_change  # large, and for wrong ones

        calls = [(case, np.asarray(self.answer(*case), dtype=float)) for case in cases]
        lines, *_ = lines_to_change(f, calls, NEAR, SECONDS)
        if not lines:
            return verdict
        numbers = " and ".join(str(number) for number in dict.fromkeys(x.number for x in lines))
        where = f"line{'s' if ' ' in numbers else ''} {numbers}"
        return replace(verdict, place="; ".join(filter(None, (verdict.place, f"look at {where}"))))

    def _compared(self, answers, expected, cases, general, tolerance):
        """The Verdict on what the calls gave, of which the first are ``general``."""
        off = _apart(answers, expected, tolerance)
        if not any(off):
            return self.right()
        if not any(off[:general]):
            wrong = [case for case, bad in zip(cases, off) if bad]
            right = [case for case, bad in zip(cases, off) if not bad]
            place = where(self.family, wrong, right)
            return self.wrong(
                headline=f"right at general numbers, wrong {'where ' if place else 'in a special '}"
                f"{place or 'case'}",
                place=self._call(wrong[0]),
                next=IN_DOUBLE if tolerance > self.tolerance else self.if_special,
            )
        asked = [
            k for k in range(len(cases)) if k < general or (self._of_rows and is_long(cases[k]))
        ]
        explained = self._explained(
            [answers[k] for k in asked],
            [expected[k] for k in asked],
            [cases[k] for k in asked],
            sum(off[k] for k in asked),
        )
        return self.slowly(explained)

    @property
    def _of_rows(self):
        """Whether it is called with rows of a table."""
        return self.family.endswith("_transform") or self.family == "forward_kinematics"

    def _explained(self, answers, expected, cases, off):
        """The Verdict on a program that is wrong at general numbers, in ``off`` of the calls."""
        unit = self._in_other_units(np.array(answers), np.array(expected))
        if unit:
            return self.told(*unit)
        finding = explain_function(answers, expected, cases, self.family)
        known = self.refine(finding and finding.mistake, answers, cases)
        if known:
            return self.wrong(known[0], place=known[1])
        if finding:
            return self._found(finding)
        if all(np.array_equal(a, answers[0]) for a in answers):
            return self.wrong(
                headline="the answer is the same whatever goes in",
                next="Does the function use its arguments, and return what it makes of them?",
            )
        return self.wrong(
            headline="the answers differ from the right ones",
            place=f"{off} of {len(cases)} calls; {self.parts(answers, expected, cases)}",
        )

    def _found(self, finding):
        """The Verdict on a mistake that the doctor found. The catalogue speaks of poses; of a
        program that gives other numbers its title and the doctor's place are said, or the place
        alone where that is a sentence and the title is about poses.
        """
        mistake, place = finding.mistake, finding.place
        if finding.detail:  # what is said of one mistake alone is not true of two
            return self._found_several(finding)
        if {mistake, (mistake, place)} & self.words.keys():
            return self.wrong(mistake, place=place)
        if self.family not in NUMBERS:
            of_link = OF_LINKS.get(mistake) if len(self.names) == len(COLUMNS) else None
            said = of_link or OF_PROGRAMS.get(mistake)
            return self.wrong(mistake, place=replace(said, place=place) if said else place)
        if mistake in OF_OTHERS.get(self.family, OF_POSES) and place:
            return self.told(mistake, Said(place))
        return self.told(mistake, Said(catalogue()[mistake].title, place=place))

    def _found_several(self, finding):
        """The Verdict on mistakes that only together explain the answers: their titles."""
        alone = self._found(replace(finding, detail=""))
        title = catalogue()[finding.mistake].title
        place = f" ({finding.place})" if finding.place else ""
        slips = [f"{title}{place}", *finding.detail.split(AND)]
        headline = f"several slips: {AND.join(map(_within, slips))}"
        return replace(alone, headline=headline, place="", why="")

    def _in_other_units(self, answers, expected):
        """The slip of units that explains poses, with what is said of it; None."""
        if self.shape != (4, 4) or answers.dtype.kind != "f":
            return None
        position = np.zeros(answers.shape, dtype=bool)
        position[:, :3, 3] = True
        return in_other_units(
            answers,
            [Group("the position", "m", position)],
            lambda numbers: np.allclose(numbers, expected, rtol=1e-6, atol=1e-6),
        )

    def refine(
        self, mistake: str | None, answers: Sequence[NDArray], cases: Sequence[tuple]
    ) -> tuple[str | None, str | Said] | None:
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

    def parts(
        self, answers: Sequence[NDArray], expected: Sequence[NDArray], cases: Sequence[tuple]
    ) -> str:
        """Which block of the pose is wrong, or which numbers of a vector are."""
        difference = np.abs(np.array(answers) - np.array(expected)).max(axis=0)
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


def _apart(answers, expected, tolerance):
    """Of each answer, whether it is another than the one expected; all have one shape."""
    near = np.isclose(np.array(answers), np.array(expected), rtol=tolerance, atol=tolerance)
    return (~near.reshape(len(near), -1).all(axis=1)).tolist()


def _within(title):
    """A title as part of a sentence: "The inverse pose" begins small, "T_06" does not."""
    return title[0].lower() + title[1:] if title[1:2].islower() or title[1:2] == " " else title
