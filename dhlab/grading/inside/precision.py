"""Whether a program computes in single precision; the file itself stands here in the cage."""

from ...doctor.programs.source.precision import says_single

__all__ = ["says_single"]
