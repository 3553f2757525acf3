"""course.yaml: what may stand in it, and what is said of what may not."""

from datetime import UTC, datetime, timedelta

import pytest

from dhlab.course.exercises import exercises
from dhlab.grading.settings import Limits, Settings, read_settings

WHOLE = """
timezone: Europe/Vienna
lessons:
  "05": {due: 2026-11-20 23:59}
  "06": {due: "2026-11-27T23:59+00:00", points: {"06.2": 5}}
late: {percent_per_day: 10, floor: 60, grace_hours: 2}
partial: 0.5
own_kinematics: 0.25
limits: {cell_seconds: 2.5, memory_mb: 256}
cage: landlock
"""


def read(tmp_path, text):
    (tmp_path / "course.yaml").write_text(text, encoding="utf-8")
    return read_settings(tmp_path / "course.yaml")


def test_everything(tmp_path):
    course = read(tmp_path, WHOLE)
    # Vienna is an hour ahead in winter
    assert course.lessons["05"].due == datetime(2026, 11, 20, 22, 59, tzinfo=UTC)
    assert course.lessons["06"].due == datetime(2026, 11, 27, 23, 59, tzinfo=UTC)
    assert (
        course.points(exercises()["06.2"]),
        course.points(exercises()["06.1"]),
        course.points(exercises()["01.1"]),
    ) == (5, 1, 1)
    assert (course.partial, course.own_kinematics, course.cage, course.limits) == (
        0.5,
        0.25,
        "landlock",
        Limits(cell_seconds=2.5, memory_mb=256),
    )


def test_a_date_alone_is_the_end_of_that_day(tmp_path):
    course = read(
        tmp_path,
        'timezone: Europe/Vienna\nlessons: {"05": {due: 2026-11-17}}\nlate: {percent_per_day: 10}',
    )
    due = course.lessons["05"].due
    assert (due.hour, due.minute, due.utcoffset()) == (
        23,
        59,
        timedelta(hours=1),
    ) and course.lateness("05", datetime(2026, 11, 17, 22, 30, tzinfo=UTC)) == (0, 0)


@pytest.mark.parametrize("number", ["5", "55", "11"])
def test_a_lesson_that_is_none_is_told_as_one(tmp_path, number):
    with pytest.raises(ValueError, match="write two digits") as caught:
        read(tmp_path, f'lessons: {{"{number}": {{}}}}')
    assert "decimal comma" not in str(caught.value)


@pytest.mark.parametrize(
    "hours, days, penalty",
    [
        (-5, 0, 0),
        (0, 0, 0),
        (1.9, 0, 0),
        (2.5, 0.1042, 0.1),
        (23, 0.9583, 0.1),
        (25, 1.0417, 0.2),
        (24 * 9, 9, 0.4),
    ],
)
def test_lateness(tmp_path, hours, days, penalty):
    course = read(tmp_path, WHOLE)
    assert course.lateness("05", course.lessons["05"].due + timedelta(hours=hours)) == (
        days,
        penalty,
    )
    assert (
        course.lateness("01", course.lessons["05"].due + timedelta(hours=hours))
        == (0, 0)
        == course.lateness("05", None)
    )


def test_a_minute_is_over_when_the_next_begins(tmp_path):
    course = read(tmp_path, 'lessons: {"05": {due: 2026-11-20 23:59}}\nlate: {percent_per_day: 10}')
    late = [
        course.lateness("05", datetime(2026, 11, day, hour, minute, second, tzinfo=UTC))[1]
        for day, hour, minute, second in [(20, 23, 59, 0), (20, 23, 59, 59), (21, 0, 0, 0)]
    ]
    assert late == [0, 0, 0.1]


def test_days_are_as_long_as_they_are_when_summer_time_ends(tmp_path):
    course = read(tmp_path, WHOLE.replace("2026-11-20", "2026-10-24"))
    due = course.lessons["05"].due
    for when in (datetime(2026, 10, 25, 23, 30, tzinfo=due.tzinfo), due + timedelta(hours=24)):
        at = when.astimezone(UTC)
        hours = (at - due.astimezone(UTC)).total_seconds() / 3600
        assert (
            course.late_after(due, when)
            == course.lateness("05", at)
            == (round(hours / 24, 4), 0.1 if hours <= 24 else 0.2)
        )


def test_an_empty_file_is_the_default(tmp_path):
    assert read(tmp_path, "{}") == Settings()


@pytest.mark.parametrize(
    "text, words",
    [
        ("lesson: {}", 'unknown key "lesson"; did you mean "lessons"'),
        ('lessons: {"99": {}}', 'unknown key "99"'),
        ('lessons: {"05": {points: {"05.99": 1}}}', 'unknown key "05.99"'),
        ('lessons: {"05": {due: tomorrow}}', "expected a date such as"),
        ("timezone: Mars/Olympus", "expected a name such as"),
        ("late: {percent_per_day: 120}", "from 0 to 100"),
        ("partial: half", "expected a number"),
        ("partial: 2", "from 0 to 1"),
        ("limits: {seconds: 0}", "from 1 to"),
        ("cage: strong", "bubblewrap, landlock, rlimits"),
        ("late: {floor: 3}", "no percent_per_day"),
    ],
)
def test_what_may_not_stand_there(tmp_path, text, words):
    with pytest.raises(ValueError) as caught:
        read(tmp_path, text)
    assert (
        words in str(caught.value)
        and "course.yaml" in str(caught.value)
        and "\n" not in str(caught.value)
    )
