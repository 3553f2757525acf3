"""dhlab: learn, teach and debug Denavit-Hartenberg kinematics. Radians and metres inside; degrees and millimetres where people write."""

from .arm import Arm
from .equivalence import equivalent
from .frames import NearlyParallelWarning, assign_frames
from .robots import load, robots
from .table import DHTable

__version__ = "0.1.0"
__all__ = ["Arm", "DHTable", "NearlyParallelWarning", "assign_frames", "equivalent", "load", "robots"]
