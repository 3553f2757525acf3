"""The course's late policy for nbgrader: the same days, the same share, the same floor."""

from datetime import UTC, datetime, timedelta

from nbgrader.plugins import LateSubmissionPlugin
from traitlets import Float

from ..settings import Lesson, Settings

__all__ = ["Lateness"]

DUE = datetime(2000, 1, 1, tzinfo=UTC)  # any: only the time since then counts


class Lateness(LateSubmissionPlugin):
    """Takes a share of the points off for every day after the due date; set in
    ``nbgrader_config.py``.
    """

    percent_per_day = Float(0).tag(config=True)
    floor = Float(0).tag(config=True)
    grace_hours = Float(0).tag(config=True)

    def late_submission_penalty(
        self, student_id: str, score: float, total_seconds_late: float
    ) -> float:
        """The points to take off."""
        course = Settings(
            {"": Lesson(DUE)},
            percent_per_day=self.percent_per_day,
            floor=self.floor,
            grace_hours=self.grace_hours,
        )
        _, share = course.lateness("", DUE + timedelta(seconds=total_seconds_late))
        return round(score * share, 6)
