"""The course: exercises and what they say of an answer; building and opening the lessons."""

from .report import report
from .session import check, given, hint, predict, progress, reveal, set_variant, then_and_now

__all__ = [
    "check",
    "given",
    "hint",
    "predict",
    "progress",
    "report",
    "reveal",
    "set_variant",
    "then_and_now",
]
