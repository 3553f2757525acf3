"""From the lines that came out of the cage to marks. Everything here happens outside, and nothing
that came out is trusted.
"""

from __future__ import annotations

from collections import deque
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from ...course.kinds import UNDECIDED, Function
from ...course.kinds.exercise import SHUFFLED
from ...course.kinds.lettered import Lettered
from ...course.verdict import NOT_ATTEMPTED, RIGHT, WRONG
from ..inside.book import MOST
from ..inside.wire import DECODED, decode, error_name
from ..results.marks import ERROR, TO_MARK, Mark
from ..shown import readable
from .compared import TEXT, compared, timed_out
from .explained import named
from .programs import ABSENT, READ, program

if TYPE_CHECKING:
    from collections.abc import Callable

    from ...course.kinds.exercise import Exercise
    from ..cage.listener import Run
    from ..settings import Settings
    from .asking import Asked
    from .questions import Course
    from .work import Handed

__all__ = ["mark", "Answers"]

WORD = 12  # letters; the longest text that a right answer has
ENTRY = 3  # of a text in a list; else it is an option's id
MOST_NUMBERS = 1000  # of an answer that is compared; right ones have a few dozen
OTHERS_ORDER = (
    "this copy of the lesson has numbers that are not your own, so its options stood in another"
    " order than yours"
)
NO_ORDER = (
    "this copy of the lesson has no numbers of your own, so it does not say in which order its"
    " options stood"
)


class Answers:
    """What one student's notebooks sent: the notes of each exercise, in order, and what happened to
    the cells.
    """

    def __init__(self) -> None:
        self.notes: dict[str, deque[tuple[dict[str, Any], Handed]]] = {}
        self.troubles: dict[str, tuple[str, str, str]] = {}
        self.ids: dict[int, list[str]] = {}
        # how the last run of a notebook ended, when that was before its end
        self.cut: str | None = None

    def add(self, run: Run, handed: Handed) -> None:
        """Take in one run of one notebook, a Handed."""
        for line in run.lines:
            if isinstance(line.get("check"), str):
                # the last ones, as many as the book within sends: a line may be made up
                last = self.notes.setdefault(line["check"], deque(maxlen=MOST))
                last.append((line, handed))
            ids = (
                [key for key in line.get("ids", ()) if isinstance(key, str)]
                if isinstance(line.get("ids", ()), list)
                else []
            )
            if line.get("ended") in ("error", "timed out"):
                next_ = ABSENT if line.get("absent") is True else READ
                self._trouble(ids, line["ended"], line.get("message"), next_)
            elif "cell" in line and isinstance(line["cell"], int):
                self.ids[line["cell"]] = ids
        self.cut = None if run.ended == "done" else run.ended
        if self.cut and run.cell is not None:
            self._trouble(self.ids.get(run.cell, ()), run.ended, "")

    def _trouble(self, ids, kind, message, next_=READ):
        message = readable(message[:TEXT]) if isinstance(message, str) else ""
        for key in ids:
            self.troubles.setdefault(key, (kind, message, next_))


def mark(
    exercise: Exercise,
    answers: Answers,
    variant: int,
    settings: Settings,
    ask: Callable[..., tuple[Asked, int]],
) -> tuple[Mark, Handed | None]:
    """(Mark, the notebook it comes from) of one exercise: the last attempt that was noted counts.

    Parameters
    ----------
    exercise : Exercise
    answers : Answers
    variant : int
    settings : Settings
    ask : callable
        ``ask(exercise, note, notebook, whole=False)`` calls the program of a note, with all that
        its notebook holds when ``whole``, and gives what it gave and the seed of the inputs.

    Returns
    -------
    Mark, Handed or None
    """
    worth = settings.points(exercise)
    for line, handed in reversed(answers.notes.get(exercise.id, ())):
        if line.get("function") == "written" and isinstance(exercise, Function):
            found = program(exercise, partial(ask, exercise, line, handed), settings, worth)
        elif isinstance(exercise, Lettered):
            found = _in_letters(exercise, line, handed, variant, settings, worth)
        else:
            found = _judged(exercise, line, variant, settings, worth)
        if found.status != NOT_ATTEMPTED:
            return found, handed
    return _without_answer(exercise, answers, worth), None


def _in_letters(exercise, line, handed, variant, settings, worth):
    """The Mark of an answer in letters.

    A notebook without anybody's own numbers, such as one from the site, does not say whether its
    options stood in the student's own order or in that for all: a letter that is right in one of
    them alone is for the teacher to look at.
    """
    own, for_all = (
        _judged(exercise, line, number, settings, worth) for number in (variant, variant % SHUFFLED)
    )
    if any(number >= SHUFFLED for number in handed.numbers):
        chosen = own.status == WRONG and own.chosen and UNDECIDED not in own.chosen
        return _of_another(own) if chosen and variant not in handed.numbers else own
    if (own.status == RIGHT) == (for_all.status == RIGHT):
        return for_all
    right = own if own.status == RIGHT else for_all
    whose = "of this student's own copy" if right is own else "of the lesson for all"
    return replace(
        right,
        status=TO_MARK,
        points=0,
        headline=NO_ORDER,
        note=f"right by the letters {whose} alone",
        chosen=(),  # it would tell which option is right
        answer=named(line["value"]),
    )


def _of_another(own):
    """The Mark of a wrong letter in a copy with another's numbers: of which option it was the
    letter there is another question.
    """
    return replace(own, mistake=None, headline=OTHERS_ORDER, why="", next="", chosen=())


def _judged(exercise, line, variant, settings, worth):
    """The Mark of a value."""
    if "stopped" in line:
        return timed_out(exercise, worth)
    if line.get("function") == "stub":
        return Mark(exercise.id, NOT_ATTEMPTED, 0, worth)
    try:
        answer = decode(line["value"])
        if _size(answer) > MOST_NUMBERS:
            raise ValueError("expected an answer of a few numbers, found many")
        answer = _short(answer, exercise.texts() if isinstance(exercise, Lettered) else ())
    except DECODED:
        headline = (
            "the answer cannot be read: give plain numbers, text, a list, a table or a function"
        )
        return Mark(exercise.id, WRONG, 0, worth, headline=headline)
    return compared(exercise, answer, variant, settings, worth)


def _size(answer):
    """How many numbers, texts and rows there are in an answer."""
    if isinstance(answer, dict):
        answer = list(answer.values())
    if isinstance(answer, list):
        return len(answer) + sum(map(_size, answer))
    rows = getattr(getattr(answer, "table", answer), "rows", answer)
    return int(getattr(rows, "size", 1))


def _short(answer, known, most=WORD):
    """An answer without texts of its own: what is repeated to its student are letters and words of
    the course; ``known`` are the ids of options.
    """
    if isinstance(answer, str):
        plain = len(answer) <= most and answer.isascii() and answer.isprintable()
        return answer if plain or answer.strip().lower() in known else "…"
    if isinstance(answer, list):
        return [_short(entry, known, ENTRY) for entry in answer]
    if isinstance(answer, dict):
        return {
            _short(key, known, ENTRY): _short(entry, known, ENTRY) for key, entry in answer.items()
        }
    return answer


def _without_answer(exercise, answers, worth):
    """The mark of an exercise for which no attempt was noted."""
    ended = "the notebook ended before this exercise was reached" if answers.cut else ""
    kind, message, next_ = answers.troubles.get(exercise.id, (answers.cut, ended, READ))
    if kind == "timed out":
        return timed_out(exercise, worth)
    if kind is None:
        return Mark(exercise.id, NOT_ATTEMPTED, 0, worth)
    if exercise.id not in answers.troubles:
        headline = message
    elif message:
        headline = f"the cell stops with {error_name(message.partition(':')[0])}"
    else:
        headline = "the notebook's program ended itself in this cell"
    return Mark(exercise.id, ERROR, 0, worth, headline=headline, next=next_, note=message[:TEXT])


def without_marks(course: Course, status: str) -> tuple[Mark, ...]:
    """A mark for every exercise of somebody who handed in nothing that could be graded."""
    return tuple(Mark(e.id, status, 0, course.settings.points(e)) for e in course.exercises)
