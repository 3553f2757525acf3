"""The doctor's way of calling a learner's function. In the cage the file itself stands here, so
that the rest of the doctor need not be loaded.
"""

from ...doctor.programs.running.calling import Fault, call, fits, is_stub, quiet

__all__ = ["Fault", "call", "fits", "is_stub", "quiet"]
