"""The course: exercises and what they say of an answer; building and opening the lessons."""

from .session import check, given, hint, predict, progress, reveal, set_variant

__all__ = ["check", "given", "hint", "predict", "progress", "reveal", "set_variant"]
