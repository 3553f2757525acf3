"""What a regrade changed: which marks are others than after the run before, and why."""

from collections.abc import Iterable, Mapping
from itertools import chain
from typing import NamedTuple

from .marks import HELD, MARKED, TO_MARK, Graded, Mark

__all__ = ["Change", "changes"]

ALL = "total"


class Change(NamedTuple):
    """One mark that is another one now; ``exercise`` is "total" for all points together."""

    student: str
    exercise: str
    before: str
    now: str
    why: str


def changes(before: Mapping[str, Graded], now: Iterable[Graded]) -> list[Change]:
    """Every mark that differs, of students who had marks before; both with the decisions.

    Examples
    --------
    >>> old = Graded("ada", "a", "graded", (Mark("05.4", "wrong", 0, 2, file="a"),))
    >>> new = Graded("ada", "b", "graded", (Mark("05.4", "right", 2, 2, file="b"),))
    >>> for change in changes({"ada": old}, [new]):
    ...     print(*change, sep="; ")
    ada; 05.4; 0 of 2, wrong; 2 of 2, right; another file
    ada; total; 0 of 2; 2 of 2; its exercises
    """
    return list(
        chain.from_iterable(
            _of_one(before[graded.student], graded) for graded in now if graded.student in before
        )
    )


def _of_one(old, new):
    known = {mark.exercise: mark for mark in old.marks}
    found = [
        Change(new.student, mark.exercise, _said(was), _said(mark), _why(was, mark))
        for mark in new.marks
        if (was := known.get(mark.exercise)) is not None and _said(was) != _said(mark)
    ]
    yield from found
    reasons = [
        reason
        for reason, holds in (
            ("its exercises", found),
            ("another lateness", old.penalty != new.penalty),
            ("another bonus", old.bonus != new.bonus),
            ("put on hold or let go", HELD in (old.status, new.status)),
            ("other exercises are graded", len(old.marks) != len(new.marks)),
        )
        if holds
    ]
    if (old.total, old.of, old.status == HELD) != (new.total, new.of, new.status == HELD):
        yield Change(new.student, ALL, _sum(old), _sum(new), ", ".join(reasons) or "rounding")


def _said(mark: Mark) -> str:
    if mark.status == TO_MARK:
        return TO_MARK
    return f"{mark.points:g} of {mark.of:g}, {mark.status}"


def _sum(graded):
    return "on hold" if graded.status == HELD else f"{graded.total:g} of {graded.of:g}"


def _why(old, new):
    """The first reason that holds; what none of them explains is the grader itself."""
    if bool(old.of) != bool(new.of):
        return "the exercise is dropped, or counts again"
    if (old.file, old.handed_in, old.answer) != (new.file, new.handed_in, new.answer):
        return "another file"
    if MARKED in (old.status, new.status) or (old.note, old.comment) != (new.note, new.comment):
        return "your decision"
    if old.of != new.of:
        return "other points in course.yaml"
    return "graded anew: the course, the limits or dhlab have changed"
