"""Which functions make matrices for a learner's; the file itself stands here in the cage."""

from ...doctor.programs.running.made import matrices_made

__all__ = ["matrices_made"]
