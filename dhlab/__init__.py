"""dhlab: learn, teach and debug Denavit-Hartenberg kinematics. Radians and metres inside; degrees
and millimetres where people write.
"""

from importlib import import_module

from . import symbolic
from .arm import Arm
from .formats.urdf import read_urdf, to_urdf
from .geometry.equivalence import equivalent
from .geometry.frames import NearlyParallelWarning, assign_frames
from .robots import load, robots
from .table import DHTable

# what needs scipy's optimisers or the pictures is loaded when it is first asked for
LATER = {
    "calibrate_offsets": "measure",
    "diagnose": "doctor",
    "diagnose_function": "doctor",
    "explore": "view.explorer",
    "generate": "generating",
    "recognise_table": "doctor",
    "fit_circles": "measure",
    "read_poses": "formats.posefile",
}

__version__ = "0.1.0"
__all__ = [
    "Arm",
    "DHTable",
    "NearlyParallelWarning",
    "assign_frames",
    "calibrate_offsets",
    "diagnose",
    "diagnose_function",
    "equivalent",
    "explore",
    "fit_circles",
    "generate",
    "load",
    "read_poses",
    "read_urdf",
    "recognise_table",
    "robots",
    "symbolic",
    "to_urdf",
]


def __getattr__(name):
    if name not in LATER:
        raise AttributeError(f"dhlab has no {name!r}; it has {', '.join(__all__)}")
    return getattr(import_module(f".{LATER[name]}", __name__), name)


def __dir__():
    return [*globals(), *LATER]
