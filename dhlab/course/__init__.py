"""The course: exercises and what they say of an answer; building and opening the lessons."""

from .report import report
from .session import (
    check,
    course_map,
    given,
    hint,
    predict,
    progress,
    reveal,
    route,
    set_variant,
    then_and_now,
)

__all__ = [
    "check",
    "course_map",
    "given",
    "hint",
    "predict",
    "progress",
    "report",
    "reveal",
    "route",
    "set_variant",
    "then_and_now",
]
