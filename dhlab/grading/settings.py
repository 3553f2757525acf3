"""``course.yaml``: which lessons count, when they are due, what they are worth, what lateness costs
and what a submission may use.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from datetime import UTC, date, datetime, time, tzinfo
from pathlib import Path
from typing import TYPE_CHECKING, Any
from zoneinfo import ZoneInfo

from ..formats import plainyaml

if TYPE_CHECKING:
    from ..course.kinds.exercise import Exercise
    from .own_items import Items

__all__ = ["Limits", "Lesson", "Settings", "moment", "read_settings", "LEVELS"]

LEVELS = ("bubblewrap", "landlock", "rlimits")
TOP = {"lessons", "late", "timezone", "partial", "own_kinematics", "limits", "cage", "items"}


@dataclass(frozen=True)
class Limits:
    """What one notebook may use: seconds for a cell and in all, MB of memory above the warm start,
    MB of files, threads.
    """

    cell_seconds: float = 10.0
    seconds: float = 60.0
    memory_mb: int = 512
    files_mb: int = 16
    threads: int = 32


@dataclass(frozen=True)
class Lesson:
    """One lesson of the course: when it is due (None: never late) and points that differ from the
    exercises' own.
    """

    due: datetime | None = None
    points: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Settings:
    """The course as the teacher sets it; the default grades every lesson that is handed in, never
    late.

    Examples
    --------
    >>> Settings().lessons, Settings().limits.seconds
    ({}, 60.0)
    """

    lessons: dict[str, Lesson] = field(default_factory=dict)
    percent_per_day: float = 0.0
    floor: float = 0.0
    grace_hours: float = 0.0
    partial: float = 0.0
    own_kinematics: float = 0.0
    limits: Limits = Limits()
    cage: str | None = None
    zone: tzinfo = UTC
    items: Items | None = None

    def lateness(self, lesson: str, when: datetime | None) -> tuple[float, float]:
        """(days after the due date, share of the points taken off) of work on a lesson that came at
        ``when``, a datetime or None.

        Every day that has begun counts, once the hours of grace are over; what is left never falls
        below the floor.

        Examples
        --------
        >>> from datetime import datetime, timedelta, timezone
        >>> due = datetime(2026, 11, 20, tzinfo=timezone.utc)
        >>> course = Settings({"05": Lesson(due)}, percent_per_day=10, floor=50)
        >>> course.lateness("05", due + timedelta(hours=30))
        (1.25, 0.2)
        >>> course.lateness("05", due + timedelta(days=9))
        (9.0, 0.5)
        """
        due = self.lessons[lesson].due if lesson in self.lessons else None
        if due is None or when is None:
            return 0.0, 0.0
        return self.late_after(due, when)

    def late_after(self, due: datetime, when: datetime) -> tuple[float, float]:
        """The same, for a due date of one student's own."""
        # by the minute, as they are shown: 23:59 lasts until midnight
        due, when = (at.replace(second=0, microsecond=0) for at in (due, when))
        # two times of one zone would be subtracted as the clocks show them, summer time or not
        days = (when.astimezone(UTC) - due.astimezone(UTC)).total_seconds() / 86400
        if days <= self.grace_hours / 24:
            return 0.0, 0.0
        percent = min(self.percent_per_day * math.ceil(days), 100 - self.floor)
        return round(days, 4), round(percent / 100, 6)

    def points(self, exercise: Exercise) -> float:
        """What an exercise is worth in this course."""
        lesson = self.lessons.get(exercise.id.split(".")[0])
        return lesson.points.get(exercise.id, exercise.points) if lesson else exercise.points


def read_settings(path: str | Path) -> Settings:
    """The Settings in a ``course.yaml``.

    Parameters
    ----------
    path : str or path
        ::

            timezone: Europe/Vienna         # UTC when left out
            lessons:
              "05": {due: 2026-11-20}       # without a time: the end of that day
              "06": {due: 2026-11-27 23:59, points: {"06.2": 5}}
            late: {percent_per_day: 10, floor: 50, grace_hours: 1}
            # share of the points for a wrong answer whose mistake is recognised, 0 when left out
            partial: 0.5
            # share for a function that calls the library's kinematics where it is to be written
            own_kinematics: 0
            limits: {cell_seconds: 10, seconds: 60, memory_mb: 512, files_mb: 16, threads: 32}
            cage: bubblewrap      # when left out; or landlock, rlimits, which are weaker
            items: own_items.py   # exercises of your own, beside this file

    Returns
    -------
    Settings

    Raises
    ------
    ValueError
        One sentence with the line: an unknown key, lesson or exercise, or a value of another kind.
    """
    top = plainyaml.read(path, "a course's settings")
    known = plainyaml.fields(top, "course", required=set(), allowed=TOP)
    zone = _zone(known.get("timezone"))
    given: dict[str, Any] = {"zone": zone}
    if "items" in known:
        from .own_items import read_items

        name = plainyaml.text(known["items"], "items")
        given["items"] = read_items(Path(path).parent / name)
    given |= {"lessons": _lessons(known["lessons"], zone)} if "lessons" in known else {}
    if "late" in known:
        late = plainyaml.fields(
            known["late"],
            "late",
            required={"percent_per_day"},
            allowed={"percent_per_day", "floor", "grace_hours"},
        )
        given |= {
            key: _between(item, f"late: {key}", 0, 10_000 if key == "grace_hours" else 100)
            for key, item in late.items()
        }
    given |= {
        key: _between(known[key], key, 0, 1)
        for key in ("partial", "own_kinematics")
        if key in known
    }
    if "limits" in known:
        given["limits"] = _limits(known["limits"])
    if "cage" in known:
        given["cage"] = _level(known["cage"])
    return Settings(**given)


def _zone(item):
    if item is None:
        return UTC
    name = plainyaml.text(item, "timezone")
    try:
        return ZoneInfo(name)
    except (KeyError, ValueError, OSError):
        raise ValueError(
            f"{item.where}: timezone: expected a name such as Europe/Vienna or UTC, found {name!r}"
        ) from None


def _lessons(item, zone):
    from ..course.exercises import exercises

    known = {key.split(".")[0] for key in exercises()}
    for name, entry in item.value.items() if isinstance(item.value, dict) else ():
        if name not in known:
            raise ValueError(
                f"{entry.where}: lessons: expected lessons from {', '.join(sorted(known))}, unknown"
                f' key "{name}"; write two digits, such as "05"'
            )
    lessons = plainyaml.fields(item, "lessons", required=set(), allowed=known)
    return {name: _lesson(name, entry, zone) for name, entry in lessons.items()}


def _lesson(name, item, zone):
    if item.value is None:
        return Lesson()
    from ..course.exercises import exercises

    known = plainyaml.fields(item, f"lesson {name}", required=set(), allowed={"due", "points"})
    points = {}
    if "points" in known:
        ids = {key for key in exercises() if key.startswith(f"{name}.")}
        given = plainyaml.fields(
            known["points"], f"lesson {name}: points", required=set(), allowed=ids
        )
        points = {key: _between(entry, f"points of {key}", 0, 1000) for key, entry in given.items()}
    return Lesson(
        moment(known["due"], f"lesson {name}: due", zone) if "due" in known else None, points
    )


def moment(item: plainyaml.Item, what: str, zone: tzinfo) -> datetime:
    """A moment; of a day alone its end."""
    words = plainyaml.text(item, what)
    try:
        moment = datetime.fromisoformat(words)
    except ValueError:
        raise ValueError(
            f"{item.where}: {what}: expected a date such as 2026-11-20 23:59, found {words!r}"
        ) from None
    if _is_date(words):
        moment = datetime.combine(moment, time(23, 59, 59))
    return moment if moment.tzinfo else moment.replace(tzinfo=zone)


def _is_date(words):
    """Whether a moment is given as a day alone."""
    try:
        return bool(date.fromisoformat(words))
    except ValueError:
        return False


def _between(item, what, low, high):
    value = plainyaml.number(item, what)
    if not low <= value <= high:
        raise ValueError(
            f"{item.where}: {what}: expected a number from {low} to {high}, found {value}"
        )
    return value


def _limits(item):
    names = {name: type(value) for name, value in vars(Limits()).items()}
    known = plainyaml.fields(item, "limits", required=set(), allowed=set(names))
    return Limits(
        **{
            name: names[name](_between(entry, f"limits: {name}", 1, 100_000))
            for name, entry in known.items()
        }
    )


def _level(item):
    name = plainyaml.text(item, "cage")
    if name not in LEVELS:
        raise ValueError(
            f"{item.where}: cage: expected {', '.join(LEVELS)}, found {name!r}; leave it out for"
            " the best there is"
        )
    return name
