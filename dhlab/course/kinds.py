"""The kinds of exercises: each knows how to draw its numbers from a seed and how to judge an answer."""

import zlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np

from ..arm import Arm
from ..doctor import catalogue, explain_function, explain_rows
from ..doctor.calling import Called, CallFault, call_all, is_stub
from ..equivalence import equivalent
from ..table import DHTable
from .verdict import NOT_ATTEMPTED, RECORDED, RIGHT, WRONG, Verdict

__all__ = ["Exercise", "Value", "Function", "Table", "Choice", "Order", "PreTest", "Prediction", "Option", "UNDECIDED"]

UNDECIDED = "?"  # "I don't know yet", in every choice
CASES = 24  # seeded inputs of a function exercise, and poses of a table exercise


@dataclass(frozen=True, kw_only=True)
class Exercise:
    """What every exercise has: an id such as "05.2", a title, points, two hints, and what is said when it is right.

    ``mirrors`` is the id of the pre-test question that a question of the post-test asks again.
    """

    id: str
    title: str
    points: float = 1
    hints: tuple = ()
    praise: str = ""
    mirrors: str = ""

    def rng(self, variant):
        """The generator of this exercise's numbers: the same for the same variant, everywhere."""
        return np.random.default_rng([zlib.crc32(self.id.encode()), variant])

    def given(self, variant):
        """The numbers of the task, by name; none for most kinds."""
        return {}

    def judge(self, answer, variant=0):
        """The Verdict on an answer; never raises because of the answer."""
        if _untouched(answer):
            return self.say(NOT_ATTEMPTED, next="Fill in the cell above, run it, then run this one again.")
        return self.compare(answer, variant)

    def compare(self, answer, variant):
        """The Verdict on an answer that was attempted."""
        raise NotImplementedError

    def say(self, status, headline="", **words):
        """A Verdict of this exercise."""
        return Verdict(self.id, status, headline, points=self.points if status == RIGHT else 0, of=self.points, **words)

    def right(self):
        """The Verdict on a right answer."""
        return self.say(RIGHT, self.praise)

    def wrong(self, mistake_id=None, headline="", place="", next=""):
        """The Verdict on a wrong answer, in the catalogue's words when the mistake is known."""
        if mistake_id is None:
            return self.say(WRONG, headline, place=place, next=next or f'hint("{self.id}") gives a first hint.')
        mistake = catalogue()[mistake_id]
        return self.say(WRONG, headline or f"{mistake.title}. {mistake.see}", place=place, why=mistake.why, next=next or mistake.next, mistake=mistake_id)


def _untouched(answer):
    if answer is None or answer is Ellipsis:
        return True
    return isinstance(answer, (list, tuple)) and len(answer) > 0 and all(_untouched(entry) for entry in answer)


def _no_draw(rng):
    return {}


@dataclass(frozen=True, kw_only=True)
class Value(Exercise):
    """A number or an array to be given.

    ``draw(rng)`` gives the task's numbers by name; ``answer(**given)`` the right value; ``mistakes(**given)`` yields
    (mistake, place, wrong value); ``entries`` names the entries of a vector, for the place.
    """

    answer: Callable
    draw: Callable = _no_draw
    mistakes: Callable = lambda **given: ()
    entries: tuple = ()
    tolerance: float = 1e-3

    def given(self, variant):
        return self.draw(self.rng(variant))

    def compare(self, answer, variant):
        given = self.given(variant)
        expected = np.asarray(self.answer(**given), dtype=float)
        try:
            array = np.asarray(answer)
            array = array if array.dtype.kind in "iuf" else array.astype(float, casting="unsafe" if array.dtype.kind == "O" else "safe")
        except (TypeError, ValueError):
            return self.wrong(headline=f"expected {_amount(expected)}, found {type(answer).__name__}", next="Give plain numbers, all of them, no text.")
        if array.shape != expected.shape:
            return self.wrong(headline=f"expected {_amount(expected)}, found {_amount(array)}")
        if not np.isfinite(array).all():
            return self.wrong(headline="expected finite numbers, found NaN or infinity")
        off = np.abs(array - expected) > self.tolerance * (1 + np.abs(expected))
        if not off.any():
            return self.right()
        for mistake, place, value in self.mistakes(**given):
            if np.shape(value) == array.shape and np.allclose(array, value, rtol=self.tolerance, atol=self.tolerance):
                return self.wrong(mistake, place=place)
        if np.array_equal(array, np.trunc(expected)) and array.dtype.kind == "i":
            return self.wrong("integer-arrays")
        return self.wrong(headline="these are not the numbers", place=self._place(off))

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

    ``draw(rng)`` gives the arguments of one call; ``answer(*case)`` the right result; ``family`` names the wrong versions that
    the doctor compares with; ``handed_out`` is the broken program of a "smallest fix", which is no attempt as long as it is unchanged;
    ``read(answer)`` is the answer as it is compared, what is free in it (whole turns, an order) taken out; ``library``: it may call dhlab's own
    kinematics, which otherwise earns nothing when it is graded.
    """

    answer: Callable
    draw: Callable
    names: tuple
    family: str
    handed_out: Callable = None
    shape: tuple = (4, 4)
    read: Callable = np.asarray
    library: bool = False
    tolerance: float = 1e-9

    def cases(self, variant):
        """The arguments of every call."""
        rng = self.rng(variant)
        return [self.draw(rng) for _ in range(CASES)]

    def judge(self, answer, variant=0):
        if is_stub(answer):
            answer = None
        try:
            return super().judge(answer, variant)
        except NotImplementedError:
            return super().judge(None, variant)

    def compare(self, answer, variant):
        if not callable(answer) and not isinstance(answer, Called):
            return self.wrong(headline=f"expected the function itself, found {type(answer).__name__}", next="Hand in its name without brackets.")
        cases = self.cases(variant)
        try:
            answers = [self.read(given) for given in call_all(answer, cases, self.shape, self.names)]
        except CallFault as fault:
            return self.wrong(fault.mistake, headline=fault.headline, place=fault.place, next=fault.next)
        if self.handed_out and all(np.allclose(a, self.handed_out(*case)) for a, case in zip(answers, cases)):
            return self.judge(None)
        expected = [self.answer(*case) for case in cases]
        off = [not np.allclose(a, e, rtol=self.tolerance, atol=self.tolerance) for a, e in zip(answers, expected)]
        if not any(off):
            return self.right()
        finding = explain_function(answers, expected, cases, self.family)
        if finding:
            return self.wrong(finding.mistake, place="; ".join(filter(None, (finding.place, finding.detail))))
        if all(np.array_equal(a, answers[0]) for a in answers):
            return self.wrong(headline="the answer is the same whatever goes in", next="Does the function use its arguments, and return what the loop made?")
        return self.wrong(headline="the answers differ from the right ones", place=f"{sum(off)} of {len(off)} calls; {self._parts(answers, expected)}")

    def _parts(self, answers, expected):
        """Which block of the pose is wrong."""
        difference = np.abs(np.array(answers) - np.array(expected)).max(axis=0)
        if len(self.shape) == 2 and self.shape != (4, 4):
            return "wrong in column " + ", ".join(str(j + 1) for j in np.flatnonzero(difference.max(axis=0) > 1e-9))
        if self.shape != (4, 4):
            return "look at each entry"
        R, p = difference[:3, :3].max() > 1e-9, difference[:3, 3].max() > 1e-9
        return "rotation and position" if R and p else "only the rotation" if R else "only the position"


@dataclass(frozen=True, kw_only=True)
class Table(Exercise):
    """A DH table to be written, in metres and degrees, judged by the arm it describes: every right table passes.

    ``answer`` is the right Arm; ``mistakes()`` yields (mistake, place, wrong Arm) beyond those of the doctor's :func:`wrong_tables`.
    """

    answer: Arm
    mistakes: Callable = tuple

    def poses_at(self, variant):
        """General configurations, (m, n)."""
        return self.rng(variant).uniform(0.2, 1.3, (CASES, len(self.answer))) * self.rng(variant + 1).choice([-1, 1], (CASES, len(self.answer)))

    def judge(self, answer, variant=0):
        rows = list(answer) if isinstance(answer, (list, tuple)) else []
        stubs = [i for i, row in enumerate(rows, 1) if _untouched(row) or isinstance(row, (list, tuple)) and any(_untouched(x) for x in row)]
        if stubs:
            return self.say(NOT_ATTEMPTED, place=f"row {', row '.join(map(str, stubs))}", next="Put a number in place of every ...")
        return super().judge(answer, variant)

    def compare(self, answer, variant):
        try:
            arm = _as_arm(answer, self.answer)
        except ValueError as error:
            return self.wrong(headline=str(error))
        n = len(self.answer)
        if len(arm) != n:
            return self.wrong(headline=f"expected {n} rows, found {len(arm)}", next="One row per joint.")
        q = self.poses_at(variant)
        difference = np.abs(arm.forward(q) - self.answer.forward(q)).max(axis=0)
        verdict = equivalent(self.answer, arm)
        if difference.max() < 1e-6:
            choices = "; ".join(choice.message for choice in verdict.differences)
            return self.say(RIGHT, f"{self.praise} Yours is another right table than ours: {choices}." if choices else self.praise)
        for mistake, place, wrong in self.mistakes():
            if np.allclose(wrong.forward(q), arm.forward(q), rtol=0, atol=1e-6):
                return self.wrong(mistake, place=place)
        finding = explain_rows(arm, self.answer, q)
        if finding:
            return self.wrong(finding.mistake, place=finding.place)
        rotation = difference[:3, :3].max() > 1e-6
        words = "theta, alpha or the order of the rows" if rotation else "d and a: the rotation is right at every pose"
        axis = f"joint {verdict.joint} is the first whose axis is not where it must be; " if verdict.joint else "every joint's axis is right, only the end is not; "
        return self.wrong(headline="this is another arm", place=f"{axis}look at {words}")


def _as_arm(answer, right):
    """The answer as an Arm with the right one's base, tool and signs; rows are degrees and metres."""
    if isinstance(answer, Arm):
        return answer
    if not isinstance(answer, DHTable):
        make = DHTable.standard if right.table.convention == "standard" else DHTable.craig
        answer = make(answer, angle="deg", joints=right.table.joints if np.iterable(answer) and len(list(answer)) == len(right) else None)
    if len(answer) != len(right):
        return Arm(answer)
    return Arm(answer, base=right.base, tool=right.tool, sign=right.sign)


@dataclass(frozen=True)
class Option:
    """One option of a choice: its text, what is said to who chooses it, and the mistake it stands for (None when it is right)."""

    text: str
    answer: str
    mistake: str | None = None


@dataclass(frozen=True, kw_only=True)
class Choice(Exercise):
    """One option to be chosen by its letter; "?" is "I don't know yet"."""

    options: Mapping
    correct: str
    undecided: str = "Good to say so. Read the paragraph above once more, then choose."

    def compare(self, answer, variant):
        letter = answer.strip().lower() if isinstance(answer, str) else ""
        if letter == UNDECIDED:
            return self.say(WRONG, self.undecided, next=f'hint("{self.id}") gives a first hint.')
        if letter not in self.options:
            return self.wrong(headline=f'expected one of {", ".join(self.options)} or "?", found {answer!r}', next='Write the letter in quotes, such as "a".')
        option = self.options[letter]
        if letter == self.correct:
            return self.say(RIGHT, option.answer)
        return self.say(WRONG, option.answer, mistake=option.mistake, why="" if option.mistake is None else catalogue()[option.mistake].why)


@dataclass(frozen=True, kw_only=True)
class Order(Exercise):
    """Items to be put in order or matched: the answer is a list of letters.

    ``accepts(letters)`` says whether an order is right, since more than one may be; ``explain(letters)`` gives (mistake, place) or None.
    """

    items: Mapping
    accepts: Callable
    explain: Callable = lambda letters: None
    length: int = 0

    def compare(self, answer, variant):
        if isinstance(answer, str):
            answer = answer.replace(",", "").replace(" ", "")
        letters = [str(letter).strip().lower() for letter in answer] if np.iterable(answer) else [str(answer)]
        length = self.length or len(self.items)
        strange = [letter for letter in letters if letter not in self.items]
        if strange:
            return self.wrong(headline=f"expected letters from {', '.join(self.items)}, found {strange[0]!r}")
        if len(letters) != length:
            return self.wrong(headline=f"expected {length} letters, found {len(letters)}", next="Use each place once.")
        if self.accepts(letters):
            return self.right()
        known = self.explain(letters)
        return self.wrong(known[0], place=known[1]) if known else self.wrong(headline="not in this order")


@dataclass(frozen=True, kw_only=True)
class PreTest(Exercise):
    """A question of the pre-test, never marked: every answer is noted and sent to the lesson that treats it.

    ``options`` as in :class:`Choice`; ``lesson`` is the number of the lesson. Whether the answer was right is in the verdict's ``known``,
    which is kept for the end of the course and not shown.
    """

    points: float = 0
    options: Mapping
    correct: str
    lesson: str
    hints: tuple = ("There is nothing to lose here: a guess is welcome, and so is \"?\".", "This is treated later on; the answer's verdict names the lesson.")

    def compare(self, answer, variant):
        letter = answer.strip().lower() if isinstance(answer, str) else ""
        if letter not in self.options and letter != UNDECIDED:
            return self.wrong(headline=f'expected one of {", ".join(self.options)} or "?", found {answer!r}', next='Write the letter in quotes, such as "a".')
        if letter == UNDECIDED:
            return self.say(RECORDED, "you do not know yet, and that is what the course is for.", next=f"Lesson {self.lesson} answers it.", known=False)
        option = self.options[letter]
        return self.say(RECORDED, option.answer, next=f"Lesson {self.lesson} looks into it.", mistake=option.mistake, known=letter == self.correct)


@dataclass(frozen=True, kw_only=True)
class Prediction(Exercise):
    """A guess made before a cell reveals the answer; never marked. ``options`` are texts by letter, ``outcome`` what is then seen."""

    points: float = 0
    options: Mapping = field(default_factory=dict)
    correct: str = ""
    outcome: str = ""

    def compare(self, answer, variant):
        letter = answer.strip().lower() if isinstance(answer, str) else ""
        if letter not in self.options and letter != UNDECIDED:
            return self.wrong(headline=f'expected one of {", ".join(self.options)} or "?", found {answer!r}', next='Write the letter in quotes, such as "a".')
        guess = "you would rather see first" if letter == UNDECIDED else f"you expect: {self.options[letter]}"
        return self.say(RECORDED, guess, next="Run the next cell and compare.")

    def after(self, letter):
        """What is said once the answer has been seen; ``letter`` is the guess or None."""
        if letter in (None, UNDECIDED):
            return f"What happens: {self.outcome}"
        verdict = "That is what you expected." if letter == self.correct else f"You expected: {self.options[letter]}."
        return f"{verdict} What happens: {self.outcome}"
