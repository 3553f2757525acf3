"""What a lesson calls: ``check``, ``hint``, ``given``, ``predict``, ``reveal``, ``progress``,
``then_and_now``.
"""

import re
from collections.abc import Mapping
from dataclasses import replace
from difflib import get_close_matches
from functools import partial
from html import escape
from typing import Any

from .exercises import exercises, sittings
from .growth import Growth
from .handing import as_rows, offer, watch
from .kinds import Prediction, untouched
from .progress import Log, Progress
from .route import ASKED_BY, SITTINGS, Map, begin_at, counted
from .verdict import NOT_ATTEMPTED, RECORDED, TOLD_ALL, WRONG, Verdict

__all__ = [
    "check",
    "course_map",
    "given",
    "hint",
    "predict",
    "progress",
    "reveal",
    "route",
    "set_variant",
    "then_and_now",
]

OWN_ITEM = re.compile(r"9[0-9]\.[0-9]{1,3}")  # ids of a teacher's own items
_log = Log()
_guesses: dict[str, Any] = {}
_variant = 0
watch()


def set_variant(variant: int) -> None:
    """Choose which numbers the exercises draw: a whole number, 0 unless a teacher handed out
    another.

    Examples
    --------
    >>> set_variant(0)
    """
    global _variant
    if isinstance(variant, bool) or not isinstance(variant, int) or variant < 0:
        raise ValueError(
            f"set_variant: expected a whole number from 0, found {variant!r}; copy it from the"
            " sheet you were given"
        )
    _variant = variant


def check(exercise_id: str, answer: Any) -> Verdict:
    """Judge an answer and say what is right or wrong with it.

    Parameters
    ----------
    exercise_id : str
        Such as ``"05.2"``.
    answer
        A value, a function, a table, a letter or a list of letters, as the exercise asks; "?" is
        an answer to every exercise.

    Returns
    -------
    Verdict
        Shown by the notebook; ``.status``, ``.mistake`` and ``.points`` for programs. Where the
        mistake is what the exercise asks for, the first wrong answer is told the kind of mistake,
        the second also its place, the third everything.

    Raises
    ------
    ValueError
        There is no such exercise.

    Notes
    -----
    In JupyterLab an answer that is still dots is asked for under the check: with cards, or with
    bare axes. What is chosen there is written in place of the dots when the answer's own cell is
    run again.

    Examples
    --------
    >>> check("05.3", ...).status
    'not attempted'
    """
    if isinstance(exercise_id, str) and OWN_ITEM.fullmatch(exercise_id):
        return _kept_for_teacher(exercise_id, answer)
    exercise, rows = _exercise(exercise_id), as_rows(answer)
    verdict = offer(exercise, rows, exercise.judge(rows, _variant), _variant)
    _log.add(verdict)
    tries = _log.wrong_tries(exercise_id)
    told = verdict.at_try(tries)
    if told.status != WRONG or (told.sparing and tries < TOLD_ALL):
        return told
    return replace(told, drawn=partial(exercise.drawn, rows, _variant))


def _kept_for_teacher(exercise_id, answer):
    """The Verdict on a teacher's own item: what is right is not known here."""
    if untouched(answer):
        return Verdict(exercise_id, NOT_ATTEMPTED, next="Put an answer in place of the dots.")
    return Verdict(
        exercise_id,
        RECORDED,
        "kept for your teacher",
        next="It is marked when you have handed in; here nothing is known of what is right.",
    )


def hint(exercise_id: str, level: int = 1) -> "Note":
    """A hint: level 1 says where to look, level 2 which way to go; neither gives the answer. A
    guess has none.

    Examples
    --------
    >>> print(hint("05.3", 2))
    Hint 2 of 2: Tx(a) must come after Rz(θ), and Rx(α) after both z moves.
    >>> print(hint("05.P1"))
    A guess has no hint: it is never marked, and the next cell shows what happens.
    """
    if isinstance(exercises().get(exercise_id), Prediction):
        return Note(
            "A guess has no hint: it is never marked, and the next cell shows what happens."
        )
    hints = _exercise(exercise_id).hints
    if level not in range(1, len(hints) + 1):
        raise ValueError(f"hint: expected a level from 1 to {len(hints)}, found {level!r}")
    more = f' (hint("{exercise_id}", {level + 1}) says more)' if level < len(hints) else ""
    return Note(f"Hint {level} of {len(hints)}: {hints[level - 1]}{more}")


def given(exercise_id: str) -> Mapping[str, Any]:
    """The numbers of a task, by name, as the learner's variant has them.

    Examples
    --------
    >>> sorted(given("01.2"))
    ['x', 'y', 'z']
    """
    return _exercise(exercise_id).given(_variant)


def predict(prediction_id: str, guess: Any) -> Verdict:
    """Note a guess before the next cell shows what happens. Never marked.

    Examples
    --------
    >>> predict("05.P1", "a").status
    'recorded'
    """
    exercise = _exercise(prediction_id, Prediction)
    verdict = offer(exercise, guess, exercise.judge(guess, _variant), _variant)
    if verdict.status == "recorded":
        (_guesses[prediction_id],) = verdict.chosen
        _log.add(verdict)
    return verdict


def reveal(prediction_id: str) -> "Note":
    """What happens, beside what was guessed.

    Examples
    --------
    >>> str(reveal("05.P1"))[:4]
    'You '
    """
    return Note(_exercise(prediction_id, Prediction).after(_guesses.get(prediction_id)))


def progress(lesson: str = "") -> Progress:
    """How far the learner is: every exercise of a lesson, or of all, from this session and the
    course folder's log.

    Parameters
    ----------
    lesson : str
        A sitting, such as ``"05"`` or ``"08b"``; all when left out.

    Examples
    --------
    >>> progress("05").to_dict()["05.3"]["of"]
    1
    """
    wanted = sittings().get(lesson, ())
    scored = {
        key: exercise
        for key, exercise in exercises().items()
        if not isinstance(exercise, Prediction) and (not lesson or key in wanted)
    }
    if not scored:
        raise ValueError(
            f'progress: expected the number of a lesson, such as "05", found {lesson!r}'
        )
    names = list(SITTINGS)
    after = names[names.index(lesson) + 1 :][:1] if lesson else []
    return Progress(scored, _log.best(), after[0] if after else "")


def course_map(lesson: str = "") -> Map:
    """The whole course with how much of each sitting is done; a click opens one.

    Parameters
    ----------
    lesson : str
        The sitting that is open, such as ``"05"`` or ``"08b"``.

    Examples
    --------
    >>> course_map("05").to_dict()["05"].of  # exercises of its core
    6
    """
    if lesson and lesson not in SITTINGS:
        raise ValueError(
            f"course_map: expected one of the lessons {', '.join(SITTINGS)}, found {lesson!r}"
        )
    return Map(counted(_log.best()), lesson)


def route() -> Map:
    """Where to begin, by what was answered rightly in the pre-test, and the map of the course.

    Examples
    --------
    >>> str(route()).splitlines()[1][:21]
    'Begin with lesson 01.'
    """
    known = _log.known_at_first()
    first, later = begin_at(known)
    asked = sum(key in known for key in ASKED_BY)
    words = f"Begin with lesson {first}."
    if first == "01" and known.get("00.2"):
        words += (
            " You answered its question rightly, which may be luck: where 01.1 and 01.2 come at"
            " once, go on with lesson 02."
        )
    if not asked:
        words += " The five questions are not answered yet."
    elif first > "01":
        words += " What was asked about the lessons before it, you answered rightly."
    if asked and later:
        words += f" Still open beyond it: the questions of {' and '.join(later)}."
    return Map(counted(_log.best()), "00", words)


def then_and_now() -> Growth:
    """The pre-test of lesson 00 beside the post-test of lesson 09, question by question.

    Returns
    -------
    Growth
        Shown as a table; ``.to_dict()`` for programs.

    Examples
    --------
    >>> len(then_and_now().to_dict())
    5
    """
    return Growth(exercises(), _log.known_at_first(), _log.best())


class Note(str):
    """A sentence that a notebook shows as text, without quotes."""

    def __repr__(self):
        return str(self)

    def _repr_html_(self):
        return f"<p>{escape(self)}</p>"


def _exercise(exercise_id, kind=None):
    known = [
        key
        for key, exercise in exercises().items()
        if (isinstance(exercise, Prediction)) == (kind is Prediction)
    ]
    if exercise_id not in known:
        near = get_close_matches(str(exercise_id), known, 1)
        such = f'write it as in "{known[0]}"'
        raise ValueError(
            f"expected the number of {'a prediction' if kind else 'an exercise'}, found"
            f" {exercise_id!r}; " + (f'did you mean "{near[0]}"?' if near else such)
        )
    return exercises()[exercise_id]
