"""What stands of an earlier run: marks of other lessons, and of work that is not among what is
graded now. No mark is ever lost.
"""

import re
from collections.abc import Collection
from dataclasses import replace

from ...course.exercises import exercises
from .marks import GRADED, MISSING, NOT_HANDED_IN, TIMED_OUT, UNREADABLE, Graded, Mark

__all__ = ["together", "left_standing", "lateness"]

NO_FILE = "no file was found"
# notes that are written anew each time, all of them: the name of a file may have words of theirs
STAND = re.compile(r"lesson \w+: [a-z ]+; the marks of (before|[0-9-]+) stand")
LACKING = re.compile(rf"lesson \w+: {NO_FILE}")


def together(before: Graded | None, new: Graded, only: str = "") -> Graded:
    """The marks of one student from an earlier run and from this one, as one Graded.

    This run's marks count, but for exercises that it did not grade, lessons of which no file was
    handed in this time, and files that cannot be read: there the earlier ones stand, and a note
    says so.

    Parameters
    ----------
    before : Graded or None
    new : Graded
    only : str
        The one exercise that was graded again; all when empty.

    Returns
    -------
    Graded
    """
    if before is None:
        return new
    old, fresh = ({mark.exercise: mark for mark in graded.marks} for graded in (before, new))
    lost = {
        key: old[key]
        for key, mark in fresh.items()
        if key in old
        and old[key].status != NOT_HANDED_IN
        and (mark.status == NOT_HANDED_IN or new.status == UNREADABLE)
    }
    stand = {key: mark for key, mark in old.items() if key not in fresh or key in lost}
    if not stand:
        return new
    marks = _in_order({**fresh, **stand})
    if only:
        return _with(before, marks)
    worked = new.status in (GRADED, TIMED_OUT) or before.status == MISSING
    used = {mark.file for mark in stand.values()}
    files = [name for name in before.file.split("; ") if name in used]
    return replace(
        _with(new, marks),
        status=new.status if worked else before.status,
        file="; ".join(dict.fromkeys([*files, *filter(None, new.file.split("; "))])),
        cage=new.cage or before.cage,
        guess_of=new.guess_of or before.guess_of,
        numbers_of=new.numbers_of or before.numbers_of,
        notes=_notes(before, new, lost),
    )


def _notes(before, new, lost):
    """What both runs noted, without what no longer holds, and which lessons' earlier marks stand;
    ``lost`` holds the earlier marks of what could not be graded this time.
    """
    notes = [note for note in _lasting(before.notes) if not LACKING.fullmatch(note)]
    told = {f"lesson {mark.lesson}: {NO_FILE}" for mark in lost.values()}
    notes += [note for note in new.notes if note not in told]
    why = "the file cannot be read" if new.status == UNREADABLE else "no file this time"
    if new.status == UNREADABLE and not lost:
        notes.append("the file handed in this time cannot be read")
    return tuple(dict.fromkeys([*notes, *_standing([lost[key] for key in sorted(lost)], why)]))


def left_standing(before: Graded) -> Graded:
    """The Graded of somebody who is not among what is graded now: as it was, with a note."""
    marks = [mark for mark in before.marks if mark.status != NOT_HANDED_IN]
    return replace(before, notes=(*_lasting(before.notes), *_standing(marks, "no file this time")))


def _lasting(notes):
    return [note for note in notes if not STAND.fullmatch(note)]


def lateness(marks: Collection[Mark]) -> tuple[float, float]:
    """(days late at most, share of all points that lateness takes off) of some marks."""
    points = sum(mark.points for mark in marks)
    lost = sum(mark.points * mark.penalty for mark in marks)
    days = max((mark.late_days for mark in marks), default=0.0)
    return days, round(lost / points, 6) if points else 0.0


def _with(graded, marks):
    days, penalty = lateness(marks)
    return replace(graded, marks=marks, late_days=days, penalty=penalty)


def _in_order(marks):
    order = {key: place for place, key in enumerate(exercises())}
    return tuple(sorted(marks.values(), key=lambda mark: order.get(mark.exercise, len(order))))


def _standing(marks, why):
    """A sentence for each lesson whose earlier marks stand."""
    for lesson in sorted({mark.lesson for mark in marks}):
        dates = [mark.handed_in[:10] for mark in marks if mark.lesson == lesson and mark.handed_in]
        yield f"lesson {lesson}: {why}; the marks of {max(dates) if dates else 'before'} stand"
