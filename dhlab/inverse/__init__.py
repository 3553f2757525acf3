"""The way back: from a pose to the configurations that reach it.

:meth:`dhlab.Arm.solve` is the door. Six turning joints, and seven with one held, are solved in
closed form by the library ssik (extra ``[ik]``); everything else, and everything without the extra,
by damped least squares from many starts.
"""

from .solutions import Nearest, Reason, Solutions
from .solving import prepare, solve

__all__ = ["Nearest", "Reason", "Solutions", "prepare", "solve"]
